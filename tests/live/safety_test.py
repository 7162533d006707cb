#!/usr/bin/env python3
"""What a server of live sessions refuses, each with the right status and without a trace of it in the session; and
that it goes on answering, and ends at once, whatever hangs on its port.

safety_test.py PROGRAM
"""
import concurrent.futures
import contextlib
import http.client
import pathlib
import signal
import socket
import sys
import tempfile
import time

from live_server import Server, run_of
from refusals import GOOD, MAY_HANG_UP, MIB, REFUSALS

MOST_SESSIONS, CONNECTIONS = 8, 200
MOST_EVENTS_AT_ONCE, MOST_EVENTS_A_SECOND = 4000, 2000
ANSWERS_WITHIN_S, ENDS_WITHIN_S = 30, 3


def asked(client, case, session):
    try:
        return client.ask(case.method, case.path.format(id=session), case.body, headers=case.headers)
    except (http.client.HTTPException, OSError) as error:
        return error


class Session:
    """A live session whose time stands still, and all that could have changed of it."""

    def __init__(self, server, folder, **wishes):
        self.client, self.folder = server.client(), pathlib.Path(folder)
        self.state = self.client.begin(clock="events", physics=False, **wishes)
        self.id = self.state["id"]
        self.trace = self.folder / self.state["trace"]

    def now(self):
        files = sorted(path.relative_to(self.folder) for path in self.folder.rglob("*"))
        sessions = [(one["id"], one["t"], one["live"], one["paused"]) for one in
                    self.client.get("/api/sessions").must()["sessions"]]
        return self.trace.read_bytes(), run_of(self.trace).read_bytes(), files, sorted(sessions)


def check_refusals(server, folder):
    client = server.client()
    session = Session(server, folder, scene="place_setting", machine="interaction", recorder="secret")
    client.post(f"/api/sessions/{session.id}/events?recorder=secret", {"t": 1, **GOOD}).must()
    before = session.now()
    for case in REFUSALS:
        answer = asked(client, case, session.id)
        if isinstance(answer, Exception):
            if case.about not in MAY_HANG_UP:
                yield f"{case.about}: {answer!r} instead of {case.status}"
        elif answer.status != case.status:
            yield f"{case.about}: {answer.status} instead of {case.status}: {answer.body[:200]!r}"
        elif not answer.json["error"]["message"]:
            yield f"{case.about}: no word of what is wrong"
        if (after := session.now()) != before:
            yield f"{case.about}: it has changed the session, or files beside it"
            before = after
    client.post(f"/api/sessions/{session.id}/events?recorder=secret", GOOD).must()
    client.post(f"/api/sessions/{session.id}/end?recorder=secret").must()
    before = session.now()
    status = client.post(f"/api/sessions/{session.id}/events?recorder=secret", GOOD).status
    if status != 409 or session.now() != before:
        yield f"an event after the end: {status} instead of 409, or it changed something"


def check_wall_clock(server, _):
    """Under a wall clock what is yet to happen cannot have been seen."""
    client = server.client()
    session = client.begin(clock="wall", physics=False)
    path = f"/api/sessions/{session['id']}/events"
    status = client.post(path, GOOD | {"t": session["t"] + 60}).status
    if status != 400:
        yield f"an event of the far future: {status} instead of 400"
    client.end(session["id"])


def check_save(server, folder):
    """A test that is there already is not written over."""
    session = Session(server, folder)
    path = f"/api/sessions/{session.id}"
    session.client.post(f"{path}/events", {"t": 1, **GOOD}).must()
    session.client.end(session.id)
    saved = pathlib.Path(folder, session.client.post(f"{path}/save", {"name": "twice"}).must(201)["trace"])
    before, files = saved.read_bytes(), session.now()
    status = session.client.post(f"{path}/save", {"name": "twice"}).status
    if status != 409 or saved.read_bytes() != before or session.now() != files:
        yield f"a test that is there already: {status} instead of 409, or it was changed"


def check_flood(server, folder):
    """However slow the machine, no more is taken than what may come at once and what each second allows again."""
    client = server.client()
    session = Session(server, folder)
    path, batch = f"/api/sessions/{session.id}/events", [GOOD | {"kind": "pointing", "target": [0, 0]}] * 500
    sent = 0
    begun = time.monotonic()
    while sent <= 10 * MOST_EVENTS_A_SECOND:
        before = session.now()
        answer = client.post(path, batch)
        if answer.status == 429:
            break
        answer.must()
        sent += len(batch)
    else:
        taken_s = time.monotonic() - begun
        if sent > MOST_EVENTS_AT_ONCE + MOST_EVENTS_A_SECOND * taken_s:
            yield f"{sent} events in {taken_s:.1f} s were all taken; expected 429"
        else:
            print(f"not flooded: this machine took {taken_s:.1f} s for {sent} events")
        client.end(session.id)
        return
    wait = float(answer.headers.get("Retry-After", "nan"))
    if not 0 < wait <= 10:
        yield f"429 with Retry-After {answer.headers.get('Retry-After')}"
        return
    if session.now() != before:
        yield "the batch that was refused has changed the session"
    time.sleep(wait)
    client.post(path, GOOD).must()
    client.end(session.id)


