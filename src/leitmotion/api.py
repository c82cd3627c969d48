"""The functions a person types; with the command line the only place that joins reading, finding and showing.

A recording goes one way: :func:`read` it, ask something of it (:func:`info`, :func:`find_patterns`), and
:func:`report` or :func:`save` the answer. What takes a recording takes a :class:`Body` as well.
"""

from __future__ import annotations

import glob
import math
import re
from collections.abc import Mapping, Sequence
from numbers import Real
from pathlib import Path
from typing import Any

from leitmotion.body import Body, BodyMap, Dynamics, Flight, embody, find_roles, map_of
from leitmotion.body import dynamics as compute_dynamics
from leitmotion.body import swap_sides as exchanged
from leitmotion.calibration import Calibration, calibrate
from leitmotion.comparing import Mirrored, compare, compare_with_mirror
from leitmotion.conversion import Converted, convert
from leitmotion.datasets import compose_session
from leitmotion.describing import Recording, Roles, as_body, described, of_body, weighed
from leitmotion.discovery import (
    Lesson,
    MotionGraph,
    Pattern,
    Patterns,
    Residual,
    SharedPattern,
    SharedPatterns,
    Symmetry,
    SymmetrySpan,
)
from leitmotion.evaluating import evaluate
from leitmotion.evaluation import FoundPatterns, PatternScores, PatternTruth
from leitmotion.features import FEATURES, FeatureSequence
from leitmotion.graphing import motion_graph
from leitmotion.inspection import Info, info
from leitmotion.io import load, read, read_all, read_annotations, save, write, write_whole
from leitmotion.lessons import make_lesson, summarize
from leitmotion.motion import (
    DataError,
    FormatError,
    LeitmotionError,
    Motion,
    ParameterError,
    Segmentation,
    Skeleton,
    Trajectories,
)
from leitmotion.repairs import Repaired, repair
from leitmotion.sharing import find_shared_patterns, report_shared
from leitmotion.symmetry import find_symmetry
from leitmotion.synthesis import Summary

__all__ = [
    "Body",
    "BodyMap",
    "Calibration",
    "Converted",
    "DataError",
    "Dynamics",
    "Flight",
    "FormatError",
    "FoundPatterns",
    "Info",
    "LeitmotionError",
    "Lesson",
    "Mirrored",
    "Motion",
    "MotionGraph",
    "ParameterError",
    "Pattern",
    "PatternScores",
    "PatternTruth",
    "Patterns",
    "Repaired",
    "Residual",
    "Segmentation",
    "SharedPattern",
    "SharedPatterns",
    "Skeleton",
    "Summary",
    "Symmetry",
    "SymmetrySpan",
    "Trajectories",
    "calibrate",
    "compare",
    "compare_with_mirror",
    "compose_session",
    "convert",
    "dynamics",
    "embody",
    "evaluate",
    "find_patterns",
    "find_roles",
    "find_shared_patterns",
    "find_symmetry",
    "info",
    "load",
    "make_lesson",
    "motion_graph",
    "read",
    "read_all",
    "read_annotations",
    "repair",
    "report",
    "report_shared",
    "save",
    "search_residual",
    "summarize",
    "write",
]

DRAWN_RATE = 30.0
"""Frames per second that the page draws."""
MOST_MOMENTS = 6000
"""Moments that the page's matrix compares at most: 3 minutes at 30 a second, 144 MB."""
OPENINGS = ("repeats", "lesson", "symmetry", "graph")
"""What a page can show first."""
LONGEST_NAME = 200
"""Bytes of a page's default name at most; file systems take 255 with the ending."""


