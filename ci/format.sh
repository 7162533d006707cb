#!/usr/bin/env bash
# Checks that the C++ is laid out as .clang-format says; --fix lays it out.
set -euo pipefail
cd "$(dirname "$0")/.."
if ! command -v clang-format > /dev/null; then
  echo "ci/format.sh: skipped: no clang-format"
  exit 0
fi
options=(--dry-run -Werror)
case "${1:-}" in
  --fix) options=(-i) ;;
  "") ;;
  *)
    echo "ci/format.sh: found '$1'; expected --fix or nothing" >&2
    exit 2
    ;;
esac
find engine replay tests web \( -name node_modules -o -name '.*' \) -prune -o \( -name '*.h' -o -name '*.cpp' \) -print0 |
  sort -z | xargs -0 clang-format "${options[@]}"
