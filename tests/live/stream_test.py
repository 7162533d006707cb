#!/usr/bin/env python3
"""Streams a recorded session into a live one ten times as fast as it happened, and pipes the paper's examples into
`continua record`: what is decided is what an offline replay decides.

stream_test.py PROGRAM SOURCE_FOLDER. Exit status 77, which counts as skipped, without the recording.
"""
import concurrent.futures
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

from live_server import Server, records, run_of

RECORDING = "PilotStudy13-2018-02-08-124816"  # acts that fail or take long: the two worlds decide differently
SECONDS, SPEED = 180, 10
HUMAN = ("speech", "gesture", "pointing")
MOVES = ("utterance", "gesture", "act")
WORLDS = ([], ["--no-physics"])
PIPED_WITH_PHYSICS = "correction"


def decisions(run):
    return records(run)[-1].get("decisions", f"{run} has no end")


def told(run):
    """The log without its statements about itself."""
    return [record for record in records(run) if record["kind"] not in ("run", "block", "end")]


def lines_of_moves(run):
    return [line for line in run.read_text(encoding="utf-8").splitlines() if json.loads(line)["kind"] in MOVES]


def replay(program, trace, world):
    """The run log of an offline replay."""
    run = trace.with_name(f"{trace.name.split('.')[0]}{''.join(world)}.replay.run.jsonl")
    # 1: what a trace expects of one world need not be so in the other.
    status = subprocess.run([program, "replay", trace, *world, "-o", run], stdout=subprocess.DEVNULL,
                            check=False).returncode
    if status not in (0, 1):
        raise AssertionError(f"continua replay {trace} ended with status {status}")
    return run


def human_side(program, log, folder):
    """The trace of what the human did in the recording's first minutes."""
    whole, trace = folder / "whole.trace.jsonl", folder / "human.trace.jsonl"
    subprocess.run([program, "import", log, "-o", whole], check=True, stdout=subprocess.DEVNULL)
    header, *events = whole.read_text(encoding="utf-8").splitlines(keepends=True)
    kept = [line for line in events if (event := json.loads(line))["kind"] in HUMAN and event["t"] <= SECONDS]
    trace.write_text(header + "".join(kept), encoding="utf-8")
    return trace


def streamed(source, server, trace, world, folder):
    """The trace of a live session into which the example client streamed that one."""
    said = subprocess.run([sys.executable, source / "replay/live/example_client.py", trace, "--server", server.address,
                           "--speed", str(SPEED), *world], cwd=folder, check=True, stdout=subprocess.PIPE, text=True)
    return pathlib.Path(folder, said.stdout.splitlines()[-2].removeprefix("trace ").strip())


def check_stream(program, source, log, folder):
    trace = human_side(program, log, folder)
    with Server(program, folder) as server, concurrent.futures.ThreadPoolExecutor() as side_by_side:
        sessions = list(side_by_side.map(lambda world: streamed(source, server, trace, world, folder), WORLDS))
    for world, session in zip(WORLDS, sessions):
        name, live, offline = " ".join(world) or "physics", run_of(session), replay(program, trace, world)
        if decisions(live) != decisions(offline):
            yield f"{name}: the live session decided otherwise than the replay of what was streamed"
        if subprocess.run([program, "diff", live, offline, "--most", "1"], stdout=sys.stderr, check=False).returncode:
            yield f"{name}: continua diff tells the live session and the replay apart"
        if decisions(replay(program, session, world)) != decisions(live):
            yield f"{name}: the replay of the session's own trace decided otherwise"
    if len({decisions(run_of(session)) for session in sessions}) < len(WORLDS):
        yield "the worlds decided alike: the recording no longer shows that physics counts"


def check_pipe(program, example, world, folder):
    """Problems of `continua record` when a trace comes through a pipe."""
    name = f"{example.name.split('.')[0]}{''.join(world)}"
    original, recorded = (folder / f"{side}_{name}.trace.jsonl" for side in ("original", "recorded"))
    shutil.copy(example, original)
    piped = subprocess.run([program, "record", "-o", recorded, *world, "--port", "0"], input=example.read_bytes(),
                           cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    if piped.returncode:
        yield f"{name}: continua record ended with status {piped.returncode}: {piped.stderr.decode()}"
        return
    run = run_of(recorded)
    # Not by the digest: the recorded trace may spell the events otherwise, 37.0 for 37.
    if told(run) != told(replay(program, original, world)):
        yield f"{name}: what was piped in went otherwise than in a replay"
    if decisions(run) != decisions(replay(program, recorded, world)):
        yield f"{name}: the replay of what was recorded decided otherwise"
    if piped.stdout.decode().splitlines() != lines_of_moves(run):
        yield f"{name}: standard output does not tell the moves that the log has"


def main(program, source):
    program, source = pathlib.Path(program).resolve(), pathlib.Path(source).resolve()
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        examples = sorted((source / "traces/paper").glob("*.trace.jsonl"))
        piped = [(example, ["--no-physics"]) for example in examples]
        piped += [(example, []) for example in examples if example.name.startswith(PIPED_WITH_PHYSICS)]
        with concurrent.futures.ThreadPoolExecutor(2) as some:
            for problems in some.map(lambda one: [*check_pipe(program, *one, folder)], piped):
                failures += problems
        log = source / f"../shared/data/pilot2018/{RECORDING}.txt"
        if log.exists():
            failures += check_stream(program, source, log, folder)
    print(*failures, sep="\n", file=sys.stderr)
    if not failures and not log.exists():
        print(f"skipped: there is no {log}")
        return 77
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
