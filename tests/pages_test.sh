#!/usr/bin/env bash
# Compares the pages that scripts print with the files in the repository. The argument is the build tree.
set -uo pipefail
build=$1
cd "$(dirname "$0")/.."
failed=0

compare() {
  local page=$1
  shift
  if ! diff -u "$page" <("$@"); then
    echo "$page is out of date: ${*/$build/build} > $page" >&2
    failed=1
  fi
}

compare docs/commands.md ci/commands_page.sh "$build/continua"
compare docs/architecture.svg /usr/bin/python3 ci/architecture.py
for picture in docs/machines/*.svg; do
  compare "$picture" "$build/continua" machine "$(basename "$picture" .svg)" --svg
done
exit "$failed"
