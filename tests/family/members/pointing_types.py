"""A pointing is things and a place until a type selects one half, and its spread grows with the distance of the hand."""
import things

# The hand is so far from the place, in metres: near by, and across a room.
NEAR, FAR = 0.5, 2.6
# Neighbours that only a hand near by can tell apart.
NEIGHBOURS = [("place_setting", "knife", "cup"), ("place_setting", "cup", "knife"), ("place_setting", "cup_blue", "cup"),
              ("staircase", "block4", "block6"), ("staircase", "block6", "block4"), ("staircase", "block3", "block7"),
              ("staircase", "block5", "block4"), ("workbench", "block_red", "block_green"),
              ("workbench", "block_green", "block_yellow"), ("workbench", "block_yellow", "block_green")]
CARRIED = {"place_setting": ("knife", "plate", "the knife"), "workbench": ("block_red", "plate", "the red block"),
           "staircase": ("block6", "block1", "the red block"), "emre_table": ("knife", "plate", "the knife")}


def rays(place, metres, hand="right"):
    """Ten samples of a hand that points from above, a little from the human's side."""
    x, y = place
    up, back = 0.97 * metres, 0.243 * metres
    ray = {"from": [x, round(y - back, 4), round(up, 4)], "direction": [0, round(back, 4), round(-up, 4)]}
    return [{"event": {"kind": "pointing", "hand": hand, "ray": ray}, "at": round(0.1 * k, 1)} for k in range(12)]


def shown(scene, thing, metres, text, hand="right"):
    return [*rays(things.where(scene, thing), metres, hand), {"say": text, "at": 0.6}]


def item(scene, what, say, *acts):
    return {"id": f"pointing_types {scene} {what}", "scene": scene, "say": say, "expect": {"acts": list(acts)}}


def members():
    for k, (scene, thing, _) in enumerate(things.everything()):
        hand = ["right", "left"][k % 2]
        yield item(scene, f"{thing} of rays", [shown(scene, thing, NEAR, "lift that one", hand)], f"lift {thing}")
        yield item(scene, f"{thing} of a gesture", [[{"point": things.where(scene, thing), "hand": hand}], "take that one"],
                   f"take {thing}")
    for scene, thing, other in NEIGHBOURS:
        yield item(scene, f"{thing} beside {other}, near", [shown(scene, thing, NEAR, "take that")], f"take {thing}")
        yield {"id": f"pointing_types {scene} {thing} beside {other}, far", "scene": scene,
               "say": [shown(scene, thing, FAR, "take that")], "expect": {"no_act": True, "asks": True}}
        yield item(scene, f"{thing} beside {other}, far, yes", [shown(scene, thing, FAR, "take that"), "yes"],
                   f"take {thing}")
    for scene, (thing, below, name) in CARRIED.items():
        free = {"point": things.FREE[scene]}
        yield item(scene, "place of rays", [shown(scene, below, NEAR, f"put {name} there")], f"put {thing} on {below}")
        yield item(scene, "place asked for", [f"put {name}", [free]], f"put {thing} at")
        yield item(scene, "thing asked for", [["put it there", free], [{"point": things.where(scene, thing)}]],
                   f"put {thing} at")
        yield item(scene, "both halves of two", [[{"point": things.where(scene, thing)}], [free], "put that one there"],
                   f"put {thing} at")
