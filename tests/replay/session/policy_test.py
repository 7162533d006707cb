#!/usr/bin/env python3
"""Lets commands choose among transitions, and replays their runs without them.

policy_test.py PROGRAM
"""
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile
import unittest

PROGRAM = None
MACHINE = {"machine": 1, "name": "forks", "start": "Here", "slots": {"taken": "text*"},
           "transitions": [{"id": name, "from": "Here", "on": "speech *", "to": "Here", "weight": weight,
                            "push": {"taken": f"append(['{name}'], taken)"}, "do": [{"say": name}]}
                           for name, weight in (("first", 3), ("second", 1), ("third", 1))]}
# Takes the candidates in turn, and writes down what it was asked.
IN_TURN = """
import json, sys
for n, line in enumerate(sys.stdin):
    print(line, end="", file=open(sys.argv[1], "a"))
    candidates = json.loads(line)["candidates"]
    print(json.dumps({"choice": candidates[(n + 1) % len(candidates)]["id"]}), flush=True)
"""


class Policies(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "forks.json").write_text(json.dumps(MACHINE), encoding="utf-8")
        lines = [{"kind": "trace", "version": 1, "scene": "place_setting", "machine": "forks.json"}]
        lines += [{"t": second, "kind": "speech", "text": f"go {second}"} for second in range(1, 6)]
        self.trace = self.folder / "x.trace.jsonl"
        self.trace.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
        self.asked = self.folder / "asked.jsonl"
        (self.folder / "policy.py").write_text(IN_TURN, encoding="utf-8")
        self.in_turn = f"pipe:{sys.executable} {shlex.quote(str(self.folder / 'policy.py'))} {shlex.quote(str(self.asked))}"

    def replay(self, name, *options, status=0):
        log = self.folder / name
        done = subprocess.run([PROGRAM, "replay", self.trace, "--no-physics", "-o", log, *map(str, options)],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return log, done.stderr

    def taken(self, log):
        return [each["id"] for each in map(json.loads, log.read_text(encoding="utf-8").splitlines())
                if each["kind"] == "transition"]

    def test_what_it_chooses_is_taken(self):
        log, _ = self.replay("piped.run.jsonl", "--choice", self.in_turn)
        self.assertEqual(self.taken(log), ["second", "third", "first", "second", "third"])
        header = json.loads(log.read_text(encoding="utf-8").splitlines()[0])
        self.assertEqual(header["choice"], self.in_turn)
        asked = [json.loads(line) for line in self.asked.read_text(encoding="utf-8").splitlines()]
        self.assertEqual([each["step"] for each in asked], [1, 2, 3, 4, 5])
        self.assertEqual(asked[1]["state"], "Here")
        self.assertEqual(asked[1]["top"], {"taken": "['second']"})
        self.assertEqual(asked[1]["t"], 2)
        self.assertEqual([(each["id"], each["probability"]) for each in asked[1]["candidates"]],
                         [("first", 0.6), ("second", 0.2), ("third", 0.2)])
        self.assertEqual(asked[1]["inputs"][0]["said"], "'go 2'")

    def test_its_run_replays_without_it(self):
        log, _ = self.replay("piped.run.jsonl", "--choice", self.in_turn)
        self.asked.unlink()
        again, _ = self.replay("again.run.jsonl", "--choice", f"run:{log}")
        self.assertFalse(self.asked.exists())
        self.assertEqual(again.read_bytes(), log.read_bytes())
        # Any run can be taken after, and its own choices are not the policy's.
        usual, _ = self.replay("usual.run.jsonl")
        self.assertEqual(self.taken(usual), ["first"] * 5)
        third, _ = self.replay("third.run.jsonl", "--choice", f"run:{usual}")
        self.assertEqual(self.taken(third), ["first"] * 5)

    def test_every_run_asks_a_command_of_its_own(self):
        one, _ = self.replay("one.run.jsonl", "--choice", self.in_turn)
        two, _ = self.replay("two.run.jsonl", "--choice", self.in_turn)
        self.assertEqual(one.read_bytes(), two.read_bytes())

    def test_answers_that_are_none(self):
        for command, told in (("cat", "expected {\"choice\": …}"), ("exit 0", "the command has ended"),
                              ("/no/such/command", "the command has ended"),
                              ("while read x; do echo '{\"choice\": \"fourth\"}'; done", "which is no candidate"),
                              ("while read x; do echo 7; done", "found '7'")):
            log, error = self.replay("bad.run.jsonl", "--choice", f"pipe:{command}", status=2)
            self.assertIn(told, error, command)
            self.assertIn("'first', 'second', 'third'", error, command)
            self.assertFalse(log.exists())

    def test_a_run_that_does_not_fit(self):
        log, _ = self.replay("piped.run.jsonl", "--choice", self.in_turn)
        longer = self.trace.read_text(encoding="utf-8") + json.dumps({"t": 9, "kind": "speech", "text": "go on"}) + "\n"
        self.trace.write_text(longer, encoding="utf-8")
        _, error = self.replay("longer.run.jsonl", "--choice", f"run:{log}", status=2)
        self.assertIn("step 6: the run has no such step", error)
        _, error = self.replay("none.run.jsonl", "--choice", f"run:{self.folder / 'none'}", status=2)
        self.assertIn("none", error)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
