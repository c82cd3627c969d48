"""Joined recordings: clips of one actor, one after another in random order, with exact truth.

``python benchmarks/joined.py NAME... -o FOLDER`` writes them as BVH for viewing, each with its truth as CSV beside
it; without a name it lists the names.

Two to four moves of one actor are each performed one to four times. Every repetition is another take of the same move;
where takes run out, one is taken again at a speed that varies smoothly between 0.85 and 1.15. The next clip is put
where the person stands and turned to where they face, and a blend of 0.2 to 0.4 s leads over to it. The clips are left
as they are: many begin and end with a similar posture. All frames of a clip carry the label of its move; those of a
blend from one move to another carry none, and between two repetitions of one move the run goes on.

Moves that a person may take for one another (a raised hand and a waved one) never meet in one recording, and walks of
all styles and directions are one move. Left out is what begins or ends lying down: no such short blend leads there.
"""

from __future__ import annotations

import argparse
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from joining import blended, placed, rooted, warped
from leitmotion import io
from leitmotion.evaluation import PatternTruth
from leitmotion.motion import Motion, Segmentation, rotations
from recordings import locate

HDM05 = "hdm05/hdm05_bd_bk_dg.tar.xz"
CMU = "cmu_amc/cmu_amc_pack.tar.xz"
ONCE = (1.0, 1.0, 1.0)
AGAIN = (np.nan, 2.0, np.inf)
"""Cycles in a clip that shows a movement over and over: two or more, not counted."""


@dataclass(frozen=True)
class Move:
    """A movement, and the clips in which one actor performs it.

    Parameters
    ----------
    label : str
        What it is called.
    takes : tuple of str
        Names of the clips.
    cycles : (float, float, float)
        How often a clip shows the movement: the count, the least and the most that one may count.
    kin : str
        Moves of one kin resemble each other and never meet in one recording; by default the label.
    """

    label: str
    takes: tuple[str, ...]
    cycles: tuple[float, float, float] = ONCE
    kin: str = ""


@dataclass(frozen=True)
class Joined:
    """A joined recording.

    Parameters
    ----------
    name : str
        Actor and number, ``hdm05-bk/03``.
    motion : Motion
        The movement.
    truth : PatternTruth
        What is performed in it; every repetition is known exactly.
    """

    name: str
    motion: Motion
    truth: PatternTruth


HDM05_MOVES = {
    "depositFloorR": ONCE, "elbowToKnee1RepsLelbowStart": ONCE, "grabHighR": ONCE, "hopBothLegs1hops": ONCE,
    "jogLeftCircle4StepsRstart": (2.0, 1.0, 2.0), "kickLFront1Reps": ONCE, "rotateArmsBothBackward1Reps": ONCE,
    "sneak2StepsLStart": ONCE, "squat1Reps": ONCE, "throwBasketball": ONCE,
}  # fmt: skip
"""Classes of HDM05, and how often one clip shows the movement (a gait cycle is two steps)."""
COUNTS = {
    "fit": {"hdm05-bd": 24, "bandai-1": 8, "cmu-02": 8},
    "report": {"hdm05-bk": 20, "hdm05-dg": 20, "bandai-2": 14, "cmu-16": 10},
}
"""How many recordings there are of each actor: those that a method may be fitted on, and those it is judged by."""


def names(split: str) -> list[str]:
    """Name the recordings to fit on ("fit") or to report on ("report")."""
    return [f"{actor}/{k:02d}" for actor, count in COUNTS[split].items() for k in range(count)]


def joined(name: str) -> Joined:
    """Make one recording; the same name gives the same bytes."""
    actor, _, number = name.partition("/")
    rng = np.random.default_rng([zlib.crc32(actor.encode()), int(number)])
    clips = list(_clips(actor, rng))
    pieces, spans = [clips[0][1]], [(0, len(clips[0][1]))]
    for _, clip in clips[1:]:
        before = pieces[-1]
        frames = round(rng.uniform(0.2, 0.4) * before.rate)
        after = placed(clip, before, frames)
        pieces += [blended(before, after, frames), after]
        start = spans[-1][1] + frames
        spans.append((start, start + len(after)))
    motion = strung_together(pieces, name.replace("/", "-"))
    return Joined(name, motion, truth_of([move for move, _ in clips], np.array(spans), motion.rate))


def truth_of(performed: list[Move], spans: np.ndarray, rate: float) -> PatternTruth:
    """One run for each series of repetitions of one move; each repetition is known exactly."""
    labels = tuple(move.label for move in performed)
    first = [k for k in range(len(labels)) if k == 0 or labels[k] != labels[k - 1]]
    last = [*(k - 1 for k in first[1:]), len(labels) - 1]
    return PatternTruth(
        Segmentation(spans[first, 0], spans[last, 1], tuple(labels[k] for k in first), rate=rate),
        cycles=np.add.reduceat(np.array([move.cycles for move in performed]), first),
        repetitions=Segmentation(spans[:, 0], spans[:, 1], labels, rate=rate),
    )


def strung_together(pieces: list[Motion], name: str) -> Motion:
    """String motions of one skeleton together."""
    return pieces[0].replace(
        local_positions=np.concatenate([piece.local_positions for piece in pieces]),
        local_rotations=rotations.continuous(np.concatenate([piece.local_rotations for piece in pieces])),
        name=name,
    )


