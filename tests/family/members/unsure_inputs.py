"""Thresholds for each kind of input: what is unsure is confirmed, what is very unsure is ignored, in every modality."""
import itertools

import things

UNSURE, NOISE = 0.2, 0.05


def said(text, confidence):
    return [{"event": {"kind": "speech", "text": text, "confidence": confidence}}]


def shown(name, confidence):
    return [{"event": {"kind": "gesture", "name": name, "phase": "start", "confidence": confidence}}]


def pointed(place, confidence, hand="right"):
    """Half a second of samples with a gesture-like steadiness, as parts of a turn."""
    return [{"event": {"kind": "pointing", "hand": hand, "target": place, "confidence": confidence}, "at": round(k / 30, 3)}
            for k in range(20)]


def ways(scene, thing, name, other, other_name):
    """The turns of each way, with the act that they end in."""
    lift = [f"lift {thing}"]
    yield "command and yes", [said(f"lift {name}", UNSURE), said("yes", UNSURE), "yes"], lift
    yield "command and nod", [said(f"lift {name}", UNSURE), shown("posack", UNSURE), shown("posack", 1)], lift
    yield "noise is no answer", [said(f"lift {name}", UNSURE), said("no", NOISE), "yes"], lift
    yield "a gesture of noise", [said(f"lift {name}", UNSURE), shown("negack", NOISE), "yes"], lift
    yield "no that was none", [said(f"lift {name}", UNSURE), said("no", UNSURE), "no", "yes"], lift
    yield "no after the act", [f"lift {name}", said("no", UNSURE), "no"], lift
    yield "something else at once", [said(f"lift {name}", UNSURE), said("yes", UNSURE), f"lift {other_name}"], [f"lift {other}"]
    yield "phrase and yes", [said(name, UNSURE), "yes", "lift it"], lift
    yield "phrase and no", [name, said(other_name, UNSURE), "no", "lift it"], lift
    yield "lesson", [shown("wax", 1), said(f"lift {name}", UNSURE), "yes", shown("wax", 1)], lift
    yield "lesson not meant", [shown("wax", 1), said(f"lift {other_name}", UNSURE), "no", f"lift {name}", shown("wax", 1)], lift
    yield "lesson without the question", [shown("wax", 1), said(f"lift {other_name}", NOISE), f"lift {name}", shown("wax", 1)], lift
    there, elsewhere = things.where(scene, thing), things.where(scene, other)
    yield "samples of noise", [[*pointed(there, 0.9), *pointed(elsewhere, NOISE), {"say": "lift that one", "at": 0.3}]], lift
    yield "weak samples", [[*pointed(elsewhere, 0.3), *pointed(there, 1), {"say": "lift that one", "at": 0.3}]], lift
    point = {"kind": "gesture", "name": "point", "phase": "start", "hand": "right", "target": elsewhere, "confidence": NOISE}
    yield "a finger of noise", [[{"event": point, "at": 0.1}, {"say": f"lift {name}", "at": 0.2}]], lift


def members():
    everything = list(things.everything())
    pairs = [(a, b) for a, b in itertools.pairwise(everything) if a[0] == b[0]]
    for k, ((scene, thing, name), (_, other, other_name)) in enumerate(pairs):
        for i, (way, turns, acts) in enumerate(ways(scene, thing, name, other, other_name)):
            if (i + k) % 4 == 0:
                yield {"id": f"unsure_inputs {scene} {thing} {way}", "scene": scene, "say": turns, "expect": {"acts": acts}}
