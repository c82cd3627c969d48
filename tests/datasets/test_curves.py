import numpy as np

from leitmotion.datasets._curves import keyed, wander

KEYS = [(0.0, 1.0), (1.0, 3.0, 0.5), (2.5, -1.0)]


def test_a_curve_goes_through_its_keys_with_their_slopes():
    at = np.array([0.0, 1.0, 2.5])
    np.testing.assert_allclose(keyed(at, KEYS), [1.0, 3.0, -1.0])
    step = 1e-6
    slopes = (keyed(at + step, KEYS) - keyed(at - step, KEYS)) / (2 * step)
    np.testing.assert_allclose(slopes, [0.0, 0.5, 0.0], atol=1e-5)


def test_a_curve_is_held_outside_its_keys():
    np.testing.assert_array_equal(keyed(np.array([-3.0, 9.0]), KEYS), [1.0, -1.0])


def test_a_curve_equals_scipys_hermite_spline():
    from scipy.interpolate import CubicHermiteSpline

    t = np.linspace(0.0, 2.5, 101)
    wanted = CubicHermiteSpline([0.0, 1.0, 2.5], [1.0, 3.0, -1.0], [0.0, 0.5, 0.0])(t)
    np.testing.assert_allclose(keyed(t, KEYS), wanted, atol=1e-12)


def test_wandering_has_unit_variance_and_zero_mean(rng):
    curves = wander(rng, np.arange(20_000) / 20, 1000.0, 1.0, 8)
    assert np.abs(curves.mean(axis=0)).max() < 0.15
    np.testing.assert_allclose(curves.std(axis=0), 1.0, atol=0.1)


def test_wandering_is_the_same_at_every_rate():
    slow, fast = (
        wander(np.random.default_rng(1), np.arange(rate * 10) / rate, 10.0, 3.0, 2) for rate in (25, 100)
    )
    np.testing.assert_allclose(fast[::4], slow, atol=1e-12)
