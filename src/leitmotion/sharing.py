"""What several recordings share."""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Real

from leitmotion.body import Body, map_of
from leitmotion.body import swap_sides as exchanged
from leitmotion.describing import Recording, Roles, as_body, described
from leitmotion.discovery import SharedPatterns
from leitmotion.discovery import find_shared_patterns as search
from leitmotion.features import FEATURES, FeatureSequence
from leitmotion.motion import ParameterError

OPTIONS = ("max_distance", "min_duration_s", "min_amplitude", "min_contrast")


def find_shared_patterns(
    recordings: Sequence[Recording],
    *,
    names: Sequence[str] | None = None,
    features: str = "posture",
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
    swap_sides: bool = False,
    **options: float,
) -> SharedPatterns:
    """Find what several recordings share: movements that occur in two or more, and those that recur within one.

    They are compared as by :func:`find_patterns`, each in its own body's size, by the joints that all recordings
    have. Rates, formats and people may differ.

    Parameters
    ----------
    recordings : sequence of Motion, Trajectories or Body
        Two or more, one person each.
    names : sequence of str, optional
        What to call them; by default their own names.
    features, joints, exclude, body_map, swap_sides
        As for :func:`find_patterns`, of every recording.
    **options
        "max_distance", "min_duration_s", "min_amplitude" and "min_contrast", as for
        :func:`leitmotion.discovery.find_shared_patterns`.

    Returns
    -------
    SharedPatterns
        Those of two or more recordings first; ``shared`` are these alone.

    Raises
    ------
    ParameterError
        When there are fewer than two recordings, a role, an option or the features are unknown, or nothing tells what
        counts as alike by these features.
    DataError
        When the recordings cannot be compared: one in a plane and one in space, too few joints in common.

    Examples
    --------
    >>> import leitmotion as lm
    >>> motions = [lm.read(path) for path in ("a.bvh", "b.bvh")]             # doctest: +SKIP
    >>> for pattern in lm.find_shared_patterns(motions).shared:              # doctest: +SKIP
    ...     print(pattern.id, pattern.recordings)
    """
    if not isinstance(recordings, Sequence):
        raise ParameterError(
            f"What recordings share takes a sequence of them, got {type(recordings).__name__}."
        )
    unknown = sorted(set(options) - set(OPTIONS))
    if unknown:
        raise ParameterError(
            f"What recordings share is sought without an option {unknown[0]!r}.",
            remedy=f"The options are {', '.join(OPTIONS)}.",
        )
    told = [_described(one, features, joints, exclude, body_map, swap_sides) for one in recordings]
    if features != "posture":
        alike = options.get("max_distance", FEATURES[features].alike.get("equal"))
        if alike is None:
            raise ParameterError(
                f"What counts as alike was never measured for {features}.",
                remedy="Say it with max_distance=, in the values of the features.",
            )
        if isinstance(alike, Real):
            options = {"max_distance": float(alike), "min_amplitude": float(alike) / 5} | options
    called = [one.name for one in recordings] if names is None else names
    found = search(told, names=called, **options)
    return found.replace(parameters=found.parameters | {"feature": features})


def _described(
    recording: Recording,
    features: str,
    joints: str | Sequence[str] | None,
    exclude: str | Sequence[str] | None,
    body_map: Roles | None,
    swap_sides: bool,
) -> FeatureSequence:
    """Describe one recording of several: what is wrong with what was asked for is said with its name."""
    if swap_sides and isinstance(recording, Body):
        raise ParameterError(
            "The sides of a Body are settled.", remedy="Give the recording itself to have them exchanged."
        )
    roles = (
        exchanged(map_of(recording, body_map)) if swap_sides and not isinstance(recording, Body) else body_map
    )
    if features == "posture":
        recording, roles = as_body(recording, roles), None
    try:
        return described(recording, features, joints=joints, exclude=exclude, body_map=roles)
    except ParameterError as error:
        raise ParameterError(f"{recording.name}: {error.message}", remedy=error.remedy) from None
