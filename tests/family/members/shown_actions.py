"""A taught sign supplies what a pending command lacks, in every state: asked for, to be chosen, to be corrected. It may
have been taught as an action or as a thing, and its own object may have to be chosen first."""
import things

SIGNS = ["two_fingers", "hug", "twist", "tap"]
# A thing, another one to put on or beside it, and a pair of which one must be chosen, with the word for both.
CAST = {
    "place_setting": {"thing": "knife", "base": "plate", "pair": ["cup", "cup_blue"], "both": "the cup"},
    "workbench": {"thing": "knife", "base": "plate", "pair": ["block_red", "block_green"], "both": "the block"},
    "staircase": {"thing": "block6", "base": "block1", "pair": ["block3", "block4"], "both": "the block"},
    "emre_table": {"thing": "knife", "base": "plate", "pair": ["red_block1", "block6"], "both": "the red block"},
}
VERBS = ["grasp", "lift", "take"]
# Words for one of a pair that has no name of its own.
BY_PLACE = {"red_block1": "the left red block", "block6": "the right red block"}


def shown(sign):
    return [{"gesture": sign}]


def item(scene, what, say, act):
    return {"id": f"shown_actions {what} {scene}", "scene": scene, "say": say, "expect": {"acts": act}}


def name_of(scene, thing):
    return things.UNIQUE[scene].get(thing) or BY_PLACE[thing]


def members():
    for i, (scene, cast) in enumerate(CAST.items()):
        sign, verb = SIGNS[i], VERBS[i % 3]
        thing, base, (one, other) = cast["thing"], cast["base"], cast["pair"]
        lesson_of = {"event": lambda x: f"{verb} {name_of(scene, x)}", "thing": lambda x: name_of(scene, x)}
        for how, lesson in lesson_of.items():
            def taught(x):
                return [shown(sign), lesson(x)]
            yield item(scene, f"ask {how}", [*taught(thing), f"put on {name_of(scene, base)}", shown(sign)],
                       [f"put {thing} on {base}"])
            yield item(scene, f"ask verb first {how}",
                       [*taught(thing), f"put it behind {name_of(scene, base)}", shown(sign)], [f"put {thing} behind {base}"])
            yield item(scene, f"choose {how}",
                       [*taught(other), f"put {cast['both']} left of {name_of(scene, base)}", shown(sign)],
                       [f"put {other} left {base}"])
            yield item(scene, f"correct {how}",
                       [*taught(other), f"put {name_of(scene, one)} in front of you", "no", shown(sign)],
                       [f"put {one} front", f"put {one} was", f"put {other} front"])
            yield item(scene, f"correct in one turn {how}",
                       [*taught(other), f"put {name_of(scene, one)} in front of you", [{"say": "no", "at": 0}, {"gesture": sign, "at": 2}]],
                       [f"put {one} front", f"put {one} was", f"put {other} front"])
        both = cast["both"]
        yield item(scene, "ask, then choose", [shown(sign), f"{verb} {both}", f"put it behind {name_of(scene, base)}", shown(sign),
                                               name_of(scene, other)], [f"put {other} behind {base}"])
        yield item(scene, "ask, then yes", [shown(sign), f"{verb} {both}", f"put it behind {name_of(scene, base)}", shown(sign), "yes"],
                   [[f"put {x} behind {base}" for x in things.SHARED[scene][both]]])
        yield item(scene, "place of it", [shown(sign), f"{verb} {name_of(scene, base)}", f"put {name_of(scene, thing)}", shown(sign)],
                   [f"put {thing} on {base}"])
