"""AMASS archives: SMPL's rotations on a mean adult, and nothing unpickled that nobody trusts."""

import io as bytes_io
import pickle
import zipfile

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import leitmotion as lm
from leitmotion import io
from leitmotion.io.joint_sets import HUMANML3D, SMPL, SMPL_H, SMPL_X
from leitmotion.io.smpl import BODIES, mean_adult
from leitmotion.motion import FormatError, forward_kinematics

SETS = (HUMANML3D, SMPL, SMPL_H, SMPL_X)
UPRIGHT = [np.pi / 2, 0.0, 0.0]  # brings SMPL's template, Y up, to Z up


@pytest.fixture
def motion(rng):
    """Make poses (T, J, 3) of a person who stands, and trans (T, 3)."""

    def make(joints, frames=40, spread=0.2):
        poses = rng.normal(0, spread, (frames, len(joints.joints), 3))
        poses[:, 0] = UPRIGHT
        return poses, np.array([1.0, 2.0, 0.93]) + rng.normal(0, 0.01, (frames, 3))

    return make


def placed(poses, trans, joints):
    """Global positions by matrices in the archive's axes, written plainly."""
    parents, offsets = mean_adult(joints)
    turns = Rotation.from_rotvec(poses.reshape(-1, 3)).as_matrix().reshape(*poses.shape, 3)
    frames, places = turns.copy(), np.empty_like(poses)
    places[:, 0] = trans
    for joint, parent in enumerate(parents):
        if parent >= 0:
            frames[:, joint] = frames[:, parent] @ turns[:, joint]
            places[:, joint] = places[:, parent] + frames[:, parent] @ offsets[joint]
    return places


@pytest.mark.parametrize("joints", SETS)
def test_joints_stand_where_matrices_put_them(tmp_path, motion, joints):
    poses, trans = motion(joints)
    np.savez(tmp_path / "a.npz", trans=trans, gender="female", mocap_framerate=100.0, betas=np.zeros(16),
             poses=poses.reshape(len(poses), -1))  # fmt: skip
    reading = io.open_recording(tmp_path / "a.npz")
    read = reading.recordings[0]
    assert read.skeleton.names == joints.joints
    assert read.rate == 100.0
    assert [reading.findings[what].how for what in ("unit", "up", "rate", "joints")] == ["read"] * 4
    expected = placed(poses, trans, joints) @ np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
    np.testing.assert_allclose(forward_kinematics(read).positions, expected, atol=1e-9)
    assert any("mean adult" in warning for warning in reading.warnings)


def test_a_standing_person_is_upright_faces_front_and_rests_in_a_t(tmp_path, motion):
    poses, trans = motion(SMPL_H, spread=0.0)
    np.savez(tmp_path / "a.npz", poses=poses.reshape(len(poses), -1), trans=trans, mocap_frame_rate=60)
    told = lm.info(tmp_path / "a.npz")
    assert told.findings["facing"].value == pytest.approx(0.0, abs=1e-9)
    assert told.findings["size"].value == pytest.approx(1.46, abs=0.01)
    read = io.read(tmp_path / "a.npz")
    at = dict(zip(read.skeleton.names, forward_kinematics(read).positions[0]))
    np.testing.assert_allclose(at["pelvis"][1], 0.93, atol=0.05)
    assert at["left_wrist"][0] - at["right_wrist"][0] == pytest.approx(2 * 0.4615 * 1.7)
    assert abs(at["left_ankle"][1]) < 0.1
    assert at["left_foot"][2] > at["left_ankle"][2]
    rest = read.replace(local_rotations=np.tile([1.0, 0, 0, 0], (len(read), 52, 1)))
    np.testing.assert_allclose(
        forward_kinematics(rest).positions, forward_kinematics(read).positions, atol=1e-9
    )  # rest is upright in the house's axes, whichever the archive's


def test_rotations_in_parts_are_the_whole(tmp_path, motion):
    poses, trans = motion(SMPL_X)
    flat = poses.reshape(len(poses), -1)
    np.savez(tmp_path / "a.npz", poses=flat, trans=trans, mocap_framerate=120)
    parts = {"pose_hand": flat[:, 75:], "pose_eye": flat[:, 69:75], "pose_jaw": flat[:, 66:69]}
    parts |= {"pose_body": flat[:, 3:66], "root_orient": flat[:, :3]}
    np.savez_compressed(tmp_path / "b.npz", **parts, trans=trans, mocap_frame_rate=120)
    assert io.read(tmp_path / "a.npz") == io.read(tmp_path / "b.npz").replace(name="a")


def test_what_the_archive_does_not_say_is_guessed_and_given_wins(tmp_path, motion):
    poses, _ = motion(SMPL)
    np.savez(tmp_path / "a.npz", poses=poses)
    reading = io.open_recording(tmp_path / "a.npz")
    assert reading.findings["rate"].how == "guessed"
    assert reading.findings["rate"].value == 120.0
    assert any("the pelvis stays" in warning for warning in reading.warnings)
    assert io.read(tmp_path / "a.npz", rate=50).rate == 50.0
    turned = poses.copy()
    turned[:, 0] = 0.0
    np.savez(tmp_path / "y.npz", poses=turned)
    a, b = (forward_kinematics(io.read(tmp_path / name, **how)).positions
            for name, how in (("a.npz", {}), ("y.npz", {"up": "y"})))  # fmt: skip
    np.testing.assert_allclose(a, b, atol=1e-9)  # an archive with Y up, of which one was told


