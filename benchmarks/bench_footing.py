"""Seams of summaries: how far feet slide while they stand, as they are and without holding them."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

import leitmotion as lm
from leitmotion.body import map_of
from leitmotion.features import posture
from leitmotion.motion import forward_kinematics
from leitmotion.synthesis import summarize
from leitmotion.synthesis.footing import Leg, legs_of
from recordings import locate

Row = tuple[str, str, str]
RECORDINGS = (
    "cmu86/86_01.amc",
    "mocap6/13_29.amc",
    "mocap6/13_30.amc",
    "mocap6/13_31.amc",
    "mocap6/14_06.amc",
    "perfume_dance/A_test.bvh",
    "perfume_dance/B_test.bvh",
)
STANDS = 0.03
"""Leg lengths above the floor below which a foot counts as standing, about 2.5 cm."""


def rows() -> list[Row]:
    """A line for each recording, one for all."""
    slid = {name: _slid(name) for name in RECORDINGS}
    table = [(name.rsplit("/")[-1], *_told(*slid[name])) for name in RECORDINGS]
    return [*table, ("All", *_told(*(sum(one[k] for one in slid.values()) for k in range(3))))]


def _told(seams: float, without: float, held: float) -> tuple[str, str]:
    figure = f"{100 * held:.0f} cm, {100 * without:.0f} cm when feet are not held"
    return figure, f"{seams:.0f} seams; both feet, way over the floor below 3 % of the leg's length"


def _slid(name: str) -> tuple[float, float, float]:
    """How many seams the summary has, and how far feet slide in them, metres: not held, and held."""
    motion = lm.read(locate(name))
    roles = map_of(motion)
    found = lm.find_patterns(motion)
    features = posture(lm.embody(motion))
    legs = legs_of(motion, roles)
    ways = []
    for known in (None, roles):
        summary = summarize(motion, found, features, known)
        seams = [
            (stop, start)
            for stop, start in pairwise(
                np.ravel((summary.contents.starts, summary.contents.stops), order="F")[1:]
            )
        ][::2]
        assert isinstance(summary.recording, lm.Motion)
        places = forward_kinematics(summary.recording).positions
        ways.append(sum(_way(places[stop:start], leg) for stop, start in seams for leg in legs))
    return float(len(seams)), *ways


def _way(places: np.ndarray, leg: Leg) -> float:
    """How far a foot goes over the floor while it is low, metres."""
    foot = places[:, leg.foot]
    low = foot[1:, 1] < leg.floor + STANDS * leg.length
    return float(np.linalg.norm(np.diff(foot[:, [0, 2]], axis=0), axis=1)[low].sum())
