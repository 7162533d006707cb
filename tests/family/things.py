"""The shipped scenes for families: how their things may be called, and where these stand."""
import run_exam

# Words that stand for exactly one thing of the scene.
UNIQUE = {
    "place_setting": {"plate": "the plate", "cup": "the white cup", "cup_blue": "the blue cup", "knife": "the knife"},
    "workbench": {"block_red": "the red block", "block_green": "the green block", "block_yellow": "the yellow block",
                  "cup": "the cup", "plate": "the plate", "knife": "the knife"},
    "staircase": {"block1": "the yellow block", "block3": "the black block", "block4": "the green block",
                  "block5": "the orange block", "block6": "the red block", "block7": "the purple block"},
    "emre_table": {"plate": "the plate", "knife": "the knife", "cup": "the cup"},
}
# Words that stand for several, with the things that these are.
SHARED = {
    "place_setting": {"the cup": ["cup", "cup_blue"]},
    "workbench": {"the block": ["block_red", "block_green", "block_yellow"]},
    "staircase": {"the block": ["block1", "block3", "block4", "block5", "block6", "block7"]},
    "emre_table": {"the red block": ["red_block1", "block6"], "the purple block": ["purple_block3", "block7"],
                   "the green block": ["block4", "green_block5"]},
}
# Spots on the table with nothing near them. x grows to the human's right, y away from the human; metres.
FREE = {"place_setting": [-0.1, -0.17], "workbench": [0.0, -0.2], "staircase": [0.12, -0.06], "emre_table": [0.4, -0.1]}


def where(scene, thing):
    """The x and y of the thing at the beginning, in metres, as a pointing's target."""
    return list(run_exam.positions_in(scene)[thing])


def everything():
    """Each scene with each thing that has a name of its own there, and the name."""
    for scene, names in UNIQUE.items():
        for thing, name in names.items():
            yield scene, thing, name
