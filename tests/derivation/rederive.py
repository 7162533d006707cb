#!/usr/bin/env python3
"""Derives again, from run logs alone, what the engine decided: stacks, applications, acts, candidates.

  tests/derivation/rederive.py PROGRAM FILE…

A FILE is a run log, or a trace, which PROGRAM replays first without physics. Prints counts, every disagreement with
file and line. An act to which no application leads is one. Ends with status 1 if there is a disagreement. README.md tells
what is covered.
"""
import collections
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import evaluate
import explored
import moments
import stacks
import terms
import types_of_terms as types
from acts import Acts
from applications import Applications
from choices import Choices
from evaluate import Unknown
from frames import with_room
from machine import Machine, MachineEvaluation, flat_effects, operation_of
from terms import NULL

RAISING = pathlib.Path(__file__).parents[2] / "engine" / "knowledge" / "raising.json"


class Tally:
    """What all logs together gave."""

    def __init__(self):
        self.counts, self.skipped = collections.Counter(), collections.Counter()
        self.disagreements = []

    def report(self):
        for place, text in self.disagreements:
            print(f"{place}: {text}")
        for name, count in sorted(self.counts.items()):
            print(f"{name}: {count}")
        for reason, count in self.skipped.most_common():
            print(f"skipped for want of {reason}: {count}")
        print(f"disagreements: {len(self.disagreements)}")


def opaque_in(term):
    """What is not known in a value."""
    if term[0] == "opaque":
        yield term[1]
    for part, _ in terms.parts_of(term):
        yield from opaque_in(part)


