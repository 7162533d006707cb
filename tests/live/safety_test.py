#!/usr/bin/env python3
"""What a server of live sessions refuses, each with the right status and without a trace of it in the session; and
that it goes on answering, and ends at once, whatever hangs on its port.

safety_test.py PROGRAM
"""
import contextlib
import http.client
import json
import pathlib
import signal
import socket
import sys
import tempfile
import threading
import time
import typing

from live_server import Server, run_of

GOOD = {"kind": "speech", "text": "Yes."}
MIB = 1 << 20
MOST_SESSIONS, CONNECTIONS = 8, 200
MOST_EVENTS_A_SECOND = 2000
ANSWERS_WITHIN_S, ENDS_WITHIN_S = 30, 3


class Case(typing.NamedTuple):
    about: str
    status: int
    body: object = GOOD  # text and bytes as they are, anything else as JSON
    path: str = "/api/sessions/{id}/events?recorder=secret"
    method: str = "POST"
    headers: dict = {}


def deep(levels):
    return '{"kind":"speech","text":"Yes.","extra":' + "[" * levels + "]" * levels + "}"


def pointing(x):
    return f'{{"kind":"pointing","target":[{x},0]}}'


SESSIONS, TEN_MB = "/api/sessions", "a name of 10 MB"
MAY_HANG_UP = (TEN_MB,)  # before all of it was sent
EVENTS = [
    Case("a page from elsewhere", 403, headers={"Origin": "http://elsewhere.example"}),
    Case("a page without an origin", 403, headers={"Origin": "null"}),
    Case("another name that points here", 403, headers={"Host": "elsewhere.example"}),
    Case("a body over 1 MiB", 413, {"kind": "speech", "text": "a" * MIB}),
    Case(TEN_MB, 413, {"kind": "gesture", "name": "a" * 10 * MIB}),
    Case("nothing", 400, ""),
    Case("no JSON", 400, "Yes."),
    Case("JSON that is cut short", 400, json.dumps(GOOD)[:-1]),
    Case("JSON with more behind it", 400, json.dumps(GOOD) + "}"),
    Case("two events, the second cut short", 400, f'[{json.dumps(GOOD)},{{"kind":"spe'),
    Case("two lines, the second cut short", 400, f'{json.dumps(GOOD)}\n{{"kind":"spe'),
    Case("a number", 400, "7"),
    Case("text", 400, '"Yes."'),
    Case("null", 400, "null"),
    Case("a list of numbers", 400, [1, 2]),
    Case("bytes that are not UTF-8", 400, b'{"kind":"speech","text":"\xff\xfe"}'),
    Case("half a surrogate pair", 400, '{"kind":"speech","text":"\\ud800"}'),
    Case("values 100,000 levels deep", 400, deep(100_000)),
    Case("values 201 levels deep", 400, deep(201)),
    Case("an unknown kind", 400, {"kind": "smell", "name": "rose"}),
    Case("no kind", 400, {"text": "Yes."}),
    Case("a kind that is no text", 400, {"kind": 7}),
    Case("a header", 400, {"kind": "trace", "version": 1}),
    Case("speech without words", 400, {"kind": "speech"}),
    Case("a gesture without a name", 400, {"kind": "gesture", "phase": "stroke"}),
    Case("a gesture in an unknown phase", 400, {"kind": "gesture", "name": "posack", "phase": "later"}),
    Case("pointing at nothing", 400, {"kind": "pointing", "hand": "left"}),
    Case("a third hand", 400, {"kind": "pointing", "hand": "middle", "target": [0, 0]}),
    Case("a ray without direction", 400, {"kind": "pointing", "ray": {"from": [0, 0, 1], "direction": [0, 0, 0]}}),
    Case("the coordinate NaN", 400, pointing("NaN")),
    Case("the coordinate Infinity", 400, pointing("Infinity")),
    Case("the coordinate 1e400", 400, pointing("1e400")),
    Case("the coordinate 1e300", 400, pointing("1e300")),
    Case("a coordinate that is text", 400, pointing('"1"')),
    Case("a coordinate too many", 400, {"kind": "gesture", "name": "point", "target": [0, 0, 0]}),
    Case("confidence 7", 400, GOOD | {"confidence": 7}),
    Case("confidence -1", 400, GOOD | {"confidence": -1}),
    Case("a time below 0", 400, GOOD | {"t": -1}),
    Case("a time beyond all", 400, GOOD | {"t": 1e10}),
    Case("a time that is text", 400, GOOD | {"t": "now"}),
    Case("an end before the beginning", 400, GOOD | {"t": 5, "until": 4}),
    Case("a good event and a bad one", 400, [GOOD, {"kind": "speech"}]),
    Case("a session that nobody knows", 404, path="/api/sessions/nobody/events"),
    Case("another recorder", 409, path="/api/sessions/{id}/events?recorder=guess"),
    Case("no recorder", 409, path="/api/sessions/{id}/events"),
    Case("another recorder's pause", 409, {"paused": True}, path="/api/sessions/{id}/pause?recorder=guess"),
    Case("another recorder's end", 409, {}, path="/api/sessions/{id}/end?recorder=guess"),
    Case("a pause that is neither", 400, {"paused": "perhaps"}, path="/api/sessions/{id}/pause?recorder=secret"),
    *(Case(f"GET on {what}", 405, method="GET", body=None, path=f"/api/sessions/{{id}}/{what}")
      for what in ("events", "pause", "end", "save")),
    *(Case(f"{method} on a session", 405, method=method, path="/api/sessions/{id}") for method in ("PUT", "DELETE")),
    *(Case(f"a test's name {name[:20]!r}", 400, {"name": name}, path="/api/sessions/{id}/save")
      for name in ("../../etc/passwd", "/etc/passwd", "..", "", "a b", "a\0b", "ä", "a" * 10_000)),
    *(Case(f"a session's {what} {value!r}", 400, {what: value}, path=SESSIONS)
      for what in ("name", "scene", "machine") for value in ("../../etc/passwd", "/etc/passwd", "..", 7)),
    Case("an unknown machine", 400, {"machine": "perpetual_motion"}, path=SESSIONS),
    Case("an unknown scene", 400, {"scene": "moon"}, path=SESSIONS),
    Case("an unknown clock", 400, {"clock": "sundial"}, path=SESSIONS),
    Case("a speed of 0", 400, {"clock": "wall", "speed": 0}, path=SESSIONS),
    Case("a speed below 0", 400, {"clock": "wall", "speed": -1}, path=SESSIONS),
    Case("a speed of 1e300", 400, {"clock": "wall", "speed": 1e300}, path=SESSIONS),
    Case("a session that is no object", 400, [], path=SESSIONS),
    Case("a session from elsewhere", 403, {}, path=SESSIONS, headers={"Origin": "http://elsewhere.example"}),
    Case("an object that is not in the scene", 400, {"objects": {"unicorn": {"position": [0, 0, 0]}}}, path=SESSIONS),
    Case("an object beyond the table", 400, {"objects": {"cup": {"position": [1e300, 0, 0]}}}, path=SESSIONS),
    Case("a stream of nobody's session", 404, method="GET", body=None, path="/api/live?session=nobody"),
    Case("a stream from nowhere", 400, method="GET", body=None, path="/api/live?session={id}&after=nowhere"),
]


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
    for case in EVENTS:
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


