"""Which side makes the movement: laws of the mirror, of place and of the links."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.body import embody, find_roles
from leitmotion.features import kinematic_chain, mirrored, side_ways
from oracles import body as oracle
from oracles import motifs as made


def test_the_mirror_exchanges_left_and_right(rng):
    chain = kinematic_chain(oracle.human(rng, bend=0.8))
    own, image = side_ways(chain), side_ways(mirrored(chain))
    assert image.left_share == pytest.approx(1 - own.left_share, abs=1e-9)
    assert own.links
    assert {link.replace("left", "*").replace("right", "*") for link in own.links} == {
        link.replace("left", "*").replace("right", "*") for link in image.links
    }
    assert all(link.startswith("left" if own.left_share > 1 / 2 else "right") for link in own.links)
    assert {link[:4] for link in own.links}.isdisjoint(link[:4] for link in image.links)


def test_place_yaw_unit_and_the_direction_of_time_change_nothing(rng):
    motion = oracle.human(rng, bend=0.8)
    own = side_ways(kinematic_chain(motion))
    elsewhere = oracle.scaled(oracle.moved(motion, yaw=2.0, by=[3.0, 0.0, -1.0]), 100.0)
    chain = kinematic_chain(motion)
    for other in (kinematic_chain(elsewhere), chain.replace(values=chain.values[::-1])):
        told = side_ways(other)
        assert told.left_share == pytest.approx(own.left_share, abs=1e-6)
        assert told.links == own.links


def test_it_is_the_sum_of_the_angles(rng):
    chain = kinematic_chain(oracle.human(rng, bend=0.8))
    turns = chain.values.reshape(len(chain), -1, 4)
    ways = {"left": 0.0, "right": 0.0}
    for k, name in enumerate(chain.names):
        for before, after in zip(turns[:-1, k], turns[1:, k], strict=True):
            if (side := name.partition("_")[0]) in ways:
                ways[side] += 2 * np.arccos(min(abs(float(before @ after)), 1.0))
    assert side_ways(chain).left_share == pytest.approx(ways["left"] / sum(ways.values()), abs=1e-9)


def test_what_is_unseen_of_one_side_counts_of_neither(rng):
    chain = kinematic_chain(oracle.human(rng, bend=0.8))
    links = chain.values.reshape(len(chain), -1, 4).copy()
    for side in ("left", "right"):
        links[10:20, chain.names.index(f"{side}_humerus")] = np.nan
    both = chain.replace(values=links.reshape(len(chain), -1))
    links[10:20, chain.names.index("right_humerus")] = chain.values.reshape(len(chain), -1, 4)[
        10:20, chain.names.index("right_humerus")
    ]
    one = chain.replace(values=links.reshape(len(chain), -1))
    assert side_ways(one) == side_ways(both)


def test_who_keeps_still_moves_no_side(rng):
    chain = kinematic_chain(oracle.human(rng, bend=0.8))
    assert side_ways(chain.replace(values=np.repeat(chain.values[:1], len(chain), axis=0))) is None
    assert side_ways(chain[:1]) is None


def test_spans_tell_the_side_and_the_mirror_the_other():
    motion = made.movement("asymmetric_palindrome")
    for told, side in ((motion, "own"), (oracle.mirrored(motion), "image")):
        spans = [span for span in lm.find_symmetry(told).spans if span.motif == "asymmetric_palindrome"]
        sides = {span.side for span in spans}
        assert len(sides) == 1
        if side == "own":
            own = sides
        assert sides <= {"left", "right"}
        assert all(link.startswith(span.side) for span in spans for link in span.links)
        assert all("humerus" in span.links[0] or "radius" in span.links[0] for span in spans)
    assert sides != own
    walk = [
        span for span in lm.find_symmetry(made.movement("anti_phase")).spans if span.motif == "anti_phase"
    ]
    assert {(span.side, span.links) for span in walk} == {("both", ())}


def test_postures_have_no_side():
    found = lm.find_symmetry(made.movement("asymmetric_palindrome"))
    for span in found.spans:
        if span.motif in ("stillness", "state_repetition", "reflected_state_repetition"):
            assert (span.side, span.left_share, span.links) == ("", None, ())


@pytest.mark.data
def test_the_arm_that_a_person_raises_is_named(data):
    raised = lm.read(data / "uiprmd/correct/Kinect/Positions/m07_s01_e01_positions.txt")
    person = embody(raised, find_roles(raised))
    risen = {
        side: np.ptp(person.positions[:, person.roles.index(f"{side}_wrist"), 1])
        for side in ("left", "right")
    }
    assert risen["right"] > 1.0 > 0.1 > risen["left"]  # metres
    span = max(lm.find_symmetry(raised).spans, key=lambda each: each.stop - each.start)
    assert (span.motif, span.side) == ("asymmetric_palindrome", "right")
    assert span.links == ("right_humerus",)
