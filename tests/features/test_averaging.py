"""Averaged postures: noise of single frames goes, the movement, the mirror and what is unseen stay."""

import numpy as np

from leitmotion.features import averaged, kinematic_chain, mirrored
from leitmotion.motion import rotations
from oracles import body as oracle


def apart(one, other):
    """(T, L) angle between the rotations of two chains."""
    return rotations.geodesic_angle(*(each.values.reshape(len(each), -1, 4) for each in (one, other)))


def test_noise_goes_and_movement_stays(rng):
    chain = kinematic_chain(oracle.human(rng, frames=240, rate=120.0))
    turns = rng.normal(
        scale=np.radians(3.0) / 2, size=(*chain.values.reshape(len(chain), -1, 4).shape[:2], 3)
    )
    noise = rotations.normalize(np.concatenate((np.ones((*turns.shape[:2], 1)), turns), axis=-1))
    noisy = chain.replace(
        values=rotations.multiply(chain.values.reshape(len(chain), -1, 4), noise).reshape(chain.values.shape)
    )
    assert np.degrees(apart(chain, averaged(chain, 0.04))[20:-20].max()) < 1.0
    assert apart(averaged(noisy, 0.04), chain).mean() < 0.35 * apart(noisy, chain).mean()


def test_the_sign_of_a_quaternion_does_not_matter(rng):
    chain = kinematic_chain(oracle.human(rng))
    values = chain.values.reshape(len(chain), -1, 4).copy()
    values[rng.uniform(size=values.shape[:2]) < 0.5] *= -1
    flipped = chain.replace(values=values.reshape(len(chain), -1))
    assert apart(averaged(chain, 0.05), averaged(flipped, 0.05)).max() < 1e-6


def test_the_mirror_image_of_the_average_is_the_average_of_the_mirror_image(rng):
    chain = kinematic_chain(oracle.human(rng))
    assert apart(mirrored(averaged(chain, 0.05)), averaged(mirrored(chain), 0.05)).max() < 1e-6


def test_what_is_unseen_stays_so_and_does_not_count(rng):
    chain = kinematic_chain(oracle.human(rng))
    values = chain.values.copy()
    values[10:20, :4] = np.nan
    found = averaged(chain.replace(values=values), 0.05).values
    assert np.array_equal(np.isnan(found), np.isnan(values))
    assert np.allclose(np.linalg.norm(found[:, 4:8], axis=1), 1.0)
