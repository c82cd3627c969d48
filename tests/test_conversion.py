"""``lm.convert``: from any format to any other, and back where nothing is lost."""

from pathlib import Path

import numpy as np
import pytest

import leitmotion as lm
import leitmotion.inspection
from leitmotion.conversion import name_of, prepare
from leitmotion.datasets import Action, compose
from leitmotion.io.formats import writable
from leitmotion.motion import forward_kinematics, resample


@pytest.fixture
def dance(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> lm.Motion:
    monkeypatch.chdir(tmp_path)
    motion = compose([Action("walk", 2), Action("squat", 1)], seed=4, rate=30.0, name="dance").motion
    lm.write(motion, "dance.npz")
    return motion


def test_to_an_archive_and_back_is_the_same_to_the_bit(dance: lm.Motion) -> None:
    assert lm.convert("dance.npz", "again.npz") == lm.Converted((Path("again.npz"),), (), ())
    assert Path("again.npz").read_bytes() == Path("dance.npz").read_bytes()


@pytest.mark.parametrize("extension", [one for one, form in writable().items() if form.module])
def test_there_and_back_keeps_every_joint_s_way(dance: lm.Motion, extension: str) -> None:
    """Through every format that is written and read, and said so where it is not kept."""
    made = lm.convert("dance.npz", f"there{extension}")
    back = lm.read(f"there{extension}", up="y" if extension == ".bvh" else None)
    if "rotations" in {change.what for change in made.changes}:
        assert isinstance(back, lm.Trajectories)
        places = {name: back.positions[:, k] for k, name in enumerate(back.names)}
    else:
        assert isinstance(back, lm.Motion)
        pose = forward_kinematics(back).positions
        places = {name: pose[:, k] for k, name in enumerate(back.skeleton.names)}
    right = forward_kinematics(dance).positions
    for k, name in enumerate(dance.skeleton.names):
        assert np.allclose(places[name], right[:, k], atol=2e-5), name
    assert back.rate == pytest.approx(dance.rate, rel=1e-6)


def test_a_window_is_cut_and_a_rate_is_resampled(dance: lm.Motion) -> None:
    made = lm.convert("dance.npz[10:70]", "part.npz", fps=12)
    assert lm.read("part.npz") == resample(dance[10:70], 12).replace(name="dance")
    assert [change.what for change in made.changes] == ["rate"]
    assert lm.convert("dance.npz", "same.npz", fps=30).changes == ()


def test_what_is_there_is_replaced_only_by_force_and_the_source_never(dance: lm.Motion) -> None:
    lm.convert("dance.npz", "dance.bvh")
    lm.convert("dance.npz", "dance.bvh")
    with pytest.raises(lm.DataError, match=r"dance\.bvh is there with other content") as told:
        lm.convert("dance.npz", "dance.bvh", fps=10)
    assert "force=True" in told.value.remedy
    lm.convert("dance.npz", "dance.bvh", fps=10, force=True)
    before = Path("dance.npz").read_bytes()
    with pytest.raises(lm.ParameterError, match="inputs are never written over"):
        lm.convert("dance.npz[:10]", "./dance.npz", force=True)
    assert Path("dance.npz").read_bytes() == before


@pytest.mark.parametrize("extension", [".fbx", "", ".BVHH"])
def test_what_is_not_written_is_refused_with_what_is(dance: lm.Motion, extension: str) -> None:
    with pytest.raises(lm.ParameterError, match=r"Recordings are written as .*\.bvh, "):
        lm.convert("dance.npz", f"x{extension}")


def test_an_extension_may_be_in_capitals_and_without_its_dot(dance: lm.Motion) -> None:
    assert prepare("dance.npz", "BVH").files == prepare("dance.npz", ".bvh").files


def test_a_misread_size_is_told(dance: lm.Motion) -> None:
    lm.write(dance, "dance.bvh", unit="cm")
    (told,) = lm.convert("dance.bvh", "giant.npz", unit="m", up="y").warnings
    assert told.startswith("The body measures 1")
    assert lm.convert("dance.bvh", "right.npz").warnings == ()


def test_a_misread_recording_is_told_as_info_tells_it(
    dance: lm.Motion, monkeypatch: pytest.MonkeyPatch
) -> None:
    lm.write(dance, "dance.bvh", unit="cm")
    options = [{"unit": "m", "up": "y"}, {"unit": "cm", "up": "x"}, {"unit": "cm", "up": "y"}]
    told = [lm.info("dance.bvh", **chosen) for chosen in options]
    assert [len(each.misread) for each in told] == [1, 1, 0]
    monkeypatch.setattr(leitmotion.inspection, "find_problems", lambda _: pytest.fail("more than is needed"))
    for chosen, info in zip(options, told, strict=True):
        assert prepare("dance.bvh", ".npz", **chosen).warnings == (*info.warnings, *info.misread)


def test_what_is_no_body_is_converted_as_well(tmp_path: Path) -> None:
    one = lm.Trajectories(("p",), np.zeros((5, 1, 3)) + 1.0, 10.0)
    lm.write(one, tmp_path / "one.npz")
    lm.convert(tmp_path / "one.npz", tmp_path / "other.npz")
    assert lm.read(tmp_path / "other.npz") == one.replace(name="one")


@pytest.mark.parametrize(
    ("person", "name"),
    [
        ("", "duo.v2.c3d"),
        ("Anna", "duo.v2.Anna.c3d"),
        ("../../etc/passwd", "duo.v2._.._etc_passwd.c3d"),
        ("a\nb", "duo.v2.a_b.c3d"),
        (" . ", "duo.v2._.c3d"),
    ],
)
def test_a_person_s_file_stays_in_its_folder(person: str, name: str) -> None:
    assert name_of(Path("out/duo.v2.c3d"), person) == Path("out") / name


@pytest.mark.data
@pytest.mark.parametrize(
    "name",
    ["cmu_amc/02_01.amc", "cmu_bvh/11_01.bvh", "btk/Gait.c3d", "btk/T.trc", "perfume_dance/A_test.bvh"],
)
def test_recordings_survive_the_archive(data: Path, tmp_path: Path, name: str) -> None:
    made = lm.convert(data / name, tmp_path / "x.npz")
    assert made.changes == ()
    assert lm.read(tmp_path / "x.npz") == lm.read(data / name)
