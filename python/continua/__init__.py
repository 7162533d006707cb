"""Continua from Python: replays conversations with an avatar, drives them live, and shows why it did what it did.

    run = continua.replay("traces/building_blocks.trace.jsonl", physics=False)
    run.to_pandas("utterance")["text"]
    print(run.why(act=1))

`read` and the records of a run need Python alone; all else needs the built module. docs/python.md has a tour.
"""
from .answers import Diff, Picture, Why
from .errors import Error
from .log import Record, Records
from .replaying import diff, read, replay
from .run import Run
from .session import Session

__version__ = "0.2.0"
__all__ = ["Diff", "Error", "Picture", "Record", "Records", "Run", "Session", "Why", "diff", "read", "replay"]
