#!/usr/bin/env python3
"""Transitions per second of Python's transitions, as JSON. Argument: the folder of make_machines.py."""
import json
import pathlib
import sys
import time

from transitions import Machine


class Model:
    def __init__(self):
        self.stack = (None, None)

    def push(self):
        self.stack = ("m", self.stack)

    def pop(self):
        self.stack = self.stack[1] or self.stack

    def unmarked(self):
        return self.stack[0] is None


def model_of(machine):
    model = Model()
    rows = []
    for one in machine["transitions"]:
        row = {"trigger": one["on"], "source": one["from"], "dest": one["to"]}
        if "when" in one:
            row["conditions"] = "unmarked"
        if "push" in one or "pop" in one:
            row["after"] = "push" if "push" in one else "pop"
        rows.append(row)
    states = sorted({row["source"] for row in rows} | {row["dest"] for row in rows})
    Machine(model, states=states, transitions=rows, initial=machine["start"], auto_transitions=False)
    return model


def per_second(machine, word):
    model = model_of(machine)
    triggers = [getattr(model, symbol) for symbol in word]
    begin = time.perf_counter()
    runs = 0
    while time.perf_counter() - begin < 0.5:
        for trigger in triggers:
            trigger()
        runs += 1
    return runs * len(word) / (time.perf_counter() - begin)


folder = pathlib.Path(sys.argv[1])
word = json.loads((folder / "word.json").read_text())
machines = {name: json.loads((folder / f"{name}.json").read_text()) for name in ("finite", "stack", "guarded")}
print(json.dumps({name: per_second(machine, word) for name, machine in machines.items()}))
