"""Balance: a suit that sits askew is told from a movement of one side."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.datasets import compose_motif
from leitmotion.features import kinematic_chain, mirrored, without_bias
from leitmotion.motion.rotations import from_axis_angle, geodesic_angle, multiply
from leitmotion.similarity import along_the_way, balanced_bias


def chain_of(name: str, seed: int | None = None):
    return kinematic_chain(
        compose_motif(name, **({"variation": None} if seed is None else {"seed": seed})).motion
    )


def turned(chain, link: str, degrees: float):
    """The chain of a suit that turns a link by a constant."""
    values = chain.values.reshape(len(chain), -1, 4).copy()
    place = chain.names.index(link)
    values[:, place] = multiply(values[:, place], from_axis_angle("z", np.radians(degrees)))
    return chain.replace(values=values.reshape(len(chain), -1))


def aside(chain, link: str) -> float:
    """Degrees from the usual link to the mirror image of its partner."""
    own, image = (each.values.reshape(len(chain), -1, 4) for each in (chain, mirrored(chain)))
    place = chain.names.index(link)
    return float(np.degrees(np.median(geodesic_angle(own[:, place], image[:, place]))))


@pytest.mark.parametrize("link", ["left_humerus", "left_femur", "thorax"])
@pytest.mark.parametrize("name", ["butterfly", "jumping jacks"])
def test_a_crooked_suit_is_told_and_straightened(name, link):
    crooked = turned(chain_of(name), link, 8.0)
    bias = balanced_bias(crooked)
    assert bias is not None
    assert aside(crooked, link) > 7.0
    assert aside(without_bias(crooked, bias), link) < 1.0


@pytest.mark.parametrize("seed", range(3))
def test_a_limp_is_no_bias(seed):
    assert balanced_bias(chain_of("limping", seed)) is None


@pytest.mark.parametrize("degrees", [15.0, 30.0, 90.0])
def test_an_arm_that_moves_alone_is_no_bias(degrees):
    """However little it moves, and however long it is held there."""
    session = compose_motif("butterfly", variation=None).motion
    local = np.repeat(session.local_rotations[:1], 200, axis=0)
    lift = np.concatenate((np.linspace(0, 1, 50), np.ones(100), np.linspace(1, 0, 50))) * np.radians(degrees)
    arm = session.skeleton.index("LeftArm")
    local[:, arm] = multiply(local[:, arm], from_axis_angle("z", lift))
    positions = np.repeat(session.local_positions[:1], 200, axis=0)
    alone = session.replace(local_rotations=local, local_positions=positions)
    assert balanced_bias(kinematic_chain(alone)) is None


def test_a_posture_that_is_held_takes_one_step():
    chain = chain_of("butterfly")
    held = chain.replace(values=np.concatenate((chain.values, np.repeat(chain.values[-1:], 300, axis=0))))
    assert (along_the_way(held) >= len(chain)).mean() < 0.01


def test_the_answer_tells_what_was_taken_out():
    motion = compose_motif("limping", seed=0).motion
    assert lm.compare_with_mirror(motion, bias="auto").bias is None
    assert lm.find_symmetry(motion, bias="auto").parameters["bias"] == "none"  # what was taken out
