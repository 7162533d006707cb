#!/usr/bin/env bash
# The C++ tests under AddressSanitizer and UndefinedBehaviorSanitizer, in build/sanitize:
#   ci/sanitize.sh [I/N [PATTERN]]
# all of them, or the I-th of N parts, so that N nights have tried them all; of those, the ones whose name has PATTERN
# (a regular expression, as in ctest -R). Builds first, which takes long the first time.
set -euo pipefail
cd "$(dirname "$0")/.."
part=${1:-1/1}
if ! [[ $part =~ ^([0-9]+)/([0-9]+)$ ]] || ((10#${BASH_REMATCH[1]} < 1 || 10#${BASH_REMATCH[1]} > 10#${BASH_REMATCH[2]})); then
  echo "ci/sanitize.sh: the part is '$part'; expected I/N, with I from 1 to N" >&2
  exit 2
fi
cmake --preset sanitize
cmake --build --preset sanitize
# No leaks are looked for: MuJoCo's and the XML reader's errors jump over destructors.
# ctest takes each N-th test from the I-th on; a C++ test has its folder before its name, as a page's has web.
ASAN_OPTIONS=detect_leaks=0 ctest --preset sanitize --tests-regex "${2:-^[a-z_]+:}" --exclude-regex "^web:" \
  --tests-information "$((10#${BASH_REMATCH[1]})),,$((10#${BASH_REMATCH[2]}))"
