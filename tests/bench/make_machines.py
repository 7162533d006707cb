#!/usr/bin/env python3
"""Writes the machines that are compared into a folder, in the project's format, and the word they read.

50 states, 200 transitions: each state takes each of four inputs to a state drawn by a seeded generator, so that no
input is refused. finite: nothing else. stack: each transition pushes or pops. guarded: each has a condition on a slot.
"""
import json
import pathlib
import random
import sys

STATES, INPUTS, WORD, SEED = 50, 4, 1000, 20200601


def machine(name, more):
    draw = random.Random(SEED)
    transitions = []
    for state in range(STATES):
        for symbol in range(INPUTS):
            transition = {"id": f"t{state}.{symbol}", "from": f"S{state}", "on": f"i{symbol}"}
            transition["to"] = f"S{draw.randrange(STATES)}"
            transitions.append({**transition, **more(draw)})
    return {"machine": 1, "name": name, "start": "S0", "slots": {"mark": "text"}, "transitions": transitions}


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    variants = {
        "finite": lambda draw: {},
        "stack": lambda draw: {"push": {"mark": "'m'"}} if draw.random() < 0.5 else {"pop": 1},
        "guarded": lambda draw: {"when": "mark = null"},
    }
    for name, more in variants.items():
        (folder / f"{name}.json").write_text(json.dumps(machine(name, more)))
    draw = random.Random(SEED + 1)
    (folder / "word.json").write_text(json.dumps([f"i{draw.randrange(INPUTS)}" for _ in range(WORD)]))


main()
