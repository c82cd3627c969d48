"""What a search may have missed: pairs of stretches, among those that no pattern holds, whose movements correlate.

Conventions
-----------
Moments are of the working rate, frames of the recording. The *left-over* stretches are those outside every pattern;
put one behind the other they are the sequence R of paper P. No window reaches across a seam of R.

References
----------
Paper P (Tang, Leung, Komura, Shum, 2008), section 3, eq. 6. The equation is missing in our copy; docs/papers/P.md
tells how it was read.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.pattern import Patterns
from leitmotion.features.resampling import resample
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, check_rate, noun
from leitmotion.motion.segmentation import Segmentation

WORKING_RATE = 30.0  # hertz
MIN_SPREAD = 0.003  # body sizes: the sway of a person who stands is about half of it
STILL_AXIS = 0.01  # of what a window moves in all: an axis with less has no coefficient
BLOCK = 64  # windows that slide at once: bounds the memory


@noun
class Candidate(Noun):
    """Two stretches that no pattern holds and that move alike: what may have been missed.

    Parameters
    ----------
    a, b : (int, int)
        The earlier and the later stretch, frames ``[start, stop)``; they do not overlap.
    correlation : float
        Mean over their windows of r_R (paper P, eq. 6), at most 1.
    """

    a: tuple[int, int]
    b: tuple[int, int]
    correlation: float


@noun
class Residual(Noun):
    """What is left over by the patterns of a recording, and what in it moves alike.

    Parameters
    ----------
    candidates : tuple of Candidate
        The best first: by their correlation times their length.
    left_over : Segmentation
        The stretches outside every pattern, in order.
    rate : float
        Frames per second of the recording.
    parameters : dict
        Window, least correlation and working rate.
    """

    candidates: tuple[Candidate, ...]
    left_over: Segmentation
    rate: float
    parameters: dict[str, object]

    def __post_init__(self) -> None:
        check_rate(self)
        object.__setattr__(self, "parameters", dict(self.parameters))

    def __len__(self) -> int:
        return len(self.candidates)

    def __iter__(self) -> Iterator[Candidate]:
        return iter(self.candidates)


class Match(NamedTuple):
    """One window and the place at which it correlates, both as first moments."""

    window: int
    place: int
    correlation: float


def search_residual(
    features: FeatureSequence,
    patterns: Patterns,
    *,
    window_s: float = 0.5,
    min_correlation: float = 0.5,
    min_spread: float = MIN_SPREAD,
) -> Residual:
    """Search what the patterns left over for movements that were missed (paper P, section 3).

    What is left over is cut into windows, and each slides over all that follows it; the half before it is the same
    pairs once more. On an axis, r is one coefficient of all joints: what they move about their own mean places in the
    one window against the same in the other. r_R is the mean over the axes.

    Parameters
    ----------
    features : FeatureSequence
        Postures, T frames, in which the patterns were found.
    patterns : Patterns
        What was found.
    window_s : float
        Length of a window, seconds; a left-over stretch shorter than this is not searched.
    min_correlation : float
        What r_R must exceed.
    min_spread : float
        A window keeps still when its joints stay nearer than this to their mean places (root of the mean square), in
        the values of the features: stillness has no correlation.

    Returns
    -------
    Residual
        Windows that follow one another and match places that do are one candidate.

    Raises
    ------
    ParameterError
        When the window is not positive, the correlation not within [0, 1), the spread negative, or the patterns are of
        another recording.

    Examples
    --------
    >>> t = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    >>> wave, rest = np.sin(t + np.sin(t)), np.zeros(60)
    >>> hand = np.concatenate([wave, rest, 2 * wave])[:, None] * [0.2, 1.0, 0.0]
    >>> features = FeatureSequence(hand, ("hand",), rate=30, width=3)
    >>> best = search_residual(features, Patterns((), (), 30, {})).candidates[0]
    >>> best.a, best.b, round(best.correlation, 2)
    ((0, 60), (120, 180), 1.0)
    """
    if not 0 < window_s < np.inf:
        raise ParameterError(f"window_s must be positive and finite, got {window_s}.")
    if not 0 <= min_correlation < 1:
        raise ParameterError(f"min_correlation must lie in [0, 1), got {min_correlation}.")
    if not 0 <= min_spread < np.inf:
        raise ParameterError(f"min_spread must be 0 or more and finite, got {min_spread}.")
    if not np.isclose(patterns.rate, features.rate):
        raise ParameterError(
            f"The patterns are of a recording at {patterns.rate:g} Hz, this one is at {features.rate:g} Hz."
        )
    last = max((int(pattern.stretches.stops[-1]) for pattern in patterns), default=0)
    if last > len(features):
        raise ParameterError(f"The patterns reach to frame {last}, but there are {len(features)} frames.")
    left_over = _left_over(patterns, len(features), features.rate)
    work = resample(features, WORKING_RATE)
    length = max(2, round(window_s * WORKING_RATE))
    ratio = features.rate / WORKING_RATE
    spans = [(int(np.ceil(a / ratio)), min(int(b / ratio), len(work))) for a, b, _, _ in left_over]
    spans = [(start, stop) for start, stop in spans if stop - start >= length]
    matches = (
        _matches(standardised(work, length, min_spread), spans, length, min_correlation) if spans else []
    )
    chains = _merge(matches, spans, length)

    def frames(start: int, stop: int) -> tuple[int, int]:
        return round(start * ratio), min(round(stop * ratio), len(features))

    candidates = [
        Candidate(
            frames(chain[0].window, chain[-1].window + length),
            frames(chain[0].place, chain[-1].place + length),
            float(np.mean([match.correlation for match in chain])),
        )
        for chain in chains
    ]
    candidates.sort(key=lambda c: (-c.correlation * (c.a[1] - c.a[0]), c.a, c.b))
    parameters: dict[str, object] = {
        "window_s": window_s, "min_correlation": min_correlation, "min_spread": min_spread,
        "working_rate_hz": WORKING_RATE,
    }  # fmt: skip
    return Residual(tuple(candidates), left_over, features.rate, parameters)


def _left_over(patterns: Patterns, frames: int, rate: float) -> Segmentation:
    """List the stretches outside every pattern: the paper's R, its seams kept."""
    held = np.zeros(frames + 2, np.bool_)
    held[[0, -1]] = True
    for pattern in patterns:
        for start, stop, _, _ in pattern.stretches:
            held[start + 1 : stop + 1] = True
    edges = np.flatnonzero(np.diff(held.astype(np.int8))).reshape(-1, 2)
    return Segmentation(edges[:, 0], edges[:, 1], rate=rate)


