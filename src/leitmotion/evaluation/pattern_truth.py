"""What is compared when patterns are judged: what a person saw in a recording, and what was found in it."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, noun, set_array
from leitmotion.motion.segmentation import Segmentation

SHORTEST_CYCLIC_RUN = 3.0
"""Seconds that a single run lasts at least for its cycles to make an action that recurs."""


@noun
class PatternTruth(Noun):
    """The actions that a person saw in one recording.

    Parameters
    ----------
    runs : Segmentation
        S stretches, each one action from where it begins to where it ends, in order, without overlap. An empty label
        is no action.
    unlabelled : (U, 2) int
        Spans ``[start, stop)`` whose frames carry no label although a run covers them, such as those between the
        earliest and the latest border that an annotator accepts.
    cycles : (S, 3) float
        How often the movement repeats within each run: the count, the least and the most that a person may count; NaN
        where nobody counted. By default nobody did.
    repetitions : Segmentation or None
        Every single time that the movement is performed, where that is known exactly, as in a recording that was put
        together; each lies in a run. Between two of them in one run any frame may be the border.

    Raises
    ------
    ParameterError
        When runs overlap or are out of order, or shapes disagree.

    Examples
    --------
    >>> runs = Segmentation([0, 480, 720], [480, 720, 1200], ("walk", "kick", "walk"), rate=120)
    >>> truth = PatternTruth(runs, unlabelled=[[470, 490]], cycles=[[4, 3, 5], [1, 1, 1], [4, 4, 4]])
    >>> truth.recurring
    ('walk',)
    """

    runs: Segmentation
    unlabelled: np.ndarray = ()  # type: ignore[assignment]
    cycles: np.ndarray = ()  # type: ignore[assignment]
    repetitions: Segmentation | None = None

    def __post_init__(self) -> None:
        for spans in (self.runs, self.repetitions):
            if spans is not None and (spans.starts[1:] < spans.stops[:-1]).any():
                k = int(np.flatnonzero(spans.starts[1:] < spans.stops[:-1])[0])
                raise ParameterError(
                    "The runs and repetitions of a truth must stand in order without overlap, but "
                    f"[{spans.starts[k]}, {spans.stops[k]}) is followed by [{spans.starts[k + 1]}, "
                    f"{spans.stops[k + 1]})."
                )
        if np.size(self.unlabelled) == 0:
            object.__setattr__(self, "unlabelled", np.zeros((0, 2), dtype=np.int64))
        if np.size(self.cycles) == 0:
            object.__setattr__(self, "cycles", np.full((len(self.runs), 3), np.nan))
        set_array(self, "unlabelled", dtype=np.int64, shape=(None, 2))
        set_array(self, "cycles", dtype=np.float64, shape=(len(self.runs), 3), finite=False)

    @property
    def rate(self) -> float:
        """Frames per second."""
        return self.runs.rate

    @property
    def actions(self) -> tuple[str, ...]:
        """The labels, in the order in which they first occur."""
        return tuple(dict.fromkeys(label for label in self.runs.labels if label))

    @property
    def recurring(self) -> tuple[str, ...]:
        """The actions that recur.

        They have two separate runs or more, or a run that is :attr:`cyclic`.
        """
        again = {label for label, cyclic in zip(self.runs.labels, self.cyclic, strict=True) if cyclic}
        return tuple(label for label in self.actions if label in again or len(self._separate(label)) > 1)

    @property
    def uncertain(self) -> tuple[str, ...]:
        """The actions with a single run of 3 s or more in which nobody counted, so that they may recur or not."""
        uncounted = np.isnan(self.cycles[:, :2]).all(axis=1) & self._long
        labels = {label for label, open_ in zip(self.runs.labels, uncounted, strict=True) if open_}
        return tuple(label for label in self.actions if label in labels and label not in self.recurring)

    @property
    def cyclic(self) -> np.ndarray:
        """Which runs show a movement again and again, shape (S,) bool.

        They last 3 s or more and hold two cycles or more, as far as a person counts; or two repetitions that are known
        exactly.
        """
        counted = np.where(np.isnan(self.cycles[:, 0]), self.cycles[:, 1], self.cycles[:, 0])
        known = np.array([len(self.within(k)) for k in range(len(self.runs))], dtype=np.int64)
        return np.asarray((self._long & (counted >= 2)) | (known >= 2))

    def within(self, run: int) -> np.ndarray:
        """Give the repetitions of a run that are known exactly, shape (K, 2), frames.

        Parameters
        ----------
        run : int
            The run, by its place.
        """
        if self.repetitions is None:
            return np.zeros((0, 2), dtype=np.int64)
        spans = np.stack((self.repetitions.starts, self.repetitions.stops), axis=1)
        return spans[(spans[:, 0] >= self.runs.starts[run]) & (spans[:, 1] <= self.runs.stops[run])]

    def which_run(self, frames: int) -> np.ndarray:
        """Say of each frame of a recording in which run it lies, shape (frames,); -1 where it carries no label.

        Parameters
        ----------
        frames : int
            Length of the recording.
        """
        which = np.full(frames, -1)
        for k, (start, stop, label, _) in enumerate(self.runs):
            if label:
                which[start:stop] = k
        for start, stop in self.unlabelled:
            which[max(start, 0) : max(stop, 0)] = -1
        return which

    @property
    def _long(self) -> np.ndarray:
        return np.asarray((self.runs.stops - self.runs.starts) / self.rate >= SHORTEST_CYCLIC_RUN - 1e-9)

    def _separate(self, label: str) -> list[int]:
        """The runs of an action that do not go on from the one before."""
        own = [k for k, name in enumerate(self.runs.labels) if name == label]
        return own[:1] + [m for k, m in pairwise(own) if self.runs.starts[m] > self.runs.stops[k]]


@noun
class FoundPatterns(Noun):
    """What a search found in one recording.

    Parameters
    ----------
    occurrences : Segmentation
        Each time that a pattern occurs; the label is the pattern's id. Those of different patterns may overlap.
    pairs : (K, 4) int or None
        Stretches said to show the same movement: start and stop of the one, start and stop of the other. By default
        all pairs of occurrences of one pattern.

    Raises
    ------
    ParameterError
        When a stretch of a pair stops before it starts or begins before frame 0.

    Examples
    --------
    >>> cycles = Segmentation([0, 120, 240], [120, 240, 360], ("A", "A", "A"), rate=120)
    >>> FoundPatterns(cycles).pairs.tolist()
    [[0, 120, 120, 240], [0, 120, 240, 360], [120, 240, 240, 360]]
    """

    occurrences: Segmentation
    pairs: np.ndarray | None = None

    def __post_init__(self) -> None:
        if self.pairs is None:
            object.__setattr__(self, "pairs", _all_pairs(self.occurrences))
        elif np.size(self.pairs) == 0:
            object.__setattr__(self, "pairs", np.zeros((0, 4), dtype=np.int64))
        pairs = set_array(self, "pairs", dtype=np.int64, shape=(None, 4))
        bad = np.flatnonzero(
            (pairs[:, 0::2] < 0).any(axis=1) | (pairs[:, 1::2] <= pairs[:, 0::2]).any(axis=1)
        )
        if bad.size:
            raise ParameterError(
                "The stretches of a pair must start at frame 0 or later and stop after their start, "
                f"got {pairs[bad[0]].tolist()}."
            )

    @property
    def rate(self) -> float:
        """Frames per second."""
        return self.occurrences.rate


def _all_pairs(occurrences: Segmentation) -> np.ndarray:
    spans = np.stack((occurrences.starts, occurrences.stops), axis=1)
    order = np.argsort(occurrences.starts, kind="stable").tolist()
    labels = occurrences.labels
    pairs = [
        (*spans[k], *spans[m])
        for place, k in enumerate(order)
        for m in order[place + 1 :]
        if labels[k] == labels[m]
    ]
    return np.array(pairs, dtype=np.int64).reshape(-1, 4)
