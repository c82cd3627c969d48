"""Poses in JSON: every layout says the same of the same poses, real files of each estimator, people told apart."""

import json

import numpy as np
import pytest

import leitmotion as lm
from leitmotion import io
from leitmotion.io.joint_sets import (
    BLAZEPOSE,
    BODY_25,
    BODY_135,
    COCO_17,
    COCO_18,
    HALPE_26,
    HALPE_136,
    HUMAN36M,
    IN_IMAGES,
    IN_SPACE,
    WHOLE_BODY,
)
from leitmotion.motion import DataError, FormatError

T = 30


@pytest.fixture
def poses(rng):
    """Make pixels (T, P, 2) of a person who moves, and confidences (T, P)."""

    def make(joints, at=(300.0, 200.0)):
        count = len(joints.joints)
        body = rng.uniform(0, 120, (count, 2)) + at
        moved = body + np.cumsum(rng.normal(0, 1, (T, 1, 2)), axis=0) + rng.normal(0, 0.5, (T, count, 2))
        return moved.round(3), rng.uniform(0.2, 1, (T, count)).round(4)

    return make


def triples(points, sure):
    return np.column_stack((points, sure)).ravel().tolist()


def openpose(*poses):
    people = [{"person_id": [-1], "pose_keypoints_2d": pose, "face_keypoints_2d": []} for pose in poses]
    return {"version": 1.3, "people": people}


def put(tmp_path, document, name="a.json"):
    path = tmp_path / name
    path.write_text(json.dumps(document))
    return path


LAYOUTS = {
    "one file of OpenPose's frames": lambda points, sure: [openpose(triples(*pose)) for pose in zip(points, sure)],
    "frames by the name of their picture": lambda points, sure: {
        f"{t}.jpg": {"bodies": [{"joints": triples(*pose)}]} for t, pose in enumerate(zip(points, sure))
    },
    "frames below a name, with a rate": lambda points, sure: {
        "fps": 30, "frames": [openpose(triples(*pose)) for pose in zip(points, sure)]
    },
    "results of COCO": lambda points, sure: [
        {"image_id": t + 7, "category_id": 1, "keypoints": triples(*pose), "score": 0.9}
        for t, pose in enumerate(zip(points, sure))
    ],
    "results of AlphaPose": lambda points, sure: [
        {"image_id": f"frame{t:04d}.jpg", "category_id": 1, "keypoints": triples(*pose), "score": 2.9, "idx": [0.0]}
        for t, pose in enumerate(zip(points, sure))
    ],
    "annotations of COCO": lambda points, sure: {
        "images": [], "categories": [],
        "annotations": [{"image_id": t, "keypoints": triples(*pose)} for t, pose in enumerate(zip(points, sure))],
    },
    "MMPose": lambda points, sure: {
        "meta_info": {}, "instance_info": [
            {"frame_id": t, "instances": [{"keypoints": p.tolist(), "keypoint_scores": s.tolist()}]}
            for t, (p, s) in enumerate(zip(points, sure))
        ],
    },
    "points as objects": lambda points, sure: [
        {"keypoints": [{"x": x, "y": y, "score": s} for (x, y), s in zip(p, c)]} for p, c in zip(points, sure)
    ],
    "lists of points, each with its confidence": lambda points, sure: [
        np.column_stack(pose).tolist() for pose in zip(points, sure)
    ],
    "lists of lists of points": lambda points, sure: [[np.column_stack(pose).tolist()] for pose in zip(points, sure)],
}  # fmt: skip


@pytest.mark.parametrize("joints", IN_IMAGES, ids=lambda joints: joints.name)
@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_layout_says_the_same(tmp_path, poses, layout, joints):
    points, sure = poses(joints)
    points[4, 3], sure[4, 3] = 0.0, 0.0
    path = put(tmp_path, LAYOUTS[layout](points, sure))
    reading = io.open_recording(path)
    read = reading.recordings[0]
    assert read.names == joints.joints
    assert read.unit == "px"
    assert read.kind == "joint"
    assert read.rate == 30.0
    assert np.isnan(read.positions[4, 3]).all()
    assert np.isnan(read.positions).sum() == 2
    seen = np.isfinite(read.positions)
    np.testing.assert_allclose(read.positions[seen], (points * [1, -1])[seen])  # Y up
    np.testing.assert_allclose(read.confidence, sure)
    assert reading.findings["joints"].value == joints.name
    assert reading.findings["up"].how == "read"
    given = io.open_recording(path, rate=25)
    assert given.findings["rate"].how == "given"
    assert not any("--rate" in warning for warning in given.warnings)
    (tmp_path / "stdin").write_bytes(path.read_bytes())
    np.testing.assert_array_equal(io.read(tmp_path / "stdin").positions, read.positions)


