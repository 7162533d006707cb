#!/usr/bin/env python3
"""Packed traces and run logs through the program: every command tells of them as of plain ones, and refuses damaged ones
with the file's name and with what was expected.

packed_test.py PROGRAM SOURCE
"""
import gzip
import json
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import urllib.request

PATIENCE_S = 120
MEMORY = 2 << 30  # bytes, for what would fill it
TRACE = "traces/talk/speech_only.trace.jsonl"


class Commands:
    """The commands, in a folder with a trace `t.trace.jsonl` and its run `r.run.jsonl`, packed or not."""

    def __init__(self, program, folder, packed):
        self.program, self.folder, self.ending = program, folder, ".gz" if packed else ""
        folder.mkdir()

    def path(self, name):
        return self.folder / (name + self.ending)

    def run(self, *arguments, **more):
        """TRACE and RUN stand for the two files."""
        names = {"TRACE": "t.trace.jsonl" + self.ending, "RUN": "r.run.jsonl" + self.ending}
        arguments = (re.sub("TRACE|RUN", lambda found: names[found.group()], one) for one in map(str, arguments))
        return subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True, timeout=PATIENCE_S,
                              check=False, **more)

    def told(self, *arguments):
        """The status and the outputs, as they would be of plain files. Digests cover names, and some commands tell how long they took."""
        done = self.run(*arguments)
        aside = rb'(?<="digest":)"[0-9a-f]*"|\b[0-9.]+ s(?= ->|\n)'
        texts = (re.sub(aside, b"", text.replace(b".gz", b"")) for text in (done.stdout, done.stderr))
        return done.returncode, *texts


def reading_commands():
    yield from (("explain", "RUN"), ("explain", "RUN", "--act", "1", "--tree"), ("coverage", "RUN", "--json"),
                ("coverage", ".", "--json"), ("validate", "RUN"), ("validate", "."), ("diff", "RUN", "RUN", "--json"),
                ("replay", "TRACE", "--no-physics", "--choice", "run:RUN", "-o", "-"), ("diff", "TRACE", "TRACE"),
                ("validate", "TRACE"), ("coverage", "TRACE", "--json"), ("replay", "TRACE", "--no-physics", "-o", "-"),
                ("score", "TRACE", "--json"), ("check", "TRACE", "--no-physics"), ("check", ".", "--no-physics"),
                ("shrink", "TRACE", "--until", "state=Ask", "-o", "least.trace.jsonl", "--no-physics"))
    for form in ("json", "dot", "svg", "csv", "chrome", "jsonl"):
        yield "export", "RUN", "--to", form, "-o", "-"


def check_reading(plain, *others):
    for command in reading_commands():
        expected, *told = (commands.told(*command) for commands in (plain, *others))
        for one in told:
            if one != expected:
                yield f"{' '.join(command)}: {one}; expected {expected}"
    for commands in others:
        through_a_pipe = commands.run("replay", "/dev/stdin", "--no-physics", "-o", "-",
                                      input=commands.path("t.trace.jsonl").read_bytes())
        if through_a_pipe.stdout.count(b"\n") != plain.path("r.run.jsonl").read_bytes().count(b"\n"):
            yield f"a packed trace through a pipe: {through_a_pipe.stderr!r}"


def check_writing(plain, commands):
    text, packed = plain.path("r.run.jsonl").read_bytes(), commands.path("r.run.jsonl").read_bytes()
    if gzip.decompress(packed) != text:
        yield "a packed log is not the plain one"
    if packed[4:8] != bytes(4) or len(packed) * 4 > len(text):
        yield f"a packed log has {len(packed)} bytes of {len(text)}, and the time {packed[4:8]}"
    for name in ("a.csv", "a.csv.gz"):
        commands.run("export", "RUN", "--to", "csv", "-o", name)
    if gzip.decompress((commands.folder / "a.csv.gz").read_bytes()) != (commands.folder / "a.csv").read_bytes():
        yield "a packed table is not the plain one"
    commands.run("shrink", "TRACE", "--until", "state=Ask", "-o", "less.trace.jsonl.gz")
    done = commands.run("replay", "less.trace.jsonl.gz", "--no-physics", "--gzip")
    if done.returncode == 2 or not gzip.decompress((commands.folder / "less.run.jsonl.gz").read_bytes()):
        yield f"a trace that was shrunk and packed cannot be replayed: {done.stderr!r}"
    done = commands.run("record", "-o", "live.trace.jsonl.gz", "--no-physics", input=b"")
    if done.returncode != 2 or b"expected a name without .gz" not in done.stderr:
        yield f"record under a packed name: {done.returncode}, {done.stderr!r}"
    # An approved run that is packed stays packed.
    approved = commands.folder / "t.run.jsonl.gz"
    approved.write_bytes(packed)
    for arguments in (("--no-physics",), ("--no-physics", "--approve", "--yes")):
        done = commands.run("check", "TRACE", *arguments)
        if done.returncode != 0 or gzip.decompress(approved.read_bytes()) != text:
            yield f"check {' '.join(arguments)}: {done.stdout!r}, {done.stderr!r}"


