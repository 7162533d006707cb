#!/usr/bin/env bash
# Shares a command of continua among hosts by GNU parallel, and tells what came out as one process would:
#
#   examples/cluster/parallel.sh one,two check traces --no-physics -- 20
#   examples/cluster/parallel.sh one,two sweep grid.json traces/*.jsonl -o sweep -- 20 -o sweep
#
# The hosts are those of parallel's --sshlogin, ":" is this one; all must see this folder under its name. The number after
# -- is that of the shards; options after it are for the merge. The reports stay in a folder shards.XXXXXX here.
set -euo pipefail

hosts=${1:-}
[[ $# -gt 0 ]] && shift
command=()
while [[ $# -gt 0 && $1 != -- ]]; do command+=("$1"); shift; done
if [[ ${#command[@]} == 0 || $# -lt 2 ]]; then
  sed -n '2,9s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
shards=$2
shift 2

folder=$(mktemp -d "$PWD/shards.XXXXXX")
program=$(command -v "${CONTINUA:-continua}")
quoted() { printf "%q " "$@"; }

# A shard that fails is told by the merge.
seq "$shards" | parallel --sshlogin "$hosts" --workdir "$PWD" \
  "$(quoted "$program" "${command[@]}") --shard {}/$shards --report $(printf %q "$folder")/{}.json" > "$folder/said.txt" || true
"$program" "${command[0]}" --merge "$folder"/[0-9]*.json "$@"
