#!/usr/bin/env python3
"""Talks at random to the avatar, and checks that it always finds back.

  tests/exam/random_turns.py build/continua [TURNS]

Turns are the lexicon's own sentences, the same with their words shuffled or dropped, gestures and pointings, in four
scenes, without physics. Every 20th turn is a probe: "never mind", then a thing to point at. The avatar must point at
it; no run may hold a problem, and no stack may be deeper at a probe than questions can wait: six of at most two symbols
each, the one that is asked now, and the bottom. Prints the figures; ends with status 1 if
anything is otherwise.
"""
import glob
import json
import os
import random
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROBES = {
    "place_setting": {"knife": "the knife", "plate": "the plate", "cup_blue": "the blue cup"},
    "workbench": {"block_red": "the red block", "cup": "the cup", "plate": "the plate"},
    "emre_table": {"knife": "the knife", "plate": "the plate", "cup": "the cup"},
    "staircase": {"block6": "the red block", "block1": "the yellow block", "block3": "the black block"},
}
GESTURES = ["posack", "negack", "nevermind", "stop", "grab", "release", "lift", "push", "engage", "count_two", "wiggle"]
DEEPEST = 14
TURNS_OF_A_RUN = 500


def sentences():
    """The lexicon's examples, without those that forbid to point, rename things or end the dialogue."""
    said = []
    for path in sorted(glob.glob(os.path.join(ROOT, "engine/knowledge/lexicon/english/examples*.json"))):
        with open(path, encoding="utf-8") as file:
            for example in json.load(file)["examples"]:
                text = example["say"]
                said.extend([text] if isinstance(text, str) else text)
    return [text for text in said if "point" not in text]


def random_turn(dice, said):
    """An event without its time, and seldom something that nobody would say."""
    kind = dice.random()
    if kind < 0.15:
        return {"kind": "gesture", "name": dice.choice(GESTURES), "phase": "start", "direction": dice.choice(["left", "right"])}
    if kind < 0.3:
        return {"kind": "pointing", "hand": "right", "target": [round(dice.uniform(-0.4, 0.4), 3), round(dice.uniform(-0.3, 0.2), 3)]}
    words = dice.choice(said).split()
    if kind > 0.75:
        dice.shuffle(words)
    if kind > 0.9:
        words = words[: max(1, len(words) // 2)] + dice.choice(said).split()
    return {"kind": "speech", "text": " ".join(words)}


def write_trace(path, scene, turns, dice, said):
    probes = []
    with open(path, "w", encoding="utf-8") as trace:
        print(json.dumps({"kind": "trace", "version": 1, "scene": scene, "machine": "interaction"}), file=trace)
        for turn in range(1, turns + 1):
            t = 3.0 * turn
            if turn % 20:
                print(json.dumps({"t": t, **random_turn(dice, said)}), file=trace)
                continue
            name, words = dice.choice(sorted(PROBES[scene].items()))
            print(json.dumps({"t": t, "kind": "speech", "text": "Never mind."}), file=trace)
            print(json.dumps({"t": t + 1, "kind": "speech", "text": f"Point at {words}."}), file=trace)
            probes.append((t + 1, name))
    return probes


def faults_of(path, probes):
    acts, depths, faults = {}, {}, []
    with open(path, encoding="utf-8") as log:
        for record in map(json.loads, log):
            if record["kind"] == "problem":
                faults.append(f"{record['t']} s: problem: {record['message']}")
            if record["kind"] == "act" and record["status"] == "done":
                acts.setdefault(round(record["t"]), set()).add(record["program"])
            if record["kind"] == "transition" and "depth" in record:
                depths[round(record["t"])] = record["depth"]
    for t, name in probes:
        if f"point({name})" not in acts.get(round(t), set()):
            faults.append(f"{t} s: did not point at {name}")
        if depths.get(round(t), 0) > DEEPEST:
            faults.append(f"{t} s: the stack is {depths[round(t)]} deep")
    return faults


def main():
    program, turns = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 10_000
    said, count, faults = sentences(), 0, []
    with tempfile.TemporaryDirectory() as folder:
        for run in range(0, turns, TURNS_OF_A_RUN):
            dice = random.Random(run)
            scene = sorted(PROBES)[run // TURNS_OF_A_RUN % len(PROBES)]
            path = os.path.join(folder, f"{run}.trace.jsonl")
            probes = write_trace(path, scene, min(TURNS_OF_A_RUN, turns - run), dice, said)
            subprocess.run([program, "replay", path, "--no-physics", "-o", folder + "/"], capture_output=True, check=False)
            count += len(probes)
            faults += [f"{scene}, seed {run}, {fault}" for fault in faults_of(path.replace(".trace.", ".run."), probes)]
    for fault in faults:
        print(fault)
    print(f"{turns} turns, {count} probes, {len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
