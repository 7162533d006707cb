#!/usr/bin/env bash
# The C++ tests, and mutations of every input, under AddressSanitizer and UndefinedBehaviorSanitizer, by clang, in
# build/sanitize:
#   ci/sanitize.sh [I/N [PATTERN]]
# all of them, or the I-th of N parts, or with "turn/N" the part whose turn the number of commits makes it, so that N
# changes have tried them all; of those, the ones whose name has PATTERN (a regular expression, as in ctest -R). With a
# PATTERN nothing is mutated.
set -euo pipefail
cd "$(dirname "$0")/.."
part=${1:-1/1}
if [[ $part == turn/* ]]; then
  count=${part#turn/}
  commits=$(git rev-list --count HEAD 2> /dev/null || echo 0)
  if [[ $count =~ ^[1-9][0-9]*$ ]]; then part=$((commits % count + 1))/$count; fi
fi
if ! [[ $part =~ ^([0-9]+)/([0-9]+)$ ]] || ((10#${BASH_REMATCH[1]} < 1 || 10#${BASH_REMATCH[1]} > 10#${BASH_REMATCH[2]})); then
  echo "ci/sanitize.sh: the part is '$part'; expected I/N, with I from 1 to N, or turn/N" >&2
  exit 2
fi
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-2}
# Warnings are the release build's matter.
cmake --preset sanitize > /dev/null
cmake --build --preset sanitize
echo "ci/sanitize.sh: part $part"
# No leaks are looked for: MuJoCo's and the XML reader's errors jump over destructors. The rest makes it twice as fast:
# a report has one line of where memory was allocated, and a freed piece is watched until some MB more are freed.
export ASAN_OPTIONS=detect_leaks=0:malloc_context_size=1:max_malloc_fill_size=0:quarantine_size_mb=8:thread_local_quarantine_size_kb=64
# A property is tried on twenty values; the plain build tries a hundred.
export RC_PARAMS=max_success=20
# ctest takes each N-th test from the I-th on. The random puts are counted, and each compiler rounds them otherwise.
ctest --preset sanitize --label-regex '^cpp$' --tests-regex "${2:-.}" --exclude-regex '^simulation/random_puts$' \
  --tests-information "$((10#${BASH_REMATCH[1]})),,$((10#${BASH_REMATCH[2]}))" --parallel "$CMAKE_BUILD_PARALLEL_LEVEL"
if [[ -z ${2:-} ]]; then
  cd build/sanitize
  tests/fuzz_mutate --list | xargs -n 1 -P "$CMAKE_BUILD_PARALLEL_LEVEL" tests/fuzz_mutate 10 1
fi
