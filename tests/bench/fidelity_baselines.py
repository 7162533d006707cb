"""The scores of avatars that know nothing of the dialogue: one that is always silent, and a bigram table."""
import collections
import json
import pathlib
import re
import xml.etree.ElementTree

SCENES = pathlib.Path(__file__).resolve().parents[2] / "mjcf" / "scenes"


def names_in(scene):
    """Names of the objects and values of their attributes, as `continua score` leaves them out of templates."""
    names = set()
    for text in xml.etree.ElementTree.parse(SCENES / f"{scene}.xml").iter("text"):
        attributes = dict(pair.split("=", 1) for pair in text.get("data").split())
        names |= {text.get("name"), *(value for key, value in attributes.items() if key != "type")}
    return {name.lower() for name in names}


def template(moves, names):
    """Words and acts, with places and names left out. Gestures do not count."""
    def blank(word):
        return "_" if word[0].lower() in names else word[0]

    return tuple((channel, re.sub(r"\w+", blank, content if channel == "speech" else re.sub("<[^>]*>", "_", content)))
                 for channel, content in moves if channel != "gesture")


def symbol(event):
    if event["kind"] == "speech":
        return "speech " + event["text"].lower()
    strength = "low" if event.get("confidence", 1) < 0.5 else None
    parts = [event["kind"]] + [event.get(field) for field in ("hand", "name", "direction", "phase")] + [strength]
    return " ".join(part for part in parts if part)


class Session:
    """A trace as episodes: (last utterance's template, input), whether it is a pointing sample, moves."""

    def __init__(self, path):
        header, *events = (json.loads(line) for line in path.read_text(encoding="utf-8").splitlines())
        self.names = names_in(header["scene"])
        self.episodes, uttered = [], None
        for event in events:
            if event["kind"] in ("speech", "gesture", "pointing"):
                self.episodes.append(((uttered, symbol(event)), event["kind"] == "pointing", []))
            elif event["kind"] == "observed" and self.episodes:
                move = (event["channel"], event["content"])
                self.episodes[-1][2].append(move)
                if event["channel"] == "speech":
                    uttered = template([move], self.names)
        # Samples are hardly ever answered; `continua score` counts those that are not apart.
        self.episodes = [episode for episode in self.episodes if not episode[1] or episode[2]]


def words(moves, names):
    """Words and acts, word for word."""
    return tuple(move for move in moves if move[0] != "gesture")


def bigram_right(sessions, level):
    """How many inputs and how many speaking episodes agree at the level with a table learnt from the other sessions."""
    inputs = speaking = 0
    for session in sessions:
        table = collections.defaultdict(collections.Counter)
        for other in sessions:
            if other is not session:
                for key, _, moves in other.episodes:
                    table[key][level(moves, other.names)] += 1
        for key, sample, moves in session.episodes:
            # Of equally frequent ones, most_common puts the first seen first.
            guess = table[key].most_common(1)[0][0] if key in table else ()
            agrees = guess == level(moves, session.names)
            inputs += agrees and not sample
            speaking += agrees and bool(moves)
    return inputs, speaking


def baselines(paths):
    """Rows of name, inputs right, speaking episodes right; and how many inputs and speaking episodes there are."""
    sessions = [Session(path) for path in paths]
    episodes = [episode for session in sessions for episode in session.episodes]
    inputs = sum(not sample for _, sample, _ in episodes)
    speaking = sum(bool(moves) for _, _, moves in episodes)
    rows = [("always silent", sum(not moves for _, _, moves in episodes), 0),
            ("bigram table, templates", *bigram_right(sessions, template)),
            ("bigram table, exact words", *bigram_right(sessions, words))]
    return rows, inputs, speaking
