"""On real recordings: what is known to be wrong is told, what is not is left alone, and gaps are filled well."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.motion import rotations
from leitmotion.repairs import fill_gaps, find_floor, level_floor, undo_exchanges
from oracles.rigid import cut

pytestmark = pytest.mark.data


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("perfume_dance/A_test.bvh", set()),
        ("bandai_namco/dataset-1_dance-short_normal_001.bvh", set()),
        ("cmu_amc/01_01.amc", set()),
        ("pymo/AV_8Walk_Meredith_HVHA_Rep1.bvh", set()),
        ("btk/PiG_Motion3_FF.c3d", set()),
        ("opensim/subject02_running.trc", {"gaps"}),
        ("btk/golfswing.c3d", {"frozen"}),
        ("btk/Gait.trc", {"spikes", "gaps"}),
        ("cmu_bvh/crossover.bvh", {"spikes", "jumps"}),
        ("gesture_phase/a3_raw.csv", {"spikes", "jumps", "duplicates", "gaps"}),
    ],
)
def test_what_is_told(data, name, told):
    faults = {"spikes", "gaps", "jumps", "frozen", "swapped", "drift", "floor", "duplicates"}
    assert {problem.what for problem in lm.info(data / name).problems} & faults == told


def test_neighbours_fill_a_second_of_a_wrist(data):
    whole = lm.read(data / "pycgm" / "Movement_trial.c3d")
    point = whole.names.index("LWRA")
    lost = cut(whole, point, 150, 270)
    errors = {}
    for method in ("linear", "spline", "rigid"):
        filled = fill_gaps(lost, method=method, max_gap_s=1.0).recording.positions
        off = np.linalg.norm(filled[150:270, point] - whole.positions[150:270, point], axis=1)
        errors[method] = float(np.sqrt(np.mean(off**2)))
    assert errors["rigid"] < 0.01
    assert errors["rigid"] < 0.3 * min(errors["linear"], errors["spline"])


def test_ankles_that_change_places_in_a_walk_get_their_names_back(data):
    whole = lm.read(data / "btk" / "Gait.c3d")
    pair = [whole.names.index("LANK"), whole.names.index("RANK")]
    positions = whole.positions.copy()
    positions[210:250, pair] = positions[210:250, pair[::-1]]
    assert undo_exchanges(whole).changes == ()
    assert undo_exchanges(whole.replace(positions=positions)).recording == whole


def test_a_dance_on_a_tilted_floor_is_levelled(data):
    dance = lm.read(data / "cmu_amc" / "131_04-dance.amc")
    before = find_floor(dance)
    turn = rotations.from_euler("xz", np.radians([5.0, -3.0]))
    places, turns = dance.local_positions.copy(), dance.local_rotations.copy()
    places[:, 0] = rotations.rotate(turn, places[:, 0])
    turns[:, 0] = rotations.multiply(np.broadcast_to(turn, turns[:, 0].shape), turns[:, 0])
    hurt = dance.replace(local_positions=places, local_rotations=turns)
    assert np.degrees(find_floor(hurt).tilt) > 5
    after = find_floor(level_floor(hurt).recording)
    assert np.degrees(after.tilt) < 0.2
    assert np.degrees(before.tilt) < 1.0
    assert abs(after.height) < 0.002