def check_wall_clock(server):
    """Under a wall clock what is yet to happen cannot have been seen."""
    client = server.client()
    session = client.begin(clock="wall", physics=False)
    path = f"/api/sessions/{session['id']}/events"
    status = client.post(path, GOOD | {"t": session["t"] + 60}).status
    if status != 400:
        yield f"an event of the far future: {status} instead of 400"
    client.end(session["id"])


def check_flood(server, folder):
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
        yield f"{sent} events in {time.monotonic() - begun:.1f} s were all taken; expected 429"
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


def check_too_many(server):
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


def check_by_hand(server):
    here = f"Host: {server.host}:{server.port}\r\n".encode()
    for about, text, expected in [
            ("HTTP/1.0", b"GET /api/sessions HTTP/1.0\r\n" + here + b"\r\n", "200"),
            ("HTTP/1.0 that hides where it goes", b"GET /api/sessions HTTP/1.0\r\n\r\n", "403"),
            ("no HTTP at all", b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n", "400"),
            ("a body of an unlikely length", b"POST /api/sessions HTTP/1.1\r\n" + here +
             b"Content-Length: 99999999999999999999\r\n\r\n", "4"),
            ("a header without an end", b"GET /api/sessions HTTP/1.1\r\n" + here + b"X: " + b"x" * MIB, "4")]:
        with contextlib.suppress(ConnectionError):  # hanging up is an answer too
            line = said_by_hand(server, text)
            if line and not line.split(" ", 1)[1].startswith(expected):
                yield f"{about}: {line.strip()!r} instead of {expected}"


def check_crowd(server):
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
    answers = []
    threads = [threading.Thread(target=lambda: answers.append(server.client().get("/api/sessions").status))
               for _ in range(CONNECTIONS)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if answers != [200] * CONNECTIONS:
        yield f"of {CONNECTIONS} that asked at once, {answers.count(200)} were answered"


def check_end(server):
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


def main(program):
    with tempfile.TemporaryDirectory() as folder, Server(pathlib.Path(program).resolve(), folder) as server:
        failures = [*check_refusals(server, folder), *check_wall_clock(server), *check_flood(server, folder),
                    *check_too_many(server), *check_by_hand(server), *check_crowd(server), *check_end(server)]
    print(*failures, sep="\n", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
