#!/usr/bin/env python3
"""A live session of many hours: how long an answer takes at its end, against its start.

    tests/bench/bench_hours.py build [HOURS]

The session hears ten inputs a second of its own time, without physics and without waiting: nods, pointings that go from
place to place, and an order every ten seconds. An answer's time is the processor time of `hear`. The table has it by hour,
with the memory that the process holds.
"""
import pathlib
import resource
import statistics
import sys
import time

INPUTS_A_SECOND = 10
ORDERS_S = 10
ORDERS = ["Put the knife on the plate.", "Take the cup.", "The blue one.", "Put it down.", "Where is the knife?", "Never mind."]


def input_at(number):
    """The input of this number and whether it is an order."""
    t = round(number / INPUTS_A_SECOND, 3)
    turn, between = divmod(number, ORDERS_S * INPUTS_A_SECOND)
    if between == 0:
        return {"t": t, "kind": "speech", "text": ORDERS[turn % len(ORDERS)]}, True
    if between % 2:
        return {"t": t, "kind": "gesture", "name": "posack", "phase": "stroke"}, False
    across = (between % 40 - 20) / 100
    return {"t": t, "kind": "pointing", "hand": "right", "target": [across, 0.2]}, False


def held_mb():
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize() / 1e6


def main(build, hours):
    sys.path.insert(0, str(build.resolve() / "python"))
    import continua  # noqa: PLC0415, it is where the build is

    session = continua.Session(scene="place_setting", physics=False)
    print("| hour | inputs | all answers, ms: median, 99 % | answers to orders, ms: median, 99 % | memory, MB |\n| --- | --- | --- | --- | --- |")
    number = 0
    for hour in range(1, hours + 1):
        every, orders = [], []
        while number < hour * 3600 * INPUTS_A_SECOND:
            event, is_order = input_at(number)
            before = time.process_time()
            session.hear(event)
            taken = 1000 * (time.process_time() - before)
            (orders if is_order else every).append(taken)
            number += 1
        told = [f"{statistics.median(times):.2f}, {statistics.quantiles(times, n=100)[-1]:.2f}" for times in (every, orders)]
        print(f"| {hour} | {number} | {told[0]} | {told[1]} | {held_mb():.0f} |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 12)
