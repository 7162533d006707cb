"""Candidates of one n-best list that are about as likely and lead to different acts are asked about, one by one."""
import itertools

import things


def shown(*candidates):
    return [{"event": {"kind": "gesture", "phase": "start",
                       "alternatives": [{"name": name, "confidence": sure} for name, sure in candidates]}}]


def said(*candidates):
    return [{"event": {"kind": "speech", "alternatives": [{"text": text, "confidence": sure} for text, sure in candidates]}}]


def ways(thing, name, other, other_name):
    lift, take, lift_other = [f"lift {thing}"], [f"take {thing}"], [f"lift {other}"]
    yield "the first gesture", [name, shown(("lift", 0.45), ("grab", 0.44)), "yes"], lift
    yield "the second gesture", [name, shown(("lift", 0.45), ("grab", 0.44)), "no", "yes"], take
    yield "the other order", [name, shown(("grab", 0.47), ("lift", 0.44)), "no", "yes"], lift
    yield "a nod", [name, shown(("grab", 0.5), ("lift", 0.49)), [{"gesture": "negack"}], [{"gesture": "posack"}]], lift
    yield "three gestures", [name, shown(("turn", 0.33), ("grab", 0.32), ("lift", 0.31)), "no", "no", "yes"], lift
    yield "neither", [name, shown(("grab", 0.45), ("turn", 0.44)), "no", "no", f"lift {name}"], lift
    yield "said instead", [name, shown(("grab", 0.45), ("turn", 0.44)), f"lift {other_name}"], lift_other
    yield "no tie", [name, shown(("lift", 0.6), ("grab", 0.3))], lift
    yield "one meaning", [name, shown(("grab", 0.45), ("claw", 0.44))], take
    yield "verbs", [said((f"lift {name}", 0.5), (f"turn {name}", 0.48)), "yes"], lift
    yield "verbs, the second", [said((f"turn {name}", 0.5), (f"lift {name}", 0.48)), "no", "yes"], lift
    yield "things", [said((f"lift {name}", 0.5), (f"lift {other_name}", 0.49)), "no", "yes"], lift_other
    yield "yes or no", [[{"event": {"kind": "speech", "text": f"lift {name}", "confidence": 0.2}}],
                        said(("yes", 0.46), ("no", 0.45)), "yes"], lift
    yield "one is nothing", [said((f"lift {name}", 0.5), ("fnord", 0.49))], lift


def members():
    everything = list(things.everything())
    pairs = [(a, b) for a, b in itertools.pairwise(everything) if a[0] == b[0]]
    for k, ((scene, thing, name), (_, other, other_name)) in enumerate(pairs):
        for i, (way, turns, acts) in enumerate(ways(thing, name, other, other_name)):
            if (i + k) % 4 == 0:
                yield {"id": f"near_ties {scene} {thing} {way}", "scene": scene, "say": turns, "expect": {"acts": acts}}
