"""Bias: how far the two sides of a body differ in a posture that should be the same on both, and the way back.

Conventions
-----------
A suit that sits askew, or a skeleton that was fitted askew, turns a joint by a constant rotation: q becomes q k. With r
the mean of a joint in the reference posture and s the middle between r and the mirror image of its partner, ``q r⁻¹ s``
takes k out, whatever the joint does.
"""

from __future__ import annotations

import numpy as np

from leitmotion.body import CHAIN_LINKS
from leitmotion.body.rest import rest_axes
from leitmotion.features.mirror import mirrored
from leitmotion.features.rotations import towards_mean
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion import DataError, ParameterError
from leitmotion.motion.noun import Noun, noun, set_array, set_names
from leitmotion.motion.rotations import conjugate, geodesic_angle, multiply, normalize, rotate

POSES = ("mean", "standing")
LARGEST = np.radians(20.0)  # sides that differ by more differ by posture, not by how a suit sits
LEANING, HANGING, STRAIGHT = np.radians(25.0), np.radians(45.0), np.radians(45.0)
STILL_RAD_S = 0.15  # of a mean link
SPEED_S, SHORTEST_S = 0.1, 0.25  # seconds over which speed is measured, and that somebody stands at least


@noun
class SideBias(Noun):
    """By how much the sides of a body differ in a posture that should be the same on both.

    Parameters
    ----------
    names : tuple of str, L
        The links.
    turns : (L, 4) float
        What each link's rotation is followed by to take the bias out; the identity where nothing is taken out.
    angles : (L,) float
        Radians between each link and the mirror image of its partner in that posture.
    pose : str
        Which posture: "mean" or "standing".
    frames : int
        Of how many frames it is the mean.
    """

    names: tuple[str, ...]
    turns: np.ndarray
    angles: np.ndarray
    pose: str
    frames: int

    def __post_init__(self) -> None:
        names = set_names(self, "names")
        set_array(self, "turns", dtype=np.float64, shape=(len(names), 4))
        set_array(self, "angles", dtype=np.float64, shape=(len(names),))

    @property
    def too_large(self) -> tuple[str, ...]:
        """The links of which nothing is taken out, since the sides differ by more than 20 degrees."""
        return tuple(name for name, angle in zip(self.names, self.angles, strict=True) if angle > LARGEST)


def side_bias(chain: FeatureSequence, *, pose: str = "mean") -> SideBias:
    """Measure how far the two sides differ in the mean posture, or while the person stands still with arms that hang.

    The mean serves where both sides do the same in the end, as in a walk or a session of many movements; of a recording
    in which one arm alone is raised it takes a part of the movement for bias. Standing serves everywhere, where there
    is any. What differs by more than 20 degrees is left as it is.

    Parameters
    ----------
    chain : FeatureSequence
        A kinematic chain (:func:`leitmotion.features.kinematic_chain`), T frames.
    pose : {"mean", "standing"}
        Which posture should be the same on both sides.

    Returns
    -------
    SideBias
        To be taken out by :func:`without_bias`.

    Raises
    ------
    ParameterError
        When the pose is none of these, or the features are no chain with both sides.
    DataError
        When nobody stands still, or no frame shows the links.

    Examples
    --------
    >>> from leitmotion.features import kinematic_chain
    >>> from leitmotion.datasets import compose_session
    >>> chain = kinematic_chain(compose_session(seed=0, rate=30.0).motion)
    >>> side_bias(chain, pose="standing").too_large
    ()
    """
    if pose not in POSES:
        raise ParameterError(f"pose must be one of {', '.join(POSES)}, got {pose!r}.")
    chosen = chain if pose == "mean" else chain.replace(values=chain.values[_standing(chain)])
    if pose == "standing" and len(chosen) < SHORTEST_S * chain.rate:
        raise DataError(
            f"Nobody stands still with hanging arms here for {SHORTEST_S:g} s, by which sides could be compared.",
            remedy='Compare them in the mean posture: pose="mean", --bias mean.',
        )
    reference = chosen.replace(values=_mean(chosen)[None])
    image = mirrored(reference)
    if image is None:
        raise ParameterError("The sides of a kinematic chain are compared, and this is none.")
    own, other = (each.values.reshape(-1, 4) for each in (reference, image))
    angles = geodesic_angle(own, other)
    sign = np.where((own * other).sum(axis=1, keepdims=True) < 0, -1.0, 1.0)
    middle = normalize(own + sign * other)
    turns = np.where(angles[:, None] > LARGEST, [1.0, 0.0, 0.0, 0.0], multiply(conjugate(own), middle))
    return SideBias(chain.names, turns, angles, pose, len(chosen))


