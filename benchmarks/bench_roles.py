"""Roles where names say nothing: real recordings with their names taken away.

The split was fixed before anything was measured. Made and tuned on: the loose recordings of `cmu86`, `mocap6`,
`cmu_amc` and `hdm05` (actor bd), and set 1 of `bandai_namco`. Reported on: everything else that has a skeleton and
names, which is set 2 of `bandai_namco`, `perfume_dance`, `animated_drawings`, `pymo`, the archive `cmu_amc_pack`
without the trials that also lie beside it, the archive of `hdm05` without actor bd, and of the archive of `uiprmd` the
first Kinect recording of each exercise and subject but s01. Two were moved to what the method was made on after it had
failed on them: `cmu_bvh`, of which 84.7 % of the roles were right, and the loose `uiprmd`, of which none were.

The truth is what the names said before they were taken away. A role is right when it is that very joint (of points: a
point at its place), and wrong when it is another or none. Intervals are 95 %, by bootstrap over recordings.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from leitmotion import io
from leitmotion.body import BodyMap, check_sides, find_roles, mirror_role, swap_sides
from leitmotion.motion import (
    LeitmotionError,
    Motion,
    Skeleton,
    Trajectories,
    forward_kinematics,
    joint_points,
)
from recordings import unpacked

Row = tuple[str, str, str]
Recording = Motion | Trajectories
WALKED_M = 2.0
SAME_M = 1e-3
MADE_ON = ("cmu86", "mocap6", "cmu_amc", "cmu_bvh", "hdm05")
REPORTED = ("perfume_dance", "animated_drawings", "pymo")
ARCHIVES = ("cmu_amc/cmu_amc_pack", "hdm05/hdm05_bd_bk_dg", "uiprmd/uiprmd_shared")
CMU_ORDER = (
    "pelvis", "", "left_hip", "left_knee", "left_ankle", "left_toe", "", "right_hip", "right_knee", "right_ankle",
    "right_toe", "", "spine", "chest", "neck", "", "head", "left_clavicle", "left_shoulder", "left_elbow", "left_wrist",
    "left_hand", "", "", "right_clavicle", "right_shoulder", "right_elbow", "right_wrist", "right_hand",
)  # fmt: skip


def main() -> None:
    """Print the table; `made` measures on the recordings that the method was made on instead."""
    for what, figure, protocol in rows(made="made" in sys.argv[1:]):
        print(f"{what}: {figure} ({protocol})")


def rows(made: bool = False) -> list[Row]:
    """Measure; (what, figure, protocol) for every line; nothing without the folder of recordings."""
    folder = os.environ.get("LEITMOTION_DATA")
    if not folder:
        return []
    paths = made_on(Path(folder)) if made else reported(Path(folder))
    return measure([recording for path in paths if (recording := readable(path)) is not None])


def made_on(data: Path) -> Iterator[Path]:
    """Paths of what the method was made on."""
    for folder in MADE_ON:
        yield from sorted(path for path in (data / folder).rglob("*") if path.suffix in (".amc", ".bvh"))
    yield from sorted((data / "bandai_namco").glob("dataset-1_*.bvh"))
    yield from sorted((data / "uiprmd").rglob("*_positions.txt"))


def reported(data: Path) -> Iterator[Path]:
    """Paths of what is reported, archives unpacked."""
    for folder in REPORTED:
        yield from sorted((data / folder).glob("*.bvh"))
    yield from sorted((data / "bandai_namco").glob("dataset-2_*.bvh"))
    seen = {path.name.split("-")[0].removesuffix(".amc") for path in made_on(data)}
    cmu, hdm, uiprmd = (unpacked(f"{archive}.tar.xz") for archive in ARCHIVES)
    for path in [*sorted(cmu.rglob("*.amc")), *sorted(hdm.rglob("*.amc"))]:
        if path.stem.split("-")[0] not in seen and not path.name.startswith("HDM_bd"):
            yield path
    for path in sorted(uiprmd.rglob("Kinect/Positions/m*_e01_positions*.txt")):
        if "_s01_" not in path.name:
            yield path


def readable(path: Path) -> Motion | None:
    """Read a recording; None of a trial whose skeleton is not in the archive."""
    try:
        recording = io.read(path)
    except LeitmotionError:
        return None
    return recording if isinstance(recording, Motion) else None


def measure(recordings: list[Motion]) -> list[Row]:
    """Change each recording in every way, and compare what is found with what its names said."""
    told = [(motion, truth_of(motion)) for motion in recordings]
    people = len({motion.skeleton.offsets.tobytes() for motion in recordings})
    whole = [(motion, truth) for motion, truth in told if len(truth) >= FEWEST]
    feet = [has_feet(motion, truth) for motion, truth in whole]
    walks = [walked(motion, truth) >= WALKED_M for motion, truth in whole]
    table, seconds = [], []
    for what, change, groups in WAYS:
        kept = [
            foot and change in WITH_FEET and (change is not points or "left_toe" in truth)
            for foot, (_, truth) in zip(feet, whole, strict=True)
        ]
        shares: dict[str, list[float]] = {group: [] for group in groups}
        unsure: dict[str, list[float]] = {group: [] for group in groups}
        swapped, trusted = dict.fromkeys(groups, 0), {group: np.zeros(2) for group in groups}
        for (motion, truth), foot, walk in zip(whole, kept, walks, strict=True):
            group = "with feet" if foot else "walking 2 m" if walk else "neither"
            if group not in groups:
                continue
            changed, place = change(motion, truth, np.random.default_rng(len(motion)))
            began = time.process_time()
            found = find_roles(changed)
            seconds.append(time.process_time() - began)
            wanted = {role: place[joint] for role, joint in truth.items() if joint in place}
            shares[group].append(right(found, wanted, changed))
            trusted[group] += believed(found, wanted, changed)
            sure, wrong = sides(found, wanted, changed)
            unsure[group].append(sure)
            swapped[group] += wrong
        for group in groups:
            if shares[group]:
                line = f"{interval(shares[group])}; swapped and sure {swapped[group]}"
                if trusted[group][1]:
                    line += (
                        f"; of what is said with more than 0.5 {trusted[group][0] / trusted[group][1]:.1%}"
                    )
                if group == "neither":
                    line += f"; highest confidence of a side {max(unsure[group]):.2f}"
                table.append((f"{what}, {group}", line, f"roles right, {len(shares[group])} recordings"))
    table.append(("Skeletons in all", f"{people}", "by their bones' lengths; intervals are over recordings"))
    table += cheap(whole)
    table += swaps(whole)
    table.append(
        (
            "Time of find_roles",
            f"median {np.median(seconds) * 1e3:.0f} ms, longest {max(seconds) * 1e3:.0f} ms",
            "CPU time, all of the above",
        )
    )
    return table


def truth_of(motion: Motion) -> dict[str, int]:
    """Read the roles that are one joint each from its names; nothing where they are in doubt."""
    found = find_roles(motion)
    if not len(found.roles) or found.confidence.min() < 0.8:
        return {}
    return {
        role: motion.skeleton.index(members[0])
        for role, members in zip(found.roles, found.members, strict=True)
        if len(members) == 1
    }


def has_feet(motion: Motion, truth: dict[str, int]) -> bool:
    """Whether a joint or an end site hangs on each ankle."""
    return all(
        truth[f"{side}_ankle"] in {*motion.skeleton.parents.tolist(), *motion.skeleton.end_parents.tolist()}
        for side in ("left", "right")
    )


def walked(motion: Motion, truth: dict[str, int]) -> float:
    """How far the person goes, without swaying, in metres: mean speed where it is above 0.4 m/s, times the duration."""
    way = forward_kinematics(motion).positions[:, truth["pelvis"], ::2]
    lag = max(1, round(motion.rate / 4))
    speed = np.linalg.norm(way[lag:] - way[:-lag], axis=1) / lag * motion.rate
    return float(np.where(speed > 0.4, speed, 0.0).mean() * motion.duration) if len(speed) else 0.0


def unnamed(
    motion: Motion, truth: dict[str, int], rng: np.random.Generator
) -> tuple[Recording, dict[int, int]]:
    """Take the names away, and put the joints in another order that a tree allows."""
    order = any_order(motion.skeleton.parents, rng)
    return reordered(motion, order, [f"n{k}" for k in rng.permutation(len(order))])


def misnamed(
    motion: Motion, truth: dict[str, int], rng: np.random.Generator
) -> tuple[Recording, dict[int, int]]:
    """Give the names to other joints at random."""
    names = motion.skeleton.names
    return reordered(motion, list(range(len(names))), [names[k] for k in rng.permutation(len(names))])


def half_named(
    motion: Motion, truth: dict[str, int], rng: np.random.Generator
) -> tuple[Recording, dict[int, int]]:
    """Take half of the names away."""
    names = motion.skeleton.names
    kept = rng.random(len(names)) < 0.5
    return reordered(
        motion,
        list(range(len(names))),
        [n if k else f"n{i}" for i, (n, k) in enumerate(zip(names, kept, strict=True))],
    )


def helped(
    motion: Motion, truth: dict[str, int], rng: np.random.Generator
) -> tuple[Recording, dict[int, int]]:
    """Add what rigs have besides a body: a node on the ground, twist joints, a target, a prop, stubs; without names."""
    tree = Tree.of(motion)
    for role in ("left_knee", "right_knee", "left_wrist", "right_wrist"):
        tree.split(truth[role])
    target = forward_kinematics(motion).positions[:, truth["left_wrist"]]
    tree.add(truth["right_wrist"], np.broadcast_to([0.0, -0.9, 0.2], (len(motion), 3)))
    for role in ("head", "left_elbow", "chest"):
        tree.add(truth.get(role, 0), np.broadcast_to(rng.normal(scale=0.04, size=3), (len(motion), 3)))
    scene = tree.under_a_node(target)
    changed, place = unnamed(scene, truth, rng)
    return changed, {joint: place[tree.place[joint + 1]] for joint in range(len(motion.skeleton))}


def footless(
    motion: Motion, truth: dict[str, int], rng: np.random.Generator
) -> tuple[Recording, dict[int, int]]:
    """Cut off all below the ankles; without names."""
    return cut(motion, {truth["left_ankle"], truth["right_ankle"]}, rng)


def cut(motion: Motion, ends: set[int], rng: np.random.Generator) -> tuple[Recording, dict[int, int]]:
    body = motion.skeleton
    gone: set[int] = set()
    for joint, up in enumerate(body.parents):
        if int(up) in gone or int(up) in ends:
            gone.add(joint)
    kept = [joint for joint in range(len(body)) if joint not in gone]
    sites = [k for k, up in enumerate(body.end_parents) if int(up) not in gone | ends]
    smaller = motion.replace(
        skeleton=Skeleton(
            tuple(body.names[j] for j in kept),
            [kept.index(int(body.parents[j])) if body.parents[j] >= 0 else -1 for j in kept],
            body.offsets[kept],
            [kept.index(int(body.end_parents[k])) for k in sites],
            body.end_offsets[sites],
        ),
        local_positions=motion.local_positions[:, kept],
        local_rotations=motion.local_rotations[:, kept],
    )
    changed, place = unnamed(smaller, {}, rng)
    return changed, {joint: place[k] for k, joint in enumerate(kept)}


def points(
    motion: Motion, truth: dict[str, int], rng: np.random.Generator
) -> tuple[Recording, dict[int, int]]:
    """Keep the joints as points only, without tree and names."""
    return pointed(*unnamed(motion, truth, rng))


def footless_points(
    motion: Motion, truth: dict[str, int], rng: np.random.Generator
) -> tuple[Recording, dict[int, int]]:
    """Keep the joints that are no feet as points only."""
    return pointed(*footless(motion, truth, rng))


def pointed(motion: Recording, place: dict[int, int]) -> tuple[Recording, dict[int, int]]:
    assert isinstance(motion, Motion)
    return joint_points(motion), place


WAYS: tuple[tuple[str, Callable[..., tuple[Recording, dict[int, int]]], tuple[str, ...]], ...] = (
    ("Skeleton, names removed, order changed", unnamed, ("with feet", "walking 2 m", "neither")),
    ("Skeleton, names at other joints", misnamed, ("with feet", "walking 2 m", "neither")),
    ("Skeleton, half of the names removed", half_named, ("with feet", "walking 2 m", "neither")),
    ("Skeleton, helpers mixed in, names removed", helped, ("with feet", "walking 2 m", "neither")),
    ("Skeleton cut at the ankles, names removed", footless, ("walking 2 m", "neither")),
    ("Joint points, names removed", points, ("with feet", "walking 2 m", "neither")),
    ("Joint points without feet, names removed", footless_points, ("walking 2 m", "neither")),
)
WITH_FEET = (unnamed, misnamed, half_named, helped, points)
FEWEST = 12


class Tree:
    """A motion's joints, to which some are added."""

    def __init__(
        self, parents: list[int], positions: list[np.ndarray], rotations: list[np.ndarray], motion: Motion
    ):
        self.parents, self.positions, self.rotations, self.motion = parents, positions, rotations, motion
        self.place: dict[int, int] = {}

    @classmethod
    def of(cls, motion: Motion) -> Tree:
        """Take a motion apart."""
        joints = range(len(motion.skeleton))
        return cls(
            [int(p) for p in motion.skeleton.parents],
            [motion.local_positions[:, j] for j in joints],
            [motion.local_rotations[:, j] for j in joints],
            motion,
        )

    def add(self, parent: int, positions: np.ndarray) -> int:
        """Hang a joint on another."""
        self.parents.append(parent)
        self.positions.append(positions)
        self.rotations.append(np.tile([1.0, 0.0, 0.0, 0.0], (len(self.motion), 1)))
        return len(self.parents) - 1

    def split(self, joint: int) -> None:
        """Put a joint into the middle of the bone that leads to one."""
        half = self.positions[joint] / 2
        self.parents[joint] = self.add(self.parents[joint], half)
        self.positions[joint] = half

    def under_a_node(self, target: np.ndarray) -> Motion:
        """Put everything under a node on the ground, and a target beside it; the node comes first."""
        still = np.tile([1.0, 0.0, 0.0, 0.0], (len(self.motion), 1))
        parents = [-1, *(p + 1 for p in self.parents), 0]
        positions = [np.zeros_like(target), *self.positions, target]
        rotations = [still, *self.rotations, still]
        order: list[int] = []
        while len(order) < len(parents):
            order += [
                j for j in range(len(parents)) if j not in order and (parents[j] < 0 or parents[j] in order)
            ]
        body = self.motion.skeleton
        local = np.stack([positions[j] for j in order], axis=1)
        motion = Motion(
            Skeleton(
                tuple(f"j{j}" for j in order),
                [order.index(parents[j]) if parents[j] >= 0 else -1 for j in order],
                local[0],
                [order.index(int(j) + 1) for j in body.end_parents],
                body.end_offsets,
            ),
            local,
            np.stack([rotations[j] for j in order], axis=1),
            self.motion.rate,
        )
        back = sorted(range(len(order)), key=lambda k: order[k])
        self.place = {j: back[j] for j in range(len(order))}
        return motion


