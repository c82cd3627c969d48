"""From how a person moves, said in anatomical terms, to a motion of the skeleton.

Conventions
-----------
Lengths are body heights, so that a tall and a short person move alike. Side axis: 0 left, 1 right; on both sides *x*
points outward, so that a symmetric posture has equal rows. Angles are radians: pitch leans forward, positive yaw turns
to the person's left, positive roll raises the left side, a foot's pitch lifts the heel.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from leitmotion.datasets import skeleton as body
from leitmotion.motion import Motion, Skeleton, rotations
from leitmotion.motion.rotations import conjugate, from_axis_angle, from_euler, multiply, rotate

STAND = body.HIPS_HEIGHT - 0.002  # the knees of a standing person are not locked
LEG = body.THIGH + body.SHANK
REACH = 0.9985 * LEG  # a knee is never quite straight
FLEXION, ABDUCTION, OUTWARD, ELBOW, SHRUG = range(5)  # columns of `arms`
SIDES = np.array([1.0, -1.0])


@dataclasses.dataclass
class Posture:
    """What a person does in each of T frames; as made, standing at ease at the origin, facing +Z."""

    hips: np.ndarray  # (T, 3) place of the pelvis
    pelvis: np.ndarray  # (T, 3) yaw, pitch, roll in the world
    trunk: np.ndarray  # (T, 3) yaw, pitch, roll of the chest relative to the pelvis
    head: np.ndarray  # (T, 3) yaw, pitch, roll relative to the chest
    arms: np.ndarray  # (T, 2, 5) flexion, abduction, outward rotation, elbow flexion, raised clavicle
    feet: np.ndarray  # (T, 2, 3) place of the ankle while the foot is flat
    foot_yaw: np.ndarray  # (T, 2) toes outward
    foot_pitch: np.ndarray  # (T, 2) heel up
    pivot: np.ndarray  # (T, 2) what the pitch turns about: 0 the ball of the foot, 1 the heel
    free: np.ndarray  # (T, 2) 1 where the foot hangs on the shank rather than keeping to the floor
    knees: np.ndarray  # (T, 2) knees outward of the toes

    @classmethod
    def standing(cls, frames: int) -> Posture:
        """Stand at ease, arms hanging, feet below the hips, toes a little out."""
        arms = np.zeros((frames, 2, 5))
        arms[..., FLEXION], arms[..., ABDUCTION], arms[..., ELBOW] = 0.04, 0.13, 0.20
        none = np.zeros((frames, 2))
        return cls(
            hips=np.tile([0.0, STAND, 0.0], (frames, 1)),
            pelvis=np.zeros((frames, 3)),
            trunk=np.zeros((frames, 3)),
            head=np.zeros((frames, 3)),
            arms=arms,
            feet=np.tile([body.HALF_HIPS, body.ANKLE, -0.01], (frames, 2, 1)),
            foot_yaw=none + 0.14,
            foot_pitch=none.copy(),
            pivot=none.copy(),
            free=none.copy(),
            knees=none.copy(),
        )

    def mirror(self) -> Posture:
        """Do the same with left and right exchanged."""
        swapped = {
            name: getattr(self, name)[:, ::-1]
            for name in ("arms", "feet", "foot_yaw", "foot_pitch", "pivot", "free", "knees")
        }
        turned = {name: getattr(self, name) * [-1.0, 1.0, -1.0] for name in ("pelvis", "trunk", "head")}
        return Posture(hips=self.hips * [-1.0, 1.0, 1.0], **turned, **swapped)

    def place(self, x: float, z: float, yaw: float) -> None:
        """Move to another stance on the floor, facing `yaw`."""
        turn, there = from_axis_angle("y", yaw), np.array([x, 0.0, z])
        self.hips = rotate(turn, self.hips) + there
        outward = SIDES[:, None] * [1.0, 0.0, 0.0] + [0.0, 1.0, 1.0]
        self.feet = (rotate(turn, self.feet * outward) + there) * outward
        self.pelvis[:, 0] += yaw
        self.foot_yaw += SIDES * yaw


def pose(skeleton: Skeleton, posture: Posture, *, height: float) -> tuple[np.ndarray, np.ndarray]:
    """Turn the joints so that the body takes the posture, the feet where they belong.

    Returns
    -------
    hips : (T, 3) float
        Place of the root, metres.
    local_rotations : (T, J, 4) float
        Of every joint.
    """
    q = np.tile(rotations.IDENTITY, (len(posture.hips), len(skeleton), 1))

    def turn(joint: str, rotation: np.ndarray) -> None:
        q[:, skeleton.index(joint)] = rotation

    pelvis = from_euler("yxz", posture.pelvis)
    turn("Hips", pelvis)
    turn("Spine", from_euler("yxz", 0.45 * posture.trunk))
    turn("Chest", from_euler("yxz", 0.55 * posture.trunk))
    turn("Neck", from_euler("yxz", 0.45 * posture.head))
    turn("Head", from_euler("yxz", 0.55 * posture.head))
    for side, name in enumerate(("Left", "Right")):
        clavicle, arm, forearm = _arm(posture.arms[:, side])
        for joint, rotation in (("Shoulder", clavicle), ("Arm", arm), ("ForeArm", forearm)):
            turn(name + joint, rotation if side == 0 else _reflect(rotation))
    ankles, soles = _feet(posture)
    hips = posture.hips.copy()
    hips[:, 1] = _reachable_height(hips, pelvis, ankles)
    for side, name in enumerate(("Left", "Right")):
        yaw = SIDES[side] * (posture.foot_yaw[:, side] + posture.knees[:, side])
        thigh, knee, shank = _leg(hips + rotate(pelvis, _hip(side)), ankles[:, side], yaw)
        hanging = multiply(shank, from_axis_angle("x", np.full(len(hips), 0.25)))
        sole = rotations.slerp(soles[:, side], hanging, posture.free[:, side])
        toes = -np.maximum(posture.foot_pitch[:, side], 0.0) * (1.0 - posture.pivot[:, side])
        turn(name + "UpLeg", multiply(conjugate(pelvis), thigh))
        turn(name + "Leg", knee)
        turn(name + "Foot", multiply(conjugate(shank), sole))
        turn(name + "ToeBase", from_axis_angle("x", toes))
    return height * hips, q


def as_motion(
    skeleton: Skeleton, hips: np.ndarray, local_rotations: np.ndarray, *, rate: float, name: str
) -> Motion:
    """Make a motion of a root path and joint rotations."""
    local_positions = np.tile(skeleton.offsets, (len(hips), 1, 1))
    local_positions[:, 0] = hips
    unit = rotations.continuous(rotations.normalize(local_rotations))
    return Motion(skeleton, local_positions, unit, rate=rate, name=name)


def _arm(angles: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Rotations of the left clavicle, upper arm and forearm, whose rest is straight out to the side."""
    flexion, abduction, outward, elbow, shrug = angles.T
    clavicle = from_axis_angle("z", shrug)
    upper = from_euler("xzx", np.stack((-flexion, abduction - 0.5 * np.pi, -outward), axis=-1))
    return clavicle, multiply(conjugate(clavicle), upper), from_axis_angle("y", -elbow)


