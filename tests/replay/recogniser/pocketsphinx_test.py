#!/usr/bin/env python3
"""A voice speaks, a recogniser hears, and the avatar answers: espeak-ng, pocketsphinx and the program.

pocketsphinx_test.py PROGRAM
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

GRAMMAR = """#JSGF V1.0;
grammar table;
public <said> = where is the ( knife | plate ) | ( take | put ) the ( knife | cup | plate );
"""
SAID = "where is the knife"


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=120, check=True).stdout


def main():
    program = sys.argv[1]
    for tool in ("espeak-ng", "ffmpeg", "pocketsphinx_continuous"):
        if not shutil.which(tool):
            print(f"{tool} is missing: skipped")
            return 77
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        (folder / "g.jsgf").write_text(GRAMMAR)
        run("espeak-ng", "-v", "en-us", "-s", "130", "-w", folder / "a.wav", SAID)
        run("ffmpeg", "-loglevel", "error", "-i", folder / "a.wav", "-ar", "16000", "-ac", "1", folder / "b.wav")
        heard = run("pocketsphinx_continuous", "-infile", folder / "b.wav", "-jsgf", folder / "g.jsgf", "-time", "yes",
                    "-logfn", "/dev/null")
        (folder / "heard.txt").write_text(heard)
        run(program, "import", folder / "heard.txt", "--from", "pocketsphinx", "-o", folder / "x.trace.jsonl")
        events = [json.loads(line) for line in (folder / "x.trace.jsonl").read_text().splitlines()][1:]
        run(program, "replay", folder / "x.trace.jsonl", "--scene", "place_setting", "--machine", "interaction",
            "--no-physics", "-o", folder / "x.run.jsonl")
        records = [json.loads(line) for line in (folder / "x.run.jsonl").read_text().splitlines()]
    said = [record["text"] for record in records if record["kind"] == "utterance"]
    print(f"heard {events}, answered {said}")
    right = [event["text"] for event in events] == [SAID] and len(events[0]["words"]) == 4 and events[0]["until"] < 3
    return 0 if right and any("knife" in text for text in said) else 1


if __name__ == "__main__":
    sys.exit(main())
