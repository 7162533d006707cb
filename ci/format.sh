#!/usr/bin/env bash
# Checks the layout of the C++ (.clang-format), and of the JavaScript and CSS (.prettierrc.json); --fix lays it out.
# A language is skipped where its formatter is not installed. Prettier comes with the packages of the browser tests.
set -euo pipefail
cd "$(dirname "$0")/.."
fix=false
case "${1:-}" in
  --fix) fix=true ;;
  "") ;;
  *)
    echo "ci/format.sh: found '$1'; expected --fix or nothing" >&2
    exit 2
    ;;
esac

# The files below these folders with one of these endings, each followed by a zero byte.
files() {
  local folders=$1 names=() ending
  shift
  for ending in "$@"; do names+=(-o -name "*.$ending"); done
  # shellcheck disable=SC2086  # folders are several words
  find $folders \( -name node_modules -o -name '.*' \) -prune -o -type f \( "${names[@]:1}" \) -print0 | sort -z
}

if command -v clang-format > /dev/null; then
  options=(--dry-run -Werror)
  if $fix; then options=(-i); fi
  files "engine python replay tests web" h cpp | xargs -0 clang-format "${options[@]}"
else
  echo "ci/format.sh: C++ skipped: no clang-format"
fi

prettier=
for modules in "${CONTINUA_NODE_MODULES:-}" build/tests/web/npm/node_modules build/*/tests/web/npm/node_modules; do
  if [[ -f $modules/prettier/bin/prettier.cjs ]]; then prettier=$modules/prettier/bin/prettier.cjs; fi
done
if [[ -n $prettier ]] && command -v node > /dev/null; then
  option=--check
  if $fix; then option=--write; fi
  files "web tests" js mjs css | xargs -0 node "$prettier" --log-level warn "$option"
else
  echo "ci/format.sh: JavaScript and CSS skipped: no prettier; configure with the tests' packages"
fi
