"""The paper's Table 1: six ways to define the object, eight to define the action, in both orders."""
import things

SCENES = {
    # the object's unique name, its gesture, a name it shares and what tells it then; a place, a shared one and what tells it
    "place_setting": {"thing": "knife", "name": "the knife", "icon": "knife", "shared": ("the cup", "the blue one", "cup_blue"), "icon_shared": ("cup", "the blue one", "cup_blue"),
                      "place": ("on the plate", "on plate"), "shared_place": ("in front of the cup", "the white one", "in_front cup")},
    "workbench": {"thing": "knife", "name": "the knife", "icon": "knife", "shared": ("the block", "the red one", "block_red"), "icon_shared": ("block", "the red one", "block_red"),
                  "place": ("behind the cup", "behind cup"), "shared_place": ("in front of the block", "the green one", "in_front block_green")},
}


def objects(scene, data):
    at = things.where(scene, data["thing"])
    shared, which, other = data["shared"]
    icon, icon_which, icon_other = data["icon_shared"]
    yield "N", [data["name"]], data["thing"]
    yield "N D", [shared, which], other
    yield "δ", [[{"point": at}]], data["thing"]
    yield "δ D", [[{"point": at}], data["name"]], data["thing"]
    yield "ω", [[{"gesture": data["icon"]}]], data["thing"]
    yield "ω D", [[{"gesture": icon}], icon_which], icon_other


def actions(scene, data):
    (place, place_act), (shared, which, shared_act) = data["place"], data["shared_place"]
    spot = things.FREE[scene]
    yield "V", ["put it in front of you"], "put {} in_front avatar"
    yield "V δ", [[{"say": "put it there", "at": 0}, {"point": spot, "at": 0.5}]], "put {} at"
    yield "V P", ["put it", place], "put {} " + place_act
    yield "V N", ["put it " + shared, which], "put {} " + shared_act
    yield "α", [[{"gesture": "lift"}]], "lift {}"
    yield "α δ", [[{"gesture": "put"}], [{"point": spot}]], "put {} at"
    yield "P", [place], "put {} " + place_act
    yield "P N", [shared, which], "put {} " + shared_act


def members():
    """All 96, in turn in one scene and the other."""
    for scene, data in SCENES.items():
        for i, (object_name, object_turns, thing) in enumerate(objects(scene, data)):
            for k, (action_name, action_turns, act) in enumerate(actions(scene, data)):
                # After "put it in front of the cup" the thing is asked for first.
                middle = 1 if action_name == "V N" else len(action_turns)
                orders = {"object first": object_turns + action_turns,
                          "action first": action_turns[:middle] + object_turns + action_turns[middle:]}
                order = list(orders)[(i + k + list(SCENES).index(scene)) % 2]
                yield {"id": f"table_one {scene} {object_name}, {action_name}, {order}", "scene": scene, "say": orders[order],
                       "expect": {"acts": [act.format(thing)]}}
