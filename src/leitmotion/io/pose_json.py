"""Poses in JSON: what OpenPose, AlphaPose, MMPose, MediaPipe, TensorFlow.js and data sets of poses write.

OpenPose writes a file a frame, ``CLIP_000000000012_keypoints.json``; any of them stands for all of its clip beside it.
Other programs write one file, with a list or a table of frames, or a list of poses that name their picture. Points are
in pixels, or in shares of the picture's width and height, or in metres about the hips; Y points down. None of the
layouts states a rate.

BlazePose tells a depth to each point of a picture, too; it is no length in the picture's unit, and is left out. Where
the same file holds the points in metres, these are read.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from leitmotion.io.companions import clip_name, clips_in, frame_of
from leitmotion.io.containers import listing, read_file
from leitmotion.io.joint_sets import BLAZEPOSE, IN_IMAGES, IN_SPACE, JointSet, set_of
from leitmotion.io.json_text import parse
from leitmotion.io.points import FARTHEST, in_pixels, is_confidence, plane_unit
from leitmotion.io.pose_documents import FRAME_RATES, Document, frames_of
from leitmotion.io.pose_tracks import Pose, people
from leitmotion.io.reading import Draft, Finding, PointTake, Source

_BEGINS = re.compile(rb"(?:\xef\xbb\xbf)?\s*(?:\[\s*\[|[\[{])")
_WORDS = re.compile(
    rb'"(?:people|bodies|keypoints|keypoints3D|pose_keypoints_2d|positions|instance_info'
    rb'|(?:pose_?|world_?|poseworld)?landmarks)"',
    re.IGNORECASE,
)
_SPARSEST = 10  # frames a file beyond which files of one name are no clip
_ABOUT_HIPS = 0.1  # metres from the origin within which the middle of the hips lies where it is the origin
_IMAGE_UP = Finding("-y", "read", "image coordinates: y points down")


def read(source: Source) -> Draft:
    """Read poses.

    Parameters
    ----------
    source : Source
        The file; of a clip with a file a frame, any of them.

    Returns
    -------
    Draft
        One a person.

    Raises
    ------
    FormatError
        When the file is no JSON or holds no poses.
    """
    warnings: list[str] = []
    document = _clip(source, warnings) or frames_of(parse(source), source)
    if document.aside:
        warnings.append(document.aside)
    frames = [[_seen(pose) for pose in frame] for frame in document.frames]
    if not any(frames):
        raise source.error(
            "expected poses such as OpenPose, AlphaPose or MediaPipe write, found nobody in any frame."
        )
    frames = _confidence_apart(frames)
    found = [pose for frame in frames for pose in frame]
    shapes = {pose.points.shape for pose in found}
    if len(shapes) > 1:
        raise source.error(
            f"expected the same points in every pose, found poses of {_listed(shapes)} points and coordinates."
        )
    count, dimensions = next(iter(shapes))
    takes = people(frames, [f"point_{k}" for k in range(count)], warnings)
    stated = document.names
    known = None if stated else _joint_set(count, dimensions, found)
    findings = {}
    if known is not None:
        stated = known.joints
        findings["joints"] = Finding(known.name, "guessed", f"because a pose has {count} points")
    elif not stated:
        warnings.append(f"No joint set that is known here has {count} points: they are numbered.")
    for take in takes:
        take.names = list(stated) or take.names
    in_space = dimensions == 3 and known in IN_SPACE and known is not BLAZEPOSE
    unit = None if in_space else _unit(takes, dimensions, warnings)
    _tell_confidence(takes, warnings)
    rate, reason = (known.rate, known.usual) if known is not None else (30.0, "the usual rate of a camera")
    if document.rate is None and source.options.rate is None:
        warnings.append(f"No rate is stated; {rate:g} Hz was guessed, --rate states another.")
    return Draft(
        takes,
        rate=Finding(document.rate, "read", f"stated as {FRAME_RATES[0]}")
        if document.rate is not None
        else Finding(rate, "guessed", reason),
        unit=unit,
        up=None if in_space else _IMAGE_UP,
        findings=findings,
        warnings=warnings,
        name=document.name,
    )


def looks(head: bytes) -> bool:
    """Whether a JSON text that begins like this names poses, or is a list of lists of numbers."""
    begin = _BEGINS.match(head)
    return begin is not None and (begin[0].count(b"[") == 2 or _WORDS.search(head) is not None)


def _clip(source: Source, warnings: list[str]) -> Document | None:
    """The poses of all frames of the file's clip; None of a file that is no frame of a clip."""
    place = frame_of(source.path.name)
    folder = source.path.parent
    if place is None:
        return None
    names = clips_in(path.name for path in listing(folder)).get(place[0], {place[1]: source.path.name})
    first, count = min(names), max(names) - min(names) + 1
    if count > _SPARSEST * len(names):
        raise source.error(
            f"its clip {place[0]!r} spans {count} frames, of which {len(names)} are there.",
            remedy="Put the files of one recording into a folder of their own.",
        )
    frames: list[list[Pose]] = [[] for _ in range(count)]
    told = Document(frames)
    for number, name in names.items():
        content = source.content if name == source.path.name else read_file(folder / name)[1]
        one = Source(folder / name, content, source.options)
        held = frames_of(parse(one), one)
        if len(held.frames) > 1:
            raise one.error(f"expected the poses of one frame, found {len(held.frames)}.")
        frames[number - first] = [pose for frame in held.frames for pose in frame]
        told = told._replace(names=told.names or held.names, aside=told.aside or held.aside)
    if count > len(names):
        warnings.append(f"{count - len(names)} frames between the first and the last file are missing.")
    return told._replace(name=clip_name(source.path))


