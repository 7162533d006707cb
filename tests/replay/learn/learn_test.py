#!/usr/bin/env python3
"""Learns from the answers of an avatar whose habits are known, and must find them out.

learn_test.py PROGRAM
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

PROGRAM = None
# Two rival answers to "go", and a word that is believed when it was heard twice.
MACHINE = {
    "machine": 1, "name": "habits", "start": "Here", "accept": ["Here"],
    "beliefs": {"concepts": {"mark": {}}, "evidence": [{"inputs": ["speech mark"], "concepts": ["mark"], "levels": [0.5, 1]}]},
    "states": {"Here": {}, "Sure": {"gate": {"when": "certainty('speech mark') > 0.5", "else": "Unsure"}}, "Unsure": {}},
    "transitions": [
        {"id": "left", "from": "Here", "on": "speech go", "to": "Here", "do": [{"say": "Left."}]},
        {"id": "right", "from": "Here", "on": "speech go", "to": "Here", "do": [{"say": "Right."}]},
        {"id": "mark", "from": "Here", "on": "speech mark", "to": "Sure"},
        {"id": "sure", "from": "Sure", "on": None, "to": "Here", "do": [{"say": "Marked."}]},
        {"id": "unsure", "from": "Unsure", "on": None, "to": "Here", "do": [{"say": "Mark?"}]}]}
SHARE_OF_LEFT, SHARE_OF_SURE = 0.25, 0.9


def continua(*arguments, status=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert done.returncode == status, done.stdout + done.stderr
    return done.stdout + done.stderr


class Learns(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.machine = self.folder / "habits.json"
        self.machine.write_text(json.dumps(MACHINE), encoding="utf-8")
        chance = random.Random(7)
        self.traces = [self.trace(n, chance) for n in range(12)]
        self.weights = self.folder / "weights.json"

    def trace(self, number, chance):
        lines = [{"kind": "trace", "version": 1, "scene": "place_setting", "machine": "habits.json"}]
        for second in range(1, 31):
            mark = second == 5
            answer = ("Marked." if chance.random() < SHARE_OF_SURE else "Mark?") if mark else \
                "Left." if chance.random() < SHARE_OF_LEFT else "Right."
            lines += [{"t": second, "kind": "speech", "text": "mark" if mark else "go"},
                      {"t": second, "kind": "observed", "channel": "speech", "content": answer}]
        path = self.folder / f"{number}.trace.jsonl"
        path.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
        return path

    def learn(self, *options):
        told = continua("learn", self.machine, *self.traces, "-o", self.weights, *options)
        return told, json.loads(self.weights.read_text(encoding="utf-8"))

    def test_habits_are_found_out(self):
        told, learned = self.learn("--held-out", "0")
        left, right = learned["transitions"]["left"], learned["transitions"]["right"]
        self.assertAlmostEqual(left / (left + right), SHARE_OF_LEFT, delta=0.06)
        self.assertGreater(learned["evidence"][0]["levels"][0], 0.6)
        self.assertIn("learned from 12 of 12 traces: 360 inputs, 348 of them with rival transitions, 12 as evidence", told)

    def test_what_was_held_out_fits_better(self):
        told, learned = self.learn("-j", "2")
        before, after = (learned["learned"]["held_out"][when] for when in ("before", "after"))
        self.assertGreater(after["log_likelihood"], before["log_likelihood"] + 20)
        # Left comes first in the file; the avatar mostly says right.
        self.assertGreater(after["answers_right"], before["answers_right"] + 50)
        self.assertEqual(learned["learned"]["traces"], 6)
        self.assertIn("6 held out: 180 inputs", told)
        first = self.weights.read_bytes()
        self.learn()
        self.assertEqual(self.weights.read_bytes(), first)

    def test_runs_have_the_weights(self):
        _, learned = self.learn()
        log = self.folder / "log.run.jsonl"
        continua("replay", self.traces[0], "--no-physics", "--weights", self.weights, "-o", log)
        records = [json.loads(line) for line in log.read_text(encoding="utf-8").splitlines()]
        document = records[0]["machine"]["document"]
        self.assertEqual({each["id"]: each["weight"] for each in document["transitions"] if "weight" in each},
                         learned["transitions"])
        went = next(each for each in records if each["kind"] == "transition" and each["input"] == "speech go")
        self.assertEqual(went["id"], "right")
        right, left = learned["transitions"]["right"], learned["transitions"]["left"]
        self.assertAlmostEqual(went["probability"], right / (right + left))

    def test_faults(self):
        bare = self.folder / "bare.trace.jsonl"
        bare.write_text(json.dumps({"kind": "trace", "version": 1, "scene": "place_setting", "machine": "habits.json"}) + "\n",
                        encoding="utf-8")
        self.assertIn("nothing was observed", continua("learn", self.machine, bare, "-o", self.weights, "--held-out", "0",
                                                       status=2))
        wrong = self.folder / "wrong.json"
        wrong.write_text('{"weights": 1, "machine": "habits", "transitions": {"lft": 1}}', encoding="utf-8")
        told = continua("replay", self.traces[0], "--no-physics", "--weights", wrong, "-o", self.folder / "x.run.jsonl", status=2)
        self.assertIn("wrong.json:1:", told)
        self.assertIn("did you mean 'left'?", told)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
