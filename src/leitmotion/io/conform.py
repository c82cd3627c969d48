"""From a file's unit and axes to the house's: metres, Y up, right-handed.

What the caller states overrules what the format states; what neither states is judged from the body.
"""

from __future__ import annotations

import numpy as np

from leitmotion.io.gapped import as_points
from leitmotion.io.judge import contradict_up, judge_up, look
from leitmotion.io.judge_unit import doubt_unit, judge_unit, makes_an_adult
from leitmotion.io.points import FARTHEST
from leitmotion.io.reading import Draft, Finding, Options, PointTake, SkeletonTake, Source
from leitmotion.io.units import METRES, unit_in_metres
from leitmotion.motion import Motion, ParameterError, Skeleton, Trajectories, rotations
from leitmotion.motion.time import FASTEST

IMAGE_UNITS = ("px", "relative")
"""Units of points that are not in metres and stay as they are."""

_CHUNK = 512  # frames that are converted at a time

_TO_Y_UP = {
    "y": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "z": ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
    "x": ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
    "-y": ((1, 0, 0), (0, -1, 0), (0, 0, -1)),
    "-z": ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    "-x": ((0, 1, 0), (-1, 0, 0), (0, 0, 1)),
}
"""For each vertical the turn that brings it to +Y; with Z up, facing -Y becomes facing +Z."""


def refuse_useless(source: Source, draft: Draft) -> None:
    """Refuse a draft that no noun can be made of: nobody, no frame, a joint nowhere, a rate that cannot be.

    Parameters
    ----------
    source : Source
        The file, for the error.
    draft : Draft
        What the reader found; points out of all reach become unseen, and skeletons with missing numbers points, with
        a warning.

    Raises
    ------
    FormatError
        When there is nothing to make a noun of; it says what is missing and where.
    """
    if not draft.takes or not all(take.names for take in draft.takes):
        raise source.error("expected a person, found nobody.")
    if not all(len(take.positions) for take in draft.takes):
        raise source.error("expected at least one frame, found none.")
    rate = draft.rate.value
    if source.options.rate is None and not 0 < rate <= FASTEST:
        raise source.error(
            f"expected a rate of up to {FASTEST:.0e} Hz, found {rate:.3g} Hz.",
            remedy="State it with --rate HZ.",
        )
    for take in draft.takes:
        if isinstance(take, SkeletonTake):
            _check_joints(source, take)
        else:
            _unsee_far(take, draft.warnings)
    draft.takes = [
        as_points(take, draft.warnings) if isinstance(take, SkeletonTake) and _has_gaps(take) else take
        for take in draft.takes
    ]


def _has_gaps(take: SkeletonTake) -> bool:
    return bool(np.isnan(np.sum(take.positions)) or np.isnan(np.sum(take.rotations)))


def _check_joints(source: Source, take: SkeletonTake) -> None:
    """Refuse a joint that is out of all reach, or of which the rest pose tells no place."""
    for what, values in (("an offset", take.offsets[None]), ("an end site", take.end_offsets[None]),
                         ("a place", take.positions), ("a rotation", take.rotations)):  # fmt: skip
        if not values.size or (values.min() > -FARTHEST and values.max() < FARTHEST):  # NaN fails both
            continue
        wrong = ~(np.abs(values) < FARTHEST)
        if what in ("a place", "a rotation"):
            wrong &= ~np.isnan(values)
        if not wrong.any():
            continue
        frame, joint = np.argwhere(wrong.any(axis=-1))[0]
        name = take.names[take.end_parents[joint] if what == "an end site" else joint]
        where = f" in frame {frame}" if what in ("a place", "a rotation") else ""
        raise source.error(
            f"expected {what} of joint {name!r}{where}, found {_spell(values[frame, joint])}.",
            remedy="Was the file damaged?",
        )


def _spell(numbers: np.ndarray) -> str:
    return ", ".join(f"{number:g}" for number in numbers)


def _unsee_far(take: PointTake, warnings: list[str]) -> None:
    # the extremes first: comparing every number takes ten times as long and a copy, and few files hold such a one
    places = take.positions
    if not places.size:
        return
    if not max(np.fmax.reduce(places, axis=None), -np.fmin.reduce(places, axis=None)) >= FARTHEST:
        return
    far = (np.abs(places) >= FARTHEST).any(axis=-1)
    take.positions = np.where(far[..., None], np.nan, take.positions)
    warnings.append(
        f"{int(far.sum())} places lie beyond {FARTHEST:.0e} from the origin and were taken as unseen."
    )


