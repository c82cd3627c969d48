"""What is written: told on a line, never over what somebody else wrote, and over our own without a question."""

import json
import os
from pathlib import Path

import pytest

import leitmotion as lm
from cli.conftest import Run
from leitmotion.cli.ours import WITH_TABLES, is_ours

ANSWERS = ("x.csv", "x.json", "x.png", "x.svg", "x.pdf", "x.html", "x.eaf", "x.npz")
OF_SOMEBODY = b"my,own,work\n1,2,3\n"
PAIRS = """frame_a,frame_b,alike
20,60,1
24,64,1
20,30,0
24,36,0
"""


@pytest.fixture
def calls(run: Run, made: Path) -> dict[str, tuple[object, ...]]:
    """How each verb that answers is asked to write, without where."""
    Path("pairs.csv").write_text(PAIRS, encoding="utf-8")
    Path("labels.csv").write_text("start_s,stop_s,label\n1.0,4.0,jump\n", encoding="utf-8")
    run("patterns", made / "jacks.bvh", "-o", "found.json")
    return {
        "info": ("info", made / "jacks.bvh"),
        "similarity": ("similarity", made / "jacks.bvh"),
        "mirror": ("similarity", made / "jacks.bvh", "--symmetry"),
        "symmetry": ("symmetry", made / "jacks.bvh"),
        "graph": ("graph", made / "jacks.bvh"),
        "patterns": ("patterns", made / "jacks.bvh"),
        "lesson": ("patterns", made / "jacks.bvh", "--lesson"),
        "across": ("patterns", made / "jacks.bvh", made / "once.bvh", "--across"),
        "calibrate": ("calibrate", "pairs.csv", made / "jacks.bvh"),
        "evaluate": ("evaluate", "patterns", "labels.csv", "found.json"),
    }


@pytest.mark.parametrize("name", ANSWERS)
def test_a_file_of_somebody_stays_unless_by_force_and_our_own_is_replaced(
    run: Run, made: Path, name: str
) -> None:
    Path(name).write_bytes(OF_SOMEBODY)
    call = ("patterns", made / "jacks.bvh", "-o", name)
    told = run(*call)
    assert told.exit_code == 2
    assert (
        f"{name} is there, and does not say that Leitmotion wrote it. Replace it with --force." in told.stderr
    )
    assert Path(name).read_bytes() == OF_SOMEBODY
    told = run(*call, "--force")
    assert told.exit_code == 0
    assert told.stdout.endswith(f"\nWrote {name}.\n")
    written = Path(name).read_bytes()
    assert is_ours(Path(name))
    assert run(*call).exit_code == 0  # the same once more asks nothing
    assert Path(name).read_bytes() == written


@pytest.mark.parametrize(
    "verb", ["info", "similarity", "mirror", "symmetry", "graph", "lesson", "across", "calibrate", "evaluate"]
)
@pytest.mark.parametrize("ending", [".csv", ".json"])
def test_every_verb_keeps_the_rule(
    run: Run, calls: dict[str, tuple[object, ...]], verb: str, ending: str
) -> None:
    out = Path(f"new/{verb}{ending}")
    told = run(*calls[verb], "-o", out)
    assert told.exit_code == 0, told.output
    assert told.stdout.endswith(f"\nWrote {out}, in a new folder.\n")
    assert run(*calls[verb], "-o", out).stdout.endswith(f"\nWrote {out}.\n")
    out.write_bytes(OF_SOMEBODY)
    told = run(*calls[verb], "-o", out)
    assert (told.exit_code, out.read_bytes()) == (2, OF_SOMEBODY)
    assert told.stderr.endswith("Replace it with --force.\n")
    assert run(*calls[verb], "-o", out, "--force").exit_code == 0
    assert is_ours(out)


def test_beside_documents_it_is_told_on_standard_error(run: Run, made: Path) -> None:
    call = ("patterns", made / "jacks.bvh", "-o", "x.csv", "--json")
    told = run(*call)
    assert json.loads(told.stdout)["verb"] == "patterns"
    assert told.stderr.endswith("Wrote x.csv.\n")
    assert run(*call, "--quiet").stderr == ""
    told = run("report", made / "jacks.bvh", made / "once.bvh", "-o", "pages", "--json")
    assert f"{made / 'jacks.bvh'}: Wrote {Path('pages/jacks.html')}, in a new folder.\n" in told.stderr


def test_the_contents_of_a_summary_keep_the_rule(run: Run, made: Path) -> None:
    call = ("patterns", made / "jacks.bvh", "--summary", "-o", "short.bvh", "--contents", "short.csv")
    Path("short.csv").write_bytes(OF_SOMEBODY)
    assert run(*call).exit_code == 2
    assert Path("short.csv").read_bytes() == OF_SOMEBODY
    assert not Path("short.bvh").exists()
    Path("short.csv").unlink()
    assert run(*call).stdout.endswith("\nWrote short.bvh.\nWrote short.csv.\n")
    assert run(*call).exit_code == 0


def test_what_another_program_saved_is_no_longer_ours(run: Run, made: Path) -> None:
    """ELAN's file once a person worked in it, a table with a column more, a recording in the format of an answer."""
    run("patterns", made / "jacks.bvh", "-o", "x.eaf")
    run("patterns", made / "jacks.bvh", "-o", "x.csv")
    lines = Path("x.eaf").read_text(encoding="utf-8").splitlines()
    Path("x.eaf").write_text("\n".join(line for line in lines if "<!--" not in line), encoding="utf-8")
    table = Path("x.csv").read_text(encoding="utf-8")
    Path("x.csv").write_text(table.replace("confidence\n", "confidence,mine\n"), encoding="utf-8")
    lm.save(lm.read(made / "jacks.bvh"), "x.npz")
    assert [is_ours(Path(name)) for name in ("x.eaf", "x.csv", "x.npz")] == [False] * 3


def test_an_empty_file_holds_nothing_to_lose(run: Run, made: Path) -> None:
    Path("x.csv").touch()
    assert run("patterns", made / "jacks.bvh", "-o", "x.csv").exit_code == 0


def test_a_device_is_refused_before_any_work(run: Run, made: Path) -> None:
    os.mkfifo("pipe.csv")
    told = run("patterns", made / "jacks.bvh", "-o", "pipe.csv")
    assert told.exit_code == 2
    assert "pipe.csv is a device or a pipe, not a file to write." in told.stderr


def test_a_name_that_was_mistyped_leaves_the_table_as_it_was(run: Run, made: Path) -> None:
    run("patterns", made / "jacks.bvh", "-o", "x.csv")
    table = Path("x.csv").read_bytes()
    told = run("patterns", "jaks.bvh", "-o", "x.csv")
    assert (told.exit_code, told.stdout, Path("x.csv").read_bytes()) == (1, "", table)


def test_what_may_have_been_missed_has_a_table_beside(run: Run, made: Path) -> None:
    call = ("patterns", made / "once.bvh", "--residual", "-o", "x.csv")
    assert run(*call).stdout.endswith("\nWrote x.csv.\nWrote x-residual.csv.\n")
    assert is_ours(Path("x-residual.csv"))
    Path("x-residual.csv").write_bytes(OF_SOMEBODY)
    assert run(*call).exit_code == 2


def test_every_table_is_known() -> None:
    from importlib import import_module
    from pkgutil import iter_modules

    import leitmotion.cli as cli

    modules = {each.name for each in iter_modules(cli.__path__)}
    assert set(WITH_TABLES) == {
        name
        for name in modules
        if isinstance(getattr(import_module(f"leitmotion.cli.{name}"), "COLUMNS", None), tuple)
    }
