#!/usr/bin/env python3
"""Tells the inputs of one instant in other orders: acts, words and gestures of the avatar must stay the same.

permutations_test.py PROGRAM SOURCE_FOLDER [--every N]

Takes all shipped traces of machines with fusion, and of the families every N-th member (1) with such inputs, whatever they
expect. Each is replayed without physics as it is, turned round, and rotated by one.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent / "exam")]
import hold_families  # noqa: E402  (found in the folder of the families)
import run_exam  # noqa: E402

INPUTS = ("speech", "gesture", "pointing", "gaze")
FEWEST = 60


def instants(lines):
    """[begin, end) of the neighbouring inputs of one instant, where there are several."""
    events = [json.loads(line) for line in lines]
    begin = 0
    for end in range(1, len(events) + 1):
        one = end < len(events) and all(each.get("kind") in INPUTS for each in (events[begin], events[end]))
        if one and events[begin]["t"] == events[end]["t"]:
            continue
        if end - begin > 1:
            yield begin, end
        begin = end


def permuted(lines, permutation):
    lines = list(lines)
    for begin, end in instants(lines):
        lines[begin:end] = permutation(lines[begin:end])
    return lines


PERMUTATIONS = {"as told": list, "turned round": lambda lines: lines[::-1], "rotated": lambda lines: lines[1:] + lines[:1]}


def answers(log):
    """All that the avatar did, and when."""
    told = []
    for record in map(json.loads, log.read_text(encoding="utf-8").splitlines()):
        if record["kind"] in ("utterance", "gesture", "act"):
            told.append([record["t"], record["kind"], record.get("text"), record.get("program"), record.get("status")])
    return told


def is_fused(machine, source):
    path = source / "engine" / "knowledge" / "machines" / (machine + ".json")
    return path.exists() and "fusion" in json.loads(path.read_text(encoding="utf-8"))


def traces(source, every, folder):
    """Name and lines of each trace."""
    for path in sorted((source / "traces").rglob("*.trace.jsonl")):
        lines = [line for line in path.read_text(encoding="utf-8-sig").splitlines() if line.strip()]
        if is_fused(json.loads(lines[0]).get("machine", ""), source):
            yield "trace " + path.name.removesuffix(".trace.jsonl"), lines
    items = [item for path in sorted((FOLDER / "members").glob("*.py")) for item in hold_families.members_of(path)]
    several = 0
    for item in items:
        path = folder / "item"
        run_exam.write_trace(item, path)
        lines = path.read_text(encoding="utf-8").splitlines()
        if any(instants(lines)):
            several += 1
            if several % every == 0:
                yield item["id"], lines


def main(program, source, *arguments):
    every = int(arguments[arguments.index("--every") + 1]) if "--every" in arguments else 1
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        cases = [(case, lines) for case, lines in traces(pathlib.Path(source), every, folder) if any(instants(lines))]
        found = {}
        for order, permutation in PERMUTATIONS.items():
            paths = [folder / f"{k}.trace.jsonl" for k in range(len(cases))]
            for path, (_, lines) in zip(paths, cases):
                path.write_text("\n".join(permuted(lines, permutation)) + "\n", encoding="utf-8")
            command = [program, "replay", *map(str, paths), "--no-physics", "-j", "2", "-o", name + "/"]
            subprocess.run(command, capture_output=True, check=False)
            found[order] = [answers(path.with_name(path.name.replace(".trace.", ".run."))) for path in paths]
    wrong = 0
    for order in PERMUTATIONS:
        for (case, _), as_told, otherwise in zip(cases, found["as told"], found[order]):
            if as_told != otherwise:
                wrong += 1
                differ = next(pair for pair in zip(as_told + [None], otherwise + [None]) if pair[0] != pair[1])
                print(f"{case}, {order}: {differ[1]} instead of {differ[0]}")
    print(f"{len(cases)} with inputs of one instant, {wrong} of {2 * len(cases)} permutations told apart")
    return not wrong and len(cases) >= FEWEST


if __name__ == "__main__":
    sys.exit(0 if main(*sys.argv[1:]) else 1)