class Log(Choices, Applications):
    """One run log, record by record."""

    def __init__(self, name, records, tally, raising):
        self.name, self.records, self.tally = name, records, tally
        header = records[0]
        self.machine = Machine(header, raising)
        self.explores = header["choice"] == "explore"
        self.choice = header["choice"]
        self.slots = {slot: {**each, "empty": self.machine.empty(each)} for slot, each in self.machine.slots.items()}
        self.symbols, self.below, self.certainties = {}, {}, {}
        self.registers = {name: self.machine.empty(each) for name, each in self.machine.registers.items()}
        self.state = self.machine.document["start"]
        self.stack, self.ids, self.history = [], [], []
        self.readings = moments.Readings(records)
        self.name_types, self.moment, self.offers = self.types_told(), {}, {}
        self.left, self.latest, self.named = None, None, {0}
        self.before_step, self.after_rewrite, self.pointing, self.gaze = None, False, False, False
        self.pointings = set()
        self.acts = Acts(self)
        self.branches = explored.Branches(self)

    def types_told(self):
        return {record["function"]: record["types"]["function"] for record in self.records
                if record["kind"] == "application" and terms.read(record["function"])[0] == "name"}

    def count(self, name):
        self.tally.counts[name] += 1

    def place(self, record):
        return f"{self.name}:{record['n'] + 1}"

    def disagree(self, record, text):
        self.tally.disagreements.append((self.place(record), f"{record['kind']}: {text}"))

    def skip(self, name, why):
        self.count(f"{name}, skipped")
        self.tally.skipped[str(why)] += 1

    def check(self):
        for name, each in self.machine.registers.items():
            if "initial" in each:
                self.registers[name] = self.evaluation({}, {}).value(terms.read(each["initial"]))
        for record in self.records:
            own = getattr(self, "on_" + record["kind"], None)
            if own:
                own(record)
            self.acts.see(record)
        self.at_rest(self.records[-1])

    def evaluation(self, moment, slots=None):
        slots = (self.stack[-1] if self.stack else {}) if slots is None else slots
        return MachineEvaluation(self.machine, slots, self.registers, moment, self.certainties, self.name_types)

    def known(self, text, moment, evaluation=None):
        try:
            return (evaluation or self.evaluation(moment)).value(terms.read(text))
        except RecursionError as why:
            raise Unknown("a deep evaluation") from why
        except types.NoType as why:
            raise Unknown("types that do not go together") from why

    # Symbols and stacks

    def on_symbol(self, record):
        symbol = {slot: each["empty"] for slot, each in self.slots.items()}
        symbol.update({slot: terms.read(text) for slot, text in record["slots"].items()})
        if record["id"] in self.symbols and not stacks.same(self.symbols[record["id"]], symbol):
            self.disagree(record, f"symbol {record['id']} was different before")
        self.symbols[record["id"]], self.below[record["id"]] = symbol, record["below"]
        if not self.stack:
            self.begin(record, symbol)

    def begin(self, record, symbol):
        bottom = {slot: each["empty"] for slot, each in self.slots.items()}
        for slot, text in self.machine.document.get("bottom", {}).items():
            bottom[slot] = self.evaluation({}, {}).value(terms.read(text))
        self.count("bottom symbols")
        if not stacks.same(bottom, symbol):
            self.disagree(record, "the symbol at the bottom is not that of the machine")
        self.stack, self.ids, self.history = [symbol], [record["id"]], [(self.state, symbol)]
        self.branches.begin_step()

    def chain(self, top):
        """The ids from the bottom up to this one, by the records of symbols."""
        ids = []
        while top is not None:
            if top not in self.below:
                raise stacks.Unexpected(f"symbol {top} was never written")
            ids.append(top)
            top = self.below[top]
        return ids[::-1]

    def change_stack(self, record, moment):
        """Performs the operation of a record and compares with the stack that the record states."""
        self.count("stacks")
        try:
            ids = self.chain(record["stack"])
            self.compare_stack(record, ids, moment)
        except stacks.Unexpected as why:
            self.disagree(record, str(why))
            return
        self.ids, self.stack = ids, [self.symbols[each] for each in ids]
        if not ids:
            self.disagree(record, "an empty stack")

    def compare_stack(self, record, ids, moment):
        operation = record["operation"]
        kind, content = next(iter(operation.items()))
        base = self.kept(kind, content)
        logged = [self.symbols[each] for each in ids[base:]] if kind.startswith(("push", "rewrite")) else []
        values = self.contents(record, kind, content, logged, moment)
        expected = stacks.operated(self.stack, self.history, operation, logged, values, self.slots,
                                   self.machine.document.get("rewrite_below", False))
        if not expected:
            expected = [self.stack[0]]
        if len(expected) != record["depth"]:
            self.disagree(record, f"{kind} gives a stack of {len(expected)}, the log has a depth of {record['depth']}")
        if len(expected) != len(ids):
            raise stacks.Unexpected(f"{kind} gives a stack of {len(expected)}, the log's symbols are {ids}")
        kept = min(base, len(expected))
        if kind not in ("flush", "pop_until") and self.ids[:kept] != ids[:kept]:
            self.disagree(record, f"{kind} keeps the symbols {self.ids[:kept]}, the log has {ids}")
        makes = kind == "flush" or kind.startswith(("push", "rewrite")) and content is not None
        new = ids[kept:] if makes else []
        if self.named.intersection(new) and not self.explores:
            self.disagree(record, f"{kind} makes new symbols, but {new} were there before")
        self.named.update(ids)
        for own, id_ in zip(expected, ids):
            self.compare_symbol(record, own, id_)

    def kept(self, kind, content):
        """How many symbols the operation leaves as they are, at most."""
        if kind == "flush":
            return 0
        return len(self.stack) - (kind.startswith("rewrite") and content is not None)

    def compare_symbol(self, record, own, id_):
        logged = self.symbols[id_]
        if not stacks.same(own, logged):
            differing = [slot for slot in own if not stacks.near(own[slot], logged[slot])]
            self.disagree(record, f"symbol {id_}: " + "; ".join(
                f"{slot} is {terms.text_of(own[slot])} by the rules, {terms.text_of(logged[slot])} in the log"
                for slot in differing))
            return
        logged.update(own)

    def contents(self, record, kind, content, logged, moment):
        """For each new symbol the contents whose values are known."""
        values = [{} for _ in logged]
        if not isinstance(content, dict) or kind == "flush":
            return values
        for slot, text in content.items():
            if text is None:
                continue
            evaluation = self.evaluation(moment)
            try:
                value = self.known(text, moment, evaluation)
                for hidden in opaque_in(value):
                    raise Unknown(hidden)
                self.add_values(record, slot, value, kind.endswith("_each"), values)
                self.count("contents of slots")
                self.compare_fills(record, evaluation.fills)
            except Unknown as why:
                self.skip("contents of slots", why)
        return values

    def compare_fills(self, record, fills):
        """Each `fill` in a content is an application, which the log has since the step before."""
        logged, n = [terms.read(each["result"]) for each in self.branches.made], record["n"] - 1
        while not self.branches.follows and self.records[n]["kind"] in ("symbol", "application", "block"):
            if self.records[n]["kind"] == "application":
                logged.append(terms.read(self.records[n]["result"]))
            n -= 1
        for result in fills:
            self.count("applications that contents make")
            if not any(stacks.near(result, each) for each in logged):
                self.disagree(record, f"no application before it has the result {terms.text_of(result)}")

    def add_values(self, record, slot, value, is_each, values):
        each = value[1] if is_each and value[0] == "list" else [value]
        if is_each and len(each) != len(values):
            raise stacks.Unexpected(f"{slot} has {len(each)} values, the log has {len(values)} new symbols")
        for known, one in zip(values, each):
            known[slot] = self.raised(one, self.slots[slot]["type"])

    def raised(self, value, wanted):
        if wanted == "term" or value in stacks.EMPTY:
            return value
        if wanted == "region" and value[0] == "point":  # to the types the same as loc, but it has an extent
            rules = [each for each in self.machine.raising["rules"] if each["to"] == wanted]
            return self.evaluation({}).raised_by(rules[0], value) if rules else value
        return self.evaluation({}).fitting(value, types.read_type(wanted))

    # Inputs

    def on_input(self, record):
        event = record["event"]
        self.gaze = self.gaze or event["kind"] == "gaze"
        self.pointing = self.pointing or event["kind"] == "pointing" or "target" in event or "ray" in event

    def on_belief(self, record):
        self.certainties[record["concept"]] = record["value"]

    def on_memory(self, record):
        value = terms.read(record["value"])
        declared = self.machine.registers[record["register"]]
        self.registers[record["register"]] = self.machine.empty(declared) if value == NULL else value

    def source_of(self, record):
        """The reading and the input that a step goes back to; either may be None."""
        reading = None
        while record is not None and record["kind"] != "input":
            if record["kind"] == "reading" and reading is None:
                reading = record
            record = self.records[record["cause"]] if "cause" in record else None
        return reading, record

    def was_assured(self, record):
        """Whether the input was asked about and is now as sure as one can be."""
        while record is not None and record["kind"] != "input":
            if record.get("assured"):
                return True
            record = self.records[record["cause"]] if "cause" in record else None
        return False

    def moment_of(self, record, reading, event, symbol):
        said = moments.of_event(event, symbol, reading)
        said.update(moments.of_reading(reading or {"move": None}))
        if reading is None:
            del said["move"]
        said["now"], said["in_state"] = ("num", record["t"]), ("text", self.state)
        sure = self.was_assured(record)
        said["confidence"] = ("num", 1.0 if sure else moments.confidence_of(event, reading))
        said["input"] = ("text", symbol) if symbol else NULL
        self.add_neighbours(said, reading)
        if not self.gaze:
            said["looked_at"] = moments.names([])
        if not self.pointing:
            said["pointed"] = said["pointed_confidence"] = moments.NO_POINTING
        elif symbol == "gesture δ" and event.get("target"):
            said["pointed"] = moments.POINTED
        return said

    def add_neighbours(self, said, reading):
        try:
            said["next"] = self.readings.neighbour(reading, 1) if reading else NULL
            said["previous"] = self.readings.neighbour(reading, -1) if reading else NULL
            if reading:
                said["following"], said["later"] = self.readings.after(reading)
                said["joined"] = self.readings.joined(reading)
                said["quoted"] = self.readings.quoted(reading)
        except Unknown:
            pass

    def symbol_of(self, reading, event, given):
        """The input symbol of an alternative that was not taken; None if it is not known."""
        document = self.machine.document
        if event["kind"] == "speech" and "lexicon" in document and reading["move"]:
            return "speech " + reading["move"]
        if event["kind"] == "gesture" and "gestures" in document and reading["move"]:
            return "gesture " + reading["move"]
        return None

    def offers_at(self, record):
        """{number of the alternative: (symbol, moment)}; None for the number where one input was offered."""
        reading, source = self.source_of(record)
        event = source["event"] if source else {"kind": "none"}
        if not any("alternative" in each for each in [*record.get("candidates", []), *record["refused"]]):
            return {None: (record["input"], self.moment_of(record, reading, event, record["input"]))}
        offers = {}
        for number, own in self.readings.offered(reading).items():
            taken = number == record.get("alternative")
            symbol = record["input"] if taken else self.symbol_of(own, event, record["input"])
            if own["confidence"] > 0:
                offers[number] = (symbol, self.moment_of(record, own, event, symbol))
        return offers

    # Steps

    def on_transition(self, record):
        if record["input"] is not None:
            self.begin_branches(record)
            self.at_rest(record)
            self.before_step = (self.state, self.stack, self.ids, self.history)
            self.offers = self.offers_at(record)
            self.moment = self.offers.get(record.get("alternative"), (None, {}))[1]
            self.count("steps with an input")
        else:
            self.offers = {None: (None, {**self.moment, "input": NULL})}
            self.count("steps without an input")
        if record["from"] != self.state:
            self.disagree(record, f"leaves {record['from']}, but the state was {self.state}")
            self.state = record["from"]
        self.compare_candidates(record)
        self.compare_choice(record)
        moment = self.offers.get(record.get("alternative"), (None, {}))[1]
        self.compare_way(record, moment)
        self.change_stack(record, moment)
        self.left, self.latest = self.state, record["id"]
        self.enter(record["to"], next(iter(record["operation"])))
        if record["input"] is None:
            self.moment = {**self.moment, "input": NULL}

    def enter(self, state, kind):
        self.state = state
        self.history = [*self.history, (state, self.stack[-1])]
        self.after_rewrite = kind.startswith("rewrite")

    def on_rewrite(self, record):
        """A rewrite among the effects of a state, or of a transition before the state is entered."""
        of_transition = self.transition_does(record["operation"]) and record["state"] == self.left
        if record["state"] != self.state and not of_transition:
            self.disagree(record, f"is in {record['state']}, but the state was {self.state}")
        if not of_transition and record["operation"] not in self.rewrites_of(self.machine.states.get(self.state, {})):
            self.disagree(record, f"no effect of {self.state} is {record['operation']}")
        self.change_stack(record, self.moment)
        self.after_rewrite = True
        if of_transition:
            self.history = [*self.history[:-1], (self.state, self.stack[-1])]

    def transition_does(self, operation):
        return operation in map(operation_of, flat_effects(self.machine.by_id[self.latest].get("do")))

    @staticmethod
    def rewrites_of(state):
        return list(map(operation_of, flat_effects(state.get("enter"))))

    def on_refusal(self, record):
        if self.explores:
            return
        if self.before_step and record["state"] == self.before_step[0] != self.state:
            self.state, self.stack, self.ids, self.history = self.before_step
        self.count("refusals")
        if record["state"] != self.state:
            self.disagree(record, f"is in {record['state']}, but the state was {self.state}")
        if not record["reason"].startswith("no transition") and not record["refused"]:
            self.skip("refusals", "the rule of a refusal that is not of conditions")
            return
        self.offers = self.offers_at({**record, "candidates": []})
        self.moment = next(iter(self.offers.values()))[1]
        self.compare_candidates({**record, "candidates": []}, record)

    def on_correction(self, record):
        self.state, self.ids = record["to"], self.chain(record["stack"])
        self.stack = [self.symbols[each] for each in self.ids]
        self.skip("stacks", "the stack that an observation implies")

    def on_expect(self, record):
        found = record["found"]
        for name, own in (("state", self.state), ("stack_depth", len(self.stack))):
            if name in found and not self.explores:
                self.count("states and depths in expectations")
                if found[name] != own:
                    self.disagree(record, f"{name} is {found[name]} in the log, {own} by the rules")

    def at_rest(self, record):
        """Before the next input no ε-transition may apply."""
        if self.explores or self.choice == "unique" and not self.after_rewrite or not self.stack:
            return
        if self.machine.document.get("epsilon") == "after_rewrite" and not self.after_rewrite:
            return
        evaluation = self.evaluation({**self.moment, "input": NULL})
        for transition in self.machine.fitting(self.state, None):
            try:
                holds = evaluate.truth(self.known(transition.get("when", "true"), {}, evaluation))
            except Unknown as why:
                self.skip("conditions at rest", why)
                continue
            self.count("conditions at rest")
            if holds:
                self.disagree(record, f"before it '{transition['id']}' applied in {self.state}, and was not taken")

    # Branches

    def begin_branches(self, record):
        if self.explores and not self.branches.follows:
            self.branches.begin_step()
            self.branches.lead(record)

    def on_branched(self, record):
        self.branches.waiting.append(record)

    def on_branches(self, record):
        for branch in record["branches"]:
            self.count("stacks of branches")
            if len(self.chain(branch["stack"])) != branch["depth"]:
                self.disagree(record, f"a branch in {branch['state']} has {len(self.chain(branch['stack']))} symbols, "
                                      f"not {branch['depth']}")
        self.branches.after_step(record)