def test_joint_sets_are_told_by_their_number_alone():
    for sets in (IN_IMAGES, IN_SPACE):
        assert len({len(joints.joints) for joints in sets}) == len(sets)
        assert all(len(set(joints.joints)) == len(joints.joints) for joints in sets)
    counts = {COCO_17: 17, COCO_18: 18, BODY_25: 25, HALPE_26: 26, BLAZEPOSE: 33, WHOLE_BODY: 133, BODY_135: 135,
              HALPE_136: 136}  # fmt: skip
    assert {joints: len(joints.joints) for joints in IN_IMAGES} == counts
    assert BODY_25.joints.index("mid_hip") == 8
    assert BODY_25.joints[10:12] == ("right_knee", "right_ankle")
    assert BODY_25.joints[19] == "left_big_toe"
    assert COCO_18.joints[11] == "left_hip"
    assert BLAZEPOSE.joints.index("right_foot_index") == 32
    assert BLAZEPOSE.joints[11] == "left_shoulder"
    assert WHOLE_BODY.joints[20] == "right_big_toe"
    assert HALPE_26.joints[21] == "right_big_toe"


@pytest.mark.parametrize("joints", IN_IMAGES, ids=lambda joints: joints.name)
def test_roles_are_found_by_the_names(tmp_path, poses, joints):
    points, sure = poses(joints)
    told = lm.info(put(tmp_path, LAYOUTS["results of COCO"](points, sure)))
    limbs = ("shoulder", "elbow", "wrist", "hip", "knee", "ankle")
    assert {f"{side}_{limb}" for side in ("left", "right") for limb in limbs} <= set(told.roles.roles)
    assert {"pelvis", "neck", "head"} <= set(told.roles.roles)


def test_a_folder_with_a_file_a_frame_is_one_recording(tmp_path, poses):
    points, sure = poses(BODY_25)
    for t in range(T):
        if t not in (11, 12):
            put(tmp_path, openpose(triples(points[t], sure[t])), f"clip_{t + 5:012d}_keypoints.json")
    (tmp_path / "readme.json").write_text("{}")
    whole = io.open_recording(tmp_path)
    read = whole.recordings[0]
    assert read.name == "clip"
    assert len(read) == T
    assert read.names == BODY_25.joints
    assert np.isnan(read.positions[11:13]).all()
    np.testing.assert_allclose(read.positions[13:], points[13:] * [1, -1])
    assert any("2 frames between the first and the last file are missing" in word for word in whole.warnings)
    assert io.read(tmp_path / "clip_000000000019_keypoints.json") == read
    assert len(io.read(f"{tmp_path}[5:20]")) == 15


def test_a_clip_whose_files_lie_far_apart_is_one_sentence(tmp_path, poses):
    points, sure = poses(BODY_25)
    for t in (0, 90000):
        put(tmp_path, openpose(triples(points[0], sure[0])), f"clip_{t}_keypoints.json")
    with pytest.raises(FormatError, match="its clip 'clip' spans 90001 frames, of which 2 are there"):
        io.read(tmp_path)


def test_people_are_told_apart_by_the_nearest_place(tmp_path, poses, rng):
    a, b = poses(COCO_17), poses(COCO_17, at=(600.0, 220.0))
    frames = []
    for t in range(T):
        people = [triples(a[0][t], a[1][t])] if t >= 3 else []
        if not 10 <= t < 14:
            people.append(triples(b[0][t], b[1][t]))
        rng.shuffle(people)
        frames.append(openpose(*people))
    reading = io.open_recording(put(tmp_path, frames))
    assert reading.people == ("1", "2")
    first, second = reading.recordings  # in the order in which they appear: b is there from the start
    assert np.isnan(first.positions[10:14]).all()
    assert np.isnan(second.positions[:3]).all()
    np.testing.assert_allclose(first.positions[14:], b[0][14:] * [1, -1])
    np.testing.assert_allclose(second.positions[3:], a[0][3:] * [1, -1])
    assert any("by the nearest place" in word for word in reading.warnings)
    with pytest.raises(DataError, match="holds 2 people: 1, 2"):
        io.read(tmp_path / "a.json")


