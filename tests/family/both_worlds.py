#!/usr/bin/env python3
"""Asks for acts at random in both worlds, which must agree on the possible ones.

  tests/family/both_worlds.py build/continua [--acts 200] [--seed 1] [--least 98] [--all]

An act takes, lifts or puts a thing: on, in, beside, left of, right of or in front of another thing, or at a point inside the reach of
the arm, at its edge or outside, free or occupied. Things may stand elsewhere than in the scene, also out of reach. Both
worlds must refuse an act in the same words, or both do it. An act that both begin and only one finishes is told apart:
a fall, a slip or an arm without a way happens in the physics world alone. Ends with status 1 if the share of agreement
is below --least percent.
"""
import argparse
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent / "exam")]
import run_exam  # noqa: E402  (found in the folder of the exams)
import things  # noqa: E402

RELATIONS = ["on", "in", "beside", "to the left of", "to the right of", "in front of"]


def point(rng):
    """Anywhere on the table or a little beyond its edges."""
    return [round(rng.uniform(-0.65, 0.65), 3), round(rng.uniform(-0.42, 0.42), 3)]


def random_act(rng):
    scene = rng.choice(sorted(things.UNIQUE))
    names = things.UNIQUE[scene]
    thing = rng.choice(sorted(names))
    act = {"scene": scene, "thing": thing, "objects": {}}
    if rng.random() < 0.4:
        x, y = round(rng.uniform(-0.5, 0.5), 3), round(rng.uniform(-0.29, 0.29), 3)
        if all(abs(x - other[0]) > 0.17 or abs(y - other[1]) > 0.17 for other in run_exam.positions_in(scene).values()):
            act["objects"][thing] = {"position": [x, y, 0]}
    kind = rng.choice(["take", "lift", "relation", "relation", "relation", "point", "point"])
    if kind in ("take", "lift"):
        act["say"] = f"{kind} {names[thing]}"
    elif kind == "relation":
        other = rng.choice(sorted(set(names) - {thing}))
        act["say"] = f"put {names[thing]} {rng.choice(RELATIONS)} {names[other]}"
    else:
        act["say"] = f"put {names[thing]} there"
        act["point"] = things.where(scene, rng.choice(sorted(names))) if rng.random() < 0.3 else point(rng)
    return act


def write_trace(act, path):
    header = {"kind": "trace", "version": 1, "scene": act["scene"], "machine": "interaction", "objects": act["objects"]}
    lines = [header, {"t": 1, "kind": "speech", "text": act["say"].capitalize() + ".", "until": 2}]
    if "point" in act:
        lines.append({"t": 1.6, "kind": "gesture", "name": "point", "hand": "right", "phase": "start", "target": act["point"]})
    lines.append({"t": 3, "kind": "end"})
    with open(path, "w", encoding="utf-8") as trace:
        for line in lines:
            print(json.dumps(line), file=trace)


def outcome(path):
    """The end of the act, or "no act", and the avatar's words apart from Okay."""
    status, reason, said = "no act", "", []
    with open(path, encoding="utf-8") as log:
        for record in map(json.loads, log):
            if record["kind"] == "utterance":
                said.append(record["text"])
            elif record["kind"] == "act" and "step" not in record and record["status"] not in ("asked", "started"):
                status, reason = record["status"], record.get("reason", "")
    return status, [text for text in said if not text.startswith("Okay")], reason


def is_refusal(status):
    return status in ("no act", "unreachable", "blocked")


def verdict(kinematic, physical):
    if kinematic[:2] == physical[:2]:
        return "agree"
    if (kinematic[0] == "done") == (physical[0] == "done"):
        return "words differ"
    return "physics alone fails" if kinematic[0] == "done" else "kinematic alone fails"


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    options.add_argument("program")
    options.add_argument("--acts", type=int, default=200)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--least", type=float, default=98)
    options.add_argument("--all", action="store_true")
    chosen = options.parse_args()
    rng = random.Random(chosen.seed)
    acts = [random_act(rng) for _ in range(chosen.acts)]
    count = {}
    with tempfile.TemporaryDirectory() as folder:
        traces = [os.path.join(folder, f"{i:03}.trace.jsonl") for i in range(len(acts))]
        for act, trace in zip(acts, traces):
            write_trace(act, trace)
        for world, option in (("kinematic", ["--no-physics"]), ("physical", [])):
            os.mkdir(os.path.join(folder, world))
            command = [chosen.program, "replay", *traces, *option, "-j", "2", "-o", os.path.join(folder, world) + "/"]
            subprocess.run(command, capture_output=True, check=False)
        for i, act in enumerate(acts):
            ends = [outcome(os.path.join(folder, world, f"{i:03}.run.jsonl")) for world in ("kinematic", "physical")]
            judged = verdict(*ends)
            count[judged] = count.get(judged, 0) + 1
            if judged != "agree" or chosen.all:
                print(f"{judged}: {json.dumps(act)}\n  kinematic {ends[0]}\n  physical  {ends[1]}")
    share = 100 * count.get("agree", 0) / len(acts)
    print(", ".join(f"{n} {name}" for name, n in sorted(count.items())) + f"; {share:.1f} % agree")
    return 0 if share >= chosen.least else 1


if __name__ == "__main__":
    sys.exit(main())
