"""A server of live sessions for tests: start it, ask it over one connection, listen to its streams."""
import contextlib
import http.client
import json
import os
import pathlib
import re
import signal
import subprocess
import threading
import time

PATIENCE_S = 60  # machines that do much else at the time are slow
QUIET_S = 1      # the server closes a connection that nothing was asked on for two seconds


class Server:
    """`continua serve` in that folder, or another command that serves; ended where its block ends."""

    def __init__(self, program, folder, *arguments, command="serve", environment=None):
        self.process = subprocess.Popen([program, command, *map(str, arguments), "--port", "0"], cwd=folder,
                                        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        text=True, env={**os.environ, **(environment or {})})
        self.said = ""
        while not (found := re.search(r"http://([\d.]+):(\d+)", self.said)):
            line = self.process.stdout.readline()
            if not line:
                raise RuntimeError(f"the server ended: {self.said}")
            self.said += line
        self.address, self.host, self.port = found[0], found[1], int(found[2])
        # A server whose words nobody reads would wait in the end.
        threading.Thread(target=self.process.stdout.read, daemon=True).start()

    @property
    def pid(self):
        return self.process.pid

    def client(self):
        return Client(self.host, self.port)

    def stop(self, how=signal.SIGTERM):
        """How long it took to end, seconds."""
        begun = time.monotonic()
        self.process.send_signal(how)
        self.process.wait(timeout=PATIENCE_S)
        return time.monotonic() - begun

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()


class Answer:
    def __init__(self, status, headers, body):
        self.status, self.headers, self.body = status, headers, body

    @property
    def json(self):
        return json.loads(self.body)

    def must(self, status=200):
        """The answer, if it has that status."""
        if self.status != status:
            raise AssertionError(f"answered {self.status} instead of {status}: {self.body[:300]!r}")
        return self.json


class Client:
    """One connection that is kept; of a thread of its own."""

    def __init__(self, host, port):
        self.connection = http.client.HTTPConnection(host, port, timeout=PATIENCE_S)
        self.used = 0

    def ask(self, method, path, body=None, headers=None):
        if time.monotonic() - self.used > QUIET_S:
            self.connection.close()
        text = body if body is None or isinstance(body, (bytes, str)) else json.dumps(body)
        kind = {} if body is None else {"Content-Type": "application/json"}
        try:
            self.connection.request(method, path, text, kind | (headers or {}))
            response = self.connection.getresponse()
            answer = Answer(response.status, response.headers, response.read())
        except (OSError, http.client.HTTPException):
            self.connection.close()
            raise
        self.used = time.monotonic()
        return answer

    def get(self, path, **more):
        return self.ask("GET", path, **more)

    def post(self, path, body=None, **more):
        return self.ask("POST", path, {} if body is None else body, **more)

    def begin(self, **wishes):
        """The state of a new session."""
        return self.post("/api/sessions", wishes).must(201)

    def send(self, session, events):
        return self.post(f"/api/sessions/{session}/events", events).must()

    def end(self, session):
        return self.post(f"/api/sessions/{session}/end").must()


class Stream:
    """The stream of a session, read by a thread: (event, data) pairs, unless it is long and none is kept."""

    def __init__(self, server, session, heard=None, keeps=True):
        self.heard = heard or (lambda event, data: None)
        self.keeps, self.last = keeps, None
        self.events, self.over = [], threading.Event()
        self.connection = http.client.HTTPConnection(server.host, server.port, timeout=PATIENCE_S)
        self.connection.request("GET", f"/api/live?session={session}", headers={"Accept": "text/event-stream"})
        self.response = self.connection.getresponse()
        if self.response.status != 200:
            raise AssertionError(f"no stream: {self.response.status} {self.response.read()[:300]!r}")
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        event = "message"
        with contextlib.suppress(OSError, http.client.HTTPException, ValueError):
            for line in self.response:
                field, _, value = line.decode().rstrip("\n").partition(": ")
                if field == "event":
                    event = value
                elif field == "data":
                    self.heard(event, value)
                    self.last = event
                    if self.keeps:
                        self.events.append((event, value))
        self.connection.close()
        self.over.set()

    def records(self):
        return [json.loads(data) for event, data in list(self.events) if event == "record"]


def whole_lines(path):
    """The lines of a file that may have been cut short, but for one that has no end."""
    text = pathlib.Path(path).read_bytes()
    return text[:text.rfind(b"\n") + 1].splitlines()


def records(path):
    return [json.loads(line) for line in whole_lines(path)]


def run_of(trace):
    """The run log beside a session's trace."""
    return pathlib.Path(str(trace).removesuffix(".trace.jsonl") + ".run.jsonl")