def _seen(pose: Pose) -> Pose:
    """The pose with NaN where nothing was seen: a confidence of 0, a point exactly in the corner or out of reach."""
    nowhere = ~(np.abs(pose.points) < FARTHEST).all(axis=1) | ~pose.points.any(axis=1)
    if pose.sure is not None:
        nowhere |= ~(pose.sure > 0.0)
    points = np.where(nowhere[:, None], np.nan, pose.points)
    return Pose(points, None if pose.sure is None else np.where(nowhere, 0.0, pose.sure), pose.who)


def _confidence_apart(frames: list[list[Pose]]) -> list[list[Pose]]:
    """Part three numbers a point into a place and a confidence, where the third is one everywhere.

    It lies within 0 and 1 beside pixels, or beside shares of a picture, none of which is below zero.
    """
    poses = [pose for frame in frames for pose in frame]
    if any(pose.points.shape[1] != 3 or pose.sure is not None for pose in poses):
        return frames
    points = np.concatenate([pose.points for pose in poses])
    points = points[np.isfinite(points).all(axis=1)]
    if not is_confidence(points[:, 2]) or (not in_pixels(points[:, :2]) and points.min() < 0.0):
        return frames
    return [
        [_seen(Pose(pose.points[:, :2], np.nan_to_num(pose.points[:, 2]), pose.who)) for pose in frame]
        for frame in frames
    ]


def _joint_set(count: int, dimensions: int, poses: Sequence[Pose]) -> JointSet | None:
    if dimensions == 3 and count != 17:
        return set_of(count, IN_SPACE) or set_of(count, IN_IMAGES)
    return set_of(count, IN_IMAGES if dimensions == 2 or _in_pixels(poses) else IN_SPACE)


def _in_pixels(poses: Sequence[Pose]) -> bool:
    return any(in_pixels(pose.points[:, :2]) for pose in poses)


def _unit(takes: list[PointTake], dimensions: int, warnings: list[str]) -> Finding:
    """Tell pixels, shares and metres apart; the depth of points in a picture is taken off."""
    if dimensions == 3 and _about_hips(takes):
        return Finding(
            "m", "guessed", "points in space about the middle of the hips, as MediaPipe tells them"
        )
    if dimensions == 3:
        for take in takes:
            take.positions = take.positions[..., :2]
        warnings.append("The depth of the points is no length in the picture's unit and was left out.")
    unit = plane_unit(np.concatenate([take.positions[..., :2].ravel() for take in takes]))
    if unit.value == "relative":
        warnings.append(
            "Coordinates are shares of the picture's width and height, so that lengths across and along "
            "differ in scale."
        )
    return unit


def _about_hips(takes: list[PointTake]) -> bool:
    names = [name.lower() for name in takes[0].names]
    if "left_hip" not in names or "right_hip" not in names:
        return False
    hips = [names.index("left_hip"), names.index("right_hip")]
    middles = np.concatenate([take.positions[:, hips].mean(axis=1) for take in takes])
    middles = middles[np.isfinite(middles).all(axis=1)]
    reach = max(float(np.nanmax(np.abs(take.positions), initial=0.0)) for take in takes)
    return bool(len(middles)) and reach < 3.0 and float(np.median(np.abs(middles))) < _ABOUT_HIPS


def _tell_confidence(takes: list[PointTake], warnings: list[str]) -> None:
    outside = 0
    for take in takes:
        if take.confidence is not None:
            outside += int(((take.confidence < 0.0) | (take.confidence > 1.0)).sum())
            take.confidence = np.clip(np.nan_to_num(take.confidence), 0.0, 1.0)
    if outside:
        warnings.append(f"{outside} confidences lie outside 0 to 1 and were taken as the nearer of the two.")


def _listed(shapes: set[tuple[int, ...]]) -> str:
    return " and ".join(f"{count} × {dimensions}" for count, dimensions in sorted(shapes)[:4])
