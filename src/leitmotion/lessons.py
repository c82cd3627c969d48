"""What can be made of what recurs: a summary to watch, a lesson to learn from."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from leitmotion.body import Body, map_of
from leitmotion.describing import BY_ROLE, Roles, described
from leitmotion.discovery import Lesson, Patterns
from leitmotion.discovery import make_lesson as lesson_of
from leitmotion.features import FeatureSequence
from leitmotion.motion import Motion, ParameterError, Trajectories
from leitmotion.synthesis import Summary
from leitmotion.synthesis import summarize as summary_of


def summarize(
    recording: Motion | Trajectories,
    patterns: Patterns | None = None,
    *,
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
    **options: Any,
) -> Summary:
    """Make a short recording of a long one: each movement that recurs once, one after the other.

    :func:`leitmotion.synthesis.summarize` tells what is shown of each, and how they are joined.

    Parameters
    ----------
    recording : Motion or Trajectories
        One person.
    patterns : Patterns, optional
        What recurs in this recording; by default what :func:`find_patterns` finds.
    joints, exclude, body_map
        As for :func:`find_patterns`; also what is compared to find the typical occurrences.
    **options
        Of the search, as for :func:`find_patterns`.

    Returns
    -------
    Summary
        ``recording``, of the kind of the one that was given, ``contents`` and ``sources``.

    Raises
    ------
    DataError
        When nothing recurs, or nothing tells how large the body is.
    ParameterError
        When it is a Body, which is no recording that could be written, or the patterns are of another recording.

    Examples
    --------
    >>> import leitmotion as lm
    >>> summary = lm.summarize(lm.read("dance.bvh"))          # doctest: +SKIP
    >>> lm.write(summary.recording, "short.bvh")              # doctest: +SKIP
    PosixPath('short.bvh')
    """
    if isinstance(recording, Body):
        raise ParameterError(
            "A summary is made of a recording, got a Body.", remedy="Give the Motion or Trajectories itself."
        )
    found = _found(recording, patterns, joints, exclude, body_map, options)
    postures = _postures(recording, found, joints, exclude, body_map)
    return summary_of(recording, found, postures, map_of(recording, body_map))


def make_lesson(
    recording: Motion | Trajectories | Body,
    patterns: Patterns | None = None,
    *,
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
    **options: Any,
) -> Lesson:
    """Rank what recurs, and tell of each time how it differs from the typical one.

    :func:`leitmotion.discovery.make_lesson` tells what is compared, and how.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person.
    patterns : Patterns, optional
        What recurs in this recording; by default what :func:`find_patterns` finds.
    joints, exclude, body_map
        As for :func:`find_patterns`.
    **options
        Of the search, as for :func:`find_patterns`.

    Returns
    -------
    Lesson
        The movements, most frequent first, each with its variations; none where nothing recurs.

    Raises
    ------
    DataError
        When nothing in the recording tells how large the body is.
    ParameterError
        When the patterns are of another recording.

    Examples
    --------
    >>> import leitmotion as lm
    >>> lesson = lm.make_lesson(lm.compose_session(seed=0).motion)     # doctest: +SKIP
    >>> [(step.pattern, step.count) for step in lesson.steps]          # doctest: +SKIP
    """
    found = _found(recording, patterns, joints, exclude, body_map, options)
    return lesson_of(_postures(recording, found, joints, exclude, body_map), found)


def _found(
    recording: Motion | Trajectories | Body,
    patterns: Patterns | None,
    joints: str | Sequence[str] | None,
    exclude: str | Sequence[str] | None,
    body_map: Roles | None,
    options: dict[str, Any],
) -> Patterns:
    from leitmotion.api import find_patterns

    if patterns is None:
        return find_patterns(recording, joints=joints, exclude=exclude, body_map=body_map, **options)
    if options:
        raise ParameterError(f"{min(options)!r} steers a search, but patterns= says what was found.")
    return patterns


def _postures(
    recording: Motion | Trajectories | Body,
    found: Patterns,
    joints: str | Sequence[str] | None,
    exclude: str | Sequence[str] | None,
    body_map: Roles | None,
) -> FeatureSequence:
    """Postures of the joints that were asked for; of all where the search was by features that name others."""
    if found.parameters.get("feature", "posture") not in BY_ROLE:
        joints, exclude = None, None
    return described(recording, "posture", joints=joints, exclude=exclude, body_map=body_map)
