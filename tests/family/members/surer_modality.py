"""Words and a gesture contradict each other: the recogniser that is clearly surer is believed, and the avatar says so; else it asks."""
import things

# Scene, the thing that is said, the thing that is shown.
PAIRS = [("place_setting", "knife", "cup"), ("place_setting", "plate", "cup_blue"), ("workbench", "knife", "cup"),
         ("workbench", "block_red", "block_green"), ("emre_table", "knife", "plate"), ("staircase", "block7", "block5"),
         ("staircase", "block3", "block6")]
# Seconds from the beginning of the words to the gesture.
SHIFTS = (-0.5, -0.2, 0.0, 0.6)
SURE = [(0.95, 0.3), (0.9, 0.45), (1, 0.6)]
EQUAL = [(0.9, 0.9), (0.8, 0.7), (0.6, 0.75)]
WORDS, FINGER, SHAPE = "by your words", "by your finger", "by your gesture"


def told(words, confidence, at, until=None):
    event = {"kind": "speech", "text": words, "confidence": confidence}
    return {"event": {**event, "until": round(1 + at + until, 2)} if until else event, "at": at}


def pointed(place, confidence, at, hand="right"):
    return {"event": {"kind": "gesture", "name": "point", "phase": "start", "hand": hand, "target": place, "confidence": confidence}, "at": at}


def shown(name, confidence, at):
    return {"event": {"kind": "gesture", "name": name, "phase": "start", "confidence": confidence}, "at": at}


def samples(place, confidence, at):
    return [{"event": {"kind": "pointing", "hand": "left", "target": place, "confidence": confidence}, "at": round(at + k / 20, 2)} for k in range(16)]


def in_time(*parts):
    return sorted(parts, key=lambda part: part["at"])


def begun_before(verb, said, other, source, late):
    """The other thing is what is acted on. A gesture that comes when the words have been answered may find that act done."""
    right = {"acts": [f"{verb} {other}"], "says": [source]}
    return {"one_of": [right, {"acts": [f"{verb} {said}", f"{verb} {other}"], "says": [source]}]} if late > 0 else right


def fingers():
    verbs = ["take", "lift"]
    for k, (scene, said, other) in enumerate(PAIRS):
        verb, place, words = verbs[k % 2], things.where(scene, other), things.UNIQUE[scene][said]
        begin = 1.0
        for i, shift in enumerate(SHIFTS):
            sure, unsure = SURE[(i + k) % 3]
            finger = lambda confidence: pointed(place, confidence, round(begin + shift, 2))
            turn = in_time(told(f"{verb} {words}", sure, begin), finger(unsure))
            yield f"words {said} {other} {shift}", scene, [turn], {"acts": [f"{verb} {said}"], "says": [WORDS]}
            turn = in_time(told(f"{verb} {words}", unsure, begin), finger(sure))
            yield f"finger {said} {other} {shift}", scene, [turn], begun_before(verb, said, other, FINGER, shift)
        one, another = EQUAL[k % 3]
        for shift in SHIFTS[:3]:
            turn = in_time(told(f"{verb} {words}", one, begin), pointed(place, another, round(begin + shift, 2)))
            yield f"asked {said} {other} {shift}", scene, [turn], {"no_act": True, "asks": True}
        yield f"asked {said} {other} settled", scene, [turn, things.UNIQUE[scene][other]], {"acts": [f"{verb} {other}"]}


def held():
    """A finger that is held, as samples, during words with an end."""
    for scene, said, other in PAIRS:
        place, words = things.where(scene, other), "take " + things.UNIQUE[scene][said]
        yield f"held words {said} {other}", scene, [in_time(*samples(place, 0.4, 0.2), told(words, 0.95, 0.5, 1))], {"acts": ["take " + said], "says": [WORDS]}
        yield f"held finger {said} {other}", scene, [in_time(*samples(place, 0.95, 0.2), told(words, 0.5, 0.5, 1))], {"acts": ["take " + other], "says": [FINGER]}


def shapes():
    for scene, said, other in (("workbench", "knife", "cup"), ("workbench", "block_red", "plate"), ("place_setting", "cup_blue", "knife"),
                               ("place_setting", "knife", "plate"), ("emre_table", "plate", "cup"), ("emre_table", "cup", "knife")):
        words = "take " + things.UNIQUE[scene][said]
        for shift in (-0.6, 0.0, 0.4):
            at = round(1 + shift, 2)
            yield f"words, no shape {said} {other} {shift}", scene, [in_time(told(words, 0.95, 1), shown(other, 0.4, at))], {"acts": ["take " + said], "says": [WORDS]}
            late = shift >= 0
            yield f"shape {said} {other} {shift}", scene, [in_time(told(words, 0.5, 1), shown(other, 0.95, at))], begun_before("take", said, other, SHAPE, late)
            yield f"shape asked {said} {other} {shift}", scene, [in_time(told(words, 0.9, 1), shown(other, 0.85, at))], {"asks": True} if late else {"no_act": True, "asks": True}


def answers():
    """Yes or no, and a thumb that says the other."""
    for scene, command in (("place_setting", "take the cup"), ("workbench", "lift the block"), ("staircase", "take the block"), ("emre_table", "lift the green block")):
        verb = command.split()[0]
        for at in (0.9, 1.0, 1.4):
            turn = in_time(told("yes", 0.95, 1), shown("negack", 0.3, at))
            yield f"yes, no thumb {scene} {at}", scene, [command, turn], {"acts": [verb], "says": [WORDS]}
            turn = in_time(told("no", 0.95, 1), shown("posack", 0.3, at))
            yield f"no, no thumb {scene} {at}", scene, [command, turn, "yes"], {"acts": [verb]}
            turn = in_time(told("no", 0.3, 1), shown("posack", 0.95, at))
            yield f"thumb, not the no {scene} {at}", scene, [command, turn], {"acts": [verb], "says": [SHAPE]}
            turn = in_time(told("yes", 0.3, 1), shown("negack", 0.95, at))
            yield f"thumb, not the yes {scene} {at}", scene, [command, turn], {"no_act": True, "asks": True}


def agreeing():
    """What agrees is no contradiction, however unsure one of the two is."""
    for k, (scene, said, _) in enumerate(PAIRS):
        words, place = "take " + things.UNIQUE[scene][said], things.where(scene, said)
        sure, unsure = SURE[k % 3]
        yield f"agreed {said}", scene, [in_time(pointed(place, unsure, 0.8), told(words, sure, 1))], {"acts": ["take " + said]}


def members():
    for part in (fingers, held, shapes, answers, agreeing):
        for name, scene, say, expect in part():
            yield {"id": f"surer_modality {scene} {name}", "scene": scene, "say": say, "expect": expect}
