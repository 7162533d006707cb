#!/usr/bin/env python3
"""Runs the benchmarks and prints one table: each figure as a ratio to its reference in the same run, with that of the last release.

  tests/bench/run_all.py build [SESSION.txt …] [--release VERSION]

SESSION.txt are recorded sessions; without them the rows about recordings are left out. --release keeps the figures, as those of
VERSION, in tests/bench/figures.json and in the README's table. Ends with status 1 if a figure is worse by more than a tenth.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
KEPT = HERE / "figures.json"
README = ROOT / "README.md"
BEGIN, END = "<!-- figures: tests/bench/run_all.py -->\n", "<!-- end of figures -->\n"
TOLERANCE = 0.1
OTHERS = {"transitions": "Python's transitions"}
VARIANTS = {"finite": "transitions without a stack", "stack": "transitions that push or pop", "guarded": "guarded transitions"}


def output(*command):
    """The output of a benchmark; empty, with a remark, if it could not run."""
    print(f"{pathlib.Path(command[0]).name} …", file=sys.stderr)
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if done.returncode != 0:
        print(f"left out: {pathlib.Path(command[0]).name}: {done.stderr.strip().splitlines()[-1:]}", file=sys.stderr)
        return ""
    return done.stdout


def cells(text, first):
    """The cells of the table's row that begins with `first`."""
    rows = [[cell.strip() for cell in line.strip("| ").split("|")] for line in text.splitlines()]
    return next((row for row in rows if row and row[0] == first), None)


def of_automaton(build):
    text = output(HERE / "compare.py", build)
    heads = re.search(r"^ +Continua +(.*)$", text, re.M)
    others = re.findall(r"(\S+) +ratio", heads[1]) if heads else []
    for variant, words in VARIANTS.items():
        row = re.search(rf"^{variant} +(.*)$", text, re.M)
        values = row[1].split()[1:] if row else []
        for other, ratio in zip(others, values[1::2]):
            if ratio != "-":
                yield {"what": words, "reference": OTHERS.get(other, other), "ratio": float(ratio), "better": "more"}


def of_log(build, sessions):
    examples = sorted((ROOT / "traces" / "paper").glob("*.trace.jsonl"))
    for what, files in (("replay of the worked examples, with its log", examples), ("replay of recorded sessions, with its log", sessions)):
        row = files and cells(output(build / "tests" / "bench_log", *files), "all")
        if row:
            yield {"what": what, "reference": "nlohmann/json, parse and dump of that log", "ratio": float(row[5]), "better": "less"}
            yield {"what": what, "reference": "the same without writing the log", "ratio": float(row[6]), "better": "less"}


def of_physics(build, sessions):
    row = sessions and cells(output(build / "tests" / "bench_physics", *sessions), "all")
    if row:
        yield {"what": "replay of recorded sessions with physics", "reference": "mj_step alone", "ratio": float(row[4]), "better": "less"}


def of_diff(build):
    text = output(HERE / "bench_diff.py", build / "continua")
    for first, what in (("cold", "diff of two runs of a million records"), ("with indexes", "the same with their indexes")):
        row = cells(text, first)
        if row:
            yield {"what": what, "reference": "diff -u", "ratio": float(row[2]), "better": "less"}


def key(figure):
    return f"{figure['what']} / {figure['reference']}"


def is_worse(figure, before):
    if before is None:
        return False
    now = figure["ratio"]
    return now < before * (1 - TOLERANCE) if figure["better"] == "more" else now > before * (1 + TOLERANCE)


def table(figures, release):
    """Lines of the table in Markdown; `release`: {"version", "figures": {key: ratio}}."""
    yield f"| what is measured | as a ratio to | now | {release['version']} | |"
    yield "| --- | --- | --- | --- | --- |"
    for figure in figures:
        before = release["figures"].get(key(figure))
        verdict = "worse" if is_worse(figure, before) else ""
        yield (f"| {figure['what']} | {figure['reference']}, {figure['better']} is better | {figure['ratio']:g} | "
               f"{'–' if before is None else format(before, 'g')} | {verdict} |")


def keep(figures, version):
    KEPT.write_text(json.dumps({"version": version, "figures": {key(f): f["ratio"] for f in figures}}, indent=2, ensure_ascii=False) + "\n", "utf-8")
    lines = ["| what is measured | as a ratio to | figure |", "| --- | --- | --- |"]
    lines += [f"| {f['what']} | {f['reference']}, {f['better']} is better | {f['ratio']:g} |" for f in figures]
    page = README.read_text("utf-8")
    before, rest = page.split(BEGIN)
    README.write_text(before + BEGIN + "\n".join(lines) + "\n" + END + rest.split(END)[1], "utf-8")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("build", type=pathlib.Path)
    arguments.add_argument("sessions", nargs="*", type=pathlib.Path)
    arguments.add_argument("--release", metavar="VERSION")
    options = arguments.parse_args()
    build = options.build.resolve()
    figures = [*of_automaton(build), *of_log(build, options.sessions), *of_physics(build, options.sessions), *of_diff(build)]
    release = json.loads(KEPT.read_text("utf-8")) if KEPT.exists() else {"version": "before", "figures": {}}
    print("\n".join(table(figures, release)))
    if options.release:
        keep(figures, options.release)
    return any(is_worse(figure, release["figures"].get(key(figure))) for figure in figures)


if __name__ == "__main__":
    sys.exit(main())
