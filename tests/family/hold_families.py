#!/usr/bin/env python3
"""Holds the families: each mechanism of the paper in many variants, all of which must end as they should.

  tests/family/hold_families.py build/continua [NAME ...] [--physics] [--all]

A family is a file in members/: its function members() yields items as in an exam (../exam/run_exam.py), at least 20 of
them, with other scenes, things, orders, times and modalities. An id is the family's name, a space,
and what tells the item from the others. Without a NAME all families are held. --physics holds them in the physics world.
Ends with status 1 if an item went otherwise.
"""
import importlib.util
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent / "exam")]
import run_exam  # noqa: E402  (found in the folder of the exams)

FEWEST = 20


def members_of(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    family = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(family)
    return list(family.members())


def main(program, *arguments):
    names = [each for each in arguments if not each.startswith("--")]
    paths = sorted(path for path in (FOLDER / "members").glob("*.py") if not names or path.stem in names)
    if not paths or len(names) > len(paths):
        sys.exit(f"found {[path.stem for path in paths]}, expected families of these names: {names}")
    items, few = [], []
    for path in paths:
        members = members_of(path)
        few += [f"{path.stem}: {len(members)} members, expected at least {FEWEST}"] if len(members) < FEWEST else []
        items += members
    print(*few, sep="\n", end="\n" if few else "")
    return run_exam.hold(program, items, "--physics" in arguments, "--all" in arguments) and not few


if __name__ == "__main__":
    sys.exit(0 if main(*sys.argv[1:]) else 1)
