"""Shape: roles without a name, from the tree, from points, beside names that say half."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion.body import ANALYSIS_ROLES, embody, find_roles, mirror_role
from leitmotion.motion import Motion, Skeleton, Trajectories, forward_kinematics
from oracles.body import human, mirrored, moved, points_of, renamed, scaled, stiff, without

io = pytest.importorskip("leitmotion.io")


def told_by(found):
    return dict(zip(found.roles, found.members))


def sure_of(found):
    return dict(zip(found.roles, found.confidence.tolist()))


def unnamed(motion, rng):
    """The same motion with its joints in another order, and what each is called now."""
    body = motion.skeleton
    order = []
    while len(order) < len(body):
        order.append(
            int(
                rng.choice(
                    [j for j, p in enumerate(body.parents) if j not in order and (p < 0 or p in order)]
                )
            )
        )
    names = [f"n{k}" for k in rng.permutation(len(order))]
    place = {old: new for new, old in enumerate(order)}
    other = Skeleton(
        tuple(names),
        [place[int(body.parents[j])] if body.parents[j] >= 0 else -1 for j in order],
        body.offsets[order],
        [place[int(j)] for j in body.end_parents],
        body.end_offsets,
    )
    changed = motion.replace(
        skeleton=other,
        local_positions=motion.local_positions[:, order],
        local_rotations=motion.local_rotations[:, order],
    )
    return changed, {body.names[old]: names[new] for old, new in place.items()}


def renamed_map(found, names):
    return {role: tuple(names[name] for name in members) for role, members in told_by(found).items()}


@pytest.fixture
def person(rng):
    return human(rng)


def test_a_tree_without_names_has_the_roles_that_its_names_said(person, rng):
    changed, names = unnamed(person, rng)
    found = find_roles(changed)
    assert told_by(found) == renamed_map(find_roles(person), names)
    assert set(sure_of(found).values()) == {0.8}


def test_points_without_names_have_them_as_well(person, rng):
    changed, names = unnamed(person, rng)
    found = find_roles(points_of(changed))
    assert told_by(found) == renamed_map(find_roles(person), names)
    clear = ("pelvis", "shoulder", "elbow", "wrist", "hip", "knee", "ankle", "toe")
    for role, sure in sure_of(found).items():
        assert sure == (0.8 if role.rpartition("_")[2] in clear else 0.5), role


def test_place_turn_and_size_change_nothing(person, rng):
    changed, _ = unnamed(person, rng)
    found = find_roles(changed)
    for other in (moved(changed, yaw=2.0, by=(3, 0, -1)), scaled(changed, 0.6), scaled(changed, 100.0)):
        assert find_roles(other) == found


def test_in_a_mirror_left_is_right(person, rng):
    """The mirror image of a person is a person; what was the left knee is the right one."""
    changed, names = unnamed(person, rng)
    places = forward_kinematics(changed).positions * [-1.0, 1.0, 1.0]
    found = told_by(find_roles(Trajectories(changed.skeleton.names, places, person.rate, kind="joint")))
    wanted = renamed_map(find_roles(person), names)
    assert found == {mirror_role(role): members for role, members in wanted.items()}
    assert told_by(find_roles(unnamed(mirrored(person), np.random.default_rng(1))[0]))


def test_names_that_are_elsewhere_are_put_aside_and_doubted(person, rng):
    names = list(person.skeleton.names)
    permuted = {name: names[k] for name, k in zip(names, rng.permutation(len(names)))}
    found = find_roles(renamed(person, permuted))
    assert told_by(found) == renamed_map(find_roles(person), permuted)
    assert max(sure_of(found).values()) == 0.5


def test_without_feet_and_without_a_walk_no_side_is_sure(person, rng):
    stays = person.local_positions.copy()
    stays[:, 0] = stays[:1, 0]
    still = person.replace(local_positions=stays)
    for toe in ("LeftToeBase", "RightToeBase"):
        still = without(still, toe)
    changed, _ = unnamed(still, rng)
    sure = sure_of(find_roles(changed))
    assert max(sure_of(find_roles(changed))[role] for role in sure if role != mirror_role(role)) <= 0.5
    assert sure["pelvis"] == 0.8, "what has no side is as sure as ever"


def test_nothing_is_told_of_a_body_that_never_moved_but_its_tree(rng):
    still, _ = unnamed(stiff(np.tile([1.0, 0, 0, 0], (30, 1))), rng)
    told = told_by(find_roles(still))
    assert set(ANALYSIS_ROLES) <= set(told), "a tree tells without motion"
    assert sure_of(find_roles(still))["left_knee"] == 0.8, "and its feet point ahead"


@pytest.mark.parametrize(
    "named", [{"Hips", "Head"}, {"LeftLeg", "RightArm"}, {"LeftUpLeg", "LeftLeg", "LeftFoot"}]
)
def test_names_speak_and_the_shape_says_the_rest(person, rng, named):
    kept = {name: name if name in named else f"n{k}" for k, name in enumerate(person.skeleton.names)}
    found, whole = find_roles(renamed(person, kept)), find_roles(person)
    assert told_by(found) == renamed_map(whole, kept)
    for role, (member,) in told_by(found).items():
        assert sure_of(found)[role] == (1.0 if member in named else 0.8), role


def test_a_side_that_is_named_is_never_turned(person, rng):
    """One knee is named left and is the right one: all goes by the name, and is doubted."""
    kept = {name: f"n{k}" for k, name in enumerate(person.skeleton.names)} | {"RightLeg": "LeftLeg"}
    found = find_roles(renamed(person, kept))
    told, sure = told_by(found), sure_of(found)
    assert told["left_knee"] == ("LeftLeg",)
    assert told["left_ankle"] == (kept["RightFoot"],)
    assert max(sure[role] for role in sure if role != mirror_role(role)) <= 0.5


def test_a_word_that_means_two_joints_goes_to_the_right_one(person):
    """Without a LeftArm beside it a LeftShoulder would be the joint; the tree says that it is the clavicle."""
    kept = {"LeftArm": "n1", "RightArm": "n2"}
    told = told_by(find_roles(renamed(person, kept)))
    assert told["left_clavicle"] == ("LeftShoulder",)
    assert told["left_shoulder"] == ("n1",)


def with_helpers(motion):
    """The motion under a node on the ground, with twist joints, a target and a stick in the right hand."""
    body = motion.skeleton
    frames = len(motion)
    names, parents = ["scene"], [-1]
    local = [np.zeros((frames, 3))]
    rotations = [np.tile([1.0, 0, 0, 0], (frames, 1))]
    place = {}
    for joint, name in enumerate(body.names):
        up = int(body.parents[joint])
        above, way = place.get(up, 0), motion.local_positions[:, joint]
        if name in ("LeftLeg", "RightLeg", "LeftHand", "RightHand"):
            names.append(f"{name}Middle")
            parents.append(above)
            local.append(way / 2)
            rotations.append(rotations[0])
            above, way = len(names) - 1, way / 2
        place[joint] = len(names)
        names.append(name)
        parents.append(above)
        local.append(way)
        rotations.append(motion.local_rotations[:, joint])
    for name, up, way in (
        ("target", 0, forward_kinematics(motion).positions[:, body.index("LeftHand")]),
        ("stick", names.index("RightHand"), np.tile([0.0, -0.9, 0.2], (frames, 1))),
    ):
        names.append(name)
        parents.append(up)
        local.append(way)
        rotations.append(rotations[0])
    moved_joints = np.stack(local, axis=1)
    return Motion(
        Skeleton(tuple(names), parents, moved_joints[0]),
        moved_joints,
        np.stack(rotations, axis=1),
        motion.rate,
    )


def test_helpers_do_not_mislead(person, rng):
    changed, names = unnamed(with_helpers(person), rng)
    told = told_by(find_roles(changed))
    wanted = renamed_map(find_roles(person), names)
    assert {role: told[role] for role in ANALYSIS_ROLES} == {role: wanted[role] for role in ANALYSIS_ROLES}


def test_points_that_are_seldom_seen_or_few_tell_nothing(person, rng):
    table = points_of(unnamed(person, rng)[0])
    gone = table.positions.copy()
    gone[5:] = np.nan
    assert (
        find_roles(table.replace(positions=np.where(np.arange(60)[:, None, None] % 3, np.nan, gone))).roles
        == ()
    )
    few = table.replace(names=table.names[:6], positions=table.positions[:, :6])
    assert find_roles(few).roles == ()


def test_pictures_tell_nothing_without_names(person, rng):
    table = points_of(unnamed(person, rng)[0])
    assert find_roles(table.replace(positions=table.positions[..., :2], unit="px")).roles == ()


def test_a_chain_and_a_star_are_no_bodies():
    for parents in (np.arange(-1, 19), np.array([-1] + [0] * 19)):
        offsets = np.random.default_rng(0).normal(size=(20, 3))
        body = Skeleton(tuple(f"n{k}" for k in range(20)), parents, offsets)
        local = np.broadcast_to(offsets, (10, 20, 3))
        still = np.tile([1.0, 0, 0, 0], (10, 20, 1))
        assert find_roles(Motion(body, local, still, rate=30)).roles == ()


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(2, 40))
def test_any_tree_is_looked_at(seed, joints):
    rng = np.random.default_rng(seed)
    parents = [-1, *(int(rng.integers(0, j)) for j in range(1, joints))]
    offsets = rng.normal(size=(joints, 3)) * rng.choice([0.0, 1.0], size=(joints, 1), p=[0.2, 0.8])
    quaternions = rng.normal(size=(5, joints, 4))
    quaternions /= np.linalg.norm(quaternions, axis=-1, keepdims=True)
    body = Skeleton(tuple(f"n{k}" for k in range(joints)), parents, offsets)
    found = find_roles(Motion(body, np.tile(offsets, (5, 1, 1)), quaternions, rate=30))
    assert ((found.confidence > 0) & (found.confidence <= 0.8)).all()
    points = [name for members in found.members for name in members]
    assert set(points) <= set(body.names)


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 30), st.integers(1, 12))
def test_any_cloud_is_looked_at(seed, points, frames):
    rng = np.random.default_rng(seed)
    places = rng.normal(size=(frames, points, 3))
    places[rng.random(places.shape[:2]) < 0.2] = np.nan
    find_roles(Trajectories(tuple(f"n{k}" for k in range(points)), places, 30, kind="joint"))


@pytest.mark.data
@pytest.mark.parametrize(
    "file",
    [
        "cmu86/86_01.amc",
        "cmu_bvh/10_01.bvh",
        "bandai_namco/dataset-1_walk_normal_001.bvh",
        "animated_drawings/jesse_dance.bvh",
        "perfume_dance/B_test.bvh",
        "pymo/AV_8Walk_Meredith_HVHA_Rep1.bvh",
    ],
)
def test_real_skeletons_need_no_names(data, file, rng):
    motion = io.read(data / file)
    changed, names = unnamed(motion, rng)
    found, wanted = told_by(find_roles(changed)), renamed_map(find_roles(motion), names)
    assert {role: found[role] for role in ANALYSIS_ROLES} == {role: wanted[role] for role in ANALYSIS_ROLES}
    faces, faced = embody(changed).facing, embody(motion).facing
    np.testing.assert_allclose(np.angle(np.exp(1j * (faces - faced))), 0.0, atol=1e-9)


@pytest.mark.data
@pytest.mark.parametrize(
    "file", ["btk/golfswing.c3d", "btk/T.trc", "pycgm/Movement_trial.c3d", "bmclab/walk.trc"]
)
def test_clouds_of_markers_without_names_stay_unknown(data, file):
    markers = io.read(data / file)
    assert find_roles(markers.replace(names=tuple(f"n{k}" for k in range(len(markers.names))))).roles == ()
