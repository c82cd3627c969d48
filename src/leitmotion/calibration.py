"""From labelled pairs of postures to the threshold from which on postures are alike.

A calibration is two steps: :func:`measure` reads the pairs and the recordings and tells how far the postures of each
pair are apart, as the search does; :func:`calibrate` finds the threshold as well.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from leitmotion.body import Body
from leitmotion.body import swap_sides as exchanged
from leitmotion.describing import Recording, Roles, described, known_weights, only
from leitmotion.evaluation import Calibration, equal_error_rate, errors_at
from leitmotion.features import FeatureSequence, active_weights, weighted
from leitmotion.io import LabelledPair, open_recording, read_pairs
from leitmotion.motion import DataError, LeitmotionError, Motion, ParameterError, Trajectories

READING = ("skeleton", "unit", "up", "rate", "person", "trust")
Source = str | PathLike[str] | Recording


class Looked(NamedTuple):
    """A recording that pairs were taken from."""

    name: str
    """As the pairs name it."""

    source: str
    """The file and its window; empty where the recording was given."""

    frames: int
    rate: float
    warnings: tuple[str, ...] = ()
    """What was odd about the file."""


@dataclass(frozen=True)
class Measured:
    """How far the two postures of each pair are apart.

    Parameters
    ----------
    pairs : tuple of LabelledPair
        The pairs, K.
    distances : (K,) float
        Of each, in the values of the features.
    recordings : tuple of Looked
        What they were taken from, in order of appearance.
    check : str, optional
        The group that decides nothing.
    """

    pairs: tuple[LabelledPair, ...]
    distances: np.ndarray
    recordings: tuple[Looked, ...]
    check: str | None = None


def calibrate(
    pairs: str | PathLike[str] | Iterable[LabelledPair],
    recordings: Source | Mapping[str, Source] | None = None,
    *,
    group: str | None = None,
    check: str | None = None,
    **options: Any,
) -> Calibration:
    """Find the distance from which on postures are alike, from pairs that a person labelled (paper P, section 2.3.1).

    Parameters
    ----------
    pairs : path or iterable of LabelledPair
        A table with the columns ``frame_a``, ``frame_b`` and ``alike`` (1 or 0), of several recordings also
        ``recording_a`` and ``recording_b``, perhaps ``person`` and ``group``. Frames count from 0.
    recordings : path, recording or mapping, optional
        The one recording of pairs that name none; or the recordings, or their files, by the names in the table. By
        default the names are paths, relative to the table's folder.
    group : str, optional
        Calibrate on the pairs of this group; by default on all but those of `check`.
    check : str, optional
        A group, best of other people, on which the threshold is tried.
    **options
        As for :func:`measure`: `features`, `weights`, `joints`, `exclude`, `body_map`, `swap_sides`, `folder`, and how
        to read.

    Returns
    -------
    Calibration
        The threshold where both error rates are equal, that rate, both curves, their intervals, and the errors of the
        check group. Where pairs name their person, intervals are over people.

    Raises
    ------
    FormatError
        When the table or a recording cannot be read; it names the line.
    DataError
        When a frame is outside of its recording or shows no posture, or only one class is labelled.
    ParameterError
        When there is no such group, or an option is unknown.

    Examples
    --------
    >>> import leitmotion as lm
    >>> session = lm.compose_session(seed=0, rate=30.0)
    >>> first, second = session.cycles.starts[4:6].tolist()            # two jumping jacks
    >>> same = [lm.io.LabelledPair(first + k, second + k, True) for k in (0, 3, 6)]
    >>> other = [lm.io.LabelledPair(first, first + k, False) for k in (10, 13, 16)]
    >>> found = lm.calibrate([*same, *other], session.motion)
    >>> found.equal_error_rate
    0.0
    >>> found = lm.find_patterns(session.motion, max_distance=found.threshold)        # doctest: +SKIP
    """
    return concluded(measure(pairs, recordings, group=group, check=check, **options))


def measure(
    pairs: str | PathLike[str] | Iterable[LabelledPair],
    recordings: Source | Mapping[str, Source] | None = None,
    *,
    features: str = "posture",
    weights: str = "equal",
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
    swap_sides: bool = False,
    folder: str | PathLike[str] | None = None,
    group: str | None = None,
    check: str | None = None,
    **reading: Any,
) -> Measured:
    """Tell how far the two postures of each pair are apart, as :func:`leitmotion.find_patterns` compares them.

    Parameters
    ----------
    pairs, recordings, group, check
        As for :func:`calibrate`; with a `group`, pairs of neither are left out.
    features, weights, joints, exclude, body_map, swap_sides
        As for :func:`leitmotion.find_patterns`. Weights are told by each recording as a whole; of a pair from two
        recordings they are the mean of both.
    folder : path, optional
        Where the recordings are, when not beside the table.
    **reading
        As for :func:`leitmotion.read`.

    Returns
    -------
    Measured
        The distances. Features of each recording are computed once.

    Raises
    ------
    LeitmotionError
        As for :func:`calibrate`.
    """
    known_weights(weights)
    unknown = sorted(set(reading) - set(READING))
    if unknown:
        raise ParameterError(
            f"calibrate has no option {unknown[0]!r}; recordings are read with {', '.join(READING)}."
        )
    table: Path | None = None
    if isinstance(pairs, str | PathLike):
        table = Path(pairs)
        labelled = read_pairs(table)
    else:
        labelled = tuple(pairs)
        for number, pair in enumerate(labelled):
            if not isinstance(pair, LabelledPair):
                raise ParameterError(
                    f"Pair {number} should be a LabelledPair, got {type(pair).__name__}.",
                    remedy="Make each: leitmotion.io.LabelledPair(frame_a, frame_b, alike).",
                )
    labelled = _of_groups(labelled, group, check)
    if not labelled:
        raise DataError("There are no pairs to calibrate on.")
    home = Path(folder) if folder is not None else table.parent if table is not None else Path()
    called = table.name if table is not None else ""
    found: dict[str, _Moments] = {}
    for name, frames in _frames_of(labelled, called).items():
        source = _source(name, recordings, home)
        try:
            recording, warnings = _read(source, reading)
            roles = _roles(recording, body_map, swap_sides=swap_sides)
            told = described(recording, features, joints=joints, exclude=exclude, body_map=roles)
        except LeitmotionError as error:
            where = next(iter(frames.values()))
            raise type(error)(f"{where}: {error.message}", remedy=error.remedy) from error
        found[name] = _moments(told, frames, name, source, warnings)
    distances = np.array([_distance(pair, found, weights, called) for pair in labelled])
    return Measured(labelled, distances, tuple(moments.looked for moments in found.values()), check)


def concluded(measured: Measured) -> Calibration:
    """Find the threshold of measured pairs, and try it on those of the check group."""
    kept = np.array([measured.check is not None and pair.group == measured.check for pair in measured.pairs])
    calibration = equal_error_rate(*_labels(measured, ~kept), owners=_owners(measured, ~kept))
    if measured.check is None:
        return calibration
    tried = errors_at(calibration.threshold, *_labels(measured, kept), owners=_owners(measured, kept))
    return calibration.replace(check=tried)


class _Moments(NamedTuple):
    """The moments of a recording that pairs name, and the weights of its joints."""

    looked: Looked
    features: FeatureSequence
    place: dict[int, int]
    weights: np.ndarray


def _of_groups(
    pairs: tuple[LabelledPair, ...], group: str | None, check: str | None
) -> tuple[LabelledPair, ...]:
    """Keep the pairs that were asked for."""
    if check is not None and group == check:
        raise ParameterError(
            f"A threshold is checked on other pairs than those it is from, got {group!r} for both."
        )
    there = dict.fromkeys(pair.group for pair in pairs)
    for name in (group, check):
        if name is not None and name not in there:
            named = ", ".join(filter(None, there))
            raise ParameterError(
                f"No pair is of the group {name!r}.",
                remedy=f"There are {named}." if named else "The table has no column group.",
            )
    return pairs if group is None else tuple(pair for pair in pairs if pair.group in (group, check))


def _frames_of(pairs: Sequence[LabelledPair], table: str) -> dict[str, dict[int, str]]:
    """Frames of each recording, and where the pair stands that first names each."""
    frames: dict[str, dict[int, str]] = {}
    for number, pair in enumerate(pairs):
        for name, frame in ((pair.recording_a, pair.frame_a), (pair.recording_b, pair.frame_b)):
            frames.setdefault(name, {}).setdefault(frame, _where(pair, table, number))
    return frames


def _where(pair: LabelledPair, table: str, number: int | None = None) -> str:
    if table:
        return f"{table}, line {pair.line}"
    return f"Pair {number}" if number is not None else f"Pair of frames {pair.frame_a} and {pair.frame_b}"


def _source(name: str, recordings: Source | Mapping[str, Source] | None, home: Path) -> str | Recording:
    if isinstance(recordings, Mapping):
        if name not in recordings:
            raise ParameterError(f"The pairs name a recording {name!r}, which is not among those given.")
        source = recordings[name]
    elif recordings is None:
        if not name:
            raise ParameterError(
                "The pairs name no recordings.", remedy="Name the one they are of beside the table."
            )
        source = home / name
    elif name:
        raise ParameterError(
            f"One recording is given, but the pairs name theirs, such as {name}.", remedy="Leave it out."
        )
    else:
        source = recordings
    return source if isinstance(source, Motion | Trajectories | Body) else fspath(source)


def _read(source: str | Recording, reading: Mapping[str, Any]) -> tuple[Recording, tuple[str, ...]]:
    """The recording of one person, and what is odd about its file."""
    if not isinstance(source, str):
        return source, ()
    opened = open_recording(source, **reading)
    if len(opened.recordings) > 1:
        raise DataError(
            f"{source} holds {len(opened.recordings)} people: {', '.join(opened.people)}.",
            remedy="Choose one with --person NAME (person= in Python).",
        )
    return opened.recordings[0], tuple(opened.warnings)


def _roles(recording: Recording, body_map: Roles | None, *, swap_sides: bool) -> Roles | None:
    from leitmotion.body import map_of

    if not swap_sides:
        return body_map
    if isinstance(recording, Body):
        raise ParameterError("The sides of a Body are settled.")
    return exchanged(map_of(recording, body_map))


def _moments(
    told: FeatureSequence,
    frames: Mapping[int, str],
    name: str,
    source: str | Recording,
    warnings: tuple[str, ...],
) -> _Moments:
    for frame, where in frames.items():
        if not 0 <= frame < len(told):
            raise DataError(
                f"{where}: frame {frame} is outside of {name or 'the recording'}, "
                f"which has frames 0 to {len(told) - 1}."
            )
        if not np.isfinite(told.values[frame]).any():
            raise DataError(f"{where}: frame {frame} of {name or 'the recording'} shows no posture.")
    looked = Looked(name, source if isinstance(source, str) else "", len(told), told.rate, warnings)
    kept = told.replace(values=told.values[list(frames)])
    return _Moments(looked, kept, {frame: k for k, frame in enumerate(frames)}, active_weights(told))


def _distance(pair: LabelledPair, found: Mapping[str, _Moments], weights: str, table: str) -> float:
    from leitmotion.similarity import pair_distances

    a, b = found[pair.recording_a], found[pair.recording_b]
    names = tuple(name for name in a.features.names if name in b.features.names)
    if not names:
        raise DataError(f"{_where(pair, table)}: the two recordings have no joint in common.")
    one, other = only(a.features, names), only(b.features, names)
    if weights == "active":
        mean = [
            (a.weights[a.features.names.index(name)] + b.weights[b.features.names.index(name)]) / 2
            for name in names
        ]
        one, other = weighted(one, np.array(mean)), weighted(other, np.array(mean))
    frames = [a.place[pair.frame_a]], [b.place[pair.frame_b]]
    distance = float(pair_distances(one, np.array(frames[0]), other, np.array(frames[1]))[0])
    if not np.isfinite(distance):
        raise DataError(
            f"{_where(pair, table)}: the two postures have no joint in common that is seen in both."
        )
    return distance


def _labels(measured: Measured, chosen: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return measured.distances[chosen], np.array([pair.alike for pair in measured.pairs], dtype=bool)[chosen]


def _owners(measured: Measured, chosen: np.ndarray) -> list[str] | None:
    """Whose pairs they are, where all say so and there are several people."""
    owners = [pair.person for pair, mine in zip(measured.pairs, chosen, strict=True) if mine]
    return owners if all(owners) and len(set(owners)) > 1 else None