def test_people_whom_the_file_names_keep_their_names(tmp_path, poses):
    a, b = poses(COCO_17), poses(COCO_17)  # in one place
    results = [
        {"image_id": t, "keypoints": triples(points[t], sure[t]), "track_id": who}
        for t in range(T)
        for who, (points, sure) in ((8, a), (3, b))
    ]
    reading = io.open_recording(put(tmp_path, results))
    assert reading.people == ("8", "3")
    np.testing.assert_allclose(reading.recordings[1].positions, b[0] * [1, -1])


def test_a_fleeting_mistake_is_left_out_and_counted(tmp_path, poses):
    points, sure = poses(COCO_17)
    frames = [openpose(triples(*pose)) for pose in zip(points, sure)]
    frames[6] = openpose(triples(points[6], sure[6]), triples(points[6] + 400, sure[6]))
    reading = io.open_recording(put(tmp_path, frames))
    assert len(reading.recordings) == 1
    assert any("1 of 2 people were seen in 1 frame at most" in word for word in reading.warnings)


def landmarks(points, sure=1.0):
    return [{"x": x, "y": y, "z": z, "visibility": sure} for x, y, z in points]


@pytest.fixture
def world(rng):
    """World landmarks (T, 33, 3) in metres about the hips, y down."""
    body = rng.uniform(-0.8, 0.8, (33, 3))
    body[23], body[24] = [0.1, 0, 0], [-0.1, 0, 0]
    return (body + rng.normal(0, 0.003, (T, 33, 3))).round(5)


def test_points_in_metres_are_in_space_and_image_points_never_have_depth(tmp_path, world):
    frames = [{"pose_world_landmarks": [landmarks(frame, 0.8)]} for frame in world]
    reading = io.open_recording(put(tmp_path, frames))
    read = reading.recordings[0]
    assert read.unit == "m"
    assert read.positions.shape == (T, 33, 3)
    assert (read.confidence == 0.8).all()
    np.testing.assert_allclose(read.positions, world * [1, -1, -1])
    pictures = [{"landmarks": landmarks(frame / 3 + 0.5)} for frame in world]
    reading = io.open_recording(put(tmp_path, pictures))
    assert reading.recordings[0].unit == "relative"
    assert reading.recordings[0].positions.shape == (T, 33, 2)
    assert any("depth" in word for word in reading.warnings)
    both = [{"landmarks": landmarks(frame / 3 + 0.5), "worldLandmarks": landmarks(frame)} for frame in world]
    reading = io.open_recording(put(tmp_path, both))
    assert reading.recordings[0].unit == "m"
    assert any("points in the picture, too" in word for word in reading.warnings)


def test_joints_in_space_of_another_set_stay_in_space(tmp_path, rng):
    joints = HUMAN36M.joints
    body = rng.uniform(-0.8, 0.8, (17, 3))
    body[joints.index("head")], body[joints.index("right_ankle")] = [0, 0.8, 0], [0, -0.8, 0]
    body[[joints.index("left_ankle"), joints.index("left_knee"), joints.index("right_knee")], 1] = -0.7
    frames = (body + rng.normal(0, 0.003, (T, 17, 3))).round(5)
    read = io.read(put(tmp_path, frames.tolist()), up="y", unit="m")
    assert read.names == joints
    np.testing.assert_allclose(read.positions, frames)


@pytest.mark.parametrize("scale", [1.0, 400.0])
def test_a_third_number_is_a_confidence_where_it_is_one_everywhere(tmp_path, rng, scale):
    points, sure = rng.uniform(0.1, 0.9, (T, 17, 2)).round(4), rng.uniform(0.1, 1, (T, 17, 1)).round(4)
    read = io.read(put(tmp_path, np.concatenate((points * scale, sure), axis=2).tolist()))
    assert read.names == COCO_17.joints
    np.testing.assert_allclose(read.positions, points * scale * [1, -1])
    np.testing.assert_allclose(read.confidence, sure[..., 0])


def test_names_in_the_file_count(tmp_path, world):
    named = [
        [point | {"name": name} for name, point in zip(BLAZEPOSE.joints[::-1], landmarks(frame))]
        for frame in world
    ]
    assert io.read(put(tmp_path, named)).names == BLAZEPOSE.joints[::-1]


