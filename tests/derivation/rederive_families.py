#!/usr/bin/env python3
"""Replays families (../family) without physics and derives their runs again (rederive.py).

  tests/derivation/rederive_families.py PROGRAM            a sample of every family
  tests/derivation/rederive_families.py PROGRAM --all      every member of every family
  tests/derivation/rederive_families.py PROGRAM NAME…      every member of these families

The sample is every ONE_OF-th member, in the order in which the families list them. It begins elsewhere with each change
of the dialogue's machine, so that every member has its turn; the same files give the same sample.
Ends with status 1 if there is a disagreement, such as an act to which no application leads.
"""
import hashlib
import pathlib
import sys
import tempfile

import rederive

FOLDER = pathlib.Path(__file__).resolve().parents[1]
MEMBERS = FOLDER / "family" / "members"
MACHINE = FOLDER.parent / "engine" / "knowledge" / "machines" / "interaction.json"
sys.path[:0] = [str(FOLDER / "family"), str(FOLDER / "exam")]
import hold_families  # noqa: E402  (found in the folder of the families)
import run_exam  # noqa: E402

# A sample takes less than a minute on one core.
ONE_OF = 8
# Most members end in an act; the others end in words. Fewer acts than this share mean that the members did not run.
LEAST_ACTS = 1 / 4


def sample_of(members, machine):
    begin = hashlib.sha256(machine).digest()[0] % ONE_OF
    return members[begin::ONE_OF]


def chosen(names):
    paths = [MEMBERS / (name + ".py") for name in names] or sorted(MEMBERS.glob("*.py"))
    return [each for path in paths for each in hold_families.members_of(path)]


def rederived(program, members):
    with tempfile.TemporaryDirectory() as folder:
        traces = [str(pathlib.Path(folder) / (each["id"] + ".trace.jsonl")) for each in members]
        for each, trace in zip(members, traces):
            run_exam.write_trace(each, trace)
        return rederive.check_files(program, traces)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    names = sys.argv[2:]
    members = chosen([] if names == ["--all"] else names)
    if not names:
        members = sample_of(members, MACHINE.read_bytes())
    tally = rederived(sys.argv[1], members)
    tally.report()
    print(f"members: {len(members)}")
    sys.exit(bool(tally.disagreements) or tally.counts["acts asked for"] < LEAST_ACTS * len(members))


if __name__ == "__main__":
    main()
