"""The functions a person types; with the command line the only place that joins reading, finding and showing.

A recording goes one way: :func:`read` it, ask something of it (:func:`info`, :func:`find_patterns`), and
:func:`report` or :func:`save` the answer. What takes a recording takes a :class:`Body` as well.
"""

from __future__ import annotations

import fnmatch
import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from leitmotion.body import ROLES, Body, BodyMap, embody, find_roles, map_from
from leitmotion.datasets import compose_session
from leitmotion.discovery import Pattern, Patterns
from leitmotion.features import FeatureSequence, posture
from leitmotion.features.posture import choose_roles
from leitmotion.inspection import Info, info
from leitmotion.io import load, read, read_all, read_annotations, save, write, write_whole
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

__all__ = [
    "Body",
    "BodyMap",
    "DataError",
    "FormatError",
    "Info",
    "LeitmotionError",
    "Motion",
    "ParameterError",
    "Pattern",
    "Patterns",
    "Segmentation",
    "Skeleton",
    "Trajectories",
    "compose_session",
    "embody",
    "find_patterns",
    "find_roles",
    "info",
    "load",
    "read",
    "read_all",
    "read_annotations",
    "report",
    "save",
    "write",
]

DRAWN_RATE = 30.0
"""Frames per second that the page draws."""
MOST_MOMENTS = 6000
"""Moments that the page's matrix compares at most: 3 minutes at 30 a second, 144 MB."""
LONGEST_NAME = 200
"""Bytes of a page's default name at most; file systems take 255 with the ending."""

Recording = Motion | Trajectories | Body
Roles = BodyMap | Mapping[str, str | list[str]]


def find_patterns(
    recording: Recording,
    *,
    method: str = "recurrence",
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
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
    joints : str or sequence of str, optional
        The roles to compare, with wildcards: ``"left_*"``. By default those that every skeleton has.
    exclude : str or sequence of str, optional
        Roles to leave out, with wildcards.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role, when the names do not tell.
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
        When a role, the method or an option of it is unknown.
    DataError
        When nothing in the recording tells how large the body is.

    Examples
    --------
    >>> import leitmotion as lm
    >>> session = lm.compose_session(seed=0, rate=30.0)
    >>> patterns = lm.find_patterns(session.motion)                  # doctest: +SKIP
    >>> [(pattern.id, pattern.cycles) for pattern in patterns.patterns]       # doctest: +SKIP
    """
    from leitmotion.discovery import find_patterns as search

    return search(_postures(_body(recording, body_map), joints, exclude), method=method, **options)


def report(
    recording: Recording,
    path: str | Path | None = None,
    *,
    labels: Segmentation | None = None,
    labels_from: str = "",
    patterns: Patterns | None = None,
    source: Mapping[str, object] | None = None,
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
) -> Path:
    """Write the page that shows what recurs in a recording: one HTML file that needs nothing else.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person.
    path : path, optional
        Where to write it; by default the recording's name with the ending ``.html``, always in the current folder:
        of a name that holds a path only the last part counts.
    labels : Segmentation, optional
        Labels from elsewhere, shown in a lane of their own.
    labels_from : str
        Where they are from, as the lane's title.
    patterns : Patterns, optional
        What recurs; by default what :func:`find_patterns` finds.
    source : mapping, optional
        What the page tells about where the recording comes from: "path", "sha256" and the like.
    joints, exclude, body_map
        As for :func:`find_patterns`.

    Returns
    -------
    Path
        The page that was written, whole or not at all.

    Raises
    ------
    ParameterError
        When a role is unknown.
    DataError
        When nothing in the recording tells how large the body is.

    Examples
    --------
    >>> import leitmotion as lm
    >>> lm.report(lm.read("dance.bvh"), "dance.html")       # doctest: +SKIP
    PosixPath('dance.html')
    """
    from leitmotion.discovery import find_patterns as search
    from leitmotion.similarity import self_distance
    from leitmotion.view import report_page

    body = _body(recording, body_map)
    features = _postures(body, joints, exclude)
    found = search(features) if patterns is None else patterns
    facts = {"name": body.name, "frames": len(body), "rate": body.rate, "seconds": len(body) / body.rate}
    page = report_page(
        body,
        found,
        self_distance(_thinned(features)),
        source=facts | dict(source or {}),
        labels=labels,
        labels_from=labels_from,
    )
    target = Path(path) if path is not None else Path(f"{_file_name(body.name)}.html")
    write_whole(target, page)
    return target


def _file_name(name: str) -> str:
    """Make a name that a file may bear of one that a recording brought along, which may say anything."""
    last = re.split(r"[/\\]", name)[-1]
    spoken = "".join(mark for mark in last if mark.isprintable() and mark not in '<>:"|?*')
    short = spoken.encode("utf-8")[:LONGEST_NAME].decode("utf-8", errors="ignore")
    return short.strip(" .") or "recording"


def _body(recording: Recording, body_map: Roles | None) -> Body:
    if isinstance(recording, Body):
        return recording
    if not isinstance(recording, Motion | Trajectories):
        raise ParameterError(
            f"A recording was expected, got {type(recording).__name__}.",
            remedy='Read the file first: leitmotion.read("dance.bvh").',
        )
    if body_map is None or isinstance(body_map, BodyMap):
        return embody(recording, body_map)
    return embody(recording, map_from(body_map, recording))


def _postures(
    body: Body, joints: str | Sequence[str] | None, exclude: str | Sequence[str] | None
) -> FeatureSequence:
    if not joints and not exclude:
        return posture(body)
    wanted = _matching(joints, body.roles) if joints else choose_roles(body, None)
    unwanted = _matching(exclude, (*body.roles, *ROLES)) if exclude else ()
    roles = tuple(role for role in wanted if role not in unwanted)
    if not roles:
        raise ParameterError("No joint is left to compare.", remedy="Exclude fewer.")
    return posture(body, roles=roles)


def _matching(names: str | Sequence[str], known: Sequence[str]) -> tuple[str, ...]:
    """Those of the known roles that the names mean, wildcards allowed, in the order in which they are known."""
    given = (names,) if isinstance(names, str) else tuple(names)
    for name in given:
        if not any(fnmatch.fnmatchcase(role, name) for role in known):
            raise ParameterError(
                f"The body has no joint {name!r} to compare.",
                remedy=f"It has {', '.join(dict.fromkeys(known))}.",
            )
    return tuple(role for role in known if any(fnmatch.fnmatchcase(role, name) for name in given))


def _thinned(features: FeatureSequence) -> FeatureSequence:
    """Keep as many moments as the page draws: 30 a second, fewer of a recording that is long."""
    drawn = max(1, round(features.rate / DRAWN_RATE))
    return features[:: drawn * math.ceil(len(features) / drawn / MOST_MOMENTS)]