def test_numbers_of_pictures_that_are_no_frames(tmp_path, poses):
    points, sure = poses(COCO_17)
    results = [
        {"image_id": 1000 * t**2, "keypoints": triples(*pose)} for t, pose in enumerate(zip(points, sure), 1)
    ]
    reading = io.open_recording(put(tmp_path, results))
    assert len(reading.recordings[0]) == T
    assert any("no numbers of frames" in word for word in reading.warnings)


@pytest.mark.parametrize(
    ("text", "match"),
    [
        ("{}", "found an empty object"),
        ('{"a": 1}', "found the names a"),
        ("[1, 2]", "found a list of something else"),
        ("3", "found something else"),
        ('{"people": []}', "found nobody in any frame"),
        ('[{"people": [{"pose_keypoints_2d": []}]}]', "found nobody in any frame"),
        ('{"people": [{"pose_keypoints_2d": [1, 2, 0.5, 7]}]}', "found a list of something else"),
        ('{"people": [{"pose_keypoints_2d": ["a", "b", "c"]}]}', "expected numbers for the points of a pose"),
        ('[[[1, 2], [3, 4]], [[1, 2], ["a", 4]]]', "found something else in frame 1"),
        ("[[[1, 2], [3, 1" + "0" * 400 + "]]]", "found something else in frame 0"),
        ("[[[1, 2], [3, 4]], [[1, 2], [3, 4], [5, 6]]]", "poses of 2 × 2 and 3 × 2 points"),
        ('{"people": [', "line 1: expected JSON, found the end"),
        ('{"people":\n [1,, 2]}', "line 2: expected JSON, found ', 2]}'"),
        ("[" * 100_000, "nests too deeply"),
        ('{"frames": ' * 900 + "[]" + "}" * 900, "expected poses"),
        ('{"' + "9" * 5000 + '.jpg": {"people": []}}', "found nobody"),
        ('{"positions": ' + '{"a": ' * 100_000, "nests too deeply"),
        ('{"people": ' + "9" * 10_000 + "}", "thousands of digits"),
        ('{"segments": [{"start": 1, "stop": 2, "label": "a"}]}', "found the names segments"),
    ],
)
def test_other_json_is_one_sentence(tmp_path, text, match):
    (tmp_path / "a.json").write_text(text)
    with pytest.raises(FormatError, match=match) as caught:
        io.read(tmp_path / "a.json")
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 400


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "frames", "points", "unseen"),
    [("OP", 197, 18, 0.023), ("BP", 196, 33, 0.0), ("AP", 196, 17, 1 / 196)],
)
def test_keraal_is_upright_and_left_is_left(data, name, frames, points, unseen):
    path = data / "keraal" / f"G3-{name}-CTK-P1T1-Unknown-C-0.json"
    told = lm.info(path)
    assert (told.frames, len(told.names), told.dimensions) == (frames, points, 2)
    assert told.unseen == pytest.approx(unseen, abs=1e-3)
    assert told.findings["unit"].value == "relative"
    assert told.findings["up"].value == "-y"
    read = io.read(path)
    roles = lm.find_roles(read)
    at = {
        role: np.nanmean(read.positions[:, [read.names.index(one) for one in members]], axis=(0, 1))
        for role, members in zip(roles.roles, roles.members)
    }
    assert at["head"][1] > at["neck"][1] > at["pelvis"][1] > at["left_knee"][1] > at["left_ankle"][1]
    for limb in (
        "shoulder",
        "elbow",
        "hip",
        "knee",
    ):  # who faces the camera has the left on the picture's right
        assert at[f"left_{limb}"][0] > at[f"right_{limb}"][0]


@pytest.mark.data
def test_squats_in_pixels_and_in_metres(data):
    pixels = io.read(data / "tfjs_pose" / "pose_squats.full.json", rate=5)
    metres = io.read(data / "tfjs_pose" / "pose_squats_3d.full.json", rate=5)
    assert pixels.names == metres.names == BLAZEPOSE.joints
    assert len(pixels) == len(metres) == 65
    assert pixels.unit == "px"
    assert pixels.positions.shape[2] == 2
    assert metres.unit == "m"
    told = lm.info(metres)
    assert 1.4 < told.findings["size"].value < 1.5
    assert abs(np.degrees(told.findings["facing"].value)) < 45
    # the knees bend together in both
    hip, knee = BLAZEPOSE.joints.index("left_hip"), BLAZEPOSE.joints.index("left_knee")
    drops = [read.positions[:, hip, 1] - read.positions[:, knee, 1] for read in (pixels, metres)]
    assert np.corrcoef(*drops)[0, 1] > 0.9
