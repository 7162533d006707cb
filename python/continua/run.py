"""A run: its records, and the answers about it that the program gives too."""
from __future__ import annotations

import base64
import html
import json
from collections import Counter
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ._built import engine
from .answers import Picture, Why
from .log import Record, Records, StrPath

if TYPE_CHECKING:
    import pandas

    from . import _engine


class Run:
    """The run of a trace, by its log.

    Records, kinds and tables need Python alone; `stack_at`, `why`, the page and pictures need the built module.
    """

    def __init__(self, path: StrPath, *, _keep: object = None) -> None:
        """`path`: a run log. `_keep` stays alive as long as the run: the temporary folder of its log."""
        self.path = Path(path)
        self.records = Records(path)
        """All records, in order: `run.records[17]["kind"]`."""
        self._keep = _keep

    def __len__(self) -> int:
        return len(self.records)

    def __getitem__(self, n: int) -> Record:
        return self.records[n]

    @property
    def header(self) -> Record:
        """The first record: trace, machine, scene, world, seed."""
        return self.records[0]

    @property
    def complete(self) -> bool:
        """Whether the log has its last line; a log cut short, or of a session that goes on, has not."""
        return bool(self.records[-1]["kind"] == "end")

    @cached_property
    def kinds(self) -> dict[str, int]:
        """How many records there are of each kind."""
        return dict(Counter(record["kind"] for record in self.records))

    def of_kind(self, *kinds: str) -> list[Record]:
        """The records of these kinds, in order."""
        return [record for record in self.records if record["kind"] in kinds]

    @property
    def unmet(self) -> list[Record]:
        """The expectations of the trace that the run did not meet."""
        return [record for record in self.of_kind("expect") if not record["met"]]

    def to_pandas(self, kind: str | None = None) -> pandas.DataFrame:
        """A table of the records of a kind, or of all: a row a record, indexed by `n`.

        With a kind the members of objects are columns of their own, as in `expected.says`; else they stay as they are.
        """
        import pandas

        records = self.of_kind(kind) if kind else list(self.records)
        if not records:
            return pandas.DataFrame(columns=["kind", "t"], index=pandas.Index([], name="n"))
        return pandas.json_normalize(records, max_level=1 if kind else 0).set_index("n")

    def stack_at(self, n: int) -> dict[str, Any]:
        """The automaton's stack as it stood at record `n`, top first, and its last change.

        `symbols` [{`id`, `below`, `slots`, `change`, …}], `depth`, `depth_before`: what the inspector's stack panel shows.
        """
        stack: dict[str, Any] = json.loads(self._log.stack(self._number(n)))
        return stack

    def why(self, n: int | None = None, *, at: float | None = None, act: int | None = None,
            step: int | None = None) -> Why:
        """Why record `n`: the answer of `continua explain`. `print` shows its text, `.tree` the term behind it.

        Asked about in its place: the last that the avatar did until `at` seconds, the act or the transition of a number;
        without any, an unmet expectation, the first question or the last act.
        """
        if n is not None:
            n = self._number(n)
        return Why(*self._log.explain(record=n, at=at, act=act, step=step))

    def picture(self, at: float, *, size: str = "960x540", camera: str = "") -> Picture:
        """The scene at an instant, seconds, with the pointing, the words and the time: as `continua render --at`."""
        return Picture(self._log.picture(at, size, camera))

    def page(self) -> str:
        """The inspector's page with this run in it, as `continua export --to html` writes it."""
        return self._log.page()

    def save(self, path: StrPath) -> None:
        """Writes the whole log, with its documents in it."""
        self._log.save(str(path))

    def __repr__(self) -> str:
        trace, kinds = self.header["trace"]["name"], self.kinds
        counts = ", ".join(f"{kinds.get(kind, 0)} {kind}" for kind in ("input", "utterance", "transition"))
        end = "" if self.complete else ", cut short"
        return f"<continua.Run of {trace}: {counts} records, {self.records[-1]['t']:g} s{end}>"

    def _repr_html_(self) -> str:
        page = base64.b64encode(self.page().encode()).decode()
        return (f'<iframe title="{html.escape(repr(self))}" src="data:text/html;charset=utf-8;base64,{page}" '
                'style="width: 100%; height: 720px; border: 1px solid #8888" allow="fullscreen"></iframe>')

    @cached_property
    def _log(self) -> _engine.Log:
        log: _engine.Log = engine().Log(str(self.path))
        return log

    def _number(self, n: int) -> int:
        return int(self.records[n]["n"])

