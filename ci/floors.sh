#!/usr/bin/env bash
# Checks which headers a folder includes: a folder may use those below it, and a third-party library only where it is
# wrapped. Also that no file outgrows a reader.
set -euo pipefail
cd "$(dirname "$0")/.."
longest=500

# Files (a pattern over their paths) and what they may include of engine/ and replay/ (folders, or patterns of
# headers). The first pattern that fits a file counts. A folder may include itself.
floors='
engine/core/*                 -
engine/term/*                 core
engine/world/*                core
engine/voxml/*                core term
engine/automaton/*            core term
engine/machine_file/*         core term automaton
engine/analysis/*             core term automaton
engine/perception/*           core world
engine/language/*             core term voxml world perception
engine/moves/*                core term world perception language
engine/composition/*          core term world voxml moves automaton
engine/behaviour/*            core term world voxml moves composition
engine/pipeline/*             core term world voxml automaton perception language moves composition behaviour
engine/simulation/*           core world behaviour/avatar_command.h
replay/trace/*                core world perception
replay/run/*                  core
replay/views/*                core replay/run
replay/diff/trace_diff*       core world perception replay/trace replay/run replay/views
replay/diff/*                 core replay/run replay/views
replay/explain/*              core replay/run replay/views
replay/coverage/*             core replay/run replay/views
replay/exporters/*            core replay/run replay/views
replay/report/*               core replay/run replay/views replay/diff replay/exporters
replay/what_if/run_*          core replay/run replay/views
replay/score/*                core world replay/score/agreement.h replay/score/episodes.h replay/shell_word.h
replay/pictures/*             core world simulation/renderer.h replay/run replay/views
replay/inspector/inspector_*  core replay/run replay/views replay/diff replay/exporters replay/explain replay/what_if/run_*
replay/inspector/run_*        core replay/run replay/views
replay/recorder/*             pipeline core term world voxml automaton perception language moves composition behaviour replay/trace replay/run replay/score/agreement.h
'

# Third-party headers and the only files that may include them.
wrappers='
nlohmann/*     engine/core/located_json.h
xxhash.h       engine/core/digest.cpp
Eigen/*        engine/world/*.h engine/world/*.cpp engine/simulation/*
pugixml.hpp    engine/voxml/catalogue* engine/machine_file/jflap* engine/simulation/scene* tests/replay/exporters/* tests/replay/report/*
mujoco/*       engine/simulation/*
EGL/*          engine/simulation/*
GL/*           engine/simulation/*
png.h          engine/simulation/*
httplib.h      replay/server/*
zlib.h         replay/inspector/gzip.cpp
cairo*         replay/pictures/canvas.cpp
graphviz/*     replay/exporters/graph_layout.cpp
CLI/*          replay/main.cpp replay/commands/*
catch2/*       tests/support/*
rapidcheck*    tests/*
benchmark/*    tests/bench/*
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

# Our header $3, included on line $2 of file $1.
check_ours() {
  local file=$1 line=$2 header=$3 pattern allowed entry
  while read -r pattern allowed; do
    [[ -n $pattern ]] && fits_any "$file" "$pattern" || continue
    fits_any "engine/$header" "${file%/*}/*" && return
    fits_any "$header" "${file%/*}/*" && return
    for entry in $allowed; do fits_any "$header" "$entry" "$entry/*" && return; done
    complain "$file:$line: includes \"$header\"; this file may include: ${allowed}"
    return
  done <<< "$floors"
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
done < <(grep -rnE --include='*.h' --include='*.cpp' '^[[:space:]]*#[[:space:]]*include' engine replay tests | sort)

while read -r count file; do
  if ((count > longest)); then complain "$file:$count: is $count lines long; expected at most $longest"; fi
done < <(find engine replay tests web ci mjcf traces -name node_modules -prune -o -type f \
  \( -name '*.h' -o -name '*.cpp' -o -name '*.js' -o -name '*.css' -o -name '*.html' -o -name '*.sh' -o -name '*.md' \) \
  -exec wc -l {} \;)

exit "$fail"
