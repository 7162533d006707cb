#!/usr/bin/env python3
"""Live sessions full of whatever comes, on time, early, late and too late, replay to the same records.

replay_test.py PROGRAM [SESSIONS]
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

from live_server import Server, records, run_of

SESSIONS = 8
SAID = ["The plate.", "Put it there.", "That cup.", "Put the knife in the blue cup.", "No.", "Yes.", "Never mind.",
        "Stop.", "Put that there.", "What do you see?", "Lift it.", "Grasp the cup.", "Put it on the plate.",
        "Move the plate to the left of the knife.", "another one"]
SHOWN = ["point", "point", "posack", "negack", "grab", "release", "nevermind", "never_seen"]
LATE_S = [0.1, 0.7, 1.5, 3, 6]
EARLY_S = 0.5
PAUSES_S = [0, 0.005, 0.02, 0.1]


def any_event(chance):
    """Words, a gesture or a sample; which have no time of their own yet."""
    place = {"target": [chance.uniform(-0.4, 0.4), chance.uniform(-0.3, 0.3)]}
    kind = chance.choices(["speech", "gesture", "pointing"], [7, 4, 9])[0]
    if kind == "speech":
        return {"kind": kind, "text": chance.choice(SAID)}
    if kind == "pointing":
        return {"kind": kind, "hand": "right"} | place
    name = chance.choice(SHOWN)
    shown = {"kind": kind, "name": name, "phase": chance.choice(["start", "stop", "stroke"])}
    return shown | place if name == "point" else shown


def record(client, chance):
    """The state of a session of its own pace and world, once it has ended."""
    session = client.begin(scene="place_setting", machine="interaction", clock="wall", speed=chance.choice([1, 4, 10]),
                           physics=chance.random() < 0.7)
    now = 0
    for _ in range(chance.randint(10, 30)):
        event, when = any_event(chance), chance.random()
        if when < 0.3:
            event["t"] = max(0, now - chance.choice(LATE_S))
        elif when < 0.4:
            event["t"] = now + EARLY_S
        now = client.send(session["id"], event)["t"]
        time.sleep(chance.choice(PAUSES_S))
    client.end(session["id"])
    return session


def told(run):
    """All that a log tells, but for digests of what is not yet known while it is written."""
    kept = [record for record in records(run) if record["kind"] != "run"]
    for one in kept:
        one.pop("digest", None)
    return kept


def main(program, sessions=SESSIONS):
    late = different = 0
    with tempfile.TemporaryDirectory() as folder, Server(pathlib.Path(program).resolve(), folder) as server:
        client = server.client()
        for seed in range(int(sessions)):
            trace = pathlib.Path(folder, record(client, random.Random(seed))["trace"])
            live, offline = run_of(trace), trace.with_suffix(".offline")
            world = [] if records(live)[0]["world"] == "physics" else ["--no-physics"]
            subprocess.run([program, "replay", trace, *world, "-o", offline], stdout=subprocess.DEVNULL, check=True)
            was, now = told(live), told(offline)
            late += sum(one["kind"] == "refusal" and " late" in one["reason"] for one in was)
            if was == now:
                continue
            different += 1
            first = next(((a, b) for a, b in zip(was, now) if a != b), (f"{len(was)} records", f"{len(now)} records"))
            print(f"session {seed} replays otherwise:", *map(json.dumps, first), sep="\n", file=sys.stderr)
    if late == 0:
        print("nothing came too late: the sessions no longer show that it replays", file=sys.stderr)
    return 1 if different or late == 0 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
