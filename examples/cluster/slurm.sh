#!/usr/bin/env bash
# Shares a command of continua among the tasks of a Slurm job array, and tells what came out as one process would:
#
#   examples/cluster/slurm.sh check traces --no-physics -- 20
#   examples/cluster/slurm.sh sweep grid.json traces/*.jsonl -o sweep -- 20 -o sweep
#
# The number after -- is that of the tasks; options after it are for the merge (-- 20 --junit all.xml). SBATCH_… variables
# set partition, account and time limit. The reports and the output of each task stay in a folder shards.XXXXXX here, which
# all nodes must see. A task that was killed leaves no report: its shard is missing, and the whole ends with status 2.
set -euo pipefail

command=()
while [[ $# -gt 0 && $1 != -- ]]; do command+=("$1"); shift; done
if [[ ${#command[@]} == 0 || $# -lt 2 ]]; then
  sed -n '2,9s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
tasks=$2
shift 2

folder=$(mktemp -d "$PWD/shards.XXXXXX")
program=$(command -v "${CONTINUA:-continua}")
quoted() { [[ $# == 0 ]] || printf "%q " "$@"; }

job=$(sbatch --parsable --job-name=continua --array="1-$tasks" --output="$folder/%a.txt" \
  --wrap "$(quoted "$program" "${command[@]}") --shard auto --report $(printf %q "$folder")/\$SLURM_ARRAY_TASK_ID.json")
status=0
# The merge waits for all tasks, also for those that fail.
sbatch --wait --dependency="afterany:${job%%;*}" --job-name=continua-merge --output="$folder/all.txt" \
  --wrap "$(quoted "$program" "${command[0]}") --merge $(printf %q "$folder")/[0-9]*.json $(quoted "$@")" > "$folder/job.txt" ||
  status=$?
cat "$folder/all.txt"
exit "$status"
