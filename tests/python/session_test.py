"""Sessions driven live from Python."""
import gc

import pytest

import continua


@pytest.fixture
def session():
    with continua.Session(scene="staircase", machine="diana2018", physics=False) as session:
        yield session


def said(moves):
    return [move["text"] for move in moves if move["kind"] == "utterance"]


def test_hears_and_moves(session):
    assert session.t == 0
    moves = session.hear({"kind": "gesture", "name": "engage", "phase": "start"})
    assert said(moves) == ["Hello."] and session.state == "Wait"
    assert session.hear({"kind": "mark", "text": "now"}) == []


def test_time_goes_on_when_it_is_told_to(session):
    session.advance(3)
    assert session.t == 3
    session.hear({"t": 5, "kind": "mark", "text": "later"})
    assert session.t == 5
    session.advance(4)
    assert session.t == 5


@pytest.mark.parametrize("physics", [False, True])
def test_replays_to_the_same_decisions(tmp_path, physics):
    session = continua.Session(scene="staircase", machine="interaction", physics=physics, folder=tmp_path, name="talk")
    session.hear("Take the red block.")
    session.advance(20)
    session.hear({"kind": "speech", "text": "Thank you."}, {"kind": "mark", "text": "polite"})
    run = session.end()
    assert run.complete and run.path == tmp_path / "talk.run.jsonl" and run.kinds["act"] > 1
    again = continua.replay(session.trace, physics=physics)
    assert again.records[-1]["decisions"] == run.records[-1]["decisions"]
    assert session.end().complete


def test_the_run_so_far(session):
    session.hear({"kind": "gesture", "name": "engage", "phase": "start"})
    run = session.run
    assert not run.complete and run.kinds["utterance"] == 1
    assert "Hello" in str(run.why(run.of_kind("utterance")[0]["n"]))


@pytest.mark.parametrize("event,sentence", [
    ({"kind": "speach", "text": "x"}, "unknown kind 'speach'"),
    ({"kind": "speech"}, "speech"),
    ({"kind": "mark", "text": "x", "t": 1e6}, "ahead of the session's time"),
    ({"kind": "mark", "text": {1, 2}}, "no JSON"),
])
def test_an_event_that_cannot_be_used(session, event, sentence):
    with pytest.raises(continua.Error, match=sentence):
        session.hear({"kind": "mark", "text": "fine"}, event)
    assert "mark" not in session.run.kinds


def test_after_the_end(session):
    session.end()
    with pytest.raises(continua.Error, match="the session has ended"):
        session.hear("hello")


@pytest.mark.parametrize("options,sentence", [({"scene": "nowhere"}, "nowhere"), ({"seed": -1}, "seed"),
                                              ({"name": "../x"}, "name"), ({"knowledge": "/nowhere"}, "/nowhere")])
def test_what_cannot_be_begun(options, sentence):
    with pytest.raises(continua.Error, match=sentence):
        continua.Session(**options)


def test_several_at_a_time_and_none_left_behind():
    sessions = [continua.Session(scene="staircase", physics=False) for _ in range(12)]
    folders = [session.trace.parent for session in sessions]
    assert len(set(folders)) == 12
    for number, session in enumerate(sessions):
        session.advance(number)
    assert [session.t for session in sessions] == list(range(12))
    del sessions, session
    gc.collect()
    assert not any(folder.exists() for folder in folders)
