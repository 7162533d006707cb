"""A taught grasp keeps its pose: the part of the thing and the side from which the hand comes. The gesture alone does it
again, "like that" does the same with another thing, and a hold that the thing does not afford is refused in words."""
import things

SIGNS = ["claw_hand", "pinch", "cradle"]
# Things that the hand can take from above and from the side, at the beginning.
TAKEN = {"place_setting": ["cup", "cup_blue"], "workbench": ["cup"], "emre_table": ["cup"]}
WITH_KNIFE = ["place_setting", "workbench", "emre_table"]
SIDES = {"from above": "above", "from the side": "side"}


def shown(sign):
    return [{"gesture": sign}]


def item(what, scene, say, expect):
    return {"id": f"shown_grasps {what} {scene}", "scene": scene, "say": say, "expect": expect}


def members():
    for i, (scene, taken) in enumerate(TAKEN.items()):
        sign = SIGNS[i]
        for thing in taken:
            name = things.UNIQUE[scene][thing]
            for words, side in SIDES.items():
                yield item(f"told {side} {thing}", scene, [f"grasp {name} {words}"], {"acts": [f"grip {thing} {side}"]})
                yield item(f"taught {side} {thing}", scene, [shown(sign), f"take {name} {words}", shown(sign)],
                           {"acts": [f"grip {thing} {side}"]})
            yield item(f"like that {thing}", scene, [shown(sign), "grasp the knife from above", f"grasp {name} like that"],
                       {"acts": [f"grip {thing} above"]})
            yield item(f"fills put {thing}", scene, [shown(sign), f"grasp {name} from above", "put it behind the plate", shown(sign)],
                       {"acts": [f"put {thing} behind plate"]})
            yield item(f"no handle {thing}", scene, [f"grasp {name} by the handle"], {"no_act": True, "says": ["cannot take", "no hold"]})
            yield item(f"no rim, taught {thing}", scene, [shown(sign), f"grasp {name} by the rim", shown(sign)],
                       {"no_act": True, "says": ["cannot take", "no hold"]})
    for i, scene in enumerate(WITH_KNIFE):
        sign = SIGNS[i]
        yield item("handle", scene, ["take the knife by the handle"], {"acts": ["grip knife handle"]})
        yield item("handle, taught", scene, [shown(sign), "take the knife by the handle", shown(sign)], {"acts": ["grip knife handle"]})
        yield item("blade", scene, ["take the knife by the blade"], {"no_act": True, "says": ["cannot take", "no hold"]})
        yield item("taken anew", scene, ["take the knife", "grasp it by the handle"], {"acts": ["take knife", "grip knife handle"]})
        yield item("how not shown yet", scene, ["grasp the knife like that"], {"no_act": True})
        yield item("how shown after it", scene,
                   [shown(sign), "lift the plate", "grasp the knife like that", "never mind", "grasp the knife by its handle"],
                   {"acts": ["grip knife handle"]})
    yield item("block from above", "staircase", [shown("pinch"), "grasp the red block from above", shown("pinch")], {"acts": ["grip block6 above"]})
    yield item("block like that", "staircase", ["grasp the red block from above", "let go of it", "grasp the yellow block like that"],
               {"acts": ["grip block6 above", "let_go block6", "grip block1 above"]})
