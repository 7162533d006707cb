#!/usr/bin/env bash
# The six commands that share their work, over generated traces: what --merge tells of N shards must be, byte for byte, what
# one process tells.
#
#   tests/merged_test.sh PROGRAM [TRACES [N…]]     (otherwise 24 traces, N of 2 and 7; all: 1000 1 2 7 64)
set -euo pipefail
program=$1
many=${2:-24}
counts=("${@:3}")
[[ ${#counts[@]} -gt 0 ]] || counts=(2 7)
root=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
failed=0
complain() {
  echo "$1" >&2
  failed=1
}

# As many variants of each example as it takes, in the kinematic world. Something observed in each gives score its figures.
examples=("$root"/traces/paper/*.trace.jsonl "$root"/traces/talk/wizard.trace.jsonl)
each=$(((many + ${#examples[@]} - 1) / ${#examples[@]}))
for example in "${examples[@]}"; do "$program" vary "$example" --count "$each" -o varied > said; done
mkdir traces
find varied -name '*.trace.jsonl' | sort | head -n "$many" | while read -r trace; do
  awk 'NR == 2 { t = $0; sub(/^[{]"t":/, "", t); sub(/,.*/, "", t)
                 print "{\"t\":" t ",\"kind\":\"observed\",\"channel\":\"speech\",\"content\":\"Okay.\"}" }
       { print }' "$trace" > "traces/${trace##*/}"
done
traces=(traces/*.trace.jsonl)
[[ ${#traces[@]} == "$many" ]] || complain "${#traces[@]} traces were made; expected $many"

cat > grid.json << 'END'
{ "grid": { "surer_by": [0.2, 0.6] }, "policies": ["likeliest", "sample"] }
END
# Each point takes all of its traces: a quarter of them, of the machine whose parameter is set, keeps the test quick.
mapfile -t swept < <(grep -l '"machine": *"interaction"' "${traces[@]}" | head -n "$(((many + 3) / 4))")
# A check's last line tells how long it took.
timeless() { sed 's/; in [0-9.]* s$//'; }
# The arguments of a command and of its merge, into `command` and `merging`.
arguments() {
  case $1 in
    replay) command=(replay "${traces[@]}" --no-physics -o runs/) merging=() ;;
    score) command=(score "${traces[@]}" --json) merging=(--json) ;;
    coverage) command=(coverage runs --json) merging=(--json) ;;
    table) command=(table runs -o table) merging=(-o table) ;;
    check) command=(check traces --no-physics) merging=() ;;
    sweep) command=(sweep grid.json "${swept[@]}" -o sweep) merging=(-o sweep) ;;
  esac
}
commands=(replay score coverage table check sweep)
for one in "${commands[@]}"; do
  arguments "$one"
  status=0
  "$program" "${command[@]}" 2> said | timeless > "$one.txt" || status=$?
  echo "$status" >> "$one.txt"
done
mv table table.whole
mv sweep sweep.whole

for count in "${counts[@]}"; do
  for one in "${commands[@]}"; do
    arguments "$one"
    for ((index = 1; index <= count; ++index)); do
      "$program" "${command[@]}" --shard "$index/$count" --report "$index.json" > shard.txt 2> said || true
    done
    status=0
    "$program" "$one" --merge $(seq -f '%g.json' "$count") "${merging[@]}" 2> said | timeless > merged.txt || status=$?
    echo "$status" >> merged.txt
    cmp "$one.txt" merged.txt >&2 || complain "$one of $many traces in $count shards: not what one process tells"
    rm [0-9]*.json
  done
  rm -rf table/shard-*
  diff -r table.whole table >&2 || complain "table of $many traces in $count shards: other tables"
  diff -r --exclude=index.html sweep.whole sweep >&2 || complain "sweep of $many traces in $count shards: other files"
  rm -rf table sweep
  echo "$count shards: ${#commands[@]} commands over $many traces"
done
exit "$failed"