class Movement(NamedTuple):
    """What the joints do within each window of a length, P windows, one at every moment."""

    axes: tuple[np.ndarray, ...]
    """Of each axis (P, joints · length) float32: centred joint by joint, of norm 1, or 0 where the axis is still."""
    moves: tuple[np.ndarray, ...]
    """Of each axis (P,) bool: whether it moves."""
    still: np.ndarray
    """(P,) bool: whether the window keeps still on all axes."""

    def of(self, which: np.ndarray) -> Movement:
        """Choose some of the windows."""
        return Movement(
            tuple(z[which] for z in self.axes), tuple(m[which] for m in self.moves), self.still[which]
        )


def standardised(work: FeatureSequence, length: int, min_spread: float) -> Movement:
    """Centre each joint of each window on every axis, and scale the axis to norm 1.

    Parameters
    ----------
    work : FeatureSequence
        N moments. A joint that is not seen throughout a window adds nothing to it.
    length : int
        Of a window, moments.
    min_spread : float
        Root of the mean square of what the joints move about their mean places; with less a window keeps still.

    Returns
    -------
    Movement
        P = N - length + 1 windows.
    """
    axes, norms = [], []
    for axis in range(work.width):
        values = work.values[:, axis :: work.width].astype(np.float32)
        z = np.lib.stride_tricks.sliding_window_view(values, length, axis=0)  # (P, joints, length)
        z = np.nan_to_num(z - z.mean(axis=2, keepdims=True)).reshape(len(z), -1)
        axes.append(z)
        norms.append(np.linalg.norm(z, axis=1))
    whole = np.linalg.norm(norms, axis=0)
    moves = tuple(norm > STILL_AXIS * whole for norm in norms)
    for z, norm, moving in zip(axes, norms, moves, strict=True):
        z /= np.where(moving, norm, np.inf)[:, None]
    return Movement(tuple(axes), moves, whole <= min_spread * np.sqrt(length * len(work.names)))


