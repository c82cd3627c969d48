"""Rotation algebra: the laws of the group, and scipy's Rotation as twin."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation, Slerp

from leitmotion.motion import ParameterError, rotations

ORDERS = ["".join(p) for p in itertools.permutations("xyz")] + ["zxz", "xyx", "yzy"]
UNIT = (
    arrays(np.float64, (4,), elements=st.floats(-1, 1))
    .filter(lambda q: np.linalg.norm(q) > 0.1)
    .map(rotations.normalize)
)
VECTOR = arrays(np.float64, (3,), elements=st.floats(-10, 10))
close = pytest.approx
IDENTITY = rotations.IDENTITY


def twin(q):
    return Rotation.from_quat(np.asarray(q)[..., [1, 2, 3, 0]])


def random(rng, *shape):
    return rotations.normalize(rng.normal(size=(*shape, 4)))


@given(UNIT, UNIT, UNIT)
def test_the_product_is_associative_and_undone_by_the_conjugate(a, b, c):
    left = rotations.multiply(rotations.multiply(a, b), c)
    right = rotations.multiply(a, rotations.multiply(b, c))
    assert left == close(right, abs=1e-12)
    assert rotations.multiply(a, rotations.conjugate(a)) == close(IDENTITY, abs=1e-12)
    assert np.linalg.norm(left) == close(1)


@given(UNIT, UNIT, VECTOR)
def test_turning_is_an_action_that_keeps_lengths(a, b, v):
    twice = rotations.rotate(a, rotations.rotate(b, v))
    assert rotations.rotate(rotations.multiply(a, b), v) == close(twice, abs=1e-10)
    assert np.linalg.norm(twice) == close(np.linalg.norm(v), abs=1e-10)
    assert rotations.rotate(IDENTITY, v) == close(v)
    assert rotations.rotate(-a, v) == close(rotations.rotate(a, v))


@given(UNIT, UNIT, VECTOR)
def test_product_and_turning_are_those_of_scipy(a, b, v):
    assert twin(rotations.multiply(a, b)).as_matrix() == close((twin(a) * twin(b)).as_matrix(), abs=1e-12)
    assert rotations.rotate(a, v) == close(twin(a).apply(v), abs=1e-11)


def test_leading_axes_broadcast(rng):
    a, b, v = random(rng, 5, 1), random(rng, 1, 3), rng.normal(size=(3, 3))
    assert rotations.multiply(a, b).shape == (5, 3, 4)
    assert rotations.rotate(a, v).shape == (5, 3, 3)
    np.testing.assert_allclose(rotations.multiply(a, b)[4, 2], rotations.multiply(a[4, 0], b[0, 2]))


@pytest.mark.parametrize("order", ORDERS)
def test_euler_angles_are_intrinsic_as_scipy_has_them(rng, order):
    angles = rng.uniform(-np.pi, np.pi, (50, 3))
    q = rotations.from_euler(order, angles)
    np.testing.assert_allclose(
        twin(q).as_matrix(), Rotation.from_euler(order.upper(), angles).as_matrix(), atol=1e-12
    )


@pytest.mark.parametrize("order", ORDERS[:6])
def test_euler_angles_there_and_back(rng, order):
    q = random(rng, 4, 20)
    back = rotations.from_euler(order, rotations.as_euler(order, q))
    assert rotations.geodesic_angle(q, back).max() < 1e-7
    locked = np.array([[0.3, np.pi / 2, 0.4], [-1.0, -np.pi / 2, 2.0]])
    q = rotations.from_euler(order, locked)
    assert rotations.geodesic_angle(q, rotations.from_euler(order, rotations.as_euler(order, q))).max() < 1e-7


def test_one_and_two_letters_are_products_of_turns(rng):
    a, b = rng.uniform(-3, 3, (2, 10))
    np.testing.assert_allclose(rotations.from_euler("z", a[:, None]), rotations.from_axis_angle("z", a))
    product = rotations.multiply(rotations.from_axis_angle("z", a), rotations.from_axis_angle("x", b))
    np.testing.assert_allclose(rotations.from_euler("zx", np.stack([a, b], -1)), product, atol=1e-15)


def test_rotation_vectors_are_what_scipy_has(rng):
    vectors = rng.normal(0, 1, (60, 3))
    vectors *= (rng.uniform(0, np.pi, 60) / np.linalg.norm(vectors, axis=1))[:, None]
    vectors[0] = 0.0
    vectors[1] *= 1e-12
    q = rotations.from_rotation_vector(vectors)
    np.testing.assert_allclose(twin(q).as_matrix(), Rotation.from_rotvec(vectors).as_matrix(), atol=1e-12)
    further = vectors * 3  # beyond a half turn it is another way to the same rotation
    made = twin(rotations.from_rotation_vector(further)).as_matrix()
    np.testing.assert_allclose(made, Rotation.from_rotvec(further).as_matrix(), atol=1e-12)


def test_matrices_there_and_back(rng):
    q = random(rng, 3, 7)
    matrices = rotations.as_matrix(q)
    assert matrices.shape == (3, 7, 3, 3)
    assert rotations.geodesic_angle(rotations.from_matrix(matrices), q).max() < 1e-7
    v = rng.normal(size=3)
    np.testing.assert_allclose(matrices @ v, rotations.rotate(q, v), atol=1e-12)


@given(UNIT, UNIT, UNIT)
@settings(max_examples=50)
def test_the_angle_is_a_metric(a, b, c):
    d = rotations.geodesic_angle
    assert d(a, b) == close(d(b, a), abs=1e-12)
    assert d(a, -a) == close(0, abs=1e-12)
    assert 0 <= d(a, b) <= np.pi + 1e-12
    assert d(a, c) <= d(a, b) + d(b, c) + 1e-9
    assert d(rotations.multiply(c, a), rotations.multiply(c, b)) == close(d(a, b), abs=1e-7)
    assert d(a, b) == close((twin(a).inv() * twin(b)).magnitude(), abs=1e-7)


def test_the_angle_is_exact_for_the_smallest_turns():
    assert rotations.geodesic_angle(IDENTITY, rotations.from_axis_angle("x", 1e-9)) == close(1e-9, rel=1e-6)


def test_continuous_changes_signs_only_and_leaves_no_jump(rng):
    steps = rotations.from_euler("xyz", rng.normal(0, 0.1, (100, 3, 3)))
    smooth = steps.copy()
    for t in range(1, 100):
        smooth[t] = rotations.multiply(smooth[t - 1], steps[t])
    flipped = smooth * rng.choice([-1, 1], (100, 3, 1))
    made = rotations.continuous(flipped)
    np.testing.assert_allclose(np.abs(made), np.abs(smooth))
    assert (np.einsum("tjc,tjc->tj", made[1:], made[:-1]) > 0).all()
    np.testing.assert_array_equal(made[0], flipped[0])
    np.testing.assert_array_equal(rotations.continuous(made), made)
    assert rotations.continuous(made[:1]).shape == (1, 3, 4)


def test_slerp_goes_the_shorter_way_at_constant_speed(rng):
    a, b = random(rng, 20), random(rng, 20)
    for t in (0.0, 0.25, 0.5, 1.0):
        part = rotations.geodesic_angle(a, rotations.slerp(a, b, t))
        np.testing.assert_allclose(part, t * rotations.geodesic_angle(a, b), atol=1e-7)
    between = Slerp([0, 1], Rotation.concatenate([twin(a[0]), twin(b[0])]))(0.3)
    assert (twin(rotations.slerp(a[0], b[0], 0.3)).inv() * between).magnitude() < 1e-7
    np.testing.assert_allclose(rotations.slerp(a, a, 0.4), a, atol=1e-12)


def test_axis_and_yaw():
    np.testing.assert_allclose(
        rotations.rotate(rotations.yaw_rotation(np.pi / 2), [0, 0, 1]), [1, 0, 0], atol=1e-15
    )
    np.testing.assert_allclose(
        rotations.rotate(rotations.from_axis_angle("X", np.pi / 2), [0, 1, 0]), [0, 0, 1], atol=1e-15
    )
    with pytest.raises(ParameterError, match="one of x, y, z, got 'w'"):
        rotations.from_axis_angle("w", 1.0)
    with pytest.raises(ParameterError, match="3 columns"):
        rotations.from_euler("xyz", np.zeros((5, 2)))
