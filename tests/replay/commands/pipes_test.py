#!/usr/bin/env python3
"""Commands that read standard input under the name "-", one behind another as in a shell, and what a terminal sees.

pipes_test.py PROGRAM SOURCE
"""
import json
import os
import pathlib
import pty
import subprocess
import sys
import tempfile

PATIENCE_S = 60


def main(program, source):
    trace = pathlib.Path(source) / "traces/talk/speech_only.trace.jsonl"

    def run(*arguments, given=b""):
        return subprocess.run([program, *map(str, arguments)], input=given, capture_output=True, timeout=PATIENCE_S,
                              check=False)

    def out(*arguments, given=b""):
        done = run(*arguments, given=given)
        assert done.returncode in (0, 1), (arguments, done.returncode, done.stderr)
        return done.stdout

    cut = out("trace", "cut", "--to", "1000", "-", "-o", "-", given=trace.read_bytes())
    log = out("replay", "--no-physics", "-", "-o", "-", given=cut)
    with tempfile.TemporaryDirectory() as folder:
        kept = pathlib.Path(folder) / "stdin.run.jsonl"
        kept.write_bytes(log)
        for command in (["explain"], ["export", "--to", "csv", "-o", "-"], ["coverage"]):
            assert out(*command, "-", given=log) == out(*command, kept), command
        assert b"The runs are the same." in out("diff", kept, "-", given=log)
        assert b"run log" in out("validate", "-", given=log)

        unmet = pathlib.Path(folder) / "unmet.trace.jsonl"
        *lines, end = trace.read_bytes().splitlines(keepends=True)
        t = json.loads(end)["t"]
        unmet.write_bytes(b"".join([*lines, b'{"t":%f,"kind":"expect","state":"Nowhere"}\n' % t, end]))
        line = len(lines) + 1
        told = run("replay", "--no-physics", unmet, "-o", pathlib.Path(folder) / "unmet.run.jsonl")
        assert told.returncode == 1, told
        assert f'unmet.trace.jsonl:{line}: expected {{"state":"Nowhere"}}, found {{"state":'.encode() in told.stderr, told

        coloured = at_a_terminal([program, "check", "--no-physics", str(trace)], {})
        assert b"\033[32mok\033[0m" in coloured, coloured
        plain = at_a_terminal([program, "check", "--no-physics", str(trace)], {"NO_COLOR": "1"})
        assert b"ok " in plain and b"\033[32m" not in plain, plain
        assert b"\033" not in out("check", "--no-physics", trace)

    twice = run("diff", "-", "-", given=log)
    assert twice.returncode == 2 and b"can be read once" in twice.stderr, twice


def at_a_terminal(arguments, more):
    ours, theirs = pty.openpty()
    environment = {name: value for name, value in os.environ.items() if name != "NO_COLOR"} | more
    child = subprocess.Popen(arguments, stdout=theirs, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL,
                             env=environment)
    os.close(theirs)
    seen = b""
    try:
        while piece := os.read(ours, 65536):
            seen += piece
    except OSError:  # the child is gone
        pass
    os.close(ours)
    child.wait(PATIENCE_S)
    return seen


if __name__ == "__main__":
    main(*sys.argv[1:])
