#!/usr/bin/env bash
# Shares the commands that take many files among processes, by hand and over a Slurm cluster of two nodes on this machine;
# what is merged must be what one process tells. The program is the first argument. Skipped (77) in part without root or slurm-wlm.
set -euo pipefail
program=$1
root=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
cd "$folder"
stop() {
  [[ -f slurm.conf ]] && scontrol shutdown > stopped 2>&1
  # A daemon that is ending still writes its state there.
  for _ in {1..50}; do
    rm -rf "$folder" 2> /dev/null && break
    sleep 0.2
  done
}
trap stop EXIT
failed=0
complain() {
  echo "$1" >&2
  failed=1
}
same() { diff "$1" "$2" >&2 || complain "$3: not what one process tells"; }
# A check's last line tells how long it took.
timeless() { sed 's/; in [0-9.]* s$//'; }

traces=("$root"/traces/paper/*.trace.jsonl)
"$program" replay "${traces[@]}" --no-physics -o runs/ > whole.txt
"$program" check "$root/traces/paper" --no-physics | timeless > checked.txt
cat > grid.json << 'END'
{ "grid": { "surer_by": [0.1, 0.2, 0.3, 0.4, 0.5], "weights.not now": { "from": 0.1, "to": 1, "count": 4 } }, "seeds": [1, 2, 3] }
END
wizard=$root/traces/talk/wizard.trace.jsonl
sweep=(sweep grid.json "$wizard" --variant world)
scored=(score "${traces[@]:0:2}" "$wizard" --json)
"$program" "${scored[@]}" > scored.txt 2> said
"$program" coverage runs --json > covered.txt
"$program" table runs -o table | sed s/table/merged/ > told.txt

# share COUNT WHOLE COMMAND… -- OPTIONS…: does the command in so many shards; their merge, with the options, must tell WHOLE.
share() {
  local count=$1 whole=$2 index command=()
  shift 2
  while [[ $1 != -- ]]; do command+=("$1"); shift; done
  shift
  for ((index = 1; index <= count; ++index)); do
    "$program" "${command[@]}" --shard "$index/$count" --report "$index.json" > "$index.txt" 2> said || complain "${command[0]}, shard $index/$count"
  done
  "$program" "${command[0]}" --merge $(seq -f '%g.json' "$count") "$@" > merged.txt || complain "${command[0]} in $count shards: status $?"
  same "$whole" merged.txt "${command[0]} in $count shards"
  rm [0-9]*.json
}
for count in 1 2 7 ${CONTINUA_MANY_SHARDS:+64}; do  # 64 take minutes
  share "$count" whole.txt replay "${traces[@]}" --no-physics -o runs/ --
  share "$count" scored.txt "${scored[@]}" -- --json
  share "$count" covered.txt coverage runs -- --json
  share "$count" told.txt table runs -o merged -- -o merged
  rm -rf merged/shard-*
  diff -r table merged >&2 || complain "tables in $count shards"
done

# A sweep that is killed goes on where it was; all that it writes is as if it had not been.
"$program" "${sweep[@]}" -o swept > swept.txt
"$program" "${sweep[@]}" -o killed > killed.txt 2>&1 & killed=$!
until [[ $(find killed/points -name '*.json' 2> /dev/null | wc -l) -ge 3 ]]; do sleep 0.05; done
kill -9 "$killed" || complain 'the sweep was over before it could be killed'
wait "$killed" 2> said || true
"$program" "${sweep[@]}" -o killed > resumed.txt 2> said
grep -q 'of 60 points were there already' said || complain 'the killed sweep began anew'
same swept.txt resumed.txt 'a sweep that was killed'
same_files() { diff -r --exclude=index.html swept "$1" >&2 || complain "$2: other files"; }
same_files killed 'a sweep that was killed'

export CONTINUA=$program
if command -v parallel > /dev/null; then
  "$root"/examples/cluster/parallel.sh : "${scored[@]}" -- 2 --json > there.txt || complain "score by GNU parallel: status $?"
  same scored.txt there.txt 'score by GNU parallel'
fi
if command -v snakemake > /dev/null; then
  sweep_there() { snakemake -q -s "$root"/examples/cluster/Snakefile -j 2 --config grid=grid.json traces="$wizard" options='--variant world' shards=2 out=snake program="$program" "$@" > said 2>&1; }
  sweep_there -n || { cat said >&2; complain "a dry run of Snakemake: status $?"; }
  [[ ! -e snake ]] || complain 'a dry run of Snakemake swept'
  sweep_there || { cat said >&2; complain "a sweep by Snakemake: status $?"; }
  diff -r --exclude=index.html --exclude=reports swept snake >&2 || complain 'a sweep by Snakemake: other files'
fi

SLURM_ARRAY_TASK_ID=2 SLURM_ARRAY_TASK_COUNT=2 "$program" replay "${traces[@]}" --no-physics -o runs/ --shard auto --report 2.json > 2.txt
status=0
"$program" replay --merge 2.json > merged.txt 2> said || status=$?
[[ $status == 2 ]] && grep -q 'shard 1/2 is missing' said || { cat said >&2; complain "a missing shard: status $status"; }
status=0
"$program" replay --merge 2.json 2.json > merged.txt 2> said || status=$?
[[ $status == 2 ]] && grep -q 'is shard 2/2, and so is 2.json' said || { cat said >&2; complain "a doubled shard: status $status"; }
[[ $failed == 0 ]] || exit 1

for each in slurmctld slurmd munged; do
  command -v "$each" > /dev/null || { echo "skipped the cluster: no $each (slurm-wlm, munge)"; exit 77; }
done
[[ $(id -u) == 0 ]] || { echo "skipped the cluster: it is started as root"; exit 77; }

host=$(hostname -s)
cat > slurm.conf << END
ClusterName=continua
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=17000
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_interval=1
MpiDefault=none
ReturnToService=2
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool.%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.%n.log
SlurmdParameters=config_overrides
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=[17001-17002] CPUs=1 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$folder/slurm.conf
mkdir -p state
pgrep -x munged > /dev/null || { mkdir -p /run/munge && chown munge: /run/munge && su -s /bin/sh munge -c /usr/sbin/munged; }
slurmctld -f "$SLURM_CONF" 2> started
for node in n1 n2; do slurmd -f "$SLURM_CONF" -N "$node" 2>> started; done
for ((i = 0; i < 60; ++i)); do
  [[ $(sinfo -h -t idle -o %D 2> /dev/null | awk '{n += $1} END {print n + 0}') == 2 ]] && break
  sleep 0.5
done
[[ $i -lt 60 ]] || { cat slurmctld.log slurmd.*.log >&2; echo 'skipped the cluster: its nodes do not come up here'; exit 77; }

slurm() { "$root"/examples/cluster/slurm.sh "$@"; }
# A task that is killed cannot pass for one that is done.
cat > killed.sh << END
#!/usr/bin/env bash
if [[ "\$*" == *auto* && \$SLURM_ARRAY_TASK_ID == 2 ]]; then kill -9 \$\$; fi
exec "$program" "\$@"
END
chmod +x killed.sh

# All of them wait for the cluster at the same time.
slurm replay "${traces[@]}" --no-physics -o runs/ -- 3 > replayed.txt & replaying=$!
slurm check "$root/traces/paper" --no-physics -- 2 --junit all.xml > merged.txt & checking=$!
CONTINUA=$(realpath killed.sh) slurm replay "${traces[@]}" --no-physics -o runs/ -- 3 > killed.txt 2>&1 & killing=$!
slurm "${scored[@]}" -- 2 --json > scored_there.txt & scoring=$!
CONTINUA=$(realpath killed.sh) slurm "${sweep[@]}" -o there -- 3 -o there > killed_sweep.txt 2>&1 & sweeping=$!
wait "$replaying" || complain "replay over Slurm: status $?"
same whole.txt replayed.txt 'replay over Slurm'
wait "$checking" || complain "check over Slurm: status $?"
timeless < merged.txt > timeless.txt
same checked.txt timeless.txt 'check over Slurm'
grep -q "tests=\"$(($(wc -l < checked.txt) - 1))\"" all.xml || complain 'check over Slurm: its JUnit report'
wait "$scoring" || complain "score over Slurm: status $?"
same scored.txt scored_there.txt 'score over Slurm'
status=0
wait "$sweeping" || status=$?
[[ $status == 2 ]] && grep -q 'shard 2/3 is missing' killed_sweep.txt || { cat killed_sweep.txt >&2; complain "a killed task of a sweep: status $status"; }
slurm "${sweep[@]}" -o there -- 3 -o there > swept_there.txt || complain "the sweep over Slurm, again: status $?"
same swept.txt swept_there.txt 'a sweep over Slurm'
same_files there 'a sweep over Slurm'
[[ $(cat shards.*/3.txt | grep -c 'were there already') == 1 ]] || complain 'a sweep over Slurm: done points were done again'
status=0
wait "$killing" || status=$?
[[ $status == 2 ]] && grep -q 'shard 2/3 is missing' killed.txt || { cat killed.txt >&2; complain "a killed task: status $status"; }
exit "$failed"