def any_order(parents: np.ndarray, rng: np.random.Generator) -> list[int]:
    """Give an order of the joints in which a parent comes before its children."""
    order: list[int] = []
    while len(order) < len(parents):
        ready = [j for j, p in enumerate(parents) if j not in order and (p < 0 or p in order)]
        order.append(int(rng.choice(ready)))
    return order


def reordered(motion: Motion, order: list[int], names: list[str]) -> tuple[Recording, dict[int, int]]:
    """Put joints in another order under other names; tell where each went."""
    body = motion.skeleton
    place = {old: new for new, old in enumerate(order)}
    skeleton = Skeleton(
        tuple(names),
        [place[int(body.parents[old])] if body.parents[old] >= 0 else -1 for old in order],
        body.offsets[order],
        [place[int(up)] for up in body.end_parents],
        body.end_offsets,
    )
    changed = motion.replace(
        skeleton=skeleton,
        local_positions=motion.local_positions[:, order],
        local_rotations=motion.local_rotations[:, order],
    )
    return changed, place


def names_of(recording: Recording) -> tuple[str, ...]:
    """Names of joints or points."""
    return recording.skeleton.names if isinstance(recording, Motion) else recording.names


def is_it(recording: Recording, members: tuple[str, ...], point: int) -> bool:
    """Whether a role is that very joint; of points, whether it is at its place."""
    names = names_of(recording)
    if members == (names[point],):
        return True
    if isinstance(recording, Motion):
        return False
    mean = recording.positions[:, [names.index(name) for name in members]].mean(axis=1)
    return bool(np.abs(mean - recording.positions[:, point]).max() <= SAME_M)


