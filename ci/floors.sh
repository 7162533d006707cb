#!/usr/bin/env bash
# Checks the headers that a folder includes: its own, those of the folders below, and a third-party library only in the
# files that wrap it. Checks the length of files and functions too.
set -euo pipefail
cd "$(dirname "$0")/.."
longest=500
longest_function=60

# The folders, and what each may include of the others: the lists that the build links by.
declare -A floors
engine=$(tr '\n' ' ' < replay/CMakeLists.txt | sed -E 's/.*set\(engine ([^)]*)\).*/\1/')
while read -r folder allowed; do
  allowed=${allowed%%NEEDS*}
  floors[$folder]=" ${allowed/'${engine}'/$engine} "
done < <(cat engine/CMakeLists.txt replay/CMakeLists.txt | tr '\n' ' ' | grep -oE 'continua_folder\([^)]*' |
  sed -E 's/continua_folder\(([a-z_]+) MAY_INCLUDE/\1/; s/ +/ /g')

# Folders that may include only some headers of another one: FOLDER/OTHER and the headers.
declare -A only=(
  [pictures/simulation]="renderer.h"
)

# Third-party headers and the only files that may include them.
wrappers='
nlohmann/*     engine/core/located_json.h
xxhash.h       engine/core/digest.cpp
Eigen/*        engine/world/*.h engine/world/*.cpp engine/simulation/*
pugixml.hpp    engine/voxml/catalogue* engine/machine_file/jflap* engine/simulation/scene* replay/annotation/eaf* replay/recogniser/emma* tests/replay/export/*
mujoco/*       engine/simulation/*
EGL/*          engine/simulation/*
GL/*           engine/simulation/*
httplib.h      replay/server/*
zlib.h         engine/core/gzip.cpp engine/core/gzip_blocks.cpp engine/core/gzip_pieces.cpp replay/mcap/chunk_packing.cpp
zstd.h         replay/mcap/chunk_packing.cpp
cairo*         replay/pictures/canvas.cpp
graphviz/*     replay/export/graph_layout.cpp
CLI/*          replay/commands/*
catch2/*       tests/support/*
rapidcheck*    tests/*
benchmark/*    tests/bench/*
pybind11/*     python/module/*
'

fail=0
complain() {
  echo "$1" >&2
  fail=1
}

# Whether $1 fits one of the patterns after it.
# shellcheck disable=SC2053  # the right-hand side is meant as a pattern
fits_any() {
  local text=$1 pattern
  shift
  for pattern in "$@"; do [[ $text == $pattern ]] && return 0; done
  return 1
}

# Our header $3, included on line $2 of file $1: "continua/FOLDER/NAME.h" or "continua/replay/FOLDER/NAME.h".
check_ours() {
  local file=$1 line=$2 header=${3#continua/} folder other
  header=${header#replay/}
  case $file in
    engine/*/* | replay/*/*) folder=${file#*/} folder=${folder%%/*} ;;
    *) return 0 ;;
  esac
  other=${header%%/*}
  [[ $other == "$folder" || $other == "$header" ]] && return
  if [[ " ${floors[$folder]-} " != *" $other "* ]]; then
    complain "$file:$line: includes \"$3\"; this folder may include: ${floors[$folder]-nothing: CMake does not know it}"
  elif [[ -n ${only[$folder/$other]-} && " ${only[$folder/$other]} " != *" ${header#*/} "* ]]; then
    complain "$file:$line: includes \"$3\"; of $other this folder may include: ${only[$folder/$other]}"
  fi
}

# The header $3 in angle brackets, included on line $2 of file $1.
check_library() {
  local file=$1 line=$2 header=$3 pattern places
  while read -r pattern places; do
    [[ -n $pattern ]] && fits_any "$header" "$pattern" || continue
    read -ra places <<< "$places"
    fits_any "$file" "${places[@]}" || complain "$file:$line: includes <$header>, which belongs in: ${places[*]}"
    return
  done <<< "$wrappers"
}

set -f
while IFS=: read -r file line text; do
  case "$text" in
    *\"*) header=${text#*\"} && check_ours "$file" "$line" "${header%%\"*}" ;;
    *\<*) header=${text#*<} && check_library "$file" "$line" "${header%%>*}" ;;
  esac
done < <(grep -rnE --include='*.h' --include='*.cpp' '^[[:space:]]*#[[:space:]]*include' engine python replay tests | sort)

while read -r count file; do
  if ((count > longest)); then complain "$file:$count: is $count lines long; expected at most $longest"; fi
done < <(find engine python replay tests web ci mjcf traces -name node_modules -prune -o -type f \
  \( -name '*.h' -o -name '*.cpp' -o -name '*.js' -o -name '*.css' -o -name '*.html' -o -name '*.sh' -o -name '*.md' \) \
  -exec wc -l {} \;)

while read -r place; do complain "$place"; done < <(find engine python replay web tests/web -name node_modules -prune -o -type f \
  \( -name '*.h' -o -name '*.cpp' -o -name '*.js' -o -name '*.mjs' \) -print0 |
  xargs -0 awk -v limit="$longest_function" -f ci/long_functions.awk)

exit "$fail"
