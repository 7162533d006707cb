"""A pointing without words keeps both halves: the thing, and the place where it stands. A type selects one of them."""
import things

DELAYS = [2.5, 4, 7, 11]


def item(number, scene, what, say, *acts):
    return {"id": f"bare_pointing {scene} {number} {what}", "scene": scene, "say": say, "expect": {"acts": list(acts)}}


def at(scene, thing, hand="right"):
    return {"point": things.where(scene, thing), "hand": hand}


def things_shown():
    """The thing, by "that one", "that", "it" and its kind, at once or later, with either hand."""
    ways = ["lift that one", "lift that", "lift it", "lift this one"]
    for k, (scene, thing, _) in enumerate(things.everything()):
        shown = at(scene, thing, ["right", "left"][k % 2])
        yield item(k, scene, f"that {thing}", [[shown], "lift that one"], f"lift {thing}")
        yield item(k, scene, f"later {thing}", [[shown, {"say": ways[k % 4], "at": DELAYS[k % 4]}]], f"lift {thing}")


# Of each scene a thing that is carried, one that carries it, and how the first is called.
CARRIED = {"place_setting": ("knife", "plate", "the knife"), "workbench": ("block_red", "plate", "the red block"),
           "staircase": ("block6", "block1", "the red block"), "emre_table": ("knife", "plate", "the knife")}


def places_shown():
    for k, (scene, (thing, below, name)) in enumerate(CARRIED.items()):
        on, free, there = f"put {thing} on {below}", f"put {thing} at", {"point": things.FREE[scene]}
        seconds = DELAYS[k % 4]
        yield item(k, scene, "place of a thing", [name, [at(scene, below)], "put it there"], on)
        yield item(k, scene, "place of a thing, later", [name, [at(scene, below), {"say": "put it there", "at": seconds}]], on)
        yield item(k, scene, "place, then thing named", [[at(scene, below)], name, "put it there"], on)
        yield item(k, scene, "place in a command", [[at(scene, below)], f"put {name} there"], on)
        yield item(k, scene, "place here", [[at(scene, below, "left")], f"put {name} here"], on)
        yield item(k, scene, "on that one", [[at(scene, below)], f"put {name} on that one"], on)
        yield item(k, scene, "place without a word", [[at(scene, below)], f"put {name}"], on)
        yield item(k, scene, "free place", [name, [there], "put it there"], free)
        yield item(k, scene, "free place first", [[there], [at(scene, thing)], "put it there"], free)
        yield item(k, scene, "free place, that one", [[there], [at(scene, thing)], "put that one there"], free)
        yield item(k, scene, "two things", [[at(scene, thing)], [at(scene, below)], "put it there"], on)
        yield item(k, scene, "two things, that there", [[at(scene, thing)], [at(scene, below, "left")], "put that there"], on)
        yield item(k, scene, "thing and free place", [[at(scene, thing)], [there], "put that one here"], free)
        yield {"id": f"bare_pointing {scene} {k} one for two", "scene": scene, "say": [[at(scene, thing)], "put that there"],
               "expect": {"no_act": True, "asks": True}}
        yield item(k, scene, "two for two", [[at(scene, thing)], "put that there", [there]], free)


def members():
    yield from things_shown()
    yield from places_shown()
    # The words for a kind of thing mean the one that was shown.
    for k, (scene, name, thing) in enumerate([("place_setting", "cup", "cup"), ("place_setting", "cup", "cup_blue"),
                                              ("workbench", "block", "block_green"), ("staircase", "block", "block4"),
                                              ("workbench", "block", "block_yellow"), ("staircase", "block", "block7")]):
        yield item(k, scene, f"that kind {thing}", [[at(scene, thing)], f"take that {name}"], f"take {thing}")
        yield item(k, scene, f"the kind {thing}", [[at(scene, thing)], f"take the {name}"], f"take {thing}")
