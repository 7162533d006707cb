#!/usr/bin/env python3
"""Holds dialogues under every policy: where one behaviour is sensible, all of them do the same acts.

choices_test.py PROGRAM SOURCE_FOLDER [--seeds N]

The family has dialogues over the four scenes: things named or pointed at, commands whole or in pieces, questions with a no
and a yes, corrections, and what is taken back. Each is replayed without physics under likeliest, explore, unique and sample, the
last with several seeds. No transition of theirs may have a rival of the same weight, since only the order of the file would
decide between the two; and the text of the machine must show that it has no rivals of one rank.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

SEEDS = 3
FEWEST = 20


def dialogues(things):
    """(name, scene, turns): turns as in an exam."""
    for scene, names in things.UNIQUE.items():
        free = things.FREE[scene]
        several, them = next(iter(things.SHARED.get(scene, {}).items()), (None, []))
        thing, name = next((each, word) for each, word in names.items() if "cup" in each or "block" in each)
        at = things.where(scene, thing)
        yield f"{scene}: named, then told where", scene, [name, ["put it there", {"point": free, "at": 0.3}]]
        yield f"{scene}: predicate first", scene, [["put it there", {"point": free, "at": 0.3}], name]
        yield f"{scene}: in one breath", scene, [f"put {name} in front of you"]
        yield f"{scene}: pointed at", scene, [["take this", {"point": at, "at": 0.3}]]
        yield f"{scene}: taken back", scene, [f"put {name} there", "never mind", f"take {name}"]
        yield f"{scene}: corrected before the command", scene, [name, f"no, {list(names.values())[-1]}", "take it"]
        yield f"{scene}: again and let go", scene, [f"take {name}", "let go of it", f"take {name}"]
        if several:
            yield f"{scene}: yes to the first of several", scene, [f"take {several}", "yes"]
            yield f"{scene}: no, then yes", scene, [f"take {several}", "no", "yes"]
            yield f"{scene}: told which", scene, [f"take {several}", ["this one", {"point": things.where(scene, them[0]), "at": 0.3}]]


def acts_of(log):
    """The programs of the acts that were asked for, and the steps at which only the order of the file decided."""
    acts, ties = [], []
    for record in map(json.loads, log.read_text(encoding="utf-8").splitlines()):
        if record["kind"] == "act" and record["status"] == "asked":
            acts.append(record["program"])
        if record["kind"] == "transition":
            heaviest = max((each["weight"] for each in record["candidates"]), default=0)
            rivals = [each["id"] for each in record["candidates"] if each["weight"] == heaviest]
            ties += [rivals] if len(rivals) > 1 else []
    return acts, ties


def replayed(program, traces, folder, *options):
    subprocess.run([program, "replay", *traces, "--no-physics", "-j", "2", "-o", f"{folder}/", *options],
                   check=True, stdout=subprocess.DEVNULL)
    return {path.name: acts_of(path) for path in sorted(pathlib.Path(folder).glob("*.run.jsonl"))}


def main(program, source, *arguments):
    sys.path[:0] = [str(pathlib.Path(source, "tests", each)) for each in ("family", "exam")]
    import run_exam  # noqa: E402  (found in the folder of the exams)
    import things  # noqa: E402
    seeds = int(arguments[arguments.index("--seeds") + 1]) if "--seeds" in arguments else SEEDS
    policies = {policy: ["--choice", policy] for policy in ("unique", "explore")}
    policies.update({f"sample, seed {seed}": ["--choice", "sample", "--seed", str(seed)] for seed in range(seeds)})
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        names, traces = {}, []
        for n, (name, scene, turns) in enumerate(dialogues(things)):
            traces.append(f"{folder}/{n:02}.trace.jsonl")
            names[f"{n:02}.run.jsonl"] = name
            run_exam.write_trace({"scene": scene, "say": turns}, traces[-1])
        if len(traces) < FEWEST:
            failures.append(f"{len(traces)} dialogues, expected at least {FEWEST}")
        usual = replayed(program, traces, f"{folder}/likeliest")
        failures += [f"{names[run]}: only the order of the file decides between {ties}" for run, (_, ties) in usual.items()
                     if ties]
        failures += [f"{names[run]}: no act" for run, (acts, _) in usual.items() if not acts]
        for policy, options in policies.items():
            for run, (acts, _) in replayed(program, traces, f"{folder}/{policy}", *options).items():
                if acts != usual[run][0]:
                    failures.append(f"{names[run]}: {policy} does {acts}, likeliest {usual[run][0]}")
    told = subprocess.run([program, "machine", "interaction"], check=True, capture_output=True, text=True).stdout
    rivals = [line for line in told.splitlines() if line.startswith("  in ")]
    failures += [f"rivals of one rank: {line.strip()}" for line in rivals]
    print(*failures, sep="\n", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
