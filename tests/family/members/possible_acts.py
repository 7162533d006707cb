"""What can be done is the same in both worlds: the reach of the arm, the room and the fit. An impossible act is refused and says why."""
import things

# Beyond the reach of the arm, and off the table, for all scenes.
FAR, OFF = [-0.56, -0.36], [0.0, -0.5]
WHY = ["out of my reach", "fall off the table", "my arm end before that"]


def item(number, what, scene, say, expect):
    return {"id": f"possible_acts {scene} {number} {what}", "scene": scene, "say": say, "expect": expect}


def refused(*says):
    return {"no_act": True, "says": list(says)}


def members():
    for scene, names in things.UNIQUE.items():
        free = {"point": things.FREE[scene]}
        for k, (thing, name) in enumerate(list(names.items())[:4]):
            yield item(k, f"take {thing}", scene, [f"take {name}"], {"acts": [f"take {thing}"]})
            yield item(k, f"far {thing}", scene, [[f"put {name} there", {"point": FAR, "at": 0.5}]], refused(*WHY))
            yield item(k, f"off {thing}", scene, [[f"put {name} there", {"point": OFF, "at": 0.5}]], refused(*WHY))
            yield item(k, f"free {thing}", scene, [[f"put {name} there", {**free, "at": 0.5}]], {"acts": [f"put {thing} at"]})
    for k, (scene, thing, name, into) in enumerate([
            ("workbench", "block_red", "the red block", "the cup"), ("workbench", "plate", "the plate", "the cup"),
            ("place_setting", "plate", "the plate", "the blue cup"), ("emre_table", "plate", "the plate", "the cup")]):
        yield item(k, f"too big {thing}", scene, [f"put {name} in {into}"], {"no_act": True})