def check_too_many(server, _):
    client, begun = server.client(), []
    while (answer := client.post("/api/sessions", {"physics": False})).status == 201 and len(begun) <= MOST_SESSIONS:
        begun.append(answer.json["id"])
    if answer.status != 503 or len(begun) != MOST_SESSIONS:
        yield f"session {len(begun) + 1} of at most {MOST_SESSIONS}: {answer.status}"
    for one in begun:
        client.end(one)
    client.end(client.begin(physics=False)["id"])


def said_by_hand(server, text):
    """The first line that answers these bytes."""
    with socket.create_connection((server.host, server.port), timeout=ANSWERS_WITHIN_S) as connection:
        connection.sendall(text)
        return connection.makefile("rb").readline().decode(errors="replace")


def check_by_hand(server, _):
    here = f"Host: {server.host}:{server.port}\r\n".encode()
    for about, text, expected in [
            ("HTTP/1.0", b"GET /api/sessions HTTP/1.0\r\n" + here + b"\r\n", "200"),
            ("HTTP/1.0 that hides where it goes", b"GET /api/sessions HTTP/1.0\r\n\r\n", "403"),
            ("no HTTP at all", b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n", "400"),
            ("a body of more than 1 MiB", b"POST /api/sessions HTTP/1.1\r\n" + here +
             f"Content-Length: {MIB + 1}\r\n\r\n".encode() + b" " * (MIB + 1), "413"),
            ("a body of an unlikely length", b"POST /api/sessions HTTP/1.1\r\n" + here +
             b"Content-Length: 99999999999999999999\r\n\r\n", "4"),
            ("a header without an end", b"GET /api/sessions HTTP/1.1\r\n" + here + b"X: " + b"x" * MIB, "4")]:
        with contextlib.suppress(ConnectionError):  # hanging up is an answer too
            line = said_by_hand(server, text)
            if line and not line.split(" ", 1)[1].startswith(expected):
                yield f"{about}: {line.strip()!r} instead of {expected}"


def check_smuggled(server, _):
    """The body of a refused request must not be taken for the next request, which would have no origin."""
    begin = f"POST /api/sessions HTTP/1.1\r\nHost: {server.host}:{server.port}\r\n"
    inner = f"{begin}Content-Length: 2\r\n\r\n{{}}".encode()
    outer = f"{begin}Origin: http://elsewhere.example\r\nContent-Length: {len(inner)}\r\n\r\n".encode()
    client = server.client()
    before = client.get("/api/sessions").must()["sessions"]
    with socket.create_connection((server.host, server.port), timeout=ANSWERS_WITHIN_S) as connection:
        connection.sendall(outer)
        time.sleep(0.1)
        connection.sendall(inner)
        with contextlib.suppress(OSError):
            while connection.recv(65536):
                pass
    if client.get("/api/sessions").must()["sessions"] != before:
        yield "a request in the body of a refused one was carried out"


def check_crowd(server, _):
    """Two hundred connections that say nothing, or half of something, while others ask."""
    half = f"POST /api/sessions HTTP/1.1\r\nHost: {server.host}:{server.port}\r\nContent-Length: 100\r\n\r\n{{".encode()
    with contextlib.ExitStack() as crowd:
        for number in range(CONNECTIONS):
            one = crowd.enter_context(socket.create_connection((server.host, server.port), timeout=ANSWERS_WITHIN_S))
            if number % 2:
                one.sendall(half)
        begun = time.monotonic()
        server.client().get("/api/sessions").must()
        took = time.monotonic() - begun
        print(f"answered after {took:.2f} s with {CONNECTIONS} connections open")
        if took > ANSWERS_WITHIN_S:
            yield f"{CONNECTIONS} connections kept the server from answering for {took:.1f} s"
    with concurrent.futures.ThreadPoolExecutor(CONNECTIONS) as crowd:
        answered = sum(crowd.map(lambda _: is_answered(server), range(CONNECTIONS)))
    if answered != CONNECTIONS:
        yield f"of {CONNECTIONS} that asked at once, {answered} were answered"


def is_answered(server):
    with contextlib.suppress(OSError, http.client.HTTPException):
        return server.client().get("/api/sessions").status == 200
    return False


def check_end(server, _):
    """It ends at once although a session is live and somebody hangs on the line."""
    client = server.client()
    state = client.begin()
    with socket.create_connection((server.host, server.port)) as half_open:
        half_open.sendall(b"GET /api")
        stream = http.client.HTTPConnection(server.host, server.port)
        stream.request("GET", f"/api/live?session={state['id']}")
        took = server.stop(signal.SIGTERM)
        stream.close()
    print(f"ended after {took:.2f} s")
    if took > ENDS_WITHIN_S:
        yield f"the server ended {took:.1f} s after SIGTERM"


CHECKS = [check_refusals, check_wall_clock, check_save, check_flood, check_too_many, check_by_hand, check_smuggled,
          check_crowd, check_end]


def problems(check, server, folder):
    try:
        yield from check(server, folder)
    except (AssertionError, OSError, http.client.HTTPException) as error:
        yield f"{check.__name__}: {error!r}"


def main(program):
    failed = False
    with tempfile.TemporaryDirectory() as folder, Server(pathlib.Path(program).resolve(), folder) as server:
        for check in CHECKS:
            for problem in problems(check, server, folder):
                failed = True
                print(problem, file=sys.stderr, flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
