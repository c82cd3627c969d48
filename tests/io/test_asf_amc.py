"""ASF/AMC: agreement with the BVH of the same trial and with chained scipy Rotations."""

import numpy as np
import pytest
from oracles import amc as amc_oracle
from oracles import bvh as bvh_oracle

from leitmotion import io
from leitmotion.motion import forward_kinematics, rotations

UNIT = 0.0254 / 0.45

BVH_NAME = {
    "root": "Hips",
    "lhipjoint": "LHipJoint", "lfemur": "LeftUpLeg", "ltibia": "LeftLeg", "lfoot": "LeftFoot", "ltoes": "LeftToeBase",
    "rhipjoint": "RHipJoint", "rfemur": "RightUpLeg", "rtibia": "RightLeg", "rfoot": "RightFoot",
    "rtoes": "RightToeBase",
    "lowerback": "LowerBack", "upperback": "Spine", "thorax": "Spine1",
    "lowerneck": "Neck", "upperneck": "Neck1", "head": "Head",
    "lclavicle": "LeftShoulder", "lhumerus": "LeftArm", "lradius": "LeftForeArm", "lwrist": "LeftHand",
    "lhand": "LeftFingerBase", "lfingers": "LFingers", "lthumb": "LThumb",
    "rclavicle": "RightShoulder", "rhumerus": "RightArm", "rradius": "RightForeArm", "rwrist": "RightHand",
    "rhand": "RightFingerBase", "rfingers": "RFingers", "rthumb": "RThumb",
}  # fmt: skip


DROPPED = ("lowerneck", "lclavicle", "rclavicle", "lhand", "lthumb", "rhand", "rthumb")
"""Where a bone branches, the program that made this BVH hung its children on the bone's joint and not on its tip."""


@pytest.fixture(scope="module")
def pair(data):
    """The same trial as AMC and as BVH, which begins with a T-pose more."""
    of_amc = io.read(data / "cmu_amc" / "01_01.amc")
    of_bvh = io.read(data / "cmu_bvh" / "01_01.bvh")
    assert len(of_bvh) == len(of_amc) + 1
    return of_amc, of_bvh[1:]


def _apart(a, b):
    ours, theirs = forward_kinematics(a).positions, forward_kinematics(b).positions
    pairs = [(a.skeleton.index(x), b.skeleton.index(y)) for x, y in BVH_NAME.items()]
    return {
        name: np.abs(ours[:, i] - theirs[:, j]).max() for name, (i, j) in zip(BVH_NAME, pairs, strict=True)
    }


@pytest.mark.data
def test_amc_and_bvh_of_one_trial_agree_below_the_chest(pair):
    apart = _apart(*pair)
    below = [n for n in BVH_NAME if n in ("root", "lowerback", "upperback", "thorax") or n[1:] in (
        "hipjoint", "femur", "tibia", "foot", "toes")]  # fmt: skip
    assert len(below) == 14
    assert max(apart[name] for name in below) < 1e-4


@pytest.mark.data
def test_amc_and_bvh_of_one_trial_agree_joint_by_joint(pair):
    of_amc, of_bvh = pair
    moved = np.array(of_bvh.local_positions)
    for name in DROPPED:
        j = of_bvh.skeleton.index(BVH_NAME[name])
        assert not of_bvh.skeleton.offsets[j].any()
        moved[:, j] = of_amc.skeleton.offsets[of_amc.skeleton.index(name)]
    apart = _apart(of_amc, of_bvh.replace(local_positions=moved))
    assert max(apart.values()) < 1e-4


@pytest.mark.data
def test_amc_and_bvh_of_one_trial_turn_alike(pair):
    of_amc, of_bvh = pair
    for ours, theirs in BVH_NAME.items():
        a = of_amc.local_rotations[:, of_amc.skeleton.index(ours)]
        b = of_bvh.local_rotations[:, of_bvh.skeleton.index(theirs)]
        assert rotations.geodesic_angle(a, b).max() < 1e-5, ours


@pytest.mark.data
@pytest.mark.parametrize("trial", ["cmu_amc/01_01", "cmu86/86_01"])
def test_amc_agrees_with_chained_rotations(data, trial):
    path = data / f"{trial}.amc"
    motion = io.read(path)
    frames = [0, 17, 1000, 2750]
    positions = forward_kinematics(motion).positions[frames]
    twin = amc_oracle.joint_positions(path.with_name(f"{path.name[:2]}.asf"), path, frames)
    assert set(twin) == set(motion.skeleton.names)
    for name, places in twin.items():
        np.testing.assert_allclose(
            positions[:, motion.skeleton.index(name)], places * UNIT, rtol=0, atol=1e-6
        )


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "unit"), [("cmu_bvh/01_01", UNIT), ("cmu_bvh/10_01", 0.01), ("perfume_dance/A_test", 0.01)]
)
def test_bvh_agrees_with_chained_rotations(data, name, unit):
    path = data / f"{name}.bvh"
    motion = io.read(path)
    frames = [0, 17, 500]
    positions = forward_kinematics(motion).positions[frames]
    for joint, places in bvh_oracle.joint_positions(path, frames).items():
        np.testing.assert_allclose(
            positions[:, motion.skeleton.index(joint)], places * unit, rtol=0, atol=1e-6
        )
