#!/usr/bin/env python3
"""Inputs that are not to be believed, given to the program: scenes, machines, logs and reports that ask for all time or
memory, say a thing twice, or are not what they seem. Each is answered soon, in words and with the right status.

belief_test.py PROGRAM SOURCE [CHECK…]
"""
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "live"))
from live_server import Server  # noqa: E402

SOON_S = 30         # of a processor's time
PATIENCE_S = 300    # of the clock: other programs run meanwhile
MOST_MEMORY = 2 << 30
HEADER = {"kind": "trace", "version": 1, "scene": "place_setting", "machine": "interaction"}
SPEECH = {"t": 1, "kind": "speech", "text": "The plate."}


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SOON_S, SOON_S))


class Commands:
    def __init__(self, program, source, folder):
        self.program, self.source, self.folder = program, source, folder

    def run(self, *arguments, **more):
        return subprocess.run([self.program, *map(os.fsencode, map(str, arguments))], cwd=self.folder,
                              capture_output=True, timeout=PATIENCE_S, check=False, preexec_fn=limited, **more)

    def write(self, name, *lines):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("".join((line if isinstance(line, str) else json.dumps(line)) + "\n" for line in lines))
        return path

    def told(self, status, words, *arguments):
        """A problem unless the command ends soon with that status and says the words."""
        done = self.run(*arguments)
        said = (done.stdout + done.stderr).decode(errors="replace")
        if done.returncode == status and words in said:
            return []
        return [f"{arguments}: {done.returncode} instead of {status}, {said[-300:]!r}; expected {words!r}"]


def check_time_steps(commands):
    """A scene's time step, its inclusions and sizes."""
    scene = (commands.source / "mjcf/scenes/staircase.xml").read_text().replace("../", f"{commands.source}/mjcf/")
    trace = commands.write("t.trace.jsonl", HEADER | {"scene": "s.xml"}, SPEECH)
    for step in ("0", "-1", "nan", "inf", "1e-6", "1e-12"):
        commands.write("s.xml", scene.replace('timestep="0.002"', f'timestep="{step}"'))
        yield from commands.told(1, "time step", "validate", "s.xml")
        yield from commands.told(2, "time step", "replay", trace, "-o", "-")
    commands.write("i0.xml", "<mujoco>", "</mujoco>")
    for depth in range(1, 40):
        commands.write(f"i{depth}.xml", "<mujoco>", *[f'<include file="i{depth - 1}.xml"/>'] * 2, "</mujoco>")
    yield from commands.told(1, "expected at most 1000", "validate", "i39.xml")
    for size in ('nkey="1000000"', 'nuser_body="100000000"'):
        commands.write("size.xml", "<mujoco>", f"<size {size}/>", "</mujoco>")
        yield from commands.told(1, "expected at most", "validate", "size.xml")


def check_what_if_of_strangers(commands):
    """A run log from elsewhere brings its scene along; a replay of it must not stop the server."""
    trace = commands.write("t.trace.jsonl", HEADER, SPEECH)
    done = commands.run("replay", trace, "-o", "t.run.jsonl")
    log = commands.folder / "t.run.jsonl"
    text = log.read_text()
    if done.returncode or 'timestep=\\"0.002\\"' not in text:
        yield f"the run does not carry its scene: {done}"
        return
    log.write_text(text.replace('timestep=\\"0.002\\"', 'timestep=\\"-1\\"'))
    with Server(commands.program, commands.folder) as server:
        client = server.client()
        run = client.get("/api/runs").must()["runs"][0]["id"]
        for _ in range(3):
            begun = time.monotonic()
            answer = client.post("/api/what-if", {"run": run})
            if answer.status == 200 or b"time step" not in answer.body or time.monotonic() - begun > SOON_S:
                yield f"a what-if of a scene without time: {answer.status}, {answer.body[:200]!r}"
        if (took := server.stop()) > SOON_S:
            yield f"the server ended {took:.0f} s after SIGTERM"


