#!/usr/bin/env python3
"""Twenty live sessions in a row on one server: it keeps no thread, no open file and little memory of any.

leak_test.py PROGRAM
"""
import pathlib
import sys
import tempfile
import time

from live_server import PATIENCE_S, Server, Stream

SESSIONS, FIRST = 20, 2  # the first ones leave what is made once: threads of a pool, what was read and is kept
LAST = 5                 # sessions at the middle and at the end that memory is compared of, by the least of each
MOST_GROWN_MB = 10       # between those two; ten sessions that were kept would be over 50
# Freed memory goes back to the system at once, and threads share one heap: else memory tells most of what happened
# to be made when, and in which thread.
GIVES_BACK = {"MALLOC_CONF": "narenas:1,dirty_decay_ms:0,muzzy_decay_ms:0,tcache:false"}
SPEECH = ["The plate.", "Put the knife in the white cup.", "Yes."]


def use(server, client):
    """One session: a viewer, samples of pointing, words, and an act in a world with physics."""
    state = client.begin(scene="place_setting", machine="interaction", clock="events", physics=True)
    stream = Stream(server, state["id"])
    samples = [{"t": i / 30, "kind": "pointing", "hand": "right", "target": [0.2, i / 1000]} for i in range(60)]
    client.send(state["id"], samples)
    for i, text in enumerate(SPEECH):
        client.send(state["id"], {"t": 3 + 2 * i, "kind": "speech", "text": text})
    client.send(state["id"], {"t": 12, "kind": "clock"})
    client.end(state["id"])
    if not stream.over.wait(PATIENCE_S):
        raise AssertionError("the stream of an ended session goes on")
    kinds = {record["kind"] for record in stream.records()}
    if not {"utterance", "act", "pose", "end"} <= kinds:
        raise AssertionError(f"the session was to speak and move, but told only {sorted(kinds)}")


def held(pid):
    """Threads, open files and megabytes of memory."""
    process = pathlib.Path("/proc", str(pid))
    kilobytes = next(line.split()[1] for line in (process / "status").read_text().splitlines() if "VmRSS" in line)
    return len(list((process / "task").iterdir())), len(list((process / "fd").iterdir())), int(kilobytes) / 1024


def held_soon(pid, most):
    """The same, once threads and files are no more than that, or when it has been waited long enough."""
    until = time.monotonic() + PATIENCE_S / 4
    while (now := held(pid))[0] > most[0] or now[1] > most[1]:
        if time.monotonic() > until:
            break
        time.sleep(0.05)
    return now


def least_memory(measured):
    return min(megabytes for _, _, megabytes in measured)


def main(program):
    measured = []
    program = pathlib.Path(program).resolve()
    with tempfile.TemporaryDirectory() as folder, Server(program, folder, environment=GIVES_BACK) as server:
        client = server.client()
        for number in range(1, SESSIONS + 1):
            use(server, client)
            measured.append(held_soon(server.pid, measured[FIRST - 1] if number > FIRST else (10**9, 10**9)))
            print("session {}: {} threads, {} files, {:.1f} MB".format(number, *measured[-1]), flush=True)
    # At any one look work in the background may be under way.
    grown = least_memory(measured[-LAST:]) - least_memory(measured[SESSIONS // 2 - LAST : SESSIONS // 2])
    failures = []
    for column, what in enumerate(["threads", "open files"]):
        if measured[-1][column] > measured[FIRST - 1][column]:
            failures.append(f"{measured[-1][column]} {what}, after {FIRST} sessions {measured[FIRST - 1][column]}")
    if grown > MOST_GROWN_MB:
        failures.append(f"memory has grown by {grown:.1f} MB over {SESSIONS - SESSIONS // 2} sessions")
    print(*failures, sep="\n", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
