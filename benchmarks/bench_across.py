"""Patterns across recordings: whether the clips of a folder that show one movement are joined, and others not.

``python benchmarks/bench_across.py cases [fit|report] [OPTION=NUMBER...]`` prints the folders of a split one by one, as
with ``max_distance=0.1``; fit is what a method may be fitted on, and the default.
"""

from __future__ import annotations

import sys
import time
import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations

import numpy as np

import leitmotion as lm
from joined import HDM05, moves
from leitmotion.discovery import find_shared_patterns
from leitmotion.features import FeatureSequence, posture
from recordings import locate, unpacked

Row = tuple[str, str, str]
FOLDERS = 20
RESAMPLED = 2000
ACTORS = ("hdm05-bd", "hdm05-bk", "hdm05-dg")
CLASSES = {
    "fit": (
        "depositFloorR",
        "elbowToKnee1RepsLelbowStart",
        "grabHighR",
        "hopBothLegs1hops",
        "jogLeftCircle4StepsRstart",
    ),
    "report": (
        "kickLFront1Reps",
        "rotateArmsBothBackward1Reps",
        "sneak2StepsLStart",
        "squat1Reps",
        "throwBasketball",
    ),
}
"""Classes of HDM05 that the folders of three actors are composed of."""
SETS: dict[str, dict[str, tuple[str, ...]]] = {
    "one actor": {"fit": ("hdm05-bd",), "report": ("hdm05-bk", "hdm05-dg")},
    "three actors": {"fit": ACTORS, "report": ACTORS},
    "gaits of two people": {"fit": ("cmu-02", "bandai-1"), "report": ("cmu-16", "bandai-2")},
}
HOW = {
    "one actor": "4 classes of HDM05, 3 takes of each by one actor",
    "three actors": "4 classes of HDM05, a take of each by each of 3 actors, classes not fitted on",
    "gaits of two people": "walks and runs, 3 of each by an actor of CMU (AMC, 120 Hz) and one of Bandai (BVH, 30 Hz)",
}


@dataclass(frozen=True)
class Clip:
    """A clip of a folder: what it shows, who moves, and where it lies."""

    label: str
    actor: str
    name: str


Answer = Callable[[Sequence[Clip]], np.ndarray]


def folder(kind: str, split: str, number: int) -> list[Clip]:
    """Compose a folder; the same number gives the same clips."""
    rng = np.random.default_rng([list(SETS).index(kind), split == "report", number])
    actors = SETS[kind][split]
    if kind == "one actor":
        return _takes(actors[number % len(actors)], None, 4, 3, rng)
    if kind == "three actors":
        labels = tuple(rng.permutation(CLASSES[split])[:4])
        return [clip for actor in actors for clip in _takes(actor, labels, 4, 1, rng)]
    return [clip for actor in actors for clip in _takes(actor, ("walk", "run"), 2, 3, rng)]


def _takes(
    actor: str, labels: Sequence[str] | None, most: int, each: int, rng: np.random.Generator
) -> list[Clip]:
    known = {move.label: move.takes for move in moves(actor)}
    chosen = labels if labels is not None else rng.permutation(sorted(known))[:most]
    return [
        Clip(str(label), actor, known[label][k])
        for label in chosen
        for k in rng.permutation(len(known[label]))[:each]
    ]


@lru_cache(maxsize=512)
def _postures(name: str) -> FeatureSequence:
    return posture(lm.embody(lm.read(locate(name))))


def ours(clips: Sequence[Clip], **options: float) -> np.ndarray:
    """Tell which pairs of clips a shared pattern joins, (R, R) bool."""
    found = find_shared_patterns([_postures(clip.name) for clip in clips], **options)
    occurs = found.counts > 0
    return (occurs[:, None] & occurs[None]).any(axis=2)


def mean_posture(clips: Sequence[Clip]) -> np.ndarray:
    """Join the clips whose mean postures are nearest, as many pairs as are of one class."""
    means = np.array([np.nanmean(_postures(clip.name).values, axis=0) for clip in clips])
    points = means.reshape(len(clips), -1, 3)
    return _nearest(np.linalg.norm(points[:, None] - points[None], axis=3).mean(axis=2), clips)


def same_length(clips: Sequence[Clip]) -> np.ndarray:
    """Join the clips whose lengths are nearest, as many pairs as are of one class."""
    seconds = np.log([len(_postures(clip.name)) / _postures(clip.name).rate for clip in clips])
    return _nearest(np.abs(seconds[:, None] - seconds[None]), clips)


def at_random(clips: Sequence[Clip]) -> np.ndarray:
    """Join pairs at random, as many as are of one class."""
    seed = zlib.crc32("".join(clip.name for clip in clips).encode())
    chance = np.random.default_rng(seed).random((len(clips), len(clips)))
    return _nearest(chance, clips)


