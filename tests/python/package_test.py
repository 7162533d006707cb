"""The package as it is given to others: types, versions, the wheel."""
import ast
import inspect
import os
import re
import subprocess
import sys
import zipfile

import pytest

import continua
from conftest import BUILD


def test_versions_are_those_of_the_project(root):
    project = re.search(r"project\(continua VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text())[1]
    metadata = (root / "python/pyproject.toml").read_text()
    assert continua.__version__ == project and f'\nversion = "{project}"\n' in metadata


def test_all_that_is_public_has_types_and_a_docstring():
    for name in continua.__all__:
        value = getattr(continua, name)
        if name == "Record":
            continue
        assert value.__doc__, name
        members = [value] if inspect.isfunction(value) else [
            member for key, member in vars(value).items() if not key.startswith("_") or key == "__init__"]
        for member in members:
            function = member.fget if isinstance(member, property) else getattr(member, "func", member)
            assert inspect.isfunction(function), member
            assert function.__doc__ or function.__name__ == "__init__", f"{name}.{function.__name__}"
            assert "return" in function.__annotations__, f"{name}.{function.__name__}"


def test_the_stubs_are_those_of_the_module(root):
    engine = pytest.importorskip("continua._engine")
    stubs = ast.parse((root / "python/continua/_engine.pyi").read_text())
    found = {}
    for node in stubs.body:
        if isinstance(node, ast.FunctionDef):
            found[node.name] = [argument.arg for argument in node.args.args]
        elif isinstance(node, ast.ClassDef):
            found[node.name] = None
            for method in node.body:
                if isinstance(method, ast.FunctionDef):
                    found[f"{node.name}.{method.name}"] = [argument.arg for argument in method.args.args]
    there = {name for name in vars(engine) if not name.startswith("_")}
    for name in list(there):
        if inspect.isclass(getattr(engine, name)):
            there |= {f"{name}.{member}" for member in vars(getattr(engine, name))
                      if not member.startswith("_") or member == "__init__"}
    assert there == set(found)
    for name, arguments in found.items():
        value = eval(f"engine.{name}", {"engine": engine})
        if arguments and not isinstance(value, property):
            signature = value.__doc__.splitlines()[0]
            assert re.findall(r"(\w+): ", signature.split(" -> ")[0]) == arguments, signature


def test_the_types_fit_together(root, tmp_path):
    pytest.importorskip("mypy")
    done = subprocess.run([sys.executable, "-m", "mypy", "--cache-dir", tmp_path], cwd=root / "python",
                          env={**os.environ, "MYPYPATH": "."}, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("place", ["python", None])
def test_the_wheel(root, tmp_path, place):
    """Of the sources: Python alone. Of the build tree: with the module and its data, for this Python and system."""
    pytest.importorskip("setuptools")
    pytest.importorskip("wheel")
    source = root / place if place else BUILD / "python"
    if not (source / "continua").exists():
        pytest.skip(f"{source} is not built")
    copy = tmp_path / "source"
    subprocess.run(["cp", "-rL", source, copy], check=True)
    make = "import sys; from setuptools import build_meta; print(build_meta.build_wheel(sys.argv[1]))"
    done = subprocess.run([sys.executable, "-c", make, str(tmp_path)], cwd=copy, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    name = done.stdout.splitlines()[-1]
    with zipfile.ZipFile(tmp_path / name) as wheel:
        names = wheel.namelist()
        metadata = wheel.read(f"continua-{continua.__version__}.dist-info/METADATA").decode()
        wheel.extractall(tmp_path / "installed")
    assert "Name: continua\n" in metadata and "License: Apache-2.0" in metadata
    assert {"continua/__init__.py", "continua/py.typed", "continua/_engine.pyi"} <= set(names)
    if place:
        assert name.endswith("-py3-none-any.whl") and not [each for each in names if each.endswith(".so")]
        ask = "print(len(continua.read(sys.argv[1])))"
    else:
        assert name.endswith(".whl") and "none-any" not in name
        ask = "print(continua.replay(sys.argv[1] + '/traces/paper/correction.trace.jsonl', physics=False).header['kind'])"
    log = root / "traces/paper/correction.physics.run.jsonl" if place else root
    environment = {key: value for key, value in os.environ.items() if key not in ("CONTINUA_HOME", "PYTHONPATH")}
    done = subprocess.run([sys.executable, "-c", f"import sys, continua; {ask}; print(continua.__file__)", str(log)],
                          cwd=tmp_path / "installed", env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert str(tmp_path / "installed") in done.stdout


def test_the_installed_package(root, tmp_path):
    pytest.importorskip("continua._engine")
    subprocess.run(["cmake", "--install", BUILD, "--component", "python", "--prefix", tmp_path], check=True,
                   stdout=subprocess.DEVNULL)
    environment = {**os.environ, "PYTHONPATH": str(tmp_path / "lib/python3/dist-packages"), "CONTINUA_HOME": str(root)}
    ask = "import continua; print(continua.Session(physics=False).hear('Hello.')[0]['kind'], continua.__file__)"
    done = subprocess.run([sys.executable, "-c", ask], cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert done.stdout.startswith(f"utterance {tmp_path}"), done.stderr
