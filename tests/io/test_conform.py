"""From a draft to nouns of the house: what holds of every reader."""

import io as streams
from functools import partial

import numpy as np
import pytest

from fuzzing.law import put
from fuzzing.seeds import SEEDS, amc, motion
from leitmotion import io
from leitmotion.io import bvh
from leitmotion.motion import rotations

DEGREES = np.arange(0.0, 1080.0, 30.0)  # three times round


def _bytes(save, *args, **kwargs):
    file = streams.BytesIO()
    save(file, *args, **kwargs)
    return file.getvalue()


def _bvh():
    turns = rotations.from_axis_angle("y", np.radians(DEGREES))[:, None] * np.ones((1, 9, 1))
    spun = motion().replace(
        local_positions=np.repeat(motion().local_positions[:1], len(DEGREES), axis=0), local_rotations=turns
    )
    return {"clip.bvh": bvh.write(spun)}


def _amc():
    rows = [
        f"{k + 1}\nroot 1 2 3 0 {angle} 0\nback {angle} 0\nhead {angle}\n" for k, angle in enumerate(DEGREES)
    ]
    return amc() | {"s_01.amc": (":FULLY-SPECIFIED\n:DEGREES\n" + "".join(rows)).encode()}


def _mot():
    head = (
        "Coordinates\ninDegrees=yes\nendheader\ntime\tpelvis_tilt\thip_flexion_r\tpelvis_ty\tknee_angle_r\n"
    )
    rows = [f"{k / 50}\t{angle}\t0\t0.9\t0\n" for k, angle in enumerate(DEGREES)]
    return {"clip.mot": (head + "".join(rows)).encode()}


def _amass():
    poses = np.zeros((len(DEGREES), 156))
    poses[:, 1] = poses[:, 7] = (np.radians(DEGREES) + np.pi) % (2 * np.pi) - np.pi
    content = _bytes(np.savez, trans=np.zeros((len(DEGREES), 3)), mocap_framerate=np.array(60.0), poses=poses)
    return {"clip.npz": content}


def _poselib():
    turns = np.zeros((len(DEGREES), 2, 4))
    turns[..., :] = np.roll(rotations.from_axis_angle("z", np.radians(DEGREES)), -1, axis=-1)[:, None]
    turns *= np.where(np.arange(len(DEGREES)) % 3 == 0, -1.0, 1.0)[:, None, None]
    held = {
        "rotation": {"arr": turns}, "root_translation": {"arr": np.zeros((len(DEGREES), 3))}, "fps": 30.0,
        "skeleton_tree": {"node_names": ["pelvis", "head"], "parent_indices": {"arr": np.array([-1, 0])},
                          "local_translation": {"arr": np.array([[0.0, 0, 0], [0, 0, 0.6]])}},
    }  # fmt: skip
    return {"clip.npy": _bytes(np.save, np.array(held, dtype=object), allow_pickle=True)}


def _uiprmd():
    angles = np.zeros((len(DEGREES), 22, 3))
    angles[:, :4, 1] = DEGREES[:, None]
    rows = "".join(",".join(map(str, row)) + "\n" for row in angles.reshape(len(DEGREES), -1).tolist())
    places = SEEDS["UI-PRMD"]()["m01_positions.txt"].splitlines(keepends=True)[0] * len(DEGREES)
    return {"m01_positions.txt": places, "m01_angles.txt": rows.encode()}


@pytest.mark.parametrize("make", [_bvh, _amc, _mot, _amass, _poselib, _uiprmd])
def test_who_turns_round_and_round_has_continuous_quaternions(tmp_path, make):
    (person,) = io.open_recording(put(tmp_path, make()), trust=True).recordings
    turns = person.local_rotations
    assert len(turns) == len(DEGREES)
    dots = np.einsum("tji,tji->tj", turns[1:], turns[:-1])
    assert dots.min() > 0.9, dots.min()
    assert rotations.geodesic_angle(turns[1:, 0], turns[:-1, 0]) == pytest.approx(np.radians(30), abs=1e-6)


@pytest.mark.parametrize(
    "name", [name for name in SEEDS if not name.endswith((".gz", ".bz2", ".xz", ".zip"))]
)
def test_up_and_unit_may_be_spelled_in_any_case(tmp_path, name):
    path = put(tmp_path, SEEDS[name]())
    read = partial(io.open_recording, path)
    plane = not hasattr(read().recordings[0], "skeleton") and read().recordings[0].positions.shape[-1] == 2
    units = [("px", "PX"), ("relative", "Relative")] if plane else [("cm", "CM"), ("mm", "Millimetre")]
    for up, spelled in (("y", "+Y"), ("-y", "-Y"), *([] if plane else [("z", "Z"), ("z", "+z"), ("x", "X")])):
        for unit, word in units:
            one, other = read(up=up, unit=unit), read(up=spelled, unit=word)
            assert one.findings == other.findings
            for a, b in zip(one.recordings, other.recordings):
                held = ("local_positions", "local_rotations") if hasattr(a, "skeleton") else ("positions",)
                for what in held:
                    np.testing.assert_array_equal(getattr(a, what), getattr(b, what))
                if hasattr(a, "skeleton"):
                    np.testing.assert_array_equal(a.skeleton.offsets, b.skeleton.offsets)
