#!/usr/bin/env python3
"""Shows that rederive.py finds faults: approved runs are falsified in one place, and the fault must be reported there.

  tests/derivation/rederive_test.py

Needs no program.
"""
import copy
import functools
import json
import pathlib
import re
import unittest

import evaluate
import rederive
import terms
import types_of_terms as types

ROOT = pathlib.Path(__file__).parents[2]
RAISING = json.loads(rederive.RAISING.read_text(encoding="utf-8"))
RUNS = ("paper/figure_pda_disambiguation", "paper/never_mind", "paper/one_shot_learning", "talk/staircase",
        "building_blocks")

AFTER = 50  # records after a falsified one that are looked at: a fault is told where it is


def run(name):
    return rederive.read_log(ROOT / "traces" / (name + ".run.jsonl"))


@functools.cache
def known_run(name):
    """The same, not to be changed."""
    return run(name)


def check(records):
    tally = rederive.Tally()
    rederive.check_log("log", records, tally, RAISING)
    return tally


def lines_of_faults(records):
    return [int(place.split(":")[1]) for place, _ in check(records).disagreements]


class Faults(unittest.TestCase):
    def input_of(self, record):
        while record["kind"] != "input":
            record = self.records[record["cause"]]
        return record["n"]

    def found_everywhere(self, kind, falsify, least):
        """Falsifies records of the kind one by one, some six all over each run.

        falsify(record) is false where there is nothing to falsify."""
        count = 0
        for name in RUNS:
            records = self.records = known_run(name)
            falsified = []
            for n, record in enumerate(records):
                wrong = copy.deepcopy(record) if record["kind"] == kind else None
                if wrong and falsify(wrong) is not False:
                    falsified.append((n, record, wrong))
            for n, record, wrong in falsified[::max(1, len(falsified) // 6)]:
                count += 1
                faults = lines_of_faults([*records[:n], wrong, *records[n + 1:n + AFTER]])
                self.assertIn(n + 1, faults, f"{name}: {record['n']}")
        self.assertGreaterEqual(count, least)

    def test_approved_runs_have_none(self):
        for name in RUNS:
            self.assertEqual(check(run(name)).disagreements, [], name)

    def test_depth_of_a_stack(self):
        def falsify(record):
            if record["n"] % 5:
                return False
            record["depth"] += 1
        self.found_everywhere("transition", falsify, 20)

    def test_topmost_symbol(self):
        def falsify(record):
            if record["n"] % 5 or record["stack"] == 0:
                return False
            record["stack"] -= 1
        self.found_everywhere("transition", falsify, 20)

    def test_depth_after_a_rewrite(self):
        def falsify(record):
            record["depth"] -= 1
        self.found_everywhere("rewrite", falsify, 5)

    def test_result_of_an_application(self):
        def falsify(record):
            names = terms.names_in(terms.read(record["result"]))
            other = sorted(names - {record["function"]})[-1] if len(names) > 1 else sorted(names)[-1]
            record["result"] = record["result"].replace(other, "spoon")
        self.found_everywhere("application", falsify, 20)

    def test_rule_of_an_application(self):
        def falsify(record):
            if record["rule"] is None:
                return False
            record["rule"] = "object_to_place_on"
        self.found_everywhere("application", falsify, 1)

    def test_candidate_that_is_left_out(self):
        def falsify(record):
            if record["n"] % 4 or not record["candidates"]:
                return False
            del record["candidates"][-1]
        self.found_everywhere("transition", falsify, 5)

    def test_candidate_that_should_be_refused(self):
        def falsify(record):
            if record["n"] % 3 or not record["refused"]:
                return False
            other = next((each for each in record["refused"] if each["reason"].startswith("not lacks")), None)
            if other is None:
                return False
            record["refused"].remove(other)
            record["candidates"].append({"id": other["id"], "weight": 1.0})
        self.found_everywhere("transition", falsify, 3)

    def test_candidate_that_is_refused_wrongly(self):
        def falsify(record):
            if record["n"] % 4 or not record["candidates"]:
                return False
            record["refused"].append({"id": record["candidates"].pop()["id"], "reason": "false"})
        self.found_everywhere("transition", falsify, 5)

    def test_candidate_of_a_lower_rank(self):
        def falsify(record):
            other = next((each for each in record["refused"] if "outranked_by" in each), None)
            if other is None:
                return False
            record["refused"].remove(other)
            record["candidates"].append({"id": other["id"], "weight": 1.0})
        self.found_everywhere("transition", falsify, 5)

    def test_gate(self):
        def falsify(record):
            if record["n"] % 4 or not record["gates"]:
                return False
            record["gates"][-1]["passed"] = not record["gates"][-1]["passed"]
        self.found_everywhere("transition", falsify, 5)

    def test_act_that_nobody_asked_for(self):
        def falsify(record):
            if record["status"] != "asked":
                return False
            record["program"] = "grasp(spoon)"
        self.found_everywhere("act", falsify, 10)

    def test_act_without_its_inputs(self):
        def falsify(record):
            if record["status"] != "asked" or not record["because"]:
                return False
            first = next(each["n"] for each in self.records if each["kind"] == "input")
            if self.input_of(record) == first:
                return False
            record["because"] = [first]
        self.found_everywhere("act", falsify, 10)

    def test_slot_of_a_symbol(self):
        """Found at the transition that makes the symbol."""
        records = run("paper/figure_pda_disambiguation")
        at = next(n for n, each in enumerate(records) if each["kind"] == "symbol" and each["slots"].get("options"))
        records[at]["slots"]["indicated"] = "block1"
        named = next(n for n, each in enumerate(records) if n > at and each["kind"] == "transition")
        self.assertIn(named + 1, lines_of_faults(records))

    def test_act_without_derivation(self):
        records = run("paper/figure_pda_disambiguation")
        without = [each for each in records if each["kind"] != "application"]
        numbers = {each["n"]: n for n, each in enumerate(without)}
        for n, each in enumerate(without):
            each["n"] = n
            if "cause" in each:
                each["cause"] = numbers[each["cause"]]
            if "because" in each:
                each["because"] = [numbers[because] for because in each["because"]]
        faults = [text for _, text in check(without).disagreements if "no application leads to" in text]
        self.assertEqual(len(faults), 1)


class Language(unittest.TestCase):
    """The examples of engine/term/FUNCTIONS.md, and the notation of all approved runs."""

    OWN = {"block1": "e", "block4": "e", "on": "e -> loc", "put": "e -> loc -> t"}

    def type_of(self, name, applied):
        text = self.OWN.get(name) or evaluate.TYPES.get(name)
        if text is None:
            raise types.UnknownType(name)
        return types.read_type(text)

    def test_functions(self):
        page = (ROOT / "engine" / "term" / "FUNCTIONS.md").read_text(encoding="utf-8")
        rows = re.findall(r"^\| `[^`]+` \| `[^`]+` \|.*\| `([^`|]+)` \| `([^`|]+)` \|$", page, re.MULTILINE)
        self.assertGreater(len(rows), 60)
        for example, value in rows:
            own = evaluate.Evaluation(inert=self.OWN.__contains__, type_of_name=self.type_of, raising=RAISING["rules"])
            self.assertEqual(own.value(terms.read(example)), own.value(terms.read(value)), example)

    def test_notation(self):
        count = 0
        for path in sorted((ROOT / "traces").rglob("*.run.jsonl")):
            for record in rederive.read_log(path):
                texts = list(record["slots"].values()) if record["kind"] == "symbol" else []
                if record["kind"] == "application":
                    texts = [record[name] for name in ("function", "argument", "result")]
                for text in texts:
                    count += 1
                    self.assertEqual(terms.text_of(terms.read(text)), text)
        self.assertGreater(count, 500)


if __name__ == "__main__":
    unittest.main()
