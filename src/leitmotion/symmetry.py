"""Find the motifs of a recording's symmetry: chain, bias, double metric and taxonomy in one call."""

from __future__ import annotations

import numpy as np

from leitmotion.comparing import Mirrored, compare_with_mirror
from leitmotion.describing import Recording, Roles
from leitmotion.discovery import Symmetry, SymmetrySpan
from leitmotion.discovery import find_symmetry as find_in_moments
from leitmotion.features import side_ways

POSTURES = ("stillness", "state_repetition", "reflected_state_repetition")


def find_symmetry(
    recording: Recording,
    *,
    metric: str = "inner",
    weights: str = "equal",
    bias: str = "none",
    beta: float | None = None,
    min_still_s: float = 0.5,
    body_map: Roles | None = None,
    mirrored: Mirrored | None = None,
) -> Symmetry:
    """Find what a movement is like in space and in time: the taxonomy of paper S, chapter 3.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person in three dimensions.
    metric, weights, bias, beta, body_map
        As for :func:`leitmotion.compare_with_mirror`.
    min_still_s : float
        How long stillness lasts at least, seconds.
    mirrored : Mirrored, optional
        What :func:`leitmotion.compare_with_mirror` made of this recording, with the same options.

    Returns
    -------
    Symmetry
        Its stretches in frames of the recording; its parameters tell β, what counts as half alike, and the bias that
        was taken out.

    Raises
    ------
    ParameterError
        When an option is unknown, or `min_still_s` is not positive.
    DataError
        When the recording is planar, its trunk or a side is unknown, or nobody stands still.

    Examples
    --------
    >>> import leitmotion as lm
    >>> found = lm.find_symmetry(lm.compose_session(seed=0, rate=30.0).motion)
    >>> found.frames == len(lm.compose_session(seed=0, rate=30.0).motion)
    True
    """
    made = mirrored or compare_with_mirror(
        recording, metric=metric, weights=weights, bias=bias, beta=beta, body_map=body_map
    )
    found = motifs_in(made, recording, min_still_s=min_still_s)
    return found.replace(parameters=found.parameters | {"weights": weights})


def motifs_in(mirrored: Mirrored, recording: Recording, *, min_still_s: float = 0.5) -> Symmetry:
    """Find the motifs in a recording that was compared with its mirror image.

    Parameters
    ----------
    mirrored : Mirrored
        What :func:`leitmotion.compare_with_mirror` tells of it.
    recording : Motion, Trajectories or Body
        The recording.
    min_still_s : float
        How long stillness lasts at least, seconds.

    Returns
    -------
    Symmetry
        Its stretches in frames of the recording.
    """
    told = find_in_moments(mirrored.distances, min_still_s=min_still_s)
    taken = mirrored.bias
    parameters = {
        **told.parameters,
        "moments_per_s": mirrored.distances.rate,
        "bias": "none" if taken is None else taken.pose,
        "largest_bias_deg": None if taken is None else float(np.degrees(taken.angles.max())),
    }
    frames = len(recording)
    return Symmetry(
        tuple(_in_frames(_with_sides(span, mirrored), mirrored.every, frames) for span in told.spans),
        recording.rate,
        frames,
        parameters,
        told.strikes * mirrored.every,
    )


def _with_sides(span: SymmetrySpan, mirrored: Mirrored) -> SymmetrySpan:
    """Tell which side makes the movement of a stretch; a posture is none."""
    if span.motif in POSTURES or (told := side_ways(mirrored.chain[span.start : span.stop])) is None:
        return span
    sided = span.replace(left_share=told.left_share)
    return sided.replace(links=told.links) if sided.side in ("left", "right") else sided


def _in_frames(span: SymmetrySpan, every: int, frames: int) -> SymmetrySpan:
    """A moment is its frame and those until the next."""
    later = span.partner
    return span.replace(
        start=span.start * every,
        stop=min(span.stop * every, frames),
        partner=None if later is None else (later[0] * every, min(later[1] * every, frames)),
        marks=span.marks * every,
    )
