"""Content of both modalities in one window is one move: equal content counts once, complementary composes, contradictory
is asked about. The order of arrival changes nothing."""
import things

# Words and a gesture at one moment, in each order: scene, words, gestures, seconds after the words' beginning, expectation.
SHIFTS = (-0.4, 0.0, 0.5)


def both(words, *shown):
    for shift in SHIFTS:
        begin = 1.0
        yield shift, [{"say": words, "at": begin}, *({**each, "at": round(begin + shift + 0.3 * k, 2)} for k, each in enumerate(shown))]


def equal():
    for scene, words, gesture, act in (
            ("place_setting", "take the knife", {"gesture": "grab"}, "take knife"),
            ("workbench", "lift the plate", {"gesture": "lift"}, "lift plate"),
            ("emre_table", "push the cup to the right", {"gesture": "push", "direction": "right"}, "push cup right"),
            ("staircase", "take the purple block", {"gesture": "grab"}, "take block7")):
        for shift, turn in both(words, gesture):
            yield f"equal {words} {shift}", scene, [turn], {"acts": [act]}
    for scene, opening, act in (("workbench", "take the block", "take"), ("place_setting", "take the cup", "take"), ("staircase", "lift the block", "lift")):
        for shift, turn in both("yes", {"gesture": "posack"}):
            yield f"equal {opening} yes {shift}", scene, [opening, turn], {"acts": [act]}
    for shift, turn in both("no", {"gesture": "negack"}):
        yield f"equal cup no {shift}", "place_setting", ["take the cup", turn, "yes"], {"acts": ["take"]}
        yield f"equal block no no {shift}", "workbench", ["take the block", turn, turn, "yes"], {"acts": ["take"]}
        yield f"equal no, the plate {shift}", "place_setting", ["take the knife", [{**turn[0], "say": "no, the plate"}, turn[1]]], {"one_of": [{"acts": ["take knife", "take plate"]}, {"acts": ["take knife", "put knife", "take plate"]}]}


def complementary():
    for scene, thing, icon in (("place_setting", "knife", "knife"), ("place_setting", "plate", "plate"), ("workbench", "cup", "cup"), ("emre_table", "plate", "plate")):
        for verb in ("take", "lift"):
            for shift, turn in both(f"{verb} this", {"gesture": icon}):
                yield f"{verb} this {icon} {scene} {shift}", scene, [turn], {"acts": [f"{verb} {thing}"]}
        for shift, (words, shape) in both("put that there", {"gesture": icon}):
            turn = [words, shape, {"point": things.FREE[scene], "at": 1.9}]
            yield f"put that there {icon} {scene} {shift}", scene, [turn], {"acts": [f"put {thing} at"]}
        for direction in ("left", "right"):
            if (scene, thing, direction) == ("place_setting", "plate", "right"):
                continue  # the knife is in its way, which only the physics world finds
            turn = [{"point": things.where(scene, thing), "at": 0}, {"say": "push it", "at": 0.6}, {"gesture": "push", "direction": direction, "at": 1.1}]
            yield f"push it {direction} {icon} {scene}", scene, [turn], {"acts": [f"push {thing} {direction}"]}
            for shift, turn in both("push it", {"gesture": "push", "direction": direction}):
                yield f"push it {direction} {icon} {scene} {shift} named", scene, [things.UNIQUE[scene][thing], turn], {"acts": [f"push {thing} {direction}"]}
    for words in ("lift the blocks", "lift all blocks"):
        for before in (0.4, 0.8):
            turn = [{"gesture": "count_two", "at": 0}, {"say": words, "at": before}]
            yield f"two, {words} {before}", "workbench", [turn], {"acts": ["lift", "lift"]}


def contradictory():
    for scene, said, shown in (("place_setting", "knife", "cup"), ("place_setting", "plate", "cup_blue"), ("workbench", "knife", "cup"),
                               ("workbench", "block_red", "block_green"), ("emre_table", "knife", "plate"), ("staircase", "block7", "block5")):
        for shift, turn in both("take " + things.UNIQUE[scene][said], {"point": things.where(scene, shown)}):
            # A finger that comes when the words have been answered finds the act begun.
            asked = {"asks": True} if shift > 0 else {"no_act": True, "asks": True}
            yield f"contradictory {said} {shown} {scene} {shift}", scene, [turn], asked
            right = {"acts": ["take " + shown]}
            settled = {"one_of": [right, {"acts": ["take " + said, "take " + shown]}]} if shift > 0 else right
            yield f"contradictory {said} {shown} {scene} {shift} settled", scene, [turn, things.UNIQUE[scene][shown]], settled
    for shift, turn in both("yes", {"gesture": "negack"}):
        yield f"contradictory yes no {shift}", "place_setting", ["take the cup", turn], {"asks": True}


def afterwards():
    """A gesture that contradicts words on which the avatar acts already: what is chosen is done once."""
    for scene, thing in (("place_setting", "plate"), ("emre_table", "knife"), ("staircase", "block3"), ("workbench", "knife")):
        words = things.UNIQUE[scene][thing]
        for at in (0.2, 0.6, 1.0):
            side = "left" if scene != "emre_table" else "right"
            other = {"left": "right", "right": "left"}[side]
            turn = [{"say": f"push {words} to the {side}", "at": 0}, {"gesture": "push", "direction": other, "at": at}]
            yield f"pushed {side} {thing} {scene} {at}", scene, [turn, "yes"], {"acts": [f"push {thing} {side}"]}
        for at in (0.1, 0.4):
            turn = [{"say": f"lift {words}", "at": 0}, {"gesture": "turn", "at": at}]
            yield f"lifted {thing} {scene} {at}", scene, [turn, "yes"], {"acts": [f"lift {thing}"]}
            turn = [{"say": f"put {words} in front of me", "at": 0}, {"gesture": "grab", "at": at}]
            yield f"grasped {thing} {scene} {at}", scene, [turn], {"acts": [f"put {thing} front"]}
    for scene, thing, ground, elsewhere in (("place_setting", "knife", "plate", [-0.1, -0.17]), ("workbench", "block_red", "plate", [0.0, -0.2]),
                                            ("staircase", "block7", "block1", [0.12, -0.06])):
        for at in (0.2, 0.6):
            turn = [{"say": f"put {things.UNIQUE[scene][thing]} on {things.UNIQUE[scene][ground]}", "at": 0}, {"point": elsewhere, "at": at}]
            yield f"elsewhere {thing} {ground} {scene} {at}", scene, [turn, "yes"], {"acts": [f"put {thing} on {ground}"]}
            turn = [turn[0], {"point": things.where(scene, thing), "at": at}]
            yield f"not elsewhere {thing} {ground} {scene} {at}", scene, [turn], {"acts": [f"put {thing} on {ground}"]}


def timed():
    """Words with an end, and gestures while they are spoken."""
    for scene, thing in (("place_setting", "knife"), ("workbench", "cup"), ("emre_table", "plate")):
        for at in (0.2, 0.6, 1.0):
            words = {"kind": "speech", "text": "take this", "until": 2.4}
            yield f"take this {thing} {scene} until {at}", scene, [[{"event": words, "at": 0}, {"gesture": thing, "at": at}]], {"acts": ["take " + thing]}


def members():
    for part in (equal, complementary, contradictory, afterwards):
        for name, scene, say, expect in part():
            yield {"id": f"ensembles {name}", "scene": scene, "say": say, "expect": expect}
