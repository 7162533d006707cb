"""Requests that a live session must refuse: a table, for safety_test.py."""
import json
import typing

GOOD = {"kind": "speech", "text": "Yes."}
MIB = 1 << 20


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


SESSIONS = "/api/sessions"
MAY_HANG_UP = TOO_LONG, TEN_MB = "a body over 1 MiB", "a name of 10 MB"  # before all of it was sent
REFUSALS = [
    Case("a page from elsewhere", 403, headers={"Origin": "http://elsewhere.example"}),
    Case("a page without an origin", 403, headers={"Origin": "null"}),
    Case("another name that points here", 403, headers={"Host": "elsewhere.example"}),
    Case(TOO_LONG, 413, {"kind": "speech", "text": "a" * MIB}),
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
    Case("an object that is not in the scene", 422, {"objects": {"unicorn": {"position": [0, 0, 0]}}}, path=SESSIONS),
    Case("an object beyond the table", 400, {"objects": {"cup": {"position": [1e300, 0, 0]}}}, path=SESSIONS),
    Case("a stream of nobody's session", 404, method="GET", body=None, path="/api/live?session=nobody"),
]
