#!/usr/bin/env bash
# Attacks the readers with libFuzzer, under AddressSanitizer and UndefinedBehaviorSanitizer:
#   tests/fuzz/fuzz.sh [SECONDS [TARGET…]]
# for so long each (600), all targets if none is named. Builds with clang into build/fuzz, which takes some twenty
# minutes the first time. Inputs that were found are kept in build/fuzz/corpus; those that break something are in
# build/fuzz/found and belong in tests/corpus/TARGET once they are mended.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-600}
shift || true
build=build/fuzz
cmake -S . -B "$build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -gline-tables-only" -DCONTINUA_FUZZ=ON -DCONTINUA_SANITIZE=address,undefined \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=12 \
  > /dev/null
cmake --build "$build" --target fuzz_libfuzzer fuzz_mutate
mkdir -p "$build/found"
targets=("$@")
if [[ ${#targets[@]} -eq 0 ]]; then mapfile -t targets < <("$build/tests/fuzz_mutate" --list); fi
status=0
for target in "${targets[@]}"; do
  corpus=$build/corpus/$target
  mkdir -p "$corpus"
  "$build/tests/fuzz_mutate" --seeds "$target" "$corpus"
  "$build/tests/fuzz_mutate" --words "$target" > "$build/found/$target.dict"
  echo "$target:"
  # No leaks are looked for: MuJoCo's and the XML reader's errors jump over destructors.
  CONTINUA_FUZZ=$target ASAN_OPTIONS=detect_leaks=0 "$build/tests/fuzz_libfuzzer" "$corpus" -max_total_time="$seconds" \
    -max_len=32768 -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 -verbosity=1 -dict="$build/found/$target.dict" \
    -artifact_prefix="$build/found/$target-" 2> "$build/found/$target.log" || status=1
  grep -E "^(#.*DONE|stat::number_of_executed|SUMMARY)" "$build/found/$target.log" || true
done
exit $status
