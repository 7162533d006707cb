#!/usr/bin/env python3
"""The page about two small logs, whose figures were counted by hand, and what must hold of the recorded study.

fidelity_test.py PROGRAM SOURCE_FOLDER
"""
import pathlib
import subprocess
import sys
import tempfile

ALL_AGREES = [("HG", "engage start"), ("AS", '"Hello."'), ("HS", "GREEN"), ("AS", '"OK, go on."'), ("AG", "reach(block4)"),
              ("HS", "RED"), ("AS", '"Should I put the green block on the red block?"'), ("AG", "look_at(block6)"),
              ("HG", "engage stop"), ("AS", '"Bye!"')]
# The system, for once, took yellow for green, and no "Bye!" was said.
NOT_ALL = [("HG", "engage start"), ("AS", '"Hello."'), ("HP", "r,0.10,0.70"), ("HP", "r,0.10,0.71"),
           ("HS", "GREEN"), ("AS", '"OK, go on."'), ("AG", "reach(block1)"),
           ("HS", "RED"), ("AS", '"Should I put the yellow block on the red block?"'), ("AG", "look_at(block6)"),
           ("HS", "WHAT"), ("HG", "engage stop")]
LOGS = {"Trial10-2018-02-13-100000.txt": ALL_AGREES, "Trial2-2018-02-13-110000.txt": NOT_ALL}

ASTRAY = "5 (71.4 %) | 5 (71.4 %) | 7 (100.0 %) | 33.3 – 100.0 % | 0.667 | 1 (14.3 %) | 66.7 % | 2 of 2"
LED = "6 (85.7 %) | 6 (85.7 %) | 7 (100.0 %) | 66.7 – 100.0 % | 0.800 | 1 (14.3 %) | 77.8 % | 2 of 2"
ROWS = [f"| free | {ASTRAY} |", f"| world | {ASTRAY} |", f"| teacher | {LED} |",
        "| P2 | 1 | 3 | 33.3 % | 33.3 % | 66.7 % | 1 |\n| P10 | 1 | 4 | 100.0 % | 100.0 % | 100.0 % | 0 |",
        "| always silent | 22.2 % | 0.0 % |",
        "| bigram table, templates | 77.8 % | 85.7 % |",
        "| bigram table, exact words | 55.6 % | 57.1 % |",
        "| Should I put the _ block on the _ block? | 2 | 50.0 % | 50.0 % | 100.0 % |",
        "| nothing | 71.4 % | 85.7 % | 1 |"]
GOALS = {"free": 65, "world": 80, "teacher": 93}


def written(folder):
    logs = []
    for name, rows in LOGS.items():
        seconds, lines = 0, []
        for index, (channel, content) in enumerate(rows, 1):
            seconds += channel[0] == "H"
            lines.append(f"{index}\t{channel}\t{content}\t{seconds}\n")
        logs.append(pathlib.Path(folder, name))
        logs[-1].write_text("".join(lines), encoding="utf-8")
    return logs


def page_of(program, source, logs, folder, *options):
    page = pathlib.Path(folder, "page.md")
    subprocess.run([sys.executable, source / "tests/bench/fidelity.py", program, *logs, "-o", page, "-j", "2", *options],
                   check=True, stdout=subprocess.DEVNULL)
    return page.read_text(encoding="utf-8")


def by_hand(program, source, folder):
    logs = written(folder)
    page = page_of(program, source, logs, folder, "--ablations")
    failures = [f"the page does not have\n{row}" for row in ROWS if row not in page]
    if page_of(program, source, logs[::-1], folder, "--ablations") != page:
        failures.append("the same logs in another order make another page")
    return failures + [f"the page names {name}" for name in ("Trial", "100000", "110000") if name in page]


def cells(page, variant):
    """The cells of its row in the table of all sessions, the widest table."""
    rows = [line for line in page.splitlines() if line.startswith(f"| {variant} | ")]
    return [cell.strip() for cell in max(rows, key=lambda row: row.count("|")).strip("|").split("|")][1:]


def share(cell):
    return float(cell.partition("(")[2].partition(" %")[0])


def goals(program, source, folder):
    logs = sorted((source / "../shared/data/pilot2018").glob("*.txt"))
    if not logs:
        print("without the recorded study")
        return []
    page, failures = page_of(program, source, logs, folder), []
    for variant, lax in GOALS.items():
        found = cells(page, variant)
        print(variant, *found)
        silent, samples = found[7].split(" of ")
        if share(found[1]) < lax:
            failures.append(f"{variant}: {found[1]} agree lax, expected {lax} %")
        if share(found[5]) > 3:
            failures.append(f"{variant}: {found[5]} are spurious, expected at most 3 %")
        if silent != samples:
            failures.append(f"{variant}: silent on {silent} of {samples} samples of pointing")
    return failures


def main(program, source):
    source = pathlib.Path(source)
    with tempfile.TemporaryDirectory() as folder:
        failures = by_hand(program, source, folder) + goals(program, source, folder)
    print(*failures, sep="\n", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
