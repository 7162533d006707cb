#!/usr/bin/env python3
"""Replays families (../family) without physics and derives their runs again (rederive.py).

  tests/derivation/rederive_families.py PROGRAM NAME…

Ends with status 1 if there is a disagreement, such as an act to which no application leads.
"""
import pathlib
import sys
import tempfile

import rederive

FOLDER = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(FOLDER / "family"), str(FOLDER / "exam")]
import hold_families  # noqa: E402  (found in the folder of the families)
import run_exam  # noqa: E402


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    members = [each for name in sys.argv[2:]
               for each in hold_families.members_of(FOLDER / "family" / "members" / (name + ".py"))]
    with tempfile.TemporaryDirectory() as folder:
        traces = [str(pathlib.Path(folder) / (each["id"] + ".trace.jsonl")) for each in members]
        for each, trace in zip(members, traces):
            run_exam.write_trace(each, trace)
        tally = rederive.check_files(sys.argv[1], traces)
    tally.report()
    sys.exit(bool(tally.disagreements) or tally.counts["acts asked for"] < len(members) // 4)


if __name__ == "__main__":
    main()
