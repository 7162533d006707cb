#!/usr/bin/env bash
# Installs the project, builds examples/embed against the installation, and compares its output with its README.
#   embed_test.sh BUILD
set -euo pipefail
build=$1
cd "$(dirname "$0")/.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

cmake --install "$build" --prefix "$out/installed" > /dev/null
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[^=]*=//p' "$build/CMakeCache.txt")
cmake -S examples/embed -B "$out/build" -DCMAKE_PREFIX_PATH="$out/installed" -DCMAKE_CXX_COMPILER="$compiler" > /dev/null
cmake --build "$out/build" > /dev/null

# Another minor version is not taken for the one that is asked for.
mkdir "$out/other"
printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(other LANGUAGES CXX)' \
  'find_package(Continua 0.1 REQUIRED)' > "$out/other/CMakeLists.txt"
if cmake -S "$out/other" -B "$out/other/build" -DCMAKE_PREFIX_PATH="$out/installed" > "$out/refused" 2>&1 ||
  ! grep -q 'compatible with requested version "0.1"' "$out/refused"; then
  echo "find_package(Continua 0.1) was not refused for its version:" >&2
  cat "$out/refused" >&2
  exit 1
fi

# The README's console blocks: a command after "$ ", then its output.
sed -n '/^```console$/,/^```$/p' examples/embed/README.md | sed '/^```/d' > "$out/page"
commands=$(grep -c '^\$ embed ' "$out/page")
while IFS= read -r line; do
  printf '$ %s\n' "$line"
  (cd / && PATH=$out/build:$PATH bash -c "$line")
done < <(sed -n 's/^\$ //p' "$out/page") > "$out/printed" 2>&1
diff "$out/page" "$out/printed"
echo "$commands commands of examples/embed/README.md, the same output"

# The installed program finds its data beside itself.
(cd / && env -u CONTINUA_HOME "$out/installed/bin/continua" check > /dev/null)