def random_machine(states, transitions):
    draw, place = random.Random(7), lambda: f"s{draw.randrange(states)}"
    return {"machine": 1, "name": "many", "start": "s0", "slots": {"taken": "text*"}, "transitions": [
        {"id": f"t{n}", "from": place(), "on": draw.choice(["speech *", "gesture *", "pointing *"]), "to": place(),
         **draw.choice([{}, {"push": {"taken": "append(['x'], taken)"}}, {"pop": 1}])} for n in range(transitions)]}


def check_machines(commands):
    """A machine whose language takes hours to decide, and branches without number."""
    commands.write("many.json", random_machine(300, 3000))
    for allowed, arguments in (((0,), ("machine", "many.json")), ((0, 2), ("machine", "many.json", "--svg", "-o", "m.svg")),
                               ((1, 2), ("accept", "many.json", "a a a"))):
        done = commands.run(*arguments)
        if done.returncode not in allowed:
            yield f"{arguments}: {done.returncode}, {done.stderr[-200:]!r}"
    yield from commands.told(2, "100000", "replay", "--choice", "explore", "--branches", "1000000",
                             commands.write("x.trace.jsonl", HEADER, SPEECH))
    endless = {"machine": 1, "name": "endless", "start": "A", "slots": {"taken": "text*"}, "transitions": [
        {"id": "in", "from": "A", "on": "speech *", "to": "B"},
        *({"id": name, "from": "B", "to": "B", "push": {"taken": f"append(['{name}'], taken)"}} for name in "xy")]}
    commands.write("endless.json", endless)
    trace = commands.write("e.trace.jsonl", HEADER | {"machine": "endless.json"}, SPEECH)
    done = commands.run("replay", "--no-physics", "--choice", "explore", "--branches", "100000", trace, "-o", "-")
    if done.returncode < 0 or b"bad_alloc" in done.stderr:
        yield f"branches that push without end: {done.returncode}, {done.stderr[-200:]!r}"


def check_reports(commands):
    """A report of a check that says one thing in its verdict and another in its status."""
    commands.write("ok.trace.jsonl", HEADER, SPEECH)
    commands.run("check", "ok.trace.jsonl", "--no-physics", "--report", "r.json", "--failures", "")
    report = json.loads((commands.folder / "r.json").read_text())
    for change in ({"status": 256}, {"status": -1}, {"status": 3}, {"verdict": "changed", "status": 0}):
        commands.write("changed.json", report | {"cases": [report["cases"][0] | change]})
        yield from commands.told(2, "status", "check", "--merge", "changed.json")


def check_empty_folders(commands):
    """A wrong path must not pass."""
    (commands.folder / "empty").mkdir()
    for command in ("validate", "check", "coverage"):
        yield from commands.told(2, "empty", command, "empty")


def check_keys_twice(commands):
    """The same key twice in one object says two things, whatever the file."""
    base = commands.source / "engine/knowledge"
    trace = commands.write("k.trace.jsonl", HEADER, '{"t":1,"kind":"speech","text":"No.","text":"Yes."}')
    yield from commands.told(1, "text", "validate", trace)
    yield from commands.told(2, "k.trace.jsonl:2", "replay", trace, "--no-physics", "-o", "-")
    header = commands.write("h.trace.jsonl", json.dumps(HEADER)[:-1] + ',"machine":"diana2018"}', SPEECH)
    yield from commands.told(1, "machine", "validate", header)
    commands.write("n.trace.jsonl", HEADER, SPEECH)
    commands.run("replay", "n.trace.jsonl", "--no-physics", "-o", "n.run.jsonl")
    notes = commands.write("n.notes.json", '{"notes":[{"id":"a","n":0,"to":null,"text":"x","text":"y"}]}')
    yield from commands.told(1, "a second time", "validate", notes)
    for path, key in ((base / "machines/diana2018.json", "name"), (next(base.glob("raising*.json"), None), None),
                      (base / "live.json", None), (next(base.glob("gestures/*.json"), None), None),
                      (next(base.glob("phrases/english.json"), None), None),
                      (next(base.glob("lexicon/**/*.json"), None), None),
                      (next(base.glob("voxemes/**/*.json"), None), None)):
        if path is None:
            continue
        text = path.read_text()
        key = key or next(iter(json.loads(text)))
        at = text.index("{") + 1
        copy = commands.folder / "knowledge" / path.relative_to(base)
        shutil.copytree(base, commands.folder / "knowledge", dirs_exist_ok=True)
        copy.write_text(text[:at] + f"{json.dumps(key)}:{json.dumps(json.loads(text)[key])}," + text[at:])
        done = commands.run("validate", copy)
        if done.returncode == 0 or b"a second time" not in done.stderr:
            yield f"{path.name} with a key twice: {done.returncode}, {done.stderr[-200:]!r}"


