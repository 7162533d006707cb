"""A question whose words stop at a thing that is pointed at, and go on after a pause, is answered as a whole."""
import things

# Scene, thing, its kind, and what may be asked of it with the answer.
ASKED = [
    ("workbench", "block_red", "block", [("green", "no"), ("yellow", "no"), ("on the plate", "no")]),
    ("workbench", "block_green", "block", [("red", "no"), ("behind the cup", "no")]),
    ("workbench", "block_yellow", "block", [("blue", "no"), ("in the cup", "no")]),
    ("staircase", "block6", "block", [("black", "no"), ("purple", "no")]),
    ("staircase", "block4", "block", [("red", "no"), ("orange", "no")]),
    ("place_setting", "cup_blue", "cup", [("white", "no"), ("on the plate", "no")]),
    ("emre_table", "cup", "cup", [("on the plate", "no")]),
]


def members():
    number = 0
    for scene, thing, kind, questions in ASKED:
        for rest, answer in questions:
            for begun in ("is this one", f"is this {kind}", "is that one", f"is that {kind}", "is this"):
                number += 1
                pause = 0.35 * len(begun.split()) + (0.3, 0.6, 0.9)[number % 3]
                at = (0.3, 0.6, -0.4)[number % 3]
                begin = 0.5
                turn = [{"say": begun, "at": begin}, {"point": things.where(scene, thing), "at": round(begin + at, 2)}, {"say": rest, "at": round(begin + pause, 2)}]
                turn.sort(key=lambda part: part["at"])
                yield {"id": f"paused_questions {scene} {thing} {begun} {rest}", "scene": scene, "say": [turn], "expect": {"no_act": True, "says": [answer + "."]}}
    # A question that is finished is answered, and a command is not held up.
    for scene, thing, kind, _ in ASKED:
        turn = [{"point": things.where(scene, thing), "at": 0}, {"say": f"is this a {kind}?", "at": 0.4}]
        yield {"id": f"paused_questions {scene} {thing} finished", "scene": scene, "say": [turn], "expect": {"no_act": True, "says": ["yes."]}}
        turn = [{"point": things.where(scene, thing), "at": 0}, {"say": f"lift this {kind}", "at": 0.4}, {"say": "thanks", "at": 2}]
        yield {"id": f"paused_questions {scene} {thing} command", "scene": scene, "say": [turn], "expect": {"acts": [f"lift {thing}"]}}
