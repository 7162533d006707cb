#!/usr/bin/env bash
# Builds with the MuJoCo that is installed in the folder CONTINUA_MUJOCO, and runs all tests; skipped without it.
#   CONTINUA_MUJOCO=/path/to/mujoco ci/mujoco.sh
set -euo pipefail
cd "$(dirname "$0")/.."
if [[ -z ${CONTINUA_MUJOCO:-} ]]; then
  echo "ci/mujoco.sh: skipped another MuJoCo: CONTINUA_MUJOCO names none"
  exit 0
fi
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-2}
cmake --preset release -B build/mujoco -DCMAKE_PREFIX_PATH="$CONTINUA_MUJOCO"
cmake --build build/mujoco
build/mujoco/continua --version
# The pages show what Debian's MuJoCo does, and the package depends on it.
ctest --test-dir build/mujoco --output-on-failure --parallel "$CMAKE_BUILD_PARALLEL_LEVEL" --exclude-regex '^(readme|deb)$'
