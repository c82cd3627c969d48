"""The composed motions of paper S: laws of space and time, and a truth that follows every variation."""

import functools

import numpy as np
import pytest

from leitmotion.datasets import MOTIONS, Variation, compose_motif
from leitmotion.features import kinematic_chain, mirrored
from leitmotion.motion import ParameterError
from leitmotion.motion.kinematics import end_site_positions, forward_kinematics
from leitmotion.motion.rotations import geodesic_angle
from leitmotion.similarity import double_metric

NOTATIONS = {
    "butterfly": "X̄; x̄x →",
    "jumping jacks": "X̄, Ȳ; x̄y ↔",
    "jogging in place": "A, X̄, A*; ax ↔, (ax)* ↔",
    "walking": "A, A*; aa* →, (aa*)* →",
    "limping": "A; aa →",
    "side kicks": "A, X̄, A*; aa →, ax ↔, (ax)* ↔, (aa)* →",
    "sun salutation": "Ȳ, X̄, T̄, W̄, V̄; ȳx ↔, ȳy ↔, x̄t ↔, t̄w ↔, wv →, v̄v →, v̄w →",
}
SYMMETRIC = ("butterfly", "jumping jacks")
NONE = Variation(0.0, 0.0, (1.0, 1.0), 0.0, (0.0, 0.0), (0.0, 0.0))
ONLY = {
    "noise": NONE._replace(noise_deg=3.0),
    "offset": NONE._replace(offset_deg=(5.0, 10.0)),
    "tempo": NONE._replace(tempo=(0.7, 1.4), warp=0.15),
    "dwell": NONE._replace(dwell_s=(0.0, 1.0)),
}


@functools.cache
def exact(name, rate=60.0):
    return compose_motif(name, rate=rate, variation=None)


def degrees(a, b):
    """Mean over the links of the angle between two stretches of a chain."""
    links = [each.values.reshape(len(each), -1, 4) for each in (a, b)]
    return np.degrees(geodesic_angle(*links)).mean(axis=1)


@pytest.mark.parametrize("name", MOTIONS)
def test_the_notation_is_that_of_the_thesis_however_it_varies(name):
    for variation in (None, Variation()):
        assert compose_motif(name, seed=3, rate=30.0, variation=variation).notation == NOTATIONS[name]


@pytest.mark.parametrize("name", SYMMETRIC)
def test_symmetric_motions_are_their_own_mirror_image_at_every_moment(name):
    assert double_metric(kinematic_chain(exact(name).motion), metric="geodesic").lopsidedness.max() < 1e-3


def test_only_the_way_into_the_plank_of_the_sun_salutation_is_asymmetric():
    found = exact("sun salutation", 30.0)
    lopsided = double_metric(kinematic_chain(found.motion), metric="geodesic").lopsidedness
    asymmetric = np.zeros(len(lopsided), bool)
    for step in found.steps:
        asymmetric[step.start : step.stop] |= not step.symmetric
    assert lopsided[~asymmetric].max() < 1e-3
    assert lopsided[asymmetric].max() > np.radians(20.0)


def test_walking_is_its_mirror_image_half_a_cycle_later_and_never_symmetric():
    found = exact("walking", 50.0)
    chain = kinematic_chain(found.motion)
    half = 28  # 0.56 s
    assert found.steps[1].start == half
    assert degrees(chain[half:], mirrored(chain)[:-half]).max() < 1e-3
    assert degrees(chain, mirrored(chain)).min() > 8.0


def test_limping_comes_back_after_a_cycle_and_never_as_a_mirror_image():
    found = exact("limping", 40.0)
    chain = kinematic_chain(found.motion)
    assert degrees(chain[54:], chain[:-54]).max() < 1e-3
    mirror = double_metric(chain, metric="geodesic").mirror
    assert np.degrees(min(np.diagonal(mirror, lag).mean() for lag in range(60))) > 10.0


@pytest.mark.parametrize(
    ("name", "reflect"), [("jumping jacks", False), ("jogging in place", True), ("side kicks", True)]
)
def test_palindromes_are_their_own_reversal_and_anti_palindromes_that_of_their_mirror_image(name, reflect):
    rate = 100.0
    found = exact(name, rate)
    first = {"jumping jacks": 0, "jogging in place": 0, "side kicks": 4}[name]
    there, back = found.steps[first : first + 2]
    chain = kinematic_chain(found.motion)
    image = mirrored(chain) if reflect else chain
    length = there.stop - there.start
    ahead = chain[there.stop : there.stop + length]
    behind = image.replace(values=image.values[there.stop - length + 1 : there.stop + 1][::-1])
    assert abs(length - (back.stop - back.start)) <= 1
    assert degrees(ahead, behind).max() < 3.0


