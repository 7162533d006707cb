"""A question, a second command, a lesson while something is pending: when it is over, the pending question is open again."""

# Each scene with what is pending, the question about it answered at last, the act that this comes to, and things to
# talk about in between: a question, a whole command with its act, a half command with what completes it and the act.
PENDING = {
    "place_setting": [(["take the cup"], "the blue one", "take cup_blue"), (["put the knife"], "on the plate", "put knife on plate"),
                      (["put it on the plate"], "the white cup", "put cup on plate")],
    "workbench": [(["lift the block"], "the green one", "lift block_green"), (["put the red block"], "behind the cup", "put block_red behind cup"),
                  (["put it in front of you"], "the yellow block", "put block_yellow in_front avatar")],
    "staircase": [(["take the block"], "the orange one", "take block5"), (["put the purple block"], "in front of me", "put block7 in_front human")],
    "emre_table": [(["lift the red block"], "the left one", "lift"), (["put the cup"], "behind the plate", "put cup behind plate")],
}
QUESTIONS = {"place_setting": "where is the plate", "workbench": "how many blocks are there", "staircase": "what color is the left block",
             "emre_table": "where is the knife"}
WHOLE = {"place_setting": ("push the plate to the left", "push plate left"), "workbench": ("put the knife on the plate", "put knife on plate"),
         "staircase": ("put the green block in front of me", "put block4 in_front human"),
         "emre_table": ("put the knife in front of me", "put knife in_front human")}
HALF = {"place_setting": ("push the plate", "to the left", "push plate left"), "workbench": ("push the knife", "to the left", "push knife left"),
        "staircase": ("put the black block", "in front of me", "put block3 in_front human"),
        "emre_table": ("put the knife", "in front of me", "put knife in_front human")}
SIGN = [{"gesture": "twirl"}]
THING = {"place_setting": "the plate", "workbench": "the knife", "staircase": "the yellow block", "emre_table": "the knife"}

# A thing to lift, where it lies, and where another thing lies that the finger shows.
LIFTED = {"place_setting": ("the plate", "plate", [-0.2, 0.01], [0.12, -0.09]), "workbench": ("the knife", "knife", [-0.2, -0.12], [0.2, -0.1]),
          "staircase": ("the yellow block", "block1", [0, 0.0064], [0.3132, 0.0796]), "emre_table": ("the knife", "knife", [0.06, 0.06], [-0.02, -0.22])}


def shown_between(scene):
    """Commands in between with a finger on another thing, on the thing itself, or a hand that shows the action too."""
    thing, name, place, elsewhere = LIFTED[scene]
    lift, act = f"lift {thing}", f"lift {name}"
    yield "contradicted", [[{"point": elsewhere}, lift], thing], [act]
    yield "contradicted afterwards", [[lift, {"point": elsewhere}], thing], [act]
    yield "contradicted and left", [[{"point": elsewhere}, lift], "never mind"], []
    yield "shown as well", [[lift, {"point": place}]], [act]
    yield "shown by a hand as well", [[lift, {"gesture": "lift"}]], [act]
    yield "report of two commands", [f"he told me to turn {thing} and {lift}"], []
    yield "condition of two commands", [f"if {thing} isn't on the table, take it and {lift}"], []


def between(scene):
    """What comes in between, with the acts of it."""
    question, (whole, whole_act), (half, rest, half_act) = QUESTIONS[scene], WHOLE[scene], HALF[scene]
    yield "question", [question], []
    yield "two questions", [question, question], []
    yield "command", [whole], [whole_act]
    yield "half command", [half, rest], [half_act]
    yield "half command left", [half, "never mind"], []
    yield "question in half command", [half, question, rest], [half_act]
    yield "lesson", [SIGN, "it means lift the plate"], []
    yield "lesson left", [SIGN, "never mind"], []
    yield "question in lesson", [SIGN, question, "it means lift the plate"], []
    thing = THING[scene]
    yield "name", [f"{thing} is called Zorby"], []
    yield "name in half command", [half, f"call {thing} Zorby", rest], [half_act]
    yield "verb", ["to zorp something means put it in front of you"], []
    yield "quote", [f'"{whole}" is what she said'], []
    yield "quote of two commands", [f"{whole} and take {thing} is what he said"], []
    yield "quote in half command", [half, f'"{whole}" is what she said', rest], [half_act]
    yield "only asked about", [f"could you {whole}? just asking"], []
    yield "rule", [f"never turn {thing}"], []
    yield "rule in half command", [half, f"never turn {thing}", rest], [half_act]
    yield "rule and permission", [f"never turn {thing}", f"you may turn {thing} again"], []


def members():
    for scene, pendings in PENDING.items():
        for number, (opening, answer, act) in enumerate(pendings):
            # To lift one of the blocks is an answer where a block is to be taken.
            shown = [] if (scene, number) == ("staircase", 0) else shown_between(scene)
            for k, (name, turns, acts) in enumerate([*between(scene), *shown]):
                item = {"id": f"sub_dialogues {scene} {number} {name}", "scene": scene}
                if (number + k) % 2 == 0:
                    yield {**item, "say": [*opening, *turns, answer], "expect": {"acts": [*acts, act]}}
                else:
                    yield {**item, "id": item["id"] + " asked again", "say": [*opening, *turns], "expect": {"acts": acts, "asks": True}}
            half = HALF[scene][0]
            yield {"id": f"sub_dialogues {scene} {number} left twice", "scene": scene,
                   "say": [*opening, half, "never mind", "never mind", answer], "expect": {"no_act": True}}
