import numpy as np
import pytest

from leitmotion.datasets import ACTIONS, Action, compose, compose_session, human_skeleton
from leitmotion.motion import ParameterError, end_site_positions, forward_kinematics, rotations

KICKS = [Action("left side kick", 2), Action("still", period_s=1.0), Action("right side kick", 2)]


@pytest.fixture(scope="module")
def session():
    return compose_session(seed=3)


@pytest.fixture(scope="module")
def positions(session):
    return forward_kinematics(session.motion).positions


def soles(motion):
    """Heels and toe tips, (T, 4, 3)."""
    on = [motion.skeleton.names[j] for j in motion.skeleton.end_parents]
    places = end_site_positions(motion, forward_kinematics(motion))
    return places[:, [k for k, name in enumerate(on) if name.endswith(("Foot", "ToeBase"))]]


def mirror_image(skeleton, positions):
    """Left and right exchanged, x negated."""
    other = {"Left": "Right", "Right": "Left"}
    partners = [
        next((other[side] + name.removeprefix(side) for side in other if name.startswith(side)), name)
        for name in skeleton.names
    ]
    return positions[:, [skeleton.names.index(name) for name in partners]] * [-1.0, 1.0, 1.0]


def of(session, label):
    return [(start, stop) for start, stop, name, _ in session.stretches if name == label]


def test_session_holds_what_it_promises(session):
    counts = {name: session.cycles.labels.count(name) for name in ACTIONS}
    assert counts == {
        "still": 0, "walk": 8, "jumping jack": 5, "squat": 4,
        "left side kick": 3, "right side kick": 3, "arm raise": 3,
    }  # fmt: skip
    assert 55 < session.motion.duration < 65
    assert len(of(session, "walk")) == 2


def test_stretches_cover_the_recording_without_gap_or_overlap(session):
    stretches = session.stretches
    assert stretches.starts[0] == 0
    assert stretches.stops[-1] == len(session.motion)
    np.testing.assert_array_equal(stretches.stops[:-1], stretches.starts[1:])


def test_each_cycle_lies_in_a_stretch_of_its_action(session):
    for start, stop, label, _ in session.cycles:
        assert any(a <= start and stop <= b for a, b in of(session, label))


def test_cycles_of_a_stretch_follow_one_another_at_a_persons_tempo(session):
    lengths = {}
    for start, stop, label, _ in session.cycles:
        lengths.setdefault(label, []).append((stop - start) / session.motion.rate)
    for label, seconds in lengths.items():
        usual = Action(label).movement.period_s
        assert max(seconds) <= usual / 0.92 + 0.01
        assert min(seconds) >= usual / 1.08 - 0.01
        assert np.ptp(seconds) > 0.01


def test_bones_keep_their_length(session, positions):
    skeleton = session.motion.skeleton
    child = np.arange(1, len(skeleton))
    bones = np.linalg.norm(positions[:, child] - positions[:, skeleton.parents[child]], axis=-1)
    wanted = np.linalg.norm(skeleton.offsets[child], axis=-1)
    np.testing.assert_allclose(bones, np.broadcast_to(wanted, bones.shape), atol=1e-12)


def test_rotations_are_unit_and_continuous(session):
    q = session.motion.local_rotations
    np.testing.assert_allclose(np.linalg.norm(q, axis=-1), 1.0, atol=1e-12)
    assert (np.einsum("tjk,tjk->tj", q[1:], q[:-1]) > 0.9).all()


def test_feet_never_sink_into_the_floor(session):
    assert soles(session.motion)[..., 1].min() > -0.005


def test_a_foot_is_on_the_floor_but_in_a_jump(session):
    lowest = soles(session.motion)[..., 1].min(axis=1)
    jumping = np.zeros(len(lowest), dtype=bool)
    for start, stop in of(session, "jumping jack"):
        jumping[start:stop] = True
    assert lowest[~jumping].max() < 0.02
    assert lowest[jumping].max() > 0.04


def test_hips_fall_freely_in_a_jump():
    motion = compose([Action("jumping jack", 4)], variation=0, rate=240).motion
    aloft = soles(motion)[..., 1].min(axis=1) > 0.03
    fall = np.gradient(np.gradient(motion.local_positions[:, 0, 1])) * 240**2
    inside = aloft & np.roll(aloft, 3) & np.roll(aloft, -3)
    np.testing.assert_allclose(fall[inside], -9.81, rtol=0.05)


def test_a_standing_foot_stays_where_it_stands():
    """Of a walk without noise, the ball of a foot that is down moves less than a centimetre from strike to leave."""
    motion = compose([Action("walk", 4, turn=0.5)], variation=0).motion
    places = forward_kinematics(motion).positions
    for side in ("Left", "Right"):
        ball = places[:, motion.skeleton.index(side + "ToeBase")]
        heel = soles(motion)[:, [0, 2] if side == "Left" else [1, 3]]
        down = (ball[:, 1] < 0.0215) & (heel[..., 1].min(axis=1) < 0.012)
        runs = np.split(np.flatnonzero(down), np.flatnonzero(np.diff(np.flatnonzero(down)) > 1) + 1)
        held = [run for run in runs if len(run) > 30]
        assert len(held) >= 4
        for run in held:
            middle = ball[run[3:-3]]
            assert np.linalg.norm(np.ptp(middle[:, [0, 2]], axis=0)) < 0.01


