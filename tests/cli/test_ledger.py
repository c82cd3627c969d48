"""What was converted into a folder: kept by content, and never believed blindly."""

import json
from pathlib import Path

import pytest

from leitmotion.cli.ledger import NAME, Ledger, checksum, facts, still_holds


@pytest.fixture
def entry(tmp_path: Path) -> dict[str, object]:
    (tmp_path / "walk.npz").write_bytes(b"made")
    made = facts(
        sha256="s", others="k", parameters={"to": "npz", "fps": 30.0},
        written={"walk.npz": checksum(tmp_path / "walk.npz")}, told={"frames": 1},
    )  # fmt: skip
    return made


def test_what_is_noted_is_there_for_the_next_run(tmp_path: Path, entry: dict[str, object]) -> None:
    source = tmp_path / "src" / "walk.bvh"
    Ledger(tmp_path).add(tmp_path / "walk.npz", source, entry)
    again = Ledger(tmp_path)
    held = again.entry(tmp_path / "walk.npz", source)
    assert held is not None
    assert entry.items() <= held.items()
    assert again.written() == {(tmp_path / "walk.npz").resolve()}
    assert again.entry(tmp_path / "walk.npz", tmp_path / "other" / "walk.bvh") is None
    assert again.entry(tmp_path / "run.npz", source) is None


def test_it_is_seen_alike_from_every_folder(
    tmp_path: Path, entry: dict[str, object], monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "out").mkdir()
    monkeypatch.chdir(tmp_path)
    Ledger(Path("out")).add(Path("out/walk.npz"), Path("walk.bvh"), entry)
    monkeypatch.chdir(tmp_path / "out")
    assert Ledger(Path()).entry(Path("walk.npz"), Path("../walk.bvh")) is not None
    assert str(tmp_path) not in Path(NAME).read_text(encoding="utf-8")


def test_closing_makes_it_whole_and_stable_and_keeps_what_another_run_noted(
    tmp_path: Path, entry: dict[str, object]
) -> None:
    one, other = Ledger(tmp_path), Ledger(tmp_path)
    one.add(tmp_path / "b.npz", tmp_path / "b.bvh", entry)
    one.add(tmp_path / "a.npz", tmp_path / "a.bvh", entry)
    other.add(tmp_path / "c.npz", tmp_path / "c.bvh", entry)
    one.add(tmp_path / "b.npz", tmp_path / "b.bvh", entry | {"sha256": "new"})
    one.close()
    lines = [json.loads(line) for line in (tmp_path / NAME).read_text(encoding="utf-8").splitlines()]
    assert [line["target"] for line in lines] == ["a.npz", "b.npz", "c.npz"]
    assert lines[1]["sha256"] == "new"


@pytest.mark.parametrize(
    "line", ['{"target": "wal', "[1, 2]", "null", '{"target": "walk.npz"}', "\x00\xff", ""]
)
def test_a_line_that_is_none_is_passed_over(tmp_path: Path, entry: dict[str, object], line: str) -> None:
    source = tmp_path / "walk.bvh"
    Ledger(tmp_path).add(tmp_path / "walk.npz", source, entry)
    with (tmp_path / NAME).open("a", encoding="latin-1") as file:
        file.write(line)
    assert Ledger(tmp_path).entry(tmp_path / "walk.npz", source) is not None


def test_a_conversion_holds_while_everything_is_as_it_was(tmp_path: Path, entry: dict[str, object]) -> None:
    now = {"sha256": "s", "others": "k", "parameters": {"to": "npz", "fps": 30.0}}
    assert still_holds(entry, tmp_path, **now)
    for change in ({"sha256": "t"}, {"others": ""}, {"parameters": {"to": "npz"}}):
        assert not still_holds(entry, tmp_path, **now | change)
    assert not still_holds(entry | {"leitmotion": "0.0.0"}, tmp_path, **now)
    (tmp_path / "walk.npz").write_bytes(b"edited")
    assert not still_holds(entry, tmp_path, **now)
    (tmp_path / "walk.npz").unlink()
    assert not still_holds(entry, tmp_path, **now)


def test_a_folder_that_takes_no_ledger_is_no_fault(tmp_path: Path, entry: dict[str, object]) -> None:
    (tmp_path / NAME).mkdir()
    ledger = Ledger(tmp_path)
    ledger.add(tmp_path / "walk.npz", tmp_path / "walk.bvh", entry)
    ledger.close()
    assert (tmp_path / NAME).is_dir()
