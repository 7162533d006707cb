#!/usr/bin/env bash
# Approves the example runs anew in both worlds, also those whose decisions are the same but whose ingredients (lexicon,
# machine, phrases, …) have changed: what-if replays them and warns of ingredients that differ. Read the diff afterwards.
set -euo pipefail
cd "$(dirname "$0")/.."
program=${1:-build/continua}
"$program" check traces --no-physics --strict --approve --yes
mapfile -t traces < <(find traces -name '*.physics.run.json*' | sed -E 's/\.physics\.run\.jsonl?$/.trace.jsonl/' | sort)
"$program" check "${traces[@]}" --physics --strict --approve --yes
"$program" check traces --physics