def _reflect(q: np.ndarray) -> np.ndarray:
    """Rotation of the mirror image, left and right exchanged."""
    return q * [1.0, 1.0, -1.0, -1.0]


def _feet(posture: Posture) -> tuple[np.ndarray, np.ndarray]:
    """Ankles (T, 2, 3) and global rotations (T, 2, 4) of feet that roll about the ball or the heel."""
    heading = from_axis_angle("y", SIDES * posture.foot_yaw)
    sole = multiply(heading, from_axis_angle("x", posture.foot_pitch))
    ball = np.array([0.0, body.BALL_HEIGHT - body.ANKLE, body.BALL])
    heel = np.array([0.0, -body.ANKLE, -body.HEEL])
    flat = posture.feet * (SIDES[:, None] * [1.0, 0.0, 0.0] + [0.0, 1.0, 1.0])
    by_ball, by_heel = (rotate(heading, pivot) - rotate(sole, pivot) for pivot in (ball, heel))
    return flat + by_ball + posture.pivot[..., None] * (by_heel - by_ball), sole


def _hip(side: int) -> np.ndarray:
    return np.array([SIDES[side] * body.HALF_HIPS, body.HIP - body.HIPS_HEIGHT, 0.0])


def _reachable_height(hips: np.ndarray, pelvis: np.ndarray, ankles: np.ndarray) -> np.ndarray:
    """Lower the pelvis, smoothly, to where both legs reach their feet."""
    limits = []
    for side in range(2):
        joint = rotate(pelvis, _hip(side))
        across = (hips + joint - ankles[:, side])[:, [0, 2]]
        spare = REACH**2 - (across**2).sum(axis=-1)
        limits.append(ankles[:, side, 1] - joint[:, 1] + np.sqrt(np.maximum(spare, 0.0)))
    left, right = limits
    return _soft_minimum(hips[:, 1], _soft_minimum(left, right, 0.003), 0.003)


def _leg(hip: np.ndarray, ankle: np.ndarray, yaw: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Solve the triangle of hip, knee and ankle with the knee pointing to `yaw`: thigh, knee, shank rotations."""
    line = ankle - hip
    distance = np.linalg.norm(line, axis=-1)
    up = -line / distance[:, None]
    forward = np.stack((np.sin(yaw), np.zeros_like(yaw), np.cos(yaw)), axis=-1)
    hinge = np.cross(up, forward)
    hinge /= np.linalg.norm(hinge, axis=-1, keepdims=True)
    frame = rotations.from_matrix(np.stack((hinge, up, np.cross(hinge, up)), axis=-1))
    distance = _soft_minimum(distance, np.full_like(distance, 0.9995 * LEG), 0.0005)
    a, b = body.THIGH, body.SHANK
    lift = np.arccos((a**2 + distance**2 - b**2) / (2.0 * a * distance))
    flexion = np.pi - np.arccos((a**2 + b**2 - distance**2) / (2.0 * a * b))
    thigh, knee = multiply(frame, from_axis_angle("x", -lift)), from_axis_angle("x", flexion)
    return thigh, knee, multiply(thigh, knee)


def _soft_minimum(a: np.ndarray, b: np.ndarray, width: float) -> np.ndarray:
    """Lesser of the two, never more than either, rounded where they cross."""
    return 0.5 * (a + b - np.sqrt((a - b) ** 2 + width**2))
