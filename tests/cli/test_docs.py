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
    rows = [f"{k},{k + apart},{int(apart == 1)}" for k in range(30, 60, 5) for apart in (1, 9)]
    Path("frames.csv").write_text("frame_a,frame_b,alike\n" + "\n".join(rows), encoding="utf-8")
    named = [f"dance.bvh,{a},dance.bvh,{b}" for a, _, b in (row.partition(",") for row in rows)]
    named = [f"{row},{group}" for row in named for group in ("fit", "check")]
    head = "recording_a,frame_a,recording_b,frame_b,alike,group\n"
    Path("pairs.csv").write_text(head + "\n".join(named), encoding="utf-8")
    told = run(*shlex.split(command))
    assert told.exit_code == 0, told.stderr
    assert told.stdout


def test_every_verb_is_in_the_table() -> None:
    assert re.findall(r"^\| `(\w+)` \| [a-z]", TEXT, re.MULTILINE)[: len(VERBS)] == list(VERBS)