def find_patterns(
    recording: Recording,
    *,
    method: str = "recurrence",
    features: str = "posture",
    weights: str = "equal",
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
    swap_sides: bool = False,
    **options: Any,
) -> Patterns:
    """Find what recurs in a recording.

    Postures are compared without regard to where the person stands and which way they face (paper P, section 2.1),
    joint by joint (paper P, eq. 2), in body sizes.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person.
    method : {"recurrence", "tang2008"}
        How to search: by local alignment, without a parameter to set, or as paper P describes it.
    features : {"posture", "velocity", "joint_angles", "limb_directions", "joint_rotations", "kinematic_chain", ...}
        What of a frame is compared (:data:`leitmotion.features.FEATURES`). Posture, velocity, angles, directions and
        rotations are invariant to place, yaw, body size and unit; marker posture, all markers as paper P has them
        (eq. 1), to place and yaw. What counts as alike was calibrated for each (:func:`calibrate`) but the kinematic
        chain and marker posture: with these the method "recurrence" needs ``max_distance``. Unless they are postures
        with equal weights, ``min_amplitude`` is by default a fifth of it.
    weights : {"equal", "active"}
        Whether each joint counts alike, or the more the more it moves (:func:`leitmotion.features.active_weights`).
    joints : str or sequence of str, optional
        The roles to compare, with wildcards, in one text parted by commas: ``"left_*, head"``. By default those that
        every skeleton has.
    exclude : str or sequence of str, optional
        Roles to leave out, with wildcards.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role, when the names do not tell.
    swap_sides : bool
        Whether what is called left is the person's right: the roles of the two sides are exchanged, the recording
        is left as it is. Not of a Body, whose roles are settled.
    **options
        Of the method, such as ``stillness=True``; :func:`leitmotion.discovery.find_patterns` tells them, and refuses
        what it does not know.

    Returns
    -------
    Patterns
        The patterns, most time first; none, with the nearest miss, is a proper answer.

    Raises
    ------
    ParameterError
        When a role, the method, an option of it or the features are unknown, the features do not describe such a
        recording, or need a ``max_distance``.
    DataError
        When nothing in the recording tells how large the body is.

    Examples
    --------
    >>> import leitmotion as lm
    >>> session = lm.compose_session(seed=0, rate=30.0)
    >>> patterns = lm.find_patterns(session.motion)                  # doctest: +SKIP
    >>> [(pattern.id, pattern.cycles) for pattern in patterns.patterns]       # doctest: +SKIP
    """
    roles = _exchanged(recording, body_map) if swap_sides else body_map
    told = described(recording, features, joints=joints, exclude=exclude, body_map=roles)
    return _search(told, features, method=method, weights=weights, **options)


def search_residual(
    recording: Recording,
    patterns: Patterns,
    *,
    body_map: Roles | None = None,
    swap_sides: bool = False,
    **options: Any,
) -> Residual:
    """Search what the patterns of a recording left over for movements that may have been missed (paper P, eq. 6).

    A check on a search: stretches that no pattern holds are compared by how their movements correlate, which is loose.
    Many candidates are chance: they are worth a look and no more.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person.
    patterns : Patterns
        What :func:`find_patterns` found in it; the same features and joints are compared.
    body_map, swap_sides
        As for :func:`find_patterns`.
    **options
        ``window_s``, ``min_correlation`` and ``min_spread`` of :func:`leitmotion.discovery.search_residual`.

    Returns
    -------
    Residual
        The candidates, best first; none is a proper answer.

    Raises
    ------
    ParameterError
        When an option is out of range, or the patterns are of another recording.
    DataError
        When nothing in the recording tells how large the body is.

    Examples
    --------
    >>> import leitmotion as lm
    >>> dance = lm.read("dance.bvh")                                 # doctest: +SKIP
    >>> missed = lm.search_residual(dance, lm.find_patterns(dance))  # doctest: +SKIP
    >>> missed.candidates[0].correlation                             # doctest: +SKIP
    0.83
    """
    from leitmotion.discovery import search_residual as search

    roles = _exchanged(recording, body_map) if swap_sides else body_map
    name = str(patterns.parameters.get("feature", "posture"))
    compared: Any = patterns.parameters.get("features")
    joints = compared and [glob.escape(joint) for joint in compared]
    told = described(recording, name, joints=joints, body_map=roles)
    return search(weighed(told, str(patterns.parameters.get("weights", "equal"))), patterns, **options)


