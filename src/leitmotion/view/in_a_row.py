"""Several recordings as one: one after another, at one rate and one body size, for the page of what they share.

Conventions
-----------
Everybody is drawn as large as the mean body, as distances across recordings are told on it; heights above the floor
grow with it. *Row* frames count through all recordings, at :data:`ROW_RATE`; each recording begins on a whole one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.body import Body
from leitmotion.discovery import (
    Pattern,
    PatternPair,
    Patterns,
    Places,
    SharedPair,
    SharedPattern,
    SharedPatterns,
)
from leitmotion.features import FeatureSequence
from leitmotion.features.resampling import resample
from leitmotion.motion import ParameterError, Segmentation

ROW_RATE = 30.0
"""Frames per second of the row: what the page draws."""
FINE = 4
"""Times that: how finely borders of patterns are kept."""


class Row(NamedTuple):
    """Recordings one after another."""

    body: Body
    """All of them, F frames."""

    patterns: Patterns
    """What they share, in :data:`FINE` times the row's frames."""

    starts: np.ndarray
    """(R,) int: the frame at which each recording begins."""

    @property
    def stops(self) -> np.ndarray:
        """(R,) int: the frame at which each ends."""
        return np.append(self.starts[1:], len(self.body))


def in_a_row(bodies: Sequence[Body], found: SharedPatterns) -> Row:
    """Put recordings one after another.

    Parameters
    ----------
    bodies : sequence of Body
        Those that were searched, in their order.
    found : SharedPatterns
        What they share.

    Returns
    -------
    Row
        Of the roles that all bodies have.

    Raises
    ------
    ParameterError
        When the bodies are not those that were searched.
    """
    if [len(body) for body in bodies] != found.frames.tolist():
        raise ParameterError(
            f"The patterns are of recordings of {found.frames.tolist()} frames, got bodies of "
            f"{[len(body) for body in bodies]}."
        )
    roles = tuple(role for role in bodies[0].roles if all(role in body.roles for body in bodies))
    metric = all(body.unit == "m" for body in bodies)
    size = float(np.mean([body.size for body in bodies])) if metric else 1.0
    placed = [_resampled(body, roles, size / body.size) for body in bodies]
    lengths = [len(places) for places, _ in placed]
    starts = np.concatenate(([0], np.cumsum(lengths)[:-1]))
    whole = Body(
        roles,
        np.concatenate([places for places, _ in placed]),
        np.concatenate([facing for _, facing in placed]),
        ROW_RATE,
        size,
        "m" if metric else "relative",
        facing_told=all(body.facing_told for body in bodies),
    )
    patterns = Patterns(
        tuple(_pattern(pattern, found, starts, lengths) for pattern in found.patterns),
        (),
        ROW_RATE * FINE,
        found.parameters,
        found.nearest_miss,
        stripes=tuple(_stripe(pair, found, starts, lengths) for pair in found.pairs),
    )
    return Row(whole, patterns, starts)


def features_in_a_row(sequences: Sequence[FeatureSequence]) -> FeatureSequence:
    """Put what is compared one after another: of what all have, at the row's rate.

    Parameters
    ----------
    sequences : sequence of FeatureSequence
        Of each recording, in body sizes.

    Returns
    -------
    FeatureSequence
        As many frames as the row of the bodies; its scale is the mean.
    """
    first = sequences[0]
    common = tuple(name for name in first.names if all(name in one.names for one in sequences))
    pieces = []
    for one in sequences:
        values = one.values.reshape(len(one), -1, one.width)[:, [one.names.index(name) for name in common]]
        pieces.append(
            resample(one.replace(values=values.reshape(len(one), -1), names=common), ROW_RATE).values
        )
    units = {one.unit for one in sequences}
    metric = units <= {"m", "m/s"} or units == {"rad"}
    scale = float(np.mean([one.scale for one in sequences])) if metric else 1.0
    unit = first.unit if metric else "relative"
    return FeatureSequence(
        np.concatenate(pieces), common, ROW_RATE, first.invariant_to, first.width, scale, unit
    )


def _resampled(body: Body, roles: tuple[str, ...], grow: float) -> tuple[np.ndarray, np.ndarray]:
    """Positions of those roles and facing at the row's rate."""
    places = body.positions[:, [body.roles.index(role) for role in roles]] * grow
    told = np.concatenate((places.reshape(len(places), -1), body.facing[:, None]), axis=1)
    names = tuple(str(column) for column in range(told.shape[1]))
    values = resample(FeatureSequence(told, names, body.rate), ROW_RATE).values
    return values[:, :-1].reshape(len(values), *places.shape[1:]), values[:, -1]


def _pattern(
    pattern: SharedPattern, found: SharedPatterns, starts: np.ndarray, lengths: Sequence[int]
) -> Pattern:
    return Pattern(
        id=pattern.id, kind=pattern.kind,
        occurrences=_spans(pattern.occurrences, found, starts, lengths),
        stretches=_spans(pattern.stretches, found, starts, lengths),
        period_s=pattern.period_s, cost=pattern.cost, confidence=pattern.confidence, reason=pattern.reason,
    )  # fmt: skip


def _spans(places: Places, found: SharedPatterns, starts: np.ndarray, lengths: Sequence[int]) -> Segmentation:
    ends = np.array(lengths)[places.recordings] * FINE
    per_frame = ROW_RATE * FINE / found.rates[places.recordings]
    begins = np.minimum(np.round(places.starts * per_frame).astype(np.int64), ends - 1)
    closes = np.clip(np.round(places.stops * per_frame).astype(np.int64), begins + 1, ends)
    offset = starts[places.recordings] * FINE
    assert places.scores is not None
    return Segmentation(begins + offset, closes + offset, scores=places.scores, rate=ROW_RATE * FINE)


def _stripe(
    pair: SharedPair, found: SharedPatterns, starts: np.ndarray, lengths: Sequence[int]
) -> PatternPair:
    ends = np.array(lengths)[pair.recordings] * FINE
    per_frame = ROW_RATE * FINE / found.rates[pair.recordings]
    path = np.minimum(np.round(pair.path * per_frame).astype(np.int64), ends - 1)
    path = path + starts[pair.recordings] * FINE
    return PatternPair(pair.pattern, path if path[0, 0] <= path[0, 1] else path[:, ::-1], pair.cost)
