"""AMASS: motions as rotations of SMPL's joints, in an archive of NumPy.

An ``.npz`` with ``poses`` (T, 3 J), rotation vectors in radians, each in the parent's frame, and ``trans`` (T, 3) in
metres, Z up; or with the rotations in parts, ``root_orient``, ``pose_body`` and so on. The rate is ``mocap_framerate``
or ``mocap_frame_rate``. The shape (``betas``, ``gender``) needs the body model and is not used: the bones are those of
:mod:`leitmotion.io.smpl`. SMPL's ``trans`` is the place of the model's origin, a hand's length from the pelvis; here it
is taken as the pelvis's.

Only the members that are needed are read, and never one that holds pickled Python objects unless the caller trusts it.

References
----------
[1] Mahmood, Ghorbani, Troje, Pons-Moll, Black, *AMASS: archive of motion capture as surface shapes*, ICCV 2019.
"""

from __future__ import annotations

import io
import warnings as warnings_
import zipfile
from collections.abc import Sequence

import numpy as np

from leitmotion.io.archive import promises_too_much
from leitmotion.io.points import FARTHEST
from leitmotion.io.reading import Draft, Finding, SkeletonTake, Source
from leitmotion.io.smpl import BODIES, STATURE, mean_adult
from leitmotion.motion import FormatError, rotations

_WHOLE = ("poses", "smpl_poses")
_PARTS = (
    ("root_orient", "global_orient"),
    ("pose_body", "body_pose"),
    ("pose_jaw", "jaw_pose"),
    ("pose_eye",),
    ("pose_hand",),
)
_PLACE = ("trans", "transl", "smpl_trans")
_RATE = ("mocap_framerate", "mocap_frame_rate", "framerate", "frame_rate", "fps")
_UNKNOWN_RATE = 120.0  # of most of the sets in AMASS
_Z_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])  # of the T-pose, which has Y up


def read(source: Source) -> Draft:
    """Read a motion of AMASS.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person, on the skeleton of a mean adult.

    Raises
    ------
    FormatError
        When the archive is damaged, lacks what is needed, or holds pickled objects and the caller does not trust it.
    """
    with _Archive(source) as box:
        poses = _poses(box)
        frames, joints = poses.shape[0], BODIES[poses.shape[1]]
        key = box.first(_PLACE)
        trans = box.numbers(key) if key else np.zeros((frames, 3))
        rate = _rate(box)
    if not frames:
        raise source.error("expected at least one frame of poses, found none.")
    warnings = [
        f"The file holds no bone lengths: those of a mean adult of {STATURE:.2f} m were taken for the body's shape."
    ]
    if not key:
        warnings.append("The file holds no places (trans): the pelvis stays where it is.")
    if trans.shape != (frames, 3):
        raise source.error(f"expected {key} of {frames} × 3 numbers, found {_size(trans)}.")
    for what, values in (("poses", poses), (key, trans)):
        if not (np.abs(values) < FARTHEST).all():
            raise source.error(
                f"expected finite numbers in {what}, found NaN, infinity or beyond {FARTHEST:.0e}."
            )
    if rate.how == "guessed" and source.options.rate is None:
        warnings.append(f"No rate is stated; {rate.value:g} Hz was guessed, --rate states another.")
    parents, offsets = mean_adult(joints)
    turns = rotations.from_rotation_vector(poses)
    if source.options.up in (None, "z"):
        # at rest, too, the body stands upright in the file's axes, as the reader's caller expects of a skeleton
        offsets = offsets @ _Z_UP.T
        turns[:, 1:, 1:] = turns[:, 1:, 1:] @ _Z_UP.T
        turns[:, 0] = rotations.multiply(turns[:, 0], rotations.from_matrix(_Z_UP.T))
    positions = np.broadcast_to(offsets, (frames, *offsets.shape)).copy()
    positions[:, 0] = trans
    take = SkeletonTake(
        list(joints.joints), parents, offsets, np.empty(0, dtype=np.int64), np.empty((0, 3)), positions, turns
    )
    return Draft(
        [take],
        rate=rate,
        unit=Finding("m", "read", "an AMASS archive"),
        up=Finding("z", "read", "an AMASS archive"),
        findings={"joints": Finding(joints.name, "read", f"its poses turn {len(joints.joints)} joints")},
        warnings=warnings,
    )


