"""Real recordings: every skeleton of the data folder is understood."""

import numpy as np
import pytest

from leitmotion.body import ANALYSIS_ROLES, embody, find_roles
from leitmotion.motion import Motion

io = pytest.importorskip("leitmotion.io")

PEOPLE = (
    "cmu86",
    "cmu_amc",
    "cmu_bvh",
    "hdm05",
    "mocap6",
    "bandai_namco",
    "perfume_dance",
    "pymo",
    "animated_drawings",
)
FORWARDS = (
    "cmu86/86_01.amc",
    "cmu_amc/02_01.amc",
    "cmu_amc/07_05-walk.amc",
    "cmu_amc/09_06-run.amc",
    "cmu_bvh/cmu_12_01_walk.bvh",
    "cmu_bvh/11_01.bvh",
    "cmu_bvh/forward-dribble.bvh",
    "bandai_namco/dataset-1_walk_normal_001.bvh",
    "bandai_namco/dataset-2_run_normal_038.bvh",
    "pymo/AV_8Walk_Meredith_HVHA_Rep1.bvh",
)
BACKWARDS = ("cmu_bvh/backward-dribble.bvh", "bandai_namco/dataset-1_walk-back_normal_001.bvh")


def heading_against_facing(body):
    """Angle between where the pelvis goes and where the body faces, while it goes, (N,) radians."""
    pelvis = body.positions[:, body.roles.index("pelvis")][:, [0, 2]]
    half = max(1, round(body.rate / 4))
    velocity = (pelvis[2 * half :] - pelvis[: -2 * half]) / (2 * half) * body.rate
    facing = body.facing[half : half + len(velocity)]
    going = np.linalg.norm(velocity, axis=1) > 0.5
    return np.angle(np.exp(1j * (np.arctan2(velocity[:, 0], velocity[:, 1]) - facing)))[going]


@pytest.mark.data
@pytest.mark.parametrize("folder", PEOPLE)
def test_every_skeleton_is_understood(data, folder):
    files = [path for path in sorted((data / folder).rglob("*")) if path.suffix in (".amc", ".bvh")]
    assert files
    for path in files[:60:3] if folder == "bandai_namco" else files:
        motion = io.read(path)
        assert isinstance(motion, Motion)
        found = find_roles(motion)
        assert set(ANALYSIS_ROLES) <= set(found.roles), path.name
        assert found.confidence.min() >= 0.8, path.name
        assert found.confidence[found.roles.index("left_elbow")] == 1.0, path.name
        body = embody(motion, found)
        assert np.isfinite(body.positions).all()
        if folder != "animated_drawings":  # two of whose files carry no hint of their unit
            assert 1.1 < body.size < 1.7, path.name
        hips = (
            body.positions[:, body.roles.index("left_hip")] - body.positions[:, body.roles.index("right_hip")]
        )
        left = np.stack((np.cos(body.facing), -np.sin(body.facing)), axis=1)
        assert (np.einsum("ti,ti->t", hips[:, [0, 2]], left) > 0).mean() > 0.9, path.name


@pytest.mark.data
@pytest.mark.parametrize("file", FORWARDS)
def test_who_walks_forwards_faces_there(data, file):
    angle = heading_against_facing(embody(io.read(data / file)))
    assert len(angle)
    assert (np.abs(angle) < np.pi / 4).mean() > 0.95


@pytest.mark.data
@pytest.mark.parametrize("file", BACKWARDS)
def test_who_walks_backwards_does_not(data, file):
    angle = heading_against_facing(embody(io.read(data / file)))
    assert (np.abs(angle) > 3 * np.pi / 4).mean() > 0.9


@pytest.mark.data
def test_lying_down_keeps_the_facing(data):
    body = embody(io.read(next((data / "hdm05" / "lieDownFloor").glob("*.amc"))))
    assert np.ptp(body.facing) < np.pi / 2
    assert np.abs(np.diff(body.facing)).max() * body.rate < 2.0


@pytest.mark.data
def test_amc_and_bvh_of_one_trial_face_the_same_way(data):
    amc, bvh = (embody(io.read(data / path)) for path in ("cmu_amc/01_01.amc", "cmu_bvh/01_01.bvh"))
    turn = np.angle(np.exp(1j * (amc.facing - bvh.facing[1:])))  # the BVH begins with one frame in T-pose
    assert np.abs(turn).max() < np.radians(10)
    for role in ("left_knee", "right_ankle", "pelvis"):
        apart = amc.positions[:, amc.roles.index(role)] - bvh.positions[1:, bvh.roles.index(role)]
        assert np.abs(apart).max() < 2e-3, role


@pytest.mark.data
@pytest.mark.parametrize(
    ("file", "missing"),
    [
        ("btk/T.trc", set()),
        ("btk/ballet_reduced.trc", set()),
        ("pycgm/Movement_trial.c3d", set()),
        ("btk/Gait.c3d", {"head"}),
        ("btk/Gait.trc", {"head"}),
        ("opensim/motion_capture_walk.trc", {"head"}),
        ("opensim/subject02_running.trc", {"left_knee", "right_knee", "left_ankle", "right_ankle"}),
    ],
)
def test_marker_sets_are_understood(data, file, missing):
    recording = io.read(data / file)
    found = find_roles(recording)
    assert set(ANALYSIS_ROLES) - set(found.roles) == missing
    assert found.confidence.max() <= 0.9, "no marker is a joint"
    assert found.confidence.min() >= 0.4
    assert 1.3 < embody(recording).size < 1.7


@pytest.mark.data
@pytest.mark.parametrize(
    "file",
    [
        "btk/Gait.c3d",
        "btk/Gait.trc",
        "btk/PiG_Motion3_FF.c3d",
        "bmclab/walk.trc",
        "opensim/motion_capture_walk.trc",
    ],
)
def test_markers_that_walk_forwards_face_there(data, file):
    angle = heading_against_facing(embody(io.read(data / file)))
    assert len(angle)
    assert (np.abs(angle) < np.pi / 4).all()


@pytest.mark.data
def test_left_handed_axes_are_doubted(data):
    """Its left side is on the right of where its toes point."""
    found = find_roles(io.read(data / "bmclab" / "walk1.trc"))
    sure = dict(zip(found.roles, found.confidence))
    assert sure["left_knee"] == 0.45
    assert sure["pelvis"] == 0.9


@pytest.mark.data
def test_numbered_channels_have_no_roles(data):
    recording = io.read(data / "btk" / "Dance.c3d")
    body = embody(recording)
    assert find_roles(recording).roles == ()
    assert body.roles == recording.names
    assert not body.facing.any()
