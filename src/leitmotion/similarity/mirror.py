"""The double metric: how far every posture is from every other, and from the mirror image of every other.

Conventions
-----------
D(a, b) is the distance of two postures, D*(a, b) that of a to the mirror image of b; both are symmetric, and D*(a, a)
is 0 where a posture is its own mirror image. Likeness is Z = exp(-β D) and Z* = exp(-β D*): 1 is the same. Where Z
falls to one half two postures are *half alike*.

References
----------
Paper S, sections 2.13, 2.14 and 3.1 to 3.3. The absolute value of the inner product is taken link by link, since q and
-q are one rotation; the mean over the links is a cost that fails the triangle inequality, which the geodesic angle
keeps.
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from leitmotion.body import mirror_role
from leitmotion.features import FeatureSequence, mirrored
from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, check_rate, noun, set_array, set_names
from leitmotion.motion.segmentation import Segmentation
from leitmotion.similarity.distance import _across_time, _blank

MIRROR_METRICS = ("inner", "geodesic")
SHARE_ALIKE = 1 / 3  # of the distance that is usual in a recording, where two moments are half alike
LEAST, MOST = np.radians(5.0), np.radians(16.0)  # per link: bounds of it, whatever the recording
SAMPLED = 1000  # moments that the usual distance is told from


@noun
class DoubleMetric(Noun):
    """Distances between the moments of one recording, and between them and their mirror images.

    Parameters
    ----------
    own : (T, T) float32
        D: of moment i to moment j.
    mirror : (T, T) float32
        D*: of moment i to the mirror image of moment j. The diagonal tells how lopsided a posture is.
    metric : {"inner", "geodesic"}
        "inner" is 1 - abs(q · r) of paper S, "geodesic" the angle of the turn in radians; the mean over the links.
    rate : float
        Moments a second.
    names : tuple of str, L
        The links.
    weights : (L,) float
        How much each counts; they sum to 1.
    beta : float
        β, the sensitivity of the likeness, in 1 over the unit of the metric.

    Raises
    ------
    ParameterError
        When the shapes disagree, or β is not positive.
    """

    own: np.ndarray
    mirror: np.ndarray
    metric: str
    rate: float
    names: tuple[str, ...]
    weights: np.ndarray
    beta: float

    def __post_init__(self) -> None:
        names = set_names(self, "names")
        frames = set_array(self, "own", dtype=np.float32, shape=(None, None), finite=False).shape[0]
        set_array(self, "mirror", dtype=np.float32, shape=(frames, frames), finite=False)
        set_array(self, "weights", dtype=np.float64, shape=(len(names),))
        check_rate(self)
        if not (np.isfinite(self.beta) and self.beta > 0):
            raise ParameterError(f"beta must be a positive number, got {self.beta}.")

    def __len__(self) -> int:
        return self.own.shape[0]

    @property
    def half(self) -> float:
        """The distance at which two postures are half alike: ln 2 / β."""
        return float(np.log(2.0) / self.beta)

    @property
    def half_angle(self) -> float:
        """The same as a turn of every link, radians."""
        return float(link_angle(self.half, self.metric))

    @property
    def lopsidedness(self) -> np.ndarray:
        """(T,) distance of each posture to its own mirror image: the diagonal of D*."""
        return np.ascontiguousarray(np.diagonal(self.mirror))


def double_metric(
    chain: FeatureSequence,
    *,
    metric: str = "inner",
    weights: Sequence[float] | np.ndarray | None = None,
    beta: float | None = None,
) -> DoubleMetric:
    """Compare every moment of a recording with every other, and with the mirror image of every other.

    Parameters
    ----------
    chain : FeatureSequence
        A kinematic chain with both sides (:func:`leitmotion.features.kinematic_chain`): T moments of L links.
    metric : {"inner", "geodesic"}
        The cost of paper S, or the angle, which is a metric.
    weights : (L,) float, optional
        How much each link counts, 0 or more, the same for both sides; by default all count alike.
    beta : float, optional
        β of the likeness; by default what :func:`choose_beta` tells of this recording.

    Returns
    -------
    DoubleMetric
        Both (T, T), symmetric to the bit, D with a diagonal of zeros. A link that is unseen in either moment is left
        out of the mean; moments that share none are NaN apart.

    Raises
    ------
    ParameterError
        When the features are no such chain, the metric is unknown, or the weights differ between the sides.
    DataError
        When the matrices would not fit in memory.

    Examples
    --------
    >>> from leitmotion.datasets import compose_session
    >>> from leitmotion.features import kinematic_chain
    >>> chain = kinematic_chain(compose_session(seed=0, rate=30.0).motion)[::30]
    >>> found = double_metric(chain)
    >>> bool((found.own == found.own.T).all() and (found.mirror == found.mirror.T).all())
    True
    """
    if metric not in MIRROR_METRICS:
        raise ParameterError(f"metric must be one of {', '.join(MIRROR_METRICS)}, got {metric!r}.")
    image = mirrored(chain) if chain.width == 4 and not chain.weights else None
    if image is None:
        raise ParameterError(
            "The mirror images of these features are not known.",
            remedy="Take a kinematic chain with the links of both sides, and give weights here.",
        )
    shares = _shares(chain.names, weights)
    memory = _blank(len(chain), 2 * len(chain))
    own, mirror = memory.reshape(2, len(chain), len(chain))
    from leitmotion.similarity import _mirror_kernels as kernels

    kind = kernels.INNER if metric == "inner" else kernels.GEODESIC
    rows, images = (_across_time(each, np.zeros(each.values.shape[1])) for each in (chain, image))
    with ThreadPoolExecutor(2) as both:  # the kernels let go of the interpreter, and share nothing
        jobs = [
            both.submit(kernels.distances, rows, columns, shares.astype(np.float32), kind, filled)
            for columns, filled in ((rows, own), (images, mirror))
        ]
        for job in jobs:
            job.result()
    seen = np.isfinite(np.diagonal(own))
    np.fill_diagonal(
        own, np.where(seen, np.float32(0), np.float32(np.nan))
    )  # to the bit, though |q| is rounded
    for array in (memory, own, mirror):  # what is read-only down to its memory is taken over, not copied
        array.flags.writeable = False
    return DoubleMetric(
        own,
        mirror,
        metric,
        chain.rate,
        chain.names,
        shares,
        choose_beta(own, metric) if beta is None else beta,
    )


def choose_beta(own: np.ndarray, metric: str = "inner") -> float:
    """Choose β so that the picture of a recording has contrast.

    Two moments are half alike at a third of the distance that is usual in the recording, the median over all pairs of
    moments, as an angle; at 5 degrees a link at least, which is noise, and at 16 at most, beyond which postures are not
    alike however far apart others are. Being a median over time it does not depend on the rate.

    Parameters
    ----------
    own : (T, T) float
        D.
    metric : {"inner", "geodesic"}
        What it is measured in.

    Returns
    -------
    float
        ln 2 over the distance of half likeness.

    Examples
    --------
    >>> round(choose_beta(np.array([[0.0, 0.6], [0.6, 0.0]]), "geodesic"), 2)
    3.47
    """
    stride = max(1, len(own) // SAMPLED)
    sample = own[::stride, ::stride]
    sample = sample[np.isfinite(sample) & ~np.eye(len(sample), dtype=bool)]
    usual = float(np.median(sample)) if sample.size else 0.0
    half = float(np.clip(SHARE_ALIKE * link_angle(usual, metric), LEAST, MOST))
    return float(np.log(2.0) / (half if metric == "geodesic" else 1.0 - np.cos(half / 2.0)))


def link_angle(distances: np.ndarray | float, metric: str) -> np.ndarray:
    """Tell distances as the turn by which every link would have to differ.

    Parameters
    ----------
    distances : (...) float
        D or D*.
    metric : {"inner", "geodesic"}
        What they are measured in.

    Returns
    -------
    (...) float
        Radians, 0 to π; NaN where the distance is.

    Examples
    --------
    >>> float(np.degrees(link_angle(1 - np.cos(np.pi / 8), "inner")).round(6))
    45.0
    """
    if metric == "geodesic":
        return np.asarray(distances, dtype=np.float64)
    return np.asarray(2.0 * np.arccos(np.clip(1.0 - np.asarray(distances, dtype=np.float64), 0.0, 1.0)))


def likeness(distances: np.ndarray, beta: float) -> np.ndarray:
    """Turn distances into likeness: exp(-β D), of paper S, section 3.1.

    Parameters
    ----------
    distances : (...) float
        D or D*.
    beta : float
        β.

    Returns
    -------
    (...) float
        1 for the same, towards 0; NaN where the distance is.
    """
    return np.asarray(np.exp(-beta * np.asarray(distances)))


def symmetry_index(found: DoubleMetric) -> float:
    """Tell how symmetric a recording is on the whole: the mean of Z* over the mean of Z.

    Parameters
    ----------
    found : DoubleMetric
        T moments.

    Returns
    -------
    float
        About 1 where whatever is done is done to the other side as well, at once or at another time; 0 where nothing
        comes near the mirror image of anything. NaN where nothing is seen.

    Examples
    --------
    >>> same, other = np.zeros((2, 2)), np.full((2, 2), np.log(2.0))
    >>> round(symmetry_index(DoubleMetric(same, other, "geodesic", 30.0, ("pelvis",), [1.0], beta=1.0)), 6)
    0.5
    """
    own, mirror = (_mean_likeness(each, found.beta) for each in (found.own, found.mirror))
    return mirror / own if own > 0 else float("nan")


def _mean_likeness(distances: np.ndarray, beta: float) -> float:
    total, known = 0.0, 0
    for row in distances:  # no second matrix is made
        seen = row[np.isfinite(row)]
        total += float(likeness(seen, beta).sum(dtype=np.float64))
        known += seen.size
    return total / known if known else 0.0


def identity_width(found: DoubleMetric) -> np.ndarray:
    """Read how wide the identity axis of Z is: how long the body stays half alike to what it is at each moment.

    Paper S, section 3.2: the wider the axis, the more slowly the body moves.

    Parameters
    ----------
    found : DoubleMetric
        T moments.

    Returns
    -------
    (T,) float
        Seconds, before and after together. Where the recording, or what is seen of it, begins or ends too soon, twice
        the other side; its whole length where it does so on both. NaN where the body is unseen, and of a single
        moment, which tells nothing of how long it lasts.
    """
    ahead, behind, _ = _reaches(found)
    one = np.where(ahead < 0, behind, ahead), np.where(behind < 0, ahead, behind)
    whole = len(found) if len(found) > 1 else np.nan
    return np.where(one[0] < 0, whole, one[0] + one[1]) / found.rate


def axis_speed(found: DoubleMetric) -> np.ndarray:
    """Read how fast the body moves from the width of the identity axis.

    Parameters
    ----------
    found : DoubleMetric
        T moments.

    Returns
    -------
    (T,) float
        Radians a second of a mean link: twice the angle of half likeness over the width; NaN where that is.
    """
    return 2.0 * found.half_angle / identity_width(found)


def still_spans(found: DoubleMetric, *, min_duration_s: float = 0.5) -> Segmentation:
    """Find where the body keeps still: spans of which all moments are half alike to one another (paper S, 3.2.1).

    Parameters
    ----------
    found : DoubleMetric
        T moments.
    min_duration_s : float
        How long a span lasts at least, seconds.

    Returns
    -------
    Segmentation
        Spans that do not overlap, in moments of `found`, labelled "stillness"; the longest is taken first. An unseen
        moment is in none.

    Raises
    ------
    ParameterError
        When the duration is not positive and finite.
    """
    if not 0 < min_duration_s < np.inf:
        raise ParameterError(
            f"The least duration of stillness must be positive seconds, got {min_duration_s}."
        )
    _, _, until = _reaches(found)
    shortest = max(2, round(min_duration_s * found.rate))
    spans = [(start, _end(until, start)) for start in range(len(found))]
    taken: list[tuple[int, int]] = []
    for start, stop in sorted(spans, key=lambda span: span[0] - span[1]):
        if stop - start < shortest:
            break
        if all(stop <= other or start >= until for other, until in taken):
            taken.append((start, stop))
    taken.sort()
    return Segmentation(
        starts=np.array([start for start, _ in taken], dtype=np.int64),
        stops=np.array([stop for _, stop in taken], dtype=np.int64),
        labels=("stillness",) * len(taken),
        rate=found.rate,
    )


def _end(until: np.ndarray, start: int) -> int:
    """Where a span that begins at a moment has to end: no moment in it reaches a moment that is far from it."""
    end, stop = start + 1, int(until[start])
    while end < stop:
        stop = min(stop, int(until[end]))
        end += 1
    return stop


def _reaches(found: DoubleMetric) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    from leitmotion.similarity import _mirror_kernels as kernels

    ahead, behind, until = np.empty(len(found)), np.empty(len(found)), np.empty(len(found), dtype=np.int64)
    kernels.reaches(found.own, np.float32(found.half), ahead, behind, until)
    return ahead, behind, until


def _shares(names: tuple[str, ...], weights: Sequence[float] | np.ndarray | None) -> np.ndarray:
    given = np.ones(len(names)) if weights is None else np.asarray(weights, dtype=np.float64)
    if given.shape != (len(names),) or not (
        np.isfinite(given).all() and (given >= 0).all() and given.sum() > 0
    ):
        raise ParameterError(
            f"Each of the {len(names)} links has one weight, 0 or more and not all 0, got {given.tolist()}."
        )
    of = dict(zip(names, given, strict=True))
    uneven = [name for name in names if of[name] != of[mirror_role(name)]]
    if uneven:
        raise ParameterError(
            f"A link counts as much as its mirror partner, but {uneven[0]} weighs {of[uneven[0]]:g} and "
            f"{mirror_role(uneven[0])} {of[mirror_role(uneven[0])]:g}."
        )
    shares: np.ndarray = given / given.sum()
    return shares
