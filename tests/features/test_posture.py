"""Posture: what may change without changing the numbers."""

import numpy as np
import pytest

from leitmotion.body import embody, mirror_role
from leitmotion.features import posture
from leitmotion.motion import ParameterError
from oracles.body import human, moved


@pytest.fixture
def dancer(rng):
    return human(rng, frames=90)


def test_invariant_to_place_and_yaw(dancer):
    assert np.allclose(
        posture(embody(dancer)).values, posture(embody(moved(dancer, yaw=2.1, by=[4.0, 0.0, -3.0]))).values
    )


def test_sees_height(dancer):
    lower = posture(embody(moved(dancer, yaw=0.0, by=[0.0, -0.3, 0.0])))
    drop = posture(embody(dancer)).values.reshape(90, -1, 3) - lower.values.reshape(90, -1, 3)
    assert np.allclose(drop * lower.scale, [0.0, 0.3, 0.0])


def test_invariant_to_unit_and_size(dancer):
    small = posture(
        embody(
            scaled := dancer.replace(
                skeleton=dancer.skeleton.replace(offsets=dancer.skeleton.offsets * 0.7),
                local_positions=dancer.local_positions * 0.7,
            )
        )
    )
    assert np.allclose(posture(embody(dancer)).values, small.values)
    assert small.scale == pytest.approx(0.7 * embody(dancer).size)
    assert len(scaled) == 90


def test_frame_rate_by_slicing(dancer):
    assert np.allclose(posture(embody(dancer[::3])).values, posture(embody(dancer)).values[::3], atol=1e-3)


def test_unknown_role_is_named(dancer):
    with pytest.raises(ParameterError, match="left_wing"):
        posture(embody(dancer), roles=["left_wing"])


def test_mirror_swaps_sides_and_negates_x(dancer):
    from oracles.body import mirrored

    body, image = posture(embody(dancer)), posture(embody(mirrored(dancer)))
    swap = [body.names.index(mirror_role(name)) for name in body.names]
    expected = body.values.reshape(90, -1, 3)[:, swap] * [-1.0, 1.0, 1.0]
    assert np.allclose(image.values.reshape(90, -1, 3), expected, atol=1e-9)