def without_bias(chain: FeatureSequence, bias: SideBias) -> FeatureSequence:
    """Take the bias of the sides out of a kinematic chain.

    Parameters
    ----------
    chain : FeatureSequence
        T frames.
    bias : SideBias
        Measured in this recording, or in another of the same suit and person.

    Returns
    -------
    FeatureSequence
        In which the posture of reference is the same on both sides.

    Raises
    ------
    ParameterError
        When the two are of other links.
    """
    if chain.names != bias.names:
        raise ParameterError(
            f"The bias is of {', '.join(bias.names)}; the chain has {', '.join(chain.names)}."
        )
    values = multiply(chain.values.reshape(len(chain), -1, 4), bias.turns)
    return chain.replace(values=(values * towards_mean(values)).reshape(len(chain), -1))


def _mean(chain: FeatureSequence) -> np.ndarray:
    """Mean rotation of each link: the principal axis of the sum of q qᵀ."""
    values = chain.values.reshape(len(chain), -1, 4)
    seen = np.where(np.isfinite(values), values, 0.0)
    if not (seen != 0).any(axis=(0, 2)).all():
        raise DataError("A link of the body is never seen, so that its sides cannot be compared.")
    mean = np.linalg.eigh(np.einsum("tji,tjk->jik", seen, seen))[1][..., -1]
    return (mean * np.where(mean[:, :1] < 0, -1.0, 1.0)).ravel()


def _standing(chain: FeatureSequence) -> np.ndarray:
    """Which frames show a person who stands still, upright, with legs that are straight and arms that hang."""
    values = chain.values.reshape(len(chain), -1, 4)
    if not set(chain.names) <= set(CHAIN_LINKS):
        raise ParameterError("Standing is told by a kinematic chain, and this is none.")
    stands = np.ones(len(chain), dtype=bool)
    with np.errstate(invalid="ignore"):  # an unseen link stands in nobody's way
        for k, name in enumerate(chain.names):
            side, _, link = name.rpartition("_")
            if link in ("femur", "humerus"):
                along = rotate(values[:, k], rest_axes(link, side)[0])
                off = np.arccos(np.clip(-along[:, 1], -1.0, 1.0))
                stands &= ~(off > (LEANING if link == "femur" else HANGING))
            elif link in ("pelvis", "tibia", "radius"):
                off = 2.0 * np.arccos(np.clip(np.abs(values[:, k, 0]), 0.0, 1.0))
                stands &= ~(off > {"pelvis": LEANING, "tibia": LEANING, "radius": STRAIGHT}[link])
    return stands & (_speed(chain) < STILL_RAD_S)


def _speed(chain: FeatureSequence) -> np.ndarray:
    """Mean angular speed of the links, radians a second, at each frame."""
    span = max(1, round(SPEED_S * chain.rate))
    values = chain.values.reshape(len(chain), -1, 4)
    if len(values) <= span:
        return np.zeros(len(values))
    speed = np.nanmean(geodesic_angle(values[span:], values[:-span]), axis=1) * chain.rate / span
    return np.interp(np.arange(len(values)), np.arange(len(speed)) + span / 2, speed)
