"""Engines that find what recurs, asked alike: postures in, sets of stretches out.

``python benchmarks/engines.py ENGINE POSTURES.npz HINTS`` lets one search, in a process of its own, and prints the CPU
seconds and the answer as JSON. HINTS is the JSON of :class:`Hints`.

The others are told what ours is not: how many actions recur, and how long the shortest and the longest repetition are.
How each is set beyond that was chosen on the actors that a method may be fitted on (``bench_rivals.py fit``).
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass
from types import MappingProxyType
from typing import Any

import numpy as np

from leitmotion import discovery, io
from leitmotion.evaluation import FoundPatterns
from leitmotion.features import FeatureSequence
from leitmotion.motion import Segmentation

Sets = list[list[tuple[int, int]]]
REPEAT_UNDER_S = 5.0
WARM_UP = 240
LOCOMOTIF: Mapping[str, Any] = MappingProxyType({"scaled": "whole", "rho": 0.95, "overlap": 0.0})
STUMPY: Mapping[str, Any] = MappingProxyType(
    {"normalize": False, "window": "middle", "k": 1.0, "spread": 1.5, "apart": 4}
)


@dataclass(frozen=True)
class Hints:
    """What the truth tells the engines that must be told something.

    Parameters
    ----------
    shortest, longest : int
        Frames of the shortest and of the longest repetition of what recurs.
    sets : int or None
        How many actions recur; None where nobody tells.
    """

    shortest: int
    longest: int
    sets: int | None


GUESSED = Hints(20, 235, None)
"""What one may guess from the actors to fit on: their shortest and longest repetition, and any number of actions."""


def ours(postures: FeatureSequence, _: Hints) -> Sets:
    """Search by default."""
    return of_patterns(discovery.find_patterns(postures))


def tang2008(postures: FeatureSequence, _: Hints) -> Sets:
    """Search as paper P does, with its parameters."""
    return of_patterns(discovery.find_patterns(postures, method="tang2008"))


def locomotif(postures: FeatureSequence, hints: Hints, chosen: Mapping[str, Any] = LOCOMOTIF) -> Sets:
    """Search by LoCoMotif, with time warping, its default."""
    from locomotif.locomotif import apply_locomotif

    found = apply_locomotif(
        scaled(postures.values, chosen["scaled"]), hints.shortest, hints.longest, rho=chosen["rho"], nb=hints.sets,
        overlap=chosen["overlap"],
    )  # fmt: skip
    return of_locomotif(found)


def locomotif_untold(postures: FeatureSequence, _: Hints) -> Sets:
    """Search by LoCoMotif as one must who does not know the truth: lengths guessed, all sets taken."""
    return locomotif(postures, GUESSED)


def stumpy(postures: FeatureSequence, hints: Hints, chosen: Mapping[str, Any] = STUMPY) -> Sets:
    """Search by the multi-dimensional matrix profile, then by its motifs and all their matches."""
    window = window_of(hints, chosen["window"])
    return stumpy_motifs(postures, profile_of(postures, window, chosen), window, hints, chosen)


def profile_of(postures: FeatureSequence, window: int, chosen: Mapping[str, Any]) -> Any:
    """Compute the multi-dimensional matrix profile."""
    from stumpy import mstump

    return mstump(postures.values.T, window, normalize=chosen["normalize"])


def stumpy_motifs(
    postures: FeatureSequence, profile: Any, window: int, hints: Hints, chosen: Mapping[str, Any]
) -> Sets:
    """Take the motifs with the smallest values of the profile, and all that match each."""
    from stumpy import config, mmotifs

    values = postures.values.T
    k = columns(chosen["k"], len(values))
    kept = config.STUMPY_EXCL_ZONE_DENOM
    config.STUMPY_EXCL_ZONE_DENOM = chosen["apart"]
    try:
        _, starts, _, _ = mmotifs(
            values, *profile, cutoffs=np.inf, max_matches=None, max_motifs=hints.sets or 1, k=k,
            max_distance=lambda D: within(D, chosen["spread"]), normalize=chosen["normalize"],
        )  # fmt: skip
    finally:
        config.STUMPY_EXCL_ZONE_DENOM = kept
    return of_stumpy(starts, window)


def columns(share: float | str, of: int) -> int | None:
    """Say how many columns a motif needs, less one; None where the description length is to tell ("mdl")."""
    return None if isinstance(share, str) else round(share * of) - 1


def within(distances: np.ndarray, spread: float) -> float:
    """Say how far a match may be: so many standard deviations below the mean, but the nearest always."""
    known = distances[np.isfinite(distances)].astype(float)
    return float(max(known.mean() - spread * known.std(), known.min()))


def scaled(values: np.ndarray, how: str) -> np.ndarray:
    """Take the mean away and divide by the deviation: of all values ("whole"), or of each column ("columns")."""
    axis = None if how == "whole" else 0
    return (values - values.mean(axis=axis)) / np.maximum(values.std(axis=axis), 1e-9)


def window_of(hints: Hints, which: str) -> int:
    """Frames of the window: the shortest repetition, the longest, or the geometric mean of the two."""
    lengths = {"shortest": hints.shortest, "longest": hints.longest}
    return lengths.get(which, round(float(np.sqrt(hints.shortest * hints.longest))))


def of_patterns(found: discovery.Patterns) -> Sets:
    """Give the occurrences of each pattern of ours."""
    return [[(start, stop) for start, stop, _, _ in pattern.occurrences] for pattern in found]


def of_locomotif(found: Iterable[tuple[Any, Iterable[tuple[int, int]]]]) -> Sets:
    """Give the motif sets of LoCoMotif, without the representative, which is one of each set."""
    return [sorted((int(start), int(stop)) for start, stop in motifs) for _, motifs in found]


def of_stumpy(starts: np.ndarray, window: int) -> Sets:
    """Give the matches of each motif: rows of starts, -1 where a motif has no more."""
    return [sorted((int(start), int(start) + window) for start in row if start >= 0) for row in starts]


def found_patterns(sets: Iterable[Iterable[tuple[int, int]]], rate: float) -> FoundPatterns:
    """Lay open what was found: each set is a pattern, all pairs in it are its pairs."""
    spans = [(start, stop, f"{k}") for k, one in enumerate(sets) for start, stop in one]
    return FoundPatterns(
        Segmentation(
            np.array([start for start, _, _ in spans], dtype=np.int64),
            np.array([stop for _, stop, _ in spans], dtype=np.int64),
            tuple(label for _, _, label in spans),
            rate=rate,
        )
    )


ENGINES: dict[str, Callable[[FeatureSequence, Hints], Sets]] = {
    "leitmotion": ours,
    "tang2008": tang2008,
    "dtai-locomotif": locomotif,
    "dtai-locomotif, not told": locomotif_untold,
    "stumpy": stumpy,
}


def timed(engine: str, postures: FeatureSequence, hints: Hints) -> tuple[float, Sets]:
    """Measure the CPU seconds of a search, kernels compiled before: the best of three where it takes seconds."""
    search = ENGINES[engine]
    search(postures[:WARM_UP], Hints(20, 60, 1))
    taken: list[float] = []
    while not taken or (len(taken) < 3 and taken[0] < REPEAT_UNDER_S):
        began = time.process_time()
        found = search(postures, hints)
        taken.append(time.process_time() - began)
    return min(taken), found


def main() -> None:
    """Let one engine search."""
    engine, file, hints = sys.argv[1:]
    seconds, sets = timed(engine, io.load(file), Hints(**json.loads(hints)))
    print(json.dumps({"seconds": seconds, "sets": sets}))


def command(engine: str, file: str, hints: Hints) -> list[str]:
    """Give the command that lets an engine search in a process of its own."""
    return [sys.executable, __file__, engine, file, json.dumps(asdict(hints))]


if __name__ == "__main__":
    main()
