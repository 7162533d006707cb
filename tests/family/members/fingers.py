"""Fingers say how many, and words say of what: before the words, during them, after them, as an answer and as a correction."""

# Scene, the words for several things of a kind, how many there are.
KINDS = [("workbench", "blocks", 3), ("staircase", "blocks", 6), ("place_setting", "cups", 2)]
FINGERS = {1: "count_one", 2: "count_two", 3: "count_three", 4: "count_four"}


def counts():
    """Each kind with each number of fingers that leaves some of them out."""
    for scene, kind, most in KINDS:
        for number in range(2, min(most, 5)):
            yield scene, kind, number
    yield "place_setting", "cups", 1
    yield "staircase", "blocks", 1


def fingers(number, at=0.0):
    return {"gesture": FINGERS[number], "at": at}


def spoken(words, at, until=None):
    return {"event": {"kind": "speech", "text": words, **({"until": round(1 + until, 2)} if until else {})}, "at": at}


def with_all(scene, kind, number):
    most = next(count for where, _, count in KINDS if where == scene)
    acts = {"acts": ["lift"] * number}
    for words in (f"lift the {kind}", f"lift all {kind}"):
        for at in (0.4, 1.2):
            yield f"before, {words} {at}", [[fingers(number), spoken(words, at)]], acts
        for at in (0.2, 0.9):
            yield f"during, {words} {at}", [[spoken(words, 0, 2.2), fingers(number, at)]], acts
        yield f"at once, {words}", [[spoken(words, 0), fingers(number, 0)]], acts
        # Acts that were done before are taken back.
        done = {"acts": ["lift"] * most + ["put"] * (most - number)}
        for at in (0.5, 1.1):
            yield f"after, {words} {at}", [[spoken(words, 0), fingers(number, at)]], {"one_of": [acts, done]}


def with_some(scene, kind, number):
    if number < 2:
        return
    acts = {"acts": ["lift"] * number}
    yield "some before", [[fingers(number), spoken(f"lift {kind}", 0.6)]], acts
    yield "some during", [[spoken(f"lift {kind}", 0, 2), fingers(number, 0.7)]], acts
    yield "some after", [[spoken(f"lift {kind}", 0), fingers(number, 0.9)]], acts
    yield "an answer", [f"lift {kind}", [fingers(number)]], acts
    if scene != "staircase":
        yield "an answer after too many", [f"lift {kind}", [{"gesture": "count_five", "at": 0}], [fingers(number)]], acts
    yield "the things first", [[fingers(number), spoken(kind, 0.5)], "lift them"], acts
    yield "the things first, fingers later", [kind, [fingers(number)], "lift them"], acts
    yield "asked for the thing", ["lift", [fingers(number), spoken(kind, 0.6)]], acts


WORD = {2: "two", 3: "three"}


def corrections(scene, kind, number):
    for said in WORD:
        if said >= number:
            continue
        acts = {"acts": ["lift"] * number}
        yield f"no, more than {said}", [f"lift {WORD[said]} {kind}", [{"say": "no", "at": 0}, fingers(number, 0.8)]], acts
        yield f"shaken, more than {said}", [f"lift {WORD[said]} {kind}", [{"gesture": "negack", "at": 0}, fingers(number, 1.5)]], acts


def members():
    for scene, kind, number in [*counts(), ("workbench", "blocks", 3)]:
        parts = [corrections] if (scene, number) == ("workbench", 3) else [with_all, with_some, corrections]
        for part in parts:
            for k, (way, say, expect) in enumerate(part(scene, kind, number)):
                yield {"id": f"fingers {scene} {kind} {number} {way}", "scene": scene, "say": say, "expect": expect}
