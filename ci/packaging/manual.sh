#!/usr/bin/env bash
# Writes a compressed manual page for the program and for each of its commands, from their --help.
#   manual.sh PROGRAM FOLDER
set -euo pipefail
program=$1 folder=$2
page_of=$(dirname "$0")/manual_page.awk
version=$("$program" --version | sed -n 's/^continua //p')
commands=$("$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z_-]*\) .*/\1/p')
rm -rf "$folder"
mkdir -p "$folder"

# page NAME SEE HELP…: the words of the program with these arguments.
page() {
  local name=$1 see=$2
  shift 2
  "$program" "$@" | LC_ALL=C.UTF-8 awk -v name="$name" -v version="$version" -v see="$see" -f "$page_of" | gzip -9n > "$folder/$name.1.gz"
}

all=$(for command in $commands; do printf '.BR continua\\-%s (1),\n' "$command"; done | sed '$s/,$//')
page continua "${all//\\/\\\\}" --help
for command in $commands; do page "continua-$command" '.BR continua (1)' "$command" --help; done
