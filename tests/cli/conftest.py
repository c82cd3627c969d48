"""Recordings made on the spot, and a way to run the program in this process."""

from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from leitmotion.cli import main

Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run the program in an empty folder of its own."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("LEITMOTION_TRACEBACK", raising=False)

    def invoke(*arguments: object, stdin: bytes | None = None) -> Result:
        return CliRunner().invoke(main, [str(argument) for argument in arguments], input=stdin)

    return invoke


@pytest.fixture(scope="session")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a person who jumps (``jacks.bvh``), one who kneads nothing (``once.bvh``), and bad files."""
    from leitmotion.datasets import Action, compose
    from leitmotion.io import write

    folder = tmp_path_factory.mktemp("recordings")
    jacks = compose(
        [Action("still"), Action("jumping jack", 4), Action("still")], seed=1, rate=30.0, name="jacks"
    )
    write(jacks.motion, folder / "jacks.bvh")
    once = compose([Action("still"), Action("squat", 1)], seed=2, rate=30.0, name="once")
    write(once.motion, folder / "once.bvh")
    (folder / "bad.bvh").write_text("HIERARCHY\nROOT Hips\n{\n OFFSET 0 0\n", encoding="utf-8")
    (folder / "empty.bvh").write_bytes(b"")
    return folder
