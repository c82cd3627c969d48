"""The JSON contract: every document is what docs/json.md says, the bad ones in their place."""

import hashlib
import itertools
import json
import re
from pathlib import Path
from typing import Any

import pytest

import leitmotion
from cli.conftest import Run
from cli.json_schema import faults
from leitmotion.cli.progress import COMPILING
from leitmotion.datasets import Action, compose

DOCS = Path(__file__).resolve().parents[2] / "docs" / "json.md"


@pytest.fixture(scope="module")
def schema() -> dict[str, Any]:
    blocks = re.findall(r"```json\n(.*?)```", DOCS.read_text(encoding="utf-8"), re.DOTALL)
    found: dict[str, Any] = json.loads(blocks[-1])
    return found


def documents(output: str) -> list[dict[str, Any]]:
    return [json.loads(line, parse_constant=_no_constant) for line in output.splitlines()]


def _no_constant(name: str) -> None:
    raise AssertionError(f"{name} is no JSON")


@pytest.mark.parametrize("verb", ["info", "patterns"])
def test_one_document_per_input_in_the_order_given(
    run: Run, made: Path, schema: dict[str, Any], verb: str
) -> None:
    given = [made / name for name in ("once.bvh", "bad.bvh", "jacks.bvh", "missing.bvh", "empty.bvh")]
    told = run(verb, *given, "--json")
    found = documents(told.stdout)
    assert told.exit_code == 1
    assert told.stderr in ("", COMPILING + "\n")
    assert [document["source"][0]["path"] for document in found] == [str(path) for path in given]
    assert [sorted(document)[0] for document in found] == [
        "leitmotion" if "result" in document else "error" for document in found
    ]
    assert ["error" in document for document in found] == [False, True, False, True, True]
    assert [fault for document in found for fault in faults(document, schema)] == []
    assert {document["verb"] for document in found} == {verb}


