#!/usr/bin/env python3
"""Replays all shipped traces without physics and derives their runs again (rederive.py).

  tests/derivation/rederive_traces.py PROGRAM [FOLDER]     FOLDER: traces, if not those of the repository

Ends with status 1 if there is a disagreement, or if a trace gave no run.
"""
import pathlib
import sys

import rederive

TRACES = pathlib.Path(__file__).parents[2] / "traces"


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else TRACES
    traces = sorted(map(str, folder.rglob("*.trace.jsonl")))
    tally = rederive.check_files(sys.argv[1], traces)
    tally.report()
    print(f"traces: {len(traces)}")
    sys.exit(bool(tally.disagreements) or not traces)


if __name__ == "__main__":
    main()
