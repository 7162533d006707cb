"""Replays, reasons, stacks, differences, pages: the same from Python as from the program."""
import json
import re
import signal
import subprocess
import urllib.request
from concurrent.futures import ThreadPoolExecutor

import pytest

import continua
from conftest import BUILD


@pytest.fixture(scope="module")
def run(talk):
    return continua.read(talk)


@pytest.fixture(scope="module")
def server(talk):
    """The inspector's address of the run."""
    served = subprocess.Popen([BUILD / "continua", "serve", str(talk), "--port", "0"], stdout=subprocess.PIPE, text=True)
    base = re.search(r"http://[\d.:]+", served.stdout.readline())[0]
    with urllib.request.urlopen(f"{base}/api/runs") as answer:
        yield f"{base}/api/runs/{json.load(answer)['runs'][0]['id']}"
    served.terminate()
    served.wait()
    served.stdout.close()


@pytest.mark.parametrize("physics", [False, True])
def test_a_replay_writes_the_same_bytes(program, root, tmp_path, physics):
    trace = root / "traces/paper/correction.trace.jsonl"
    ours, theirs = tmp_path / "ours.run.jsonl", tmp_path / "theirs.run.jsonl"
    run = continua.replay(trace, physics=physics, output=ours)
    program("replay", trace, "-o", theirs, *([] if physics else ["--no-physics"]))
    assert ours.read_bytes() == theirs.read_bytes()
    assert run.header["world"] == ("physics" if physics else "kinematic") and run.unmet == []


def test_a_replay_without_output_lives_as_long_as_its_run(root):
    run = continua.replay(root / "traces/paper/correction.trace.jsonl", physics=False)
    folder = run.path.parent
    assert folder.exists() and len(run) > 10
    del run
    assert not folder.exists()


def test_a_trace_of_dictionaries():
    trace = [{"kind": "trace", "version": 1, "scene": "staircase", "machine": "diana2018"},
             {"t": 1, "kind": "gesture", "name": "engage", "phase": "start"},
             {"t": 2, "kind": "expect", "state": "Nowhere"}]
    run = continua.replay(trace, physics=False, name="hello")
    assert run.header["trace"]["name"] == "hello.trace.jsonl" and run.path.name == "hello.run.jsonl"
    assert [record["text"] for record in run.of_kind("utterance")] == ["Hello."]
    assert [record["found"] for record in run.unmet] == [{"state": "Wait"}]


@pytest.mark.parametrize("line", [{"t": {1}}, "speech", 7])
def test_a_trace_of_other_things(line):
    with pytest.raises(continua.Error, match=r"replayed\.trace\.jsonl: found a line that is no object of JSON"):
        continua.replay([{"kind": "trace", "version": 1}, line])


def test_changes_in_mid_run(program, root, tmp_path):
    trace, path = root / "traces/talk/speech_only.trace.jsonl", tmp_path / "what_if.run.jsonl"
    program("replay", trace, "--no-physics", "--from", "5", "--seed", "9", "-o", path)
    run = continua.replay(trace, physics=False, change_at=5, seed=9)
    assert list(run.records) == list(continua.read(path).records) and run.header["what_if"]["from"] == 5


def test_a_forced_transition_that_does_not_apply_is_told(root):
    trace = root / "traces/talk/speech_only.trace.jsonl"
    run = continua.replay(trace, physics=False)
    last = run.of_kind("transition")[-1]
    with pytest.warns(UserWarning, match="forced .* at step 1: that transition does not apply there"):
        continua.replay(trace, physics=False, forced={1: last["id"]})


@pytest.mark.parametrize("options,sentence", [
    ({"scene": "nowhere"}, "scene: there is no scene 'nowhere'"),
    ({"machine": "nobody"}, "there is no machine 'nobody'"),
    ({"choice": "maybe"}, "choice: found 'maybe'; expected likeliest"),
    ({"output": "/nowhere/x.run.jsonl"}, "/nowhere/x.run.jsonl"),
])
def test_what_cannot_be_replayed_is_told(root, options, sentence):
    with pytest.raises(continua.Error, match=re.escape(sentence)):
        continua.replay(root / "traces/talk/speech_only.trace.jsonl", physics=False, **options)