def test_the_knee_bends_as_in_gait():
    """Nearly straight before the heel strikes, 50 to 70 degrees in the swing, never backwards."""
    motion = compose([Action("walk", 5)], variation=0)
    q = motion.motion.local_rotations[:, motion.motion.skeleton.index("LeftLeg")]
    flexion = np.degrees(2.0 * np.arctan2(q[:, 1], q[:, 0]))
    stride = flexion[motion.cycles.starts[2] : motion.cycles.stops[2]]
    assert 50 < stride.max() < 70
    assert 0 < stride.min() < 15
    assert flexion.min() > 0


def test_nothing_jumps(session, positions):
    """Blends between actions are smooth: no joint is accelerated as no person could."""
    velocity = np.diff(positions, axis=0) * session.motion.rate
    acceleration = np.linalg.norm(np.diff(velocity, axis=0), axis=-1) * session.motion.rate
    assert np.linalg.norm(velocity, axis=-1).max() < 12
    assert acceleration.max() < 250
    borders = session.stretches.starts[1:]
    assert max(acceleration[b - 5 : b + 5].max() for b in borders) < 50


def test_same_seed_same_bits():
    assert compose_session(seed=5, rate=30) == compose_session(seed=5, rate=30)
    assert compose_session(seed=5, rate=30) != compose_session(seed=6, rate=30)


def test_the_frame_rate_changes_only_how_often_one_looks():
    slow, fast = compose_session(seed=4, rate=60), compose_session(seed=4, rate=120)
    every_other = fast.motion[::2]
    np.testing.assert_allclose(every_other.local_positions, slow.motion.local_positions, atol=1e-9)
    angles = rotations.geodesic_angle(every_other.local_rotations, slow.motion.local_rotations)
    assert angles.max() < 1e-9
    assert slow.cycles.labels == fast.cycles.labels
    np.testing.assert_allclose(slow.cycles.starts / 60, fast.cycles.starts / 120, atol=1 / 60)
    np.testing.assert_allclose(slow.stretches.stops / 60, fast.stretches.stops / 120, atol=1 / 60)


def test_everything_scales_with_the_body():
    actions = [Action("walk", 2), Action("jumping jack", 2)]
    adult, child = (forward_kinematics(compose(actions, height=h).motion).positions for h in (1.8, 1.2))
    np.testing.assert_allclose(child, adult * (1.2 / 1.8), atol=1e-9)


def test_right_kicks_mirror_left_kicks():
    session = compose(KICKS, variation=0)
    places = forward_kinematics(session.motion).positions
    (a, b), (c, d) = (of(session, f"{side} side kick")[0] for side in ("left", "right"))
    left, right = places[a:b], places[c:d]
    length = min(len(left), len(right))
    np.testing.assert_allclose(
        mirror_image(session.motion.skeleton, left)[:length], right[:length], atol=1e-6
    )
    assert np.abs(left[:length] - right[:length]).max() > 0.5


def test_mirrored_exchanges_left_and_right():
    actions = [Action("walk", 2), *KICKS]
    plain, mirrored = (compose(actions, mirrored=m, variation=0).motion for m in (False, True))
    np.testing.assert_allclose(
        mirror_image(plain.skeleton, forward_kinematics(plain).positions),
        forward_kinematics(mirrored).positions,
        atol=1e-9,
    )


def test_a_turning_walk_ends_facing_where_it_should():
    motion = compose([Action("walk", 3, turn=1.0), Action("still")], variation=0).motion
    front = rotations.rotate(forward_kinematics(motion).rotations[-1, 0], np.array([0.0, 0.0, 1.0]))
    assert np.arctan2(front[0], front[2]) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("name", ACTIONS)
def test_every_action_starts_and_ends_standing_at_ease(name):
    motion = compose([Action(name, 2), Action("still")], variation=0).motion
    standing = motion.local_rotations[-1]
    assert rotations.geodesic_angle(motion.local_rotations[0], standing)[1:].max() < 1e-6


def test_without_variation_cycles_are_alike():
    session = compose([Action("squat", 3)], variation=0, rate=100)
    first, last = (session.motion.local_rotations[k * 220 : (k + 1) * 220] for k in (0, 2))
    assert rotations.geodesic_angle(first, last).max() < 1e-6


@pytest.mark.parametrize("height", [1.0, 1.75])
def test_the_skeleton_stands_on_the_floor_at_its_height(height):
    skeleton = human_skeleton(height)
    places = np.zeros((len(skeleton), 3))
    for j, parent in enumerate(skeleton.parents):
        places[j] = skeleton.offsets[j] + (places[parent] if parent >= 0 else 0.0)
    ends = places[skeleton.end_parents] + skeleton.end_offsets
    assert ends[:, 1].max() == pytest.approx(height)
    assert ends[:, 1].min() == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Action("cartwheel"), "one of still, walk"),
        (lambda: Action("squat", 0), "cycles must be 1 or more"),
        (lambda: Action("squat", period_s=0.1), "period_s"),
        (lambda: Action("squat", amplitude=3), "amplitude"),
        (lambda: compose([]), "at least one Action"),
        (lambda: compose([Action("squat")], variation=-1), "variation"),
        (lambda: human_skeleton(-1.7), "height"),
    ],
)
def test_what_cannot_be_done_is_said(make, message):
    with pytest.raises(ParameterError, match=message):
        make()