def right(found: BodyMap, wanted: dict[str, int], recording: Recording) -> float:
    """Share of the roles that are where the names had them."""
    told = dict(zip(found.roles, found.members, strict=True))
    return float(
        np.mean([role in told and is_it(recording, told[role], point) for role, point in wanted.items()])
    )


def believed(found: BodyMap, wanted: dict[str, int], recording: Recording) -> tuple[int, int]:
    """How many roles of a confidence above 0.5 are right, and how many there are."""
    sure = [
        (role, members)
        for role, members, confidence in zip(found.roles, found.members, found.confidence, strict=True)
        if confidence > 0.5 and role in wanted
    ]
    return sum(is_it(recording, members, wanted[role]) for role, members in sure), len(sure)


def sides(found: BodyMap, wanted: dict[str, int], recording: Recording) -> tuple[float, int]:
    """Highest confidence of a role with a side; how many are the other side's joint with more than 0.5."""
    sure, wrong = 0.0, 0
    for role, members, confidence in zip(found.roles, found.members, found.confidence, strict=True):
        other = mirror_role(role)
        if role == other:
            continue
        sure = max(sure, float(confidence))
        if confidence > 0.5 and other in wanted and role in wanted:
            wrong += is_it(recording, members, wanted[other]) and not is_it(recording, members, wanted[role])
    return sure, wrong


