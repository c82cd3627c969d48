"""Velocity: seconds, not frames; the body's axes, not the world's."""

import numpy as np
import pytest

from leitmotion.body import embody, mirror_role
from leitmotion.features import velocity
from leitmotion.motion import rotations
from oracles.body import human, mirrored, moved, scaled, stiff


@pytest.fixture
def dancer(rng):
    return human(rng, frames=240, rate=120.0)


def described(motion):
    return velocity(embody(motion)).values


def test_invariant_to_place_yaw_and_size(dancer):
    assert np.allclose(described(dancer), described(moved(dancer, yaw=-1.2, by=[4.0, 0.0, -3.0])))
    assert np.allclose(described(dancer), described(scaled(dancer, 0.6)))


def test_equivariant_to_the_mirror(dancer):
    own, image = velocity(embody(dancer)), velocity(embody(mirrored(dancer)))
    swap = [own.names.index(mirror_role(name)) for name in own.names]
    assert np.allclose(
        image.values.reshape(240, -1, 3), own.values.reshape(240, -1, 3)[:, swap] * [-1.0, 1.0, 1.0]
    )


def test_frame_rate_matters_little(dancer):
    fast, slow = described(dancer)[::4], described(dancer[::4])
    assert np.abs(fast - slow)[1:-1].max() < 0.02 * np.abs(fast).max()


def test_walking_forwards_is_along_z():
    walk = stiff(rotations.yaw_rotation(np.full(60, 1.1)))
    positions = walk.local_positions.copy()
    positions[:, 0, [0, 2]] += np.arange(60)[:, None] / 60 * 1.4 * np.array([np.sin(1.1), np.cos(1.1)])
    features = velocity(embody(walk.replace(local_positions=positions)))
    assert np.allclose(features.values.reshape(60, -1, 3) * features.scale, [0.0, 0.0, 1.4])
    assert features.unit == "m/s"


def test_one_frame_stands_still(dancer):
    assert not described(dancer[:1]).any()


def test_an_unseen_point_has_no_velocity_there_nor_beside(dancer):
    body = embody(dancer)
    holes = body.positions.copy()
    holes[40, body.roles.index("head")] = np.nan
    holes[0, body.roles.index("neck")] = np.nan
    features = velocity(body.replace(positions=holes))
    unseen = np.isnan(features.values.reshape(240, -1, 3)).all(axis=2)
    assert np.flatnonzero(unseen[:, features.names.index("head")]).tolist() == [39, 40, 41]
    assert np.flatnonzero(unseen[:, features.names.index("neck")]).tolist() == [0, 1]
    assert np.isnan(velocity(body.replace(positions=holes[:1], facing=[0.0])).values).sum() == 3