def answers(commands):
    """Of the inspector, for each of its addresses."""
    with subprocess.Popen([commands.program, "serve", ".", "--port", "0"], cwd=commands.folder,
                          stdout=subprocess.PIPE) as server:
        try:
            address = re.search(rb"http://\S+", server.stdout.readline()).group().decode() + "api/runs"
            for view in ("/r", "/r/columns", "/r/explain?n=40", "/r/stack?n=40", "/r/records?from=3&limit=50", "/r/graph"):
                with urllib.request.urlopen(address + view, timeout=PATIENCE_S) as response:
                    yield view, response.read().replace(b".gz", b"")
        finally:
            server.terminate()


def check_serving(plain, *others):
    expected = dict(answers(plain))
    for commands in others:
        for view, answer in answers(commands):
            if answer != expected[view]:
                yield f"serve {view}: {answer[:500]}; expected {expected[view][:500]}"


def damaged(packed, whole):
    """Damages, and a word of the refusal of each."""
    yield "cut", packed[:len(packed) // 2], b"is cut short"
    yield "cut between blocks", packed[:-28], b"is cut short"
    yield "another byte", packed[:-60] + bytes([packed[-60] ^ 4]) + packed[-59:], b"is damaged"
    yield "more behind it", packed + b"more", b"is damaged"
    yield "cut, in one", whole[:len(whole) // 2], b"is cut short"
    yield "another byte, in one", whole[:-200] + bytes([whole[-200] ^ 4]) + whole[-199:], b"is damaged"
    yield "only a beginning", packed[:2], b"is cut short"
    yield "no gzip", b"\x1f\x8b" + b"none" * 100, b"is damaged"
    yield "a trap", gzip.compress(bytes(1 << 20)) * 3000, b"more than 200 times as long"


def check_damage(commands):
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    on_logs = (("explain",), ("validate",), ("export", "--to", "jsonl", "-o", "-"), ("render", "-o", "x.png"),
               ("diff", "RUN"), ("pack", "--gzip"))
    on_traces = (("replay", "--no-physics", "-o", "x.run.jsonl"), ("validate",), ("score",), ("pack", "--no-gzip"))
    for original, bad, tried in (("r.run.jsonl", "bad.run.jsonl.gz", on_logs),
                                 ("t.trace.jsonl", "bad.trace.jsonl.gz", on_traces)):
        packed = commands.path(original).read_bytes()
        for what, content, word in damaged(packed, gzip.compress(gzip.decompress(packed))):
            (commands.folder / bad).write_bytes(content)
            for command in tried:
                done = commands.run(*command, bad, preexec_fn=limit)
                if done.returncode != 2 or word not in done.stderr or bad.encode() not in done.stderr:
                    yield (f"{' '.join(command)} {bad}, {what}: {done.returncode}, {done.stderr!r}; "
                           f"expected {word!r}")


def main(program, source):
    program, trace = pathlib.Path(program).resolve(), (pathlib.Path(source) / TRACE).read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        plain, packed, in_one = (Commands(program, pathlib.Path(folder) / name, name != "plain")
                                 for name in ("plain", "packed", "in_one"))
        for commands in (plain, packed):
            (commands.folder / "t.trace.jsonl").write_bytes(trace)
        done = packed.run("pack", "--gzip", "t.trace.jsonl")
        assert done.returncode == 0, done.stderr
        for commands in (plain, packed):
            done = commands.run("replay", "TRACE", "--no-physics", "-o", "RUN")
            assert done.returncode == 0, done.stderr
        for name in ("t.trace.jsonl", "r.run.jsonl"):
            in_one.path(name).write_bytes(gzip.compress(plain.path(name).read_bytes()))
        faults = [*check_reading(plain, packed, in_one), *check_serving(plain, packed, in_one),
                  *check_writing(plain, packed), *check_damage(packed)]
    for fault in faults:
        print(fault[:2000], file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
