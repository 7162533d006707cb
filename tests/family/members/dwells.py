"""A finger that dwells counts with all its samples: its first may still be on the way, and the hand trembles."""
import random

import things

TREMBLE_M = 0.02
# How far off the first samples are, how many they are, and samples a second.
OFFSETS = [(0.1, 1, 30), (0.08, 2, 25), (0.1, 2, 20), (0.06, 3, 30)]


def dwell(place, begin, seconds, rng, off=None, hand="right"):
    """Samples around a place; the first ones are off."""
    away, first, rate = off or (0, 0, 30)
    angle = rng.choice([(1, 0), (-1, 0), (0, 1), (0, -1), (0.7, 0.7), (-0.7, 0.7)])
    for k in range(int(seconds * rate)):
        x, y = (place[i] + rng.gauss(0, TREMBLE_M) + (away * angle[i] if k < first else 0) for i in (0, 1))
        confidence = 0.5 if k < first else 0.9
        yield {"event": {"kind": "pointing", "hand": hand, "target": [round(x, 4), round(y, 4)], "confidence": confidence}, "at": round(begin + k / rate, 3)}


def in_time(*parts):
    return sorted(parts, key=lambda part: part["at"])


def ways(scene, thing, name, place, rng):
    off = rng.choice(OFFSETS)
    yield "before", [in_time(*dwell(place, 0, 1.2, rng, off), {"say": "lift that one", "at": 1.0})], f"lift {thing}"
    yield "with", [in_time(*dwell(place, 0.4, 1.0, rng, off), {"say": "lift that one", "at": 0.4})], f"lift {thing}"
    yield "late", [in_time(*dwell(place, 1.3, 1.0, rng, off), {"say": "lift this", "at": 0.4})], f"lift {thing}"
    start = next(dwell(place, 0.9, 1.0, rng, (0.1, 1, 1)))
    stroke = {"event": {**start["event"], "kind": "gesture", "name": "point", "phase": "start"}, "at": 0.9}
    yield "begun off", [in_time(stroke, *dwell(place, 0.92, 1.0, rng, (0.06, 1, 30)), {"say": "lift that one", "at": 0.8})], f"lift {thing}"
    yield "begun off, late", [in_time({**stroke, "at": 1.4}, *dwell(place, 1.42, 1.0, rng, (0.06, 1, 30)), {"say": "lift this", "at": 0.4})], f"lift {thing}"
    yield "no place at first", [in_time({"event": {"kind": "gesture", "name": "point", "hand": "right", "phase": "start"}, "at": 0.3}, *dwell(place, 0.3, 1.0, rng, off), {"say": "lift that one", "at": 0.4})], f"lift {thing}"


def members():
    for seed, (scene, thing, name) in enumerate(things.everything()):
        rng = random.Random(seed)
        place = things.where(scene, thing)
        for way, say, act in ways(scene, thing, name, place, rng):
            yield {"id": f"dwells {scene} {thing} {way}", "scene": scene, "say": say, "expect": {"acts": [act]}}
        # Two dwells for two words.
        there = things.FREE[scene]
        say = [in_time(*dwell(place, 0.3, 0.7, rng, rng.choice(OFFSETS)), {"say": "put that there", "at": 0.4}, *dwell(there, 1.25, 0.8, rng, (0.06, 1, 30)))]
        yield {"id": f"dwells {scene} {thing} two", "scene": scene, "say": say, "expect": {"acts": [f"put {thing} at"]}}
