#!/usr/bin/env bash
# Builds, replays a recorded interaction and serves it in the inspector; --no-serve stops after the replay.
set -euo pipefail
cd "$(dirname "$0")/.."
trace=traces/building_blocks.trace.jsonl

serve=true
for argument in "$@"; do
  case "$argument" in
    --no-serve) serve=false ;;
    *)
      echo "ci/demo.sh: found '$argument'; expected --no-serve or nothing" >&2
      exit 2
      ;;
  esac
done

ci/setup.sh
ci/build.sh continua
runs=build/demo
mkdir -p "$runs"
run="$runs/$(basename "$trace" .trace.jsonl).run.jsonl"
build/continua replay "$trace" -o "$run"
if [[ "$serve" == true ]]; then exec build/continua serve "$runs"; fi
