"""Motifs of symmetry: what a movement is like in space and in time, stretch by stretch (paper S, chapter 3).

Conventions
-----------
Frames are half-open and belong to the recording's own rate. *Own* is the body itself, *mirror* its mirror image.

References
----------
Paper S, sections 3.2 to 3.5: what each motif is, and how it shows in Z and Z*.
"""

from __future__ import annotations

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, check_rate, noun, set_array

MOTIFS = (
    "stillness",
    "state_repetition",
    "path_repetition",
    "path_reversal",
    "symmetric_path",
    "reflected_state_repetition",
    "reflected_path_repetition",
    "symmetric_cycle",
    "asymmetric_cycle",
    "symmetric_palindrome",
    "asymmetric_palindrome",
    "anti_phase",
    "anti_palindrome",
)
"""The taxonomy of paper S."""

PAIRED = (
    "state_repetition",
    "path_repetition",
    "path_reversal",
    "reflected_state_repetition",
    "reflected_path_repetition",
)
"""Motifs of two stretches, the second of which is the partner."""

ONE_SIDE = 2 / 3
"""Share of the way of both sides, from which on one side is said to move more."""


@noun
class SymmetrySpan(Noun):
    """A stretch of time in which the movement has a motif.

    Parameters
    ----------
    motif : str
        One of :data:`MOTIFS`.
    start, stop : int
        The stretch, frames ``[start, stop)``: of a paired motif the earlier one, of another all of it.
    confidence : float
        0 to 1.
    cyclic : bool
        Whether it goes on without a break, twice at least.
    partner : tuple of int, optional
        Of a paired motif, the later stretch, frames ``[start, stop)``.
    marks : (M,) int
        Moments within that tell its form, frames in order: where each cycle, half-cycle or way begins, and where the
        last one ends; a palindrome turns back at every second of them.
    reason : str
        Why that confidence, in words.
    left_share : float, optional
        Way of the left arm and leg over that of both sides, 0 to 1: the sum of the angles that their links turn by in
        the stretch, of a paired motif in the earlier one. None of a posture, and where no side moves.
    links : tuple of str
        Where one side moves more, its links whose way differs most from that of their twins.

    Raises
    ------
    ParameterError
        When the motif is none, the stretch is empty, a paired motif has no partner, or the share is none.
    """

    motif: str
    start: int
    stop: int
    confidence: float
    cyclic: bool = False
    partner: tuple[int, int] | None = None
    marks: np.ndarray = ()  # type: ignore[assignment]
    reason: str = ""
    left_share: float | None = None
    links: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.motif not in MOTIFS:
            raise ParameterError(
                f"SymmetrySpan.motif must be one of {', '.join(MOTIFS)}, got {self.motif!r}."
            )
        if (self.partner is not None) != (self.motif in PAIRED):
            raise ParameterError(f"SymmetrySpan.partner belongs to these motifs: {', '.join(PAIRED)}.")
        for start, stop in ((self.start, self.stop), self.partner or (self.start, self.stop)):
            if not 0 <= start < stop:
                raise ParameterError(
                    f"A stretch begins at 0 or later and ends after it began, got {start}, {stop}."
                )
        if self.left_share is not None and not 0 <= self.left_share <= 1:
            raise ParameterError(f"SymmetrySpan.left_share is from 0 to 1, got {self.left_share}.")
        object.__setattr__(self, "links", tuple(self.links))
        set_array(self, "marks", dtype=np.int64, shape=(None,))

    @property
    def side(self) -> str:
        """Which side moves: "left" or "right" where it makes two thirds of the way or more, else "both".

        Empty where that is not known.
        """
        if self.left_share is None:
            return ""
        return (
            "left" if self.left_share >= ONE_SIDE else "right" if 1 - self.left_share >= ONE_SIDE else "both"
        )


@noun
class Symmetry(Noun):
    """All motifs of one recording.

    Parameters
    ----------
    spans : tuple of SymmetrySpan
        In order of their starts. Where two motifs fit one stretch both stand here, each with its confidence.
    rate : float
        Frames per second of the recording.
    frames : int
        How many the recording has.
    parameters : dict
        What was looked for and how: metric, β, what counts as half alike in degrees, bias, links.
    strikes : (N,) int
        Frames at which a fast movement is stopped or thrown back at once: spikes across the identity axis (3.6.3).
    """

    spans: tuple[SymmetrySpan, ...]
    rate: float
    frames: int
    parameters: dict[str, object]
    strikes: np.ndarray = ()  # type: ignore[assignment]

    def __post_init__(self) -> None:
        object.__setattr__(self, "spans", tuple(self.spans))
        set_array(self, "strikes", dtype=np.int64, shape=(None,))
        check_rate(self)