def dynamics(
    recording: Recording,
    *,
    mass: float | None = None,
    sex: str = "mean",
    cutoff_hz: float | str | None = "usual",
    body_map: Roles | None = None,
    swap_sides: bool = False,
) -> Dynamics:
    """Compute momentum and energy of each part of a body and of the whole (paper S, sections 2.4 to 2.6).

    The body is 16 rigid segments that weigh and turn as de Leva's table (1996) says, scaled to this body. Where it
    jumps, the recording is judged by how well it obeys physics between take-off and landing.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person, in metres. Where it holds rotations, they tell how limbs turn about their own axis.
    mass : float, optional
        Of the body, kg; 70 by default. Without it momenta and energies are right but for a factor.
    sex : {"mean", "female", "male"}
        Whose table is used.
    cutoff_hz : float, "usual" or None
        Of the zero-lag low-pass before differentiation, hertz: usual are 10, at most 0.4 of the rate; None: no filter.
    body_map, swap_sides
        As for :func:`find_patterns`.

    Returns
    -------
    Dynamics
        Arrays along time, and the flights.

    Raises
    ------
    ParameterError
        When the mass is no positive number, or sex or cutoff are none that there are.
    DataError
        When the recording is not in metres and three dimensions, a joint of the body is missing, or all joints are
        never seen together for five frames.

    Examples
    --------
    >>> import leitmotion as lm
    >>> jump = lm.dynamics(lm.read("jump.bvh"), mass=62)             # doctest: +SKIP
    >>> [(flight.start, round(flight.gravity, 1)) for flight in jump.flights]   # doctest: +SKIP
    [(431, 9.7)]
    """
    roles = _exchanged(recording, body_map) if swap_sides else body_map
    return compute_dynamics(recording, mass=mass, sex=sex, cutoff_hz=cutoff_hz, body_map=roles)


def report(
    recording: Recording,
    path: str | Path | None = None,
    *,
    labels: Segmentation | None = None,
    labels_from: str = "",
    patterns: Patterns | None = None,
    source: Mapping[str, object] | None = None,
    features: str | None = None,
    weights: str | None = None,
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
    swap_sides: bool = False,
    opens_with: str = "repeats",
    mirrored: Mirrored | None = None,
    symmetry: Symmetry | None = None,
    graph: MotionGraph | None = None,
    force: bool = False,
    **options: Any,
) -> Path:
    """Write the page that shows what recurs in a recording, and its symmetry: one HTML file that needs nothing else.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person.
    path : path, optional
        Where to write it, ending in ``.html``; by default the recording's name with that ending, always in the
        current folder: of a name that holds a path only the last part counts.
    labels : Segmentation, optional
        Labels from elsewhere, shown in a lane of their own.
    labels_from : str
        Where they are from, as the lane's title.
    patterns : Patterns, optional
        What recurs in this recording; by default what :func:`find_patterns` finds.
    source : mapping, optional
        What the page tells about where the recording comes from: "path", "sha256" and the like; "warnings" are
        sentences that it shows as notes.
    features, weights : str, optional
        As for :func:`find_patterns`; by default those by which the given patterns were found, else posture and equal.
    joints, exclude, body_map, swap_sides
        As for :func:`find_patterns`.
    opens_with : {"repeats", "lesson", "symmetry", "graph"}
        What the page shows first; repeats where there is no such thing to show.
    mirrored : Mirrored, optional
        What :func:`compare_with_mirror` made of this recording; by default what it makes by its own defaults.
    symmetry : Symmetry, optional
        What :func:`find_symmetry` found in `mirrored`; by default what it finds by its own defaults.
    graph : MotionGraph, optional
        What :func:`motion_graph` made of it, likewise; the page adds the mirror images.
    force : bool
        Whether an ``.html`` file that Leitmotion did not write may be replaced.
    **options
        Of the search, as for :func:`find_patterns`: ``method="tang2008"``, ``stillness=True``.

    Returns
    -------
    Path
        The page that was written, whole or not at all.

    Raises
    ------
    ParameterError
        When a role, an option or what to open with is unknown, the path does not end in ``.html`` or holds somebody
        else's page, or the patterns or labels are of another recording.
    DataError
        When nothing in the recording tells how large the body is.

    Examples
    --------
    >>> import leitmotion as lm
    >>> lm.report(lm.read("dance.bvh"), "dance.html")       # doctest: +SKIP
    PosixPath('dance.html')
    """
    from leitmotion.paging import dynamics_of, graph_of, mirroring_of
    from leitmotion.similarity import self_distance
    from leitmotion.view import report_page
    from leitmotion.view.report import check_page

    if opens_with not in OPENINGS:
        raise ParameterError(f"opens_with must be one of {', '.join(OPENINGS)}, got {opens_with!r}.")
    if swap_sides:
        body_map = _exchanged(recording, body_map)
    body = as_body(recording, body_map)
    target = Path(path) if path is not None else Path(f"{_file_name(body.name)}.html")
    check_page(target, force=force)
    _check_fits(body, patterns, labels)
    if patterns is not None and options:
        raise ParameterError(f"{min(options)!r} steers a search, but patterns= says what was found.")
    by = {} if patterns is None else patterns.parameters
    name, weights = features or str(by.get("feature", "posture")), weights or str(by.get("weights", "equal"))
    told = (
        described(body, name, joints=joints, exclude=exclude)
        if of_body(name)
        else described(recording, name, joints=joints, exclude=exclude, body_map=body_map)
    )
    found = _search(told, name, weights=weights, **options) if patterns is None else patterns
    facts = {"name": body.name, "frames": len(body), "rate": body.rate, "seconds": len(body) / body.rate}
    page = report_page(
        body,
        found,
        self_distance(_thinned(weighed(told, weights))),
        source=facts | dict(source or {}),
        labels=labels,
        labels_from=labels_from,
        mirroring=mirroring_of(recording, body, body_map, mirrored, symmetry),
        dynamics=dynamics_of(recording, body_map),
        graph=graph_of(recording, body, body_map, graph),
        opens_with=opens_with,
    )
    write_whole(target, page)
    return target


