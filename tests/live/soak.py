#!/usr/bin/env python3
"""Load for as long as you like, and figures of it: sessions in a row, a long one, many viewers, many requests of each
kind, slow readers and half-open connections. Memory, files and threads stay flat, and others are answered as before.

soak.py PROGRAM [MINUTES [PART…]]      10 minutes if left out; PART: long, wall, sessions, viewers, requests, slow

A part has its share of the time, or ends when it has done what it is to: to have it done, give a part time enough.
Prints a row of a table for each part. Exit status 1 where something grew.
"""
import multiprocessing
import pathlib
import selectors
import socket
import statistics
import sys
import tempfile
import time

from leak_test import GIVES_BACK, held
from live_server import Server, Stream

WORDS = ["The plate.", "Put the knife in the white cup.", "Yes.", "Never mind."]
MOST_MORE_MB, MOST_MORE_FILES, MOST_MORE_THREADS = 20, 8, 4
VIEWERS, SLOW = 50, 200
HOURS_OF_SESSION = 12
SESSIONS, FIRST = 1000, 20  # as many as a server begins; of which the first ones make what is made once
REQUESTS = 10_000  # of each kind
VIEWS = ("", "/records?from=0&to=50", "/columns", "/labels?from=0&limit=50", "/find?text=plate", "/stack?n=5",
         "/derivation?n=5", "/explain?n=5", "/account?n=5", "/graph", "/scene", "/poses?from=0&to=1", "/notes", "/media")
SOME_TIME_S = 0.02  # a delay that nobody notices


def time_s(ask):
    begun = time.monotonic()
    ask()
    return time.monotonic() - begun


def times_s(client, path="/api/sessions", count=200):
    return [time_s(lambda: client.get(path)) for _ in range(count)]


def p99_s(times):
    return statistics.quantiles(times, n=100)[98]


def in_ms(times):
    cuts = statistics.quantiles(times, n=100)
    return f"p50 {cuts[49] * 1000:.1f} ms, p99 {cuts[98] * 1000:.1f} ms"


