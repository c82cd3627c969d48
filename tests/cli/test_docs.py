"""What docs/cli.md tells a person to type works, and its tables are complete."""

import re
import shlex
import shutil
from pathlib import Path

import pytest

from cli.conftest import Run
from leitmotion.cli.program import VERBS

TEXT = (Path(__file__).resolve().parents[2] / "docs" / "cli.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^\$ leitmotion (.+)$", TEXT, re.MULTILINE)


@pytest.mark.parametrize("command", COMMANDS)
def test_command(run: Run, made: Path, command: str) -> None:
    shutil.copy(made / "jacks.bvh", "dance.bvh")
    shutil.copy(made / "once.bvh", "other.bvh")
    Path("recordings").mkdir()
    shutil.copy(made / "jacks.bvh", "recordings")
    shutil.copy(made / "once.bvh", "recordings")
    Path("labels.csv").write_text("start_s,stop_s,label\n1,2,jump\n", encoding="utf-8")
    if "found.json" in shlex.split(command)[1:4]:
        run("patterns", "dance.bvh", "-o", "found.json")
    told = run(*shlex.split(command))
    assert told.exit_code == 0, told.stderr
    assert told.stdout


def test_every_verb_is_in_the_table() -> None:
    assert re.findall(r"^\| `(\w+)` \| [a-z]", TEXT, re.MULTILINE)[: len(VERBS)] == list(VERBS)
