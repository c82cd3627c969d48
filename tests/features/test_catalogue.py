"""The features by name: each is what it says."""

import numpy as np
import pytest

from leitmotion.body import embody, find_roles, map_from
from leitmotion.features import FEATURES, extract, posture
from leitmotion.motion import Motion, ParameterError, Trajectories
from oracles.body import human, moved, points_of, scaled, stretched

SUIT = {"Spine1": "T10", "LeftArm": "LSHO", "RightArm": "RSHO", "LeftLeg": "LKNE", "RightLeg": "RKNE"}
CHANGED = {
    "place": lambda motion: moved(motion, yaw=0.0, by=[2.0, 0.0, -5.0]),
    "yaw": lambda motion: moved(motion, yaw=1.9, by=[0.0, 0.0, 0.0]),
    "body_size": lambda motion: scaled(motion, 0.8),
    "unit": lambda motion: scaled(motion, 100.0),
    "bone_lengths": lambda motion: stretched(motion, {"ForeArm": 1.4, "Hand": 0.7, "Leg": 1.2, "Foot": 0.8}),
}


@pytest.mark.parametrize("name", FEATURES)
def test_invariances_hold_as_listed(name, rng):
    motion = human(rng)
    feature = FEATURES[name]

    def described(motion):
        source = points_of(motion, SUIT, kind="marker") if feature.takes is Trajectories else motion
        return extract(name, source)

    own = described(motion)
    assert own.invariant_to == feature.invariant_to
    for what, change in CHANGED.items():
        same = np.allclose(described(change(motion)).values, own.values)
        assert same == (what in feature.invariant_to), what


def test_every_function_has_its_line():
    for name, feature in FEATURES.items():
        assert feature.compute.__name__ == name
        assert feature.compute.__doc__
        assert feature.summary


def test_a_recording_or_its_body(rng):
    motion = human(rng)
    assert extract("posture", motion) == extract("posture", embody(motion)) == posture(embody(motion))
    assert extract("posture", motion, find_roles(motion), roles=["head"]).names == ("head",)


def test_errors_help(rng):
    motion = human(rng)
    with pytest.raises(ParameterError, match="Did you mean posture"):
        extract("postures", motion)
    with pytest.raises(
        ParameterError, match="compares how a skeleton's joints are turned, and this is points alone"
    ):
        extract("joint_rotations", points_of(motion))
    with pytest.raises(ParameterError) as told:
        extract("marker_posture", motion)
    assert (
        told.value.remedy
        == "Compare one of posture, velocity, joint_angles, limb_directions, joint_rotations."
    )
    with pytest.raises(ParameterError, match="compares a body, and this is ndarray"):
        extract("posture", np.zeros(3))
    for name, source in (("posture", motion), ("posture", embody(motion)), ("joint_rotations", motion)):
        with pytest.raises(ParameterError, match=f"feature {name} has no option 'foo'; it has .*roles"):
            extract(name, source, foo=1)
    for name, source in (("posture", embody(motion)), ("marker_posture", points_of(motion))):
        with pytest.raises(ParameterError, match=f"feature {name} takes no body map"):
            extract(name, source, find_roles(motion))
    assert isinstance(motion, Motion)


def test_a_map_may_be_written_as_names(rng):
    motion = human(rng)
    entries = {"pelvis": "Hips", "left_hip": "LeftUpLeg", "left_knee": ["LeftLeg"]}
    assert extract("joint_rotations", motion, entries).names == ("pelvis", "left_hip", "left_knee")
    assert extract("joint_rotations", motion, entries) == extract(
        "joint_rotations", motion, map_from(entries, motion)
    )
    with pytest.raises(ParameterError, match="'Hip'"):
        extract("joint_rotations", motion, {"pelvis": "Hip"})
