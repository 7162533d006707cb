#!/usr/bin/env bash
# Replays traces in two builds, one by g++ and one by clang with sanitizers, which fill fresh memory, and in processes
# that have nothing else in common: number of threads, language, time zone, layout of the address space. All must give
# the same bytes: without physics a log depends on its trace, seed and machine alone. The paper's examples a thousand times, recorded sessions four times, and
# twice led by what was observed.
set -euo pipefail
cd "$(dirname "$0")/.."
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-2}
cmake --preset sanitize > /dev/null
cmake --build --preset sanitize --target continua
export ASAN_OPTIONS=detect_leaks=0

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
release=build/continua other=build/sanitize/continua

# A language in which a decimal point is a comma and an i has no dot: it is made here, since few machines have it.
export LOCPATH=$out/locales
mkdir "$LOCPATH"
for name in tr_TR de_DE; do localedef -i "$name" -f UTF-8 "$LOCPATH/$name.UTF-8" 2> /dev/null || true; done
languages=(C tr_TR.UTF-8 de_DE.UTF-8 C.UTF-8)
zones=(UTC Asia/Kathmandu America/St_Johns Pacific/Chatham)

# replay ROUND PROGRAM TRACE…: everything that may vary depends on the number of the round. Its logs must be those of
# the round before.
replay() {
  local round=$1 program=$2 layout=()
  shift 2
  if ((round % 5 == 4)) && setarch --addr-no-randomize true 2> /dev/null; then layout=(setarch --addr-no-randomize); fi
  env LC_ALL="${languages[round % 4]}" TZ="${zones[round / 2 % 4]}" "PADDING=$(printf "%$((round * 37))s" x)" \
    "${layout[@]}" "$program" replay "$@" --no-physics -j $((round % 4 + 1)) -o "$out/round" > /dev/null
  # A header names its compiler, and the digests of blocks and of the whole cover the header.
  sed -i -E -e '1s/"compiler":"[^"]*"//' -e '/^."kind":"(block|end)"/s/"digest":"[0-9a-f]*"//' "$out/round"/*.jsonl
  if [[ -d $out/first ]]; then diff -rq "$out/first" "$out/round"; else mv "$out/round" "$out/first"; fi
  rm -rf "$out/round"
}

examples=(traces/paper/*.trace.jsonl)
replays=0
for ((round = 0; replays < 1000; ++round)); do
  program=$release
  # With sanitizers a replay takes several times as long.
  if ((round % 12 == 7)); then program=$other; fi
  replay "$round" "$program" "${examples[@]}"
  ((replays += ${#examples[@]}))
done
echo "ci/same_bytes.sh: $replays replays of ${#examples[@]} examples in $round processes, one digest each"

rm -rf "$out/first"
traces=(traces/*.trace.jsonl traces/talk/*.trace.jsonl)
sessions=../shared/data/pilot2018
if [[ -d $sessions ]]; then
  # Every seventh, as that takes long with sanitizers.
  find "$sessions" -name '*.txt' | sort | awk 'NR % 7 == 0' | xargs "$release" import -o "$out/sessions/" 2> /dev/null
  traces+=("$out"/sessions/*.jsonl)
else
  echo "ci/same_bytes.sh: skipped the recorded sessions: no $sessions"
fi
for round in 0 3; do replay "$round" "$release" "${traces[@]}"; done
for round in 1 2; do replay "$round" "$other" "${traces[@]}"; done
if [[ -d $out/sessions ]]; then
  rm -rf "$out/first"
  replay 1 "$release" --variant teacher "$out"/sessions/*.jsonl
  replay 2 "$other" --variant teacher "$out"/sessions/*.jsonl
fi
echo "ci/same_bytes.sh: ${#traces[@]} traces, the same bytes in two builds and four processes"
