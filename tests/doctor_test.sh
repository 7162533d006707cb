#!/usr/bin/env bash
# `continua doctor` where all is well, and where a part is missing. Arguments: the program, the source tree.
set -uo pipefail
program=$1
tree=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0

# $1: the status expected; $2: a pattern that a line must have; then the command.
check() {
  local status=$1 pattern=$2 found
  shift 2
  found=$("$@" 2>&1)
  local was=$?
  if [[ $was != "$status" ]] || ! grep -qE "$pattern" <<< "$found"; then
    printf '%s: status %s, expected %s and a line like %s\n%s\n' "$*" "$was" "$status" "$pattern" "$found" >&2
    failed=1
  fi
}

check 0 '^ok +physics +MuJoCo [0-9.]+: [0-9]+ scenes' "$program" doctor --port 0
check 0 '^no +films +.*ffmpeg' env PATH="$folder" "$program" doctor --port 0
check 1 '^FAIL knowledge .*expected the project' env CONTINUA_HOME="$folder" "$program" doctor --port 0
check 1 '^FAIL knowledge .*is no folder' "$program" doctor --port 0 --knowledge "$folder/none"

mkdir -p "$folder/tree/engine"
cp -r "$tree/engine/knowledge" "$folder/tree/engine"
cp -r "$tree/mjcf" "$folder/tree"
# A program in a folder of its own finds no model of hands beside itself.
cp "$program" "$folder/alone"
check 0 '^ok +page +.*no hands by camera, for want of @mediapipe/hands' env CONTINUA_HOME="$folder/tree" "$folder/alone" doctor --port 0
mkdir "$folder/tree/hands"
touch "$folder/tree/hands"/hands.js
check 0 '^ok +page +.*, hands by camera' env CONTINUA_HOME="$folder/tree" "$folder/alone" doctor --port 0
echo '{' > "$folder/tree/engine/knowledge/machines/palindromes.json"
sed -i 's/timestep="0.002"/timestep="2"/' "$folder/tree/mjcf/scenes/workbench.xml"
check 1 '^FAIL knowledge .*palindromes.json:' env CONTINUA_HOME="$folder/tree" "$program" doctor --port 0
check 1 '^FAIL physics .*workbench.xml' env CONTINUA_HOME="$folder/tree" "$program" doctor --port 0

# A port that another program has.
"$program" serve "$folder" --port 0 > "$folder/said" &
server=$!
for _ in {1..100}; do grep -q ':[0-9]*/' "$folder/said" && break; sleep 0.1; done
port=$(sed -E 's|.*:([0-9]+)/.*|\1|' "$folder/said")
check 0 '^no +port +.*in use' "$program" doctor --port "$port"
kill "$server"
exit "$failed"
