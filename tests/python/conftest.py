"""What the tests of the package share: the program of the build tree CONTINUA_BUILD, and runs."""
import json
import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("CONTINUA_BUILD", ROOT / "build"))


class Program:
    """The program, for what it prints."""

    def __call__(self, *arguments, status=0):
        done = subprocess.run([BUILD / "continua", *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode == status, done.stderr
        return done.stdout

    def json(self, *arguments, status=0):
        return json.loads(self(*arguments, status=status))


@pytest.fixture(scope="session")
def program():
    return Program()


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def talk(program, tmp_path_factory):
    """The log of a conversation with words, questions and acts."""
    path = tmp_path_factory.mktemp("talk") / "talk.run.jsonl"
    program("replay", ROOT / "traces/talk/speech_only.trace.jsonl", "--no-physics", "-o", path)
    return path
