#!/usr/bin/env bash
# Replays traces in the release and the debug build, twice each, and wants the same bytes of all four: where no physics
# runs a log may depend on nothing but its trace, seed and machine.
set -euo pipefail
cd "$(dirname "$0")/.."
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-2}
cmake --preset debug -B build/bytes -DCMAKE_CXX_FLAGS_DEBUG=-O0 > /dev/null
cmake --build build/bytes --target continua

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
traces=(traces/*.trace.jsonl traces/{paper,talk}/*.trace.jsonl)
sessions=../shared/data/pilot2018
if [[ -d $sessions ]]; then
  # Every seventh: the debug build is ten times slower.
  find "$sessions" -name '*.txt' | sort | awk 'NR % 7 == 0' | xargs build/continua import -o "$out/sessions/" 2> /dev/null
  traces+=("$out"/sessions/*.jsonl)
else
  echo "ci/same_bytes.sh: skipped the recorded sessions: no $sessions"
fi
for run in release-1 release-2 debug-1 debug-2; do
  program=build/continua
  if [[ $run == debug-* ]]; then program=build/bytes/continua; fi
  "$program" replay "${traces[@]}" --no-physics -j 2 -o "$out/$run" > /dev/null
  diff -rq "$out/release-1" "$out/$run"
done
echo "ci/same_bytes.sh: ${#traces[@]} traces, the same bytes in two builds and four processes"