def looks(head: bytes) -> bool:
    """Whether a file that begins like this is an archive of arrays, other than one of ours."""
    name = head[30 : 30 + int.from_bytes(head[26:28], "little")]
    return head[:4] == b"PK\x03\x04" and name.endswith(b".npy") and name != b"header.npy"


def _poses(box: _Archive) -> np.ndarray:
    """Rotation vectors (T, J, 3)."""
    key = box.first(_WHOLE)
    if key:
        values = box.numbers(key)
    else:
        keys = [key for names in _PARTS if (key := box.first(names))]
        if box.first(_PARTS[0]) is None or box.first(_PARTS[1]) is None:
            raise box.source.error(
                f"expected the members poses and trans of an AMASS archive, found {', '.join(box.names[:8])}.",
                remedy="Save the points as CSV with the columns time, NAME_x, NAME_y, NAME_z.",
            )
        parts = [box.numbers(key) for key in keys]
        lengths = {len(part) for part in parts if part.ndim}
        if len(lengths) != 1 or any(part.ndim == 0 for part in parts):
            raise box.source.error(f"expected {', '.join(keys)} of one length, found others.")
        values = np.concatenate([part.reshape(len(part), -1) for part in parts], axis=1)
    if values.ndim not in (2, 3) or not len(values) or values[0].size not in {3 * count for count in BODIES}:
        counts = ", ".join(f"{3 * count}" for count in BODIES)
        raise box.source.error(
            f"expected poses of {counts} numbers a frame (SMPL, SMPL-H, SMPL-X), found {_size(values)}."
        )
    return values.reshape(len(values), -1, 3)


def _rate(box: _Archive) -> Finding:
    for key in _RATE:
        if key in box.names:
            rate = box.numbers(key)
            if rate.size != 1 or not (np.isfinite(rate).all() and rate.item() > 0):
                raise box.source.error(f"expected {key} to be a rate in hertz, found {rate.tolist()}.")
            return Finding(float(rate.item()), "read", f"stated as {key}")
    return Finding(_UNKNOWN_RATE, "guessed", "the rate of most of AMASS")


def _size(values: np.ndarray) -> str:
    return " × ".join(map(str, values.shape)) or "one number"


class _Archive:
    """The members of a NumPy archive, each read when it is asked for."""

    def __init__(self, source: Source) -> None:
        self.source = source
        try:
            with zipfile.ZipFile(io.BytesIO(source.content)) as box:
                self.sizes = {one.filename.removesuffix(".npy"): one for one in box.infolist()}
            self.box = np.load(io.BytesIO(source.content), allow_pickle=source.options.trust)
        except Exception:  # of what is damaged NumPy raises anything
            raise FormatError(
                f"{source.path.name} is no archive or is damaged.",
                remedy="Was it copied or downloaded completely?",
            ) from None
        self.names = list(self.box.files)

    def __enter__(self) -> _Archive:
        return self

    def __exit__(self, *error: object) -> None:
        self.box.close()

    def first(self, keys: Sequence[str]) -> str | None:
        """The first of several names that is there."""
        return next((key for key in keys if key in self.names), None)

    def numbers(self, key: str) -> np.ndarray:
        """Read one member as numbers."""
        member = self.sizes[key]
        if promises_too_much(member.file_size, member.compress_size):
            raise self.source.error(
                f"its member {key} promises {member.file_size / 1e9:.1f} GB, more than it can hold."
            )
        try:
            with warnings_.catch_warnings():
                warnings_.simplefilter("ignore")  # of a header that looks as Python 2 wrote it
                held = np.asarray(self.box[key])
        except Exception as error:  # of what is damaged NumPy raises anything
            if isinstance(error, ValueError) and "pickle" in str(error):
                raise self.source.error(
                    f"its member {key} holds pickled Python objects, which can run code when they are read.",
                    remedy="If you trust where it comes from, read it with --trust (trust=True in Python).",
                ) from None
            raise self.source.error(
                f"its member {key} is damaged.", remedy="Was it copied or downloaded completely?"
            ) from None
        try:
            return held.astype(np.float64)
        except (TypeError, ValueError):
            raise self.source.error(f"expected numbers in {key}, found something else.") from None