def test_why_is_the_answer_of_explain(program, run):
    for n in range(0, len(run), 9):
        why = run.why(n)
        assert why == program.json("explain", run.path, "--record", n, "--json")
        assert str(why) == program("explain", run.path, "--record", n).rstrip("\n")
    for ours, theirs in [({"at": 12.5}, ("--at", 12.5)), ({"act": 1}, ("--act", 1)), ({"step": 3}, ("--step", 3))]:
        assert str(run.why(**ours)) == program("explain", run.path, *theirs).rstrip("\n")
    assert run.why(act=1).tree == program("explain", run.path, "--act", 1, "--tree").rstrip("\n")
    assert run.why(-1)["n"] == len(run) - 1


@pytest.mark.parametrize("question,sentence", [({"act": 99}, "there is no act 99"), ({"step": 0}, "there is no step 0")])
def test_why_of_nothing(run, question, sentence):
    with pytest.raises(continua.Error, match=sentence):
        run.why(**question)
    with pytest.raises(IndexError):
        run.why(len(run))


def test_the_stack_is_the_inspectors(run, server):
    for n in range(0, len(run), 7):
        with urllib.request.urlopen(f"{server}/stack?n={n}") as answer:
            assert run.stack_at(n) == json.load(answer)
    with pytest.raises(IndexError):
        run.stack_at(len(run))


def test_diff_is_the_answer_of_diff(program, root, run, tmp_path):
    other = continua.replay(root / "traces/talk/speech_only.trace.jsonl", physics=False, machine="diana2018")
    diff = continua.diff(run, other)
    assert not diff.same and diff == program.json("diff", run.path, other.path, "--json", status=1)
    assert str(diff) == program("diff", run.path, other.path, status=1).rstrip("\n")
    assert diff.markdown == program("diff", run.path, other.path, "--markdown", status=1)
    again = continua.replay(root / "traces/talk/speech_only.trace.jsonl", physics=False)
    assert continua.diff(run, again.path).same


def test_the_page_and_the_log_are_those_of_export(program, root, tmp_path):
    path = root / "traces/paper/correction.physics.run.jsonl"
    run = continua.read(path)
    assert run.page() == program("export", path, "--to", "html")
    assert run._repr_html_().startswith("<iframe ")
    run.save(tmp_path / "whole.run.jsonl")
    assert (tmp_path / "whole.run.jsonl").read_text() == program("export", path, "--to", "jsonl")


def test_pictures(run):
    try:
        picture = run.picture(12.5, size="320x180")
    except continua.Error as problem:
        pytest.skip(str(problem))
    assert picture._repr_png_().startswith(b"\x89PNG") and run.picture(12.5, size="320x180") == picture
    for wrong in ({"at": -1}, {"at": 1e6}, {"at": 1, "camera": "nowhere"}, {"at": 1, "size": "0x0"}, {"at": 1, "size": "large"}):
        with pytest.raises(continua.Error):
            run.picture(**wrong)


def test_a_document_that_is_not_what_its_name_says(root, tmp_path):
    source = root / "traces/paper/correction.physics.run.jsonl"
    (tmp_path / "one.run.jsonl").write_bytes(source.read_bytes())
    (tmp_path / "documents").mkdir()
    for file in (root / "traces/documents").iterdir():
        (tmp_path / "documents" / file.name).write_text("{}")
    with pytest.raises(continua.Error, match="is not the document that it was"):
        continua.read(tmp_path / "one.run.jsonl")


def test_an_interrupt_ends_a_replay(root, tmp_path):
    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    path = tmp_path / "interrupted.run.jsonl"
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with pytest.raises(KeyboardInterrupt):
            for _ in range(100):
                continua.replay(root / "traces/building_blocks.trace.jsonl", output=path)
                path.unlink()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert not path.exists()


def test_replays_in_several_threads(root, talk):
    def replay(_):
        run = continua.replay(root / "traces/talk/speech_only.trace.jsonl", physics=False)
        return run.path.read_bytes(), run.why(act=1)["headline"]

    with ThreadPoolExecutor(3) as threads:
        answers = list(threads.map(replay, range(6)))
    assert all(answer == answers[0] for answer in answers) and answers[0][0] == talk.read_bytes()
