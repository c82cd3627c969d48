"""A segmentation: labelled stretches of time."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, check_rate, noun, set_array, set_names


@noun
class Segmentation(Noun):
    """Stretches of a recording, each with a label and a score; gaps and overlaps are allowed.

    Parameters
    ----------
    starts, stops : (S,) int
        Frames, half-open: a stretch is ``[start, stop)``.
    labels : tuple of str, S
        What each stretch is called; empty strings where it has no name.
    scores : (S,) float
        How sure each is or how well it fits; NaN where nobody said.
    rate : float
        Frames per second.

    Raises
    ------
    ParameterError
        When lengths disagree, a frame is not whole or a stretch stops before it starts.

    Examples
    --------
    >>> from leitmotion.motion import Segmentation
    >>> steps = Segmentation([0, 120], [120, 300], ("walk", "punch"), rate=120)
    >>> [(label, start / 120) for start, stop, label, score in steps]
    [('walk', 0.0), ('punch', 1.0)]
    """

    starts: np.ndarray
    stops: np.ndarray
    labels: tuple[str, ...] = ()
    scores: np.ndarray = ()  # type: ignore[assignment]
    rate: float = 0.0

    def __post_init__(self) -> None:
        count = set_array(self, "starts", dtype=np.int64, shape=(None,)).size
        set_array(self, "stops", dtype=np.int64, shape=(count,))
        if len(self.labels) == 0:
            object.__setattr__(self, "labels", ("",) * count)
        if np.size(self.scores) == 0:
            object.__setattr__(self, "scores", np.full(count, np.nan))
        set_names(self, "labels", unique=False, empty=True)
        set_array(self, "scores", dtype=np.float64, shape=(count,), finite=False)
        if len(self.labels) != count:
            raise ParameterError(
                f"Segmentation.labels must be {count}, one a stretch, got {len(self.labels)}."
            )
        backwards = np.flatnonzero((self.stops <= self.starts) | (self.starts < 0))
        if backwards.size:
            k = int(backwards[0])
            raise ParameterError(
                "A stretch must start at frame 0 or later and stop after its start, "
                f"got [{self.starts[k]}, {self.stops[k]})."
            )
        check_rate(self)

    def __len__(self) -> int:
        return self.starts.size

    def __iter__(self) -> Iterator[tuple[int, int, str, float]]:
        for start, stop, label, score in zip(self.starts, self.stops, self.labels, self.scores, strict=True):
            yield int(start), int(stop), label, float(score)

    def __getitem__(self, which: slice) -> Segmentation:
        return self.replace(
            starts=self.starts[which],
            stops=self.stops[which],
            labels=self.labels[which],
            scores=self.scores[which],
        )
