"""Points: whose they are, how each keeps a name of its own, and which are not there."""

from __future__ import annotations

import numpy as np

from leitmotion.io.reading import Finding, PointTake

FARTHEST = 1e12
"""No unit that is known puts anything on a person as far from the origin."""

_PIXELS = 20.0  # coordinates in a picture beyond this are pixels

OTHERS = "others"
"""What the points without a subject are called where others have one."""

_CHUNK = 1 << 15  # points that are looked at at a time


def split_people(
    names: list[str], positions: np.ndarray, kind: str = "marker", confidence: np.ndarray | None = None
) -> list[PointTake]:
    """Part points named ``SUBJECT:NAME`` by their subject, and take the subject off the names.

    Parameters
    ----------
    names : list of str, P
        One a point.
    positions : (T, P, C) float
        Where each is.
    kind : {"marker", "joint"}
        What they are.
    confidence : (T, P) float, optional
        How sure the source was of each.

    Returns
    -------
    list of PointTake
        One a subject, in the order in which they first appear.
    """
    subjects: dict[str, list[int]] = {}
    for k, name in enumerate(names):
        subjects.setdefault(name.rpartition(":")[0], []).append(k)
    if len(subjects) == 1:
        person = next(iter(subjects))
        return [PointTake([_bare(name) for name in names], positions, kind, confidence, person)]
    return [
        PointTake(
            [_bare(names[k]) for k in which],
            positions[:, which],
            kind,
            None if confidence is None else confidence[:, which],
            person or OTHERS,
        )
        for person, which in subjects.items()
    ]


def _bare(name: str) -> str:
    """The name without its subject, or the whole where nothing follows the subject."""
    bare = name.rpartition(":")[2]
    return bare if bare.strip() else name


def distinct(names: list[str], warnings: list[str]) -> list[str]:
    """Number the names that stand more than once: ``RKNE``, ``RKNE#2``.

    Parameters
    ----------
    names : list of str
        Names, some of them perhaps doubled.
    warnings : list of str
        Gains a sentence where any is.

    Returns
    -------
    list of str
        Names that differ from one another.
    """
    counts: dict[str, int] = {}
    taken = set(names)
    made = []
    for name in names:
        counts[name] = counts.get(name, 0) + 1
        own = name
        while counts[name] > 1 and own in taken:
            own = f"{name}#{counts[name]}"
            if own in taken:
                counts[name] += 1
        taken.add(own)
        made.append(own)
    doubled = [name for name, count in counts.items() if count > 1]
    if doubled:
        warnings.append(f"Names stand more than once and were numbered: {', '.join(doubled)}.")
    return made


def unseen_in_origin(positions: np.ndarray, warnings: list[str]) -> np.ndarray:
    """Mark as unseen what lies exactly in the origin, or nowhere: no marker on a person does.

    Parameters
    ----------
    positions : (T, P, C) float
        Changed in place.
    warnings : list of str
        Gains a sentence with the count.

    Returns
    -------
    (T, P, C) float
        The same array.
    """
    count = 0
    step = max(1, _CHUNK // max(1, positions.shape[1]))
    for start in range(0, len(positions), step):  # by chunks and components, which is four times as fast
        chunk = positions[start : start + step]
        columns = [chunk[..., k] for k in range(chunk.shape[-1])]
        nowhere = np.logical_and.reduce([column == 0.0 for column in columns])
        nowhere |= np.logical_or.reduce([np.isinf(column) for column in columns])
        if nowhere.any():
            count += int(nowhere.sum())
            chunk[nowhere] = np.nan
    if count:
        warnings.append(f"{count} places lie exactly in the origin or at infinity and were taken as unseen.")
    return positions


def in_pixels(positions: np.ndarray) -> bool:
    """Whether coordinates (..., 2) of points in a plane are as large as pixels, not shares of a picture."""
    return bool(np.fmax.reduce(np.abs(positions), axis=None, initial=0.0) > _PIXELS)


def plane_unit(positions: np.ndarray, what: str = "points in a picture") -> Finding:
    """Guess the unit of points in a plane.

    Parameters
    ----------
    positions : (..., 2) float
        Where they are, NaN where unseen.
    what : str
        What the points are, for the reason.

    Returns
    -------
    Finding
        "px" or "relative".

    Examples
    --------
    >>> plane_unit(np.array([[320.0, 240.0]])).value, plane_unit(np.array([[0.5, np.nan]])).value
    ('px', 'relative')
    """
    if in_pixels(positions):
        return Finding("px", "guessed", f"{what} with coordinates as large as pixels")
    return Finding("relative", "guessed", f"{what} with coordinates too small for pixels")


def is_confidence(third: np.ndarray) -> bool:
    """Whether third numbers (...) of points may be confidences: within 0 and 1, and not all zero.

    Examples
    --------
    >>> is_confidence(np.array([0.0, 0.9, np.nan])), is_confidence(np.full(3, np.nan)), is_confidence(np.zeros(3))
    (True, False, False)
    """
    lowest = np.fmin.reduce(third, axis=None, initial=np.inf)
    highest = np.fmax.reduce(third, axis=None, initial=-np.inf)
    return bool(lowest >= 0.0 and 0.0 < highest <= 1.0)