def correlations(windows: Movement, places: Movement) -> np.ndarray:
    """Average the coefficients of the axes: r_R of every window with every place (paper P, eq. 6).

    Parameters
    ----------
    windows, places : Movement
        W and P windows of one length.

    Returns
    -------
    (W, P) float32
        An axis that is still in both is left out of the mean; one that is in one of them counts as 0. Where a whole
        window keeps still there is no correlation: NaN.
    """
    total = sum(a @ b.T for a, b in zip(windows.axes, places.axes, strict=True))
    count = sum((a[:, None] | b).astype(np.int8) for a, b in zip(windows.moves, places.moves, strict=True))
    return np.where(windows.still[:, None] | places.still, np.nan, total / np.maximum(count, 1))


def _matches(
    movement: Movement, spans: Sequence[tuple[int, int]], length: int, least: float
) -> list[list[Match]]:
    """Slide every window over what follows it; of places that overlap one another the best is kept."""
    places = _within(spans, length, 1)
    windows = _within(spans, length, length)
    sliding = movement.of(places)
    matches = []
    for start in range(0, len(windows), BLOCK):
        block = windows[start : start + BLOCK]
        r = correlations(movement.of(block), sliding)
        matches += [
            _peaks(int(window), places, line, length, least) for window, line in zip(block, r, strict=True)
        ]
    return matches


def _within(spans: Sequence[tuple[int, int]], length: int, step: int) -> np.ndarray:
    """First moments of the windows within the spans, every `step`."""
    starts = [np.arange(start, stop - length + 1, step) for start, stop in spans]
    return np.concatenate([np.zeros(0, np.int64), *starts])


def _peaks(window: int, places: np.ndarray, r: np.ndarray, length: int, least: float) -> list[Match]:
    """Take the places after the window that correlate, the best of those that overlap one another."""
    later = np.flatnonzero((places >= window + length) & (r > least))
    taken: list[int] = []
    free = np.ones(len(places), np.bool_)
    for k in later[np.argsort(-r[later], kind="stable")].tolist():
        if free[k]:
            taken.append(k)
            near = np.searchsorted(places, [places[k] - length + 1, places[k] + length])
            free[near[0] : near[1]] = False
    return [Match(window, int(places[k]), min(float(r[k]), 1.0)) for k in sorted(taken)]


def _merge(
    matches: Sequence[Sequence[Match]], spans: Sequence[tuple[int, int]], length: int
) -> list[list[Match]]:
    """Chain matches of windows that follow one another to places that do, within slope [1/2, 3/2].

    Both sides of a chain stay within one left-over stretch and do not overlap. The matches of a window stand in
    order of their places, at least a window apart.
    """
    starts = [start for start, _ in spans]
    chains: list[list[Match]] = []
    growing: list[list[Match]] = []
    for row in matches:
        places = [match.place for match in row]
        taken: set[int] = set()
        grown = []
        for chain in sorted(growing, key=lambda c: -sum(match.correlation for match in c)):
            last = chain[-1]
            wanted = last.place + length
            nearest = bisect_left(places, wanted)
            near = [k for k in (nearest - 1, nearest) if 0 <= k < len(row) and k not in taken]
            k = min(near, key=lambda k: abs(places[k] - wanted), default=None)
            if (
                k is not None
                and row[k].window == last.window + length
                and 2 * abs(places[k] - wanted) <= length
                and row[k].window + length <= chain[0].place
                and bisect_right(starts, places[k]) == bisect_right(starts, last.place)
            ):
                taken.add(k)
                chain.append(row[k])
                grown.append(chain)
        fresh = [[match] for k, match in enumerate(row) if k not in taken]
        chains += fresh
        growing = grown + fresh
    return chains
