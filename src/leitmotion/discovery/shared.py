"""What several recordings share: movements, where in which recording they occur, and the pairs that show it.

Conventions
-----------
Recordings are told by their place in the order given, from 0. Frames are half-open and of the recording's own rate.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from leitmotion.discovery.pattern import KINDS
from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, noun, set_array, set_names


@noun
class Places(Noun):
    """Stretches of time of several recordings, in order of recording and time.

    Parameters
    ----------
    recordings : (S,) int
        Which recording.
    starts, stops : (S,) int
        Frames of that recording, half-open.
    scores : (S,) float, optional
        How sure each is; NaN where nobody said.

    Raises
    ------
    ParameterError
        When shapes disagree, one is empty or begins before frame 0, or they do not stand in order without overlap.

    Examples
    --------
    >>> places = Places([0, 2], [10, 0], [40, 30], [0.9, 0.8])
    >>> list(places)
    [(0, 10, 40, 0.9), (2, 0, 30, 0.8)]
    """

    recordings: np.ndarray
    starts: np.ndarray
    stops: np.ndarray
    scores: np.ndarray | None = None

    def __post_init__(self) -> None:
        recordings = set_array(self, "recordings", dtype=np.int64, shape=(None,))
        count = len(recordings)
        starts = set_array(self, "starts", dtype=np.int64, shape=(count,))
        stops = set_array(self, "stops", dtype=np.int64, shape=(count,))
        if self.scores is None:
            object.__setattr__(self, "scores", np.full(count, np.nan))
        set_array(self, "scores", dtype=np.float64, shape=(count,), finite=False)
        if (starts < 0).any() or (stops <= starts).any():
            raise ParameterError("Places must begin at frame 0 or later and end after they begin.")
        step = np.diff(recordings)
        if (step < 0).any() or ((step == 0) & (starts[1:] < stops[:-1])).any():
            raise ParameterError("Places must stand in order of recording and time, without overlap.")

    def __len__(self) -> int:
        return len(self.recordings)

    def __iter__(self) -> Iterator[tuple[int, int, int, float]]:
        assert self.scores is not None
        columns = (self.recordings, self.starts, self.stops, self.scores)
        return iter(zip(*(column.tolist() for column in columns), strict=True))

    def of(self, recording: int) -> list[tuple[int, int, float]]:
        """Start, stop and score of those in one recording.

        Parameters
        ----------
        recording : int
            Its place, from 0.
        """
        return [(start, stop, score) for where, start, stop, score in self if where == recording]


@noun
class SharedPattern(Noun):
    """A movement that recurs in one recording or in several.

    Parameters
    ----------
    id : str
        Its letter.
    kind : {"cyclic", "acyclic"}
        Whether it repeats continuously somewhere.
    occurrences : Places
        At least two; of a cyclic pattern one per cycle. The score is the likeness of each to the others, 0 to 1.
    stretches : Places
        The stretches of time that hold the occurrences; of an acyclic pattern the occurrences.
    period_s : float
        Median length of an occurrence, seconds.
    cost : float
        Mean distance between occurrences along their warping paths: radians of limb directions; of postures metres on
        a body of mean size where all recordings are in metres, else body sizes.
    confidence : float
        0 to 1.
    reason : str
        Why that confidence, in words.

    Raises
    ------
    ParameterError
        When the kind is unknown or there are fewer than two occurrences.
    """

    id: str
    kind: str
    occurrences: Places
    stretches: Places
    period_s: float
    cost: float
    confidence: float
    reason: str = ""

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ParameterError(f"SharedPattern.kind must be one of {', '.join(KINDS)}, got {self.kind!r}.")
        if len(self.occurrences) < 2:
            raise ParameterError(f"A pattern must occur at least twice, got {len(self.occurrences)}.")

    @property
    def recordings(self) -> tuple[int, ...]:
        """The recordings in which it occurs."""
        return tuple(np.unique(self.occurrences.recordings).tolist())

    @property
    def cycles(self) -> int:
        """How many cycles a cyclic pattern has in all; 0 of an acyclic one."""
        return len(self.occurrences) if self.kind == "cyclic" else 0


@noun
class SharedPair(Noun):
    """Two stretches of time, of one recording or of two, that show the same movement, moment by moment.

    Parameters
    ----------
    pattern : str
        Id of the pattern.
    recordings : (2,) int
        Which recordings; of one recording twice, the earlier stretch stands first.
    path : (K, 2) int
        The warping path: frames of the first and of the second, each of its own recording, never decreasing.
    cost : float
        Mean distance along the path, as :class:`SharedPattern` has it.
    """

    pattern: str
    recordings: np.ndarray
    path: np.ndarray
    cost: float

    def __post_init__(self) -> None:
        set_array(self, "recordings", dtype=np.int64, shape=(2,))
        set_array(self, "path", dtype=np.int64, shape=(None, 2))

    @property
    def a(self) -> tuple[int, int, int]:
        """The first stretch: recording, start and stop."""
        return int(self.recordings[0]), int(self.path[0, 0]), int(self.path[-1, 0]) + 1

    @property
    def b(self) -> tuple[int, int, int]:
        """The second stretch: recording, start and stop."""
        return int(self.recordings[1]), int(self.path[0, 1]), int(self.path[-1, 1]) + 1


@noun
class SharedPatterns(Noun):
    """Everything that recurs in several recordings taken together.

    Parameters
    ----------
    patterns : tuple of SharedPattern
        Those of two or more recordings first; of each kind the one that fills most time first.
    pairs : tuple of SharedPair
        Paths between two occurrences of one pattern, at most one for each two.
    names : tuple of str, R
        Of the recordings; they may be alike.
    rates : (R,) float
        Frames per second of each.
    frames : (R,) int
        How long each is.
    parameters : dict
        What was looked for and how; "features" are the joints that were compared.
    nearest_miss : str
        When no two recordings share anything: what came nearest, with its number; else empty.

    Raises
    ------
    ParameterError
        When a pattern or pair names a recording that is not there, or frames beyond its end.
    """

    patterns: tuple[SharedPattern, ...]
    pairs: tuple[SharedPair, ...]
    names: tuple[str, ...]
    rates: np.ndarray
    frames: np.ndarray
    parameters: dict[str, object]
    nearest_miss: str = ""

    def __post_init__(self) -> None:
        names = set_names(self, "names", unique=False, empty=True)
        set_array(self, "rates", dtype=np.float64, shape=(len(names),))
        frames = set_array(self, "frames", dtype=np.int64, shape=(len(names),))
        object.__setattr__(self, "parameters", dict(self.parameters))
        held = [place for pattern in self.patterns for place in (*pattern.occurrences, *pattern.stretches)]
        ends = [(place[0], place[2]) for place in held] + [
            (end[0], end[2]) for pair in self.pairs for end in (pair.a, pair.b)
        ]
        for recording, stop in ends:
            if not 0 <= recording < len(names) or stop > frames[recording]:
                raise ParameterError(
                    f"There are {len(names)} recordings, of {frames.tolist()} frames; "
                    f"recording {recording} does not reach to frame {stop}."
                )

    def __len__(self) -> int:
        return len(self.patterns)

    def __iter__(self) -> Iterator[SharedPattern]:
        return iter(self.patterns)

    @property
    def shared(self) -> tuple[SharedPattern, ...]:
        """The patterns that occur in two or more recordings."""
        return tuple(pattern for pattern in self.patterns if len(pattern.recordings) > 1)

    @property
    def counts(self) -> np.ndarray:
        """How often each pattern occurs in each recording, (R, P) int."""
        counts = np.zeros((len(self.names), len(self.patterns)), np.int64)
        for column, pattern in enumerate(self.patterns):
            np.add.at(counts[:, column], pattern.occurrences.recordings, 1)
        return counts
