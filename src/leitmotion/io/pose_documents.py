"""Layouts of poses in JSON: from any of them to the poses of each frame.

A layout is told by the names it uses. What a value is, is asked from the outside in: a document holds frames, a frame
holds poses, a pose holds points.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from leitmotion.io.joint_sets import IN_IMAGES
from leitmotion.io.pose_tracks import Pose
from leitmotion.io.reading import Source

FRAME_RATES = ("fps", "frame_rate", "framerate", "frameRate")
"""What a rate is called."""

_FRAMES = ("frames", "instance_info", "annotations", "results", "predictions", "data")
_PEOPLE = ("people", "bodies", "instances", "poses")
_WORLD = ("keypoints3D", "keypoints_3d", "pose_world_landmarks", "poseWorldLandmarks", "worldLandmarks",
          "world_landmarks")  # fmt: skip
_POINTS = ("pose_keypoints_2d", "pose_keypoints", "keypoints", "joints", "pose_landmarks", "poseLandmarks", "landmarks",
           "landmark", "joints2d", "joints3d")  # fmt: skip
_SCORES = ("keypoint_scores", "keypoints_scores", "scores")
_SURE = ("visibility", "score", "confidence")
_HANDS_AND_FACE = ("face_keypoints_2d", "hand_left_keypoints_2d", "hand_right_keypoints_2d")
_WHO = ("track_id", "person_id", "idx")
_DIGITS = 15  # of a number of a picture
_SPAN = 10  # frames a picture beyond which numbers of pictures are no numbers of frames


class Document(NamedTuple):
    """What a file of poses holds."""

    frames: list[list[Pose]]
    names: tuple[str, ...] = ()
    """One a point, where the file says so."""

    rate: float | None = None
    aside: str = ""
    """What else the file holds and was left aside, as a sentence."""

    name: str = ""
    """What the recording is called, where several files hold it."""


def frames_of(document: Any, source: Source) -> Document:
    """Tell the poses of each frame.

    Parameters
    ----------
    document : value
        What the JSON says.
    source : Source
        The file, for the error.

    Returns
    -------
    Document
        Its poses.

    Raises
    ------
    FormatError
        When it holds no poses.
    """
    told = _Layout(source)
    try:
        frames = told.document(document)
    except RecursionError:
        raise source.error("expected poses, found JSON that nests too deeply.") from None
    return Document(frames, told.names, told.rate(document), told.aside)


class _Layout:
    """Reads one document, and gathers on the way what it says beside the poses."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.names: tuple[str, ...] = ()
        self.aside = ""
        self.where = ""

    def document(self, value: Any) -> list[list[Pose]]:
        if isinstance(value, dict):
            if isinstance(value.get("positions"), dict):
                return self.named_frames(value["positions"])
            held = next((value[key] for key in _FRAMES if isinstance(value.get(key), list | dict)), None)
            if held is not None:
                return self.document(held)
            if any(key in value for key in (*_PEOPLE, *_WORLD, *_POINTS)):
                return [self.frame(value)]
            if value and all(re.search(r"\d", key) for key in value):
                return self.in_order({key: self.frame_at(key, held) for key, held in value.items()})
        elif isinstance(value, list):
            if value and all(isinstance(item, dict) and "image_id" in item for item in value):
                return self.results(value)
            if _is_points(value):
                return [[self.points(value)]]
            if value and all(isinstance(item, list | dict) or item is None for item in value):
                return [self.frame_at(f"{k}", item) for k, item in enumerate(value)]
        raise self.fault(value)

    def results(self, results: Sequence[Mapping[str, Any]]) -> list[list[Pose]]:
        """Poses that each name their picture."""
        pictures: dict[str, list[Pose]] = {}
        for result in results:
            picture = str(result["image_id"])
            pictures.setdefault(picture, []).extend(self.frame_at(picture, result))
        return self.in_order(pictures)

    def in_order(self, pictures: Mapping[str, list[Pose]]) -> list[list[Pose]]:
        """Frames by the last number in their names; those between two that are there are empty."""
        numbers = {key: re.findall(r"\d+", key) for key in pictures}
        if not all(numbers.values()):
            return list(pictures.values())
        places = {key: int(found[-1][-_DIGITS:]) for key, found in numbers.items()}
        span = max(places.values()) - min(places.values()) + 1
        ordered = sorted(pictures, key=lambda key: places[key])
        if span > _SPAN * len(pictures) or len(set(places.values())) < len(places):
            self.aside = self.aside or (
                "The numbers of the pictures are no numbers of frames: each picture was taken as a frame, in order."
            )
            return [pictures[key] for key in ordered]
        frames: list[list[Pose]] = [[] for _ in range(span)]
        for key in ordered:
            frames[places[key] - min(places.values())] = pictures[key]
        return frames

    def named_frames(self, frames: Mapping[str, Any]) -> list[list[Pose]]:
        """Frames by number, each a table of points by name; a name missing is a point unseen."""
        rows = [row for row in frames.values() if isinstance(row, dict)]
        fullest = max(rows, key=len, default={})
        names = list(dict.fromkeys([*fullest, *(name for row in rows for name in row)]))
        if not names or len(rows) < len(frames):
            raise self.fault(frames)
        if all(name.isdigit() for name in names):
            names.sort(key=int)
        else:
            self.names = tuple(names)
        widths = {len(point) for row in rows for point in row.values() if isinstance(point, list)}
        if len(widths) != 1 or next(iter(widths)) not in (2, 3):
            raise self.fault(frames)
        unseen = [None] * next(iter(widths))
        return self.in_order(
            {
                key: [Pose(self.array([row.get(name, unseen) for name in names]))] if row else []
                for key, row in _by_number(frames)
            }
        )

    def frame_at(self, place: str, value: Any) -> list[Pose]:
        self.where = f" in frame {place[:40]}"
        return self.frame(value)

    def frame(self, value: Any) -> list[Pose]:
        if value is None or value == [] or value == {}:
            return []
        if isinstance(value, dict):
            held = next((value[key] for key in _PEOPLE if isinstance(value.get(key), list)), None)
            if held is not None:
                return [self.pose(pose) for pose in held if not _is_pointless(pose)]
            world = next((value[key] for key in _WORLD if value.get(key)), None)
            points = world or next((value[key] for key in _POINTS if value.get(key)), None)
            several = isinstance(points, list) and not _is_points(points) and not _is_flat(points)
            if points and several and all(_is_points(one) for one in points):
                return [self.points(one) for one in points]
            return [] if _is_pointless(value) else [self.pose(value)]
        if isinstance(value, list):
            if _is_points(value):
                return [self.points(value)]
            return [self.pose(pose) for pose in value if not _is_pointless(pose)]
        raise self.fault(value)

    def pose(self, value: Any) -> Pose:
        if isinstance(value, list):
            return self.points(value)
        if not isinstance(value, dict):
            raise self.fault(value)
        world = next((value[key] for key in _WORLD if value.get(key)), None)
        flat = next((value[key] for key in _POINTS if value.get(key)), None)
        if world is not None and flat is not None:
            self.aside = "It holds the points in the picture, too; those in space were read."
        if any(value.get(key) for key in _HANDS_AND_FACE):
            self.aside = "The points of hands and face were left out; those of the body were read."
        points = world if world is not None else flat
        if points is None:
            raise self.fault(value)
        scores = next((value[key] for key in _SCORES if isinstance(value.get(key), list)), None)
        pose = self.points(points)
        if scores is not None and len(scores) == len(pose.points):
            pose = Pose(pose.points, self.array(scores))
        return Pose(pose.points, pose.sure, _who(value))

    def points(self, value: Any) -> Pose:
        """Points as triples on end, as lists of coordinates, or as objects with x and y."""
        if not isinstance(value, list) or not value:
            raise self.fault(value)
        if isinstance(value[0], dict):
            return self.objects(value)
        numbers = self.array(value)
        if numbers.ndim == 1:
            numbers = numbers.reshape(-1, self.width(numbers.size, value))
            if numbers.shape[1] == 3 and np.fmin.reduce(numbers[:, 2], initial=np.inf) >= 0.0:
                return Pose(numbers[:, :2], numbers[:, 2])
            return Pose(numbers)
        if numbers.ndim != 2 or numbers.shape[1] not in (2, 3, 4):
            raise self.fault(value)
        if numbers.shape[1] == 4:
            return Pose(numbers[:, :3], numbers[:, 3])
        return Pose(numbers)

    def width(self, size: int, value: Any) -> int:
        """Numbers a point of numbers on end: three, or two where only that makes a joint set."""
        known = {len(one.joints) for one in IN_IMAGES}
        if size % 3 == 0 and (size // 3 in known or size % 2 or size // 2 not in known):
            return 3
        if size % 2 == 0 and size // 2 in known:
            return 2
        raise self.fault(value)

    def objects(self, value: Sequence[Any]) -> Pose:
        if not all(isinstance(point, dict) and "x" in point and "y" in point for point in value):
            raise self.fault(value)
        axes = "xyz" if all("z" in point for point in value) else "xy"
        names = tuple(str(point.get("name", "")) for point in value)
        if all(names) and len(set(names)) == len(names):
            self.names = names
        sure = next((key for key in _SURE if all(key in point for point in value)), None)
        return Pose(
            self.array([[point[axis] for axis in axes] for point in value]),
            None if sure is None else self.array([point[sure] for point in value]),
        )

    def array(self, value: Any) -> np.ndarray:
        try:
            return np.array(value, dtype=np.float64)
        except (TypeError, ValueError, OverflowError):
            raise self.source.error(
                f"expected numbers for the points of a pose, found something else{self.where}."
            ) from None

    def rate(self, value: Any) -> float | None:
        found = (
            next((value[key] for key in FRAME_RATES if key in value), None)
            if isinstance(value, dict)
            else None
        )
        plain = isinstance(found, int | float) and not isinstance(found, bool) and 0 < found < 1e6
        return float(found) if plain else None  # type: ignore[arg-type]

    def fault(self, value: Any) -> Exception:
        if isinstance(value, dict):
            found = f"the names {', '.join(list(value)[:6])}" if value else "an empty object"
        else:
            found = "a list of something else" if isinstance(value, list) else "something else"
        return self.source.error(
            f"expected poses such as OpenPose, AlphaPose, MediaPipe or COCO have them, found {found}{self.where}.",
            remedy="Is this a file of poses?",
        )


def _is_points(value: Any) -> bool:
    """Whether a value is a list of points: of short lists of numbers, or of objects with x and y."""
    if not isinstance(value, list) or not value:
        return False
    if all(isinstance(point, dict) for point in value):
        return all("x" in point and "y" in point for point in value)
    return all(
        isinstance(point, list) and len(point) in (2, 3, 4) and not isinstance(point[0], list | dict)
        for point in value
    )


def _is_pointless(value: Any) -> bool:
    """Whether a value has a place for the points of a person, and nothing in it."""
    if not isinstance(value, dict):
        return value is None or value == []
    keys = [key for key in (*_WORLD, *_POINTS) if key in value]
    return not value or (bool(keys) and not any(value[key] for key in keys))


def _is_flat(value: list[Any]) -> bool:
    return all(isinstance(item, int | float) for item in value)


def _who(value: Mapping[str, Any]) -> str:
    """What the file calls a person; OpenPose writes [-1] for nobody known."""
    for key in _WHO:
        who = value.get(key)
        who = who[0] if isinstance(who, list) and len(who) == 1 else who
        if isinstance(who, float) and who.is_integer():
            who = int(who)
        if isinstance(who, int | float | str) and not isinstance(who, bool) and str(who) not in ("-1", ""):
            return str(who)
    return ""


def _by_number(frames: Mapping[str, Any]) -> list[tuple[str, Any]]:
    """Frames with whole numbers for names: "12.0" is 12."""
    return [(re.sub(r"\.0+$", "", key), row) for key, row in frames.items()]
