"""The clips whose symmetry is labelled by eye: drawn at random from all recordings of a whole body, one per line.

A movement takes part a few times at most, so that the many takes of one do not fill the draw. A recording longer than
a labeller can look through gives a random window. ``PYTHONPATH=src python benchmarks/choose_symmetry_clips.py`` prints
``recording,start,stop``: frames from 0, half-open, at the recording's own rate.
"""

from __future__ import annotations

import random
import re
from collections import defaultdict
from collections.abc import Iterator

import leitmotion
from leitmotion.body import Body
from recordings import ARCHIVES, folder, locate, unpacked

SEED = 20261125
CLIPS = 48
TAKES, GAITS = 2, 8  # chances of one movement; of all walking and running together
SHORTEST, LONGEST = 1.0, 12.0  # seconds
WINDOW = (6.0, 12.0)  # seconds, of a recording longer than LONGEST
LIMBS = ("shoulder", "elbow", "wrist", "hip", "knee", "ankle")
SUFFIXES = (".amc", ".bvh", ".c3d", ".csv", ".json", ".mot", ".trc", ".tsv", ".txt")
NOT_BODIES = r"^(feng_arms|gesture_phase|ground_guide|video|weizmann)/|/Angles/|/cmu8_train"
TWINS = r"^hdm05/[^.]*/|^uiprmd/(in)?correct/|01_01\.bvh|Gait\.trc|pc_int|sgi_int|-(AP|BP|OP|Vicon)-|_ik\.mot"
GAIT = r"walk|run|jog|dash|sneak|/(09|16|127)/|AV_8Walk|Gait"
JUMPS = r"/16_(01|02|04|05|07|10)\."  # subject 16 jumps in these, walks and runs in all others


def names() -> Iterator[str]:
    """Names of the files that may hold a body, each trial once, in order."""
    for path in sorted(folder().rglob("*")):
        name = path.relative_to(folder()).as_posix()
        found = [name]
        if name.endswith(ARCHIVES) and not re.search(NOT_BODIES, name):
            place = unpacked(name)
            found = [f"{name}/{p.relative_to(place).as_posix()}" for p in sorted(place.rglob("*"))]
        for one in found:
            if one.endswith(SUFFIXES) and not re.search(f"{NOT_BODIES}|{TWINS}", one):
                yield one


def movement(name: str) -> str:
    """What is done in a recording, as far as its name tells: a class, a content, a subject or the file itself."""
    if re.search(GAIT, name) and not re.search(JUMPS, name):
        return "gait"
    parts = name.split("/")
    if parts[0] == "hdm05":
        return parts[-2]
    if parts[0] == "bandai_namco":
        return parts[-1].split("_")[1]
    if parts[0] == "uiprmd":
        return parts[-1][:3]
    if parts[0] in ("cmu_amc", "mocap6"):
        return "cmu " + parts[-1].split("_")[0]
    return name


def body(name: str) -> Body | None:
    """The body of a recording, or nothing where it is no whole one in space or too short."""
    try:
        found = leitmotion.embody(leitmotion.read(locate(name)))
    except leitmotion.LeitmotionError:
        return None
    whole = all(f"{side}_{limb}" in found.roles for side in ("left", "right") for limb in LIMBS)
    long_enough = len(found.positions) >= SHORTEST * found.rate
    return found if whole and long_enough and found.positions.shape[2] == 3 else None


def clips() -> list[tuple[str, int, int]]:
    """Draw the clips."""
    draw = random.Random(SEED)
    left = defaultdict(list)
    for name in names():
        left[movement(name)].append(name)
    chances = [key for key in sorted(left) for _ in range(GAITS if key == "gait" else TAKES)]
    draw.shuffle(chances)
    found: list[tuple[str, int, int]] = []
    for key in chances:
        if len(found) == CLIPS:
            break
        draw.shuffle(left[key])
        while left[key]:
            name = left[key].pop()
            if (one := body(name)) is not None:
                found.append((name, *window(len(one.positions), one.rate, draw)))
                break
    return sorted(found)


def window(frames: int, rate: float, draw: random.Random) -> tuple[int, int]:
    """The whole recording, or a random stretch of a long one."""
    if frames <= LONGEST * rate:
        return 0, frames
    length = round(draw.uniform(*WINDOW) * rate)
    start = draw.randrange(frames - length + 1)
    return start, start + length


if __name__ == "__main__":
    print("recording,start,stop")
    for clip in clips():
        print(*clip, sep=",")
