"""What is wrong with a recording: each fault that is put in is told with what mends it, and nothing else."""

import shlex

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.datasets import Action, compose
from leitmotion.motion import Motion, joint_points
from leitmotion.repairs import Problem, repair
from oracles.body import human, points_of


@pytest.fixture(scope="module")
def walk() -> Motion:
    return compose([Action("still"), Action("walk", 6, turn=3.0), Action("still")], seed=3, rate=30.0).motion


def problems(recording, **said) -> dict[str, Problem]:
    return {problem.what: problem for problem in lm.info(recording, **said).problems}


def changed(recording, change):
    positions = recording.positions.copy()
    change(positions, recording.names.index)
    return recording.replace(positions=positions)


def test_a_clean_recording_has_none(walk):
    assert problems(walk) == {}
    assert problems(joint_points(walk)) == {}
    assert problems(joint_points(walk).replace(kind="marker")) == {}


def gap(at, of):
    at[100:120, of("LeftHand")] = np.nan


def spike(at, of):
    at[100, of("LeftHand")] += 0.4


def frozen(at, of):
    at[100:130, of("LeftHand")] = at[99, of("LeftHand")]


def sides(at, of):
    pair = [of("LeftFoot"), of("RightFoot")]
    at[100:130, pair] = at[100:130, pair[::-1]]


def others(at, of):
    pair = [of("LeftFoot"), of("Head")]
    at[100:130, pair] = at[100:130, pair[::-1]]


def hold(at, of):
    at[100:104] = at[99]


def raised(at, of):
    at[..., 1] += 1.0


def stretched(at, of):
    length = np.linspace(1.0, 1.4, len(at))[:, None]
    knee = at[:, of("LeftLeg")]
    at[:, of("LeftFoot")] = knee + (at[:, of("LeftFoot")] - knee) * length


@pytest.mark.parametrize(
    ("fault", "what", "options"),
    [
        (gap, "gaps", ("--fill",)),
        (spike, "spikes", ("--spikes",)),
        (frozen, "frozen", ("--frozen", "--fill")),
        (sides, "swapped", ("--swaps",)),
        (others, "swapped", ("--swaps",)),
        (hold, "duplicates", ("--duplicates",)),
        (raised, "floor", ("--level",)),
        (stretched, "drift", ()),
    ],
    ids=lambda value: getattr(value, "__name__", None),
)
def test_each_fault_is_told_with_what_mends_it(walk, fault, what, options):
    found = problems(changed(joint_points(walk), fault))
    told = found.pop(what)
    assert set(found) <= {"jumps", "gaps", "spikes"}  # what a point does that changes places, or freezes
    assert [word for word in told.options if word.startswith("--")] == list(options)
    assert (told.verb == "repair") == bool(options)


@pytest.mark.parametrize(
    ("fault", "remedies"),
    [
        (gap, {"fill": "spline", "max_gap_s": 1.0}),
        (spike, {"spikes": True}),
        (frozen, {"frozen": True, "fill": "spline", "max_gap_s": 2.0}),
        (sides, {"swaps": True}),
        (hold, {"duplicates": True}),
        (raised, {"level": True}),
    ],
    ids=lambda value: getattr(value, "__name__", None),
)
def test_what_is_suggested_mends_it(walk, fault, remedies):
    hurt = changed(joint_points(walk), fault)
    assert problems(repair(hurt, **remedies).recording) == {}


def test_left_and_right_are_told_apart_from_other_exchanges(walk):
    points = joint_points(walk)
    assert "left and right" in problems(changed(points, sides))["swapped"].message
    assert "left and right" not in problems(changed(points, others))["swapped"].message


def test_a_skeleton_has_spikes_and_holds_too(walk):
    turns = walk.local_rotations.copy()
    joint = walk.skeleton.index("LeftArm")
    turns[100, joint] = [0.0, 1.0, 0.0, 0.0]
    assert problems(walk.replace(local_rotations=turns))["spikes"].options == ("--spikes",)


def test_a_wrong_unit_is_answered_with_the_right_one(walk, tmp_path):
    path = lm.write(walk, tmp_path / "walk.bvh")
    found = problems(path, unit="m")
    assert found["size"].command(str(path)) == f"leitmotion info {path} --unit cm"
    assert "--unit cm comes nearest to an adult, with 1." in found["size"].message + found["size"].remedy


def test_a_wrong_vertical_is_answered_with_the_right_one(walk, tmp_path):
    path = lm.write(walk, tmp_path / "walk.bvh")
    assert problems(path, up="z")["up"].options == ("--up", "y")
    lying = joint_points(walk)
    assert problems(lying.replace(positions=lying.positions[..., [1, 0, 2]]))["up"].options == ("--up", "x")


def test_a_rest_pose_in_front_is_left_out_by_a_window():
    motion = human(np.random.default_rng(1), frames=120)
    places = motion.local_positions.copy()
    places[0, 0] += 5.0
    told = problems(motion.replace(local_positions=places))["jumps"]
    assert told.command("a b.bvh") == "leitmotion info 'a b.bvh[1:]'"


def test_commands_are_words_of_a_shell():
    problem = Problem("gaps", "", "", "repair", ("--fill", "rigid"))
    for name in ("walk.c3d", "my walk.c3d", "it's.c3d", "a[1:2].c3d", "$HOME.c3d"):
        assert shlex.split(problem.command(name, "out.npz")) == [
            "leitmotion", "repair", name, "--fill", "rigid", "-o", "out.npz",
        ]  # fmt: skip
    assert Problem("short", "").command("walk.c3d") == ""


def test_swapped_sides_turn_the_body_round(walk):
    there, here = lm.info(walk, swap_sides=True), lm.info(walk)
    assert there.roles == lm.body.swap_sides(here.roles)
    turned = there.findings["facing"].value - here.findings["facing"].value
    assert np.cos(turned) == pytest.approx(-1.0, abs=0.05)
    assert there.names == here.names


def test_points_without_roles_are_looked_at_too(rng):
    points = points_of(human(rng, frames=120))
    bare = points.replace(names=tuple(f"m{k}" for k in range(len(points.names))))
    assert set(problems(bare)) <= {"roles", "unsure"}  # some are told by where they are on the body
    assert "spikes" in problems(changed(bare, lambda at, of: np.add.at(at, (50, 7), 0.4)))
