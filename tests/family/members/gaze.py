"""The eyes make what they dwell on salient: it is asked about first, and never taken without being asked about."""
import things


def looked(place, begin=0.0, samples=24, **more):
    """Samples of an eye tracker, as parts of a turn."""
    return [{"event": {"kind": "gaze", "target": place, **more}, "at": round(begin + k / 30, 3)} for k in range(samples)]


def ray_to(place):
    eye = [0.0, -0.8, 0.45]
    return {"from": eye, "direction": [place[0] - eye[0], place[1] - eye[1], -eye[2] + 0.01]}


def then(text, at=0.9):
    return {"say": text, "at": at}


def shared():
    for scene, names in things.SHARED.items():
        for name, all_of in names.items():
            for thing in all_of:
                yield scene, name, thing, all_of


def members():
    def item(scene, what, turns, act):
        return {"id": f"gaze {scene} {what}", "scene": scene, "say": turns, "expect": {"acts": [act]}}

    for scene, name, thing, all_of in shared():
        there = things.where(scene, thing)
        yield item(scene, f"{thing} of several", [[*looked(there), then(f"lift {name}")], "yes"], f"lift {thing}")
        other = next(each for each in all_of if each != thing)
        yield item(scene, f"{thing} after another", [[*looked(things.where(scene, other), samples=8), *looked(there, 0.4, 40), then(f"take {name}", 1.8)], "yes"],
                   f"take {thing}")
    for k, (scene, thing, name) in enumerate(things.everything()):
        there = things.where(scene, thing)
        elsewhere = things.FREE[scene]
        if k % 3 == 0:
            yield item(scene, f"{thing} for it", [[*looked(there), then("lift it")], "yes"], f"lift {thing}")
            yield item(scene, f"{thing} not meant", [[*looked(there), then("lift it")], "no", f"lift {name}"], f"lift {thing}")
        if k % 3 == 1:
            yield item(scene, f"{thing} by a ray", [[{"event": {"kind": "gaze", "ray": ray_to(there), "until": 1.8}, "at": 0}, then("lift")], "yes"], f"lift {thing}")
            yield item(scene, f"{thing} while looking elsewhere", [[*looked(elsewhere), then(f"lift {name}")]], f"lift {thing}")
        if k % 3 == 2:
            point = {"point": there, "at": 1.0}
            yield item(scene, f"{thing} pointed at", [[*looked(elsewhere), point, then("lift that one", 1.0)]], f"lift {thing}")
            yield item(scene, f"{thing} looked at long ago", [[*looked(there)], f"take {name}"], f"take {thing}")