def test_the_source_tells_the_bytes_and_the_length(run: Run, made: Path) -> None:
    path = made / "jacks.bvh"
    (document,) = documents(run("patterns", path, "--json").stdout)
    (source,) = document["source"]
    assert source["sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()
    assert source["rate"] == 30.0
    assert source["seconds"] == pytest.approx(source["frames"] / 30.0, abs=1e-4)


def test_stretches_lie_in_the_recording_and_pairs_join_occurrences(run: Run, made: Path) -> None:
    (document,) = documents(run("patterns", made / "jacks.bvh", "--json").stdout)
    frames = document["source"][0]["frames"]
    result = document["result"]
    assert [pattern["cycles"] for pattern in result["patterns"]] == [4]
    assert result["nearest_miss"] == ""
    for pattern in result["patterns"]:
        occurrences = pattern["occurrences"]
        assert all(0 <= one["start"] < one["stop"] <= frames for one in occurrences)
        assert all(one["stop"] <= other["start"] for one, other in itertools.pairwise(occurrences))
    known = {pattern["id"]: pattern["occurrences"] for pattern in result["patterns"]}
    joined = [
        tuple(_holding(known[pair["pattern"]], pair[side]) for side in ("a", "b")) for pair in result["pairs"]
    ]
    assert joined
    assert all(earlier < later for earlier, later in joined)
    assert len(set(joined)) == len(joined)


def _holding(occurrences: list[dict[str, Any]], side: dict[str, Any]) -> int:
    """Say which occurrence holds a side of a pair that is at least half of it."""
    (place,) = [
        place
        for place, one in enumerate(occurrences)
        if one["start"] <= side["start"] and side["stop"] <= one["stop"]
    ]
    one = occurrences[place]
    assert 2 * (side["stop"] - side["start"]) >= one["stop"] - one["start"]
    return place


def test_nothing_found_is_done_and_tells_the_nearest_miss(run: Run, schema: dict[str, Any]) -> None:
    actions = [
        Action("squat", 1, period_s=1.8), Action("still"), Action("jumping jack", 1), Action("arm raise", 1)
    ]  # fmt: skip
    leitmotion.write(compose(actions, seed=2, rate=30.0).motion, "medley.bvh")
    told = run("patterns", "medley.bvh", "--json")
    (document,) = documents(told.stdout)
    assert told.exit_code == 0
    assert document["result"]["patterns"] == []
    assert re.match(r"The nearest: [\d.]+ to [\d.]+ s and .* cm apart", document["result"]["nearest_miss"])
    assert document["result"]["nearest_miss"] in run("patterns", "medley.bvh").stdout
    assert faults(document, schema) == []


def test_a_folder_stands_for_its_recordings(run: Run, made: Path) -> None:
    told = run("info", made, "--json")
    assert [Path(d["source"][0]["path"]).name for d in documents(told.stdout)] == [
        "bad.bvh", "empty.bvh", "jacks.bvh", "once.bvh",
    ]  # fmt: skip


def test_an_empty_folder_is_one_error(run: Run, tmp_path: Path, schema: dict[str, Any]) -> None:
    (tmp_path / "void").mkdir()
    told = run("patterns", "void", "--json")
    (document,) = documents(told.stdout)
    assert told.exit_code == 1
    assert faults(document, schema) == []
    assert document["error"]["type"] == "DataError"
    assert document["error"]["message"] == "void holds no recordings."


def test_what_is_no_recording_in_a_folder_is_left_out_with_a_word(
    run: Run, made: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "mixed"
    folder.mkdir()
    (folder / "jacks.bvh").write_bytes((made / "jacks.bvh").read_bytes())
    (folder / "labels.csv").write_text("start_s,stop_s,label\n0.5,1.0,jump\n", encoding="utf-8")
    told = run("patterns", "mixed", "--json")
    assert told.exit_code == 0
    assert len(documents(told.stdout)) == 1
    assert f"{Path('mixed', 'labels.csv')}: Left out, as no recording: " in told.stderr


def test_standard_input_is_an_input(run: Run, made: Path, schema: dict[str, Any]) -> None:
    content = (made / "jacks.bvh").read_bytes()
    (document,) = documents(run("patterns", "-", "--json", stdin=content).stdout)
    assert faults(document, schema) == []
    assert document["source"][0]["path"] == "-"
    assert document["source"][0]["sha256"] == hashlib.sha256(content).hexdigest()
    assert len(document["result"]["patterns"]) == 1


def test_a_window_counts_from_its_start_and_says_where_that_is(run: Run, made: Path) -> None:
    path = made / "jacks.bvh"
    (document,) = documents(run("info", f"{path}[10:40]", "--json").stdout)
    assert document["parameters"]["window"] == {"start": 10, "stop": 40}
    assert document["source"][0]["frames"] == 30
    assert document["source"][0]["path"] == f"{path}[10:40]"
    assert document["source"][0]["sha256"] == hashlib.sha256(path.read_bytes()).hexdigest()


def test_a_defect_in_one_input_does_not_stop_the_others(
    run: Run, made: Path, monkeypatch: pytest.MonkeyPatch, schema: dict[str, Any]
) -> None:
    import leitmotion.api
    from leitmotion.api import info

    def broken_on_the_first(source: str, **options: Any) -> Any:
        if source.endswith("once.bvh"):
            raise IndexError("list index out of range")
        return info(source, **options)

    monkeypatch.setattr(leitmotion.api, "info", broken_on_the_first)
    told = run("info", made / "once.bvh", made / "jacks.bvh", "--json", "--traceback")
    first, second = documents(told.stdout)
    assert told.exit_code == 1
    assert first["error"]["type"] == "IndexError"
    assert "a defect in Leitmotion" in first["error"]["remedy"]
    assert "Traceback (most recent call last)" in told.stderr
    assert "result" in second
    assert faults(first, schema) == []


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        (lambda d: d.pop("warnings"), "lacks 'warnings'"),
        (lambda d: d.update(extra=1), "has 'extra'"),
        (lambda d: d["source"][0].update(frames=1.5), "expected integer"),
        (lambda d: d["result"]["patterns"][0]["occurrences"].pop(), "fewer than 2"),
        (lambda d: d["result"]["patterns"][0].update(kind="odd"), "expected one of"),
    ],
)
def test_the_schema_can_say_no(
    run: Run, made: Path, schema: dict[str, Any], change: Any, complaint: str
) -> None:
    (document,) = documents(run("patterns", made / "jacks.bvh", "--json").stdout)
    if complaint == "fewer than 2":
        del document["result"]["patterns"][0]["occurrences"][2:]
    change(document)
    assert complaint in " ".join(faults(document, schema))


def test_what_may_have_been_missed_is_part_of_the_contract(
    run: Run, made: Path, schema: dict[str, Any]
) -> None:
    (document,) = documents(
        run("patterns", made / "jacks.bvh", "--min-duration", "60", "--residual", "--json").stdout
    )
    assert faults(document, schema) == []
    assert document["result"]["residual"]["candidates"]
    (without,) = documents(run("patterns", made / "jacks.bvh", "--json").stdout)
    assert "residual" not in without["result"]
