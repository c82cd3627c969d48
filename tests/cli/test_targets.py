"""Where inputs are written: as one expects, no two in one place."""

from pathlib import Path

import click
import pytest

from leitmotion.cli.inputs import Input
from leitmotion.cli.targets import plan


def found(path: str, folder: str = "", window: str = "") -> Input:
    return Input(f"{path}{window}", Path(path), window, folder=folder)


def names(*inputs: Input) -> list[str]:
    return [path.as_posix() for path in plan(inputs, Path("out"), ".c3d").paths]


def test_files_stand_in_the_folder_and_what_a_folder_holds_as_it_stood_there() -> None:
    assert names(found("a/walk.bvh"), found("run.v2.amc")) == ["out/walk.c3d", "out/run.v2.c3d"]
    assert names(found("a/b/walk.bvh", "a"), found("a/run.amc", "a")) == ["out/b/walk.c3d", "out/run.c3d"]
    assert plan([found("a/walk.bvh")], Path("out"), ".c3d").remark == ""


def test_each_of_several_folders_keeps_its_name() -> None:
    assert names(found("x/a/walk.bvh", "x/a"), found("b/walk.bvh", "b")) == [
        "out/a/walk.c3d", "out/b/walk.c3d",
    ]  # fmt: skip


def test_inputs_of_one_name_keep_what_tells_them_apart() -> None:
    assert names(found("walk.amc"), found("walk.bvh"), found("run.bvh")) == [
        "out/walk.amc.c3d", "out/walk.bvh.c3d", "out/run.c3d",
    ]  # fmt: skip
    assert names(found("walk.bvh", window="[2s:5s]"), found("walk.bvh", window="[10:]")) == [
        "out/walk.2s-5s.c3d", "out/walk.10-.c3d",
    ]  # fmt: skip
    assert names(found("a/walk.bvh"), found("b/walk.bvh")) == ["out/walk.c3d", "out/walk-2.c3d"]


def test_it_is_said_which_were_told_apart() -> None:
    told = plan([found("walk.amc"), found("walk.bvh")], Path("out"), ".c3d").remark
    assert told == (
        "Inputs of one name are told apart: walk.amc becomes walk.amc.c3d, walk.bvh becomes walk.bvh.c3d."
    )


def test_no_two_are_alike_whatever_the_file_system_minds() -> None:
    many = [
        "walk.bvh", "Walk.BVH", "a/walk.bvh", "walk.amc", "walk.amc.bvh", "walk-2.bvh",
        "b/caf\u00e9.bvh", "b/cafe\u0301.bvh",
    ]  # fmt: skip
    made = names(*map(found, many))
    assert len({name.casefold() for name in made}) == len(many)
    assert "out/walk.amc.c3d" in made
    assert "out/walk-2.c3d" in made


def test_a_name_is_the_same_whatever_the_order_where_it_is_alone() -> None:
    assert set(names(found("walk.amc"), found("walk.bvh"))) == set(
        names(found("walk.bvh"), found("walk.amc"))
    )


def test_one_file_named_twice_is_refused() -> None:
    with pytest.raises(click.UsageError, match=r"a/walk\.bvh is named twice"):
        names(found("walk.bvh"), found("a/walk.bvh"), found("./a/walk.bvh", "a"))


def test_an_archive_in_a_folder_becomes_a_folder_and_a_named_one_is_a_folder(tmp_path: Path) -> None:
    pack = tmp_path / "src" / "pack.zip"
    pack.parent.mkdir()
    pack.write_bytes(b"PK")
    within = [
        found(str(pack / "walk.bvh"), str(pack.parent)),
        found(str(pack / "in/run.bvh"), str(pack.parent)),
    ]
    assert names(*within) == ["out/pack/walk.c3d", "out/pack/in/run.c3d"]
    alone = [found(str(pack / "walk.bvh"), str(pack)), found(str(pack / "in/run.bvh"), str(pack))]
    assert names(*alone) == ["out/walk.c3d", "out/in/run.c3d"]
    assert names(*alone, found("b/walk.bvh", "b")) == [
        "out/pack/walk.c3d", "out/pack/in/run.c3d", "out/b/walk.c3d",
    ]  # fmt: skip


def test_what_is_compressed_is_told_apart_by_both_endings() -> None:
    assert names(found("walk.bvh"), found("walk.bvh.gz")) == ["out/walk.bvh.c3d", "out/walk.bvh.gz.c3d"]


def test_a_clip_of_a_file_a_frame_has_the_name_of_the_clip() -> None:
    assert names(found("a/duet_000000000000_keypoints.json")) == ["out/duet.c3d"]
    assert names(found("solo/000000000000_keypoints.json")) == ["out/solo.c3d"]