class Boom:
    def __reduce__(self):
        return (exec, ("raise SystemExit('code ran')",))


@pytest.mark.parametrize("member", ["poses", "trans", "mocap_framerate"])
def test_a_pickled_member_is_not_touched_unless_trusted(tmp_path, motion, member):
    poses, trans = motion(SMPL)
    held = {"poses": poses, "trans": trans, "mocap_framerate": np.array(120.0)}
    held[member] = np.array([Boom()], dtype=object)
    np.savez(tmp_path / "a.npz", **held)
    with pytest.raises(FormatError, match=f"its member {member} holds pickled .* can run code") as caught:
        io.read(tmp_path / "a.npz")
    assert "--trust" in caught.value.remedy
    with pytest.raises(SystemExit, match="code ran"):
        io.read(tmp_path / "a.npz", trust=True)


def test_pickled_members_that_are_not_needed_do_no_harm(tmp_path, motion):
    poses, trans = motion(SMPL)
    np.savez(tmp_path / "a.npz", gender=np.array([Boom()], dtype=object), poses=poses, trans=trans, fps=30)
    assert io.read(tmp_path / "a.npz").rate == 30.0


def test_ours_and_theirs_share_the_extension(tmp_path, motion):
    poses, trans = motion(SMPL)
    np.savez(tmp_path / "a.npz", trans=trans, poses=poses, fps=30)
    read = io.read(tmp_path / "a.npz")
    io.save(read, tmp_path / "ours.npz")
    assert io.read(tmp_path / "ours.npz") == read
    for name in ("a.npz", "ours.npz"):
        (tmp_path / "stdin").write_bytes((tmp_path / name).read_bytes())
        assert io.read(tmp_path / "stdin").skeleton == read.skeleton


@pytest.mark.parametrize(
    ("held", "match"),
    [
        ({"a": np.zeros(3)}, "expected the members poses and trans of an AMASS archive, found a"),
        ({"poses": np.zeros((5, 100))}, "expected poses of 66, 72, 156, 165 numbers a frame .* found 5 × 100"),
        ({"poses": np.zeros((0, 72))}, "found 0 × 72"),
        ({"poses": np.zeros(72)}, "found 72"),
        ({"poses": np.full((5, 72), np.nan)}, "expected finite numbers in poses"),
        ({"poses": np.zeros((5, 72)), "trans": np.zeros((4, 3))}, "expected trans of 5 × 3 numbers, found 4 × 3"),
        ({"poses": np.zeros((5, 72)), "fps": np.array(0)}, "expected fps to be a rate in hertz, found 0"),
        ({"poses": np.array(["a", "b"])}, "expected numbers in poses, found something else"),
        ({"root_orient": np.zeros((5, 3)), "pose_body": np.zeros((4, 63))}, "of one length, found others"),
    ],
)  # fmt: skip
def test_what_is_no_motion_is_one_sentence(tmp_path, held, match):
    np.savez(tmp_path / "a.npz", **held)
    with pytest.raises(FormatError, match=match):
        io.read(tmp_path / "a.npz")


def test_a_damaged_or_swollen_member_is_one_sentence(tmp_path, motion):
    poses, trans = motion(SMPL)
    np.savez(tmp_path / "a.npz", poses=poses, trans=trans)
    content = bytearray((tmp_path / "a.npz").read_bytes())
    content[5000] ^= 0xFF
    (tmp_path / "a.npz").write_bytes(content)
    with pytest.raises(FormatError, match="its member poses is damaged"):
        io.read(tmp_path / "a.npz")
    (tmp_path / "a.npz").write_bytes(content[: len(content) // 2])
    with pytest.raises(FormatError, match="is no archive or is damaged"):
        io.read(tmp_path / "a.npz")
    swollen = bytes_io.BytesIO()
    np.save(swollen, np.zeros((1_500_000, 72), dtype=np.int8))
    with zipfile.ZipFile(tmp_path / "b.npz", "w", zipfile.ZIP_DEFLATED) as box:
        box.writestr("poses.npy", swollen.getvalue())
    with pytest.raises(FormatError, match=r"its member poses promises 0\.1 GB"):
        io.read(tmp_path / "b.npz")


def test_the_mean_adult_is_symmetric_and_has_every_joint_once():
    for joints in BODIES.values():
        parents, offsets = mean_adult(joints)
        assert (parents < np.arange(len(parents))).all()
        assert (parents == -1).sum() == 1
        index = {name: k for k, name in enumerate(joints.joints)}
        for name, k in index.items():
            if name.startswith("left_"):
                other = index[name.replace("left_", "right_")]
                np.testing.assert_allclose(offsets[k], offsets[other] * [-1, 1, 1])
                assert offsets[k].any()


def test_pickle_is_what_the_boom_would_be():
    with pytest.raises(SystemExit):  # the test above would pass for a bomb that is a dud
        pickle.loads(pickle.dumps(Boom()))
