#!/usr/bin/env python3
"""The grammar that `continua machine --jsgf` writes: sentences drawn from it are understood.

speech_grammar_test.py PROGRAM
"""
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

DRAWN = 60
problems = []


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, check=True)


class Grammar:
    """A grammar in JSGF, as far as the program uses it: rules, weights, groups, options."""

    def __init__(self, text):
        header, *rest = text.split(";")
        if header.strip() != "#JSGF V1.0 UTF-8":
            raise ValueError(f"found {header}; expected the header of JSGF")
        self.rules = {}
        for rule in rest[1:]:
            if rule.strip():
                name, body = rule.replace("public", "").split("=", 1)
                self.rules[name.strip()] = re.findall(r"/[\d.e+]+/|<\w+>|[()\[\]|]|[^\s()\[\]|]+", body)

    def words(self):
        return {token for body in self.rules.values() for token in body if re.match(r"[^</()\[\]|]", token)}

    def draw(self, rule):
        self.tokens, self.at = self.rules[rule], 0
        said = self.alternatives()
        return [word for part in said for word in (self.again(part) if part.startswith("<") else [part])]

    def again(self, rule):
        kept = self.tokens, self.at
        said = self.draw(rule)
        self.tokens, self.at = kept
        return said

    def alternatives(self):
        weighted = [self.sequence()]
        while self.at < len(self.tokens) and self.tokens[self.at] == "|":
            self.at += 1
            weighted.append(self.sequence())
        return random.choices([said for _, said in weighted], [weight for weight, _ in weighted])[0]

    def sequence(self):
        weight, said = 1.0, []
        while self.at < len(self.tokens) and self.tokens[self.at] not in "|)]":
            token = self.tokens[self.at]
            self.at += 1
            if token.startswith("/"):
                weight = float(token.strip("/"))
            elif token in "([":
                inner = self.alternatives()
                self.at += 1
                said += inner if token == "(" or random.random() < 0.5 else []
            else:
                said.append(token)
        return weight, said


def test_sentences_are_understood(program, folder):
    text = run(program, "machine", "interaction", "--jsgf", "--scene", "place_setting").stdout
    if len(text) > 100_000:
        problems.append(f"the grammar has {len(text)} bytes; expected at most 100000")
    grammar = Grammar(text)
    random.seed(3)
    sentences = sorted({" ".join(grammar.draw("<sentence>")) for _ in range(DRAWN)})
    lines = [{"kind": "trace", "version": 1, "scene": "place_setting", "machine": "interaction"}]
    lines += [{"t": 20.0 * i, "kind": "speech", "text": said} for i, said in enumerate(sentences)]
    (folder / "x.trace.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))
    run(program, "replay", folder / "x.trace.jsonl", "--no-physics", "-o", folder / "x.run.jsonl")
    readings = [record for record in map(json.loads, (folder / "x.run.jsonl").read_text().splitlines())
                if record["kind"] == "reading"]
    lost = {record["words"] for record in readings if record.get("unknown") or record.get("unused")}
    if len(readings) < len(sentences) or lost:
        problems.append(f"of {len(sentences)} sentences {len(readings)} were read; words were lost in {sorted(lost)}")


def test_words_are_those_of_scene_and_dictionary(program, folder):
    (folder / "my.dict").write_text("take T EY K\nthe DH AH\nthe(2) DH IY\nplate P L EY T\nBLOCK B L AA K\n")
    done = run(program, "machine", "interaction", "--jsgf", "--scene", "place_setting", "--dictionary", folder / "my.dict")
    words = Grammar(done.stdout).words()
    if words != {"take", "the", "plate"} or "which the grammar leaves out" not in done.stderr:
        problems.append(f"found the words {sorted(words)}; expected take, the, plate, and a warning")


def main():
    with tempfile.TemporaryDirectory() as made:
        test_sentences_are_understood(sys.argv[1], pathlib.Path(made))
        test_words_are_those_of_scene_and_dictionary(sys.argv[1], pathlib.Path(made))
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
