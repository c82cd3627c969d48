"""``leitmotion patterns --across``: what several recordings share."""

import csv
import io
import json
import shutil
from pathlib import Path

import numpy as np
import pytest

import leitmotion as lm
from cli.conftest import Run
from cli.test_contract import documents, faults, schema  # noqa: F401


@pytest.fixture
def three(made: Path, tmp_path: Path) -> Path:
    """A folder with two who jump, at two rates, and one who does not."""
    folder = tmp_path / "three"
    (folder / "ann").mkdir(parents=True)
    shutil.copy(made / "jacks.bvh", folder / "ann" / "jacks.bvh")
    shutil.copy(made / "once.bvh", folder / "once.bvh")
    lm.write(lm.read(made / "jacks.bvh").replace(rate=24.0), folder / "slow.bvh")
    return folder


def test_the_answer_comes_first_then_where_then_who_shares_what(run: Run, three: Path) -> None:
    told = run("patterns", three, "--across", "--quiet")
    lines = told.stdout.splitlines()
    assert told.exit_code == 0
    assert told.stderr == ""
    assert lines[0] == "The three recordings share one movement."
    assert lines[3].split()[:3] == ["A", "cyclic", "2"]
    assert "slow.bvh" in lines[3]
    assert lines[4].split()[0] == "ann/jacks.bvh"
    assert [line.split() for line in lines[-3:]] == [
        ["once.bvh", "·"],
        ["slow.bvh", "4"],
        ["ann/jacks.bvh", "4"],
    ]
    assert not any("  " in line and line != line.rstrip() for line in lines)


def test_one_document_tells_all_sources_and_of_each_stretch_its_own(run: Run, three: Path, schema) -> None:  # noqa: F811
    (document,) = documents(run("patterns", three, "--across", "--json").stdout)
    assert faults(document, schema) == []
    assert [Path(source["path"]).name for source in document["source"]] == [
        "once.bvh",
        "slow.bvh",
        "jacks.bvh",
    ]
    (pattern,) = document["result"]["patterns"]
    assert pattern["sources"] == [1, 2]
    assert document["result"]["counts"] == [[0], [4], [4]]
    for one in (*pattern["occurrences"], *pattern["stretches"]):
        source = document["source"][one["source"]]
        assert one["stop"] <= source["frames"]
        assert one["start_s"] == pytest.approx(one["start"] / source["rate"], abs=1e-4)
    joined = {(pair["a"]["source"], pair["b"]["source"]) for pair in document["result"]["pairs"]}
    assert (1, 2) in joined


def test_a_bad_input_is_named_and_the_rest_go_on(run: Run, made: Path, three: Path, schema) -> None:  # noqa: F811
    given = (three / "slow.bvh", made / "bad.bvh", made / "jacks.bvh", "--across")
    told = run("patterns", *given)
    assert told.exit_code == 1
    assert told.stdout.startswith("The two recordings share one movement.\n")
    assert told.stderr.startswith(f"{made / 'bad.bvh'}: Error: ")
    failed, document = documents(run("patterns", *given, "--json").stdout)
    assert failed["source"] == [{"path": str(made / "bad.bvh")}]
    assert len(document["source"]) == 2
    assert [faults(one, schema) for one in (failed, document)] == [[], []]


def test_too_few_that_can_be_read_is_an_error_that_names_them(run: Run, made: Path, schema) -> None:  # noqa: F811
    given = ("patterns", made / "bad.bvh", made / "jacks.bvh", "--across")
    told = run(*given)
    assert told.exit_code == 1
    assert told.stderr.endswith(
        "Only one of 2 inputs could be read. What recordings share takes two or more.\n"
    )
    *_, document = documents(run(*given, "--json").stdout)
    assert document["error"]["type"] == "DataError"
    assert faults(document, schema) == []


def test_recordings_that_cannot_be_compared_are_one_error(run: Run, made: Path, schema) -> None:  # noqa: F811
    flat = np.cumsum(np.random.default_rng(4).normal(size=(90, 8, 2)), axis=0)
    lm.write(lm.Trajectories(tuple(f"m{k}" for k in range(8)), flat, rate=30.0, unit="px"), "flat.npz")
    told = run("patterns", made / "jacks.bvh", "flat.npz", "--across", "--json")
    assert told.exit_code == 1
    (document,) = documents(told.stdout)
    assert document["error"]["message"].startswith("flat.npz is in a plane and ")
    assert [source["path"] for source in document["source"]] == [str(made / "jacks.bvh"), "flat.npz"]
    assert faults(document, schema) == []


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ((), "there is only"),
        (("--method", "tang2008"), "does not go with --method tang2008"),
        (("--stillness",), "does not go with --stillness"),
        (("--features", "joint_rotations"), "does not go with --features joint_rotations"),
        (("--weights", "active"), "does not go with --weights active"),
        (("--residual",), "ask for one of them"),
        (("-o", "x.html"), "A page shows one recording"),
        (("-o", "x.eaf"), "An ELAN file shows one recording"),
        (("-o", "x.bvh"), "Cannot tell what to write"),
    ],
)
def test_wrong_usage_is_a_sentence(run: Run, made: Path, options: tuple[str, ...], sentence: str) -> None:
    inputs = [made / "jacks.bvh"] if not options else [made / "jacks.bvh", made / "once.bvh"]
    told = run("patterns", *inputs, "--across", *options)
    assert told.exit_code == 2
    assert sentence in " ".join(told.stderr.split())


def test_the_table_has_a_row_per_occurrence_with_its_path(run: Run, three: Path) -> None:
    told = run("patterns", three, "--across", "-o", "found.csv", "--json")
    (document,) = documents(told.stdout)
    rows = list(csv.DictReader(io.StringIO(Path("found.csv").read_text(encoding="utf-8"))))
    assert len(rows) == 8
    assert [Path(row["path"]).name for row in rows] == ["slow.bvh"] * 4 + ["jacks.bvh"] * 4
    assert {row["sources"] for row in rows} == {"2"}
    (pattern,) = document["result"]["patterns"]
    assert [int(row["start"]) for row in rows] == [one["start"] for one in pattern["occurrences"]]


def test_the_document_the_picture_and_the_archive_are_written(run: Run, three: Path) -> None:
    told = run("patterns", three, "--across", "--json", "-o", "found.json")
    assert json.loads(Path("found.json").read_text(encoding="utf-8")) == json.loads(told.stdout)
    for name in ("found.png", "found.svg", "found.npz"):
        assert run("patterns", three, "--across", "-o", name).exit_code == 0
        assert Path(name).stat().st_size > 1000
    found = lm.load("found.npz")
    assert isinstance(found, lm.SharedPatterns)
    assert found.counts.tolist() == [[0], [4], [4]]
    assert "once.bvh" in Path("found.svg").read_text(encoding="utf-8")


def test_a_window_counts_from_its_start_and_is_told(run: Run, made: Path) -> None:
    path = made / "jacks.bvh"
    (document,) = documents(run("patterns", f"{path}[1s:]", path, "--across", "--json").stdout)
    assert document["parameters"]["windows"] == [
        {"start": 30, "stop": lm.read(path).local_positions.shape[0]},
        None,
    ]
    assert document["source"][0]["path"] == f"{path}[1s:]"


def test_nothing_shared_is_an_answer(run: Run, made: Path) -> None:
    told = run("patterns", made / "once.bvh", f"{made / 'jacks.bvh'}[0:20]", "--across")
    assert told.exit_code == 0
    assert told.stdout == "The two recordings share nothing, and nothing repeats in any of them.\n"
