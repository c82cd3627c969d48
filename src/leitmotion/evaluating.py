"""How good an answer is, from files or from values: the door to the room of evaluation."""

from __future__ import annotations

import math
from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import NamedTuple

import numpy as np

from leitmotion import io
from leitmotion.discovery.pattern import Patterns
from leitmotion.evaluation import FoundPatterns, PatternScores, PatternTruth, evaluate_patterns, pool
from leitmotion.io.annotation_table import named, recordings_of_table
from leitmotion.io.containers import read_file
from leitmotion.io.dataset_labels import decoded
from leitmotion.motion import DataError, FormatError, ParameterError, Segmentation
from leitmotion.motion.errors import in_short

TASKS = ("patterns",)
FILES_OF_TRUTH = (".csv", ".tsv", ".json", ".eaf", ".txt")
"""Endings of the files that a folder is searched for."""
_OVERHANG = 0.5  # seconds by which labels in coarse steps may reach beyond the recording


class Judged(NamedTuple):
    """An answer about one recording, and how good it is."""

    recording: str
    """What the answer calls it; empty where it does not."""
    file: Path
    """Where the truth stands."""
    frames: int
    """Length of the recording, or how far truth and answer reach where it is not told."""
    truth: PatternTruth
    scores: PatternScores
    about: str = ""
    """What the truth calls its recording; empty where it does not."""

    @property
    def of_another(self) -> bool:
        """Whether truth and answer call their recordings by names that no one recording has."""
        return bool(self.about and self.recording) and not named([self.about], self.recording)


def evaluate(
    task: str,
    truth: PatternTruth | Segmentation | str | PathLike[str],
    found: Patterns | FoundPatterns | str | PathLike[str],
    *,
    rate: float | None = None,
    trial: str | None = None,
    tier: str | None = None,
    ignore: Sequence[str] = (),
) -> PatternScores:
    """Judge an answer by what a person saw.

    Parameters
    ----------
    task : {"patterns"}
        What was asked for.
    truth : PatternTruth, Segmentation or path
        What a person saw: runs of actions, or a file of them as :func:`leitmotion.read_annotations` takes it. A table
        may have the columns ``cycles``, ``least`` and ``most``, and ``recording`` where it tells of several; a folder
        holds a file for each recording, of its name.
    found : Patterns, FoundPatterns or path
        The answer, or a file of it (``.json``, ``.csv``, ``.eaf``, ``.npz``). Where it holds several answers, all are
        judged and pooled.
    rate : float, optional
        Frames per second, where neither file tells.
    trial : str, optional
        Which block or recording of a truth that tells of several; by default that which the answer names.
    tier : str, optional
        Which tier of an EAF with several.
    ignore : sequence of str
        Labels that are no action, such as "rest".

    Returns
    -------
    PatternScores
        All figures; :mod:`leitmotion.evaluation.patterns` has the protocol.

    Raises
    ------
    FormatError
        When a file is missing or is none of these.
    DataError
        When truth and answer cannot be about one recording, or the truth holds no label.
    ParameterError
        When there is no such task, no frame rate is told, or the two are of different rates.

    Examples
    --------
    >>> import leitmotion as lm
    >>> session = lm.compose_session(seed=0, rate=30.0)
    >>> scores = lm.evaluate("patterns", session.stretches, lm.find_patterns(session.motion))  # doctest: +SKIP
    >>> lm.evaluate("patterns", "labels.csv", "found.json").f1                                 # doctest: +SKIP
    """
    if task not in TASKS:
        raise ParameterError(f"What is evaluated is one of {', '.join(TASKS)}, got {task!r}.")
    given = {"rate": rate, "trial": trial, "tier": tier, "ignore": ignore}
    if isinstance(truth, str | PathLike):
        return pool([one.scores for one in judged(truth, found, **given)])  # type: ignore[arg-type]
    known = truth if isinstance(truth, PatternTruth) else PatternTruth(_without(truth, ignore))
    return pool([evaluate_patterns(known, answer) for _, _, answer in _answers(found, rate or known.rate)])


def judged(
    truth: str | PathLike[str],
    found: Patterns | FoundPatterns | str | PathLike[str],
    *,
    rate: float | None = None,
    trial: str | None = None,
    tier: str | None = None,
    ignore: Sequence[str] = (),
) -> list[Judged]:
    """Judge each answer of a file by a file of truth, parameters and errors as for :func:`evaluate`.

    Returns
    -------
    list of Judged
        One a recording.
    """
    file = Path(truth)
    told = rate or (None if file.is_dir() else io.rate_of(file))
    answers = _answers(found, told)
    if len(answers) > 1 and trial is not None:
        raise ParameterError(
            f"One recording of the truth is named, {trial}, but {_called(found)} holds answers about {len(answers)}: "
            f"{in_short([recording for recording, _, _ in answers])}.",
            remedy="Leave --trial (trial= in Python) out, or give the answer about that recording alone.",
        )
    results = []
    for recording, frames, answer in answers:
        place = _file_of(file, recording)
        seen = read_truth(
            place, rate=answer.rate, frames=frames, trial=trial or recording, tier=tier, ignore=ignore
        )
        reach = int(max(seen.runs.stops.max(), answer.occurrences.stops.max(initial=1)))
        about = _told_of(place, trial)
        results.append(
            Judged(recording, place, frames or reach, seen, evaluate_patterns(seen, answer), about)
        )
    return results


