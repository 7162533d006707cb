#!/usr/bin/env python3
"""Each command that writes, while its Nth call to the file system fails: no space, an error of the disk, a short write,
a signal, a kill. For every N, each file is afterwards as it was, or as it is to be; a part has a name that says so; and
no command says that all is well where something was not written.

faults_test.py PROGRAM FAILING_FILES SOURCE [--all] [COMMAND…]

FAILING_FILES is tests/support/failing_files.cpp as a library. With --all every N fails in every way; without it a few
do for each command, the first call and the last among them.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.dom.minidom

PATIENCE_S = 300  # of an export with pictures, on a busy machine
AT_ONCE = 2
WAYS = ("nospace", "kill", "io", "short", "interrupt")
FEW = 3  # faults of each command
SLOW = ("html", "site", "new", "shrink")  # and one of each of these
FRESH = ("new", "pack gzip")  # whose outputs must not be there before
GOES_ON = ("short", "interrupt")  # a program may get over these, and then all is well

# The folder's files for each command: NAME is written by the command, and there before it. The words {run}, {trace} and
# {source} of a command are a run, its trace and the sources.
COMMANDS = {
    "replay": "replay {trace} --no-physics -o out.run.jsonl",
    "replay packed": "replay {trace} --no-physics -o out.run.jsonl.gz",
    "json": "export {run} --to json -o out.json",
    "csv": "export {run} --to csv -o out.csv",
    "html": "export {run} --to html -o out.html",
    "mcap": "export {run} --to mcap -o out.mcap",
    "eaf": "export {run} --to eaf -o out.eaf",
    "site": "export {run} --to site -o site",
    "table": "table {run} --kind transition --kind utterance -o tables",
    "pack": "pack {run}",
    "pack gzip": "pack {trace} --gzip",
    "machine": "machine interaction --dot -o out.dot",
    "import": "import {source}/examples/corpus/table_01.eaf -o out.trace.jsonl",
    "trace": "trace cut {trace} --from 0 --to 3 -o out.trace.jsonl",
    "approve": "check {trace} --no-physics --approve --yes",
    "reports": "check {trace} --no-physics --report out.report.json --junit out.xml --failures check-failures",
    "shrink": "shrink {trace} --until state=Choose -o out.trace.jsonl",
    "picture": "render {run} --at 1 --size 64x48 -o out.png",
    "new": "new project --scene staircase",
}


# How long a check took is in its reports.
TIMES = re.compile(rb'("seconds": ?|time=")[0-9.e-]+')


def contents(folder):
    return {str(path.relative_to(folder)): TIMES.sub(rb"\g<1>0", path.read_bytes())
            for path in sorted(folder.rglob("*")) if path.is_file()}


def tells_of_it(name, content):
    """A whole report of a check that has among its failures what could not be written."""
    if b"cannot be written" not in content:
        return False
    (json.loads if name.endswith(".json") else xml.dom.minidom.parseString)(content)
    return True


def is_part(name):
    return name.endswith(".part")


class Case:
    """A command in folders of its own, each with the same files."""

    def __init__(self, program, library, source, base, name):
        self.program, self.library, self.source, self.name = program, library, source, name
        self.words = COMMANDS[name].format(run="talk.run.jsonl", trace="talk.trace.jsonl", source=source).split()
        self.base = base
        self.old = {}

    def run(self, plan):
        """Status, and the files afterwards."""
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place) / "w"
            shutil.copytree(self.base, folder)
            for name, content in self.old.items():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (folder / name).write_bytes(content)
            count = pathlib.Path(place) / "count"
            done = subprocess.run([self.program, *self.words], cwd=folder, capture_output=True, timeout=PATIENCE_S,
                                  check=False, stdin=subprocess.DEVNULL,
                                  env={**os.environ, "LD_PRELOAD": self.library, "TMPDIR": place,
                                       "CONTINUA_FAIL": plan or f"0:{count}"})
            calls = int(count.read_text()) if count.exists() else 0
            return done, contents(folder), calls

    def prepare(self):
        """The files after a run without faults, and the number of calls. Whatever it wrote is there before, with
        another content, in all further runs."""
        before = contents(self.base)
        _, after, _ = self.run("")
        if self.name not in FRESH:
            self.old = {name: (before[name] if name in before else b"old\n") for name, content in after.items()
                        if before.get(name) != content}
        done, self.new, calls = self.run("")
        self.old = before | self.old
        return done, calls

    def faults(self, plan):
        try:
            done, after, _ = self.run(plan)
        except subprocess.TimeoutExpired:
            yield f"{plan}: does not end in {PATIENCE_S} s"
            return
        way = plan.partition(":")[2]
        for name, content in after.items():
            if content not in (self.old.get(name), self.new.get(name)) and not is_part(name) and not (
                    done.returncode == 2 and tells_of_it(name, content)):
                yield f"{plan}: {name} is neither the old file nor the new one ({len(content)} bytes)"
        for name in self.old:
            # pack removes documents that no log needs, as where their log was not packed.
            if name not in after and name in self.new and not name.startswith("documents/"):
                yield f"{plan}: {name} is gone"
        if way != "kill" and any(is_part(name) for name in after):
            yield f"{plan}: a part is left"
        if way == "kill":
            return
        unwritten = [name for name, content in self.new.items() if after.get(name) != content]
        if unwritten and done.returncode != 2:
            yield f"{plan}: status {done.returncode}, but not written: {unwritten[:3]}"
        if not unwritten and done.returncode == 2 and way in GOES_ON and not done.stderr:
            yield f"{plan}: status 2 without a word"


def plans(name, calls, everything):
    if everything:
        return [f"{number}:{way}" for number in range(1, calls + 1) for way in WAYS]
    numbers = sorted({1 + (calls - 1) * part // (FEW - 1) for part in range(FEW)})
    if name in SLOW:
        numbers = numbers[1:2]
    return [f"{number}:{WAYS[(number + place) % len(WAYS)]}" for place, number in enumerate(numbers)]


def check(case, everything):
    done, calls = case.prepare()
    if done.returncode not in (0, 1) or calls == 0:
        yield f"without faults: status {done.returncode}, {calls} calls, {done.stderr[-200:]!r}"
        return
    chosen = plans(case.name, calls, everything)
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as side_by_side:
        for problems in side_by_side.map(lambda plan: list(case.faults(plan)), chosen):
            yield from problems
    print(f"{case.name}: {calls} calls, {len(chosen)} faults", flush=True)


def main(program, library, source, *more):
    program, library, source = (str(pathlib.Path(path).resolve()) for path in (program, library, source))
    names = [name for name in more if name != "--all"] or COMMANDS
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        base = pathlib.Path(folder)
        shutil.copy(pathlib.Path(source, "traces/talk/speech_only.trace.jsonl"), base / "talk.trace.jsonl")
        # A run of another trace, so that an approval changes it.
        subprocess.run([program, "replay", pathlib.Path(source, "traces/talk/corrections.trace.jsonl"), "--no-physics", "-o", "talk.run.jsonl"], cwd=base,
                       check=True, stdout=subprocess.DEVNULL)
        for name in names:
            for problem in check(Case(program, library, source, base, name), "--all" in more):
                failed = True
                print(f"{name}: {problem}", file=sys.stderr, flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
