#!/usr/bin/env python3
"""How long `continua serve` takes to answer for a run of a million records, and how much memory.

    tests/bench/bench_inspector.py build/continua [records]

Cold: the first request, with no index beside the log. Warm: three seconds after the server has started.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import urllib.request

from bench_diff import write_run

VIEWS = ["", "/graph", "/columns", "/labels?from=1000&limit=5000", "/find?text=put&kind=", "/find?text=put&kind=*",
         "/find?text=0.1&kind=*", "/find?text=nowhere&kind=*"]


class Server:
    def __init__(self, program, folder):
        self.process = subprocess.Popen([program, "serve", folder, "--port", "0"], stdout=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        self.base = line[line.index("http"):].split()[0].rstrip("/")

    def seconds(self, target):
        begun = time.monotonic()
        with urllib.request.urlopen(self.base + target) as answer:
            answer.read()
        return time.monotonic() - begun

    def megabytes(self):
        """In use now, and at most so far."""
        lines = dict(line.split(":", 1) for line in open(f"/proc/{self.process.pid}/status"))
        return [int(lines[name].split()[0]) / 1024 for name in ("VmRSS", "VmHWM")]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1000000
    source = pathlib.Path(__file__).resolve().parents[2]
    with tempfile.TemporaryDirectory() as folder:
        one, served = os.path.join(folder, "one.run.jsonl"), os.path.join(folder, "served")
        os.mkdir(served)
        subprocess.run([program, "replay", source / "traces/building_blocks.trace.jsonl", "--no-physics", "-o", one],
                       check=True, stdout=subprocess.DEVNULL)
        big = os.path.join(served, "big.run.jsonl")
        write_run([json.loads(line) for line in open(one, encoding="utf-8")], count, big)
        print(f"{count} records, {os.path.getsize(big) / 1e6:.0f} MB")
        columns, memory = [], []
        for wait in (0, 3):
            with Server(program, served) as server:
                time.sleep(wait)
                columns.append([server.seconds("/api/runs/big" + view) for view in VIEWS])
                memory.append(server.megabytes())
        print("| | cold s | warm s |\n| --- | --- | --- |")
        for view, cold, warm in zip(VIEWS, *columns):
            print(f"| {view or 'summary'} | {cold:.3f} | {warm:.3f} |")
        first_three = [sum(times[:3]) for times in columns]
        print(f"| summary, graph and columns | {first_three[0]:.2f} | {first_three[1]:.2f} |")
        print(f"| MB in use (at most) | {memory[0][0]:.0f} ({memory[0][1]:.0f}) | {memory[1][0]:.0f} ({memory[1][1]:.0f}) |")


if __name__ == "__main__":
    main()
