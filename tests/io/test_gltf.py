"""glTF: what is written stands where forward kinematics says, in both files, and is what the specification asks for."""

import numpy as np
import pygltflib
import pytest

from leitmotion import io
from leitmotion.datasets import Action, compose
from leitmotion.io import glb, gltf
from leitmotion.motion import (
    FormatError,
    Motion,
    ParameterError,
    Skeleton,
    Trajectories,
    end_site_positions,
    forward_kinematics,
    rotations,
)
from oracles.gltf import Gltf

CLOSE = 1e-5  # metres


def random_motion(rng, joints=9, frames=7, rate=59.94, moving=(), roots=1):
    parents = np.array([-1] * roots + [int(rng.integers(0, k)) for k in range(roots, joints)])
    offsets = rng.normal(0, 0.3, (joints, 3))
    ends, reach = [joints - 1, joints - 1, 0], rng.normal(0, 0.1, (3, 3))
    skeleton = Skeleton(tuple(f"joint {k}" for k in range(joints)), parents, offsets, ends, reach)
    positions = np.tile(offsets, (frames, 1, 1))
    positions[:, [0, *moving]] += rng.normal(0, 0.5, (frames, 1 + len(moving), 3))
    quaternions = rotations.normalize(rng.normal(size=(frames, joints, 4)))
    return Motion(skeleton, positions, rotations.continuous(quaternions), rate, "clip")


def assert_stands(file, motion, frames):
    pose = forward_kinematics(motion)
    ends = end_site_positions(motion, pose)
    count = len(motion.skeleton)
    for frame in frames:
        world = file.world(frame / motion.rate)
        np.testing.assert_allclose(world[:count, :3, 3], pose.positions[frame], atol=CLOSE)
        np.testing.assert_allclose(world[count : count + ends.shape[1], :3, 3], ends[frame], atol=CLOSE)
        turns = rotations.as_matrix(pose.rotations[frame])
        np.testing.assert_allclose(world[:count, :3, :3], turns, atol=CLOSE)


@pytest.mark.parametrize("write", [gltf.write, glb.write])
@pytest.mark.parametrize(
    "how", [{}, {"moving": (3, 7)}, {"roots": 3}, {"joints": 1}, {"joints": 260, "frames": 2}]
)
def test_every_node_stands_where_forward_kinematics_says(rng, write, how):
    motion = random_motion(rng, **how)
    assert_stands(Gltf(write(motion)), motion, range(len(motion)))


