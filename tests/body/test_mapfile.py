"""The map file: what a person says about their markers."""

import json

import numpy as np
import pytest

from leitmotion.body import embody, find_roles, map_from, map_to_entries
from leitmotion.motion import ParameterError, Trajectories
from oracles.body import human

MARKERS = Trajectories(("Channel101", "Channel102", "Channel103"), np.zeros((1, 3, 3)), rate=65)


def test_round_trip(rng):
    motion = human(rng)
    found = find_roles(motion)
    again = map_from(json.loads(json.dumps(map_to_entries(found))), motion)
    assert (again.roles, again.members) == (found.roles, found.members)
    assert np.all(again.confidence == 1)


def test_embody_takes_the_content_of_a_map_file(rng):
    motion = human(rng)
    assert embody(motion, map_to_entries(find_roles(motion))) == embody(motion)


def test_members_are_averaged(rng):
    motion = human(rng)
    body = embody(motion, map_from({"head": ["Neck", "Head"], "pelvis": "Hips", "left_hip": "LeftUpLeg",
                                    "right_hip": "RightUpLeg", "left_knee": "LeftLeg", "right_knee": "RightLeg"},
                                   motion))  # fmt: skip
    whole = embody(motion)
    middle = whole.positions[:, [whole.roles.index("neck"), whole.roles.index("head")]].mean(axis=1)
    assert np.allclose(body.positions[:, body.roles.index("head")], middle)


@pytest.mark.parametrize(
    ("entries", "says"),
    [
        ({"left_knea": "Channel101"}, "Did you mean left_knee"),
        ({"head": "channel101"}, "Did you mean Channel101"),
        ({"head": []}, "a name or a list of names"),
        ({"head": 7}, "a name or a list of names"),
        ({"head": ["Channel101", "Channel101"]}, "twice"),
        (["head"], "object of roles and names"),
    ],
)
def test_errors_help(entries, says):
    with pytest.raises(ParameterError, match=says):
        map_from(entries, MARKERS)


def test_map_of_another_recording_is_refused(rng):
    with pytest.raises(ParameterError, match="needs 'Hips' for pelvis"):
        embody(MARKERS, find_roles(human(rng)))
