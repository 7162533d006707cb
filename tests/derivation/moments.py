"""Names of the moment: the input and its reading, as far as a run log tells them."""
import re

import terms
from evaluate import Unknown
from terms import FALSE, NULL

NO_POINTING, POINTED = NULL, ("opaque", "pointed (perception)")


def names(objects):
    return ("list", tuple(("name", each) for each in objects))


def texts(words):
    return ("list", tuple(("text", each) for each in words))


def annotated(term, missing):
    """The meaning, its outer lambdas with the types that the reading states."""
    if term[0] == "lam" and missing:
        return ("lam", terms.Hint(term[1].name, missing[0]["type"]), annotated(term[2], missing[1:]))
    return term


def of_reading(reading):
    """What a reading says. A name that is left out is unknown."""
    said = {"move": ("text", reading["move"]) if reading["move"] is not None else NULL}
    missing = reading.get("missing", [])
    said["reading"] = terms.read(reading["reading"]) if "reading" in reading else NULL
    said["meaning"] = annotated(terms.read(reading["meaning"]), missing) if "meaning" in reading else NULL
    said["choices"] = ("list", tuple(names(each["choices"]) for each in missing))
    said["wanted"] = texts(each["words"] for each in missing)
    said["referents"] = names(reading.get("referents", []))
    if not any(reading.get(words) for words in ("unknown", "unused", "repaired")):
        said["left_out"] = said["unknown"] = texts([])
    said["repaired"] = texts(reading.get("repaired", []))
    return said


def of_event(event, symbol, reading):
    said = {"said": NULL, "gesture": NULL, "act": NULL, "target": NULL}
    if event["kind"] == "speech":
        said["said"] = ("text", reading["words"]) if reading and "words" in reading else ("opaque", "said (words)")
    elif event["kind"] == "gesture":
        said["gesture"] = ("text", event["name"]) if "name" in event else ("opaque", "gesture (of an n-best list)")
    elif event["kind"] == "act":
        said["act"] = terms.read(event["program"])
    if "ray" in event or "alternatives" in event and event["kind"] == "gesture":
        del said["target"], said["gesture"]
    elif "target" in event:
        said["target"] = ("point", *map(float, event["target"]), 0.0)
    if event["kind"] == "speech":
        del said["target"]
    return said


def confidence_of(event, reading):
    if reading and "confidence" in reading:
        return reading["confidence"]
    return event.get("confidence", 1.0)


def plain(words):
    """In lower case, without punctuation, blanks around each word."""
    return " " + " ".join(re.findall(r"[^\s.,;:!?\"]+", words.lower())) + " "


def sentences(text):
    return [plain(each) for each in re.split(r"[.!?]+(?=\s|$)", text) if plain(each).strip()]


def same_words(a, b):
    return a.get("words") == b.get("words") and a.get("move") == b.get("move")


class Readings:
    """All readings of a log: the utterance that each belongs to, and the moves before and after it."""

    def __init__(self, records):
        self.records = records
        self.roots, self.turns, self.again = {}, {}, {}
        for record in records:
            if record["kind"] == "reading":
                root = self.input_of(record)
                self.roots[record["n"]] = root
                if record.get("taken", True):
                    self.add_move(self.turns.setdefault(root, []), record)

    def add_move(self, turn, reading):
        """One that comes of the input without a step between, and is not the first, is attended to again."""
        if turn and not self.comes_of_step(reading) and same_words(turn[-1], reading):
            self.again[reading["n"]] = turn[-1]["n"]
        else:
            turn.append(reading)

    def comes_of_step(self, record):
        while record is not None and record["kind"] not in ("input", "transition"):
            record = self.records[record["cause"]] if "cause" in record else None
        return record is not None and record["kind"] == "transition"

    def input_of(self, record):
        """The number of the input that a record goes back to, or None."""
        while record is not None and record["kind"] != "input":
            record = self.records[record["cause"]] if "cause" in record else None
        return record and record["n"]

    def place(self, reading):
        """The moves of its utterance, and its number among them."""
        turn = self.turns.get(self.roots[reading["n"]], [])
        n = self.again.get(reading["n"], reading["n"])
        at = next((i for i, each in enumerate(turn) if each["n"] == n), None)
        if at is None:
            raise Unknown("a neighbouring move of an input that was not taken")
        return turn, at

    def after(self, reading):
        """The kinds of the moves after it: those in its sentence, and those in later ones."""
        turn, at = self.place(reading)
        if at + 1 == len(turn):
            return texts([]), texts([])
        said = sentences(self.text_of(reading))
        numbers, number = [], 0
        for move in turn:
            words = plain(move.get("words", ""))
            number = next((i for i in range(number, len(said)) if words in said[i]), None)
            if number is None:
                raise Unknown("a move without a sentence")
            numbers.append(number)
        rest = list(zip(numbers, turn))[at + 1:]
        return (texts(move["move"] for number, move in rest if number == numbers[at]),
                texts(move["move"] for number, move in rest if number != numbers[at]))

    def joined(self, reading):
        """The words between it and the move before it in its sentence."""
        turn, at = self.place(reading)
        if at == 0:
            return NULL
        said = sentences(self.text_of(reading))
        before, words = plain(turn[at - 1].get("words", "")), plain(reading.get("words", ""))
        for sentence in said:
            if sentence.count(before) > 1:
                raise Unknown("words that are said twice")
            end = sentence.find(before) + len(before) - 1
            begin = sentence.find(words, end) if before in sentence else -1
            if begin >= 0:
                return ("text", sentence[end:begin].strip())
        if any(mark in self.text_of(reading) for mark in ":;…") or before == words:
            raise Unknown("a sentence that goes on after a mark")
        return NULL

    def quoted(self, reading):
        """Whether it stands in quotation marks; known where there are none."""
        if re.search(r"[\"“”„«»‘’']", re.sub(r"(?<=\w)['’](?=\w)", "", self.text_of(reading))):
            raise Unknown("quotation marks")
        return FALSE

    def text_of(self, reading):
        return self.records[self.roots[reading["n"]]]["event"].get("text", "")

    def neighbour(self, reading, by):
        """The kind of the move before or after."""
        turn, at = self.place(reading)
        if not 0 <= at + by < len(turn):
            return NULL
        move = turn[at + by]["move"]
        return NULL if move is None else ("text", move)

    def offered(self, reading):
        """All readings of an n-best list, by the number of the alternative."""
        if "alternative" not in reading:
            return {0: reading}
        return {each["alternative"]: each for each in self.records
                if each["kind"] == "reading" and each.get("cause") == reading.get("cause") and "alternative" in each}
