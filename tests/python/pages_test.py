"""The pages about the package: docs/python.md prints what stands there, the notebook runs."""
import doctest
import html
import json
import os
import re
import traceback

import pytest

import continua


class Examples(doctest.DocTestRunner):
    """Runs the examples of a page, and keeps those that print something else than the page says."""

    def __init__(self):
        super().__init__(verbose=False, optionflags=doctest.ELLIPSIS)
        self.others = []

    def report_failure(self, out, test, example, got):
        self.others.append((example, got))

    def report_unexpected_exception(self, out, test, example, exc_info):
        self.others.append((example, "Traceback (most recent call last):\n    ...\n"
                            f"{traceback.format_exception_only(*exc_info[:2])[-1]}"))


def test_the_tour_prints_what_it_says(root, monkeypatch):
    """With CONTINUA_RENEW_PAGES=1 the page gets the output that is printed now."""
    pytest.importorskip("continua._engine")
    pytest.importorskip("pandas")
    monkeypatch.chdir(root)
    page = root / "docs/python.md"
    lines = page.read_text().splitlines()
    # Other lines become empty, so that examples have their lines of the page.
    shown, inside = [], False
    for line in lines:
        inside = inside and line != "```"
        shown.append(line if inside else "")
        inside = inside or line == "```pycon"
    test = doctest.DocTestParser().get_doctest("\n".join(shown) + "\n", {"continua": continua}, page.name, str(page), 0)
    assert len(test.examples) > 10
    examples = Examples()
    examples.run(test)
    if os.environ.get("CONTINUA_RENEW_PAGES"):
        for example, got in reversed(examples.others):
            first = example.lineno + example.source.count("\n")
            lines[first:first + example.want.count("\n")] = got.splitlines()
        page.write_text("\n".join(lines) + "\n")
    else:
        assert not examples.others, "\n".join(f"{page}:{example.lineno + 1}: {example.source}{got}"
                                              for example, got in examples.others)


def test_the_kept_pilot_notebook_shows_three_figures(root):
    kept = (root / "docs/notebook/pilot.html").read_text()
    assert re.findall(r'<svg[^>]*aria-label="([^"]*)"', kept) == [
        "The inputs refused most often", "Seconds from the end of an act to the asking of the next",
        "Questions for each act, by session"]
    assert not re.search(r"/(home|root|tmp|work)/", kept), "paths of the machine that it was made on"


def test_the_notebook_runs(root, monkeypatch):
    pytest.importorskip("continua._engine")
    pytest.importorskip("pandas")
    monkeypatch.chdir(root)
    cells = json.loads((root / "docs/notebook/tour.ipynb").read_text())["cells"]
    names = {}
    for cell in cells:
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), "tour.ipynb", "exec"), names)
    assert cells


@pytest.mark.parametrize("name", ["tour", "pilot"])
def test_the_kept_notebook_is_of_the_same_cells(root, name):
    kept = (root / f"docs/notebook/{name}.html").read_text()
    shown = html.unescape(re.sub(r"<[^>]+>", "", kept))
    assert len(kept.encode()) < 200_000
    for cell in json.loads((root / f"docs/notebook/{name}.ipynb").read_text())["cells"]:
        if cell["cell_type"] == "code":
            for line in "".join(cell["source"]).splitlines():
                assert line in shown, line
