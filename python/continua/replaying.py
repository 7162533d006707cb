"""Replays of traces, and comparisons of runs."""
from __future__ import annotations

import json
import os
import tempfile
import warnings
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, Union

from ._built import engine
from .answers import Diff
from .errors import Error
from .log import StrPath
from .run import Run

Trace = Union[StrPath, Iterable[Mapping[str, Any]]]
"""A file, or its lines as dictionaries: the header and the events."""


def replay(trace: Trace, physics: bool = True, *, output: StrPath | None = None, name: str = "replayed",
           scene: str | None = None, machine: str | None = None, language: str | None = None,
           knowledge: StrPath | None = None, seed: int | None = None, choice: str | None = None,
           weights: StrPath | None = None, learned: StrPath | None = None, forced: Mapping[int, str] | None = None,
           change_at: float | None = None, changed: Trace | None = None) -> Run:
    """Replays a trace, and gives the run: the same trace gives the same bytes.

    trace: a file, or its lines as dictionaries.
    physics: else the kinematic world, in which acts succeed at once.
    output: the file of the run log; else it is gone with the run.
    name: of a trace that is given as dictionaries.
    scene, machine, language, knowledge, seed, choice, weights, learned: as the options of `continua replay`; what is
        left out is as the trace has it.
    forced: {step: id of the transition to take there}.
    change_at: seconds. What if? machine, language, knowledge, choice, seed, forced and `changed` count from then on.
    changed: with `change_at`, the trace whose events happen from then on.

    Raises `Error` where the trace, its scene or its machine cannot be used.
    """
    keep = tempfile.TemporaryDirectory(prefix="continua-")
    trace = _file_of(trace, Path(keep.name) / f"{name}.trace.jsonl")
    path = Path(output) if output else Path(keep.name) / (trace.name.split(".")[0] + ".run.jsonl")
    options = {"scene": scene, "machine": machine, "language": language, "knowledge": knowledge, "seed": seed,
               "choice": choice, "weights": weights, "learned": learned, "from": change_at,
               "with": changed and _file_of(changed, Path(keep.name) / "changed.trace.jsonl")}
    options = {key: str(value) if isinstance(value, Path) else value for key, value in options.items()}
    for warning in engine().replay(str(trace), str(path), physics,
                                   {key: value for key, value in options.items() if value is not None}, forced or {}):
        warnings.warn(warning, stacklevel=2)
    return Run(path, _keep=None if output else keep)


def read(path: StrPath) -> Run:
    """The run of a log that is there. Needs Python alone."""
    return Run(path)


def diff(a: Run | StrPath, b: Run | StrPath, *, tolerance: float = 0.001, most: int = 10) -> Diff:
    """Where two runs part, and why: the answer of `continua diff`.

    tolerance: metres that a body may be elsewhere where all else is the same. most: differences that the text shows
    besides the first.
    """
    a, b = (one if isinstance(one, Run) else Run(one) for one in (a, b))
    return Diff(*engine().diff(a._log, b._log, tolerance, most))


def _file_of(trace: Trace, path: Path) -> Path:
    if isinstance(trace, (str, os.PathLike)):
        return Path(trace)
    try:
        text = "".join(json.dumps(dict(line)) + "\n" for line in trace)
    except (TypeError, ValueError) as problem:
        raise Error(f"{path.name}: found a line that is no object of JSON ({problem}); expected a trace's") from None
    path.write_text(text, encoding="utf-8")
    return path
