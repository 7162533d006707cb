#!/usr/bin/env python3
"""The family of the worked examples 1 to 4: every way to give a command with the modalities that the paper allows.

  ways.py FOLDER    writes NAME.trace.jsonl for each member

A member says or shows the object, says or shows the place, gives the predicate first or last, in one breath or turn by
turn, with the pointing before, during or after its word, by one hand or the other, as a stroke or as samples. All
members of a group end in the same act, which each expects.
"""
import json
import pathlib
import sys

SPOT = [-0.1, -0.17]
OBJECTS = {
    "plate": {"words": "the plate", "at": [-0.2, 0.01]},
    "cup_blue": {"words": "the blue cup", "at": [0.28, -0.02]},
}
PLACES = {
    "front": {"words": "in front of you", "act": "in_front(avatar)"},
    "spot": {"words": None, "act": f"<{SPOT[0]}, {SPOT[1]}, 0>"},
}
WORD_S = 0.35


class Scene:
    """Events of one member, with a clock that speech moves on."""

    def __init__(self):
        self.events, self.t = [], 1.0

    def say(self, words):
        """Speaks and returns when each word begins."""
        begins = [round(self.t + i * WORD_S, 3) for i in range(len(words.split()))]
        self.events.append({"t": self.t, "kind": "speech", "text": words, "until": round(self.t + len(begins) * WORD_S, 3)})
        self.t = round(self.t + len(begins) * WORD_S, 3)
        return begins

    def show(self, place, at, how, hand):
        if how == "stroke":
            self.events.append({"t": round(at, 3), "kind": "gesture", "name": "point", "hand": hand, "phase": "stroke",
                                "target": place, "until": round(at + 0.5, 3)})
        else:
            for i in range(16):
                self.events.append({"t": round(at + i / 30, 3), "kind": "pointing", "hand": hand,
                                    "target": [place[0] + 0.003 * ((i * 7) % 5 - 2), place[1] + 0.003 * ((i * 3) % 5 - 2)]})

    def pause(self, seconds):
        self.t = round(self.t + seconds, 3)


def members():
    when = {"before": -0.6, "during": 0.0, "after": 0.5}
    for name, thing in OBJECTS.items():
        for place_name, place in PLACES.items():
            act = f"put({name}, {place['act']})"
            for by in ("word", "point"):
                for order in ("object first", "predicate first", "one breath"):
                    timings = when if (by == "point" or place["words"] is None) else {"spoken": 0}
                    for timing, shift in timings.items():
                        for how, hand in (("stroke", "right"), ("samples", "left")):
                            if timing == "spoken" and how == "samples":
                                continue
                            yield f"{name}_{place_name}_{by}_{order}_{timing}_{how}".replace(" ", "_"), \
                                member(thing, place, by, order, shift, how, hand), act


def member(thing, place, by, order, shift, how, hand):
    scene = Scene()
    spoken_object = thing["words"] if by == "word" else "that"
    spoken_place = place["words"] or "there"

    def name_object():
        begins = scene.say(spoken_object)
        if by == "point":
            scene.show(thing["at"], begins[0] + shift, how, hand)
        scene.pause(3)

    def command(words, object_word=None):
        begins = scene.say(words)
        told = words.split()
        if object_word and by == "point":
            scene.show(thing["at"], begins[told.index(object_word)] + shift, how, hand)
        if place["words"] is None:
            scene.show(SPOT, begins[told.index("there")] + shift, how, hand)
        scene.pause(3)

    if order == "object first":
        name_object()
        command(f"put it {spoken_place}")
    elif order == "predicate first":
        command(f"put it {spoken_place}")
        name_object()
    else:
        # Two pointings by one hand take a breath between them.
        words = f"put {spoken_object} {spoken_place}" if by == "word" else f"put that one please {spoken_place}"
        command(words, "that" if by == "point" else None)
    scene.events.sort(key=lambda event: event["t"])
    return scene


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    count = 0
    for name, scene, act in members():
        header = {"kind": "trace", "version": 1, "scene": "place_setting", "machine": "interaction", "perspective": "human"}
        end = [{"t": scene.t + 1, "kind": "expect", "state": "Ready", "act": act, "stack_depth": 1}, {"t": scene.t + 1.5, "kind": "end"}]
        lines = [json.dumps(each, separators=(",", ":")) for each in [header, *scene.events, *end]]
        (folder / f"{name}.trace.jsonl").write_text("\n".join(lines) + "\n")
        count += 1
    print(f"{count} traces")


if __name__ == "__main__":
    main()
