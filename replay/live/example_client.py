#!/usr/bin/env python3
"""Streams events into a live session of Continua and prints what the avatar does.

Shows how a recogniser of speech, gestures or pointing is connected: make a session, send each event when it happens,
read the avatar's moves in the answer. Events are JSON objects, one a line, as traces/FORMAT.md describes them; a
recogniser leaves `t` out, since the engine takes the time of arrival. A trace will do as well: its header starts the
session, its events are sent at their times, what it observed or expected is left out.

    continua serve runs --port 8080 &
    replay/live/example_client.py traces/paper/correction.trace.jsonl --speed 10
    my_recogniser | replay/live/example_client.py --clock wall --scene place_setting
"""
import argparse
import http.client
import itertools
import json
import secrets
import sys
import time
import urllib.parse

# The server closes a connection that nothing was asked on for two seconds.
QUIET_S = 1
NOT_SENT = ("observed", "expect")
EXAMPLE = '{"kind": "speech", "text": "The plate."}'
HEADER_FIELDS = ("scene", "machine", "seed", "perspective", "objects")


class LiveSession:
    """A session on a server that `address` names, and the one connection that asks for it."""

    def __init__(self, address, wishes):
        # Opening a connection for each event would cost more than the event.
        self.connection = http.client.HTTPConnection(urllib.parse.urlsplit(address).netloc, timeout=60)
        self.used = 0
        # Nobody else can send events into a session that was made with a secret.
        self.secret = secrets.token_hex(8)
        self.path = "/api/sessions/" + self.ask("/api/sessions", wishes | {"recorder": self.secret})["id"]

    def send(self, event):
        """What the avatar did because of it."""
        return self.ask(f"{self.path}/events?recorder={self.secret}", event)["moves"]

    def end(self):
        """What became of the session: among others its `trace` and the name of its `run`."""
        return self.ask(f"{self.path}/end?recorder={self.secret}", {})

    def ask(self, path, body):
        while True:
            if time.monotonic() - self.used > QUIET_S:
                self.connection.close()  # the next request opens it anew
            self.connection.request("POST", path, json.dumps(body), {"Content-Type": "application/json"})
            response = self.connection.getresponse()
            answer = json.loads(response.read())
            self.used = time.monotonic()
            if response.status < 400:
                return answer
            if response.status != 429:
                sys.exit(f"{response.status}: {answer['error']['message']}")
            # Too many events a second: the server says how long to wait.
            time.sleep(float(response.headers["Retry-After"]))


def told(move):
    """One of the avatar's moves in words."""
    if move["kind"] == "utterance":
        return f"says “{move['text']}”"
    if move["kind"] == "gesture":
        return f"gestures {move['gesture']}"
    return f"act {move['act']}, {move['program']}: {move['status']}"


def events_of(lines):
    for number, line in enumerate(lines, 1):
        if not line.strip():
            continue
        try:
            event = json.loads(line)
        except ValueError:
            event = None
        if not isinstance(event, dict) or "kind" not in event:
            sys.exit(f"line {number} is no event; expected one such as {EXAMPLE}")
        yield event


def wishes_of(header, options):
    """What the session is to be: as the options say, or else the trace's header."""
    wishes = {name: header[name] for name in HEADER_FIELDS if name in header}
    wishes |= {name: value for name in ("scene", "machine", "name") if (value := getattr(options, name))}
    wishes |= {"physics": options.physics, "clock": options.clock}
    return wishes | ({"speed": options.speed} if options.clock == "wall" else {})


def stream(events, options):
    """Sends them, each at its time if it has one, and tells the avatar's moves."""
    first = next(events, {"kind": "trace"})
    is_header = first["kind"] == "trace"
    session = LiveSession(options.server, wishes_of(first if is_header else {}, options))
    begun = time.monotonic()
    for event in events if is_header else itertools.chain([first], events):
        if event["kind"] in NOT_SENT:
            continue
        if "t" in event and options.speed:
            time.sleep(max(0, begun + event["t"] / options.speed - time.monotonic()))
        for move in session.send(event):
            print(f"{move['t']:8.2f}  {told(move)}", flush=True)
    return session.end()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("events", nargs="?", default="-", help="a file of events, such as a trace; - is standard input")
    parser.add_argument("--server", default="http://127.0.0.1:8080", help="where continua listens (%(default)s)")
    parser.add_argument("--speed", type=float, default=1, help="times as fast as it happened; 0: as fast as possible")
    parser.add_argument("--clock", choices=["events", "wall"], default="events",
                        help="what the engine's time follows: the events' own times, or this machine's clock")
    parser.add_argument("--no-physics", dest="physics", action="store_false", help="acts succeed at once")
    for name in ("scene", "machine"):
        parser.add_argument(f"--{name}", help=f"otherwise the {name} of the trace, or the server's")
    parser.add_argument("--name", help="of the session's files")
    options = parser.parse_args()
    if options.speed < 0 or (options.speed == 0 and options.clock == "wall"):
        parser.error("--speed must be above 0, or 0 with --clock events")
    try:
        with sys.stdin if options.events == "-" else open(options.events, encoding="utf-8-sig") as lines:
            ended = stream(events_of(lines), options)
    except ConnectionRefusedError:
        sys.exit(f"nobody listens at {options.server}; start `continua serve` first, or say --server")
    except OSError as error:
        sys.exit(str(error))
    print(f"trace {ended['trace']}\nrun   {options.server.rstrip('/')}/r/{ended['run']}")


if __name__ == "__main__":
    main()
