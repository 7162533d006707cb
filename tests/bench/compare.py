#!/usr/bin/env python3
"""Compares the automaton with XState and Python's transitions: README.md. Argument: the build tree."""
import json
import math
import os
import pathlib
import shutil
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
VARIANTS = ("finite", "stack", "guarded")
ROUNDS = 5


def run(command, **more):
    return subprocess.run(command, check=True, capture_output=True, text=True, **more).stdout


def continua(build, folder):
    out = run([build / "tests" / "bench_automaton", "--benchmark_format=json"],
              env={**os.environ, "CONTINUA_BENCH": str(folder)})
    rows = {row["name"]: row for row in json.loads(out)["benchmarks"]}
    speeds = {name: rows[f"step/{name}"]["items_per_second"] for name in VARIANTS}
    times = {int(name.split("/")[1]): row["cpu_time"] for name, row in rows.items() if name.startswith("accept/")}
    return speeds, times


def xstate(folder):
    """A function that measures XState, or why there is none."""
    packages = folder / "npm"
    packages.mkdir(exist_ok=True)
    for name in ("package.json", "package-lock.json"):
        shutil.copy(HERE / name, packages)
    try:
        run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=packages)
    except (OSError, subprocess.CalledProcessError):
        return None, "npm could not install it"
    return lambda: json.loads(run(["node", HERE / "xstate.mjs", folder, packages])), ""


def transitions(folder):
    python = next((one for one in (sys.executable, "/usr/bin/python3")
                   if subprocess.run([one, "-c", "import transitions"], capture_output=True).returncode == 0), None)
    if python is None:
        return None, "not installed: apt-get install python3-transitions"
    return lambda: json.loads(run([python, HERE / "transitions_py.py", folder])), ""


def exponent(times):
    """Slope of the line through the points (log length, log time)."""
    x, y = [math.log(n) for n in times], [math.log(t) for t in times.values()]
    mean_x, mean_y = statistics.mean(x), statistics.mean(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def main():
    if len(sys.argv) != 2 or not (pathlib.Path(sys.argv[1]) / "tests" / "bench_automaton").exists():
        sys.exit("usage: compare.py BUILD, a build tree with the target bench_automaton")
    build = pathlib.Path(sys.argv[1]).resolve()
    folder = build / "tests" / "bench"
    run([sys.executable, HERE / "make_machines.py", folder])
    others = {"XState": xstate(folder), "transitions": transitions(folder)}
    for name, (_, problem) in others.items():
        if problem:
            print(f"without {name}: {problem}")
    speeds = {name: {variant: [] for variant in VARIANTS} for name in ("Continua", *others)}
    times = {}
    for _ in range(ROUNDS):
        own, accepting = continua(build, folder)
        for length, milliseconds in accepting.items():
            times.setdefault(length, []).append(milliseconds)
        for name, one in [("Continua", own)] + [(name, measure()) for name, (measure, _) in others.items() if measure]:
            for variant in VARIANTS:
                speeds[name][variant].append(one[variant])

    print(f"transitions per second, median of {ROUNDS}")
    print(f"{'':10}{'Continua':>14}" + "".join(f"{name:>14}{'ratio':>8}" for name in others))
    for variant in VARIANTS:
        own = statistics.median(speeds["Continua"][variant])
        row = f"{variant:10}{own:14,.0f}"
        for name in others:
            values = speeds[name][variant]
            row += f"{statistics.median(values):14,.0f}{own / statistics.median(values):8.2f}" if values else f"{'-':>14}{'-':>8}"
        print(row)
    medians = {length: statistics.median(values) for length, values in sorted(times.items())}
    print("palindromes: " + ", ".join(f"{n} letters {t:.3g} ms" for n, t in medians.items())
          + f"; time grows as length^{exponent(medians):.2f}")


main()
