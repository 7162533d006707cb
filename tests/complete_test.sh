#!/usr/bin/env bash
# Completes command lines by the program itself, and in the shells that are installed. The argument is the program.
set -uo pipefail
program=$1
here=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/bin" "$folder/at/runs"
ln -s "$program" "$folder/bin/continua"
touch "$folder/at/"{a.trace.jsonl,b.trace.jsonl,a.run.jsonl,my.json,x.xml,"two words.trace.jsonl"} "$folder/at/runs/c.run.jsonl"
cd "$folder/at" || exit
PATH=$folder/bin:$PATH
failed=0

# $1: the words expected, in order, between spaces; then the words of the line.
check() {
  local expected=$1 found
  shift
  found=$(continua complete -- "$@" | cut -f 1 | tr '\n' '|')
  if [[ $found != "$expected" ]]; then
    echo "complete $*: expected $expected, found $found" >&2
    failed=1
  fi
}

check 'record|render|replay|' re
check '--help|' --h
check '--seed|' replay --see
check '--seed|--set|' replay --se
check 'palindromes|' replay --machine pal
check '--machine=palindromes|' replay --machine=pal
check 'palindromes|' replay --machine = pal
check 'palindromes|' machine pal
check 'my.json|' machine my
check 'place_setting|' record --scene pl
check 'english|' record --language en
check 'a.trace.jsonl|' replay a
check 'a.run.jsonl|a.trace.jsonl|' check a
check 'a.run.jsonl|' explain a
check 'runs/|' explain ru
check 'runs/c.run.jsonl|' export runs/
check 'html|' export a.run.jsonl --to ht
check 'free|teacher|world|' replay --variant ''
check '' replay --seed 1
check '' explain a.run.jsonl ''
check '' nonsense ''
check '' -- --

# The meaning of a command or an option follows it.
continua complete -- accep | grep -q "^accept	Tell which words" || { echo 'complete accep: no meaning' >&2; failed=1; }

in_bash() {
  bash --norc -c '
    source "$1/ci/packaging/completions/continua.bash"
    COMP_WORDS=(continua "${@:2}") COMP_CWORD=$(($# - 1))
    compopt() { :; }
    _continua
    printf "%s|" "${COMPREPLY[@]}"' bash "$here" "$@"
}
in_zsh() {
  zsh -f -c '
    compdef() { :; }
    _describe() { for each in "${(@P)2}"; do printf "%s|" "${each%%:*}"; done; }
    compadd() { for each in "$@"; do case "$each" in -*|"") ;; *) printf "%s|" "$each";; esac; done; }
    words=(continua "${@:2}") CURRENT=$#
    source "$1/ci/packaging/completions/_continua"' zsh "$here" "$@"
}
in_fish() {
  HOME=$folder fish --no-config -c 'source $argv[1]/ci/packaging/completions/continua.fish; complete -C "continua $argv[2..-1]"' "$here" "$@" |
    cut -f 1 | tr '\n' '|'
}
for shell in bash zsh fish; do
  if ! command -v "$shell" > /dev/null; then echo "not tried: no $shell"; continue; fi
  for line in 're=record|render|replay|' 'replay --machine pal=palindromes|' 'explain a=a.run.jsonl|' 'explain ru=runs/|'; do
    read -ra words <<< "${line%%=*}"
    found=$("in_$shell" "${words[@]}")
    if [[ $found != "${line#*=}" ]]; then
      echo "$shell: ${line%%=*}: expected ${line#*=}, found $found" >&2
      failed=1
    fi
  done
done
exit "$failed"
