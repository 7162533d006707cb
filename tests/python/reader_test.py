"""Run logs are read by Python alone."""
import gzip
import json

import pytest

import continua


def whole(program, path):
    return program("export", path, "--to", "jsonl").splitlines()


@pytest.mark.parametrize("name", ["building_blocks", "paper/correction.physics", "talk/speech_only"])
def test_records_are_the_lines_of_the_whole_log(program, root, name):
    path = root / f"traces/{name}.run.jsonl"
    run = continua.read(path)
    assert list(run.records) == [json.loads(line) for line in whole(program, path)]
    assert [record["n"] for record in run.records] == list(range(len(run)))
    assert run.complete and run.header["machine"]["document"]["machine"] == 1


def test_places_kinds_and_slices(talk):
    run = continua.read(talk)
    end = run.records[-1]
    assert run[len(run) - 1] == end and end["kind"] == "end"
    assert {kind: run.kinds[kind] for kind in end["counts"]} == end["counts"]
    assert [record["kind"] for record in run.of_kind("utterance", "act")].count("utterance") == run.kinds["utterance"]
    assert run.records[3:5] == [run[3], run[4]]
    assert run.unmet == [record for record in run.of_kind("expect") if not record["met"]]
    with pytest.raises(IndexError, match=f"found record {len(run)}; expected 0 to {len(run) - 1}"):
        run[len(run)]


def test_a_record_can_be_changed_without_harm(talk):
    run = continua.read(talk)
    run.header["trace"] = None
    assert run.header["trace"]["name"] == "speech_only.trace.jsonl"


@pytest.mark.parametrize("write", [gzip.compress, lambda text: b"\xef\xbb\xbf" + text])
def test_other_forms_of_the_file(talk, tmp_path, write):
    path = tmp_path / "other.run.jsonl"
    path.write_bytes(write(talk.read_bytes()))
    assert list(continua.read(path).records) == list(continua.read(talk).records)


def test_a_log_cut_short_is_read_to_its_last_whole_line(talk, tmp_path):
    path = tmp_path / "cut.run.jsonl"
    path.write_bytes(talk.read_bytes()[:-40])
    run, all_of_it = continua.read(path), continua.read(talk)
    assert len(run) == len(all_of_it) - 1 and not run.complete
    assert "cut short" in repr(run) and "cut short" not in repr(all_of_it)


def logs_that_cannot_be_read():
    header = {"kind": "run", "n": 0, "t": 0.0, "version": 1, "machine": {"name": "m"}}
    kept = {"kept": "0" * 32}
    yield "empty", [], "no whole line"
    yield "other", [{"kind": "trace", "version": 1}], r":1: found kind 'trace'; expected 'run'"
    yield "newer", [{**header, "version": 2}], ":1: found version 2; expected 1"
    yield "list", [[1]], ":1: found list; expected a record"
    yield "missing", [{**header, "graph": kept}], r":1: `graph` is kept .* there is no documents/0{32}\.json"
    yield "digest", [{**header, "scene": {"mjcf": {"kept": "x"}}}], r":1: `scene.mjcf` is kept as 'x'; expected a digest"
    yield "what_if", [{**header, "what_if": {"knowledge": kept}}], ":1: `knowledge` is kept"


@pytest.mark.parametrize("name,lines,sentence", logs_that_cannot_be_read())
def test_a_log_that_cannot_be_read(tmp_path, name, lines, sentence):
    path = tmp_path / f"{name}.run.jsonl"
    path.write_text("".join(json.dumps(line) + "\n" for line in lines))
    with pytest.raises(continua.Error, match=sentence) as told:
        continua.read(path)
    assert str(told.value).startswith(str(path))


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(continua.Error, match="cannot be read"):
        continua.read(tmp_path / "none.run.jsonl")


def test_a_broken_line_is_told_with_its_place(talk, tmp_path):
    path = tmp_path / "broken.run.jsonl"
    lines = talk.read_text().splitlines(keepends=True)
    path.write_text("".join([*lines[:4], "{\n", *lines[5:]]))
    run = continua.read(path)
    assert run[3]["n"] == 3
    with pytest.raises(continua.Error, match=r"broken\.run\.jsonl:5: is no JSON"):
        run[4]


def test_kept_means_a_file_nowhere_else(tmp_path):
    kept = {"kept": "0" * 32}
    header = {"kind": "run", "n": 0, "t": 0.0, "version": 1, "seed": kept, "machine": {"name": kept},
              "graph": {**kept, "states": []}}
    path = tmp_path / "kept.run.jsonl"
    path.write_text(json.dumps(header) + "\n" + json.dumps({"kind": "input", "n": 1, "event": kept}) + "\n")
    assert list(continua.read(path).records) == [header, {"kind": "input", "n": 1, "event": kept}]


def test_tables(talk):
    pandas = pytest.importorskip("pandas")
    run = continua.read(talk)
    said = run.to_pandas("utterance")
    assert list(said["text"]) == [record["text"] for record in run.of_kind("utterance")]
    assert list(said.index) == [record["n"] for record in run.of_kind("utterance")]
    expected = run.to_pandas("expect")
    assert set(expected["expected.says"].dropna()) <= {record["expected"].get("says") for record in run.of_kind("expect")}
    assert len(run.to_pandas()) == len(run)
    assert isinstance(run.to_pandas("no such kind"), pandas.DataFrame) and run.to_pandas("no such kind").empty


def test_without_the_built_module_the_rest_says_so(talk):
    try:
        from continua import _engine
    except ImportError:
        pass
    else:
        assert _engine.digest(b"") == "99aa06d3014798d86001c324468d497f"
        pytest.skip("it is built")
    for ask in (lambda: continua.replay("x"), lambda: continua.read(talk).why(3), continua.Session):
        with pytest.raises(continua.Error, match=r"needs the built module.*docs/python\.md"):
            ask()
