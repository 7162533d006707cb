#!/usr/bin/python3
"""The schema of machine files accepts the project's machines and refuses the broken ones of machine_errors.txt that
only have a wrong shape. Takes the source folder."""
import json
import pathlib
import sys

from jsonschema import Draft7Validator


def no_number(text):
    raise ValueError(f"{text} is no JSON")


def parse(text):
    return json.loads(text, parse_constant=no_number)


def rows_of(table):
    """The machine, then for each row of the table its edits and whether the schema refuses the outcome."""
    head, *groups = table.split("\n= ")
    machine = groups[0].removeprefix("the machine\n")
    rows = []
    for paragraph in "\n\n".join(group.partition("\n")[2] for group in groups[1:]).split("\n\n"):
        lines = [line.partition(" ")[::2] for line in paragraph.splitlines() if line]
        olds = [text for mark, text in lines if mark == "-"]
        news = [text for mark, text in lines if mark == "+"]
        if olds:
            rows.append((list(zip(olds, news)), any(mark == "!!" for mark, text in lines)))
    return machine, rows


def main(source):
    schema = json.loads((source / "engine/automaton/machine.schema.json").read_text())
    Draft7Validator.check_schema(schema)
    validator = Draft7Validator(schema)
    failures = []
    for file in sorted((source / "engine/knowledge/machines").glob("*.json")):
        failures += [f"{file}: {error.json_path}: {error.message}" for error in validator.iter_errors(parse(file.read_text()))]
    machine, rows = rows_of((source / "tests/machine_file/machine_errors.txt").read_text())
    failures += [f"the table's machine: {error.message}" for error in validator.iter_errors(parse(machine))]
    if sum(refused for edits, refused in rows) < 100:
        failures.append("hardly any row of the table is for the schema")
    for edits, refused in rows:
        text = machine
        for old, new in edits:
            text = text.replace(old, new, 1)
        try:
            found = not validator.is_valid(parse(text))
        except ValueError:
            found = False
        if found != refused:
            failures.append(f"{edits}: {'accepted' if refused else 'refused'} by the schema")
    print("\n".join(failures) or f"{len(rows)} broken machines")
    return bool(failures)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