def run_long(server, client, until):
    """A session of twelve hours by its own clock, or as much of it as there is time for."""
    session = client.begin(clock="events", physics=False, scene="place_setting")
    t = 0
    while t < HOURS_OF_SESSION * 3600 and time.monotonic() < until:
        t += 10
        client.send(session["id"], {"t": t, "kind": "speech", "text": WORDS[t // 10 % len(WORDS)]})
    client.end(session["id"])
    return f"a session of {t / 3600:.1f} h by its clock"


def run_wall(server, client, until):
    """A session by the wall's clock with physics and a viewer, in which somebody says something every two seconds."""
    begun = time.monotonic()
    session = client.begin(clock="wall", physics=True, scene="place_setting")
    viewer, times = Stream(server, session["id"], keeps=False), []
    while time.monotonic() < until:
        said = {"kind": "speech", "text": WORDS[len(times) % len(WORDS)]}
        times.append(time_s(lambda: client.send(session["id"], said)))
        time.sleep(2)
    client.end(session["id"])
    if not viewer.over.wait(60) or viewer.last != "ended":
        raise AssertionError("the viewer is not told of the session's end")
    minutes = (time.monotonic() - begun) / 60
    return f"a session of {minutes:.0f} minutes with physics, {len(times)} events: {in_ms(times)}"


def run_sessions(server, client, until, most=SESSIONS - FIRST):
    times = []
    while len(times) < most and time.monotonic() < until:
        begun = time.monotonic()
        session = client.begin(clock="events", physics=False, scene="place_setting")
        client.send(session["id"], [{"t": 1 + n, "kind": "speech", "text": text} for n, text in enumerate(WORDS)])
        client.end(session["id"])
        times.append(time.monotonic() - begun)
    return f"{len(times)} sessions in a row, after {FIRST}; one: {in_ms(times)}"


def follow(server, session, attending, told):
    """Fifty streams, in a process of their own, so that whoever measures others has nothing to do with them. Records
    are counted by the bytes that begin one: 50 readers of JSON would be slower than the server."""
    begins, still = b"event: record\n", selectors.DefaultSelector()
    for _ in range(VIEWERS):
        viewer = socket.create_connection((server.host, server.port))
        viewer.sendall(f"GET /api/live?session={session} HTTP/1.1\r\nHost: {server.host}:{server.port}\r\n\r\n".encode())
        still.register(viewer, selectors.EVENT_READ, {"count": 0, "rest": b""})
    counts = []
    while still.get_map():
        for key, _ in still.select():
            part, seen = key.fileobj.recv(1 << 16), key.data
            text = seen["rest"] + part
            seen["count"] += text.count(begins)
            seen["rest"] = text[-len(begins) + 1:]
            if not part or b"\r\n0\r\n\r\n" in text:
                counts.append(seen["count"])
                still.unregister(key.fileobj)
        if all(key.data["rest"] for key in still.get_map().values()):
            attending.set()
    told.put(sorted(counts))


def run_viewers(server, client, until):
    """Fifty streams of one session, beside which others are asked about as soon as without them."""
    session = client.begin(clock="events", physics=False, scene="place_setting")
    t = 0

    def asked_beside_events():
        nonlocal t
        t += 1
        client.send(session["id"], {"t": t, "kind": "speech", "text": WORDS[t % len(WORDS)]})
        begun = time.monotonic()
        client.get("/api/sessions")
        return time.monotonic() - begun

    def p99_of(count):
        return p99_s([asked_beside_events() for _ in range(count)])

    p99_of(100)
    quiet = p99_of(300)
    attending, told = multiprocessing.Event(), multiprocessing.Queue()
    viewers = multiprocessing.Process(target=follow, args=(server, session["id"], attending, told), daemon=True)
    viewers.start()
    if not attending.wait(60):
        raise AssertionError("fifty viewers are not served")
    crowded = p99_of(300)
    while t < 3000 and time.monotonic() < until:
        asked_beside_events()
    client.end(session["id"])
    counts = told.get(timeout=120)
    viewers.join()
    if len(counts) != VIEWERS or len(set(counts)) != 1 or counts[0] == 0:
        raise AssertionError(f"viewers were told different numbers of records: {counts}")
    if crowded > max(2 * quiet, SOME_TIME_S):
        raise AssertionError(f"p99 beside viewers is {crowded * 1000:.1f} ms, {quiet * 1000:.1f} ms without")
    return f"{VIEWERS} viewers of {t} events, p99 of others {crowded * 1000:.1f} ms, quiet {quiet * 1000:.1f} ms"


def run_requests(server, client, until):
    """Each kind of request in turn; events are said to a session of their own."""
    run = client.get("/api/runs").must()["runs"][0]["id"]
    session = client.begin(clock="events", physics=False, scene="place_setting")["id"]
    paths = ["/", "/api/runs", "/api/sessions", f"/api/sessions/{session}", "/api/schema", f"/api/diff?a={run}&b={run}",
             *(f"/api/runs/{run}{view}" for view in VIEWS), "/api/nothing", "/no%20page"]
    asks = {path: lambda path=path: client.get(path) for path in paths}
    pointing = {"kind": "pointing", "hand": "left", "target": [0.2, 0]}
    asks["events"] = lambda: client.post(f"/api/sessions/{session}/events", pointing)
    times, answers = {name: [] for name in asks}, {}
    while time.monotonic() < until and len(times["events"]) < REQUESTS:
        for name, ask in asks.items():
            begun = time.monotonic()
            status = ask().status
            times[name].append(time.monotonic() - begun)
            if answers.setdefault(name, status) != status:
                raise AssertionError(f"{name} is answered by {answers[name]}, and then by {status}")
    client.end(session)
    slowest = max(times, key=lambda name: p99_s(times[name]))
    everything = [t for some in times.values() for t in some]
    return (f"{len(times['events'])} requests of each of {len(asks)} kinds: {in_ms(everything)};"
            f" the slowest kind, {slowest.replace(run, 'RUN')}: {in_ms(times[slowest])}")


def run_slow(server, client, until):
    """Connections that ask and do not read, and others that say nothing. Others ask beside them and without them in
    turn, equally often."""
    quiet, beside = [], []
    while time.monotonic() < until:
        quiet += times_s(client)
        slow = [socket.create_connection((server.host, server.port)) for _ in range(SLOW)]
        for one in slow[::2]:
            one.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
        beside += times_s(client)
        for one in slow:
            one.close()
    told = f"p99 of {len(beside)} requests beside them {p99_s(beside) * 1000:.1f} ms, quiet {p99_s(quiet) * 1000:.1f} ms"
    if p99_s(beside) > max(2 * p99_s(quiet), SOME_TIME_S):
        raise AssertionError(f"{SLOW} slow connections at a time: {told}")
    return f"{SLOW} slow connections at a time, {told}"


PARTS = {"long": run_long, "wall": run_wall, "sessions": run_sessions, "viewers": run_viewers, "requests": run_requests,
         "slow": run_slow}


def soak(program, part, seconds):
    """A row, and whether nothing grew."""
    with tempfile.TemporaryDirectory() as folder, Server(program, folder, environment=GIVES_BACK) as server:
        client = server.client()
        run_sessions(server, client, time.monotonic() + seconds, FIRST)  # what is made once
        for run in client.get("/api/runs").must()["runs"]:  # more than the server keeps open
            for view in VIEWS:
                client.get(f"/api/runs/{run['id']}{view}")
        before = held(server.pid)
        did = PARTS[part](server, client, time.monotonic() + seconds)
        time.sleep(12)  # connections that are left over are hung up on
        after = held(server.pid)
    more = [now - then for now, then in zip(after, before)]
    flat = all(now <= most for now, most in zip(more, (MOST_MORE_THREADS, MOST_MORE_FILES, MOST_MORE_MB)))
    columns = [f"{then:.4g}, {now:.4g}" for then, now in zip(before, after)]
    return f"| {part} | {did} | {' | '.join(columns)} MB |", flat


def main(program, minutes="10", *parts):
    program, failed = pathlib.Path(program).resolve(), False
    parts = parts or tuple(PARTS)
    print("| part | load | threads before, after | files | memory |\n| --- | --- | --- | --- | --- |", flush=True)
    for part in parts:
        try:
            row, flat = soak(program, part, 60 * float(minutes) / len(parts))
        except AssertionError as problem:
            row, flat = f"| {part} | {problem} | | | |", False
        print(row, flush=True)
        failed = failed or not flat
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
