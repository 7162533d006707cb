"""Functions of the program, for the package around this module. JSON goes over as text."""
from collections.abc import Mapping
from typing import Any

class Log:
    """A run log held open."""

    def __init__(self, path: str) -> None: ...
    def stack(self, n: int) -> str:
        """The stack as it stood at record n, as JSON. n is below the number of records."""
    def explain(self, record: int | None, at: float | None, act: int | None, step: int | None) -> tuple[str, str, str]:
        """Why the record that is asked about: as JSON, as text, and the term behind it as a tree."""
    def page(self) -> str:
        """The inspector's page with this run in it, as HTML."""
    def picture(self, at_s: float, size: str, camera: str) -> bytes:
        """The run at an instant, as the bytes of a PNG file."""
    def save(self, path: str) -> None:
        """Writes the whole log."""

class Live:
    """A session whose time goes by its events."""

    def __init__(self, asked: str, folder: str, physics: bool, knowledge: str) -> None: ...
    def hear(self, events: str) -> list[str]:
        """Takes events, as JSON, and gives the avatar's moves since, each as JSON."""
    def end(self) -> None:
        """Nothing more happens."""
    @property
    def t(self) -> float:
        """Seconds."""
    @property
    def state(self) -> str:
        """The name of the machine's state."""
    @property
    def warning(self) -> str:
        """The unknown things of the scene; else empty."""
    @property
    def trace_path(self) -> str: ...
    @property
    def log_path(self) -> str: ...

def replay(trace: str, output: str, physics: bool, options: Mapping[str, Any], forced: Mapping[int, str]) -> list[str]:
    """Replays a trace into a run log. Gives the warnings."""

def diff(a: Log, b: Log, tolerance_m: float, most: int) -> tuple[str, str, str]:
    """Where two runs part, and why: as JSON, as text and as Markdown."""

def digest(bytes: bytes) -> str:
    """The digest that names documents of logs."""
