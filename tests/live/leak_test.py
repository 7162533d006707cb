#!/usr/bin/env python3
"""Live sessions in a row on one server: it keeps no thread, no open file and little memory of any.

leak_test.py PROGRAM TOLD_MEMORY

TOLD_MEMORY is tests/support/told_memory.cpp as a library. A program with another allocator than jemalloc cannot tell how
much it has, and that part is left out.
"""
import os
import pathlib
import resource
import sys
import tempfile
import time

from live_server import PATIENCE_S, Server, Stream

SESSIONS, FIRST = 12, 2  # the first ones leave what is made once: threads of a pool, what was read and is kept
LAST = 4                 # sessions at the middle and at the end that memory is compared of, by the least of each
MOST_GROWN_MB = 10       # between those two; six sessions that were kept would be over 30
# Freed memory goes back to the system at once, and threads share one heap: else memory tells most of what happened
# to be made when, and in which thread.
GIVES_BACK = {"MALLOC_CONF": "narenas:1,dirty_decay_ms:0,muzzy_decay_ms:0,tcache:false"}
SMALL, FIRST_SMALL = 20, 6     # sessions of a few words, half of which end by an event
MOST_KEPT_KB = 10              # of each of those: its name, where its files are, how it ended
MOST_MORE_STACKS = 8           # in all: the C library keeps five for its next threads; one that nobody joined has its own
ALL_BYTES = {"MALLOC_CONF": "tcache:false"}  # freed bytes do not wait in threads for their next use
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


def stacks_of(pid):
    """The stacks of threads, also of those that have ended and that nobody has joined."""
    size = resource.getrlimit(resource.RLIMIT_STACK)[0]
    mapped = [line.split() for line in pathlib.Path("/proc", str(pid), "maps").read_text().splitlines()]
    ends = [(part[0].split("-"), part[1]) for part in mapped]
    return sum(access == "rw-p" and int(end, 16) - int(begin, 16) == size for (begin, end), access in ends)


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


def use_shortly(client, number):
    """One small session, which somebody ends, or whose last event does."""
    session = client.begin(scene="place_setting", machine="interaction", clock="events", physics=False)["id"]
    client.send(session, {"t": 1, "kind": "speech", "text": SPEECH[number % len(SPEECH)]})
    if number % 2:
        client.end(session)
    else:
        client.send(session, {"t": 2, "kind": "end"})


def allocated(fifo):
    """Kilobytes; none if the program does not know."""
    with open(fifo, encoding="ascii") as told:
        text = told.readline().strip()
    return None if text == "unknown" else int(text) / 1024


def check_small(program, library):
    """What is kept of each session that has ended, however it did."""
    with tempfile.TemporaryDirectory() as folder:
        fifo = str(pathlib.Path(folder, "told"))
        os.mkfifo(fifo)
        loads = {"LD_PRELOAD": str(library), "CONTINUA_TOLD_MEMORY": fifo}
        with Server(program, folder, environment=ALL_BYTES | loads) as server:
            client = server.client()
            for number in range(FIRST_SMALL):
                use_shortly(client, number)
            memory, stacks = allocated(fifo), stacks_of(server.pid)
            for number in range(SMALL):
                use_shortly(client, number)
            more = stacks_of(server.pid) - stacks
            kept = 0 if memory is None else (allocated(fifo) - memory) / SMALL
    print(f"{SMALL} small sessions: {kept:.1f} kB of each, {more} stacks more", flush=True)
    if kept > MOST_KEPT_KB:
        yield f"{kept:.1f} kB are kept of each session that has ended"
    if more > MOST_MORE_STACKS:
        yield f"{SMALL} sessions that have ended keep {more} stacks of threads"


def check_large(program):
    """Twenty sessions with physics and a viewer."""
    measured = []
    with tempfile.TemporaryDirectory() as folder, Server(program, folder, environment=GIVES_BACK) as server:
        client = server.client()
        for number in range(1, SESSIONS + 1):
            use(server, client)
            measured.append(held_soon(server.pid, measured[FIRST - 1] if number > FIRST else (10**9, 10**9)))
            print("session {}: {} threads, {} files, {:.1f} MB".format(number, *measured[-1]), flush=True)
    # At any one look work in the background may be under way.
    grown = least_memory(measured[-LAST:]) - least_memory(measured[SESSIONS // 2 - LAST : SESSIONS // 2])
    for column, what in enumerate(["threads", "open files"]):
        if measured[-1][column] > measured[FIRST - 1][column]:
            yield f"{measured[-1][column]} {what}, after {FIRST} sessions {measured[FIRST - 1][column]}"
    if grown > MOST_GROWN_MB:
        yield f"memory has grown by {grown:.1f} MB over {SESSIONS - SESSIONS // 2} sessions"


def main(program, library):
    program, library = pathlib.Path(program).resolve(), pathlib.Path(library).resolve()
    failures = [*check_small(program, library), *check_large(program)]
    print(*failures, sep="\n", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
