"""UI-PRMD: rehabilitation exercises before a Kinect and a Vicon system, as tables of numbers without names.

A recording of the Kinect is two files of 66 numbers a row, 22 joints: ``…_positions.txt`` holds the place of the waist
and the place of every other joint in its parent's frame, ``…_angles.txt`` how each frame is turned in its parent's.
Neither says in which order the three angles turn. They are intrinsic, about Z, then X, then Y: the angle about X alone
stays within a quarter turn in all recordings, as the middle one of three must, and with this order the feet stand still
and the knees bend about X in the squats, with no other. A recording of the Vicon is 117 numbers a row, the 39 markers
of Plug-in-Gait in millimetres; its angles belong to a model that is not in the files.

References
----------
[1] Vakanski, Jun, Paul, Baker, *A data set of human body movements for physical rehabilitation exercises*, Data 3
    (2018).
"""

from __future__ import annotations

import re

import numpy as np

from leitmotion.io.companions import OTHER, kind_of, partners
from leitmotion.io.containers import exists, read_file
from leitmotion.io.numerals import read_rows
from leitmotion.io.points import unseen_in_origin
from leitmotion.io.reading import Draft, Finding, PointTake, SkeletonTake, Source
from leitmotion.motion import rotations

EULER = "zxy"
"""Order in which the angles of a joint turn, intrinsic."""

_ARM = ("Collar", "UpperArm", "Forearm", "Hand")
_LEG = ("UpperLeg", "LowerLeg", "Foot", "Toes")
JOINTS = (
    "Waist", "Spine", "Chest", "Neck", "Head", "HeadTip",
    *(f"{side}{part}" for limb in (_ARM, _LEG) for side in ("Left", "Right") for part in limb),
)  # fmt: skip
"""The joints of the Kinect's files, in order."""

PARENTS = (-1, 0, 1, 2, 3, 4, 2, 6, 7, 8, 2, 10, 11, 12, 0, 14, 15, 16, 0, 18, 19, 20)
"""The joint that each hangs on."""

PLUG_IN_GAIT = (
    "LFHD", "RFHD", "LBHD", "RBHD", "C7", "T10", "CLAV", "STRN", "RBAK",
    "LSHO", "LUPA", "LELB", "LFRM", "LWRA", "LWRB", "LFIN",
    "RSHO", "RUPA", "RELB", "RFRM", "RWRA", "RWRB", "RFIN",
    "LASI", "RASI", "LPSI", "RPSI",
    "LTHI", "LKNE", "LTIB", "LANK", "LHEE", "LTOE",
    "RTHI", "RKNE", "RTIB", "RANK", "RHEE", "RTOE",
)  # fmt: skip
"""The markers of the Vicon's files, in order."""


def read(source: Source) -> Draft:
    """Read a recording of the Kinect or of the Vicon.

    Parameters
    ----------
    source : Source
        Either of the two files of a recording of the Kinect, or the positions of the Vicon.

    Returns
    -------
    Draft
        One person.

    Raises
    ------
    FormatError
        When the file's partner is missing or of another length, or a row holds something else.
    """
    columns = source.content.partition(b"\n")[0].count(b",") + 1
    kind = kind_of(source.path.name)
    if columns == 3 * len(PLUG_IN_GAIT):
        if kind == "angles":
            raise source.error(
                "expected positions of markers, found the joint angles of a model that is not in the file.",
                remedy="Read the file of positions that belongs to it.",
            )
        return _vicon(source)
    if not kind:
        raise source.error(
            "a row of 66 numbers may be the positions or the angles of UI-PRMD, and needs the other beside it.",
            remedy="Keep the names the files came with: …_positions.txt and …_angles.txt.",
        )
    partner = _partner(source, kind)
    warnings: list[str] = []
    tables = {kind: _rows(source, warnings), OTHER[kind]: _rows(partner, warnings)}
    positions, angles = tables["positions"], tables["angles"]
    if len(positions) != len(angles):
        raise source.error(
            f"expected as many frames as in {partner.path.name}, found {len(tables[kind])} "
            f"and {len(tables[OTHER[kind]])}."
        )
    order = ["xyz".index(axis) for axis in EULER]
    offsets = np.median(positions, axis=0)
    offsets[0] = 0.0
    take = SkeletonTake(
        list(JOINTS),
        np.array(PARENTS),
        offsets,
        np.empty(0, dtype=np.int64),
        np.empty((0, 3)),
        positions,
        rotations.from_euler(EULER, np.radians(angles[..., order])),
    )
    return Draft(
        [take],
        rate=Finding(30.0, "guessed", "the rate of a Kinect"),
        unit=Finding("cm", "guessed", "the unit of UI-PRMD's Kinect"),
        up=Finding("y", "guessed", "the axes of UI-PRMD's Kinect"),
        findings={
            "joints": Finding(
                "UI-PRMD", "guessed", f"because a row has 66 numbers; the {OTHER[kind]} are in {partner.path}"
            ),
        },
        warnings=warnings,
    )


def looks(head: bytes) -> bool:
    """Whether a table that begins like this has rows of 66 or 117 numbers between commas, and no header."""
    line = head.removeprefix(b"\xef\xbb\xbf").partition(b"\n")[0]
    return line.count(b",") + 1 in (3 * len(JOINTS), 3 * len(PLUG_IN_GAIT)) and not re.search(
        rb"[^-+.,eE\d\s]", line
    )


def _vicon(source: Source) -> Draft:
    warnings: list[str] = []
    rows = read_rows(source, 0, 3 * len(PLUG_IN_GAIT), delimiter=",", missing=True)
    rows.tell_cut(source, warnings)
    values = rows.values
    positions = unseen_in_origin(values.reshape(len(values), -1, 3), warnings)
    return Draft(
        [PointTake(list(PLUG_IN_GAIT), positions)],
        rate=Finding(100.0, "guessed", "the rate of UI-PRMD's Vicon"),
        unit=Finding("mm", "guessed", "the unit of UI-PRMD's Vicon"),
        up=Finding("z", "guessed", "the axes of UI-PRMD's Vicon"),
        findings={"joints": Finding("Plug-in-Gait", "guessed", "because a row has 117 numbers")},
        warnings=warnings,
    )


def _rows(source: Source, warnings: list[str]) -> np.ndarray:
    rows = read_rows(source, 0, 3 * len(JOINTS), delimiter=",")
    rows.tell_cut(source, warnings)
    return rows.values.reshape(len(rows.values), len(JOINTS), 3)


def _partner(source: Source, kind: str) -> Source:
    """Find the other file of the two, beside it or in the folder of its kind beside its own."""
    beside = partners(source.path)
    found = next((one for one in beside if exists(one)), None)
    if found is None:
        where = " nor in ".join(str(one.parent) for one in beside)
        raise source.error(
            f"its {kind} need the {OTHER[kind]} of the same recording, {beside[0].name}, which is not in {where}.",
            remedy=f"Put {beside[0].name} beside it.",
        )
    return Source(*read_file(found), source.options)
