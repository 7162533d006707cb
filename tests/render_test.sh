#!/usr/bin/env bash
# What `continua render` does where something is missing or it is interrupted. The program is the first argument, the
# source tree the second.
set -uo pipefail
program=$1
source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
complain() {
  echo "$1" >&2
  failed=1
}

"$program" replay "$source/traces/building_blocks.trace.jsonl" --no-physics -o "$folder/blocks.run.jsonl" > /dev/null || exit 1

# $1: what the one line on standard error must contain; then the command. No file may be left.
refuses() {
  local part=$1 said status
  shift
  said=$("$@" 2>&1)
  status=$?
  if [[ $status != 2 || $said != *"$part"* || $said == *$'\n'* ]]; then complain "$*: status $status, said: $said"; fi
  if compgen -G "$folder/out*" > /dev/null; then complain "$*: left a file"; rm -f "$folder"/out*; fi
}

without_egl=(env "__EGL_VENDOR_LIBRARY_FILENAMES=$folder/none.json")
refuses "libegl-mesa0" "${without_egl[@]}" "$program" render "$folder/blocks.run.jsonl" -o "$folder/out.png"
refuses "libegl-mesa0" "${without_egl[@]}" "$program" render "$folder/blocks.run.jsonl" -o "$folder/out.mp4"
"${without_egl[@]}" "$program" export "$folder/blocks.run.jsonl" --to json -o "$folder/blocks.json" ||
  complain "export without EGL failed"

if ! "$program" render "$folder/blocks.run.jsonl" -o "$folder/one.png" --at 1 --size 64x48 > /dev/null; then
  echo "pictures cannot be drawn here: films are not tested" >&2
  exit "$((failed ? 1 : 77))"
fi
refuses "Debian's package ffmpeg" env PATH=/nonexistent "$program" render "$folder/blocks.run.jsonl" -o "$folder/out.mp4"
if ! command -v ffmpeg > /dev/null; then exit "$((failed ? 1 : 77))"; fi
# As soon as it writes; a job of a script hears of an interrupt only with job control.
interrupted_film() {
  set -m
  "$program" render "$folder/blocks.run.jsonl" -o "$folder/out.mp4" --real-time --fps 60 &
  until [[ -e $folder/out.mp4.part ]] || ! kill -0 $!; do sleep 0.05; done
  kill -INT $!
  wait $!
}
refuses "interrupted" interrupted_film
exit "$failed"
