#!/usr/bin/env python3
"""Live sessions while the Nth call to the file system fails: no space, an error of the disk, a short write, a signal, a
kill. Acknowledged events are in the trace; trace and log end with a whole line unless the program was killed; a session
that cannot go on tells its viewers, and the server then rests and ends as always.

faults_test.py PROGRAM FAILING_FILES [--all]

FAILING_FILES is tests/support/failing_files.cpp as a library. With --all each of the first calls fails in every way.
"""
import concurrent.futures
import http.client
import os
import pathlib
import sys
import tempfile
import time

from live_server import Server, Stream, records, run_of, whole_lines

WAYS = ("nospace", "kill", "io", "short", "interrupt")
EVENTS, CALLS = 6, 120   # of a session; of which a session makes more
FEW = (1, 2, 7, 30, 61, 94)
RESTS_S, MOST_WORK_S = 1.0, 0.2
TOLD_WITHIN_S = 20


def work_s(pid):
    """Time of a processor that a program has taken."""
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def talk(client, session):
    """How many events were acknowledged until the session, or the server, broke off."""
    for number in range(EVENTS):
        try:
            answer = client.post(f"/api/sessions/{session}/events",
                                 {"t": number + 1, "kind": "speech", "text": f"The plate. {number}"})
        except (OSError, http.client.HTTPException):
            return number
        if answer.status != 200:
            return number
    return EVENTS


def faults_of_server(server, stream):
    if not stream.over.wait(TOLD_WITHIN_S) or not any(event == "ended" for event, _ in stream.events):
        yield "viewers are not told of the end"
    before = work_s(server.pid)
    time.sleep(RESTS_S)
    if (work := work_s(server.pid) - before) > MOST_WORK_S:
        yield f"the server works on for {work:.2f} s in {RESTS_S} s"
    server.stop()
    if server.process.returncode != 0:
        yield f"the server ended with {server.process.returncode}"


def check(program, library, plan, *options):
    way = plan.partition(":")[2]
    with tempfile.TemporaryDirectory() as folder, Server(
            program, folder, *options, environment={"LD_PRELOAD": library, "CONTINUA_FAIL": plan}) as server:
        client = server.client()
        trace, acknowledged = pathlib.Path(folder, "session.trace.jsonl"), 0
        try:
            begun = client.post("/api/sessions", {"clock": "events", "physics": False, "scene": "place_setting"})
            if begun.status == 201:
                stream = Stream(server, begun.json["id"])
                acknowledged = talk(client, begun.json["id"])
                if acknowledged < EVENTS and way != "kill":
                    yield from faults_of_server(server, stream)
            elif trace.exists():
                yield "a session that could not be begun left a trace"
        except (OSError, http.client.HTTPException):
            if way != "kill":
                yield "the server hung up"
        if server.process.poll() is None:
            server.stop()
        if not trace.exists():
            return
        said = [record["text"] for record in records(trace) if record["kind"] == "speech"]
        if said[:acknowledged] != [f"The plate. {number}" for number in range(acknowledged)]:
            yield f"of {acknowledged} acknowledged events {len(said)} are in the trace"
        for path in (trace, run_of(trace)):
            if way != "kill" and path.exists() and b"".join(line + b"\n" for line in whole_lines(path)) != path.read_bytes():
                yield f"{path.name} ends in the midst of a line"


def main(program, library, *more):
    program, library = (str(pathlib.Path(path).resolve()) for path in (program, library))
    cases = [(f"{number}:{way}", options) for number in (range(1, CALLS) if more else FEW)
             for way in (WAYS if more else (WAYS[number % len(WAYS)],)) for options in ((), ("--durable",))]
    if not more:
        cases = cases[::2] + cases[-1:]
    failed = False
    with concurrent.futures.ThreadPoolExecutor(4) as side_by_side:
        for (plan, options), problems in zip(cases, side_by_side.map(
                lambda case: list(check(program, library, case[0], *case[1])), cases)):
            for problem in problems:
                failed = True
                print(f"{plan} {' '.join(options)}: {problem}", file=sys.stderr, flush=True)
    print(f"{len(cases)} sessions with a fault each")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
