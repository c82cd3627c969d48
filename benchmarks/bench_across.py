"""Patterns across recordings: whether the clips of a folder that show one movement are joined, and others not.

What a method was fitted on and what it is judged by have no person in common where several people meet but for actors
bd and bk of HDM05, of whom other classes are judged, and only beside actor dg; actor dg, subjects s03 and s04 of
UI-PRMD, subject 16 of CMU and set 2 of Bandai Namco decide nothing. In folders of several people only pairs of clips
of two people count. In those of UI-PRMD a person may do an exercise with the other side (s01 steps over the hurdle with
the right leg, s02 with the left), which is another movement to the search.

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
from intervals import of_share
from joined import CMU, HDM05, joined, moves
from leitmotion.discovery import find_shared_patterns
from leitmotion.evaluation.patterns import owners
from leitmotion.features import FeatureSequence, extract
from recordings import locate, unpacked

Row = tuple[str, str, str]
FOLDERS = 20
SESSIONS = 20
PLACES = "places of joints in place of directions"
RESAMPLED = 2000
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
"""Classes of HDM05 that folders of several actors are composed of."""
UNSEEN = "hdm05-dg"
"""The actor of HDM05 that nothing is fitted on."""
EXERCISES = ("m01", "m02", "m05", "m07", "m09")
UIPRMD = "uiprmd/uiprmd_shared.tar.xz"
SETS: dict[str, dict[str, tuple[str, ...]]] = {
    "one actor": {"fit": ("hdm05-bd", "hdm05-bk"), "report": (UNSEEN,)},
    "three actors": {"fit": ("hdm05-bd", "hdm05-bk"), "report": ("hdm05-bd", "hdm05-bk", UNSEEN)},
    "exercises of two people": {"fit": ("uiprmd-s01", "uiprmd-s02"), "report": ("uiprmd-s03", "uiprmd-s04")},
    "gaits of two people": {"fit": ("cmu-others", "bandai-1"), "report": ("cmu-16", "bandai-2")},
}
HOW = {
    "one actor": "4 classes of HDM05, 3 takes of each by an actor not fitted on; pairs of clips",
    "three actors": "4 classes of HDM05, a take of each by each of 3 actors; pairs of a clip by an actor not fitted on "
    "and one by another actor, classes not fitted on",
    "exercises of two people": "5 exercises of UI-PRMD (Kinect), 2 takes of each by each; pairs of two people",
    "gaits of two people": "walks and runs, 3 of each by an actor of CMU (AMC, 120 Hz) and one of Bandai (BVH, 30 Hz); "
    "pairs of two people",
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
        known = CLASSES["fit"] if split == "fit" else tuple(move.label for move in moves(UNSEEN))
        return _takes(actors[number % len(actors)], rng.permutation(known)[:4], 3, rng)
    if kind == "three actors":
        labels, each = rng.permutation(CLASSES[split])[:4], 1
    else:
        labels, each = (EXERCISES, 2) if kind == "exercises of two people" else (("walk", "run"), 3)
    return [clip for actor in actors for clip in _takes(actor, labels, each, rng)]


def counted(kind: str, split: str, clips: Sequence[Clip]) -> np.ndarray:
    """Tell which pairs count, (R, R) bool: of several people those of two, of three actors those of the unseen one."""
    who = np.array([clip.actor for clip in clips])
    apart = who[:, None] != who[None]
    if kind == "one actor":
        return ~apart
    if kind == "three actors" and split == "report":
        return apart & ((who[:, None] == UNSEEN) | (who[None] == UNSEEN))
    return apart


def _takes(actor: str, labels: Sequence[str], each: int, rng: np.random.Generator) -> list[Clip]:
    known = _known(actor)
    return [
        Clip(str(label), actor, known[label][k])
        for label in labels
        for k in rng.permutation(len(known[label]))[:each]
    ]


@lru_cache(maxsize=16)
def _known(actor: str) -> dict[str, tuple[str, ...]]:
    """Name the takes of an actor by what they show."""
    if actor.startswith("uiprmd"):
        place, who = locate(UIPRMD), actor.removeprefix("uiprmd-")
        return {
            name: tuple(
                f"{UIPRMD}/{path.relative_to(place).as_posix()}"
                for path in sorted(place.glob(f"correct/Kinect/Positions/{name}_{who}_e*_positions.txt"))
            )
            for name in EXERCISES
        }
    if actor == "cmu-others":
        return {
            "walk": ("cmu_amc/02_01.amc", "cmu_amc/02_02.amc", "cmu_amc/07_05-walk.amc", f"{CMU}/05/05_01.amc"),
            "run": ("cmu_amc/02_03.amc", "cmu_amc/09_06-run.amc",
                    *(f"{CMU}/09/09_{trial:02d}.amc" for trial in (1, 2, 3, 4, 5, 7))),
        }  # fmt: skip
    return {move.label: move.takes for move in moves(actor)}


@lru_cache(maxsize=512)
def _body(name: str) -> lm.Body:
    return lm.embody(lm.read(locate(name)))


@lru_cache(maxsize=1024)
def _described(name: str, feature: str) -> FeatureSequence:
    return extract(feature, _body(name))


def ours(clips: Sequence[Clip], feature: str = "limb_directions", **options: float) -> np.ndarray:
    """Tell which pairs of clips a shared pattern joins, (R, R) bool."""
    found = find_shared_patterns([_described(clip.name, feature) for clip in clips], **options)
    occurs = found.counts > 0
    return (occurs[:, None] & occurs[None]).any(axis=2)


def by_places(clips: Sequence[Clip]) -> np.ndarray:
    """Tell the same where the search compares where the joints are, in body sizes."""
    return ours(clips, "posture")


def mean_posture(clips: Sequence[Clip]) -> np.ndarray:
    """Tell how far the mean postures of clips are apart, (R, R)."""
    return _apart([np.nanmean(_described(clip.name, "posture").values, axis=0) for clip in clips])


def mean_directions(clips: Sequence[Clip]) -> np.ndarray:
    """Tell how far their mean limb directions are apart."""
    return _apart([np.nanmean(_described(clip.name, "limb_directions").values, axis=0) for clip in clips])


def same_length(clips: Sequence[Clip]) -> np.ndarray:
    """Tell how much their lengths differ, as a ratio."""
    seconds = np.log([len(_body(clip.name)) / _body(clip.name).rate for clip in clips])
    return np.abs(seconds[:, None] - seconds[None])


def at_random(clips: Sequence[Clip]) -> np.ndarray:
    """Tell nothing."""
    seed = zlib.crc32("".join(clip.name for clip in clips).encode())
    return np.random.default_rng(seed).random((len(clips), len(clips)))


def _apart(means: Sequence[np.ndarray]) -> np.ndarray:
    points = np.array(means).reshape(len(means), -1, 3)
    return np.linalg.norm(points[:, None] - points[None], axis=3).mean(axis=2)


def nearest(distances: np.ndarray, clips: Sequence[Clip], among: np.ndarray) -> np.ndarray:
    """Join the clips that are nearest, as many pairs as are of one class."""
    rows, columns = np.nonzero(np.triu(among, 1))
    same = sum(clips[a].label == clips[b].label for a, b in zip(rows, columns, strict=True))
    best = np.argsort(distances[rows, columns], kind="stable")[:same]
    joined = np.zeros(distances.shape, bool)
    joined[rows[best], columns[best]] = True
    return joined | joined.T


def scores(clips: Sequence[Clip], joined: np.ndarray, among: np.ndarray) -> tuple[int, int, int, int]:
    """Count pairs of one class that are joined, all of one class, pairs of two that are joined, and all of two."""
    pairs = [pair for pair in combinations(range(len(clips)), 2) if among[pair]]
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
    answers: dict[str, Answer] = {"default": ours, PLACES: by_places}
    cheap: dict[str, Answer] = {
        "nearest mean posture": mean_posture, "nearest mean directions": mean_directions, "same length": same_length,
        "random": at_random,
    }  # fmt: skip
    table = []
    for kind, how in HOW.items():
        folders = [folder(kind, "report", number) for number in range(FOLDERS)]
        for name, answer in (answers | cheap).items():
            counts = []
            for clips in folders:
                among, told = counted(kind, "report", clips), answer(clips)
                counts.append(scores(clips, nearest(told, clips, among) if name in cheap else told, among))
            hint = "; told how many pairs are of one class" if name in cheap else ""
            table.append((f"Folders of {kind}, {name}", shares(counts),
                          f"{FOLDERS} folders: {how}{hint}; 95 % interval over folders"))  # fmt: skip
    return [*table, *(sessions(feature) for feature in ("limb_directions", "posture")), whole()]


def sessions(feature: str) -> Row:
    """Search joined recordings of two actors, several movements in each, two at a time."""
    shown, common, wrong, beyond, pairs = 0, 0, 0, 0, 0
    for number in range(SESSIONS):
        both = [joined(f"{actor}/{number:02d}") for actor in (UNSEEN, "hdm05-bk")]
        found = find_shared_patterns([extract(feature, one.motion) for one in both])
        seen = set()
        for pair in found.pairs:
            if pair.recordings[0] == pair.recordings[1]:
                continue
            a, b = (owners(both[which].truth, np.array([span]))[0] for which, *span in (pair.a, pair.b))
            pairs += 1
            wrong += a is not None and b is not None and a != b
            beyond += a is None or b is None
            seen |= {a} if a == b else set()
        names = set(both[0].truth.actions) & set(both[1].truth.actions)
        shown, common = shown + len(names & seen), common + len(names)
    low, high = of_share(shown, common)
    return (
        f"Sessions of two actors, {'default' if feature == 'limb_directions' else PLACES}",
        f"{shown} of {common} movements of both joined ({low:.0%} to {high:.0%}); of {pairs} pairs across {wrong} join "
        f"two movements, {beyond} reach beyond one",
        f"{SESSIONS} times a joined recording of an actor not fitted on and one of another actor, all 10 classes; a "
        "stretch is of the movement whose label 80 % of its frames carry; 95 % by Wilson's score",
    )


def whole() -> Row:
    """Search all takes of HDM05 as one folder, and time it."""
    place = unpacked(HDM05)
    clips = [
        Clip(path.parent.name, path.name.split("_")[1], f"{HDM05}/{path.relative_to(place).as_posix()}")
        for path in sorted(place.rglob("*.amc"))
    ]
    sequences = [_described(clip.name, "limb_directions") for clip in clips]
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
            joined, among = ours(clips, **options), counted(kind, split, clips)
            counts.append(scores(clips, joined, among))
            wrong = [
                f"{clips[a].label}+{clips[b].label}"
                for a, b in combinations(range(len(clips)), 2)
                if among[a, b] and joined[a, b] and clips[a].label != clips[b].label
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