def _nearest(distances: np.ndarray, clips: Sequence[Clip]) -> np.ndarray:
    rows, columns = np.triu_indices(len(clips), 1)
    same = sum(clips[a].label == clips[b].label for a, b in zip(rows, columns, strict=True))
    best = np.argsort(distances[rows, columns], kind="stable")[:same]
    joined = np.zeros(distances.shape, bool)
    joined[rows[best], columns[best]] = True
    return joined | joined.T


def scores(
    clips: Sequence[Clip], joined: np.ndarray, among: np.ndarray | None = None
) -> tuple[int, int, int, int]:
    """Count pairs of one class that are joined, all of one class, pairs of two that are joined, and all of two."""
    pairs = [pair for pair in combinations(range(len(clips)), 2) if among is None or among[pair]]
    same = [pair for pair in pairs if clips[pair[0]].label == clips[pair[1]].label]
    other = [pair for pair in pairs if clips[pair[0]].label != clips[pair[1]].label]
    return sum(joined[p] for p in same), len(same), sum(joined[p] for p in other), len(other)


def shares(counts: Sequence[tuple[int, int, int, int]]) -> str:
    """Say both shares, each with its interval over the folders."""
    table = np.array(counts)
    rng = np.random.default_rng(0)
    again = table[rng.integers(len(table), size=(RESAMPLED, len(table)))].sum(axis=1)
    told = []
    for hit, of, what in ((0, 1, "of one class joined"), (2, 3, "of two wrongly joined")):
        low, high = np.quantile(again[:, hit] / again[:, of], (0.025, 0.975))
        told.append(f"{table[:, hit].sum() / table[:, of].sum():.0%} ({low:.0%} to {high:.0%}) {what}")
    return ", ".join(told)


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    answers: dict[str, Answer] = {
        "default": ours, "nearest mean posture": mean_posture, "same length": same_length, "random": at_random
    }  # fmt: skip
    table = []
    for kind, how in HOW.items():
        folders = [folder(kind, "report", number) for number in range(FOLDERS)]
        for name, answer in answers.items():
            figure = shares([scores(clips, answer(clips)) for clips in folders])
            told = "" if name == "default" else "; told how many pairs are of one class"
            table.append((f"Folders of {kind}, {name}", figure, f"{FOLDERS} folders of 12 clips: {how}{told}; "
                          "pairs of clips, 95 % interval over folders"))  # fmt: skip
    return [*table, whole()]


def whole() -> Row:
    """Search all takes of HDM05 as one folder, and time it."""
    place = unpacked(HDM05)
    clips = [
        Clip(path.parent.name, path.name.split("_")[1], f"{HDM05}/{path.relative_to(place).as_posix()}")
        for path in sorted(place.rglob("*.amc"))
    ]
    sequences = [_postures(clip.name) for clip in clips]
    began = time.process_time()
    joined = ours(clips)
    spent = time.process_time() - began
    minutes = sum(len(one) / one.rate for one in sequences) / 60
    alone = np.array([[a.actor == b.actor for b in clips] for a in clips])
    by_one, by_two = (scores(clips, joined, among) for among in (alone, ~alone))
    wrong, other = by_one[2] + by_two[2], by_one[3] + by_two[3]
    return (
        "All of HDM05 as one folder, default",
        f"{by_one[0] / by_one[1]:.0%} of one class by one actor joined, {by_two[0] / by_two[1]:.0%} by two actors, "
        f"{wrong / other:.1%} of two classes wrongly joined; {spent:.0f} s CPU",
        f"{len(clips)} clips, {minutes:.1f} minutes, {len({clip.label for clip in clips})} classes by 3 actors, those "
        "to fit on among them; pairs of clips; time of the search, once",
    )


def cases(split: str, options: dict[str, float]) -> None:
    """Print each folder's counts, then the shares, of each kind of folder."""
    for kind in SETS:
        counts = []
        for number in range(FOLDERS):
            clips = folder(kind, split, number)
            joined = ours(clips, **options)
            counts.append(scores(clips, joined))
            wrong = [
                f"{clips[a].label}+{clips[b].label}"
                for a, b in combinations(range(len(clips)), 2)
                if joined[a, b] and clips[a].label != clips[b].label
            ]
            print(
                f"{kind} {number:02d}: {counts[-1][0]} of {counts[-1][1]}; wrong: {', '.join(wrong) or 'none'}"
            )
        print(f"{kind}, {split}: {shares(counts)}", flush=True)


def main() -> None:
    """Print what was asked for."""
    if sys.argv[1:2] == ["cases"]:
        given = [word.partition("=") for word in sys.argv[2:] if "=" in word]
        split = "report" if "report" in sys.argv[2:] else "fit"
        cases(split, {name: float(value) for name, _, value in given})
        return
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


if __name__ == "__main__":
    main()
