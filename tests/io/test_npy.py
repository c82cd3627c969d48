"""NumPy arrays: joints told by their number, and pickles for those who trust them."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion import io
from leitmotion.io.joint_sets import HUMANML3D, IN_SPACE, SMPL
from leitmotion.io.smpl import mean_adult
from leitmotion.motion import FormatError, Motion, Skeleton, forward_kinematics


@pytest.fixture
def places(rng):
    """Places (T, 24, 3) of SMPL's joints, metres, Y up, facing +Z."""
    parents, offsets = mean_adult(SMPL)
    turns = np.tile([1.0, 0, 0, 0], (40, 24, 1))
    positions = np.repeat(offsets[None], 40, axis=0)
    positions[:, 0, 1] = 0.93 + 0.1 * np.sin(np.linspace(0, 6, 40))
    return forward_kinematics(
        Motion(Skeleton(SMPL.joints, parents, offsets), positions, turns, rate=20)
    ).positions


@pytest.mark.parametrize("joints", IN_SPACE)
def test_joints_are_guessed_from_their_number_and_it_is_said(tmp_path, rng, joints):
    np.save(tmp_path / "a.npy", rng.uniform(-0.8, 0.8, (30, len(joints.joints), 3)).astype(np.float32))
    reading = io.open_recording(tmp_path / "a.npy")
    assert reading.recordings[0].names == joints.joints
    assert reading.recordings[0].kind == "joint"
    assert reading.findings["joints"] == io.Finding(
        joints.name, "guessed", f"because J = {len(joints.joints)}"
    )
    assert reading.findings["rate"].how == "guessed"
    assert reading.findings["rate"].value == joints.rate
    assert any(joints.name in warning for warning in reading.warnings)
    assert any("--rate" in warning for warning in reading.warnings)
    assert not any("--rate" in warning for warning in io.open_recording(tmp_path / "a.npy", rate=60).warnings)


def test_humanml3d_joints_stand_as_they_do_in_the_skeleton(tmp_path, places):
    np.save(tmp_path / "a.npy", places[:, :22])
    told = lm.info(tmp_path / "a.npy")
    assert told.names == HUMANML3D.joints
    assert told.rate == 20.0
    assert told.findings["up"].value == "y"
    assert told.findings["unit"].value == "m"
    assert told.findings["facing"].value == pytest.approx(0.0, abs=1e-9)
    assert told.findings["size"].value == pytest.approx(1.46, abs=0.01)
    np.testing.assert_allclose(io.read(tmp_path / "a.npy").positions, places[:, :22])
    np.save(tmp_path / "b.npy", 1000 * places[:, :22] @ np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]]))
    np.testing.assert_allclose(io.read(tmp_path / "b.npy").positions, places[:, :22], atol=1e-9)  # mm, Z up


def test_points_in_a_picture_have_two_numbers_or_a_confidence_beside(tmp_path, rng):
    pixels = rng.uniform(100, 400, (20, 17, 2))
    pixels[3, 4] = 0.0
    sure = rng.uniform(0.1, 1, (20, 17, 1))
    np.save(tmp_path / "a.npy", pixels)
    np.save(tmp_path / "b.npy", np.concatenate((pixels, sure), axis=2))
    a, b = io.read(tmp_path / "a.npy"), io.read(tmp_path / "b.npy")
    assert a.names == b.names
    assert a.names[5] == "left_shoulder"
    assert a.unit == "px"
    np.testing.assert_array_equal(a.positions, b.positions)
    assert np.isnan(a.positions[3, 4]).all()
    assert a.confidence is None
    np.testing.assert_array_equal(b.confidence, sure[..., 0])
    np.testing.assert_array_equal(a.positions[0], pixels[0] * [1, -1])  # y points down in a picture


@pytest.mark.parametrize(
    ("values", "match"),
    [
        (np.zeros((10, 263)), "263 numbers a frame: HumanML3D features"),
        (np.zeros((10, 66)), r"expected joints over time, \(T, J, 3\), found 10 × 66"),
        (np.zeros((0, 22, 3)), "found 0 × 22 × 3"),
        (np.array(3.0), "found one"),
        (np.array(["a"]), "expected numbers, found <U1"),
        (np.zeros((10, 22, 3), dtype=complex), "expected numbers, found complex128"),
    ],
)
def test_other_arrays_are_one_sentence(tmp_path, values, match):
    np.save(tmp_path / "a.npy", values)
    with pytest.raises(FormatError, match=match):
        io.read(tmp_path / "a.npy")


def test_a_number_of_joints_that_nobody_knows_is_numbered(tmp_path, rng):
    np.save(tmp_path / "a.npy", rng.uniform(0, 1, (10, 7, 3)))
    assert io.read(tmp_path / "a.npy").names == tuple(f"point_{k}" for k in range(7))


