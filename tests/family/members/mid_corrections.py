"""A part of a half-given command is replaced by word or gesture: theme, place, relation, verb, perspective, one of several."""
import things

# scene, a half command, a correction, the answer to what still lacks, the act
BY_WORD = [
    ("place_setting", "put it in front of you", "in front of me", "the plate", "put plate in_front human"),
    ("place_setting", "put it on the plate", "in the blue cup", "the knife", "put knife in cup_blue"),
    ("place_setting", "put it on the plate", "behind it", "the knife", "put knife behind plate"),
    ("place_setting", "put it to the left of the plate", "to the right", "the knife", "put knife right plate"),
    ("place_setting", "put the knife", "the plate", "in front of you", "put plate in_front avatar"),
    ("place_setting", "put the cup", "the knife", "on the plate", "put knife on plate"),
    ("place_setting", "take the cup", "the knife", None, "take knife"),
    ("place_setting", "take the cup", "lift it", "the blue one", "lift cup_blue"),
    ("place_setting", "put the knife in the cup", "on the plate", None, "put knife on plate"),
    ("place_setting", "put the knife in the cup", "the blue one", None, "put knife in cup_blue"),
    ("place_setting", "put the knife", "push it", "to the left", "push knife left"),
    ("place_setting", "push the knife", "put it", "on the plate", "put knife on plate"),
    ("workbench", "put it behind you", "behind the plate", "the red block", "put block_red behind plate"),
    ("workbench", "put it in front of me", "in front of you", "the green block", "put block_green in_front avatar"),
    ("workbench", "put the red block", "the green one", "on the plate", "put block_green on plate"),
    ("workbench", "put the knife", "the yellow block", "behind the cup", "put block_yellow behind cup"),
    ("workbench", "take the block", "lift it", "the red one", "lift block_red"),
    ("workbench", "take the block", "the knife", None, "take knife"),
    ("workbench", "take the block", "the yellow one", None, "take block_yellow"),
    ("workbench", "put the knife in front of the block", "on the plate", None, "put knife on plate"),
    ("workbench", "put the knife behind the block", "in front of it", "the red one", "put knife in_front block_red"),
    ("workbench", "put the block on the plate", "in front of me", "the red one", "put block_red in_front human"),
    ("staircase", "put it on the red block", "on the green block", "the purple block", "put block7 on block4"),
    ("staircase", "put the purple block", "the orange block", "in front of me", "put block5 in_front human"),
    ("staircase", "take the block", "lift it", "the orange one", "lift block5"),
    ("emre_table", "put it behind the cup", "in front of it", "the knife", "put knife in_front cup"),
    ("emre_table", "put the cup", "the knife", "on the plate", "put knife on plate"),
    ("emre_table", "put it in front of you", "to the left of the plate", "the cup", "put cup left plate"),
    ("staircase", "put the block on the black block", "on the purple block", "the yellow one", "put block1 on block7"),
    ("staircase", "put the block behind the yellow block", "in front of it", "the purple one", "put block7 in_front block1"),
    ("staircase", "push the block to the left", "to the right", "the black one", "push block3 right"),
    ("workbench", "put the block to the left of the cup", "behind it", "the yellow one", "put block_yellow behind cup"),
    ("workbench", "put the block on the plate", "on the red block", "the green one", "put block_green on block_red"),
    ("workbench", "push the block to the right", "to the left", "the green one", "push block_green left"),
    ("place_setting", "put the cup to the right of the plate", "on it", "the blue one", "put cup_blue on plate"),
    ("emre_table", "push the red block to the right", "to the left", "the left one", "push"),
]
# scene, a half command, the thing or spot pointed at with the correction, the answer, the act
BY_POINTING = [
    ("place_setting", "put the plate", "knife", "in front of you", "put knife in_front avatar"),
    ("place_setting", "take the cup", "knife", None, "take knife"),
    ("place_setting", "put it on the plate", None, "the knife", "put knife at"),
    ("workbench", "put the red block", "block_green", "in front of you", "put block_green in_front avatar"),
    ("workbench", "put it in front of me", None, "the knife", "put knife at"),
    ("workbench", "lift the block", "knife", None, "lift knife"),
    ("staircase", "put the purple block", "block5", "in front of me", "put block5 in_front human"),
    ("emre_table", "put the plate", "knife", "in front of me", "put knife in_front human"),
    ("emre_table", "put it behind the plate", None, "the cup", "put cup at"),
]


def members():
    for number, (scene, half, correction, answer, act) in enumerate(BY_WORD):
        ways = (("no", ["no, " + correction]), ("mean", ["i mean " + correction]), ("no first", [["no", {"say": correction, "at": 1.2}]]),
                ("shaken", [[{"gesture": "negack"}, {"say": correction, "at": 1.0}]]))
        # Two ways each, in turn.
        for way, turns in (ways[number % 4], ways[(number + 1 + number // 4 % 3) % 4]):
            if way == "mean" and correction.split()[0] in ("lift", "push", "put"):
                continue
            yield {"id": f"mid_corrections {scene} {number} {way}", "scene": scene, "say": [half, *turns, *([answer] if answer else [])],
                   "expect": {"acts": [act]}}
    for number, (scene, half, thing, answer, act) in enumerate(BY_POINTING):
        at = things.where(scene, thing) if thing else things.FREE[scene]
        word = "that one" if thing else "there"
        for way, turns in (("word and finger", [[{"say": "no, " + word, "at": 0}, {"point": at, "at": 0.3}]]), ("finger", [["no", {"point": at, "at": 0.8}]])):
            yield {"id": f"mid_corrections {scene} pointing {number} {way}", "scene": scene, "say": [half, *turns, *([answer] if answer else [])],
                   "expect": {"acts": [act]}}
