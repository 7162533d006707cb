#!/usr/bin/env python3
"""Kills the server fifty times at a random moment of a live session: what was acknowledged is in the trace, trace and
log are whole up to their last line, and the trace's replay goes the way that the log tells.

kill_test.py PROGRAM [SEED…]
"""
import concurrent.futures
import http.client
import json
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time

from live_server import Server, records, run_of, whole_lines

TIMES, AT_ONCE = 50, 2
LONGEST_S = 1.0       # from the session's beginning to the kill
MEAN_PAUSE_S = 0.01   # between events
WITH_PHYSICS = 0.2    # of all sessions: their replays take long, since acts under way are finished

WORDS = ["Put the knife in the cup.", "The white cup.", "Yes.", "No.", "Put it there.", "Never mind.", "The plate.",
         "glorp"]
GESTURES = ["posack", "negack", "nevermind", "wobble", "grab"]
# Statements about the trace as a whole: it is longer in the replay than it was for the killed server.
OF_THE_WHOLE = ("run", "block", "rest", "end")


def random_event(draw, now):
    """Something that a recogniser may tell when the engine's time is `now`."""
    kind = draw.choice(["speech", "gesture", "pointing", "point"])
    place = [round(draw.uniform(-0.4, 0.4), 3), round(draw.uniform(-0.3, 0.3), 3)]
    event = {
        "speech": lambda: {"kind": "speech", "text": draw.choice(WORDS), "confidence": 0.9},
        "gesture": lambda: {"kind": "gesture", "name": draw.choice(GESTURES), "phase": "stroke"},
        "pointing": lambda: {"kind": "pointing", "hand": "right", "target": place},
        "point": lambda: {"kind": "gesture", "name": "point", "hand": "right", "phase": "stroke", "target": place},
    }[kind]()
    late = draw.choice([None, None, 0.0, 0.3, 1.5, 4.0])  # recognisers take their time; some too long
    return event if late is None else {"t": max(0, round(now - late, 6)), **event}


def feed(client, session, draw, over):
    """Sends events until the server is gone. What was sent, in order, and how many of these were acknowledged."""
    sent, acknowledged, now = [], 0, 0
    try:
        while not over.is_set():
            batch = [random_event(draw, now) for _ in range(draw.choice([1, 1, 1, 4]))]
            sent += batch
            answer = client.send(session, batch)
            now, acknowledged = answer["t"], len(sent)
            time.sleep(draw.expovariate(1 / MEAN_PAUSE_S))
    except (OSError, http.client.HTTPException):
        return sent, acknowledged
    return sent, acknowledged


def killed_session(program, folder, draw):
    """The trace that a killed server left, its world, what was sent and how much of it was acknowledged."""
    physics, command = draw.random() < WITH_PHYSICS, draw.choice(["serve", "record"])
    with Server(program, folder, command=command) as server:
        client, over = server.client(), threading.Event()
        session = client.begin(scene="place_setting", machine="interaction", clock="wall", speed=draw.choice([1, 5]),
                               physics=physics)

        def kill():
            over.set()
            server.process.send_signal(signal.SIGKILL)

        timer = threading.Timer(draw.uniform(0, LONGEST_S), kill)
        timer.start()
        sent, acknowledged = feed(client, session["id"], draw, over)
        timer.join()
    return pathlib.Path(folder, session["trace"]), physics, sent, acknowledged


def as_sent(event):
    """An event of the trace without what the server adds: when it learned of it, and when it had happened."""
    return {name: value for name, value in event.items() if name not in ("t", "happened")}


def check_trace(trace, sent, acknowledged):
    header, *events = records(trace)
    if header["kind"] != "trace":
        yield "the trace does not begin with a header"
    if len(events) < acknowledged:
        yield f"the trace holds {len(events)} events of {acknowledged} that were acknowledged"
    if list(map(as_sent, events)) != list(map(as_sent, sent[:len(events)])):
        yield "the trace holds other events than those that were sent"


def check_log(program, run):
    asked = subprocess.run([program, "validate", run], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if asked.returncode:
        yield f"continua validate ended with status {asked.returncode}: {asked.stdout.decode()}"
    if [record["n"] for record in records(run)] != list(range(len(records(run)))):
        yield "records are missing from the log"


def check_replay(program, trace, physics):
    whole, again = trace.with_suffix(".whole.jsonl"), trace.with_suffix(".again.run.jsonl")
    whole.write_bytes(b"".join(line + b"\n" for line in whole_lines(trace)))
    subprocess.run([program, "replay", whole, *([] if physics else ["--no-physics"]), "-o", again], check=True,
                   stdout=subprocess.DEVNULL)
    told, replayed = ([record for record in records(log) if record["kind"] not in OF_THE_WHOLE]
                      for log in (run_of(trace), again))
    for was, now in zip(told, replayed):
        if was != now:
            yield f"the log told {json.dumps(was)[:200]}, the replay tells {json.dumps(now)[:200]}"
            return
    if len(told) > len(replayed):
        yield f"the log tells {len(told)} records, the replay only {len(replayed)}"


def check(program, seed):
    """Problems, the number of events acknowledged, and of records in the log."""
    with tempfile.TemporaryDirectory() as folder:
        trace, physics, sent, acknowledged = killed_session(program, folder, random.Random(seed))
        problems = [*check_trace(trace, sent, acknowledged), *check_log(program, run_of(trace)),
                    *check_replay(program, trace, physics)]
        return [f"seed {seed}: {problem}" for problem in problems], acknowledged, len(whole_lines(run_of(trace)))


def main(program, *seeds):
    program = pathlib.Path(program).resolve()
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as some:
        checked = list(some.map(lambda seed: check(program, seed), map(int, seeds) if seeds else range(TIMES)))
    failures = [problem for problems, _, _ in checked for problem in problems]
    acknowledged, told = sum(one[1] for one in checked), sum(one[2] for one in checked)
    print(f"{len(checked)} kills, {acknowledged} events acknowledged, {told} records told")
    print(*failures, sep="\n", file=sys.stderr)
    return 1 if failures or not acknowledged else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
