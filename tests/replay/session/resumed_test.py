#!/usr/bin/env python3
"""A run that is taken up again at an instant of it (replay --from) is the whole run, from there on and before, in both
worlds.

resumed_test.py PROGRAM SOURCE
"""
import json
import pathlib
import subprocess
import sys
import tempfile

TRACES = ("talk/speech_only",)
PARTS = (0.3, 0.7)  # of the run's length


def records(run):
    return [json.loads(line) for line in run.read_text(encoding="utf-8").splitlines()]


def told(run):
    """Records without their numbers and what the log says of itself."""
    for record in records(run):
        if record["kind"] not in ("run", "block", "end"):
            yield record


def replay(program, trace, run, *options):
    done = subprocess.run([program, "replay", trace, "-o", run, *options], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise AssertionError(f"replay {trace.name} {' '.join(options)}: {done.returncode}, {done.stderr}")


def main(program, source):
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        for name in TRACES:
            trace = pathlib.Path(source, "traces", name + ".trace.jsonl")
            for world in ([], ["--no-physics"]):
                whole, part = pathlib.Path(folder, "whole.run.jsonl"), pathlib.Path(folder, "part.run.jsonl")
                replay(program, trace, whole, *world)
                end = records(whole)[-1]
                for share in PARTS:
                    replay(program, trace, part, *world, "--from", str(round(end["t"] * share, 3)))
                    again = records(part)[-1]
                    same = [end.get(member) == again.get(member) for member in ("decisions", "physics")]
                    if not all(same) or list(told(whole)) != list(told(part)):
                        failed = True
                        print(f"{name} {' '.join(world)} from {share}: the run is not the whole one, digests {same}",
                              file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
