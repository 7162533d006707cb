#!/usr/bin/env python3
"""Recognisers' outputs as they come, through `continua listen` into `continua record`.

listen_test.py PROGRAM
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

VOSK = """{"partial" : ""}
{"partial" : "take"}
{"partial" : "take"}
{
  "result" : [{ "conf" : 1.0, "end" : 0.3, "start" : 0.1, "word" : "take" },
              { "conf" : 1.0, "end" : 0.4, "start" : 0.3, "word" : "the" },
              { "conf" : 1.0, "end" : 0.8, "start" : 0.4, "word" : "plate" }],
  "text" : "take the plate"
}
"""
PIPE = subprocess.PIPE
problems = []


def expect(what, found, expected):
    if found != expected:
        problems.append(f"{what}: found {found}; expected {expected}")


def heard(program, output, *options):
    """The events of an output, the exit status and the number of messages."""
    done = subprocess.run([program, "listen", *options], input=output, capture_output=True, text=True, timeout=60)
    return [json.loads(line) for line in done.stdout.splitlines()], done.returncode, len(done.stderr.splitlines())


def test_events_are_written_at_once(program):
    listening = subprocess.Popen([program, "listen", "--from", "vosk"], stdin=PIPE, stdout=PIPE, text=True)
    expect("the clock", json.loads(listening.stdout.readline()), {"kind": "clock", "t": 0})
    listening.stdin.write(VOSK)
    listening.stdin.flush()
    lines = [json.loads(listening.stdout.readline()) for _ in range(2)]
    expect("words that may change", lines[0], {"kind": "speech", "text": "take", "final": False})
    expect("words", (lines[1]["text"], lines[1]["t"], lines[1]["until"]), ("take the plate", 0.1, 0.8))
    listening.stdin.close()
    expect("status", listening.wait(60), 0)


def test_what_is_broken_is_told_and_passed_over(program):
    events, status, messages = heard(program, 'noise\n{"text": "cut\n{"a": 1}\n{"text": "yes"}\n', "--from", "vosk")
    expect("broken parts", (events[1:], status, messages), ([{"kind": "speech", "text": "yes"}], 1, 3))


def test_times_of_a_calendar_count_from_the_first_event(program):
    message = '{"header": {"header": {"stamp": {"sec": %d, "nanosec": 0}}, "id": "a"}, "gesture": 6}\n'
    events, status, _ = heard(program, message % 1700000000 + message % 1700000002, "--from", "ros4hri")
    expect("a calendar", ([event["t"] for event in events], status), ([0, 0.0, 2.0], 0))
    events, _, _ = heard(program, message % 1700000000, "--from", "ros4hri", "--now")
    expect("now", events, [{"kind": "gesture", "name": "waving"}])


def test_pocketsphinx_without_times_is_heard_at_once(program):
    listening = subprocess.Popen([program, "listen", "--from", "pocketsphinx", "--now"], stdin=PIPE, stdout=PIPE, text=True)
    listening.stdin.write("INFO: continuous.c(252): Ready....\ntake the plate\n")
    listening.stdin.flush()
    expect("a line", json.loads(listening.stdout.readline()), {"kind": "speech", "text": "take the plate"})
    listening.stdin.close()
    listening.wait(60)


def test_a_session_hears_a_recogniser(program, folder):
    trace = folder / "talk.trace.jsonl"
    begun = time.monotonic()
    listening = subprocess.Popen([program, "listen", "--from", "vosk"], stdin=PIPE, stdout=PIPE, text=True)
    recording = subprocess.Popen(
        [program, "record", "--clock", "wall", "--no-physics", "--scene", "place_setting", "-o", trace],
        stdin=listening.stdout, stdout=PIPE, stderr=PIPE, text=True)
    listening.stdout.close()
    listening.stdin.write(json.dumps({"partial": "take"}) + "\n")
    listening.stdin.flush()
    while not trace.exists() or "take" not in trace.read_text():  # it is loaded some seconds after the recogniser began
        time.sleep(0.05)
    said_at = max(round(time.monotonic() - begun - 0.5, 3), 0)
    words = [{"word": word, "start": said_at, "end": said_at, "conf": 1} for word in ("take", "the", "plate")]
    listening.stdin.write(json.dumps({"text": "take the plate", "result": words}))
    listening.stdin.close()
    deeds, told = recording.communicate(timeout=60)
    listening.wait(60)
    expect("status of record", (recording.returncode, told.count("\n")), (0, 2))
    said = [json.loads(line) for line in trace.read_text().splitlines()][2]
    expect("when it was said", (said["text"], said.get("happened", said["t"])), ("take the plate", said_at))
    acts = [deed for deed in map(json.loads, deeds.splitlines()) if deed["kind"] == "act" and deed["status"] == "done"]
    expect("the act", {act["program"] for act in acts}, {"grasp(plate)"})


def main():
    program = os.path.abspath(sys.argv[1])
    test_events_are_written_at_once(program)
    test_what_is_broken_is_told_and_passed_over(program)
    test_times_of_a_calendar_count_from_the_first_event(program)
    test_pocketsphinx_without_times_is_heard_at_once(program)
    with tempfile.TemporaryDirectory() as made:
        test_a_session_hears_a_recogniser(program, pathlib.Path(made))
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