def read_truth(
    path: str | PathLike[str],
    *,
    rate: float,
    frames: int = 0,
    trial: str | None = None,
    tier: str | None = None,
    ignore: Sequence[str] = (),
) -> PatternTruth:
    """Read what a person saw in a recording.

    Parameters
    ----------
    path : str or path
        Any file that :func:`leitmotion.read_annotations` takes.
    rate : float
        Frames per second of the recording.
    frames : int
        Its length; 0 where it is not known.
    trial, tier, ignore
        As for :func:`evaluate`.

    Returns
    -------
    PatternTruth
        Runs in order, spans without a label, and counts of cycles where the file has them.

    Raises
    ------
    FormatError
        When the file is missing or has another layout.
    DataError
        When it holds no label, reaches beyond the recording, or two of its stretches overlap.
    """
    path = Path(path)
    which = trial if path.suffix.lower() in (".csv", ".tsv") or not trial else Path(trial).stem
    runs = _without(io.read_annotations(path, rate=rate, trial=which, tier=tier), ignore)
    cycles = io.read_cycles(path, trial=which) or [(math.nan,) * 3] * len(runs)
    if not any(runs.labels):
        raise DataError(f"{path.name} holds no labelled stretch.", remedy="Label what a person sees recur.")
    if frames and runs.stops.max() > frames + _OVERHANG * rate:
        raise DataError(
            f"{path.name} reaches to {runs.stops.max() / rate:.2f} s, but the recording lasts {frames / rate:.2f} s.",
            remedy="Give the truth of this recording.",
        )
    keep = [k for k in np.argsort(runs.starts, kind="stable") if not frames or runs.starts[k] < frames]
    stops = runs.stops[keep] if not frames else np.minimum(runs.stops[keep], frames)
    labels = tuple(runs.labels[k] for k in keep)
    try:
        return PatternTruth(
            Segmentation(runs.starts[keep], stops, labels, rate=rate),
            unlabelled=np.array(io.read_unlabelled(path, rate=rate, trial=which)),
            cycles=np.array([cycles[k] for k in keep]),
        )
    except ParameterError as error:
        raise DataError(f"{path.name}: {error.message}", remedy="Give one label to each moment.") from None


def found_patterns(found: Patterns) -> FoundPatterns:
    """Lay open what was found: occurrences under the names of their patterns, and pairs as four frames.

    Parameters
    ----------
    found : Patterns
        The answer of a search.

    Returns
    -------
    FoundPatterns
        The same for the evaluation.
    """
    spans = [(start, stop, pattern.id) for pattern in found for start, stop, _, _ in pattern.occurrences]
    occurrences = Segmentation(
        np.array([start for start, _, _ in spans], dtype=np.int64),
        np.array([stop for _, stop, _ in spans], dtype=np.int64),
        tuple(name for _, _, name in spans),
        rate=found.rate,
    )
    pairs = np.array([(*pair.a, *pair.b) for pair in found.pairs], dtype=np.int64).reshape(-1, 4)
    return FoundPatterns(occurrences, pairs)


def _answers(
    found: Patterns | FoundPatterns | str | PathLike[str], rate: float | None
) -> list[tuple[str, int, FoundPatterns]]:
    """Each answer with the recording that it names and its length, as far as they are told."""
    if isinstance(found, Patterns):
        return [("", 0, found_patterns(found))]
    if isinstance(found, FoundPatterns):
        return [("", 0, found)]
    path = Path(found)
    if path.suffix.lower() == ".npz":
        loaded = io.load(path)
        if not isinstance(loaded, Patterns):
            raise FormatError(f"{path.name} holds {type(loaded).__name__}, not the patterns of a recording.")
        return [("", 0, found_patterns(loaded))]
    return [
        (one.recording, one.frames, FoundPatterns(one.occurrences, one.pairs))
        for one in io.read_answers(path, rate=rate)
    ]


def _told_of(truth: Path, trial: str | None) -> str:
    """What the truth calls the recording that is judged: as was said, else as the one in a table."""
    if trial is not None or truth.suffix.lower() not in (".csv", ".tsv"):
        return trial or ""
    try:
        told = recordings_of_table(decoded(read_file(truth)[1]), truth)
    except FormatError:  # of another layout, which names none
        return ""
    return told[0] if len(told) == 1 else ""


def _called(found: Patterns | FoundPatterns | str | PathLike[str]) -> str:
    return Path(found).name if isinstance(found, str | PathLike) else "it"


def _file_of(truth: Path, recording: str) -> Path:
    """The file in which the truth about a recording stands: in a folder the one that has its name."""
    if not truth.is_dir():
        return truth
    if not recording:
        raise ParameterError(
            f"{truth} is a folder, but the answer does not name its recording.", remedy="Name one file of it."
        )
    stem = Path(recording).stem
    mine = [
        path
        for path in sorted(truth.iterdir())
        if path.stem == stem and path.suffix.lower() in FILES_OF_TRUTH
    ]
    if len(mine) != 1:
        raise DataError(
            f"{truth} holds {len(mine)} files that may be the truth about {recording}, but there must be one.",
            remedy=f"Name it {stem}.csv.",
        )
    return mine[0]


def _without(runs: Segmentation, ignore: Sequence[str]) -> Segmentation:
    """Take labels away that are no action."""
    unknown = sorted(set(ignore) - set(runs.labels))
    if unknown:
        raise ParameterError(
            f"There is no label {unknown[0]!r} to ignore.",
            remedy=f"The labels are {', '.join(dict.fromkeys(filter(None, runs.labels)))}.",
        )
    return runs.replace(labels=tuple("" if label in ignore else label for label in runs.labels))
