#!/usr/bin/env bash
# Everything that must hold: format, floors, a build without warnings, all tests; with sanitizers a third
# of those in C++, and mutations of every input.
set -euo pipefail
cd "$(dirname "$0")/.."
ci/setup.sh --tests
cmake --preset release  # brings the packages, and with them the page's formatter
ci/format.sh
ci/floors.sh
ci/build.sh
# Two more at a time than there are processors: servers and browsers are waited for. Inputs are mutated under sanitizers.
ctest --preset release --exclude-regex '^fuzz$' --parallel "$((${CMAKE_BUILD_PARALLEL_LEVEL:-2} + 2))"
ci/same_bytes.sh
ci/sanitize.sh turn/3
ci/mujoco.sh