def check_terminals(commands):
    """Control characters of texts and names are shown, not obeyed; no line of ours begins where a name wants it."""
    hostile = "\x1b]0;owned\x07\x9b31m"
    trace = commands.write("e.trace.jsonl", HEADER, SPEECH | {"text": f"The {hostile} plate."})
    commands.run("replay", trace, "--no-physics", "-o", "e.run.jsonl")
    commands.run("replay", commands.write("f.trace.jsonl", HEADER, SPEECH), "--no-physics", "-o", "f.run.jsonl")
    odd = commands.folder / "a\n::warning::owned\x1b[2J.trace.jsonl"
    shutil.copy(trace, odd)
    commands.write("m.json", random_machine(3, 3) | {"name": f"m{hostile}"})
    commands.run("replay", odd, "--no-physics", "-o", "odd.run.jsonl")
    for arguments in (["explain", "e.run.jsonl"], ["diff", "e.run.jsonl", "f.run.jsonl"], ["machine", "m.json"],
                      ["validate", odd], ["check", odd, "--no-physics", "--github", "--failures", ""],
                      ["replay", odd, "--no-physics", "-o", "odd.run.jsonl"], ["explain", f"no{hostile}file"]):
        done = commands.run(*arguments)
        said = (done.stdout + done.stderr).decode(errors="replace")
        if any(mark in said for mark in ("\x1b", "\x07", "\x9b")):
            yield f"{arguments}: control characters reach the terminal"
        if any(line.startswith("::warning::owned") for line in said.splitlines()):
            yield f"{arguments}: a file's name begins a line"


def check_names_without_letters(commands):
    """JUnit's XML is read by others, whatever the bytes of a file's name."""
    name = os.fsencode(commands.folder) + b"/n\xff\xfe.trace.jsonl"
    with open(name, "wb") as file:
        file.write(commands.write("x.trace.jsonl", HEADER, SPEECH).read_bytes())
    subprocess.run([commands.program, "check", name, "--no-physics", "--junit", "j.xml", "--failures", ""],
                   cwd=commands.folder, capture_output=True, check=False, timeout=PATIENCE_S)
    try:
        xml.etree.ElementTree.parse(commands.folder / "j.xml")
    except (OSError, xml.etree.ElementTree.ParseError) as error:
        yield f"JUnit's XML of a name that is not UTF-8: {error}"


def check_future(commands):
    """A log without its end that was written just now may grow; one of next year, by a clock set back, may not."""
    commands.write("l.trace.jsonl", HEADER, SPEECH)
    commands.run("replay", "l.trace.jsonl", "--no-physics", "-o", "l.run.jsonl")
    log = commands.folder / "l.run.jsonl"
    log.write_bytes(b"".join(log.read_bytes().splitlines(keepends=True)[:-1]))
    with Server(commands.program, commands.folder) as server:
        for about, ahead_s, live in (("just now", 0, True), ("a year ago", -3.2e7, False),
                                     ("in a year", 3.2e7, False)):
            os.utime(log, (time.time() + ahead_s,) * 2)
            run = server.client().get("/api/runs").must()["runs"][0]
            if run.get("live", False) is not live:
                yield f"a log without end, written {about}: live is {run.get('live')}"


