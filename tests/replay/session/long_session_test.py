#!/usr/bin/env python3
"""A session that goes on and on costs by what happens in it, not by how long it has been going on.

long_session_test.py PROGRAM TRACE

The trace is replayed without physics, told a few times in a row and eight times as often. The longer run may take at most a
fifth more memory; none of its records may be longer, name more records that it came of, or have a deeper stack.
Nothing is timed.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

FEW, TIMES, MOST_MEMORY = 10, 8, 1.2
PAUSE_S = 20  # so that nothing of one time is under way in the next


def repeated(trace, times, path):
    header, *events = [json.loads(line) for line in trace.read_text(encoding="utf-8").splitlines()]
    events = [event for event in events if event["kind"] not in ("end", "expect")]
    length = events[-1]["t"] + PAUSE_S
    with open(path, "w", encoding="utf-8") as file:
        print(json.dumps(header), file=file)
        for number in range(times):
            for event in events:
                times_of_it = {key: round(event[key] + number * length, 6) for key in ("t", "until") if key in event}
                print(json.dumps({**event, **times_of_it}), file=file)


def replayed(program, trace, run):
    """The most memory that the replay took, in kilobytes."""
    process = subprocess.Popen([program, "replay", trace, "--no-physics", "-o", run], stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"the replay of {trace} ended with {os.waitstatus_to_exitcode(status)}")
    return used.ru_maxrss


def largest(run):
    """Of the records after the header and before the last line."""
    most = {"bytes of a record": 0, "sources of a record": 0, "symbols on the stack": 0}
    lines = pathlib.Path(run).read_text(encoding="utf-8").splitlines()[1:-1]
    for line in lines:
        record = json.loads(line)
        for name, size in (("bytes of a record", len(line)), ("sources of a record", len(record.get("because", []))),
                           ("symbols on the stack", record.get("depth", 0))):
            most[name] = max(most[name], size)
    return most, len(lines)


def main(program, trace):
    with tempfile.TemporaryDirectory() as folder:
        told = {}
        for times in (FEW, FEW * TIMES):
            path, run = f"{folder}/{times}.trace.jsonl", f"{folder}/{times}.run.jsonl"
            repeated(pathlib.Path(trace), times, path)
            told[times] = (replayed(program, path, run), *largest(run))
    (memory, most, records), (memory_long, most_long, records_long) = told.values()
    faults = [f"{name}: {most_long[name]}, {TIMES} times shorter {most[name]}"
              # Times and numbers of records have more digits.
              for name in most if most_long[name] > most[name] + (40 if name.startswith("bytes") else 0)]
    if memory_long > MOST_MEMORY * memory:
        faults.append(f"{memory_long} kB of memory, {TIMES} times shorter {memory}")
    if records_long < 0.9 * TIMES * records:
        faults.append(f"{records_long} records, {TIMES} times shorter {records}: the session has not gone on")
    print(*faults, f"{memory} and {memory_long} kB, {records} and {records_long} records, {most_long}", sep="\n")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
