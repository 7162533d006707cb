#!/usr/bin/env bash
# Tests the package of Python: python_test.sh BUILD [OPTION OF PYTEST…]. First its reader with Python alone, then all of
# it with the built module. Skipped (77) where pytest is missing; without pybind11 there is the reader alone.
set -euo pipefail
build=$(cd "$1" && pwd)
shift
cd "$(dirname "$0")/python"
export CONTINUA_BUILD=$build PYTHONDONTWRITEBYTECODE=1 PYTHONUTF8=1
python=/usr/bin/python3
"$python" -c 'import pytest' 2> /dev/null || { echo "python_test.sh: skipped: no python3-pytest"; exit 77; }
PYTHONPATH=../../python "$python" -m pytest -q -p no:cacheprovider reader_test.py
if compgen -G "$build/python/continua/_engine*.so" > /dev/null; then
  PYTHONPATH=$build/python "$python" -m pytest -q -p no:cacheprovider "$@"
else
  echo "python_test.sh: the module is not built: no pybind11"
fi
