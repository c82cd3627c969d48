"""``leitmotion info``: what a recording holds, and how each fact is known."""

import csv
import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cli.conftest import Run


def result(run: Run, *arguments: object) -> dict[str, Any]:
    document = json.loads(run("info", *arguments, "--json").stdout)
    found: dict[str, Any] = document["result"]
    return found


def test_a_person_reads_the_answer_the_facts_and_the_roles(run: Run, made: Path) -> None:
    told = run("info", made / "jacks.bvh").stdout
    assert told.startswith("A skeleton of ")
    assert "frames at 30 Hz.\nNo problem found.\n" in told
    for what in ("unit", "up", "rate", "facing", "size", "left_knee"):
        assert f"\n{what}  " in told


def test_every_fact_says_how_it_is_known(run: Run, made: Path) -> None:
    found = result(run, made / "jacks.bvh")
    assert found["rate"]["how"] == "read"
    assert found["rate"]["value"] == pytest.approx(30.0)
    assert found["up"]["value"] == "y"
    for what in ("unit", "up", "rate", "facing", "size"):
        assert found[what]["reason"]


def test_what_is_said_counts_as_given(run: Run, made: Path) -> None:
    found = result(run, made / "jacks.bvh", "--unit", "inch", "--rate", "24")
    assert (found["unit"]["value"], found["unit"]["how"]) == ("inch", "given")
    assert (found["rate"]["value"], found["rate"]["how"]) == (24.0, "given")


def test_a_wrong_unit_is_a_problem_with_a_remedy(run: Run, made: Path) -> None:
    found = result(run, made / "jacks.bvh", "--unit", "mm")
    (problem,) = [problem for problem in found["problems"] if problem["what"] == "size"]
    assert "people measure" in problem["message"]
    assert "--unit" in problem["remedy"]


def test_a_map_file_settles_the_roles(run: Run, made: Path) -> None:
    joint = next(
        role["members"][0] for role in result(run, made / "jacks.bvh")["roles"] if role["role"] == "head"
    )
    Path("map.json").write_text(json.dumps({"head": joint}), encoding="utf-8")
    assert result(run, made / "jacks.bvh", "--map", "map.json")["roles"] == [
        {"role": "head", "members": [joint], "confidence": 1.0}
    ]


def test_a_folder_is_one_table(run: Run, made: Path) -> None:
    told = run("info", made, "-o", "all.csv")
    assert told.exit_code == 1
    rows = list(csv.DictReader(io.StringIO(Path("all.csv").read_text(encoding="utf-8"))))
    assert [Path(row["path"]).name for row in rows] == ["bad.bvh", "empty.bvh", "jacks.bvh", "once.bvh"]
    assert [bool(row["error"]) for row in rows] == [True, True, False, False]
    assert [row["kind"] for row in rows] == ["", "", "skeleton", "skeleton"]
    assert [float(row["rate"]) for row in rows[2:]] == [30.0, 30.0]
    assert [row["handedness"] for row in rows[2:]] == [
        result(run, row["path"]).get("handedness", {}).get("value", "") for row in rows[2:]
    ]


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "unit", "rate"),
    [
        ("cmu86/86_01.amc", "1/0.45 inch", 120.0),
        ("bandai_namco/dataset-1_walk_normal_001.bvh", "cm", 30.0),
        ("perfume_dance/A_test.bvh", "cm", 40.0),
        ("btk/Dance.c3d", "mm", 65.05),
    ],
)
def test_real_recordings(run: Run, data: Path, name: str, unit: str, rate: float) -> None:
    found = result(run, data / name)
    assert found["unit"]["value"] == unit
    assert found["rate"]["value"] == pytest.approx(rate, abs=0.5)
    assert 1.0 < found["size"]["value"] < 1.7


def test_pickles_are_read_with_trust_only(run: Run, tmp_path: Path) -> None:
    held = {
        "rotation": {"arr": np.tile([0.0, 0, 0, 1], (90, 2, 1))},
        "root_translation": {"arr": np.zeros((90, 3))},
        "skeleton_tree": {
            "node_names": ["pelvis", "head"],
            "parent_indices": {"arr": [-1, 0]},
            "local_translation": {"arr": [[0, 0, 0], [0, 0, 0.7]]},
        },
        "fps": 30,
    }
    path = tmp_path / "a.npy"
    np.save(path, np.array(held, dtype=object), allow_pickle=True)
    refused = run("info", path)
    assert refused.exit_code == 1
    assert refused.stderr.count("\n") == 1
    assert "--trust" in refused.stderr
    document = json.loads(run("info", path, "--trust", "--json").stdout)
    assert document["parameters"]["reading"] == {"trust": True}
    assert document["result"]["rate"]["value"] == 30
