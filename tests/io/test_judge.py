"""What files do not say: unit, vertical and sides judged from the body, right on every recording that is known."""

import numpy as np
import pytest

from leitmotion import io
from leitmotion.io.conform import conform
from leitmotion.io.judge import contradict_up, judge_up, look
from leitmotion.io.judge_unit import judge_unit
from leitmotion.io.reading import Draft, Finding, Options, PointTake, SkeletonTake
from leitmotion.motion import Trajectories, rotations

NAMES = ["Hips", "LeftUpLeg", "LeftFoot", "LeftToe", "RightUpLeg", "RightFoot", "RightToe", "Chest", "Head"]
PARENTS = np.array([-1, 0, 1, 2, 0, 4, 5, 0, 7])
OFFSETS = np.array([
    [0, 0, 0], [0.1, -0.05, 0], [0, -0.85, 0], [0, -0.05, 0.15], [-0.1, -0.05, 0], [0, -0.85, 0], [0, -0.05, 0.15],
    [0, 0.3, 0], [0, 0.3, 0],
])  # fmt: skip
LIES = rotations.from_axis_angle("x", -np.pi / 2)
"""On the back: the head towards -Z."""


def take(root, quaternions=rotations.IDENTITY, *, turn=None, scale=1.0, offsets=OFFSETS):
    """A person whose root goes through places (T, 3), turned by quaternions; in other axes by a turn of the basis."""
    turn = np.eye(3) if turn is None else np.array(turn, dtype=float)
    frames = len(root)
    positions = np.tile(offsets, (frames, 1, 1))
    positions[:, 0] = root
    local = np.tile(rotations.IDENTITY, (frames, 9, 1))
    local[:, 0] = quaternions
    axis = local[..., 1:] @ turn.T
    return SkeletonTake(
        NAMES, PARENTS, scale * offsets @ turn.T, np.zeros(0, int), np.zeros((0, 3)), scale * positions @ turn.T,
        np.concatenate([local[..., :1], axis], axis=-1),
    )  # fmt: skip


def walk(rng, frames=40):
    root = np.cumsum(np.full((frames, 3), [0.01, 0, 0.03]), axis=0)
    root[:, 1] = 0.95 + rng.normal(0, 0.005, frames)
    return root


