"""Kinect tables: rows of numbers without names, three or seven a joint.

Seven are a place and a quaternion (x, y, z, w). The joints are told by how many there are: 20 of the first Kinect, 25
of the second, 32 of Azure Kinect; 17 with seven numbers each are the targets of a Vicon beside the Kinect [1]. Places
are in metres and Y points up; with Azure Kinect they are in millimetres and Y points down. The axes are the camera's
and right-handed, and Z points away from it: who faces the camera faces -Z, and has the left hand at smaller x. Blanks,
commas, semicolons or tabs divide.

References
----------
[1] Blanchard, Nguyen, Devanne, Simonnet, Le Goff-Pronost, Rémy-Néris, *Technical feasibility of supervision of
    stretching exercises by a humanoid robot coach for chronic low back pain: the R-COOL randomized trial* (2022), with
    the Keraal data set.
"""

from __future__ import annotations

import re

import numpy as np

from leitmotion.io.joint_sets import AZURE, KINECT_1, KINECT_2, JointSet
from leitmotion.io.numerals import read_rows
from leitmotion.io.points import unseen_in_origin
from leitmotion.io.reading import Draft, Finding, PointTake, Source

KERAAL_VICON = JointSet(
    "the Vicon of Keraal",
    (
        "RightForearmTarget", "LeftForearmTarget", "RightArmTarget", "LeftArmTarget", "Chest",
        "RightThighTarget", "LeftThighTarget", "RightShoulder", "LeftShoulder", "RightHand", "LeftHand",
        "RightFoot", "LeftFoot", "Hips", "Head", "RightTibiaTarget", "LeftTibiaTarget",
    ),
    60.0,
    "twice that of the Kinect beside it, which has half as many frames",
)  # fmt: skip
"""Targets of which those in the middle of a limb say nothing about a joint."""

_ROWS = {
    numbers * len(joints.joints): (joints, numbers)
    for joints in (KINECT_1, KINECT_2, AZURE, KERAAL_VICON)
    for numbers in (3, 7)
    if (joints, numbers) != (KERAAL_VICON, 3)
}
"""Joints, and numbers for each, by numbers a row."""

_AXES = {AZURE: ("mm", "-y"), KERAAL_VICON: ("mm", "z")}


def read(source: Source) -> Draft:
    """Read a table of joints without names.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person; a joint exactly in the origin is unseen.

    Raises
    ------
    FormatError
        When a row has none of the known lengths, or another than the first.
    """
    warnings: list[str] = []
    count, delimiter = _shape(source.content[:65536])
    if count not in _ROWS:
        lengths = ", ".join(map(str, sorted(_ROWS)))
        raise source.error(
            f"expected rows of {lengths} numbers, three or seven a joint of a Kinect, "
            f"found {count or 'something else'}.",
            remedy="Name the columns in a first line: time, NAME_x, NAME_y, NAME_z.",
        )
    joints, numbers = _ROWS[count]
    # between blanks no cell is empty, and a row that is short is a row that is broken
    missing = delimiter != " " or re.search(rb"nan", source.content, re.IGNORECASE) is not None
    rows = read_rows(source, 0, count, delimiter=delimiter, missing=missing)
    rows.tell_cut(source, warnings)
    positions = rows.values.reshape(len(rows.values), len(joints.joints), numbers)[..., :3].copy()
    positions[~np.isfinite(positions).all(axis=-1)] = np.nan
    unseen_in_origin(positions, warnings)
    if numbers == 7:
        warnings.append("The orientations of the joints were left out; their places were read.")
    unit, up = _AXES.get(joints, ("m", "y"))
    kind = "marker" if joints is KERAAL_VICON else "joint"
    return Draft(
        [PointTake(list(joints.joints), positions, kind)],
        rate=Finding(joints.rate, "guessed", joints.usual),
        unit=Finding(unit, "guessed", f"the unit of {_of(joints)}"),
        up=Finding(up, "guessed", f"the axes of {_of(joints)}"),
        findings={"joints": Finding(joints.name, "guessed", f"because a row has {count} numbers")},
        warnings=warnings,
    )


def looks(head: bytes) -> bool:
    """Whether a table that begins like this has rows as long as those of a Kinect, and no header."""
    return _shape(head)[0] in _ROWS


def _shape(head: bytes) -> tuple[int, str]:
    """Numbers in the first line, 0 where it holds anything else, and what divides them."""
    line = head.removeprefix(b"\xef\xbb\xbf").lstrip().partition(b"\n")[0].strip()
    if not line or re.search(rb"[^-+.,;eE\d\sNa]", line):
        return 0, " "
    delimiter = next((mark for mark in (b",", b";", b"\t") if mark in line), b" ")
    cells = line.split() if delimiter == b" " else line.split(delimiter)
    return len(cells), delimiter.decode()


def _of(joints: JointSet) -> str:
    return joints.name if joints is KERAAL_VICON else "a Kinect" if joints is not AZURE else "an Azure Kinect"