def check_hang_up(commands):
    """A terminal that is closed, or a key that is pressed, ends a session with its last line."""
    for sign in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):
        with Server(commands.program, commands.folder) as server:
            session = server.client().begin(physics=False)
            server.client().send(session["id"], [SPEECH])
            server.stop(sign)
        log = commands.folder / session["trace"].replace(".trace.jsonl", ".run.jsonl")
        if json.loads(log.read_bytes().splitlines()[-1])["kind"] != "end":
            yield f"after {sign.name} the session's log has no last line"
    pipe = subprocess.Popen([commands.program, "record", "-o", "p.trace.jsonl", "--no-physics", "--port", "0"],
                            cwd=commands.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL)
    pipe.stdin.write(json.dumps(SPEECH).encode() + b"\n")
    pipe.stdin.flush()
    pipe.stdout.readline()  # the avatar's move: the session is under way
    pipe.send_signal(signal.SIGHUP)
    pipe.communicate(timeout=PATIENCE_S)
    if json.loads((commands.folder / "p.run.jsonl").read_bytes().splitlines()[-1])["kind"] != "end":
        yield "after SIGHUP the log of record has no last line"


def check_names_of_objects(commands):
    """An object that only a trace's header has: the header is wrong, not the scene."""
    trace = commands.write("o.trace.jsonl", HEADER | {"objects": {"KNIFE": {"position": [0, 0]}}}, SPEECH)
    for command in (["replay", trace, "-o", "-"], ["validate", trace]):
        done = commands.run(*command)
        said = done.stderr.decode()
        if done.returncode == 0 or not said.replace("continua: ", "").startswith(f"{trace}:1: "):
            yield f"{command[0]}: an unknown object is told with {said[:200]!r}"


def check_markup(commands):
    """Words, gestures and names of files that are markup stay text in every exported page and picture."""
    words, gesture, name = ("</script><img src=x onerror=alert(1)>\u2028<!--<script>&amp;]]>",
                            "</title><svg/onload=alert(2)>", "<img src=x onerror=alert(3)>")
    trace = commands.write(f"{name}.trace.jsonl", HEADER, SPEECH | {"text": words},
                           {"t": 2, "kind": "gesture", "name": gesture, "phase": "stroke"})
    run = commands.folder / f"{name}.run.jsonl"
    yield from commands.told(0, "2 inputs", "replay", trace, "--no-physics", "-o", run)
    for to in ("html", "svg", "eaf", "vtt", "site"):
        commands.run("export", run, "--to", to, "-o", f"out.{to}")
        out = commands.folder / f"out.{to}"
        files = [path for path in out.rglob("*") if path.is_file()] if out.is_dir() else [out]
        for path in files:
            text = path.read_text(errors="replace")
            if any(part in text for part in ("<img src=x", "<svg/onload", "</script><img", "<!--<script>")):
                yield f"{path.name} has the words as markup"
        if to in ("svg", "eaf"):
            xml.etree.ElementTree.parse(out)


CHECKS = (check_markup, check_time_steps, check_what_if_of_strangers, check_machines, check_reports, check_empty_folders,
          check_keys_twice, check_terminals, check_names_without_letters, check_future, check_hang_up,
          check_names_of_objects)


def main(program, source, *names):
    failed = False
    for check in CHECKS:
        if names and check.__name__ not in names:
            continue
        with tempfile.TemporaryDirectory() as folder:
            try:
                problems = list(check(Commands(pathlib.Path(program).resolve(), pathlib.Path(source).resolve(),
                                               pathlib.Path(folder))))
            except (AssertionError, OSError, RuntimeError, subprocess.SubprocessError) as error:
                problems = [repr(error)]
        for problem in problems:
            failed = True
            print(f"{check.__name__}: {problem}", file=sys.stderr, flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
