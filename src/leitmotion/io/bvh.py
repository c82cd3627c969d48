"""BVH: Biovision hierarchy, a tree of joints with channels and a row of numbers a frame.

Angles are degrees, intrinsic, and turn in the order in which a joint's channels stand, joint by joint. Positions may
stand on any joint and in any place; they take the place of the offset. BVH states neither unit nor vertical. Several
roots are several people.

References
----------
.. [1] M. Meredith, S. Maddock: Motion capture file formats explained. University of Sheffield, 2001.
"""

from __future__ import annotations

import numpy as np

from leitmotion.io.bvh_frames import rate_of, read_frames, read_header
from leitmotion.io.bvh_hierarchy import SCALE, Joint, read_hierarchy
from leitmotion.io.reading import Draft, Finding, SkeletonTake, Source
from leitmotion.io.units import unit_in_metres
from leitmotion.motion import Motion, ParameterError, rotations

CMU_BVH = frozenset({"lhipjoint", "rhipjoint", "lowerback", "lthumb", "rthumb"})
"""Joints that only the conversions of the CMU archive's own skeleton to BVH have together."""


def read(source: Source) -> Draft:
    """Read a BVH.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person a root.

    Raises
    ------
    FormatError
        When the hierarchy or a row of numbers is not what the format says; it names the line.
    """
    warnings: list[str] = []
    tree = read_hierarchy(source, warnings)
    joints = tree.joints
    header = read_header(source, tree.stop)
    if tree.columns == 0:
        raise source.error("expected at least one channel in the hierarchy, found none.")
    values = read_frames(source, header, tree.columns, warnings)
    rate = rate_of(source, header, warnings)
    roots = [k for k, joint in enumerate(joints) if joint.parent < 0]
    takes = [
        _take(joints[first:last], first, values) for first, last in zip(roots, [*roots[1:], len(joints)])
    ]
    unit = None
    if {joint.name.lower() for joint in joints} >= CMU_BVH:
        unit = Finding(
            "1/0.45 inch",
            "guessed",
            "the joints are those of the CMU archive, in whose unit the body is an adult's",
        )
    return Draft(takes, rate=rate, unit=unit, warnings=warnings)


def _take(joints: list[Joint], first: int, values: np.ndarray) -> SkeletonTake:
    frames = len(values)
    offsets = np.array([joint.offset for joint in joints])
    parents = np.array([joint.parent - first if joint.parent >= 0 else -1 for joint in joints])
    positions = np.empty((frames, len(joints), 3))
    quaternions = np.empty((frames, len(joints), 4))
    for j, joint in enumerate(joints):
        positions[:, j] = offsets[j]
        order, turning = "", []
        for k, letter in enumerate(joint.channels):
            column = values[:, joint.first + k]
            if letter == SCALE:
                continue
            if letter.isupper():
                positions[:, j, "XYZ".index(letter)] = column
            else:
                order += letter
                turning.append(column)
        if order:
            quaternions[:, j] = rotations.from_euler(order, np.deg2rad(np.stack(turning, axis=-1)))
        else:
            quaternions[:, j] = rotations.IDENTITY
    ends = [(j, end) for j, joint in enumerate(joints) for end in joint.ends]
    return SkeletonTake(
        [joint.name for joint in joints],
        parents,
        offsets,
        np.array([j for j, _ in ends], dtype=np.int64),
        np.array([end for _, end in ends]).reshape(-1, 3),
        positions,
        quaternions,
        person=joints[0].name,
    )


def write(motion: Motion, *, unit: str | float = "cm") -> bytes:
    """Make the bytes of a BVH, Y up.

    Joints stand depth first, and blanks within a name become one space. The root has position channels, and so has a
    joint whose local position leaves its offset; every joint turns in the order Z, Y, X. A leaf without an end site
    gets one of no length, which the format asks for. The frame time is written with all its digits.

    Parameters
    ----------
    motion : Motion
        T frames of J joints.
    unit : str or float
        Unit of length to write, a name or a number of metres.

    Returns
    -------
    bytes
        The file's content.

    Raises
    ------
    ParameterError
        When it is no Motion, the unit is unknown or a name is no text that UTF-8 can hold.
    """
    if not isinstance(motion, Motion):
        raise ParameterError(
            "A BVH holds a skeleton in motion, and this recording is points without one.",
            remedy="Write points as .npz, .csv or .glb.",
        )
    _, metres = unit_in_metres(unit)
    skeleton = motion.skeleton
    offsets, positions = skeleton.offsets / metres, motion.local_positions / metres
    moves = np.abs(motion.local_positions - skeleton.offsets).max(axis=(0, 2), initial=0.0) > 1e-9
    moves |= skeleton.parents < 0
    lines: list[str] = ["HIERARCHY"]
    order: list[int] = []
    children = [np.flatnonzero(skeleton.parents == j).tolist() for j in range(len(skeleton))]

    def describe(joint: int) -> None:
        # without recursion: a chain of a thousand joints is a legal skeleton
        stack: list[tuple[int, int, bool]] = [(joint, 0, False)]
        while stack:
            j, depth, closing = stack.pop()
            pad = "\t" * depth
            if closing:
                lines.append(f"{pad}}}")
                continue
            order.append(j)
            name = " ".join(skeleton.names[j].split()) or f"joint{j}"
            lines.append(f"{pad}{'JOINT' if depth else 'ROOT'} {name}")
            lines.append(f"{pad}{{")
            lines.append(f"{pad}\tOFFSET {_spell(offsets[j])}")
            turns = "Zrotation Yrotation Xrotation"
            lines.append(
                f"{pad}\tCHANNELS 6 Xposition Yposition Zposition {turns}"
                if moves[j]
                else f"{pad}\tCHANNELS 3 {turns}"
            )
            ends = skeleton.end_offsets[skeleton.end_parents == j] / metres
            for end in ends if len(ends) or children[j] else np.zeros((1, 3)):
                lines.append(f"{pad}\tEnd Site\n{pad}\t{{\n{pad}\t\tOFFSET {_spell(end)}\n{pad}\t}}")
            stack.append((j, depth, True))
            stack.extend((child, depth + 1, False) for child in reversed(children[j]))

    for root in np.flatnonzero(skeleton.parents < 0):
        describe(int(root))
    angles = np.rad2deg(rotations.as_euler("zyx", motion.local_rotations))
    columns = [
        np.concatenate((positions[:, j], angles[:, j]), 1) if moves[j] else angles[:, j] for j in order
    ]
    table = np.concatenate(columns, axis=1)
    row = " ".join(["%.10g"] * table.shape[1])
    lines += ["MOTION", f"Frames: {len(motion)}", f"Frame Time: {1.0 / motion.rate:.17g}"]
    lines += [row % tuple(numbers) for numbers in table.tolist()]
    try:
        return ("\n".join(lines) + "\n").encode("utf-8")
    except UnicodeEncodeError as error:
        name = error.object[error.start : error.end]
        raise ParameterError(
            f"A BVH is a text in UTF-8, which cannot hold {name!r} in a joint's name."
        ) from None


def _spell(vector: np.ndarray) -> str:
    return " ".join(f"{number:.10g}" for number in vector)
