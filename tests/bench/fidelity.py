#!/usr/bin/env python3
"""How faithful the machine diana2018 is to the recorded system: scores session logs and writes the page about it.

    tests/bench/fidelity.py build/continua LOG... [-o PAGE] [-j N] [--ablations]

Logs are VoxSim's, named NAME<number>-DATE...; what stands before the first '-' is the participant.
"""
import argparse
import json
import os
import pathlib
import random
import re
import string
import subprocess
import sys
import tempfile
import time

from fidelity_baselines import baselines

HERE = pathlib.Path(__file__).resolve().parent
MACHINE = HERE.parents[1] / "engine" / "knowledge" / "machines" / "diana2018.json"
VARIANTS = ("free", "world", "teacher")
RESAMPLES, SEED = 2000, 2018


class Program:
    def __init__(self, path, jobs):
        self.path, self.jobs = os.path.abspath(path), str(jobs)

    def run(self, what, *arguments):
        """Its output. Tells how long it took."""
        begun = time.monotonic()
        done = subprocess.run([self.path, *map(str, arguments)], stdout=subprocess.PIPE, text=True)
        if done.returncode:
            sys.exit(f"fidelity.py: {what} ended with status {done.returncode}")
        print(f"{what}: {time.monotonic() - begun:.1f} s", flush=True)
        return done.stdout

    def score(self, what, traces, variant, *options):
        return json.loads(self.run(f"scoring {what}, {variant}", "score", *traces, "--variant", variant, "--json",
                                   "-j", self.jobs, *options))


def participant(trace):
    return trace.split("-")[0]


def short(name):
    return "P" + re.search(r"\d+$", name).group()


def check_names(logs):
    names = {participant(log.name) for log in logs}
    for name in names:
        if not re.search(r"\d$", name):
            sys.exit(f"fidelity.py: {name}: the name of a participant does not end in a number")
    if len({short(name) for name in names}) < len(names):
        sys.exit("fidelity.py: two participants have the same number")


def by_participant(report):
    """Participant -> the scores of the sessions, in numeric order."""
    sessions = {}
    for trace in report["traces"]:
        sessions.setdefault(participant(trace["trace"]), []).append(trace)
    return dict(sorted(sessions.items(), key=lambda item: int(short(item[0])[1:])))


def total(scores, count):
    return sum(score[count] for score in scores)


def interval(report):
    """Where 95 % of the shares lie that participants drawn with replacement would give."""
    people = [(total(scores, "lax"), total(scores, "speaking")) for scores in by_participant(report).values()]
    draw = random.Random(SEED)
    shares = []
    for _ in range(RESAMPLES):
        sample = draw.choices(people, k=len(people))
        shares.append(sum(lax for lax, _ in sample) / max(1, sum(speaking for _, speaking in sample)))
    shares.sort()
    return shares[round(0.025 * RESAMPLES)], shares[round(0.975 * RESAMPLES) - 1]


def percent(count, of):
    return f"{100 * count / of:.1f} %" if of else "–"


def counted(count, of):
    return f"{count} ({percent(count, of)})"


def table(head, rows):
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    return "\n".join("| " + " | ".join(str(cell).replace("|", "\\|") for cell in line) + " |" for line in lines)


def pooled(reports):
    rows = []
    for variant, report in reports.items():
        score = report["total"]
        low, high = interval(report)
        rows.append([variant] + [counted(score[level], score["speaking"]) for level in ("exact", "lax", "template")]
                    + [f"{100 * low:.1f} – {100 * high:.1f} %", f"{score['f1']:.3f}",
                       counted(score["spurious"], score["speaking"]), percent(score["right"], score["inputs"]),
                       f"{score['silent_samples']} of {score['samples']}"])
    return table(["variant", "exact", "lax", "template", "lax, 95 % interval", "F1", "spurious", "inputs right",
                  "silent on pointing"], rows)


def participants(reports):
    rows = []
    people = {variant: by_participant(report) for variant, report in reports.items()}
    for name, scores in people["teacher"].items():
        speaking = total(scores, "speaking")
        rows.append([short(name), len(scores), speaking]
                    + [percent(total(people[variant][name], "lax"), speaking) for variant in VARIANTS]
                    + [total(scores, "spurious")])
    return table(["participant", "sessions", "speaking", *VARIANTS, "spurious, teacher"], rows)


