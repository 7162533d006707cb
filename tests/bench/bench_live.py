#!/usr/bin/env python3
"""How long a live session takes from an event to the transition that it brings about.

    tests/bench/bench_live.py build/continua [seconds]

A recogniser sends a hundred events a second over one connection, each when it happens; a viewer, another process, hears
of the transitions on the session's stream. Meanwhile physics runs, and the arm is told to move again and again.
"""
import json
import multiprocessing
import pathlib
import statistics
import sys
import tempfile
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "live"))
from live_server import Server, Stream  # noqa: E402, it is in another folder

EVENTS_A_SECOND = 100
# In the machine `interaction` a nod that answers nothing is acknowledged: one transition, and the state is the same.
EVENT = {"kind": "gesture", "name": "posack", "phase": "stroke"}
ORDERS = ["Put the knife on the plate.", "Put the knife in the white cup."]
EACH_ORDER_S = 7
GOAL_MS = {"median": 5, "99 %": 20}


def view(server, session, heard_all):
    """Hands over when each nod had led to a transition, and how many records told of something that moved."""
    times, counts = [], {"pending": False, "pose": 0}

    def heard(event, data):
        if event != "record":
            return
        now = time.monotonic()
        if data.startswith('{"kind":"input"'):
            counts["pending"] = json.loads(data)["event"].get("name") == EVENT["name"]
        elif data.startswith('{"kind":"transition"') and counts["pending"]:
            times.append(now)
            counts["pending"] = False
        counts["pose"] += data.startswith('{"kind":"pose"')

    stream = Stream(server, session, heard)
    heard_all.put("listening")
    stream.over.wait()
    heard_all.put((times, counts["pose"]))


def send(client, session, seconds):
    """When each nod was sent, and how long its answer took."""
    sent, answered = [], []
    begun = time.monotonic()
    for number in range(seconds * EVENTS_A_SECOND):
        time.sleep(max(0, begun + number / EVENTS_A_SECOND - time.monotonic()))
        if number % (EACH_ORDER_S * EVENTS_A_SECOND) == 0:
            order = ORDERS[number // (EACH_ORDER_S * EVENTS_A_SECOND) % len(ORDERS)]
            client.send(session, {"kind": "speech", "text": order})
        sent.append(time.monotonic())
        client.send(session, EVENT)
        answered.append(time.monotonic() - sent[-1])
    return sent, answered


def row(name, seconds):
    parts = statistics.quantiles(seconds, n=100, method="inclusive")
    told = [parts[49], parts[94], parts[98], max(seconds)]
    print(f"| {name} |" + "".join(f" {1000 * part:.2f} |" for part in told))


def main():
    seconds = int(sys.argv[2]) if len(sys.argv) > 2 else 30
    with tempfile.TemporaryDirectory() as folder, Server(pathlib.Path(sys.argv[1]).resolve(), folder) as server:
        client = server.client()
        session = client.begin(scene="place_setting", machine="interaction", clock="wall", physics=True)["id"]
        heard_all = multiprocessing.Queue()
        # In a process of its own: threads of one would wait for each other, and that would be measured.
        viewer = multiprocessing.Process(target=view, args=(server, session, heard_all))
        viewer.start()
        heard_all.get()
        sent, answered = send(client, session, seconds)
        client.end(session)
        heard, poses = heard_all.get()
        viewer.join()
    if len(heard) != len(sent):
        sys.exit(f"{len(sent)} nods were sent, but {len(heard)} led to a transition")
    print(f"{len(sent)} events in {sent[-1] - sent[0]:.1f} s, {poses} records of poses\n")
    print("| ms | median | 95 % | 99 % | most |\n| --- | --- | --- | --- | --- |")
    row("event sent to transition heard", [there - here for here, there in zip(sent, heard)])
    row("event sent to answer", answered)
    print("\ngoal: " + ", ".join(f"{name} below {most} ms" for name, most in GOAL_MS.items()))


if __name__ == "__main__":
    main()
