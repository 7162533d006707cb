#!/usr/bin/env python3
"""Replays all shipped traces without physics and derives their runs again (rederive.py).

  tests/derivation/rederive_traces.py PROGRAM [FOLDER]     FOLDER: traces, if not those of the repository

Ends with status 1 if there is a disagreement, if a trace gave no run, or if a raising rule is used by none of the
repository's traces.
"""
import json
import pathlib
import sys

import rederive

TRACES = pathlib.Path(__file__).parents[2] / "traces"


def unused_rules(tally):
    rules = json.loads(rederive.RAISING.read_text(encoding="utf-8"))["rules"]
    return [each["name"] for each in rules if not tally.counts[f"raised by {each['name']}"]]


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else TRACES
    traces = sorted(map(str, folder.rglob("*.trace.jsonl")))
    tally = rederive.check_files(sys.argv[1], traces)
    tally.report()
    print(f"traces: {len(traces)}")
    unused = [] if len(sys.argv) == 3 else unused_rules(tally)
    for rule in unused:
        print(f"no trace raises anything by the rule '{rule}'")
    sys.exit(bool(tally.disagreements or unused) or not traces)


if __name__ == "__main__":
    main()
