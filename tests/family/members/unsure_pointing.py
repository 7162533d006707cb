"""Distance enters a pointing through its spread: dead centre is not asked about, between two things is, far away is a place."""
import random

import things

NOISE_M = 0.008
# The place was understood, but lies beyond the arm or the table.
UNREACHED = ["out of my reach", "fall off the table", "my arm end before that"]


def between(a, b, share=0.5):
    return [round(x + share * (y - x), 4) for x, y in zip(a, b)]


# Neighbours so close that a hand between them may mean either.
NEIGHBOURS = [("place_setting", "knife", "cup"), ("staircase", "block4", "block6"), ("staircase", "block3", "block7"),
              ("staircase", "block4", "block5"), ("emre_table", "purple_block3", "cup")]
FAR = {"place_setting": [[-0.45, -0.25], [0.0, -0.27], [-0.1, 0.25]], "workbench": [[0.0, -0.2], [-0.5, 0.25]],
       "staircase": [[0.12, -0.06], [0.45, -0.25]], "emre_table": [[0.4, -0.1], [0.5, -0.3]]}


def members():
    rng = random.Random(4)
    for scene, thing, _ in things.everything():
        x, y = things.where(scene, thing)
        near = [round(x + rng.uniform(-NOISE_M, NOISE_M), 4), round(y + rng.uniform(-NOISE_M, NOISE_M), 4)]
        yield {"id": f"unsure_pointing {scene} {thing} sure", "scene": scene, "say": [[{"point": near}], "take it"],
               "expect": {"acts": [f"take {thing}"]}}
    for scene, one, other in NEIGHBOURS:
        middle = between(things.where(scene, one), things.where(scene, other))
        yield {"id": f"unsure_pointing {scene} {one} {other} asked", "scene": scene, "say": [[{"point": middle}]],
               "expect": {"no_act": True, "asks": True}}
        yield {"id": f"unsure_pointing {scene} {one} {other} words", "scene": scene,
               "say": [[{"point": middle}], "yes", "take it"],
               "expect": {"one_of": [{"acts": [f"take {one}"]}, {"acts": [f"take {other}"]}]}}
    for scene, places in FAR.items():
        thing, name = next(iter(things.UNIQUE[scene].items()))
        for k, place in enumerate(places):
            yield {"id": f"unsure_pointing {scene} {k} far", "scene": scene, "say": [[{"point": place}]],
                   "expect": {"no_act": True, "says": ["go on"]}}
            yield {"id": f"unsure_pointing {scene} {k} far place", "scene": scene,
                   "say": [[{"point": place}], f"put {name} there"],
                   "expect": {"one_of": [{"acts": [f"put {thing} at"]}, {"no_act": True, "says": UNREACHED}]}}
