"""The built module, and the data that it reads."""
from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import Error

if TYPE_CHECKING:
    from types import ModuleType


def engine() -> ModuleType:
    """The module `_engine`. Raises an `Error` where it is not built."""
    home = data_folder()
    if home:
        os.environ.setdefault("CONTINUA_HOME", str(home))
    try:
        from . import _engine
    except ImportError as problem:
        raise Error(f"this needs the built module of the package, which cannot be loaded ({problem}); without it only "
                    "logs are read. docs/python.md says how it is built") from problem
    return _engine


def data_folder() -> Path | None:
    """The nearest tree of knowledge and scenes above the package: of the sources, or PREFIX/share/continua."""
    for folder in Path(__file__).resolve().parents:
        for tree in (folder, folder / "share" / "continua"):
            if (tree / "engine" / "knowledge").is_dir() and (tree / "mjcf").is_dir():
                return tree
    return None