def conform(
    draft: Draft, options: Options, name: str
) -> tuple[list[Motion | Trajectories], dict[str, Finding]]:
    """Bring a draft to the house's unit and axes, and make its quaternions continuous in time.

    Parameters
    ----------
    draft : Draft
        What the reader found; warnings are added to it.
    options : Options
        What the caller said.
    name : str
        What the recording is called.

    Returns
    -------
    tuple
        The nouns, one a person, and the findings "unit", "up", "rate" and the reader's own.

    Raises
    ------
    ParameterError
        When an option is none of those that exist.
    """
    first: SkeletonTake | PointTake = max(draft.takes, key=lambda take: len(take.names))
    positions = look(first)
    rate = _rate(draft, options)
    up = _up(draft, options, positions, first)
    unit, metres = _unit(draft, options, positions, first)
    turn = _turn(up.value, positions.shape[-1])
    nouns: list[Motion | Trajectories] = []
    for take in draft.takes:
        called = f"{name}:{take.person}" if len(draft.takes) > 1 else name
        if isinstance(take, SkeletonTake):
            if not draft.as_saved:
                take.rotations = rotations.continuous(take.rotations)
            nouns.append(_motion(take, metres, turn, rate.value, called))
        else:
            word = unit.value if unit.value in IMAGE_UNITS else "m"
            nouns.append(_trajectories(take, metres, turn, word, rate.value, called))
    findings = {"unit": unit, "up": up, "rate": rate, **draft.findings}
    return nouns, findings


def _rate(draft: Draft, options: Options) -> Finding:
    if options.rate is None:
        return draft.rate
    rate = float(options.rate)
    if not (np.isfinite(rate) and rate > 0):
        raise ParameterError(f"rate must be a positive number of hertz, got {options.rate!r}.")
    return Finding(rate, "given", "rate given by the caller")


def _up(draft: Draft, options: Options, positions: np.ndarray, take: SkeletonTake | PointTake) -> Finding:
    if options.up is not None:
        if options.up not in _TO_Y_UP:
            raise ParameterError(f"up must be one of {', '.join(_TO_Y_UP)}, got {options.up!r}.")
        return Finding(options.up, "given", "up given by the caller")
    if draft.up is None:
        return judge_up(positions, take)
    better = contradict_up(draft.up, positions) if draft.up_may_err else None
    if better is None:
        return draft.up
    draft.warnings.append(
        f"The vertical was taken as {better.value}: {better.reason}; --up {draft.up.value} overrules this."
    )
    return better


def _unit(
    draft: Draft, options: Options, positions: np.ndarray, take: SkeletonTake | PointTake
) -> tuple[Finding, float]:
    if options.unit is not None:
        named = str(options.unit).lower()
        if named in IMAGE_UNITS and isinstance(take, PointTake):
            return Finding(named, "given", "unit given by the caller"), 1.0
        word, metres = unit_in_metres(options.unit)
        return Finding(word, "given", "unit given by the caller"), metres
    if draft.unit is not None and (
        draft.unit.how != "guessed"
        or draft.unit.value in IMAGE_UNITS
        or makes_an_adult(draft.unit.value, take, positions)
    ):
        doubt = doubt_unit(draft.unit, take, positions)
        if doubt:
            draft.warnings.append(doubt)
        return draft.unit, METRES.get(draft.unit.value, 1.0)
    unit, warning = judge_unit(take, positions)
    if warning:
        draft.warnings.append(warning)
    return unit, METRES[unit.value]


def _turn(up: str, components: int) -> np.ndarray:
    if components == 3:
        return np.array(_TO_Y_UP[up], dtype=np.float64)
    if up.endswith("y"):
        return np.diag([1.0, -1.0 if up == "-y" else 1.0])
    raise ParameterError(f"The vertical of points in a plane is y or -y, got {up!r}.")


def _motion(take: SkeletonTake, metres: float, turn: np.ndarray, rate: float, name: str) -> Motion:
    offsets, ends, positions, quaternions = take.offsets, take.end_offsets, take.positions, take.rotations
    if metres != 1.0:
        offsets, ends, positions = offsets * metres, ends * metres, positions * metres
    if not np.array_equal(turn, np.eye(3)):
        # a change of basis for every joint: the rest pose stands upright in the new axes as well
        offsets, ends, positions = offsets @ turn.T, ends @ turn.T, positions @ turn.T
        quaternions = np.concatenate((quaternions[..., :1], quaternions[..., 1:] @ turn.T), axis=-1)
    skeleton = Skeleton(tuple(take.names), take.parents, offsets, take.end_parents, ends)
    return Motion(skeleton, positions, quaternions, rate, name)


def _trajectories(
    take: PointTake, metres: float, turn: np.ndarray, unit: str, rate: float, name: str
) -> Trajectories:
    positions = take.positions if take.positions.flags.writeable else take.positions.copy()
    turned = not np.array_equal(turn, np.eye(len(turn)))
    for start in range(0, len(positions), _CHUNK):  # in place: of a long recording there is no second copy
        chunk = positions[start : start + _CHUNK]
        with np.errstate(invalid="ignore"):  # a NaN of a file may be one that signals
            chunk *= metres
            if turned:
                chunk[...] = chunk @ turn.T
    positions.flags.writeable = False
    return Trajectories(tuple(take.names), positions, rate, unit, take.kind, take.confidence, name)
