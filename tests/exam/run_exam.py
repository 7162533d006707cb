#!/usr/bin/env python3
"""Holds an exam: replays utterances without physics and compares the avatar's acts and answers with expectations.

  tests/exam/run_exam.py build/continua tests/exam/EXAM.jsonl [--all]

An exam has a JSON object a line: {"id", "scene", "say": [turns], "expect"}. A turn is a text, or a list of parts in the
order of their times: texts, {"point": [x, y]}, {"gesture": NAME, "direction": …} and {"event": {…}}, an event of a trace
without its time. Parts follow each other by 0.6 s; one with "at" comes so many seconds after its turn's beginning, and a
text with a time is {"say": TEXT, "at": …}. An item may have a "machine" and a "perspective". `expect` is "nothing", or an object
with any of `acts` ("put knife on plate", in order; a list where one of several will do; the end may be left out: "put
knife"), `acts_any_order`, `no_act`, `asks` (the last answer is a question), `says` (one of these texts is in the
answer to the last turn) and `one_of` (a list of expectations, one of which will do). Prints each line that went otherwise, and the share of right ones by the letters of their ids.
--all prints the right ones too. Ends with status 1 if one is wrong.
"""
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

VERBS = {"grasp": "take", "slide": "push", "ungrasp": "let_go", "turn_by": "turn", "reach": "point"}
SECONDS_BETWEEN_TURNS, SECONDS_BETWEEN_PARTS = 15, 0.6


def events_of(part):
    if isinstance(part, str):
        yield {"kind": "speech", "text": part}
    elif "say" in part:
        yield {"kind": "speech", "text": part["say"]}
    elif "event" in part:
        yield part["event"]
    elif "point" in part:
        target = {"hand": part.get("hand", "right"), "target": part["point"]}
        yield {"kind": "gesture", "name": "point", "phase": "start", **target}
        yield {"kind": "pointing", **target}
    else:
        direction = {"direction": part["direction"]} if "direction" in part else {}
        yield {"kind": "gesture", "name": part["gesture"], "phase": "start", **direction}


def timed_events(item):
    for i, turn in enumerate(item["say"]):
        for k, part in enumerate(turn if isinstance(turn, list) else [turn]):
            seconds = part["at"] if isinstance(part, dict) and "at" in part else SECONDS_BETWEEN_PARTS * k
            for event in events_of(part):
                yield {"t": round(1 + SECONDS_BETWEEN_TURNS * i + seconds, 3), **event}


def write_trace(item, path):
    header = {"kind": "trace", "version": 1, "scene": item["scene"], "machine": item.get("machine", "interaction")}
    header.update({key: item[key] for key in ("perspective",) if key in item})
    with open(path, "w", encoding="utf-8") as trace:
        for line in [header, *sorted(timed_events(item), key=lambda event: event["t"])]:
            print(json.dumps(line), file=trace)


SIDES = {"left": "left", "right": "right", "in_front": "front", "behind": "back"}
SIDE_OF = {"human": "front", "avatar": "back"}
SCENES = pathlib.Path(__file__).parents[2] / "mjcf" / "scenes"


def positions_in(scene):
    """The x and y of each object at the beginning."""
    text = (SCENES / (scene + ".xml")).read_text(encoding="utf-8")
    bodies = re.findall(r'<body name="(\w+)" pos="(\S+) (\S+)', text)
    return {name: (float(x), float(y)) for name, x, y in bodies}


def direction_to(point, position):
    x, y = point[0] - position[0], point[1] - position[1]
    if abs(x) > abs(y):
        return "right" if x > 0 else "left"
    return "back" if y > 0 else "front"


def acts_in_words(program, positions):
    """The ways to tell an act: put(knife, on(plate)) as "put knife on plate"; a point or a region as "at", or by the
    direction in which the thing goes; beside something also as near it; a side of the thing itself or of someone also as that side: push(cup, behind(cup)) as
    "push cup back"."""
    words = re.findall(r"-?[\w.]+|<", program)
    said = [VERBS.get(words[0], words[0]), *words[1:2]]
    place = words[2:]
    if "<" in place:
        ways = ["at"]
        if place[0] == "<" and words[1] in positions:
            ways.append(direction_to((float(place[1]), float(place[2])), positions[words[1]]))
        return [" ".join([*said, way]) for way in ways]
    if place[0:1] and place[0] in SIDES and place[1] in (words[1], "human", "avatar"):
        return [" ".join([*said, SIDES[place[0]]]), " ".join([*said, *place])]
    if said[0] == "push" and place[0:1] == ["near"] and place[1] in SIDE_OF:
        return [" ".join([*said, SIDE_OF[place[1]]]), " ".join([*said, *place])]
    if place[0:1] == ["beside"]:
        return [" ".join([*said, *place]), " ".join([*said, "near", *place[1:]])]
    return [" ".join([*said, *place])]


