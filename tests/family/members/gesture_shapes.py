"""A gesture without a name is learned from one showing and known by its shape: with noise, among others, in several
dimensions. A shape that is like none or like two is asked about, and a correction makes another exemplar."""
import random

import things

DIMENSIONS = [1, 2, 3, 8, 32, 128]


def features(rng, dimensions):
    return [rng.gauss(0, 1) for _ in range(dimensions)]


def noisy(rng, shape, share):
    """The shape with noise of this share of its length."""
    noise = [rng.gauss(0, 1) for _ in shape]
    length = sum(x * x for x in shape) ** 0.5
    scale = share * length / (sum(x * x for x in noise) ** 0.5)
    return [x + scale * e for x, e in zip(shape, noise)]


def between(a, b, share):
    return [(1 - share) * x + share * y for x, y in zip(a, b)]


def unit(k, dimensions, length=1.0):
    return [length if i == k else 0.0 for i in range(dimensions)]


def show(shape, **more):
    return [{"event": {"kind": "gesture", "phase": "stroke", "features": shape, **more}}]


def item(what, scene, say, expect):
    return {"id": f"gesture_shapes {what}", "scene": scene, "say": say, "expect": expect}


def act(verb, thing):
    return {"acts": [f"{'take' if verb == 'grasp' else verb} {thing}"]}


def recognised(everything):
    for seed in range(12):
        rng = random.Random(seed)
        dimensions = DIMENSIONS[seed % 6] if seed % 6 else 4
        scene, thing, name = everything[seed * 5 % len(everything)]
        verb = ["grasp", "lift"][seed % 2]
        shape = features(rng, dimensions)
        other = [-x for x in shape]
        share = [0.02, 0.1, 0.2, 0.3][seed % 4]
        yield item(f"noise {share} of {dimensions}, seed {seed}", scene,
                   [show(shape), f"{verb} {name}", show(noisy(rng, shape, share))], act(verb, thing))
        yield item(f"unlike, seed {seed}", scene, [show(shape), f"{verb} {name}", show(noisy(rng, other, share))],
                   {"no_act": True, "asks": True})


def among_several():
    names = things.UNIQUE["place_setting"]
    for seed in range(4):
        rng = random.Random(100 + seed)
        shapes = {thing: unit(i, 4 + seed, 3.0) for i, thing in enumerate(names)}
        teaching = [turn for thing, shape in shapes.items() for turn in (show(shape), f"lift {names[thing]}")]
        wanted = list(names)[seed]
        yield item(f"one of four, seed {seed}", "place_setting", [*teaching, show(noisy(rng, shapes[wanted], 0.25))], act("lift", wanted))


def corrected():
    a, b = unit(0, 3), between(unit(0, 3), unit(1, 3), 0.25)
    learn_a, near_b = [show(a), "grasp the plate"], between(a, b, 0.95)
    yield item("a wrong one corrected", "place_setting",
               [*learn_a, show(b), "no, that means grasp the knife", show(near_b)], {"acts": ["take plate", "take knife"]})
    yield item("a wrong one corrected, the first stays", "place_setting",
               [*learn_a, show(b), "no, that means lift the knife", "let go of the plate", show(between(a, b, 0.05))],
               {"acts": ["take plate", "let_go plate", "take plate"]})
    yield item("a wrong one corrected, between the two", "place_setting",
               [*learn_a, show(b), "no, that means lift the knife", show(between(a, b, 0.5))], {"acts": ["take plate"], "asks": True})
    yield item("a wrong thing corrected", "place_setting",
               [show(a), "the plate", show(b), "no, that means the knife", show(near_b), "lift it"], act("lift", "knife"))
    yield item("more exemplars of one meaning", "workbench",
               [show(unit(0, 5)), "lift the knife", show(unit(1, 5)), "lift the knife", show(unit(1, 5, 1.1))], act("lift", "knife"))
    yield item("forgotten", "workbench", [show(a), "lift the knife", "forget that gesture", show(a)], {"no_act": True, "asks": True})
    yield item("learned anew after it was forgotten", "workbench",
               [show(a), "lift the knife", "forget that gesture", show(a), "lift the cup", show(noisy(random.Random(7), a, 0.1))],
               act("lift", "cup"))


def named():
    a, b = unit(0, 4), unit(1, 4)
    yield item("a known name counts", "emre_table", [show(a), "lift the knife", show(a, name="posack")], {"no_act": True})
    yield item("taught under a name, shown without", "emre_table", [show(a, name="hug"), "lift the knife", show(between(a, b, 0.05))],
               act("lift", "knife"))
    yield item("taught without a name, shown with one", "emre_table", [show(a), "lift the knife", show(a, name="swirl")], act("lift", "knife"))
    yield item("another length is another space", "emre_table", [show(a), "lift the knife", show([1.0, 0.0, 0.0])],
               {"no_act": True, "asks": True})
    yield item("fills what put lacks", "emre_table", [show(a), "grasp the knife", "put it on the plate", show(between(a, b, 0.1))],
               {"acts": ["put knife on plate"]})
    yield item("a thing fills what put lacks", "place_setting", [show(b), "the blue cup", "put it behind the plate", show(between(b, a, 0.1))],
               {"acts": ["put cup_blue behind plate"]})
    yield item("an n-best list of unknown names", "workbench",
               [show(a), "lift the knife", show(between(a, b, 0.1), alternatives=[{"text": "hug", "confidence": 0.5}, {"text": "swirl", "confidence": 0.4}])],
               act("lift", "knife"))
    yield item("numbers of any size", "workbench", [show(unit(0, 3, 1e200)), "lift the knife", show([1.1e200, 1e199, 0.0])], act("lift", "knife"))
    yield item("all zero", "workbench", [show([0.0, 0.0]), "lift the knife", show([0.0, 0.0])], act("lift", "knife"))


def members():
    everything = [each for each in things.everything() if each[1] != "plate"]
    for family in (recognised(everything), among_several(), corrected(), named()):
        yield from family
