"""A session that is driven live, event by event."""
from __future__ import annotations

import json
import tempfile
import warnings
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any

from ._built import engine
from .errors import Error
from .log import Record, StrPath
from .run import Run

if TYPE_CHECKING:
    from . import _engine


class Session:
    """A conversation with the avatar that happens now. Time goes on only when it is told to.

        session = continua.Session(scene="staircase", physics=False)
        moves = session.hear({"kind": "speech", "text": "Take the red block."})
        moves += session.advance(5)
        run = session.end()

    Along the way a trace and a run log are written, which replay to the same decisions.
    """

    def __init__(self, scene: str | None = None, machine: str | None = None, *, physics: bool = True,
                 seed: int | None = None, language: str | None = None, perspective: str | None = None,
                 objects: dict[str, Any] | None = None, knowledge: StrPath | None = None,
                 folder: StrPath | None = None, name: str = "session") -> None:
        """Names or files as in a trace's header; what is left out is as `continua record` has it.

        `folder`: where NAME.trace.jsonl and NAME.run.jsonl go; else they are gone with the session and its runs.
        """
        self._keep = None
        if folder is None:
            self._keep = tempfile.TemporaryDirectory(prefix="continua-")
            folder = self._keep.name
        asked = {"scene": scene, "machine": machine, "seed": seed, "language": language, "perspective": perspective,
                 "objects": objects, "name": name}
        told = json.dumps({key: value for key, value in asked.items() if value is not None})
        self._live: _engine.Live = engine().Live(told, str(folder), physics, str(knowledge or ""))
        if self._live.warning:
            warnings.warn(self._live.warning, stacklevel=2)

    def hear(self, event: dict[str, Any] | str, *more: dict[str, Any] | str) -> list[Record]:
        """Tells the avatar events, or words alone, and gives its moves since: records of the log.

        An event is as in a trace (traces/FORMAT.md). One without `t` happens now; one with a later `t` lets time go on
        to then. If one of them cannot be used, none is taken.
        """
        events = [{"kind": "speech", "text": each} if isinstance(each, str) else each for each in (event, *more)]
        return self._told(events)

    def advance(self, t: float) -> list[Record]:
        """Lets time go on to the instant `t`, seconds since the session began, and gives the avatar's moves since."""
        return self._told([{"kind": "clock", "t": t}])

    @property
    def t(self) -> float:
        """The session's time, seconds."""
        return self._live.t

    @property
    def state(self) -> str:
        """The name of the state that the machine is in."""
        return self._live.state

    @property
    def trace(self) -> Path:
        """The trace of all that was told, as it stands in its file."""
        return Path(self._live.trace_path)

    @property
    def run(self) -> Run:
        """The run so far."""
        return Run(self._live.log_path, _keep=self._keep)

    def end(self) -> Run:
        """Nothing more happens: acts under way are finished. Gives the whole run. Ending again does nothing."""
        self._live.end()
        return self.run

    def __enter__(self) -> Session:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None,
                 traceback: TracebackType | None) -> None:
        self._live.end()

    def __repr__(self) -> str:
        return f"<continua.Session at {self.t:g} s in state {self.state}>"

    def _repr_html_(self) -> str:
        return self.run._repr_html_()

    def _told(self, events: list[dict[str, Any]]) -> list[Record]:
        try:
            told = json.dumps(events)
        except (TypeError, ValueError) as problem:
            raise Error(f"found an event that is no JSON ({problem}); expected one as in a trace") from None
        return [json.loads(line) for line in self._live.hear(told)]
