"""``leitmotion patterns --summary``: a short recording and its table of contents."""

import csv
import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import leitmotion as lm
from cli.conftest import Run
from cli.json_schema import faults
from cli.test_contract import schema  # noqa: F401
from leitmotion.motion import joint_points


def test_the_summary_is_written_and_its_contents_printed(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh", "--summary", "-o", "short.bvh")
    assert told.exit_code == 0
    assert told.stderr == ""
    short = lm.read("short.bvh")
    assert told.stdout.startswith(f"1 movement in {len(short) / 30:.1f} s, of a recording of ")
    assert told.stdout.endswith("\nWrote short.bvh.\n")
    assert told.stdout.splitlines()[-2].split()[:2] == ["A", "cyclic"]
    assert lm.summarize(lm.read(made / "jacks.bvh")).contents.labels == ("A",)


def test_json_tells_where_each_is_and_where_it_was(
    run: Run,
    made: Path,
    schema: dict[str, Any],  # noqa: F811
) -> None:
    told = run("patterns", made / "jacks.bvh", "--summary", "-o", "short.npz", "--json")
    document = json.loads(told.stdout)
    assert faults(document, schema) == []
    result = document["result"]
    assert result["written"] == "short.npz"
    (entry,) = result["contents"]
    summary = lm.summarize(lm.read(made / "jacks.bvh"))
    assert (entry["start"], entry["stop"]) == (summary.contents.starts[0], summary.contents.stops[0])
    assert (entry["source"]["start"], entry["source"]["stop"]) == (
        summary.sources.starts[0],
        summary.sources.stops[0],
    )
    assert entry["stop"] - entry["start"] == entry["source"]["stop"] - entry["source"]["start"]
    assert len(result["patterns"][0]["occurrences"]) == 4


def test_without_a_file_it_is_told_and_nothing_is_written(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh", "--summary")
    assert told.exit_code == 0
    assert "it was not written: name it with -o" in told.stdout
    assert list(Path().iterdir()) == []


@pytest.mark.parametrize("ending", [".c3d", ".trc", ".csv", ".npz", ".glb"])
def test_points_are_summarised_in_every_format_that_holds_them(run: Run, made: Path, ending: str) -> None:
    lm.write(joint_points(lm.read(made / "jacks.bvh")), "points.npz")
    told = run("patterns", "points.npz", "--summary", "-o", f"short{ending}")
    assert told.exit_code == 0, told.stderr
    assert Path(f"short{ending}").stat().st_size > 1000


def test_gaps_stay_gaps(run: Run, made: Path) -> None:
    points = joint_points(lm.read(made / "jacks.bvh"))
    positions = points.positions.copy()
    positions[::7, 2] = np.nan
    lm.write(points.replace(positions=positions), "points.npz")
    assert run("patterns", "points.npz", "--summary", "-o", "short.npz").exit_code == 0
    seen = np.isfinite(lm.read("short.npz").positions).all(axis=(0, 2))  # type: ignore[union-attr]
    assert (~seen).sum() == 1


def test_points_into_a_format_of_skeletons_is_a_sentence(run: Run, made: Path) -> None:
    lm.write(joint_points(lm.read(made / "jacks.bvh")), "points.npz")
    told = run("patterns", "points.npz", "--summary", "-o", "short.bvh")
    assert told.exit_code == 1
    assert told.stderr.startswith("Error: ")
    assert told.stderr.count("\n") == 1
    assert not Path("short.bvh").exists()


def test_nothing_recurs_and_nothing_is_written(run: Run, made: Path) -> None:
    told = run("patterns", made / "once.bvh", "--summary", "-o", "short.bvh")
    assert told.exit_code == 0
    assert told.stdout.startswith("Nothing repeats here.\n")
    assert "So there is nothing to summarise, and no recording was written." in told.stdout
    assert not Path("short.bvh").exists()
    result = json.loads(run("patterns", made / "once.bvh", "--summary", "-o", "short.bvh", "--json").stdout)[
        "result"
    ]
    assert (result["contents"], result["written"]) == ([], None)


def test_a_folder_becomes_a_folder_and_one_table(run: Run, made: Path) -> None:
    told = run("patterns", made, "--summary", "-o", "short", "--contents", "short.csv")
    assert told.exit_code == 1  # bad.bvh and empty.bvh
    assert [path.name for path in Path("short").iterdir()] == ["jacks.bvh"]
    rows = list(csv.DictReader(io.StringIO(Path("short.csv").read_text(encoding="utf-8"))))
    assert [row["pattern"] for row in rows] == ["A"]
    assert float(rows[0]["source_stop_s"]) == pytest.approx(int(rows[0]["source_stop"]) / 30, abs=1e-4)


def test_a_file_of_other_content_is_replaced_only_by_force(run: Run, made: Path) -> None:
    Path("short.bvh").write_text("mine", encoding="utf-8")
    told = run("patterns", made / "jacks.bvh", "--summary", "-o", "short.bvh")
    assert told.exit_code == 1
    assert "--force" in told.stderr
    assert Path("short.bvh").read_text(encoding="utf-8") == "mine"
    assert run("patterns", made / "jacks.bvh", "--summary", "-o", "short.bvh", "--force").exit_code == 0
    assert (
        run("patterns", made / "jacks.bvh", "--summary", "-o", "short.bvh").exit_code == 0
    )  # the same again


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        (["--summary", "--lesson"], "ask for one of them"),
        (["--summary", "--residual"], "ask for one of them"),
        (["--contents", "c.csv"], "give --summary and -o as well"),
        (["--summary", "--contents", "c.csv"], "give --summary and -o as well"),
        (["--summary", "-o", "short.doc"], "end it in"),
        (["--summary", "-o", "in.bvh"], "inputs are never written over"),
        (["--summary", "-o", "s.bvh", "--contents", "c.txt"], "end it in .csv, .json"),
        (["--summary", "-o", "c.csv", "--contents", "c.csv"], "is the summary itself"),
    ],
)
def test_what_cannot_be_is_wrong_usage_before_any_work(
    run: Run, made: Path, options: list[str], complaint: str
) -> None:
    Path("in.bvh").write_bytes((made / "jacks.bvh").read_bytes())
    told = run("patterns", "in.bvh", *options)
    assert told.exit_code == 2
    assert complaint in " ".join(told.stderr.split())
    assert [path.name for path in Path().iterdir()] == ["in.bvh"]


def test_one_file_for_several_is_wrong_usage(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh", made / "once.bvh", "--summary", "-o", "short.bvh")
    assert told.exit_code == 2
    assert "Name a folder: -o short." in told.stderr
