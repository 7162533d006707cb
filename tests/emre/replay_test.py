#!/usr/bin/env python3
"""Replays EMRE's referring expressions as traces and holds the referents of the run logs against what was meant.

replay_test.py PROGRAM SOURCE_FOLDER. Exit status 77, which counts as skipped, without the data.
"""
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

# Share of the expressions in which the focus is the single referent, among the referents, the first of them.
AT_LEAST = {"linguistic": {"single": 0.74, "among": 0.98}, "ensemble": {"first": 0.99}, "gestural": {"first": 0.96}}


def referents(run, move):
    """Those of the last reading that is such a move."""
    found = None
    for line in run.read_text(encoding="utf-8").splitlines():
        record = json.loads(line)
        if record["kind"] == "reading" and record["move"] == move:
            found = record.get("referents")
    return found


def main(program, source):
    source = pathlib.Path(source)
    data = source / "../shared/data/emre/references.jsonl"
    if not data.exists():
        print(f"skipped: there is no {data}")
        return 77
    items = [json.loads(line) for line in data.read_text(encoding="utf-8").splitlines()]
    counts, failures = collections.defaultdict(collections.Counter), []
    with tempfile.TemporaryDirectory() as folder:
        traces, runs = pathlib.Path(folder, "traces"), pathlib.Path(folder, "runs")
        subprocess.run([sys.executable, source / "tests/emre/make_traces.py", data, traces], check=True)
        replay = subprocess.run([program, "replay", *sorted(traces.iterdir()), "--no-physics", "-j", "2", "-o", runs],
                                check=False, stdout=subprocess.DEVNULL)
        if replay.returncode:
            failures.append(f"continua replay ended with status {replay.returncode}")
        for number, item in enumerate(items, 1):
            found = referents(runs / f"{number:04}.run.jsonl", "N" if item["text"] else "δ") or []
            count, focus = counts[item["modality"]], item["focus"]
            count["all"] += 1
            count["single"] += found == [focus]
            count["among"] += focus in found
            count["first"] += found[:1] == [focus]
            if len(found) == 1 and found != [focus]:
                failures.append(f"{item['id']}: {item['text']!r} means {found[0]}, expected {focus}")
    for modality, count in counts.items():
        print(modality, dict(count))
        for what, share in AT_LEAST[modality].items():
            if count[what] < share * count["all"]:
                failures.append(f"{modality}: {what} in {count[what]} of {count['all']}, expected {share:.0%}")
    print(*failures, sep="\n", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