def cheap(whole: list[tuple[Motion, dict[str, int]]]) -> list[Row]:
    """What three cheap answers get right."""
    chance = [1 / len(motion.skeleton) for motion, _ in whole]
    ordered = [
        float(np.mean([j < len(CMU_ORDER) and CMU_ORDER[j] == role for role, j in truth.items()]))
        for _, truth in whole
    ]
    spoken = []
    for motion, truth in whole:
        changed, place = points(motion, truth, np.random.default_rng(len(motion)))
        unseen = changed.replace(positions=np.full_like(changed.positions, np.nan))
        spoken.append(
            right(find_roles(unseen), {role: place[joint] for role, joint in truth.items()}, unseen)
        )
    return [
        ("Cheap: any joint for any role", interval(chance), "roles right; one over the number of joints"),
        ("Cheap: the order of CMU's skeletons", interval(ordered), "roles right, in the files' own order"),
        ("Cheap: names alone", interval(spoken), "names removed, the same recordings without any place"),
    ]


def swaps(whole: list[tuple[Motion, dict[str, int]]]) -> list[Row]:
    """How often the check of sides says what it should, of recordings as they are and with sides exchanged."""
    alarms, found, told = [], 0, 0
    for motion, _ in whole:
        roles = find_roles(motion)
        told += check_sides(motion, roles).verdict == "agree"
        if check_sides(motion, roles).verdict == "swapped":
            alarms.append(motion.name)
        found += check_sides(motion, swap_sides(roles)).verdict == "swapped"
    return [
        ("Sides as named: agreed", f"{told} of {len(whole)}", "check_sides"),
        (
            "Sides as named: false alarms",
            f"{len(alarms)} of {len(whole)} {' '.join(alarms)}".strip(),
            "check_sides",
        ),
        ("Sides exchanged: found", f"{found} of {len(whole)}", "check_sides"),
    ]


def interval(shares: list[float]) -> str:
    """Mean with its 95 % interval over recordings."""
    rng = np.random.default_rng(0)
    means = [rng.choice(shares, len(shares)).mean() for _ in range(2000)]
    low, high = np.quantile(means, (0.025, 0.975))
    return f"{np.mean(shares):.1%} ({low:.1%} to {high:.1%})"


if __name__ == "__main__":
    main()
