#!/usr/bin/env python3
"""Writes EMRE's referring expressions as traces: make_traces.py REFERENCES.jsonl FOLDER

One trace per expression, FOLDER/0001.trace.jsonl and on, in the order of the file. What was pointed is a gesture with
30 Hz samples of half a second; what was said begins with the pointing. The focus is expected as the only referent
where that is certain: it is of the kind and colour that was said and pointed at, and no other such object is near.
"""
import json
import math
import pathlib
import sys

SCALE = 0.4  # metres of ours to one of VoxSim's
HALF_HEIGHT = {"block": 0.03, "plate": 0.01, "cup": 0.05, "knife": 0.005}
BEGIN, RATE, SAMPLES = 1.0, 30.0, 16  # seconds, 1/s
NEAR, FAR = 0.05, 0.15  # metres


def in_w(x, z):
    """VoxSim's metres (x to the avatar's right, z toward the human) in frame W."""
    return [round(-SCALE * x, 6), round(-SCALE * z, 6)]


def header(item):
    objects = {}
    for each in item["objects"]:
        x, _, z = each["position"]
        objects[each["name"]] = {"position": in_w(x, z) + [HALF_HEIGHT[each["type"]]]}
    return {"kind": "trace", "version": 1, "scene": "emre_table", "machine": "interaction", "seed": 0,
            "perspective": "avatar", "objects": objects, "source": item["id"]}


def is_certain(item):
    if not item["text"] or not item.get("deixis"):
        return False
    target, kind, distances = in_w(*item["deixis"]), {}, {}
    for each in item["objects"]:
        x, _, z = each["position"]
        distances[each["name"]] = math.dist(in_w(x, z), target)
        kind[each["name"]] = (each["type"], each.get("color"))
    alike = [distances[name] for name in kind if name != item["focus"] and kind[name] == kind[item["focus"]]]
    return distances[item["focus"]] < NEAR and all(each > FAR for each in alike)


def events(item):
    deixis, end = item.get("deixis"), BEGIN
    if deixis:
        target, end = in_w(*deixis), BEGIN + (SAMPLES - 1) / RATE
        yield {"t": BEGIN, "kind": "gesture", "name": "point", "hand": "right", "phase": "start", "target": target}
        for i in range(SAMPLES):
            yield {"t": round(BEGIN + i / RATE, 6), "kind": "pointing", "hand": "right", "target": target}
    if item["text"]:
        until = round(BEGIN + 0.3 * len(item["text"].split()), 6)
        yield {"t": BEGIN, "kind": "speech", "text": item["text"], "until": until}
        end = max(end, until)
    if deixis:
        yield {"t": round(end, 6), "kind": "gesture", "name": "point", "hand": "right", "phase": "stop"}
    end = round(end + 2, 6)
    if is_certain(item):
        yield {"t": end, "kind": "expect", "referents": [item["focus"]]}
    yield {"t": end, "kind": "end"}


def main(references, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    lines = pathlib.Path(references).read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        item = json.loads(line)
        ordered = sorted(events(item), key=lambda event: event["t"])
        records = [header(item), *ordered]
        text = "".join(json.dumps(record, separators=(",", ":")) + "\n" for record in records)
        (folder / f"{number:04}.trace.jsonl").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
