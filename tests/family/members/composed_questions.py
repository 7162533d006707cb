"""While a command is pending, each question applies the next option to it and asks the composition; yes does it."""
import things

# Scene, command, its options in the order of the questions (each in words, and as the act tells it), and the
# composition in words and as an act. An option is a thing, or the place itself.
CUPS = [("the white cup", "cup"), ("the blue cup", "cup_blue")]
BLOCKS = [("the red block", "block_red"), ("the green block", "block_green"), ("the yellow block", "block_yellow")]
REDS = [("the red block on the left", "red_block1"), ("the red block on the right", "block6")]
PURPLES = [("the purple block on the right", "purple_block3"), ("the purple block on the left", "block7")]
STAIRS = [(name, thing) for thing, name in things.UNIQUE["staircase"].items()]
SPOKEN = [
    ("place_setting", "Put the knife in the cup.", CUPS, "put the knife in {}", "put knife in {}"),
    ("place_setting", "Lift the cup.", CUPS, "lift {}", "lift {}"),
    ("place_setting", "Put the cup on the plate.", CUPS, "put {} on the white plate", "put {} on plate"),
    ("workbench", "Put the knife on the block.", BLOCKS, "put the knife on {}", "put knife on {}"),
    ("workbench", "Put the block on the plate.", BLOCKS, "put {} on the white plate", "put {} on plate"),
    ("staircase", "Take the block.", STAIRS, "take {}", "take {}"),
    ("emre_table", "Take the red block.", REDS, "take {}", "take {}"),
    ("emre_table", "Put the knife on the purple block.", PURPLES, "put the knife on {}", "put knife on {}"),
]
# Pointings that may mean a thing or a place: scene, command, where the human points, the composition with the thing
# and that with the place. None where the act is not what is asked about here: a plate does not go into a cup.
POINTED = [
    ("place_setting", "Put the knife.", [0.29, -0.05], ("put the knife in the blue cup", "put knife in cup_blue"), None),
    ("place_setting", "Put the plate.", [0.1, 0.1], ("put the white plate in the white cup", None),
     ("put the white plate here", ["put plate at", "put plate right"])),
]


def question(name, scene, turns, words):
    return {"id": f"composed_questions {name}", "scene": scene, "say": turns,
            "expect": {"no_act": True, "asks": True, "says": [f"Should I {words}?"]}}


def answer(name, scene, turns, act):
    return {"id": f"composed_questions {name}", "scene": scene, "say": turns, "expect": {"acts": [act]}}


def spoken(scene, command, options, words, act):
    for noes, (name, thing) in enumerate(options):
        told = f"{scene} {command} {noes} noes"
        said = [command, *["No."] * noes]
        yield question(told, scene, said, words.format(name))
        yield answer(f"{told}, yes", scene, [*said, "Yes."], act.format(thing))
        yield answer(f"{told}, thumb", scene, [*said[:-1], *([] if noes == 0 else [[{"gesture": "negack"}]]),
                     *([command] if noes == 0 else []), [{"gesture": "posack"}]], act.format(thing))
    last_name, last = options[-1]
    yield answer(f"{scene} {command} named", scene, [command, f"{last_name.capitalize()}."], act.format(last))
    yield answer(f"{scene} {command} pointed at", scene, [command, [{"point": things.where(scene, last)}]], act.format(last))


def pointed(scene, command, spot, thing, place):
    said = [command, [{"point": spot}]]
    yield question(f"{scene} {command} thing", scene, said, thing[0])
    if thing[1]:
        yield answer(f"{scene} {command} thing, yes", scene, [*said, "Yes."], thing[1])
    if place:
        yield question(f"{scene} {command} place", scene, [*said, "No."], place[0])
        yield answer(f"{scene} {command} place, yes", scene, [*said, "No.", "Yes."], place[1])


def members():
    for each in SPOKEN:
        yield from spoken(*each)
    for each in POINTED:
        yield from pointed(*each)
    yield {"id": "composed_questions noun phrase alone", "scene": "place_setting", "say": ["The cup."],
           "expect": {"no_act": True, "asks": True, "says": ["The white cup?"]}}
