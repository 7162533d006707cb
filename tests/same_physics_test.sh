#!/usr/bin/env bash
# Replays one short trace with physics a hundred times, in several processes, one, two and four at a time, and wants the
# same bytes of all. same_physics_test.sh CONTINUA
set -euo pipefail
continua=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat > "$folder/trace" << 'TRACE'
{"kind":"trace","version":1,"scene":"staircase","machine":"interaction","seed":0,"perspective":"human"}
{"t":1,"kind":"speech","text":"Put the red block on the green block.","until":2}
{"t":5,"kind":"gesture","name":"point","hand":"right","phase":"stroke","target":[0.1,-0.05],"until":5.5}
{"t":6,"kind":"end"}
TRACE
traces=()
for i in {01..20}; do
  cp "$folder/trace" "$folder/$i.trace.jsonl"
  traces+=("$folder/$i.trace.jsonl")
done

# A run differs in the trace's name alone, which the header has, and with it in the digest of all lines.
for jobs in 1 2 4 4 2; do
  rm -rf "$folder/runs"
  "$continua" replay "${traces[@]}" -j "$jobs" -o "$folder/runs" > /dev/null
  for run in "$folder"/runs/*.run.jsonl; do
    sed -e '1s/"name":"[0-9]*\.trace\.jsonl"//' -e '$s/"digest":"[^"]*"//' "$run" | cksum
  done
done > "$folder/sums"
grep -q '"kind":"pose"' "$folder/runs/01.run.jsonl" || { echo "nothing has moved" >&2; exit 1; }
if [[ $(wc -l < "$folder/sums") != 100 || $(sort -u "$folder/sums" | wc -l) != 1 ]]; then
  echo "100 runs of one trace are not the same:" >&2
  sort "$folder/sums" | uniq -c >&2
  exit 1
fi
