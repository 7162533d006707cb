#!/usr/bin/env python3
"""Requests that are no honest requests: bodies that look like requests, bodies and heads that take memory, connections
that are slow. Nothing of them may be carried out, memory stays, and others are answered as if they were not there.

guard_test.py PROGRAM
"""
import contextlib
import multiprocessing
import pathlib
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import zlib

from live_server import Server

MIB = 1 << 20
PATIENCE_S = 30
MOST_MORE_MIB = 40         # that a server may take for a request it refuses
SLOW, ASKED = 200, 1000    # connections; requests beside them
LEAST_NOTICED_S = 0.01     # a delay below which two cores do what they like
BURST, MOST_WAIT_S = 128, 1.0


def rss_mib(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmHWM"):
            return int(line.split()[1]) / 1024
    raise RuntimeError("the server has ended")


def connected(server):
    return socket.create_connection((server.host, server.port), timeout=PATIENCE_S)


def answers(connection):
    """All that the server says until it hangs up, or says nothing for a second."""
    said = b""
    connection.settimeout(1.5)
    with contextlib.suppress(OSError):
        while part := connection.recv(65536):
            said += part
    return said


def said_to(server, *parts, pause_s=0.0):
    with connected(server) as connection:
        with contextlib.suppress(OSError):
            for part in parts:
                connection.sendall(part)
                time.sleep(pause_s)
        return answers(connection)


def sessions(server):
    return server.client().get("/api/sessions").must()["sessions"]


def check_smuggled(server):
    """A body that nobody reads must not be taken for the next request."""
    host = f"Host: {server.host}:{server.port}\r\n"
    inner = f"POST /api/sessions HTTP/1.1\r\n{host}Content-Length: 2\r\n\r\n{{}}".encode()
    evil = "Origin: http://elsewhere.example\r\n"
    multipart = "Content-Type: multipart/form-data\r\n"
    kinds = {
        "multipart without a boundary": ("POST /api/sessions", evil + multipart),
        "multipart, the right origin": ("POST /api/sessions", multipart),
        "too long an address": ("POST /" + "a" * 9000, evil),
        "a range that is none": ("POST /api/sessions", evil + "Range: bytes=x\r\n"),
        "an unknown method": ("BREW /api/sessions", evil),
        "OPTIONS": ("OPTIONS /api/sessions", evil),
        "HEAD": ("HEAD /api/sessions", evil),
        "GET": ("GET /nothing", evil),
        "GET without an origin": ("GET /nothing", ""),
        "GET of another host": ("GET /nothing", "Host: elsewhere.example\r\n"),
        "DELETE": ("DELETE /api/sessions", evil),
        "PATCH": ("PATCH /api/sessions", evil),
        "an expectation": ("POST /api/sessions", evil + "Expect: 100-continue\r\n"),
        "two lengths": ("POST /api/sessions", "Content-Length: 0\r\n"),
        "a length and chunks": ("POST /api/sessions", evil + "Transfer-Encoding: chunked\r\n"),
        "a length with a sign": ("POST /api/sessions", "Content-Length: +0\r\n"),
    }
    before = sessions(server)
    for about, (line, headers) in kinds.items():
        hosts = "" if "Host:" in headers else host
        head = f"{line} HTTP/1.1\r\n{hosts}{headers}Content-Length: {len(inner)}\r\n\r\n".encode()
        for parts in ((head, inner), (head + inner,)):
            said_to(server, *parts, pause_s=0.2)
            if (after := sessions(server)) != before:
                yield f"{about}: a request in the body was carried out"
                before = after


def check_other_hosts(server):
    """Every request says where it goes, and it is here."""
    for head in ("GET /api/runs HTTP/1.1\r\nHost: evil.example\r\n", "GET /api/runs HTTP/1.1\r\n",
                 "HEAD / HTTP/1.1\r\nHost: evil.example\r\n",
                 f"GET /api/runs HTTP/1.1\r\nHost: {server.host}:{server.port}\r\nHost: evil.example\r\n"):
        for length in ("", "Content-Length: 0\r\n", "Content-Length: 00\r\n", "Content-Length: 1\r\n"):
            said = said_to(server, f"{head}{length}Connection: close\r\n\r\n{'x' if '1' in length else ''}".encode())
            if not said.startswith(b"HTTP/1.1 4"):
                yield f"{head + length!r}: {said[:60]!r}"


def check_other_sites(server):
    """A browser says from where a request comes; a page's address may be followed, nothing else be asked for."""
    for headers, expected in [
            ("Sec-Fetch-Site: cross-site\r\n", 403), ("Sec-Fetch-Site: same-site\r\n", 403),
            ("Sec-Fetch-Site: same-origin\r\n", 200), ("Sec-Fetch-Site: none\r\n", 200),
            ("Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\nSec-Fetch-Dest: document\r\n", 200),
            ("Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\nSec-Fetch-Dest: iframe\r\n", 403)]:
        said = said_to(server, f"GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n{headers}\r\n".encode())
        if not said.startswith(f"HTTP/1.1 {expected}".encode()):
            yield f"{headers!r}: {said[:40]!r} instead of {expected}"
        if b"X-Frame-Options: DENY\r\n" not in said:
            yield f"{headers!r}: no X-Frame-Options"


def check_rebinding(server):
    """A name that an attacker lets point to this machine is no name of it, though its page says so in every header."""
    for host in ("evil.example", f"evil.example:{server.port}", f"localhost.evil.example:{server.port}",
                 f"127.0.0.1.evil.example:{server.port}", f"192.168.0.1:{server.port}", "0.0.0.0", "localhost@evil.example"):
        for request in ("GET /api/runs", "POST /api/sessions", "PUT /api/runs/x/notes", "GET /"):
            said = said_to(server, f"{request} HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nSec-Fetch-Site: "
                                   "same-origin\r\nContent-Length: 0\r\nConnection: close\r\n\r\n".encode())
            if not said.startswith(b"HTTP/1.1 403"):
                yield f"{request} for {host}: {said[:40]!r}"


def check_cross_site(server):
    """A page elsewhere can send simple requests without asking: none of them counts."""
    here = f"Host: {server.host}:{server.port}\r\n"
    before = sessions(server)
    for origin in ("http://evil.example", "null", f"https://{server.host}:{server.port}", f"http://{server.host}",
                   f"http://{server.host}:{server.port}.evil.example", "file://", ""):
        for kind in ("text/plain", "application/x-www-form-urlencoded", "application/json"):
            said = said_to(server, f"POST /api/sessions HTTP/1.1\r\n{here}Origin: {origin}\r\nContent-Type: {kind}\r\n"
                                   "Content-Length: 2\r\nConnection: close\r\n\r\n{}".encode())
            if not said.startswith(b"HTTP/1.1 403") or b"Access-Control-Allow" in said:
                yield f"a post of {origin!r} as {kind}: {said[:40]!r}"
    if sessions(server) != before:
        yield "a page elsewhere began a session"


def check_traversal(server):
    """No way of writing '..' leads out of the folder that is served."""
    ups = ("..", "%2e%2e", "%2E.", ".%2e", "%252e%252e", "..%00", "%c0%ae%c0%ae", "%uff0e%uff0e", "....", "..;")
    slashes = ("/", "%2f", "%5c", "\\", "%252f", "//", "%c0%af")
    for up in ups:
        for slash in slashes:
            way = slash.join([up] * 12 + ["etc", "passwd"])
            for path in (f"/{way}", f"/api/runs/{way}", f"/api/media/{way}", f"/api/runs/..{slash}{way}/notes",
                         f"/api/sessions/{way}"):
                said = said_to_end(server, path)
                if b"root:" in said or not said.startswith(b"HTTP/1.1 4"):
                    yield f"{path}: {said[:60]!r}"


def said_to_end(server, path):
    with connected(server) as connection:
        connection.sendall(f"GET {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n".encode())
        said = b""
        with contextlib.suppress(OSError):
            while part := connection.recv(65536):
                said += part
        return said


def endless(head, part, mib):
    yield head
    for _ in range(mib * MIB // len(part)):
        yield part


def check_memory(server):
    """Limits hold for whatever a length does not announce, and before memory is taken."""
    here = f"Host: {server.host}:{server.port}\r\n".encode()
    zeros = zlib.compressobj(9, zlib.DEFLATED, 31)
    bomb = zeros.compress(bytes(200 * MIB)) + zeros.flush()
    post = b"POST /api/sessions HTTP/1.1\r\n" + here
    kilobyte = b"x" * 1024
    for about, expected, parts in [
            ("a packed body", b"415", [post + b"Content-Encoding: gzip\r\nContent-Length: %d\r\n\r\n" % len(bomb), bomb]),
            ("a packed body of another page", b"4", [post + b"Origin: http://elsewhere.example\r\nContent-Encoding: "
                                                     b"gzip\r\nContent-Length: %d\r\n\r\n" % len(bomb), bomb]),
            ("chunks", b"411", endless(post + b"Transfer-Encoding: chunked\r\n\r\n", b"400\r\n" + kilobyte + b"\r\n",
                                       100)),
            ("header lines", b"431", endless(b"GET / HTTP/1.1\r\n" + here, b"X-a: " + kilobyte + b"\r\n", 100)),
            ("a header line", b"431", endless(b"GET / HTTP/1.1\r\n" + here + b"X-a: ", kilobyte, 100)),
            ("short header lines", b"431", endless(b"GET / HTTP/1.1\r\n" + here, b"a: b\r\n" * 100, 100)),
            ("a request line", b"414", endless(b"GET /", kilobyte, 100)),
            ("a body without length", b"", endless(b"PUT /api/runs/x/notes HTTP/1.1\r\n" + here + b"\r\n", kilobyte,
                                                   100)),
            ("a body of 100 MiB", b"413", endless(post + b"Content-Length: %d\r\n\r\n" % (100 * MIB), kilobyte, 100))]:
        before = rss_mib(server.pid)
        said = said_to(server, *parts)
        more = rss_mib(server.pid) - before
        print(f"{about}: {more:.0f} MiB more, {said[:40]!r}")
        if more > MOST_MORE_MIB:
            yield f"{about}: the server took {more:.0f} MiB more"
        if said and not said.startswith(b"HTTP/1.1 " + expected):
            yield f"{about}: {said[:40]!r} instead of {expected.decode()}"


def times_of(server, count):
    """How long each of so many requests takes, each on a connection of its own."""
    times = []
    for _ in range(count):
        begun = time.monotonic()
        with connected(server) as connection:
            connection.sendall(b"GET /api/sessions HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
            while connection.recv(65536):
                pass
        times.append(time.monotonic() - begun)
    return times


def p99(times):
    return statistics.quantiles(times, n=100)[98]


class Dribble(multiprocessing.Process):
    """Connections that send a header line, or a letter of a body, every 1.5 s each. A process of its own, so that
    whoever measures others has nothing to do with it."""

    def __init__(self, server, count):
        super().__init__(daemon=True)
        self.server, self.count = server, count
        self.left = multiprocessing.Value("i", 0)

    def run(self):
        half = b"POST /api/sessions HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100\r\n\r\n"
        still_open = {connected(self.server): b"{" if number % 2 else b"X-a: b\r\n" for number in range(self.count)}
        for connection, more in still_open.items():
            connection.sendall(half if more == b"{" else b"GET / HTTP/1.1\r\n")
            connection.setblocking(False)
        self.left.value = len(still_open)
        while still_open:
            for connection, more in list(still_open.items()):
                try:
                    connection.send(more)
                    if connection.recv(4096):  # an answer: it is too late
                        raise ConnectionError
                except BlockingIOError:
                    pass
                except OSError:
                    del still_open[connection]
                    connection.close()
                time.sleep(1.5 / self.count)
            self.left.value = len(still_open)


def check_slow(server):
    """Two hundred that send a line now and then, or a letter of a body, do not keep others waiting; they are hung up
    on in the end. Other work on the machine is not their fault: the best time beside them is held against the worst
    without them."""
    times_of(server, ASKED)
    quiet = p99(times_of(server, ASKED))
    dribble = Dribble(server, SLOW)
    dribble.start()
    while dribble.left.value < SLOW and dribble.is_alive():
        time.sleep(0.05)
    crowded = min(p99(times_of(server, ASKED)) for _ in range(2))
    left = dribble.left.value
    dribble.join(PATIENCE_S + 5)
    if dribble.is_alive():
        yield f"{dribble.left.value} of {SLOW} slow connections are still open after {PATIENCE_S + 5} s"
        dribble.kill()
    quiet = max(quiet, p99(times_of(server, ASKED)))
    print(f"p99 quiet {quiet * 1000:.1f} ms, beside {left} slow connections {crowded * 1000:.1f} ms")
    if crowded > max(2 * quiet, LEAST_NOTICED_S) or left < SLOW:
        yield f"beside {left} slow connections p99 is {crowded:.3f} s, without {quiet:.3f} s"


def check_slow_readers(server):
    """Two hundred that ask for much and read nothing keep no thread that others need."""
    times_of(server, ASKED)
    quiet = p99(times_of(server, ASKED))
    much = f"GET /style.css HTTP/1.1\r\nHost: {server.host}:{server.port}\r\n\r\n".encode() * 1000
    readers = [socket.socket() for _ in range(SLOW)]
    try:
        for reader in readers:
            reader.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)  # the kernel takes little for them
            reader.connect((server.host, server.port))
            reader.setblocking(False)
            with contextlib.suppress(BlockingIOError):
                reader.send(much)
        crowded = times_of(server, ASKED)
    finally:
        for reader in readers:
            reader.close()
    print(f"p99 quiet {quiet * 1000:.1f} ms, beside {SLOW} that do not read {p99(crowded) * 1000:.1f} ms;"
          f" the longest {max(crowded):.2f} s")
    if max(crowded) > MOST_WAIT_S:
        yield f"beside {SLOW} connections that do not read, one waits {max(crowded):.3f} s"


def check_burst(server):
    """So many at once wait for each other, not for the kernel to try again after a second."""
    times, ready = [], threading.Barrier(BURST)

    def ask():
        ready.wait()
        times.extend(times_of(server, 1))

    threads = [threading.Thread(target=ask) for _ in range(BURST)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    print(f"{BURST} at once: p50 {statistics.median(times) * 1000:.0f} ms, max {max(times) * 1000:.0f} ms")
    if len(times) < BURST or max(times) > MOST_WAIT_S:
        yield f"{BURST} at once: {len(times)} answered, the last after {max(times):.2f} s"


def check_pipelined(server):
    """Requests in one packet are all answered, in their order."""
    one = b"GET /api/sessions HTTP/1.1\r\nHost: localhost\r\n\r\n"
    last = b"GET /nothing HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n"
    said = said_to(server, one * 3 + last)
    if said.count(b"HTTP/1.1 200") != 3 or said.count(b"HTTP/1.1 404") != 1:
        yield f"of four requests in a packet: {said.count(b'HTTP/1.1')} answers"


def check_ranges(server):
    """Parts of an answer are not served: a request for one gets the whole."""
    said = said_to(server, b"GET / HTTP/1.1\r\nHost: localhost\r\nRange: bytes=0-,0-\r\nConnection: close\r\n\r\n")
    if not said.startswith(b"HTTP/1.1 200"):
        yield f"a range: {said[:60]!r}"


def check_token(program):
    """Another address than loopback is for those who have the token."""
    with tempfile.TemporaryDirectory() as folder, \
            Server(program, folder, "--bind", "0.0.0.0", "--token", "sesame-0123456789") as server:
        def status(path, headers=""):
            return said_to(server, f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n{headers}\r\n"
                           .encode())
        for about, path, headers, expected in [
                ("no token", "/api/runs", "", b"401"), ("the page without token", "/", "", b"401"),
                ("a wrong token", "/api/runs?token=sesame-012345678", "", b"401"),
                ("a wrong bearer", "/api/runs", "Authorization: Bearer sesame-01234567890\r\n", b"401"),
                ("the bearer", "/api/runs", "Authorization: Bearer sesame-0123456789\r\n", b"200"),
                ("the token in the address", "/?token=sesame-0123456789", "", b"303")]:
            said = status(path, headers)
            if not said.startswith(b"HTTP/1.1 " + expected):
                yield f"{about}: {said[:40]!r} instead of {expected.decode()}"
        said = status("/live?a=b&token=sesame-0123456789&c=d").decode()
        cookie = next((line for line in said.split("\r\n") if line.startswith("Set-Cookie: ")), "")
        if "Location: /live?a=b&c=d\r\n" not in said or "HttpOnly" not in cookie or "SameSite" not in cookie:
            yield f"the token is not kept as a cookie: {said[:300]!r}"
        said = status("/api/runs", f"Cookie: other=1; {cookie.removeprefix('Set-Cookie: ').split(';')[0]}\r\n")
        if not said.startswith(b"HTTP/1.1 200"):
            yield f"the cookie is not taken: {said[:60]!r}"
    with tempfile.TemporaryDirectory() as folder, Server(program, folder, "--bind", "0.0.0.0") as server:
        if "token=" not in server.said or "warning" not in server.said:
            yield f"no token was made for another address, or no warning given: {server.said!r}"


def check_two_servers(program):
    """A second server on a port is refused; the next free one is named."""
    with tempfile.TemporaryDirectory() as folder, Server(program, folder) as server:
        second = subprocess.run([program, "serve", folder, "--port", str(server.port)], capture_output=True, text=True,
                                timeout=PATIENCE_S, check=False, stdin=subprocess.DEVNULL)
        if second.returncode != 2 or "--port " not in second.stderr:
            yield f"a second server on the port: {second.returncode}, {second.stderr!r}"


BESIDE = (check_smuggled, check_other_hosts, check_other_sites, check_memory, check_pipelined, check_ranges,
          check_rebinding, check_cross_site, check_traversal,
          check_burst, check_slow, check_slow_readers)


def main(program, *names):
    program, failed = pathlib.Path(program).resolve(), False
    with tempfile.TemporaryDirectory() as folder, Server(program, folder) as server:
        for check in (*BESIDE, check_token, check_two_servers):
            if names and check.__name__ not in names:
                continue
            try:
                for problem in check(server if check in BESIDE else program):
                    failed = True
                    print(f"{check.__name__}: {problem}", file=sys.stderr, flush=True)
            except (AssertionError, OSError, RuntimeError) as error:
                failed = True
                print(f"{check.__name__}: {error!r}", file=sys.stderr, flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