def _check_fits(body: Body, patterns: Patterns | None, labels: Segmentation | None) -> None:
    """Refuse patterns or labels that cannot be of this recording."""
    if labels is not None and not isinstance(labels, Segmentation):
        raise ParameterError(
            f"Labels must be a Segmentation, got {type(labels).__name__}.",
            remedy='Read them first: leitmotion.read_annotations("labels.csv", rate=120).',
        )
    if patterns is not None and not math.isclose(patterns.rate, body.rate, rel_tol=1e-6):
        raise ParameterError(
            f"The patterns are of a recording at {patterns.rate:g} Hz, this one is at {body.rate:g} Hz."
        )
    spans = {"patterns": [pattern.stretches for pattern in patterns.patterns] if patterns else []}
    spans["labels"] = [labels] if labels else []
    for what, held in spans.items():
        last = max((one.stops.max() / one.rate for one in held if len(one)), default=0.0)
        if last > (len(body) + 1) / body.rate:
            raise ParameterError(
                f"The {what} reach to {last:.2f} s, but the recording lasts {len(body) / body.rate:.2f} s.",
                remedy=f"Give the {what} of this recording.",
            )


def _file_name(name: str) -> str:
    """Make a name that a file may bear of one that a recording brought along, which may say anything."""
    last = re.split(r"[/\\]", name)[-1]
    spoken = "".join(mark for mark in last if mark.isprintable() and mark not in '<>:"|?*')
    short = spoken.encode("utf-8")[:LONGEST_NAME].decode("utf-8", errors="ignore")
    return short.strip(" .") or "recording"


def _exchanged(recording: Recording, body_map: Roles | None) -> BodyMap:
    """The body map with its sides exchanged."""
    if isinstance(recording, Body):
        raise ParameterError(
            "The sides of a Body are settled.", remedy="Give the recording itself to have them exchanged."
        )
    return exchanged(map_of(recording, body_map))


def _search(
    features: FeatureSequence,
    name: str,
    *,
    method: str = "recurrence",
    weights: str = "equal",
    **options: Any,
) -> Patterns:
    """Search, and note by what; the defaults of recurrence itself are for postures with equal weights."""
    from leitmotion.discovery import find_patterns as search

    told = weighed(features, weights)
    if method == "recurrence" and (name, weights) != ("posture", "equal"):
        alike = options.get("max_distance", FEATURES[name].alike.get(weights))
        if alike is None:
            raise ParameterError(
                f"What counts as alike was never measured for {name}.",
                remedy="Say it with --max-distance (max_distance= in Python), in the values of the features; "
                "calibrate tells it from labels.",
            )
        if isinstance(alike, Real):
            options = {"max_distance": alike, "min_amplitude": float(alike) / 5} | options
    found = search(told, method=method, **options)
    by = {"feature": name, "weights": weights, "invariant_to": list(features.invariant_to)}
    return found.replace(parameters=found.parameters | by)


def _thinned(features: FeatureSequence) -> FeatureSequence:
    """Keep as many moments as the page draws: 30 a second, fewer of a recording that is long."""
    drawn = max(1, round(features.rate / DRAWN_RATE))
    return features[:: drawn * math.ceil(len(features) / drawn / MOST_MOMENTS)]
