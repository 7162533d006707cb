#!/usr/bin/env python3
"""How long `continua diff` takes for two runs of a million records, one of which has an event more, beside `diff -u`.

    tests/bench/bench_diff.py build/continua [records]

The records are those of a real run, over and over, renumbered.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time


def compact(record):
    return json.dumps(record, separators=(",", ":"), ensure_ascii=False) + "\n"


def write_run(records, count, path, added_at=None):
    """`records`: a run's, with its header first. The event added has a number of its own: all after it shift."""
    header, body = records[0], [r for r in records[1:] if r["kind"] not in ("end", "block")]
    duration = body[-1]["t"] + 5
    ids = 1 + max(r["id"] for r in body if r["kind"] == "symbol")
    acts = 1 + max((r["act"] for r in body if r["kind"] == "act"), default=0)
    n, repeat = 1, 0
    with open(path, "w", encoding="utf-8") as file:
        file.write(compact(header))
        for place in range(1, count):
            at = (place - 1) % len(body)
            repeat = (place - 1) // len(body)
            if at == 0:
                numbers = {}
            if place == added_at:
                event = {"kind": "speech", "text": "one event more"}
                file.write(compact({"kind": "input", "n": n, "t": body[at]["t"] + repeat * duration, "line": 1,
                                    "event": event, "symbol": "x"}))
                n += 1
            record = dict(body[at], n=n, t=round(body[at]["t"] + repeat * duration, 6))
            numbers[body[at]["n"]] = n
            if "cause" in record:
                record["cause"] = numbers.get(record["cause"], n - 1)
            if record["kind"] == "symbol":
                record["id"] += repeat * ids
                if record["below"] is not None:
                    record["below"] += repeat * ids
            elif record.get("stack") is not None:
                record["stack"] += repeat * ids
            if record["kind"] == "act":
                record["act"] += repeat * acts
            file.write(compact(record))
            n += 1
        file.write(compact({"kind": "end", "n": n, "t": round((repeat + 1) * duration, 6)}))


def measured(command):
    """Seconds and megabytes of a command, and its output."""
    read, write = os.pipe()
    child = os.fork()
    begun = time.monotonic()
    if child == 0:
        os.dup2(write, 1)
        os.close(read)
        os.execvp(command[0], command)
    os.close(write)
    with os.fdopen(read, "rb") as pipe:
        lines = sum(1 for _ in pipe)
    _, _, usage = os.wait4(child, 0)
    return time.monotonic() - begun, usage.ru_maxrss / 1024, lines


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1000000
    source = pathlib.Path(__file__).resolve().parents[2]
    with tempfile.TemporaryDirectory() as folder:
        run, a, b = (os.path.join(folder, name) for name in ("one.run.jsonl", "a.run.jsonl", "b.run.jsonl"))
        subprocess.run([program, "replay", source / "traces/building_blocks.trace.jsonl", "--no-physics", "-o", run],
                       check=True, stdout=subprocess.DEVNULL)
        records = [json.loads(line) for line in open(run, encoding="utf-8")]
        write_run(records, count, a)
        write_run(records, count, b, count // 2)
        told = json.loads(subprocess.run([program, "diff", a, b, "--json"], stdout=subprocess.PIPE).stdout)
        print(f"{count} records, {os.path.getsize(a) / 1e6:.0f} MB: {told['count']} difference; {told['sentence']}")
        rows = []
        for name, command in (("diff -u", ["diff", "-u", a, b]), ("cold", None), ("with indexes", None)):
            best = None
            for _ in range(3):
                if name == "cold":
                    for log in (a, b):
                        pathlib.Path(log + ".index").unlink(missing_ok=True)
                seconds, megabytes, lines = measured(command or [program, "diff", a, b])
                if best is None or seconds < best[0]:
                    best = (seconds, megabytes, lines)
            rows.append((name, *best))
        print("| | s | of diff -u | MB | lines |\n| --- | --- | --- | --- | --- |")
        for name, seconds, megabytes, lines in rows:
            print(f"| {name} | {seconds:.2f} | {seconds / rows[0][1]:.2f} | {megabytes:.0f} | {lines} |")


if __name__ == "__main__":
    main()