def kinds(reports):
    lax = {variant: {kind["kind"]: kind["lax"] for kind in report["kinds"]} for variant, report in reports.items()}
    return table(["kind of move", "n", *VARIANTS],
                 [[kind["kind"], kind["speaking"]]
                  + [percent(lax[variant][kind["kind"]], kind["speaking"]) for variant in VARIANTS]
                  for kind in reports["teacher"]["kinds"]])


def baseline_table(traces):
    rows, inputs, speaking = baselines(traces)
    return table(["avatar", "inputs right", "speaking episodes right"],
                 [[name, percent(right, inputs), percent(spoken, speaking)] for name, right, spoken in rows])


def without_rules(traces, folder):
    """The traces without the parameters of their time, so that the machine's own rules count."""
    folder.mkdir()
    for trace in traces:
        header, _, events = trace.read_text(encoding="utf-8").partition("\n")
        fields = json.loads(header)
        fields.pop("parameters", None)
        (folder / trace.name).write_text(json.dumps(fields) + "\n" + events, encoding="utf-8")
    return sorted(folder.iterdir())


def machines(folder):
    """Each left-out rule, and the machine without it."""
    def changed(name, change):
        machine = json.loads(MACHINE.read_text(encoding="utf-8"))
        change(machine)
        path = folder / f"{name}.json"
        path.write_text(json.dumps(machine), encoding="utf-8")
        return path

    return {
        "the gates: every gesture counts as certain":
            changed("gates", lambda machine: machine["define"].update(certain="true")),
        "saying nothing twice in a row":
            changed("repeats", lambda machine: machine.update(repeat_utterances=True)),
        "believing words it has said itself":
            changed("overheard", lambda machine: machine["beliefs"].pop("overheard")),
        "the leak: null slots of a rewrite show what lies below":
            changed("leak", lambda machine: machine.update(rewrite_below=False)),
    }


def ablations(program, traces, reports, folder):
    rows = [("nothing", reports["world"], reports["teacher"])]
    scored = [("the dates of rules: the last rules count for all", without_rules(traces, folder / "rules"), [])]
    scored += [(name, traces, ["--machine", machine]) for name, machine in machines(folder).items()]
    for name, paths, options in scored:
        rows.append([name] + [program.score(name, paths, variant, *options) for variant in ("world", "teacher")])
    return table(["left out", "lax, world", "lax, teacher", "spurious, teacher"],
                 [[name] + [percent(report["total"]["lax"], report["total"]["speaking"]) for report in (world, teacher)]
                  + [teacher["total"]["spurious"]] for name, world, teacher in rows])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("continua")
    parser.add_argument("logs", nargs="+", type=pathlib.Path, metavar="LOG")
    parser.add_argument("-o", dest="page", type=pathlib.Path, help="the page to write")
    parser.add_argument("-j", dest="jobs", type=int, default=1, help="how many traces at a time")
    parser.add_argument("--ablations", action="store_true", help="also score the machine without some of its rules")
    options = parser.parse_args()
    check_names(options.logs)
    program = Program(options.continua, options.jobs)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        imported = folder / "traces"
        imported.mkdir()
        program.run(f"importing {len(options.logs)} logs", "import", *options.logs, "-o", imported)
        traces = sorted(imported.iterdir())
        reports = {variant: program.score("diana2018", traces, variant) for variant in VARIANTS}
        parts = {"logs": len(traces), "participants": len(by_participant(reports["teacher"])),
                 **{count: reports["teacher"]["total"][count] for count in ("inputs", "speaking")},
                 "misses": sum(len(trace["misses"]) for trace in reports["teacher"]["traces"]),
                 "pooled": pooled(reports), "by_participant": participants(reports), "kinds": kinds(reports),
                 "baselines": baseline_table(traces),
                 "ablations": ablations(program, traces, reports, folder) if options.ablations
                 else "Not measured; `--ablations` does."}
    print(parts["pooled"])
    if options.page:
        text = string.Template((HERE / "fidelity_page.md").read_text(encoding="utf-8"))
        options.page.write_text(text.substitute(parts), encoding="utf-8")


if __name__ == "__main__":
    main()
