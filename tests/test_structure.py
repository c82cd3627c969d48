"""What holds the house up: which room may import which, what each room shows, and that importing is free."""

import ast
import importlib
import inspect
import re
import subprocess
import sys
from pathlib import Path

import pytest

import leitmotion

SOURCE = Path(leitmotion.__file__).parent
ROOMS = sorted(path.parent.name for path in SOURCE.glob("*/__init__.py"))
FLOORS = {
    "motion": 0,
    "io": 1, "body": 1, "vision": 1, "datasets": 1, "evaluation": 1,
    "features": 2, "repairs": 2,
    "similarity": 3, "words": 3,
    "discovery": 4, "recognition": 4, "retrieval": 4,
    "synthesis": 5, "view": 5,
    "facade": 6,
    "cli": 7,
}  # fmt: skip
FACADE = (
    "__init__",
    "api",
    "calibration",
    "comparing",
    "conversion",
    "describing",
    "evaluating",
    "graphing",
    "inspection",
    "lessons",
    "paging",
    "sharing",
    "symmetry",
)
HEAVY = ("numba", "scipy", "matplotlib", "sklearn", "torch", "cv2")


def room_of(module: str) -> str:
    """The room of a dotted module name; what lies beside the rooms is the façade, __main__ belongs to cli."""
    name = module.split(".")[1] if "." in module else "__init__"
    return {"__main__": "cli"}.get(name, name if name in ROOMS else "facade")


def imports_of(path: Path) -> set[str]:
    """Every module of ours that a file imports, at its head or inside a function."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path} imports relatively"
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
    return {name for name in found if name.split(".")[0] == "leitmotion"}


def files() -> list[Path]:
    return sorted(SOURCE.rglob("*.py"))


@pytest.mark.parametrize("path", files(), ids=lambda path: str(path.relative_to(SOURCE)))
def test_a_room_imports_only_lower_floors(path):
    module = ".".join(("leitmotion", *path.relative_to(SOURCE).with_suffix("").parts))
    room = room_of(module)
    for imported in imports_of(path):
        other = room_of(imported)
        if imported == "leitmotion.__version__" or other == room:
            continue
        assert FLOORS[other] < FLOORS[room], f"{module} ({room}) may not import {imported} ({other})"


def test_every_room_has_its_floor():
    assert set(ROOMS) <= set(FLOORS)
    assert {path.stem for path in SOURCE.glob("*.py")} == {*FACADE, "__main__"}


@pytest.mark.parametrize("name", ["leitmotion", *(f"leitmotion.{room}" for room in ROOMS)])
def test_what_a_room_promises_is_there(name):
    room = importlib.import_module(name)
    assert room.__doc__
    promised = list(room.__all__)
    assert promised == sorted(promised, key=constants_classes_functions)
    assert len(set(promised)) == len(promised)
    for each in promised:
        assert hasattr(room, each), f"{name}.__all__ promises {each}"


@pytest.mark.parametrize("name", ["leitmotion", *(f"leitmotion.{room}" for room in ROOMS)])
def test_what_a_room_shows_is_documented(name):
    room = importlib.import_module(name)
    shown = {each: getattr(room, each) for each in room.__all__ if callable(getattr(room, each))}
    assert [each for each, what in shown.items() if not what.__doc__] == []
    silent = [
        f"{each}({parameter})"
        for each, what in shown.items()
        if inspect.isfunction(what) and not re.search(r"\b[Aa]s (in|for) :func:", what.__doc__)
        for parameter in inspect.signature(what).parameters
        if not re.search(rf"\b{parameter}\b", what.__doc__)
    ]
    assert silent == []


def constants_classes_functions(name: str) -> tuple[int, str]:
    """The order in which the linter keeps ``__all__``."""
    return (0 if name.isupper() else 1 if name[0].isupper() else 2), name


@pytest.mark.parametrize(
    "command",
    [["-c", "import leitmotion"], ["-m", "leitmotion", "--help"], ["-m", "leitmotion", "patterns", "--help"]],
    ids=" ".join,
)
def test_importing_and_asking_for_help_load_nothing_heavy(command):
    done = subprocess.run(
        [sys.executable, "-X", "importtime", *command], capture_output=True, text=True, check=True, timeout=60
    )
    loaded = {line.rpartition("|")[2].strip() for line in done.stderr.splitlines() if "|" in line}
    assert "leitmotion" in loaded
    assert {name for name in loaded if name.split(".")[0] in HEAVY} == set()