def with_documents(value, folder):
    """The value with the documents in it that are kept beside the log (replay/log/RUNLOG.md, Kept documents)."""
    if not isinstance(value, dict):
        return value
    if list(value) == ["kept"]:
        places = [each / "documents" / (value["kept"] + ".json") for each in (folder, *folder.parents)]
        return json.loads(next(each for each in places if each.exists()).read_text(encoding="utf-8"))
    return {name: with_documents(member, folder) for name, member in value.items()}


def read_log(path):
    with open(path, encoding="utf-8") as lines:
        header, *records = [json.loads(line) for line in lines if line.strip()]
    return [with_documents(header, pathlib.Path(path).resolve().parent), *records]


def check_log(name, records, tally, raising):
    header = records[0]
    if header.get("what_if") or header.get("variant"):
        tally.counts["logs left out: changes in mid-run or observations"] += 1
        return
    tally.counts["logs"] += 1
    with_room(Log(name, records, tally, raising).check)


def replayed(program, traces, folder):
    """The run logs of traces, of which no two may have the same name."""
    subprocess.run([program, "replay", *traces, "--no-physics", "-o", folder + "/"], capture_output=True, check=False)
    return [os.path.join(folder, os.path.basename(each).replace(".trace.", ".run.")) for each in traces]


def check_files(program, files):
    tally = Tally()
    raising = json.loads(RAISING.read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        traces = [each for each in files if each.endswith(".trace.jsonl")]
        logs = [each for each in files if each not in traces]
        shown = dict(zip(replayed(program, traces, folder), traces)) if traces else {}
        for path in [*shown, *logs]:
            if not os.path.exists(path):
                tally.disagreements.append((shown.get(path, path), "there is no run of it"))
                continue
            check_log(shown.get(path, path).replace(".trace.", ".run."), read_log(path), tally, raising)
    return tally


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    tally = check_files(sys.argv[1], sys.argv[2:])
    tally.report()
    sys.exit(bool(tally.disagreements))


if __name__ == "__main__":
    main()
