#!/usr/bin/env bash
# Configures and builds into build/, with warnings as errors. Arguments are targets; without any, everything.
set -euo pipefail
cd "$(dirname "$0")/.."
# Two compilers at once stay below 4 GB of memory.
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-2}
targets=()
if [[ $# -gt 0 ]]; then targets=(--target "$@"); fi
cmake --preset release
cmake --build --preset release "${targets[@]}"
