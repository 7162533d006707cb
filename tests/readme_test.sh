#!/usr/bin/env bash
# Runs the commands in the console blocks of README.md and of docs/ in the source tree, with `build/` standing for the
# build tree given as the first argument, and compares the output with the page. The time that a check took is a second
# there. Each page is run from an empty folder for `build/`. With CONTINUA_RENEW_PAGES=1 the pages get the output that
# is printed now.
set -uo pipefail
build=$1
cd "$(dirname "$0")/.."
all=$(mktemp -d)
trap 'rm -rf "$all"' EXIT
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
  renewed+="$ $command"$'\n'
  if [[ -n $found ]]; then renewed+=$found$'\n'; fi
  if [[ "$found" != "${expected%$'\n'}" && -z ${CONTINUA_RENEW_PAGES:-} ]]; then
    printf '$ %s\n--- %s says\n%s\n--- it prints\n%s\n' "$command" "$page" "${expected%$'\n'}" "$found" >&2
    failed=1
  fi
  commands=$((commands + 1))
}

# Runs the console blocks of $page, and counts their commands.
check_page() {
  local inside=false command='' expected='' line renewed=''
  while IFS= read -r line; do
    case "$line" in
      '```console') inside=true renewed+=$line$'\n' ;;
      '```')
        if [[ $inside == true ]]; then check; fi
        inside=false command='' expected='' renewed+=$line$'\n'
        ;;
      '$ '*) if [[ $inside == true ]]; then check; command=${line#'$ '} expected=''; else renewed+=$line$'\n'; fi ;;
      *) if [[ $inside == true ]]; then expected+=$line$'\n'; else renewed+=$line$'\n'; fi ;;
    esac
  done < "$page"
  if [[ -n ${CONTINUA_RENEW_PAGES:-} ]]; then printf '%s' "$renewed" > "$page"; fi
}

for page in README.md docs/tour.md docs/*.md; do
  out=$all/$(basename "$page" .md)
  # Named twice above, so that a tour that has no blocks any more is noticed.
  if [[ -d $out ]]; then continue; fi
  mkdir "$out"
  commands=0
  check_page
  if [[ $commands == 0 && $page =~ README|tour ]]; then echo "$page has no console blocks" >&2; failed=1; fi
done
exit "$failed"
