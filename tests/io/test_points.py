"""Points: whose they are, and that each has a name."""

import numpy as np
import pytest

from leitmotion.io.points import OTHERS, split_people


def test_points_go_to_their_subjects_without_their_subjects_names():
    places = np.arange(9.0).reshape(1, 3, 3)
    ann, bob = split_people(["Ann:L", "Bob:L", "Ann:R"], places)
    assert (ann.person, ann.names, bob.person, bob.names) == ("Ann", ["L", "R"], "Bob", ["L"])
    np.testing.assert_array_equal(ann.positions, places[:, [0, 2]])
    nobody = split_people(["Ann:L", "R"], places[:, :2])[1]
    assert (nobody.person, nobody.names) == (OTHERS, ["R"])


@pytest.mark.parametrize(
    ("names", "kept"),
    [(["Ann:", "Ann:R"], [["Ann:", "R"]]), (["Ann:", "Bob: ", "Bob:R"], [["Ann:"], ["Bob: ", "R"]])],
)
def test_a_point_of_which_only_the_subject_is_named_keeps_that(names, kept):
    takes = split_people(names, np.zeros((1, len(names), 3)))
    assert [take.names for take in takes] == kept
