#!/usr/bin/env python3
"""Replays the family of the worked examples 1 to 4 (ways.py): each member must end in its act.

ways_test.py PROGRAM SOURCE_FOLDER
"""
import pathlib
import subprocess
import sys
import tempfile


def main(program, source):
    with tempfile.TemporaryDirectory() as folder:
        traces, runs = pathlib.Path(folder, "traces"), pathlib.Path(folder, "runs")
        subprocess.run([sys.executable, pathlib.Path(source, "tests/family/ways.py"), traces], check=True)
        members = sorted(traces.iterdir())
        replay = subprocess.run([program, "replay", *members, "--no-physics", "-j", "2", "-o", runs],
                                check=False, stdout=subprocess.PIPE, text=True)
        failed = [line for line in replay.stdout.splitlines() if "1 of 1 expectations met" not in line]
        print(*failed, sep="\n", file=sys.stderr)
        return 1 if failed or replay.returncode or len(members) < 40 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