@pytest.mark.data
@pytest.mark.parametrize(
    "name",
    [
        "cmu_amc/01_01.amc",
        "cmu_bvh/131_01.bvh",
        "bandai_namco/dataset-1_walk_normal_001.bvh",
        "perfume_dance/A_test.bvh",
    ],
)
def test_real_recordings_stand_where_forward_kinematics_says(data, name):
    motion = io.read(data / name)
    assert_stands(Gltf(glb.write(motion)), motion, (0, len(motion) // 2, len(motion) - 1))


def test_both_files_say_the_same(tmp_path, rng):
    motion = random_motion(rng)
    text = Gltf(io.write(motion, tmp_path / "clip.gltf").read_bytes())
    binary = Gltf(io.write(motion, tmp_path / "clip.glb").read_bytes())
    assert text.document == binary.document
    assert text.buffer == binary.buffer


def test_the_tree_the_names_the_rate_and_the_program_are_kept(rng):
    motion = random_motion(rng, roots=2)
    file = Gltf(gltf.write(motion))
    names = [node["name"] for node in file.nodes]
    assert names[:9] == list(motion.skeleton.names)
    assert names[9:] == ["joint 8_end", "joint 8_end2", "joint 0_end", "clip", "clip bones"]
    parents = np.array(file.parents()[:9])
    np.testing.assert_array_equal(
        np.where(parents == names.index("clip"), -1, parents), motion.skeleton.parents
    )
    assert file.document["scenes"][0]["extras"] == {"rate": 59.94, "frames": 7}
    assert file.document["asset"]["generator"].startswith("Leitmotion ")


def test_keys_stand_at_the_frames_and_only_on_what_moves(rng):
    motion = random_motion(rng, frames=50, moving=(4,))
    still = np.array(motion.local_rotations)
    still[:, 2] = rotations.IDENTITY
    still[:, 3] = still[0, 3]
    moved = Gltf(gltf.write(motion.replace(local_rotations=still))).moved()
    assert {name for name, path in moved if path == "translation"} == {"joint 0", "joint 4"}
    turning = {name: len(times) for (name, path), (times, _) in moved.items() if path == "rotation"}
    assert turning == {f"joint {k}": 1 if k == 3 else 50 for k in range(9) if k != 2}
    np.testing.assert_array_equal(moved["joint 0", "translation"][0], motion.times.astype(np.float32))


def test_a_joint_that_always_stands_off_its_offset_gets_one_key(rng):
    motion = random_motion(rng)
    positions = np.array(motion.local_positions)
    positions[:, 5] = [1.0, 2.0, 3.0]
    motion = motion.replace(local_positions=positions)
    file = Gltf(gltf.write(motion))
    np.testing.assert_array_equal(file.moved()["joint 5", "translation"][1], [[1.0, 2.0, 3.0]])
    assert_stands(file, motion, range(len(motion)))


def test_what_never_moves_has_no_animation():
    skeleton = Skeleton(("a", "b"), [-1, 0], [[0, 1, 0], [0.5, 0, 0]])
    still = np.tile(rotations.IDENTITY, (4, 2, 1))
    motion = Motion(skeleton, np.tile(skeleton.offsets, (4, 1, 1)), still, 30)
    file = Gltf(gltf.write(motion))
    assert "animations" not in file.document
    assert_stands(file, motion, [0])


def test_the_skin_lies_on_the_bones(rng):
    motion = random_motion(rng, joints=12)
    file = Gltf(glb.write(motion))
    pose = forward_kinematics(motion)
    parents, ends = motion.skeleton.parents, motion.skeleton.end_parents
    heads = np.concatenate((parents[parents >= 0], ends))
    bare = sorted(set(range(12)) - set(heads.tolist()))
    for frame in (0, 6):
        corners = file.skinned(file.world(frame / motion.rate))
        assert len(corners) == len(heads) + len(bare)
        tips = np.concatenate((pose.positions[frame][parents >= 0], end_site_positions(motion, pose)[frame]))
        np.testing.assert_allclose(corners[: len(heads), 0], pose.positions[frame][heads], atol=CLOSE)
        np.testing.assert_allclose(corners[: len(heads), 5], tips, atol=CLOSE)
        np.testing.assert_allclose(
            corners[len(heads) :].mean(axis=1), pose.positions[frame][bare], atol=CLOSE
        )


def test_a_bone_without_length_has_no_shape_of_its_own():
    skeleton = Skeleton(("a", "b"), [-1, 0], [[0, 1, 0], [0, 0, 0]])
    motion = Motion(skeleton, skeleton.offsets[None], np.tile(rotations.IDENTITY, (1, 2, 1)), 30)
    assert len(Gltf(gltf.write(motion)).skinned(np.tile(np.eye(4), (4, 1, 1)))) == 2  # a mark a joint


# --- points


@pytest.mark.parametrize("write", [gltf.write, glb.write])
def test_points_stay_where_they_were_last_seen_in_size_0(rng, write):
    places = rng.normal(size=(30, 4, 3))
    gaps = {0: slice(0, 5), 1: slice(10, 20), 2: slice(0, 30), 3: slice(25, 30)}
    for point, frames in gaps.items():
        places[frames, point] = np.nan
    points = Trajectories(tuple("ABCD"), places, 100, name="gaps")
    file = Gltf(write(points))
    assert [node["name"] for node in file.nodes] == ["A", "B", "C", "D", "gaps"]
    last = {0: 5, 1: 9, 3: 24}
    for frame in range(30):
        world = file.world(frame / 100)
        for point, gap in gaps.items():
            unseen = gap.start <= frame < gap.stop
            size = np.linalg.norm(world[point, :3, :3], axis=0)
            np.testing.assert_allclose(size, 0.0 if unseen else 1.0, atol=1e-12)
            if not unseen:
                np.testing.assert_allclose(world[point, :3, 3], places[frame, point], atol=CLOSE)
            elif point in last:
                np.testing.assert_allclose(world[point, :3, 3], places[last[point], point], atol=CLOSE)
    scales = {name: times for (name, path), (times, _) in file.moved().items() if path == "scale"}
    assert {name: len(times) for name, times in scales.items()} == {"A": 2, "B": 3, "D": 2}


@pytest.mark.data
@pytest.mark.parametrize(
    "name", ["btk/PiG_Motion3_FF.c3d", "pycgm/Movement_trial.c3d", "opensim/motion_capture_walk.trc"]
)
def test_markers_of_real_recordings_stand_where_they_were_seen(data, name):
    points = io.read(data / name)
    file = Gltf(glb.write(points))
    for frame in (0, len(points) // 2, len(points) - 1):
        world = file.world(frame / points.rate)[: len(points.names)]
        seen = np.isfinite(points.positions[frame]).all(axis=1)
        np.testing.assert_allclose(world[seen, :3, 3], points.positions[frame, seen], atol=CLOSE)
        assert not world[~seen, :3, :3].any()


# --- others


@pytest.mark.parametrize("extension", ["gltf", "glb"])
def test_a_public_reader_finds_the_same(tmp_path, extension):
    motion = compose([Action("squat", 1)], seed=1, rate=30).motion
    path = io.write(motion, tmp_path / f"squat.{extension}")
    theirs = pygltflib.GLTF2().load(str(path))
    ours = Gltf(path.read_bytes())
    assert [node.name for node in theirs.nodes] == [node["name"] for node in ours.nodes]
    assert theirs.asset.generator == ours.document["asset"]["generator"]
    assert len(theirs.animations[0].channels) == len(ours.moved())
    accessor = theirs.accessors[theirs.animations[0].samplers[0].input]
    assert (accessor.count, accessor.min, accessor.max) == (
        len(motion),
        [0.0],
        [float(np.float32(motion.times[-1]))],
    )
    blob = theirs.binary_blob() or theirs.get_data_from_buffer_uri(theirs.buffers[0].uri)
    assert bytes(blob)[: len(ours.buffer)] == ours.buffer


@pytest.mark.parametrize("write", [gltf.write, glb.write])
@pytest.mark.parametrize(
    ("recording", "match"),
    [
        (Trajectories(("A",), np.ones((2, 1, 2)), 30, "px"), "in space, in metres, got points with 2 coordinates"),
        (Trajectories(("A",), np.ones((2, 1, 3)), 30, "relative"), "got points in the unit 'relative'"),
        (Trajectories((), np.ones((2, 0, 3)), 30), "at least one, got none"),
        (Trajectories(("A",), np.ones((0, 1, 3)), 30), "at least one frame, got none"),
        (Trajectories(("A",), np.full((1, 1, 3), 1e39), 30), "32-bit floats, got a place of 1e\\+39 m"),
        (Trajectories(("\ud800",), np.ones((2, 1, 3)), 30), "cannot hold .* in a name"),
        (Trajectories(("A",), np.zeros((2, 1, 3)), 1e50), "floats, in which frames of 1e-50 s at 2e-50 s are one"),
        ("clip", "holds a recording, got a str"),
    ],
)  # fmt: skip
def test_what_a_gltf_cannot_hold_is_one_sentence(write, recording, match):
    with pytest.raises(ParameterError, match=match):
        write(recording)


@pytest.mark.parametrize("extension", ["gltf", "glb"])
def test_it_is_written_only(tmp_path, rng, extension):
    path = io.write(random_motion(rng), tmp_path / f"clip.{extension}")
    with pytest.raises(FormatError, match="files are not read"):
        io.read(path)
    with pytest.raises(ParameterError, match="options none, got unit"):
        io.write(random_motion(rng), path, unit="cm")
