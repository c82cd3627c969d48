"""NTU RGB+D: skeletons of several people before a second Kinect, as text.

The number of frames, then for each frame the number of bodies, and for each body a line that begins with its tracking
number, the number of joints, and a line of twelve numbers a joint: its place in metres, its place in the depth and the
colour picture, its orientation, and how it is tracked: 0 not at all, 1 inferred, 2 tracked. The axes are those of the
Kinect: Y up, Z away from the camera, right-handed. The file states no rate.

References
----------
[1] Shahroudy, Liu, Ng, Wang, *NTU RGB+D: a large scale dataset for 3D human activity analysis*, CVPR 2016.
"""

from __future__ import annotations

import numpy as np

from leitmotion.io.joint_sets import KINECT_2
from leitmotion.io.points import unseen_in_origin
from leitmotion.io.reading import Draft, Finding, PointTake, Source, glimpse
from leitmotion.motion import FormatError

_NUMBERS = 12


def read(source: Source) -> Draft:
    """Read skeletons of NTU RGB+D.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person a tracking number; NaN in the frames without them.

    Raises
    ------
    FormatError
        When a line is not what its place asks for; it names the line.
    """
    warnings: list[str] = []
    lines = _Lines(source)
    promised = lines.count("the number of frames")
    frames: list[dict[str, np.ndarray]] = []
    while len(frames) < promised and not lines.ended():
        frame: dict[str, np.ndarray] = {}
        for _ in range(lines.count("the number of bodies")):
            who = lines.next("a line about a body").split()[0].decode("ascii", "replace")
            joints = lines.count("the number of joints")
            if joints != len(KINECT_2.joints):
                raise lines.fault(f"{len(KINECT_2.joints)} joints", f"{joints}")
            frame[who] = np.array([lines.numbers(_NUMBERS) for _ in range(joints)])
        frames.append(frame)
    if len(frames) < promised:
        warnings.append(
            f"The header promises {promised} frames, the file has {len(frames)}; those it has were read."
        )
    people = dict.fromkeys(who for frame in frames for who in frame)
    if not people:
        raise source.error(f"expected skeletons, found nobody in its {len(frames)} frames.")
    takes = [_take(who, frames) for who in people]
    for take in takes:
        unseen_in_origin(take.positions, warnings)
    return Draft(
        takes,
        rate=Finding(KINECT_2.rate, "guessed", KINECT_2.usual),
        unit=Finding("m", "read", "NTU RGB+D tells metres"),
        up=Finding("y", "read", "the axes of a Kinect"),
        warnings=warnings,
    )


def looks(head: bytes) -> bool:
    """Whether a text that begins like this is such a file: two whole numbers alone, then a line of ten."""
    lines = [line.split() for line in head.split(b"\n")[:400]]
    start = next((k for k, line in enumerate(lines) if len(line) != 1 or not line[0].isdigit()), 0)
    return start >= 2 and len(lines[start]) == 10 and len(lines) > start + 1 and lines[start + 1] == [b"25"]


def _take(who: str, frames: list[dict[str, np.ndarray]]) -> PointTake:
    count = len(KINECT_2.joints)
    positions = np.full((len(frames), count, 3), np.nan)
    confidence = np.zeros((len(frames), count))
    for t, frame in enumerate(frames):
        if who in frame:
            positions[t] = frame[who][:, :3]
            confidence[t] = np.clip(np.nan_to_num(frame[who][:, -1]) / 2, 0.0, 1.0)
    return PointTake(list(KINECT_2.joints), positions, "joint", confidence, who)


class _Lines:
    """The lines of a file, one after another."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.lines = source.content.rstrip().split(b"\n")
        self.place = 0

    def ended(self) -> bool:
        return self.place >= len(self.lines)

    def next(self, expected: str) -> bytes:
        while not self.ended() and not self.lines[self.place].strip():
            self.place += 1
        if self.ended():
            raise self.source.error(
                f"expected {expected} after line {len(self.lines)}, found the end.",
                remedy="Was it copied or downloaded completely?",
            )
        self.place += 1
        return self.lines[self.place - 1]

    def count(self, expected: str) -> int:
        line = self.next(expected).strip()
        if not line.isdigit() or len(line) > 9:
            raise self.fault(expected, glimpse(line))
        return int(line)

    def numbers(self, count: int) -> list[float]:
        line = self.next(f"{count} numbers of a joint")
        cells = line.split()
        try:
            values = [float(cell) for cell in cells]
        except ValueError:
            raise self.fault(f"{count} numbers of a joint", glimpse(line)) from None
        if len(values) != count:
            raise self.fault(f"{count} numbers of a joint", f"{len(values)}")
        return values

    def fault(self, expected: str, found: str) -> FormatError:
        return FormatError(f"{self.source.path.name}, line {self.place}: expected {expected}, found {found}.")