@pytest.mark.parametrize(
    ("name", "step"), [("butterfly", 0), ("limping", 0), ("side kicks", 0), ("sun salutation", 8)]
)
def test_a_loop_goes_one_way_and_does_not_return_as_it_came(name, step):
    found = exact(name, 30.0)
    start, stop = found.steps[step].start, found.steps[step].stop
    own = double_metric(kinematic_chain(found.motion)[start:stop], metric="geodesic").own
    count = stop - start
    returns = [
        np.degrees(np.mean([own[middle - k, middle + k] for k in range(count // 5, count // 3)]))
        for middle in range(count // 3, count - count // 3)
    ]
    assert min(returns) > 5.0
    assert np.degrees(own[0, -1]) < 3.0


@pytest.mark.parametrize("name", MOTIONS)
def test_every_state_is_one_posture_whichever_way_it_is_reached(name):
    found = exact(name, 120.0)
    chain = kinematic_chain(found.motion)
    for state in found.states:
        at = [chain.values[visit.start].reshape(-1, 4) for visit in state.visits]
        for other in at[1:]:
            assert np.degrees(geodesic_angle(at[0], other)).mean() < 3.0
        if state.symmetric:
            own, image = (
                each.values[state.visits[0].start].reshape(-1, 4) for each in (chain, mirrored(chain))
            )
            assert np.degrees(geodesic_angle(own, image)).mean() < 4.0


@pytest.mark.parametrize("kind", ["tempo", "dwell"])
@pytest.mark.parametrize("name", MOTIONS)
def test_the_truth_follows_tempo_and_dwell(name, kind):
    plain, varied = exact(name, 120.0), compose_motif(name, seed=5, rate=120.0, variation=ONLY[kind])
    chains = [kinematic_chain(each.motion) for each in (plain, varied)]
    for a, b in zip(plain.steps, varied.steps, strict=True):
        ends = [
            chain.values[np.clip([step.start, step.stop], 0, len(chain) - 1)].reshape(2, -1, 4)
            for chain, step in zip(chains, (a, b), strict=True)
        ]
        assert np.degrees(geodesic_angle(*ends)).mean() < 3.0
    visited = [sum(len(state.visits) for state in each.states) for each in (plain, varied)]
    assert visited[0] == visited[1]


def test_dwelling_for_half_a_second_is_stillness():
    found = compose_motif("jumping jacks", seed=2, rate=100.0, variation=ONLY["dwell"])
    still = [(span.start, span.stop) for span in found.spans if span.motif == "stillness"]
    held = [(v.start, v.stop) for s in found.states for v in s.visits if v.stop - v.start >= 50]
    assert sorted(held) == still
    assert 0 < len(still) < 13
    chain = kinematic_chain(found.motion)
    for start, stop in still:
        assert degrees(chain[start : stop - 1], chain[start + 1 : stop]).max() < 1e-3


def test_noise_turns_every_joint_by_three_degrees_about_each_axis():
    plain = exact("limping")
    noisy = compose_motif("limping", rate=60.0, variation=ONLY["noise"])
    apart = geodesic_angle(plain.motion.local_rotations, noisy.motion.local_rotations)
    rms = np.degrees(np.sqrt((apart**2).mean(axis=0)))
    assert np.allclose(rms, 3.0 * np.sqrt(3.0), rtol=0.1)


def test_an_offset_turns_joints_of_one_side_all_along():
    for seed in range(6):
        plain = exact("walking")
        crooked = compose_motif("walking", seed=seed, rate=60.0, variation=ONLY["offset"])
        apart = np.degrees(geodesic_angle(plain.motion.local_rotations, crooked.motion.local_rotations))
        assert np.ptp(apart, axis=0).max() < 1e-3
        turned = [name for name, by in zip(plain.motion.skeleton.names, apart[0], strict=True) if by > 0.1]
        assert len({name.startswith("Left") for name in turned}) == 1
        assert len(turned) in (2, 4)
        assert all(5.0 <= by <= 10.0 for by in apart[0][apart[0] > 0.1])


def test_amplitude_and_tempo_stay_in_their_range_and_reach_its_ends():
    lengths = [len(compose_motif("limping", seed=seed, rate=20.0).motion) / 20.0 for seed in range(40)]
    tempo = 8.1 / np.array(lengths)
    assert 0.7 <= tempo.min() < 0.8
    assert 1.25 < tempo.max() <= 1.41


@pytest.mark.parametrize("name", ["jogging in place", "side kicks"])
def test_the_rate_changes_how_often_the_movement_is_looked_at_not_the_movement(name):
    variation = Variation(noise_deg=0.0)
    slow, fast = (compose_motif(name, seed=3, rate=rate, variation=variation) for rate in (40.0, 80.0))
    every_second = fast.motion.local_rotations[::2][: len(slow.motion)]
    assert geodesic_angle(slow.motion.local_rotations, every_second).max() < 1e-6
    for a, b in zip(slow.steps, fast.steps, strict=True):
        assert a.start == -(-b.start // 2)
        assert a.stop == -(-b.stop // 2)


def test_the_same_seed_gives_the_same_motion_and_another_another():
    one, same, other = (compose_motif("walking", seed=seed, rate=30.0).motion for seed in (7, 7, 8))
    assert one == same
    assert one != other


@pytest.mark.parametrize("name", [each for each in MOTIONS if each != "butterfly"])
def test_what_bears_the_body_stays_on_the_floor(name):
    motion = exact(name, 60.0).motion
    pose = forward_kinematics(motion)
    low = np.concatenate((pose.positions, end_site_positions(motion, pose)), axis=1)[..., 1].min(axis=1)
    assert low.min() > -0.01
    assert np.median(low) < 0.01 or name == "jumping jacks"


def test_an_unknown_motion_is_refused():
    with pytest.raises(ParameterError, match="no composed motion 'dancing'"):
        compose_motif("dancing")
    with pytest.raises(ParameterError, match="rate must be a positive number"):
        compose_motif("walking", rate=0.0)
