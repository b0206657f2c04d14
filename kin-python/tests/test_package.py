"""The package: types, documentation, and the examples in it."""

import doctest
import inspect
import re
import subprocess
import sys
from importlib import import_module, metadata
from pathlib import Path

import pytest

import kin
from kin import _kin

HERE = Path(__file__).parent


def mypy(file):
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", "/dev/null", str(HERE / file)]
    return subprocess.run(command, capture_output=True, text=True, cwd=HERE)


def test_types_of_a_program():
    checked = mypy("typed.py")
    assert checked.returncode == 0, checked.stdout


def test_mistakes_in_types():
    refused = {int(line.split(":")[1]) for line in mypy("mistyped.py").stdout.splitlines() if ": error:" in line}
    lines = (HERE / "mistyped.py").read_text().splitlines()
    assert refused == {number for number, line in enumerate(lines, 1) if line.endswith("# mistake")}


def test_types_are_those_of_the_module():
    """The stubs name what the module has, with the same arguments."""
    allowed = str(HERE / "stubtest.txt")
    command = [sys.executable, "-m", "mypy.stubtest", "kin", "--ignore-disjoint-bases", "--allowlist", allowed]
    stubs = subprocess.run(command, capture_output=True, text=True, cwd=HERE)
    assert stubs.returncode == 0, stubs.stdout + stubs.stderr


def public(value):
    """The members of a class by their names. A class keeps them in another order in each process."""
    members = [(name, item) for name, item in vars(value).items() if not name.startswith("_")]
    return sorted(members, key=lambda member: member[0])


def documented():
    """Everything that a user can ask for help."""
    for name in kin.__all__:
        value = getattr(kin, name)
        yield name, value
        if inspect.isclass(value) and value.__module__ in ("kin", "kin._kin"):
            yield from ((f"{name}.{part}", item) for part, item in public(value))


@pytest.mark.parametrize("name, value", list(documented()))
def test_everything_is_documented(name, value):
    assert inspect.getdoc(value), name


@pytest.mark.parametrize("module, lines", [("kin", 70), ("kin.library", 8)])
def test_examples_run(module, lines):
    result = doctest.testmod(import_module(module), optionflags=doctest.NORMALIZE_WHITESPACE)
    assert result.failed == 0 and result.attempted >= lines


CHAPTER = HERE.parent.parent / "docs" / "python.md"


def test_the_chapter():
    examples = re.findall(r"```pycon\n(.*?)```", CHAPTER.read_text(encoding="utf-8"), re.DOTALL)
    assert len(examples) == 6
    pytest.importorskip("matplotlib").use("agg")
    test = doctest.DocTestParser().get_doctest("\n".join(examples), {}, "python.md", str(CHAPTER), None)
    assert doctest.DocTestRunner().run(test).failed == 0


@pytest.mark.parametrize("readme", ["README.md", "kin-python/README.md"])
def test_the_readme(readme, capsys):
    text = (CHAPTER.parent.parent / readme).read_text(encoding="utf-8")
    [example] = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    exec(example, {})
    assert capsys.readouterr().out


def test_metadata():
    found = metadata.metadata("kin-mechanisms")
    assert found["License-Expression"] == "MIT OR Apache-2.0"
    assert set(found.get_all("License-File")) == {"LICENSE-MIT", "LICENSE-APACHE"}
    files = {str(file) for file in metadata.files("kin-mechanisms") or []}
    assert "kin_mechanisms-0.1.0.dist-info/METADATA" in files


def test_everything_public_is_exported():
    classes = {name for name, value in public(_kin) if inspect.isclass(value)}
    assert classes <= set(kin.__all__)


def test_another_interpreter_refuses():
    """pyo3 has no modules in several interpreters: that must be an `ImportError`, and no crash."""
    interpreters = pytest.importorskip("_xxsubinterpreters")
    program = "try:\n    import kin\nexcept ImportError:\n    pass\nelse:\n    1 / 0"
    code = f"import kin, _xxsubinterpreters as own\nown.run_string(own.create(), {program!r})\nprint('refused')"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert ran.stdout == "refused\n", ran.stderr
