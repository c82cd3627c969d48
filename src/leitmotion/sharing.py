"""What several recordings share."""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Real
from pathlib import Path

from leitmotion.body import Body, map_of
from leitmotion.body import swap_sides as exchanged
from leitmotion.describing import Recording, Roles, as_body, described
from leitmotion.discovery import SharedPatterns, nearest_across
from leitmotion.discovery import find_shared_patterns as search
from leitmotion.discovery.joining import LEAST_COMMON
from leitmotion.features import FEATURES, FeatureSequence, limbs_of
from leitmotion.io import write_whole
from leitmotion.motion import ParameterError

OPTIONS = ("max_distance", "min_duration_s", "min_amplitude", "min_contrast")
MOST_MOMENTS = 3000
"""Moments that the matrix of the page compares at most, of all recordings: it is drawn in 600 cells."""


def find_shared_patterns(
    recordings: Sequence[Recording],
    *,
    names: Sequence[str] | None = None,
    features: str | None = None,
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
    swap_sides: bool = False,
    **options: float,
) -> SharedPatterns:
    """Find what several recordings share: movements that occur in two or more, and those that recur within one.

    They are compared by the directions of trunk and limbs, which know nothing of proportions, as far as all recordings
    have these. Rates, formats and people may differ.

    Parameters
    ----------
    recordings : sequence of Motion, Trajectories or Body
        Two or more, one person each.
    names : sequence of str, optional
        What to call them; by default their own names.
    features : str, optional
        What of a frame is compared, as for :func:`find_patterns`. By default "limb_directions"; "posture", each in its
        own body's size, where a recording is in a plane or too few limbs are known in all, or where `joints` or
        `exclude` name what has a place.
    joints, exclude, body_map, swap_sides
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
    called = [one.name for one in recordings] if names is None else names
    if features is None:
        bodies = [as_body(one, _roles(one, body_map, swap_sides)) for one in recordings]
        features = "posture" if joints or exclude or not _have_limbs(bodies) else "limb_directions"
        recordings, body_map, swap_sides = bodies, None, False
    told = [_described(one, features, joints, exclude, body_map, swap_sides) for one in recordings]
    if features not in ("posture", "limb_directions"):
        alike = options.get("max_distance", FEATURES[features].alike.get("equal"))
        if alike is None:
            raise ParameterError(
                f"What counts as alike was never measured for {features}.",
                remedy="Say it with max_distance=, in the values of the features.",
            )
        if isinstance(alike, Real):
            options = {"max_distance": float(alike), "min_amplitude": float(alike) / 5} | options
    found = search(told, names=called, **options)
    by: dict[str, object] = {"feature": features}
    if features in ("posture", "limb_directions"):
        by["max_distance_within_one"] = FEATURES[features].alike["equal"]
    return found.replace(parameters=found.parameters | by, nearest_miss=nearest_across(told, found))


def report_shared(
    recordings: Sequence[Recording],
    path: str | Path,
    *,
    names: Sequence[str] | None = None,
    shared: SharedPatterns | None = None,
    paths: Sequence[str] = (),
    features: str | None = None,
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
    swap_sides: bool = False,
    force: bool = False,
    **options: float,
) -> Path:
    """Write the page that shows what recordings share: one HTML file that needs nothing else.

    Parameters
    ----------
    recordings : sequence of Motion, Trajectories or Body
        Two or more, one person each.
    path : path
        Where to write it, ending in ``.html``.
    names : sequence of str, optional
        What to call them; by default their own names.
    shared : SharedPatterns, optional
        What they share; by default what :func:`find_shared_patterns` finds.
    paths : sequence of str
        What the page tells about where each comes from.
    features : str, optional
        As for :func:`find_shared_patterns`; by default those by which `shared` was found.
    joints, exclude, body_map, swap_sides
        As for :func:`find_shared_patterns`.
    force : bool
        Whether an ``.html`` file that Leitmotion did not write may be replaced.
    **options
        Of the search, as for :func:`find_shared_patterns`.

    Returns
    -------
    Path
        The page that was written, whole or not at all.

    Raises
    ------
    ParameterError
        When the path does not end in ``.html`` or holds somebody else's page, `shared` is of other recordings, or as
        :func:`find_shared_patterns` says.
    DataError
        As :func:`find_shared_patterns` says.

    Examples
    --------
    >>> import leitmotion as lm
    >>> motions = [lm.read(path) for path in ("a.bvh", "b.bvh")]             # doctest: +SKIP
    >>> lm.report_shared(motions, "shared.html")                             # doctest: +SKIP
    PosixPath('shared.html')
    """
    from leitmotion.similarity import self_distance
    from leitmotion.view import shared_page
    from leitmotion.view.in_a_row import features_in_a_row
    from leitmotion.view.report import check_page

    target = Path(path)
    check_page(target, force=force)
    if shared is not None and options:
        raise ParameterError(f"{min(options)!r} steers a search, but shared= says what was found.")
    asked = {"joints": joints, "exclude": exclude, "body_map": body_map, "swap_sides": swap_sides}
    found = shared or find_shared_patterns(recordings, names=names, features=features, **asked, **options)  # type: ignore[arg-type]
    name = features or str(found.parameters.get("feature", "posture"))
    if names is not None:
        found = found.replace(names=tuple(names))
    told = [_described(one, name, joints, exclude, body_map, swap_sides) for one in recordings]
    bodies = [as_body(one, _roles(one, body_map, swap_sides)) for one in recordings]
    compared = features_in_a_row(told)
    thinned = compared[:: -(-len(compared) // MOST_MOMENTS)]
    write_whole(target, shared_page(bodies, found, self_distance(thinned), paths=paths))
    return target


def _described(
    recording: Recording,
    features: str,
    joints: str | Sequence[str] | None,
    exclude: str | Sequence[str] | None,
    body_map: Roles | None,
    swap_sides: bool,
) -> FeatureSequence:
    """Describe one recording of several: what is wrong with what was asked for is said with its name."""
    roles = _roles(recording, body_map, swap_sides)
    if features == "posture":
        recording, roles = as_body(recording, roles), None
    try:
        return described(recording, features, joints=joints, exclude=exclude, body_map=roles)
    except ParameterError as error:
        raise ParameterError(f"{recording.name}: {error.message}", remedy=error.remedy) from None


def _roles(recording: Recording, body_map: Roles | None, swap_sides: bool) -> Roles | None:
    """The map of one recording, its sides exchanged where that was asked for."""
    if not swap_sides:
        return body_map
    if isinstance(recording, Body):
        raise ParameterError(
            "The sides of a Body are settled.", remedy="Give the recording itself to have them exchanged."
        )
    return exchanged(map_of(recording, body_map))


def _have_limbs(bodies: Sequence[Body]) -> bool:
    """Whether all are in space and have limbs enough in common."""
    common = set.intersection(*(set(limbs_of(body)) for body in bodies)) if bodies else set()
    return len(common) >= LEAST_COMMON and all(body.positions.shape[2] == 3 for body in bodies)
