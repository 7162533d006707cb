"""Words that are not final may start a look, never an act: the act is that of the final words, done once."""
import itertools

import things


def heard(text, at, final=False):
    return {"event": {"kind": "speech", "text": text, "final": final}, "at": at}


def growing(sentence, step=0.4):
    """The sentence word by word, as a browser tells it."""
    words = sentence.split()
    return [heard(" ".join(words[:k]), round(step * k, 3)) for k in range(1, len(words) + 1)]


def ways(thing, name, other, other_name):
    whole = f"lift {name}"
    late = {"say": whole, "at": 4}
    yield "word by word", [[*growing(whole), late]], [f"lift {thing}"]
    yield "revised", [[*growing(f"lift {other_name}"), late]], [f"lift {thing}"]
    yield "another verb", [[*growing(f"take {other_name}"), *[heard(f"turn {name}", 3)], late]], [f"lift {thing}"]
    yield "never final", [[*growing(f"lift {other_name}")], whole], [f"lift {thing}"]
    yield "an answer", [[{"event": {"kind": "speech", "text": whole, "confidence": 0.2}}], [heard("no", 0.2), {"say": "yes", "at": 1}]], [f"lift {thing}"]
    yield "an object first", [[*growing(name), {"say": name, "at": 3}], [*growing("lift it"), {"say": "lift it", "at": 2}]], [f"lift {thing}"]
    yield "what was missing", ["lift", [*growing(other_name), {"say": name, "at": 3}]], [f"lift {thing}"]


def members():
    pairs = [(a, b) for a, b in itertools.pairwise(things.everything()) if a[0] == b[0]]
    for k, ((scene, thing, name), (_, other, other_name)) in enumerate(pairs):
        for i, (way, turns, acts) in enumerate(ways(thing, name, other, other_name)):
            if (i + k) % 3 == 0:
                yield {"id": f"interim_speech {scene} {thing} {way}", "scene": scene, "say": turns, "expect": {"acts": acts}}
