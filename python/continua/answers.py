"""Answers about runs: dictionaries that print as the program's text."""
from __future__ import annotations

import json
from typing import Any


class Answer(dict[str, Any]):
    """The members of an answer as the program prints them in JSON, and its text when it is printed."""

    def __init__(self, document: str, text: str) -> None:
        super().__init__(json.loads(document))
        self._text = text

    def __str__(self) -> str:
        return self._text.rstrip("\n")

    def _repr_html_(self) -> str:
        return preformatted(str(self))


class Why(Answer):
    """Why a record: the members that `continua explain --json` prints, and its text when it is printed."""

    def __init__(self, document: str, text: str, tree: str) -> None:
        super().__init__(document, text)
        self.tree = tree.rstrip("\n")
        """The term behind the record as a tree, with the words its leaves came from; empty where there is none."""

    def __repr__(self) -> str:
        return f"<continua.Why: {self['headline']}>"


class Diff(Answer):
    """Where two runs part, and why: the members that `continua diff --json` prints, and its text when it is printed."""

    def __init__(self, document: str, text: str, markdown: str) -> None:
        super().__init__(document, text)
        self.markdown = markdown
        """The same for a pull request, with the details folded."""

    @property
    def same(self) -> bool:
        """Whether nothing that happened differs."""
        return bool(self["same"])

    def __repr__(self) -> str:
        return f"<continua.Diff: {self['sentence']}>"


class Picture(bytes):
    """A picture as the bytes of a PNG file, which notebooks show."""

    def __repr__(self) -> str:
        return f"<continua.Picture: {len(self)} bytes of PNG>"

    def _repr_png_(self) -> bytes:
        return bytes(self)


def preformatted(text: str) -> str:
    """Text as notebooks show it, with its lines as they are."""
    import html

    return f"<pre>{html.escape(text)}</pre>"
