#!/usr/bin/env python3
"""Commands where something cannot be written: full disks, streams that take nothing, outputs that are inputs. None
hangs, none says that all is well, and no file that was there is lost.

writing_test.py PROGRAM SOURCE
"""
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

PATIENCE_S = 60
ROOM = 50_000  # bytes of a file, for a disk that is nearly full
ROOM_FOR_SOME = 1_000_000


def no_room(most=ROOM):
    """In place of a full disk: a file takes so many bytes and no more."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))


class Commands:
    def __init__(self, program, source, folder):
        self.program, self.source, self.folder = program, source, folder
        self.trace = folder / "talk.trace.jsonl"
        shutil.copy(source / "traces/talk/speech_only.trace.jsonl", self.trace)

    def run(self, *arguments, **more):
        return subprocess.run([self.program, *map(str, arguments)], cwd=self.folder, capture_output="stdout" not in more
                              and "stderr" not in more, timeout=PATIENCE_S, check=False, **more)

    def at(self, name):
        return self.folder / name


def check_full_disk_while_recording(commands):
    """The session ends, and so does the command; what was acknowledged is in the trace, in whole lines."""
    events = b"".join(json.dumps({"t": t, "kind": "speech", "text": "The plate."}).encode() + b"\n" for t in range(400))
    trace = commands.at("full.trace.jsonl")
    try:
        done = commands.run("record", "-o", trace, "--no-physics", input=events,
                            preexec_fn=lambda: no_room(ROOM_FOR_SOME))
    except subprocess.TimeoutExpired:
        yield "record on a full disk does not end"
        return
    if done.returncode != 2 or b"cannot be written any further" not in done.stderr:
        yield f"record on a full disk: {done.returncode}, {done.stderr[-200:]!r}"
    for path in (trace, commands.at("full.run.jsonl")):
        if not path.read_bytes().endswith(b"\n"):
            yield f"{path.name} ends in the midst of a line, or is empty"
    if commands.run("validate", trace).returncode != 0:
        yield "the trace of a session that broke off cannot be read"


def check_silent_stderr(commands):
    """A message that cannot be written changes nothing else."""
    for arguments in (["explain", "nofile"], ["replay", "nofile"], ["validate", "nofile"], ["serve", "nofile"],
                      ["machine", "nothing"], ["no-command"]):
        with open("/dev/full", "wb") as full:
            done = commands.run(*arguments, stderr=full, stdout=subprocess.DEVNULL)
        if done.returncode != 2:
            yield f"{arguments} with a full stderr: {done.returncode}"
        done = commands.run(*arguments, stdout=subprocess.DEVNULL, stderr=None, preexec_fn=lambda: os.close(2))
        if done.returncode != 2:
            yield f"{arguments} with a closed stderr: {done.returncode}"
    lines = (b'{"t":1,"kind":"speech","text":"The plate."}\n{"t":2,"kind":"nonsense"}\n'
             b'{"t":3,"kind":"speech","text":"The cup."}\n')
    with open("/dev/full", "wb") as full:
        done = commands.run("record", "-o", "told.trace.jsonl", "--no-physics", input=lines, stderr=full,
                            stdout=subprocess.DEVNULL)
    if done.returncode != 1 or b"The cup." not in commands.at("told.trace.jsonl").read_bytes():
        yield f"record with a full stderr: {done.returncode}, or events after a refused one are lost"


def check_full_stdout(commands):
    commands.run("replay", commands.trace, "--no-physics", "-o", "talk.run.jsonl")
    for arguments in (["replay", commands.trace, "--no-physics", "-o", "-"], ["validate", commands.trace],
                      ["explain", "talk.run.jsonl"], ["machine", "interaction"], ["--version"],
                      ["diff", "talk.run.jsonl", "talk.run.jsonl"], ["export", "talk.run.jsonl", "--to", "csv"],
                      ["check", commands.source / "engine/knowledge/gestures"]):
        with open("/dev/full", "wb") as full:
            done = commands.run(*arguments, stdout=full, stderr=subprocess.DEVNULL)
        if done.returncode != 2:
            yield f"{arguments} with a full stdout: {done.returncode}"


def check_old_file_is_kept(commands):
    """A run that cannot be written to its end, or whose writer is killed, leaves the one that was there."""
    run = commands.at("old.run.jsonl")
    run.write_text("old\n")
    done = commands.run("replay", commands.trace, "--no-physics", "-o", run, preexec_fn=no_room)
    if done.returncode != 2 or run.read_text() != "old\n":
        yield f"replay on a full disk: {done.returncode}, and the earlier run is lost"
    for sign in (signal.SIGKILL, signal.SIGINT):
        process = subprocess.Popen([commands.program, "replay", commands.source / "traces/talk/repairs.trace.jsonl",
                                    "-o", run], cwd=commands.folder)
        time.sleep(0.5)  # of some five seconds
        process.send_signal(sign)
        if process.wait(PATIENCE_S) == 0:
            yield f"replay was to be ended by {sign.name}, and had ended by itself"
        elif run.read_text() != "old\n":
            yield f"replay ended by {sign.name}: the earlier run is lost"
    commands.run("replay", commands.trace, "--no-physics", "-o", "talk.run.jsonl")
    html = commands.at("old.html")
    html.write_text("old\n")
    done = commands.run("export", "talk.run.jsonl", "--to", "html", "-o", html, preexec_fn=no_room)
    if done.returncode != 2 or html.read_text() != "old\n":
        yield f"export on a full disk: {done.returncode}, and the earlier file is lost"
    approved = commands.at("talk.kinematic.run.json")
    approved.write_text("{}\n")
    arguments = ["check", commands.trace, "--no-physics", "--approve", "--yes", "--failures", commands.at("failures")]
    commands.run(*arguments, preexec_fn=no_room)
    if not approved.exists() or not approved.read_bytes():
        yield "an approval on a full disk: the approved run is lost"
    left = [path.name for path in commands.folder.rglob("*") if path.name.endswith((".part", ".new"))]
    if left:
        yield f"left over: {left}"


def check_output_is_no_input(commands):
    commands.run("replay", commands.trace, "--no-physics", "-o", "talk.run.jsonl")
    machine, scene = commands.at("m.json"), commands.at("s.xml")
    shutil.copy(commands.source / "engine/knowledge/machines/diana2018.json", machine)
    shutil.copytree(commands.source / "mjcf", commands.at("mjcf"))
    scene = commands.at("mjcf/scenes/staircase.xml")
    os.link(machine, commands.at("other.json"))
    for arguments, file in [
            (["export", "talk.run.jsonl", "--to", "json", "-o", "talk.run.jsonl"], commands.at("talk.run.jsonl")),
            (["machine", machine, "--svg", "-o", machine], machine),
            (["machine", machine, "--dot", "-o", "other.json"], machine),
            (["replay", commands.trace, "--machine", machine, "-o", machine, "--no-physics"], machine),
            (["replay", commands.trace, "--scene", scene, "-o", scene, "--no-physics"], scene),
            (["replay", commands.trace, "-o", commands.trace, "--no-physics"], commands.trace),
            (["check", "--junit", commands.trace, commands.trace, "--no-physics"], commands.trace),
            (["check", "--report", commands.trace, commands.trace, "--no-physics"], commands.trace),
            (["shrink", commands.trace, "--until", "says:x", "-o", commands.trace], commands.trace),
            (["render", "talk.run.jsonl", "-o", "talk.run.jsonl"], commands.at("talk.run.jsonl"))]:
        before = file.read_bytes()
        done = commands.run(*arguments)
        if done.returncode != 2 or file.read_bytes() != before:
            yield f"{' '.join(map(str, arguments))}: {done.returncode}, or the input is gone"
            file.write_bytes(before)


def check_links_beside(commands):
    """Names beside an output are the user's: nothing is written there or removed."""
    commands.run("replay", commands.trace, "--no-physics", "-o", "talk.run.jsonl")
    victim, part = commands.at("victim"), commands.at("talk.json.part")
    victim.write_text("mine\n")
    part.symlink_to(victim)
    commands.run("export", "talk.run.jsonl", "--to", "json", "-o", "talk.json")
    if victim.read_text() != "mine\n" or not part.is_symlink():
        yield "export wrote to, or removed, a file beside its output"


CHECKS = (check_full_disk_while_recording, check_silent_stderr, check_full_stdout, check_old_file_is_kept,
          check_output_is_no_input, check_links_beside)


def main(program, source):
    failed = False
    for check in CHECKS:
        with tempfile.TemporaryDirectory() as folder:
            try:
                problems = list(check(Commands(pathlib.Path(program).resolve(), pathlib.Path(source).resolve(),
                                               pathlib.Path(folder))))
            except (OSError, subprocess.SubprocessError) as error:
                problems = [repr(error)]
        for problem in problems:
            failed = True
            print(f"{check.__name__}: {problem}", file=sys.stderr, flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