def read_run(path, scene, last_turn_s):
    """The acts that were done, each in the ways to tell it and with the things that it moved, all that the avatar said,
    and its words since the last turn."""
    acts, said, answers, moves, positions = [], [], [], [], positions_in(scene)
    before = dict(positions)
    with open(path, encoding="utf-8") as log:
        for record in map(json.loads, log):
            kind = record["kind"]
            if kind == "utterance":
                said.append(record["text"])
                if record["t"] >= last_turn_s:
                    answers.append(record["text"])
            elif kind == "pose":
                positions.update({name: pose[:2] for name, pose in record["bodies"].items()})
            elif kind == "act" and record["status"] == "asked":
                moves = []
            elif kind == "act" and "step" in record and record["status"] == "done":
                if record["program"].startswith("move("):
                    move = acts_in_words("put" + record["program"][4:], before)
                    if not moves or moves[-1][0].split()[1] != move[0].split()[1]:
                        moves.append(move)
            elif kind == "act" and record["status"] == "done" and record["program"] != "stop":
                acts.append((acts_in_words(record["program"], before), moves))
                before = dict(positions)
    return acts, said, answers


def is_wanted(wanted, ways):
    choices = wanted if isinstance(wanted, list) else [wanted]
    return any((way + " ").startswith(choice + " ") for choice in choices for way in ways)


def unfolded(acts):
    """The acts with a swap told by the things that it moves."""
    return [each for ways, moves in acts for each in (moves if ways[0].startswith("swap ") else [ways])]


def fault(expect, acts, answers):
    """Says what is wrong; empty if nothing is. A swap may be expected as one act or as the moves of its things."""
    whole = [ways for ways, _ in acts]
    return "" if not fault_of(expect, unfolded(acts), answers) else fault_of(expect, whole, answers)


def fault_of(expect, acts, answers):
    if expect == "nothing":
        expect = {"no_act": True}
    if "one_of" in expect:
        faults = [fault_of(each, acts, answers) for each in expect["one_of"]]
        return "" if "" in faults else "; or ".join(faults)
    wanted = expect.get("acts", expect.get("acts_any_order"))
    if expect.get("no_act") and acts:
        return "expected no act"
    if wanted is not None:
        rest = list(acts)
        for each in wanted:
            found = next((act for act in rest if is_wanted(each, act)), None)
            if found is None or ("acts" in expect and found != rest[0]):
                return f"expected {wanted}"
            rest.remove(found)
        if rest:
            return f"expected {wanted}"
    if expect.get("asks") and not (answers and answers[-1].endswith("?")):
        return "expected a question"
    said = " ".join(answers).lower()
    if "says" in expect and not any(text.lower() in said for text in expect["says"]):
        return f"expected one of {expect['says']}"
    return ""


def read_exam(path):
    with open(path, encoding="utf-8") as lines:
        return [json.loads(line) for line in lines if line.strip()]


def hold(program, items, physics=False, shows_right=False):
    """Replays the items in one of the worlds and prints what went otherwise. Returns whether all went right."""
    right, count, utterances = collections.Counter(), collections.Counter(), collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        traces = [os.path.join(folder, item["id"] + ".trace.jsonl") for item in items]
        for item, trace in zip(items, traces):
            write_trace(item, trace)
        world = [] if physics else ["--no-physics"]
        command = [program, "replay", *traces, *world, "-j", "2", "-o", folder + "/"]
        subprocess.run(command, capture_output=True, check=False)
        for item, trace in zip(items, traces):
            last_turn_s = 1 + SECONDS_BETWEEN_TURNS * (len(item["say"]) - 1)
            acts, said, answers = read_run(trace.replace(".trace.", ".run."), item["scene"], last_turn_s)
            part = re.match(r"[a-z_]+", item["id"]).group()
            wrong = fault(item["expect"], acts, answers)
            utterances.update(said)
            count[part] += 1
            right[part] += not wrong
            if wrong or shows_right:
                print(f"{item['id']}: {item['say']}\n  {wrong or 'right'}: did {[ways[0] for ways, _ in acts]}, said {answers}")
    for part in count:
        print(f"{part}: {right[part]} of {count[part]}, {100 * right[part] / count[part]:.0f} %")
    print(f"\"Okay.\" is {utterances['Okay.']} of {utterances.total()} utterances")
    return right == count


if __name__ == "__main__":
    sys.exit(not hold(sys.argv[1], read_exam(sys.argv[2]), shows_right="--all" in sys.argv))
