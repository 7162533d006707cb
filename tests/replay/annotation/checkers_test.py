#!/usr/bin/env python3
"""Exports under the eyes of others: ELAN's own schema by xmllint, a reader that knows no more of ELAN's files than their
manual says, Praat, and npm's WebVTT parser. Recordings of the pilot study through ELAN's file and back.

checkers_test.py PROGRAM SOURCE NODE_MODULES
"""
import collections
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

SCHEMA = os.environ.get("CONTINUA_EAF_SCHEMA")  # ELAN's EAFv3.0.xsd, whose licence does not let it stand here
PRAAT_SCRIPT = """form Read
  text file
endform
Read from file: file$
tiers = Get number of tiers
for i to tiers
  name$ = Get tier name: i
  intervals = Get number of intervals: i
  labelled = 0
  for j to intervals
    label$ = Get label of interval: i, j
    if label$ <> ""
      labelled = labelled + 1
    endif
  endfor
  appendInfoLine: name$, tab$, labelled
endfor
"""
VTT_SCRIPT = """
const { WebVTTParser } = require('webvtt-parser');
const read = new WebVTTParser().parse(require('fs').readFileSync(process.argv[1], 'utf8'), 'subtitles');
console.log(JSON.stringify({ cues: read.cues.length, errors: read.errors }));
"""


def output_of(*command, **more):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=120, check=False, **more)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command[:4]))}: {done.returncode}, {done.stderr[-400:]}{done.stdout[-200:]}")
    return done.stdout


def check_schema(eaf):
    """Raises where ELAN's file does not hold to its schema, or is no XML."""
    output_of("xmllint", "--noout", "--nonet", *(["--schema", SCHEMA] if SCHEMA else []), eaf)


def tiers_of(eaf):
    """{tier: [(begin, end, label)]}; of a tier that refers to another one the times are that one's."""
    root = xml.etree.ElementTree.parse(eaf).getroot()
    times = {slot.get("TIME_SLOT_ID"): int(slot.get("TIME_VALUE")) for slot in root.iter("TIME_SLOT")}
    spans, tiers = {}, collections.OrderedDict()
    for tier in root.iter("TIER"):
        found = tiers[tier.get("TIER_ID")] = []
        for one in tier.iter("ALIGNABLE_ANNOTATION"):
            span = times[one.get("TIME_SLOT_REF1")], times[one.get("TIME_SLOT_REF2")]
            spans[one.get("ANNOTATION_ID")] = span
            found.append((*span, one.findtext("ANNOTATION_VALUE")))
        for one in tier.iter("REF_ANNOTATION"):
            found.append((*spans[one.get("ANNOTATION_REF")], one.findtext("ANNOTATION_VALUE")))
    return tiers


def check_run(program, run, folder, node_modules):
    """The faults of the exports of one run or trace."""
    eaf, grid, vtt, srt = (folder / f"x.{ending}" for ending in ("eaf", "TextGrid", "vtt", "srt"))
    for file in (eaf, grid, vtt, srt):
        output_of(program, "export", run, "--to", file.suffix[1:].lower(), "-o", file)
    check_schema(eaf)
    tiers = tiers_of(eaf)
    for name, annotations in tiers.items():
        for (begin, end, _), (after, _, _) in zip(annotations, annotations[1:] + [(1 << 60, 0, "")]):
            if not begin < end <= after:
                yield f"{run}: {name}: {begin} to {end} ms, then {after} ms"
    if shutil.which("praat"):
        script = folder / "read.praat"
        script.write_text(PRAAT_SCRIPT)
        read = dict(line.split("\t") for line in output_of("praat", "--run", script, grid).splitlines())
        read.pop("continua.trace")
        labelled = {name: str(sum(bool(label) for _, _, label in annotations)) for name, annotations in tiers.items()}
        if read != labelled:
            yield f"{run}: Praat reads {read}, ELAN's file has {labelled}"
    if (node_modules / "webvtt-parser").is_dir():
        read = json.loads(output_of("node", "-e", VTT_SCRIPT, vtt, env={**os.environ, "NODE_PATH": str(node_modules)}))
        if read["errors"] or read["cues"] != srt.read_text().count(" --> "):
            yield f"{run}: {read}"


def rows(trace):
    return [json.loads(line) for line in trace.read_text(encoding="utf-8").splitlines()]


def check_recording(program, log, folder):
    """The faults of one recording that goes through ELAN's file and back."""
    before, eaf, after = folder / "before.trace.jsonl", folder / "x.eaf", folder / "after.trace.jsonl"
    output_of(program, "import", log, "-o", before)
    output_of(program, "export", before, "--to", "eaf", "-o", eaf)
    check_schema(eaf)
    output_of(program, "import", eaf, "-o", after)
    first, second = rows(before), rows(after)
    if len(first) != len(second):
        yield f"{log.name}: {len(first) - 1} events become {len(second) - 1}"
    for one, other in zip(first, second):
        if abs(one.get("t", 0) - other.get("t", 0)) > 0.001 or {**one, "t": 0} != {**other, "t": 0}:
            yield f"{log.name}: {one} becomes {other}"
            return


def main():
    program, source, node_modules = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])
    if not shutil.which("xmllint"):
        print("xmllint (libxml2-utils) is missing: skipped")
        return 77
    for name, there in (("praat", shutil.which("praat")), ("webvtt-parser", (node_modules / "webvtt-parser").is_dir())):
        if not there:
            print(f"{name} is missing: not asked")
    if not SCHEMA:
        print("CONTINUA_EAF_SCHEMA names no file: ELAN's schema is not asked")
    faults = []
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        runs = [source / "traces" / f"{name}.run.jsonl" for name in ("building_blocks", "talk/speech_only", "paper/one_breath")]
        runs += [*sorted((source / "traces/corner").glob("*.run.jsonl")), *sorted((source / "traces/corner").glob("*.trace.jsonl"))]
        runs = [run for run in runs if run.exists()]
        for run in runs:
            faults += check_run(program, run, folder, node_modules)
        logs = sorted((source.parent / "shared/data/pilot2018").glob("*.txt"))
        for log in logs:
            faults += check_recording(program, log, folder)
    for fault in faults:
        print(fault)
    print(f"{len(runs)} runs and traces exported, {len(logs)} recordings through ELAN's file and back, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
