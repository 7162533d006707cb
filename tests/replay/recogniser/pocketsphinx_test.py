#!/usr/bin/env python3
"""A voice speaks, a recogniser hears by the machine's grammar, and the avatar acts: espeak-ng, pocketsphinx, the program.

pocketsphinx_test.py PROGRAM
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

DICTIONARY = pathlib.Path("/usr/share/pocketsphinx/model/en-us/cmudict-en-us.dict")
# Examples of the lexicon. The synthetic voice is not always understood; which one is best was tried.
SAID = ["take the plate", "lift the knife", "grab the cup", "where is the knife", "put the knife on the plate",
        "put the cup on the plate"]
FEWEST_RIGHT = 4
VOICE = ["-v", "en-us+f3", "-s", "140"]
SCENE = ["--scene", "place_setting", "--machine", "interaction", "--no-physics"]


def run(*command, given=None):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, check=True,
                          input=given).stdout


def records(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def heard(folder, grammar, said):
    """The recogniser's output for a sentence."""
    run("espeak-ng", *VOICE, "-w", folder / "a.wav", said)
    run("ffmpeg", "-y", "-loglevel", "error", "-i", folder / "a.wav", "-ar", "16000", "-ac", "1", "-af", "apad=pad_dur=0.4",
        folder / "b.wav")
    return run("pocketsphinx_continuous", "-infile", folder / "b.wav", "-jsgf", grammar, "-time", "yes", "-logfn",
               "/dev/null")


def fault_of_import(program, folder, output):
    """Why a recorded output does not lead to the act; empty if it does."""
    (folder / "heard.txt").write_text(output)
    run(program, "import", folder / "heard.txt", "--from", "pocketsphinx", "-o", folder / "x.trace.jsonl")
    speech = records(folder / "x.trace.jsonl")[1]
    if len(speech["words"]) != 3 or not speech["t"] < speech["until"] < 3:
        return f"found {speech}; expected three words and their times"
    run(program, "replay", folder / "x.trace.jsonl", *SCENE, "-o", folder / "x.run.jsonl")
    acts = [one["program"] for one in records(folder / "x.run.jsonl") if one["kind"] == "act" and one["status"] == "done"]
    return "" if "grasp(plate)" in acts else f"the avatar did {acts}; expected grasp(plate)"


def fault_of_listen(program, folder, output):
    """The same as it comes."""
    events = run(program, "listen", "--from", "pocketsphinx", given=output)
    deeds = run(program, "record", *SCENE, "-o", folder / "y.trace.jsonl", given=events)
    return "" if '"program":"grasp(plate)"' in deeds else f"record told {deeds}; expected grasp(plate)"


def main():
    program = sys.argv[1]
    for tool in ("espeak-ng", "ffmpeg", "pocketsphinx_continuous"):
        if not shutil.which(tool):
            print(f"{tool} is missing: skipped")
            return 77
    if not DICTIONARY.exists():
        print(f"{DICTIONARY} is missing: skipped")
        return 77
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        grammar = folder / "said.jsgf"
        run(program, "machine", "interaction", "--jsgf", "--scene", "place_setting", "--dictionary", DICTIONARY, "-o", grammar)
        outputs = [heard(folder, grammar, said) for said in SAID]
        found = [output.split("\n")[0] for output in outputs]
        print("heard", found)
        right = sum(one == said for one, said in zip(found, SAID))
        faults = [] if right >= FEWEST_RIGHT else [f"{right} of {len(SAID)} were heard; expected {FEWEST_RIGHT}"]
        faults += [fault_of_import(program, folder, outputs[0]), fault_of_listen(program, folder, outputs[0])]
    for fault in filter(None, faults):
        print(fault, file=sys.stderr)
    return 1 if any(faults) else 0


if __name__ == "__main__":
    sys.exit(main())
