"""Z and Z*: what the mirror does to them, what does not matter to them, and what their identity axis tells."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.features import kinematic_chain, mirrored, posture
from leitmotion.motion import Motion, ParameterError
from leitmotion.motion.rotations import from_axis_angle
from leitmotion.similarity import (
    axis_speed,
    choose_beta,
    double_metric,
    identity_width,
    likeness,
    still_spans,
    symmetry_index,
)
from leitmotion.similarity.mirror import LEAST, MIRROR_METRICS, MOST
from leitmotion.view import plot_symmetry
from oracles import body as oracle
from oracles import mirror as twin


@pytest.fixture
def chain(rng):
    return kinematic_chain(oracle.human(rng, bend=0.8))


@pytest.mark.parametrize("metric", MIRROR_METRICS)
def test_it_is_what_the_loops_say(chain, metric, rng):
    weights = rng.uniform(0.2, 2.0, len(chain.names))
    partner = [chain.names.index(twin.swapped(name)) for name in chain.names]
    weights = weights + weights[partner]
    found = double_metric(chain[::3], metric=metric, weights=weights)
    own, mirror = twin.double_metric(chain[::3], weights, metric == "geodesic")
    assert np.abs(found.own - own).max() < 1e-5
    assert np.abs(found.mirror - mirror).max() < 1e-5


@pytest.mark.parametrize("metric", MIRROR_METRICS)
def test_both_are_symmetric_and_the_diagonal_of_z_is_one(rng, metric):
    chain = kinematic_chain(oracle.human(rng, frames=600))  # more than one tile
    found = double_metric(chain, metric=metric)
    assert np.array_equal(found.own, found.own.T)
    assert np.array_equal(found.mirror, found.mirror.T)
    assert np.array_equal(np.diagonal(likeness(found.own, found.beta)), np.ones(len(chain)))
    assert found.lopsidedness.max() > 0


@pytest.mark.parametrize("metric", MIRROR_METRICS)
def test_the_mirror_leaves_both_as_they_are(rng, metric):
    motion = oracle.human(rng, bend=0.8)
    found, image = (
        double_metric(kinematic_chain(each), metric=metric) for each in (motion, oracle.mirrored(motion))
    )
    assert np.abs(found.own - image.own).max() < 1e-5
    assert np.abs(found.mirror - image.mirror.T).max() < 1e-5
    assert image.beta == pytest.approx(found.beta, rel=1e-4)


@pytest.mark.parametrize("metric", MIRROR_METRICS)
def test_a_symmetric_posture_is_its_own_image(metric):
    body = oracle.skeleton()
    still = oracle.stiff(np.tile([1.0, 0.0, 0.0, 0.0], (4, 1)))
    local = still.local_rotations.copy()
    local[2, body.index("LeftArm")] = from_axis_angle("z", 0.9)
    found = double_metric(kinematic_chain(still.replace(local_rotations=local)), metric=metric)
    lopsided = found.lopsidedness
    assert lopsided[[0, 1, 3]].max() < 1e-6
    assert lopsided[2] > 1e-3


@pytest.mark.parametrize("metric", MIRROR_METRICS)
def test_a_distance_depends_on_its_two_moments_alone(rng, metric):
    """To the bit, whatever else is compared, and whether a rotation is told by q or by -q."""
    chain = kinematic_chain(oracle.human(rng, frames=600, bend=1.2))
    found, part = double_metric(chain, metric=metric), double_metric(chain[200:500:7], metric=metric)
    assert np.array_equal(part.own, found.own[200:500:7, 200:500:7])
    assert np.array_equal(part.mirror, found.mirror[200:500:7, 200:500:7])
    signs = rng.choice([-1.0, 1.0], (len(chain), len(chain.names), 1))
    values = (chain.values.reshape(len(chain), -1, 4) * signs).reshape(len(chain), -1)
    turned = double_metric(chain.replace(values=values), metric=metric)
    assert np.array_equal(turned.own, found.own)
    assert np.array_equal(turned.mirror, found.mirror)


def test_an_angle_of_any_size_is_right(chain):
    """From nothing to half a turn, a link alone."""
    angles = np.concatenate(([0.0], np.geomspace(1e-6, np.pi, 700)))
    values = np.tile(from_axis_angle("y", np.zeros(len(angles))), (1, 2))
    values[:, :4] = from_axis_angle("x", angles)
    values[:, 4:] = from_axis_angle("x", angles)
    pair = chain.replace(values=values, names=("left_femur", "right_femur"))
    found = double_metric(pair, metric="geodesic")
    assert np.abs(found.own[0] - angles).max() < 1e-6
    assert np.abs(found.mirror[0] - angles).max() < 1e-6


def test_place_yaw_and_unit_change_nothing(rng):
    motion = oracle.human(rng, bend=0.8)
    found = double_metric(kinematic_chain(motion))
    elsewhere = oracle.scaled(oracle.moved(motion, yaw=2.0, by=[3.0, 0.0, -1.0]), 100.0)
    moved = double_metric(kinematic_chain(elsewhere))
    assert np.abs(moved.own - found.own).max() < 1e-6
    assert np.abs(moved.mirror - found.mirror).max() < 1e-6


def test_the_rate_changes_nothing(rng):
    """But for a tenth of a degree, by which half of the moments tell otherwise how the zero pose was fitted."""
    motion = oracle.human(rng, bend=0.8)
    found, fewer = (double_metric(kinematic_chain(each), metric="geodesic") for each in (motion, motion[::2]))
    assert np.abs(fewer.mirror - found.mirror[::2, ::2]).max() < np.radians(0.1)
    assert fewer.beta == pytest.approx(found.beta, rel=0.05)
    assert np.abs(axis_speed(fewer) - axis_speed(found)[::2]).max() < 0.05 * axis_speed(found).max()


def test_the_angle_is_a_metric_and_the_cost_is_not(rng):
    chain = kinematic_chain(oracle.human(rng, bend=1.2))
    for metric, holds in (("geodesic", True), ("inner", False)):
        far = double_metric(chain, metric=metric).own.astype(float)
        detour = (far[:, :, None] + far[None]).min(axis=1)
        assert (far <= detour + 1e-6).all() == holds


def test_a_link_of_weight_0_has_no_say(chain):
    weights = [0.0 if "humerus" in name or "radius" in name else 1.0 for name in chain.names]
    legs = [name for name, weight in zip(chain.names, weights, strict=True) if weight]
    assert 0 < len(legs) < len(chain.names)
    values = chain.values.reshape(len(chain), -1, 4)[:, [chain.names.index(name) for name in legs]]
    alone = chain.replace(values=values.reshape(len(chain), -1), names=tuple(legs))
    assert np.allclose(double_metric(chain, weights=weights).own, double_metric(alone).own, atol=1e-6)


def test_an_unseen_link_is_left_out_of_the_mean(chain):
    values = chain.values.copy()
    values[5, -4:] = np.nan
    values[6] = np.nan
    found, whole = double_metric(chain.replace(values=values)), double_metric(chain)
    others = np.ones(len(chain), dtype=bool)
    others[[5, 6]] = False
    assert np.array_equal(found.own[np.ix_(others, others)], whole.own[np.ix_(others, others)])
    assert np.isfinite(found.own[5, others]).all()
    assert np.isnan(found.own[6]).all()
    assert np.isnan(found.mirror[:, 6]).all()
    assert found.beta == pytest.approx(whole.beta, rel=0.05)


def swinging(speed: float, *, rate=60.0, still_s=1.0) -> Motion:
    """Both arms rise steadily, then the person keeps still."""
    body = oracle.skeleton()
    time = np.arange(round(2 * rate)) / rate
    angle = np.concatenate((speed * time, np.full(round(still_s * rate), speed * time[-1])))
    local = np.tile([1.0, 0.0, 0.0, 0.0], (len(angle), len(body), 1))
    local[:, body.index("LeftArm")] = from_axis_angle("z", angle)
    local[:, body.index("RightArm")] = from_axis_angle("z", -angle)
    return Motion(body, np.tile(body.offsets, (len(angle), 1, 1)), local, rate=rate)


@pytest.mark.parametrize("speed", [0.3, 0.6])
def test_the_width_of_the_axis_tells_the_speed(speed):
    found = double_metric(kinematic_chain(swinging(speed)), metric="geodesic", beta=np.log(2) / 0.02)
    steady = slice(40, 70)
    assert axis_speed(found)[steady] == pytest.approx(speed * 2 / 15, rel=0.05)  # two links of fifteen
    assert identity_width(found)[steady] == pytest.approx(2 * 0.02 / (speed * 2 / 15), rel=0.05)


def test_stillness_is_a_span_of_moments_alike():
    found = double_metric(
        kinematic_chain(swinging(0.8, still_s=2.0)), metric="geodesic", beta=np.log(2) / 0.02
    )
    (start, stop, label, _), *others = still_spans(found, min_duration_s=1.0)
    assert others == []
    assert label == "stillness"
    assert found.own[start:stop, start:stop].max() < 0.02
    assert stop == len(found)
    assert 100 < start <= 120


def test_what_is_unseen_is_neither_still_nor_slow():
    chain = kinematic_chain(swinging(0.8, still_s=3.0))
    gaps = chain.values.copy()
    gaps[200:215] = np.nan
    gaps[280:] = np.nan
    whole, found = (
        double_metric(chain.replace(values=values), metric="geodesic", beta=np.log(2) / 0.02)
        for values in (chain.values, gaps)
    )
    speed = axis_speed(found)
    assert np.isnan(speed[200:215]).all()
    assert np.isnan(speed[280:]).all()
    assert np.isfinite(speed[215:280]).all()
    assert np.allclose(speed[:90], axis_speed(whole)[:90])
    (first, *_), *_ = still_spans(whole)
    assert [(start, stop) for start, stop, _, _ in still_spans(found)] == [(first, 200), (215, 280)]
    plot_symmetry(found, form="triangle")


def test_a_single_moment_has_no_width_and_no_speed():
    alone = double_metric(kinematic_chain(swinging(0.8))[:1], beta=300.0)
    assert np.isnan(identity_width(alone)).all()
    assert np.isnan(axis_speed(alone)).all()
    plot_symmetry(alone, form="triangle")


def test_the_index_is_one_with_the_mirror_image_and_the_same_of_it(chain):
    image = mirrored(chain)
    alone, other, both = (
        symmetry_index(double_metric(chain.replace(values=values), beta=300.0))
        for values in (chain.values, image.values, np.concatenate((chain.values, image.values)))
    )
    assert 0 < alone < 0.9
    assert other == pytest.approx(alone, abs=1e-4)
    assert both == pytest.approx(1.0, abs=1e-4)
    unseen = chain.replace(values=np.full_like(chain.values, np.nan))
    assert np.isnan(symmetry_index(double_metric(unseen, beta=300.0)))


def test_beta_is_bounded_and_knows_no_rate(chain):
    for metric in MIRROR_METRICS:
        found = double_metric(chain, metric=metric)
        assert LEAST - 1e-6 <= found.half_angle <= MOST + 1e-6
        assert likeness(found.half, found.beta) == pytest.approx(0.5)
        assert choose_beta(np.zeros((3, 3)), metric) > found.beta
    assert double_metric(chain, beta=7.0).beta == 7.0


def test_it_is_saved_and_loaded(chain, tmp_path):
    found = double_metric(chain)
    lm.save(found, tmp_path / "found.npz")
    assert lm.load(tmp_path / "found.npz") == found


def test_errors_help(chain, rng):
    with pytest.raises(ParameterError, match="metric must be one of inner, geodesic, got 'cosine'"):
        double_metric(chain, metric="cosine")
    with pytest.raises(ParameterError, match="mirror images of these features are not known"):
        double_metric(posture(lm.embody(oracle.human(rng))))
    with pytest.raises(ParameterError, match="A link counts as much as its mirror partner, but left_femur"):
        double_metric(chain, weights=[2.0 if name == "left_femur" else 1.0 for name in chain.names])
    with pytest.raises(ParameterError, match="Each of the 15 links has one weight"):
        double_metric(chain, weights=[1.0])
    with pytest.raises(ParameterError, match="beta must be a positive number, got -1"):
        double_metric(chain, beta=-1.0)


@pytest.mark.data
def test_a_walk_alternates_and_jumping_jacks_do_not(data):
    """Half a cycle later a walk is its own mirror image; jumping jacks are so at once (paper S, section 3.5)."""
    walk = double_metric(
        kinematic_chain(lm.read(data / "bandai_namco" / "dataset-1_walk_normal_001.bvh")), metric="geodesic"
    )
    own, image = (
        np.array([np.diagonal(each, lag).mean() for lag in range(len(walk) // 2)])
        for each in (walk.own, walk.mirror)
    )
    cycle = 20 + int(own[20:45].argmin())
    half = cycle // 2
    assert own[cycle] < 0.4 * own[half]
    assert image[half] < 0.5 * image[cycle]
    assert image[half] < 0.5 * own[half]
    jacks = double_metric(kinematic_chain(lm.read(data / "cmu_bvh" / "jumping_jacks.bvh")), metric="geodesic")
    assert jacks.lopsidedness.mean() < 0.4 * np.median(jacks.own)
    assert walk.lopsidedness.mean() > 0.7 * np.median(walk.own)