def test_a_damaged_array_is_one_sentence(tmp_path, rng):
    np.save(tmp_path / "a.npy", rng.uniform(0, 1, (10, 22, 3)))
    content = (tmp_path / "a.npy").read_bytes()
    for cut in (len(content) - 9, 90, 7):
        (tmp_path / "a.npy").write_bytes(content[:cut])
        with pytest.raises(FormatError, match=r"damaged|more than it holds"):
            io.read(tmp_path / "a.npy")
    (tmp_path / "a.npy").write_bytes(content.replace(b"(10, 22, 3)", b"(9999999999, 22, 3)"))
    with pytest.raises(FormatError, match=r"damaged|more than it holds"):
        io.read(tmp_path / "a.npy")


class Boom:
    def __reduce__(self):
        return (exec, ("raise SystemExit('code ran')",))


def test_a_pickle_is_read_for_those_who_trust_it_only(tmp_path):
    np.save(tmp_path / "a.npy", np.array([Boom()], dtype=object), allow_pickle=True)
    with pytest.raises(FormatError, match="pickled Python objects, which can run code") as caught:
        io.read(tmp_path / "a.npy")
    assert "--trust" in caught.value.remedy
    with pytest.raises(SystemExit, match="code ran"):
        io.read(tmp_path / "a.npy", trust=True)


def poselib(places, **changes):
    held = {
        "rotation": {"arr": np.tile(np.float32([0, 0, 0, 1]), (len(places), 24, 1))},
        "root_translation": {"arr": places[:, 0]},
        "skeleton_tree": {
            "node_names": list(SMPL.joints),
            "parent_indices": {"arr": mean_adult(SMPL)[0]},
            "local_translation": {"arr": mean_adult(SMPL)[1]},
        },
        "is_local": True,
        "fps": 50,
    }
    return np.array(held | changes, dtype=object)


def test_a_motion_of_poselib_is_a_skeleton_in_motion(tmp_path, places):
    np.save(tmp_path / "a.npy", poselib(places), allow_pickle=True)
    reading = io.open_recording(tmp_path / "a.npy", trust=True, up="y")
    motion = reading.recordings[0]
    assert motion.rate == 50.0
    assert reading.findings["rate"].how == "read"
    np.testing.assert_allclose(forward_kinematics(motion).positions, places, atol=1e-9)
    assert io.open_recording(tmp_path / "a.npy", trust=True).findings["up"].value == "z"


@pytest.mark.parametrize(
    ("changes", "match"),
    [
        ({"rotation": {"arr": np.zeros((40, 24, 4))}}, "expected unit quaternions"),
        (
            {"rotation": {"arr": np.zeros((40, 3, 4))}},
            "expected rotations of 40 frames and 24 joints, found 40 × 3",
        ),
        ({"is_local": False}, "in the world's frame"),
        ({"skeleton_tree": {}}, "is damaged: KeyError"),
        ({"fps": "fast"}, "is damaged: ValueError"),
    ],
)
def test_an_odd_motion_of_poselib_is_one_sentence(tmp_path, places, changes, match):
    np.save(tmp_path / "a.npy", poselib(places, **changes), allow_pickle=True)
    with pytest.raises(FormatError, match=match):
        io.read(tmp_path / "a.npy", trust=True)


@pytest.mark.parametrize("held", [{"a": 1}, [1, "a"], np.array(None, dtype=object)])
def test_another_pickle_is_one_sentence(tmp_path, held):
    np.save(tmp_path / "a.npy", np.array(held, dtype=object), allow_pickle=True)
    with pytest.raises(FormatError, match="expected a motion of poselib"):
        io.read(tmp_path / "a.npy", trust=True)


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "frames", "rate"),
    [("walk", 154, 60), ("dance", 902, 60), ("backflip", None, 16), ("cartwheel", None, 60)],
)
def test_amp_walks_upright(data, name, frames, rate):
    path = data / "amp_npy" / f"amp_humanoid_{name}.npy"
    with pytest.raises(FormatError, match="can run code"):
        io.read(path)
    motion = io.read(path, trust=True)
    assert motion.rate == rate
    assert frames is None or len(motion) == frames
    told = lm.info(path, trust=True)
    assert told.findings["size"].value == pytest.approx(1.34, abs=0.01)
    at = dict(zip(motion.skeleton.names, np.moveaxis(forward_kinematics(motion).positions, 1, 0)))
    lowest = np.minimum(at["left_foot"], at["right_foot"])[:, 1]
    assert np.median(at["pelvis"][:, 1]) > 0.6
    assert np.percentile(lowest, 5) > -0.1
    if name == "walk":
        way = at["pelvis"][-1] - at["pelvis"][0]
        left = (at["left_thigh"] - at["right_thigh"]).mean(axis=0)
        assert np.linalg.norm(way) > 2
        assert np.cross([0, 1, 0], way) @ left > 0
