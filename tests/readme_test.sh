#!/usr/bin/env bash
# Runs the commands of README.md's console blocks in the source tree, with `build/` standing for the build tree given as
# the first argument, and compares what they print with what the README says. How long a check took is a second there.
set -uo pipefail
build=$1
cd "$(dirname "$0")/.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
failed=0

# A command that serves is given a moment and then stopped; its port is replaced by a free one.
run() {
  local command=$1
  # The program last: the build tree's own path may contain "build/".
  command=${command//build\/continua/@program@}
  command=${command//build\//$out/}
  command=${command//@program@/$build/continua}
  if [[ $command == *" serve "* ]]; then
    timeout 3 bash -c "${command/--port 8080/--port 0}" 2>&1 | sed -E 's/:[0-9]+\//:8080\//'
  else
    bash -c "$command" 2>&1
  fi | sed -E "s|$out/|build/|g; s/; in [0-9.]+ s\$/; in 1.0 s/"
}

check() {
  [[ -n $command ]] || return
  local found
  found=$(run "$command")
  if [[ "$found" != "${expected%$'\n'}" ]]; then
    printf '$ %s\n--- README.md says\n%s\n--- it prints\n%s\n' "$command" "${expected%$'\n'}" "$found" >&2
    failed=1
  fi
  commands=$((commands + 1))
}

inside=false command='' expected='' commands=0
while IFS= read -r line; do
  case "$line" in
    '```console') inside=true ;;
    '```') if [[ $inside == true ]]; then check; fi; inside=false command='' expected='' ;;
    '$ '*) if [[ $inside == true ]]; then check; command=${line#'$ '} expected=''; fi ;;
    *) if [[ $inside == true ]]; then expected+=$line$'\n'; fi ;;
  esac
done < README.md
if ((commands == 0)); then echo "README.md has no console blocks" >&2; exit 1; fi
exit "$failed"
