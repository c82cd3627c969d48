"""A recording beside its mirror image, in one call."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.motion.kinematics import forward_kinematics


def test_bias_weights_and_rate_are_as_asked():
    motion = lm.compose_session(seed=3, rate=60.0).motion
    plain = lm.compare_with_mirror(motion)
    assert (plain.every, plain.bias, plain.distances.rate) == (2, None, 30.0)
    active = lm.compare_with_mirror(motion, weights="active", bias="mean", beta=50.0)
    weights = dict(zip(active.distances.names, active.distances.weights, strict=True))
    assert weights["left_humerus"] == weights["right_humerus"] > weights["lower_neck"]
    assert (active.bias.pose, active.bias.frames, active.distances.beta) == ("mean", len(motion), 50.0)
    assert not np.array_equal(active.distances.own, plain.distances.own)


def test_an_unknown_bias_is_refused():
    with pytest.raises(lm.ParameterError, match="bias must be one of none, auto, mean, standing, got 'some'"):
        lm.compare_with_mirror(lm.compose_session(seed=3, rate=30.0).motion, bias="some")


def test_motifs_tell_by_which_posture_their_bias_was_taken_out():
    motion = lm.compose_session(seed=3, rate=30.0).motion
    made = lm.compare_with_mirror(motion, bias="mean")
    for given in (made, lm.compare_with_mirror(motion)):
        parameters = lm.find_symmetry(motion, mirrored=given).parameters
        taken = parameters["largest_bias_deg"]
        assert (parameters["bias"], taken is None) == (("mean", False) if given is made else ("none", True))


@pytest.mark.parametrize("seconds", [0.0, -1.0, float("nan")])
def test_stillness_lasts_some_time(seconds):
    with pytest.raises(lm.ParameterError, match="least duration of stillness must be positive"):
        lm.find_symmetry(lm.compose_session(seed=3, rate=30.0).motion[:60], min_still_s=seconds)


def test_one_recording_is_compared_with_itself_and_with_another():
    session = lm.compose_session(seed=3, rate=60.0).motion
    own = lm.compare(session[:240])
    assert (own.values.shape, own.row_rate) == ((120, 120), 30.0)
    assert np.array_equal(own.values, own.values.T)
    both = lm.compare(session[:240], session[100:160:2])
    assert (both.values.shape, both.row_rate, both.column_rate) == ((120, 30), 30.0, 30.0)
    assert np.allclose(both.values, own.values[:, 50:80], atol=1e-4)  # each is measured by its own size


def test_two_recordings_are_compared_by_the_joints_that_both_have():
    motion = lm.compose_session(seed=3, rate=30.0).motion[:60]
    joints = [name for name in motion.skeleton.names if name not in ("RightHand", "LeftFoot")]
    places = forward_kinematics(motion).positions[:, [motion.skeleton.index(name) for name in joints]]
    fewer = lm.Trajectories(tuple(joints), places, 30.0, kind="joint")
    whole, part = lm.compare(motion, motion), lm.compare(motion, fewer)
    same = lm.compare(motion, motion, exclude="right_wrist, left_ankle")
    assert np.allclose(part.values, same.values, atol=1e-3)
    assert not np.allclose(part.values, whole.values, atol=1e-3)
    with pytest.raises(lm.ParameterError, match="Two recordings are compared with equal weights"):
        lm.compare(motion, motion, weights="active")
