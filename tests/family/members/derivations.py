"""Every way to an act: each must be led back to applications, which ../../derivation/rederive_families.py does."""
import things

# For each scene two things, and a place where either can be put: in words, and as an act tells it.
PLACES = {
    "place_setting": ("knife", "cup", "on the plate", "on plate"),
    "workbench": ("knife", "block_red", "on the plate", "on plate"),
    "staircase": ("block7", "block6", "on the orange block", "on block5"),
    "emre_table": ("knife", "cup", "on the plate", "on plate"),
}
CLEARED = {"place_setting": "plate", "workbench": "plate", "staircase": "block5", "emre_table": "plate"}
ALONE = {"place_setting": "cup", "workbench": "block_green", "staircase": "block1", "emre_table": "cup"}


def member(way, scene, turns, acts):
    return {"id": f"derivations {way} {scene}", "scene": scene, "say": turns, "expect": {"acts": acts}}


def taught(scene, a, b, place, aim):
    first, second = things.UNIQUE[scene][a], things.UNIQUE[scene][b]
    yield "word", ["Watch.", f"Take {first}.", "Lift it.", "Call that hoist.", "Let go of it.", f"Hoist {second}."], [
        f"take {a}", f"lift {a}", f"let_go {a}", f"take {b}", f"lift {b}"]
    yield "word with a place", ["Watch.", f"Put {first} {place}.", "Call that serve.", "Undo that.", f"Serve {second}."], [
        f"put {a} {aim}", f"put {a}", f"put {b} {aim}"]
    sign = {"gesture": "two_fingers"}
    yield "gesture", [[sign], f"Grasp {first}.", [sign]], [f"take {a}"]
    yield "gesture with a command", [[sign], f"Put {first} {place}.", [sign]], [f"put {a} {aim}"]
    yield "gesture for several acts", [[sign], f"Clear {things.UNIQUE[scene][CLEARED[scene]]}.", f"Put {first} {place}.", [sign]], [
        f"put {a} {aim}", f"put {a} at"]
    yield "gesture for a thing", [[sign], f"Take {first}.", f"Put it {place}.", [sign]], [f"put {a} {aim}"]


def told_by_parts(scene, a, b, place, aim):
    first, alone = things.UNIQUE[scene][a], ALONE[scene]
    yield "do that", [f"{first.capitalize()}.", f"{place.capitalize()}.", "Do it."], [f"put {a} {aim}"]
    yield "put it there", [f"{first.capitalize()}.", f"{place.capitalize()}.", "Put it there."], [f"put {a} {aim}"]
    yield "place later", [f"Put {first}.", f"{place.capitalize()}."], [f"put {a} {aim}"]
    yield "thing later", [f"Put it {place}.", f"{first.capitalize()}."], [f"put {a} {aim}"]
    yield "thing pointed at", [f"Put it {place}.", [{"point": things.where(scene, a)}]], [f"put {a} {aim}"]
    yield "direction later", [f"Push {things.UNIQUE[scene][alone]}.", "To the left."], [f"push {alone} left"]
    yield "direction shown", [f"Push {things.UNIQUE[scene][alone]}.", [{"gesture": "push", "direction": "left"}]], [
        f"push {alone} left"]


def from_others(scene, a, b, place, aim):
    first, second = things.UNIQUE[scene][a], things.UNIQUE[scene][b]
    put, back, other = f"put {a} {aim}", f"put {a}", f"put {b} {aim}"
    yield "another thing", [f"Put {first} {place}.", f"No, {second}."], [put, back, other]
    yield "undone", [f"Put {first} {place}.", "Undo that."], [put, back]
    yield "done again", [f"Put {first} {place}.", "Undo that.", "Redo that."], [put, back, put]
    yield "likewise", [f"Point at {first}.", f"And {second}."], [f"point {a}", f"point {b}"]
    yield "condition", [f"If there is a {second.split()[-1]}, put {first} {place}."], [put]
    yield "otherwise", [f"If there is a bottle, take {second}, otherwise put {first} {place}."], [put]
    yield "two acts", [f"Take {first} and put it {place}."], [f"take {a}", put]
    yield "two things", [f"Point at {first} and {second}."], [f"point {a}", f"point {b}"]


def members():
    for scene, words in PLACES.items():
        for ways in (taught, told_by_parts, from_others):
            for way, turns, acts in ways(scene, *words):
                yield member(way, scene, turns, acts)
