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
    assert [line.split() for line in lines[-5:-2]] == [
        ["once.bvh", "·"],
        ["slow.bvh", "4"],
        ["ann/jacks.bvh", "4"],
    ]
    assert not any("  " in line and line != line.rstrip() for line in lines)
    assert lines[-1].startswith(
        "Across recordings directions of limbs are alike within 0.35 radians, not 0.25 as"
    )


def test_where_the_limit_is_that_of_one_recording_nothing_is_said_of_it(run: Run, three: Path) -> None:
    told = run("patterns", three, "--across", "--quiet", "--max-distance", "0.25")
    assert "as within one" not in told.stdout
    (document,) = documents(run("patterns", three, "--across", "--json").stdout)
    limits = [document["parameters"][name] for name in ("max_distance", "max_distance_within_one")]
    assert limits == [0.35, 0.25]
    (document,) = documents(run("patterns", three, "--across", "--json", "--features", "posture").stdout)
    limits = [document["parameters"][name] for name in ("max_distance", "max_distance_within_one")]
    assert limits == [0.08, 0.054]


def test_a_recording_given_again_is_compared_once_and_named(run: Run, three: Path, made: Path) -> None:
    shutil.copy(made / "jacks.bvh", "copy.bvh")
    jacks, slow = three / "ann" / "jacks.bvh", three / "slow.bvh"
    (document,) = documents(
        run("patterns", jacks, slow, jacks, jacks, "copy.bvh", "--across", "--json").stdout
    )
    assert [source["path"] for source in document["source"]] == [str(jacks), str(slow)]
    assert document["warnings"][:2] == [
        f"{jacks} is named twice, and was compared once.",
        f"copy.bvh is the same recording as {jacks}, and was compared once.",
    ]
    told = run("patterns", jacks, "copy.bvh", "--across")
    assert told.exit_code == 1
    assert told.stdout == ""
    assert told.stderr == (
        f"Error: There is only one recording to compare: copy.bvh is the same recording as {jacks}. "
        "What recordings share takes two or more that differ.\n"
    )


def test_where_nothing_is_shared_the_nearest_is_told_with_its_number(run: Run, made: Path) -> None:
    """The same jacks by somebody with longer arms: alike, but farther apart than the limit that is given."""
    jacks = lm.read(made / "jacks.bvh")
    arms = np.array([["arm" in name.lower() or "hand" in name.lower()] for name in jacks.skeleton.names])
    lm.write(jacks.replace(local_positions=jacks.local_positions * np.where(arms, 1.25, 1.0)), "long.bvh")
    both = ("patterns", made / "jacks.bvh", "long.bvh", "--across", "--max-distance", "0.02")
    (document,) = documents(run(*both, "--json").stdout)
    assert all(
        pattern["sources"] == [0, 1] for pattern in document["result"]["patterns"]
    )  # directions are the same
    given = (*both, "--features", "posture")
    (document,) = documents(run(*given, "--json").stdout)
    miss = document["result"]["nearest_miss"]
    assert miss.startswith("The nearest: ")
    assert "long.bvh are 0.0" in miss
    assert "the limit is 0.02, at the second look 0.0" in miss
    assert run(*given, "--quiet").stdout.splitlines()[1] == miss
    assert not any(len(pattern["sources"]) > 1 for pattern in document["result"]["patterns"])


def test_the_page_of_several_is_written_and_replaced_only_when_ours(run: Run, three: Path) -> None:
    assert run("patterns", three, "--across", "-o", "shared.html").exit_code == 0
    page = Path("shared.html").read_text(encoding="utf-8")
    assert "<title>Three recordings share one movement" in page
    assert run("patterns", three, "--across", "-o", "shared.html").exit_code == 0
    Path("theirs.html").write_text("<p>theirs", encoding="utf-8")
    told = run("patterns", three, "--across", "-o", "theirs.html")
    assert told.exit_code == 2
    assert "Replace it with --force" in " ".join(told.stderr.split())


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
    assert told.stdout.startswith("The two recordings share nothing, and nothing repeats in any of them.\n\n")
