"""Reads run logs (replay/log/RUNLOG.md). Python alone: nothing here needs the built module."""
from __future__ import annotations

import gzip
import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Union, overload

from .errors import Error

Record = dict[str, Any]
"""A record of a run log: its members by their names (replay/log/RECORDS.md)."""

StrPath = Union[str, "os.PathLike[str]"]

# The members of the first line that may be kept in a file of their own; `what_if` has them as the line has.
_KEPT = (("machine", "document"), ("phrases", "document"), ("knowledge",), ("graph",), ("scene", "mjcf"),
         ("scene", "geoms"), ("scene", "bodies"))
_DIGITS = 32
_GZIP = b"\x1f\x8b"


class Records(Sequence[Record]):
    """The records of a log, each parsed when it is asked for. A record stands at the index that is its `n`."""

    def __init__(self, path: StrPath) -> None:
        self.path = Path(path)
        self._lines = _whole_lines(self.path)
        self._header = _header(self.path, self._parsed(0))

    def __len__(self) -> int:
        return len(self._lines)

    @overload
    def __getitem__(self, n: int) -> Record: ...
    @overload
    def __getitem__(self, n: slice) -> list[Record]: ...
    def __getitem__(self, n: int | slice) -> Record | list[Record]:
        if isinstance(n, slice):
            return [self[i] for i in range(*n.indices(len(self)))]
        if not -len(self) <= n < len(self):
            raise IndexError(f"{self.path}: found record {n}; expected 0 to {len(self) - 1}")
        n %= len(self)
        return self._parsed(n) if n else dict(self._header)

    def __iter__(self) -> Iterator[Record]:
        return (self[n] for n in range(len(self)))

    def _parsed(self, n: int) -> Record:
        try:
            record = json.loads(self._lines[n])
        except ValueError as problem:
            raise Error(f"{self.path}:{n + 1}: is no JSON ({problem}); expected a record") from None
        if not isinstance(record, dict):
            raise Error(f"{self.path}:{n + 1}: found {type(record).__name__}; expected a record, an object")
        return record


def _whole_lines(path: Path) -> list[bytes]:
    try:
        content = path.read_bytes()
        if content.startswith(_GZIP):
            content = gzip.decompress(content)
    except (OSError, EOFError) as problem:
        raise Error(f"{path}: cannot be read ({problem}); expected a run log") from None
    lines = content.split(b"\n")
    lines.pop()  # after the last line's end: nothing, or a line that was cut short
    if not lines:
        raise Error(f"{path}: found no whole line; expected a run log")
    return lines


def _header(path: Path, record: Record) -> Record:
    if record.get("kind") != "run":
        raise Error(f"{path}:1: found kind {record.get('kind')!r}; expected 'run', the first line of a run log")
    if record.get("version") != 1:
        raise Error(f"{path}:1: found version {record.get('version')!r}; expected 1")
    for part in (record, record.get("what_if")):
        if isinstance(part, dict):
            _bring_documents(path, part)
    return record


def _bring_documents(path: Path, header: Record) -> None:
    for *outer, member in _KEPT:
        holder = header.get(outer[0]) if outer else header
        if not isinstance(holder, dict):
            continue
        value = holder.get(member)
        if isinstance(value, dict) and list(value) == ["kept"] and isinstance(value["kept"], str):
            holder[member] = _document(path, ".".join((*outer, member)), value["kept"])


def _document(path: Path, place: str, digest: str) -> Any:
    if len(digest) != _DIGITS or set(digest) - set("0123456789abcdef"):
        raise Error(f"{path}:1: `{place}` is kept as {digest!r}; expected a digest of {_DIGITS} digits 0-9 and a-f")
    name = f"documents/{digest}.json"
    for folder in path.resolve().parents:
        file = folder / name
        if file.is_file():
            text = file.read_bytes()
            _check_digest(file, text)
            return json.loads(text)
    raise Error(f"{path}:1: `{place}` is kept in a file of its own, and there is no {name} in {path.resolve().parent} "
                "or in a folder above it; expected the folder documents that was written along with the run")


def _check_digest(file: Path, text: bytes) -> None:
    """The digest is XXH3, which Python lacks: it is checked where the built module is."""
    try:
        from . import _engine
    except ImportError:
        return
    found = _engine.digest(text)
    if found != file.stem:
        raise Error(f"{file}: is not the document that it was: its digest is {found}, its name says {file.stem}; "
                    "expected the file that was written along with the run")