TO_FILE = {
    "y": np.eye(3),
    "z": [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
    "x": [[0, 1, 0], [-1, 0, 0], [0, 0, 1]],
    "-y": [[1, 0, 0], [0, -1, 0], [0, 0, -1]],
}


@pytest.mark.parametrize("up", TO_FILE)
def test_the_vertical_of_a_walk(rng, up):
    person = take(walk(rng), turn=TO_FILE[up])
    assert judge_up(look(person), person).value == up


@pytest.mark.parametrize("up", ["y", "z"])
def test_who_lies_down_does_not_turn_the_world(rng, up):
    root = walk(rng)
    root[10:] = [0.3, 0.1, 2.0]
    quaternions = np.tile(rotations.IDENTITY, (40, 1))
    quaternions[10:] = LIES
    person = take(root, quaternions, turn=TO_FILE[up])
    finding = judge_up(look(person), person)
    assert (finding.value, finding.how) == (up, "guessed")


def test_a_rest_pose_in_odd_axes_does_not_either(rng):
    """Files whose bones lie along X at rest stand up by their rotations."""
    odd = OFFSETS @ np.array(TO_FILE["x"]).T
    stand = rotations.from_matrix(np.array(TO_FILE["x"], dtype=float).T)
    person = take(walk(rng), stand, offsets=odd)
    assert judge_up(look(person), person).value == "y"


@pytest.mark.parametrize(
    ("metres", "unit"),
    [(1.0, "m"), (0.01, "cm"), (0.001, "mm"), (0.0254, "inch"), (0.0254 / 0.45, "1/0.45 inch")],
)
@pytest.mark.parametrize("size", [0.85, 1.0, 1.2])
def test_the_unit_of_a_body(rng, metres, unit, size):
    person = take(size * walk(rng), scale=1.0 / metres, offsets=size * OFFSETS)
    finding, warning = judge_unit(person, look(person))
    assert finding.value == unit
    assert ("a child's" in warning) == (unit == "inch")  # in centimetres it would be one
    assert bool(warning) == (unit == "inch")
    assert "from ankle to head" in finding.reason


def test_a_body_of_no_usual_size_is_told(rng):
    person = take(walk(rng), scale=1 / 0.16)
    assert "--unit" in judge_unit(person, look(person))[1]


@pytest.mark.parametrize(
    ("height", "metres", "unit"),
    [
        (1.0, 0.01, "cm"), (1.0, 1.0, "m"), (1.0, 0.001, "mm"), (0.6, 1.0, "m"), (0.6, 0.001, "mm"), (2.1, 0.01, "cm"),
        (1.0, 0.0254 / 0.45, "1/0.45 inch"),
    ],
)  # fmt: skip
def test_a_child_is_measured_in_metric_units_rather_than_a_giant_in_inches(rng, height, metres, unit):
    size = height / 1.75
    person = take(size * walk(rng), scale=1.0 / metres, offsets=size * OFFSETS)
    finding, warning = judge_unit(person, look(person))
    assert finding.value == unit
    assert ("--unit" in warning) == (height <= 1.0)


def test_a_guessed_unit_is_believed_only_of_an_adult(rng):
    """The names of a known skeleton suggest its archive's unit; what was converted since has another."""
    supposed = Finding("1/0.45 inch", "guessed", "known by its joints")
    for metres, unit in ((0.0254 / 0.45, "1/0.45 inch"), (0.01, "cm"), (1.0, "m"), (0.001, "mm")):
        draft = Draft([take(walk(rng), scale=1 / metres)], rate=Finding(30.0, "read", ""), unit=supposed)
        (motion,), findings = conform(draft, Options(), "clip")
        assert findings["unit"].value == unit
        np.testing.assert_allclose(motion.skeleton.offsets, OFFSETS, atol=1e-12)
    stated = Finding("inch", "read", "stated")
    draft = Draft([take(walk(rng), scale=100)], rate=Finding(30.0, "read", ""), unit=stated)
    assert conform(draft, Options(), "clip")[1]["unit"] is stated


def test_a_stated_vertical_gives_way_only_to_a_ground(rng):
    points = look(take(walk(rng), turn=TO_FILE["x"]))
    stated = Finding("z", "read", "stated")
    assert contradict_up(stated, points).value == "x"
    assert contradict_up(Finding("x", "read", "stated"), points) is None
    lying = look(
        take(np.tile([0.3, 0.1, 2.0], (40, 1)) + rng.normal(0, 0.01, (40, 3)), LIES, turn=TO_FILE["z"])
    )
    assert contradict_up(stated, lying) is None


def test_only_the_vertical_of_a_screen_gives_way(rng, tmp_path):
    """An archive is Y up, whatever its body does: here it lies along X and rises."""
    places = look(take(walk(rng), turn=TO_FILE["x"]))
    lifted = Trajectories(tuple(NAMES), places, 30.0)
    assert contradict_up(Finding("y", "read", "stated"), places) is not None
    path = io.save(lifted, tmp_path / "lifted.npz")
    assert io.open_recording(path).findings["up"].value == "y"
    assert io.read(path).replace(name="") == io.load(path) == lifted
    for may_err, up in ((True, "x"), (False, "y")):
        draft = Draft(
            [PointTake(NAMES, places)], rate=Finding(30.0, "read", ""), unit=Finding("m", "read", ""),
            up=Finding("y", "read", "stated"), up_may_err=may_err,
        )  # fmt: skip
        assert conform(draft, Options(), "clip")[1]["up"].value == up
        assert bool(draft.warnings) == may_err


def test_points_without_telling_names_are_long_along_the_vertical(rng):
    places = rng.uniform(-0.2, 0.2, (20, 6, 3)) + np.linspace(0, 1.7, 6)[:, None] * [0, 0, 1]
    points = PointTake([f"m{k}" for k in range(6)], places)
    assert judge_up(places, points).value == "z"
    nothing = PointTake(["a"], np.full((5, 1, 3), np.nan))
    assert judge_up(nothing.positions, nothing).value == "y"
    assert judge_unit(nothing, nothing.positions)[0].value == "m"


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "unit", "up", "rate"),
    [
        ("bandai_namco/dataset-1_dance-short_normal_001.bvh", "cm", "y", 30),
        ("bandai_namco/dataset-1_dash_active_001.bvh", "cm", "y", 30), ("cmu_bvh/10_01.bvh", "cm", "y", 120),
        ("cmu_bvh/jumping_jacks.bvh", "1/0.45 inch", "y", 30), ("perfume_dance/A_test.bvh", "cm", "y", 40),
        ("perfume_dance/B_test.bvh", "cm", "y", 40), ("animated_drawings/dab.bvh", None, "z", 30),
        ("animated_drawings/jumping.bvh", None, "z", 120000 / 1001),
        ("animated_drawings/jesse_dance.bvh", "cm", "y", 100),
        ("pymo/AV_8Walk_Meredith_HVHA_Rep1.bvh", "inch", "y", 120), ("cmu86/86_01.amc", "1/0.45 inch", "y", 120),
        ("hdm05/lieDownFloor/HDM_bd_lieDownFloor_001_120.amc", "1/0.45 inch", "y", 120),
    ],
)  # fmt: skip
def test_real_recordings(data, name, unit, up, rate):
    reading = io.open_recording(data / name)
    findings = reading.findings
    assert findings["up"].value == up
    assert findings["rate"].value == rate
    if unit is None:  # a body of about 42 units: nobody knows what they are
        assert any("--unit" in warning for warning in reading.warnings)
    else:
        assert findings["unit"].value == unit


@pytest.mark.data
def test_a_person_who_lies_in_a_bvh_keeps_the_vertical(data, tmp_path):
    motion = io.read(data / "hdm05" / "lieDownFloor" / "HDM_bd_lieDownFloor_001_120.amc")
    reading = io.open_recording(io.write(motion, tmp_path / "lies.bvh"))
    assert reading.findings["up"].value == "y"


def test_the_size_of_a_cloud_of_points_is_that_of_its_outermost(rng):
    cloud = rng.normal(size=(1, 20_000, 3))
    cloud *= np.array([250.0, 850.0, 150.0]) / np.linalg.norm(cloud, axis=-1, keepdims=True)
    many, few = (PointTake([f"p{k}" for k in range(n)], cloud[:, :n]) for n in (20_000, 199))
    sizes = [judge_unit(points, points.positions)[0].reason for points in (many, few)]
    assert sizes == [
        "with it the body measures 1.70 m across, an adult's about 1.7 m",
        "with it the body measures 1.69 m across, an adult's about 1.7 m",
    ]
