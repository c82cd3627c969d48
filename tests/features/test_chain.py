"""The kinematic chain: its mirror image is the mirror image, whatever tells it and whatever does not matter."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.body import BEARER, CHAIN_LINKS, embody, mirror_role
from leitmotion.body.rest import LIMBS, rest_axes
from leitmotion.features import kinematic_chain, mirrored, side_bias, symmetry_parts, without_bias
from leitmotion.motion import DataError, Motion, ParameterError, Trajectories
from leitmotion.motion.rotations import (
    conjugate,
    from_axis_angle,
    geodesic_angle,
    multiply,
    rotate,
    yaw_rotation,
)
from oracles import body as oracle

TOLD_BY = ("rotations", "places")


def links_of(chain):
    return chain.values.reshape(len(chain), -1, 4)


def apart(a, b):
    """Degrees between the links of two chains, (T, L)."""
    assert a.names == b.names
    return np.degrees(geodesic_angle(links_of(a), links_of(b)))


def jacks() -> Motion:
    """A person whose sides do the same, arms and legs, with elbows and knees bent by turns."""
    body = oracle.skeleton()
    time = np.arange(40) / 20
    local = np.tile([1.0, 0.0, 0.0, 0.0], (len(time), len(body), 1))
    swing = 0.5 * np.sin(2 * np.pi * time)
    for side, sign in (("Left", 1.0), ("Right", -1.0)):
        local[:, body.index(f"{side}Arm")] = from_axis_angle("z", sign * swing)
        local[:, body.index(f"{side}ForeArm")] = from_axis_angle("y", -sign * swing**2)
        local[:, body.index(f"{side}UpLeg")] = from_axis_angle("x", -np.abs(swing))
        local[:, body.index(f"{side}Leg")] = from_axis_angle("x", np.abs(swing))
    return Motion(body, np.tile(body.offsets, (len(time), 1, 1)), local, rate=20.0)


@pytest.mark.parametrize("told_by", TOLD_BY)
def test_the_chain_of_the_mirrored_motion_is_the_mirrored_chain(rng, told_by):
    motion = oracle.human(rng)
    image = mirrored(kinematic_chain(motion, told_by=told_by))
    assert apart(kinematic_chain(oracle.mirrored(motion), told_by=told_by), image).max() < 1e-4
    assert apart(image, kinematic_chain(motion, told_by=told_by)).max() > 10


def test_mirrored_twice_is_the_same_to_the_bit(rng):
    chain = kinematic_chain(oracle.human(rng))
    assert chain.names == CHAIN_LINKS
    assert mirrored(mirrored(chain)) == chain


@pytest.mark.parametrize("told_by", TOLD_BY)
def test_the_links_lead_to_the_bones(rng, told_by):
    """Composed from the pelvis on, the links point the bones where they point, seen without the yaw of the pelvis."""
    motion = oracle.human(rng, bend=0.7)
    chain = kinematic_chain(motion, told_by=told_by)
    body = embody(motion)
    at = {role: body.positions[:, k] for k, role in enumerate(body.roles)}
    own = dict(zip(chain.names, np.moveaxis(links_of(chain), 1, 0), strict=True))

    def in_all(link):
        return own[link] if link == "pelvis" else multiply(in_all(BEARER[link]), own[link])

    bones = {}
    for side in ("left", "right"):
        for bone, (upper, middle, lower) in LIMBS.items():
            along, _ = rest_axes(bone, side)
            hinge = {"femur": "tibia", "humerus": "radius"}[bone]
            for link, (start, stop) in {bone: (upper, middle), hinge: (middle, lower)}.items():
                vector = at[f"{side}_{stop}"] - at[f"{side}_{start}"]
                told = rotate(in_all(f"{side}_{link}"), along)
                bones[f"{side}_{link}"] = (vector / np.linalg.norm(vector, axis=1, keepdims=True), told)
    seen, told = (np.stack([pair[k] for pair in bones.values()], axis=1) for k in (0, 1))
    turn = np.arctan2(  # one yaw a frame brings all bones of a frame together
        (seen[..., 0] * told[..., 2] - seen[..., 2] * told[..., 0]).sum(axis=1),
        (seen[..., 0] * told[..., 0] + seen[..., 2] * told[..., 2]).sum(axis=1),
    )
    assert np.abs(rotate(yaw_rotation(-turn)[:, None], seen) - told).max() < 1e-6


@pytest.mark.parametrize("told_by", TOLD_BY)
def test_at_rest_nothing_is_turned(told_by):
    chain = kinematic_chain(oracle.stiff(yaw_rotation(np.array([0.0, 1.0, 3.0]))), told_by=told_by)
    turned = geodesic_angle(links_of(chain), np.array([1.0, 0.0, 0.0, 0.0]))
    limbs = [k for k, link in enumerate(chain.names) if link.partition("_")[2] in ("femur", "humerus")]
    assert np.degrees(turned[:, limbs]).max() < 2.5  # its legs stand apart
    assert np.ptp(links_of(chain), axis=0).max() < 1e-9


@pytest.mark.parametrize("told_by", TOLD_BY)
def test_a_symmetric_posture_is_its_own_image(told_by):
    chain = kinematic_chain(jacks(), told_by=told_by)
    assert apart(chain, mirrored(chain)).max() < 1e-4
    assert np.abs(symmetry_parts(chain).antisymmetric.values).max() < 1e-6
    assert np.ptp(chain.values, axis=0).max() > 0.2


def crooked(motion: Motion, joint: str, turn: np.ndarray) -> Motion:
    """The same places of joints, told by a joint whose own axes are turned by a constant."""
    at, body = motion.skeleton.index(joint), motion.skeleton
    offsets, positions, local = (
        each.copy() for each in (body.offsets, motion.local_positions, motion.local_rotations)
    )
    local[:, at] = multiply(local[:, at], turn)
    for child in np.flatnonzero(np.asarray(body.parents) == at):
        offsets[child] = rotate(conjugate(turn), offsets[child])
        positions[:, child] = rotate(conjugate(turn), positions[:, child])
        local[:, child] = multiply(conjugate(turn), local[:, child])
    return motion.replace(
        skeleton=body.replace(offsets=offsets), local_positions=positions, local_rotations=local
    )


@pytest.mark.parametrize("axis", ["y", "z"])
@pytest.mark.parametrize("joint", ["Hips", "Head", "RightUpLeg"])
def test_a_zero_pose_that_was_fitted_askew_prefers_no_side(joint, axis):
    motion = crooked(jacks(), joint, from_axis_angle(axis, np.radians(8.0)))
    chain = kinematic_chain(motion, told_by="rotations")
    assert apart(chain, mirrored(chain)).max() < 0.5


def test_what_is_movement_is_not_settled(rng):
    """Rotations that differ from places now to one side, now to the other stay what they are."""
    motion = jacks()
    local = motion.local_rotations.copy()
    time = np.arange(len(motion)) / motion.rate
    local[:, motion.skeleton.index("Head")] = from_axis_angle("y", 0.8 * np.sin(2 * np.pi * time))
    chain = kinematic_chain(motion.replace(local_rotations=local))
    thirds = links_of(chain)[:, [chain.names.index(link) for link in ("lower_neck", "upper_neck", "head")]]
    angle = geodesic_angle(thirds, np.array([1.0, 0.0, 0.0, 0.0])).sum(axis=1)
    assert np.abs(angle - geodesic_angle(local[:, motion.skeleton.index("Head")], [1, 0, 0, 0])).max() < 1e-6


@pytest.mark.parametrize("joint", ["Spine", "Spine1"])
def test_the_count_of_joints_changes_nothing(rng, joint):
    motion = oracle.human(rng)
    full, fewer = kinematic_chain(motion), kinematic_chain(oracle.without(motion, joint))
    assert apart(full, fewer).max() < 1e-4


@pytest.mark.parametrize(("told_by", "degrees"), [("rotations", 0.1), ("places", 1e-6)])
def test_the_rate_changes_nothing(rng, told_by, degrees):
    """But for what half of the moments tell of how the zero pose was fitted."""
    motion = oracle.human(rng)
    half = kinematic_chain(motion[::2], told_by=told_by)
    assert half.rate == motion.rate / 2
    assert apart(half, kinematic_chain(motion, told_by=told_by)[::2]).max() < degrees


def test_the_identities_hold_for_the_signed_product(rng):
    chain = kinematic_chain(oracle.human(rng, bend=0.8))
    symmetric, antisymmetric = (part.values for part in symmetry_parts(chain))
    own, image = chain.values, mirrored(chain).values
    both, against = symmetric @ symmetric.T, antisymmetric @ antisymmetric.T
    assert np.allclose(own @ own.T, both + against)
    assert np.allclose(own @ image.T, both - against)
    assert np.array_equal(mirrored(chain.replace(values=symmetric)).values, symmetric)
    assert np.array_equal(mirrored(chain.replace(values=antisymmetric)).values, -antisymmetric)


@pytest.mark.parametrize("pose", ["mean", "standing"])
@pytest.mark.parametrize("degrees", [5.0, 10.0])
def test_a_crooked_suit_is_straightened(pose, degrees, rng):
    session = lm.compose_session(seed=1, rate=30.0).motion
    straight = kinematic_chain(session)
    values = links_of(straight).copy()
    for link in ("left_humerus", "left_femur", "left_radius"):
        axis = rng.normal(size=3)
        half = np.radians(degrees) / 2
        turn = np.concatenate(([np.cos(half)], np.sin(half) * axis / np.linalg.norm(axis)))
        place = straight.names.index(link)
        values[:, place] = multiply(values[:, place], turn)
    crooked = straight.replace(values=values.reshape(len(values), -1))
    bias = side_bias(crooked, pose=pose)
    own = side_bias(straight, pose=pose)
    mended, expected = without_bias(crooked, bias), without_bias(straight, own)
    lopsided = [apart(each, mirrored(each)).mean(axis=1) for each in (mended, expected, crooked)]
    assert bias.too_large == ()
    assert np.degrees(bias.angles).max() > degrees / 2
    assert np.abs(lopsided[0] - lopsided[1]).max() < 0.2 * np.abs(lopsided[2] - lopsided[1]).max()
    assert side_bias(mended, pose="mean" if pose == "mean" else "standing").angles.max() < np.radians(1.0)


def test_what_is_posture_is_not_taken_out():
    raised = jacks()
    local = raised.local_rotations.copy()
    local[:, raised.skeleton.index("LeftArm")] = from_axis_angle("z", np.full(len(raised), 1.2))
    chain = kinematic_chain(raised.replace(local_rotations=local))
    bias = side_bias(chain)
    assert set(bias.too_large) == {"left_humerus", "right_humerus"}
    assert apart(without_bias(chain, bias), chain)[:, chain.names.index("left_humerus")].max() < 1e-6


def test_errors_help(rng):
    motion = oracle.human(rng)
    with pytest.raises(ParameterError, match="told_by must be one of auto, rotations, places, got 'both'"):
        kinematic_chain(motion, told_by="both")
    with pytest.raises(ParameterError, match="cannot be counted from a rest pose"):
        kinematic_chain(oracle.points_of(motion), told_by="rotations")
    with pytest.raises(ParameterError, match="The chain has no 'tail'"):
        kinematic_chain(motion, links=["tail"])
    legs = Trajectories(("LeftHip", "RightHip"), np.eye(3)[None, :2], rate=30, kind="joint")
    with pytest.raises(DataError, match="begins with the trunk, but no") as refused:
        kinematic_chain(legs)
    assert "leitmotion patterns" in refused.value.remedy
    chain = kinematic_chain(motion)
    with pytest.raises(ParameterError, match="pose must be one of mean, standing"):
        side_bias(chain, pose="sitting")
    with pytest.raises(DataError, match="Nobody stands still"):
        side_bias(chain, pose="standing")
    with pytest.raises(ParameterError, match="no mirror image"):
        symmetry_parts(kinematic_chain(motion, links=["left_femur"]))
    assert mirror_role("left_femur") == "right_femur"


def test_an_unseen_joint_hides_its_links_alone(rng):
    points = oracle.points_of(oracle.human(rng))
    positions = points.positions.copy()
    positions[3, points.names.index("LeftHand")] = np.nan
    chain = kinematic_chain(points.replace(positions=positions))
    hidden = np.isnan(links_of(chain)).any(axis=2)
    assert [chain.names[k] for k in np.flatnonzero(hidden[3])] == ["left_humerus", "left_radius"]
    assert hidden.sum() == 2


@pytest.mark.data
def test_a_pelvis_that_was_fitted_askew_stands_upright(data):
    """The hips of this file lie 8 degrees askew in every posture, though its trunk is upright."""
    motion = lm.read(data / "hdm05/squat1Reps/HDM_bd_squat1Reps_001_120.amc")
    chain = kinematic_chain(motion, told_by="rotations")
    told = np.median(apart(chain, mirrored(chain)), axis=0)
    assert told[chain.names.index("pelvis")] < 12
    assert told[chain.names.index("lower_neck")] < 5


@pytest.mark.data
@pytest.mark.parametrize("name", ["cmu_bvh/jumping_jacks.bvh", "cmu86/86_01.amc", "mocap6/13_29.amc"])
def test_rotations_and_places_agree(data, name):
    """But for a constant turn of each link, which is where the two count from, they tell the same."""
    motion = lm.read(data / name)
    told, seen = (links_of(kinematic_chain(motion, told_by=by)) for by in TOLD_BY)
    turn = multiply(conjugate(told), seen)
    usual = np.linalg.eigh(np.einsum("tji,tjk->jik", turn, turn))[1][..., -1]
    rest = np.degrees(geodesic_angle(multiply(told, usual), seen))
    assert rest.mean() < 8.0
