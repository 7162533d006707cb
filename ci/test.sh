#!/usr/bin/env bash
# Everything that must hold: format, floors, a build without warnings, all tests, a third of the engine's with sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."
ci/setup.sh --tests
cmake --preset release  # brings the packages, and with them the page's formatter
ci/format.sh
ci/floors.sh
ci/build.sh
# Two more at a time than there are processors: servers and browsers are waited for.
ctest --preset release --parallel "$((${CMAKE_BUILD_PARALLEL_LEVEL:-2} + 2))"
ci/same_bytes.sh
# Those of replay/ take most of the time, and are left to ci/sanitize.sh by itself.
engine=$(find tests -name '*_test.cpp' -printf '%P\n' | cut -d/ -f1 | sort -u | grep -vx replay | paste -sd '|')
ci/sanitize.sh turn/3 "^($engine)/"
ci/mujoco.sh
