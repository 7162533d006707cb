#!/usr/bin/env bash
# Runs `continua accept` with words that a command line may take for something else. The program is the first argument.
set -uo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0

# Accepts words of a and - that are their own mirror image, by final state; no stack becomes empty.
cat > "$folder/m.jff" << 'END'
<structure><type>pda</type><automaton>
<state id="0"><initial/></state><state id="1"/><state id="2"><final/></state>
<transition><from>0</from><to>0</to><read>a</read><push>a</push></transition>
<transition><from>0</from><to>0</to><read>-</read><push>-</push></transition>
<transition><from>0</from><to>1</to></transition>
<transition><from>1</from><to>1</to><read>a</read><pop>a</pop></transition>
<transition><from>1</from><to>1</to><read>-</read><pop>-</pop></transition>
<transition><from>1</from><to>2</to><pop>Z</pop><push>Z</push></transition>
</automaton></structure>
END

# $1: verdicts by their first letters and the exit status; then the arguments.
check() {
  local expected=$1 found
  shift
  found=$(printf 'aa\r\n\n-a' | "$program" accept "$@" 2> /dev/null; echo "$?")
  found=$(sed 's/accept/a/; s/reject/r/' <<< "$found" | tr -d '\n')
  if [[ $found != "$expected" ]]; then
    echo "accept $*: expected $expected, found $found" >&2
    failed=1
  fi
}

machine=$folder/m.jff
check aa0 "$machine" aa ''
check araa1 "$machine" -aa- -a -- -- aa  # the first -- is no word
check rrr1 "$machine" aa -aa- --empty-stack ''
check ra1 "$machine" -- --empty-stack --
check ar1 "$machine" -- -- aa-
check rrrr1 "$machine" replay accept --no=option -x
check raar1 "$machine" -a --words -
check aar1 --words - "$machine"
check 2 "$machine"
check 2 "$machine" --
check 2
exit "$failed"