def _clips(actor: str, rng: np.random.Generator) -> Iterator[tuple[Move, Motion]]:
    """Choose moves, how often each is performed, the takes and the order."""
    every = moves(actor)
    chosen: dict[str, Move] = {}
    wanted = int(rng.integers(2, 5))
    for k in rng.permutation(len(every)):
        chosen.setdefault(every[k].kin or every[k].label, every[k])
    performed: list[tuple[Move, str, bool]] = []
    for move in list(chosen.values())[:wanted]:
        takes = [move.takes[k] for k in rng.permutation(len(move.takes))]
        for time in range(int(rng.integers(1, 5))):
            performed.append((move, takes[time % len(takes)], time >= len(takes)))
    for k in rng.permutation(len(performed)):
        move, take, again = performed[k]
        yield move, warped(_clip(take), rng) if again else _clip(take)


@lru_cache(maxsize=64)
def _clip(name: str) -> Motion:
    return rooted(io.read(locate(name)))


@lru_cache(maxsize=8)
def moves(actor: str) -> tuple[Move, ...]:
    """List the moves of an actor: ``hdm05-bd``, ``bandai-1``, ``cmu-02`` and so on."""
    source, _, who = actor.partition("-")
    return {"hdm05": _hdm05_moves, "bandai": _bandai_moves, "cmu": _cmu_moves}[source](who)


def _hdm05_moves(who: str) -> tuple[Move, ...]:
    place = locate(HDM05)
    return tuple(
        Move(label, tuple(f"{HDM05}/{label}/{path.name}" for path in _takes(place / label, who)), cycles)
        for label, cycles in HDM05_MOVES.items()
    )


def _takes(folder: Path, who: str) -> list[Path]:
    return sorted(folder.glob(f"HDM_{who}_*.amc"))


def _bandai_moves(who: str) -> tuple[Move, ...]:
    def clips(*which: str) -> tuple[str, ...]:
        return tuple(f"bandai_namco/dataset-{who}_{clip}.bvh" for clip in which)

    if who == "1":
        return (
            Move("bow", clips("bow_active_001", "bow_normal_001")),
            Move("wave", clips("bye_active_001"), AGAIN),
            Move("call", clips("call_normal_001")),
            Move("guide", clips("guide_normal_001")),
            Move("respond", clips("respond_normal_001")),
            Move("punch", clips("punch_normal_001"), AGAIN),
            Move("run", clips("run_active_001", "dash_active_001"), AGAIN),
            Move("walk", clips("walk_active_001", "walk_normal_001", "walk-left_normal_001", "walk-right_normal_001"),
                 AGAIN),
        )  # fmt: skip
    takes = {
        "both hands": {"raise": ("active_058", "exhausted_003", "normal_008"),
                       "wave": ("active_023", "exhausted_010", "normal_024")},
        "left hand": {"raise": ("active_015", "exhausted_009", "normal_021"),
                      "wave": ("active_017", "exhausted_029", "normal_026")},
        "right hand": {"raise": ("active_043", "exhausted_012", "normal_039"),
                       "wave": ("active_019", "exhausted_020", "normal_013")},
    }  # fmt: skip
    # a hand goes up to the shoulder in one style and over the head in another: each style is a move of its own
    hands = [
        Move(
            f"{what} {hand}",
            clips(f"{'raise-up' if what == 'raise' else what}-{hand.replace(' ', '-')}_{take}"),
            AGAIN if what == "wave" else ONCE,
            kin=hand,
        )
        for hand, kinds in takes.items()
        for what, each in kinds.items()
        for take in each
    ]
    walks = clips("walk_active_014", "walk_exhausted_021", "walk_normal_010", "walk-turn-left_active_019",
                  "walk-turn-left_exhausted_019", "walk-turn-left_normal_032", "walk-turn-right_active_017",
                  "walk-turn-right_exhausted_004", "walk-turn-right_normal_021")  # fmt: skip
    runs = clips("run_active_049", "run_exhausted_035", "run_normal_038")
    return (*hands, Move("walk", walks, AGAIN), Move("run", runs, AGAIN))


def _cmu_moves(who: str) -> tuple[Move, ...]:
    if who == "02":
        return (
            Move("walk", ("cmu_amc/02_01.amc", "cmu_amc/02_02.amc"), AGAIN),
            Move("run", ("cmu_amc/02_03.amc",), AGAIN),
            Move("jump", ("cmu_amc/02_04.amc",)),
        )

    def clips(*trials: int) -> tuple[str, ...]:
        return tuple(f"{CMU}/{who}/{who}_{trial:02d}.amc" for trial in trials)

    walks = clips(11, 13, 14, 16, 17, 19, 20, 22, 23, 25, 26, 28, 29, 31, 32, 47, 58)
    return (
        Move("walk", walks, AGAIN),
        Move("run", clips(35, 37, 38, 40, 41, 43, 44, 46, 49, 50, 52, 53, 55, 56), AGAIN),
        Move("jump", clips(1, 2, 4), kin="jump"),
        Move("jump forward", clips(5, 7, 10), kin="jump"),
    )


def main() -> None:
    """Write recordings for viewing."""
    parser = argparse.ArgumentParser(
        description="Write joined recordings as BVH, each with its truth as CSV."
    )
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("-o", "--output", type=Path, default=Path(), metavar="FOLDER")
    given = parser.parse_args()
    if not given.names:
        for split in COUNTS:
            print(f"{split}: {', '.join(names(split))}")
    for name in given.names:
        made = joined(name)
        given.output.mkdir(parents=True, exist_ok=True)
        io.write(made.motion, given.output / f"{made.motion.name}.bvh")
        io.write_annotations(made.truth.repetitions, given.output / f"{made.motion.name}.csv")


if __name__ == "__main__":
    main()
