"""What several recordings share: laws of joining, known movements, refusals, people who do the same."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import leitmotion as lm
from leitmotion.discovery import Places, find_recurrences, find_shared_patterns
from leitmotion.discovery.across import DIRECTIONS, PLACES
from leitmotion.discovery.joining import join
from leitmotion.discovery.shared import SharedPatterns
from leitmotion.features import FeatureSequence
from leitmotion.motion import DataError, ParameterError

NINE = tuple("abcdefghi")


def smooth(seed, seconds, rate=30.0, names=NINE):
    """A movement like no other: sums of slow waves, nine points in space."""
    rng = np.random.default_rng(seed)
    time = np.arange(round(seconds * rate)) / rate
    waves = 2 * np.pi * rng.uniform(0.1, 0.9, (27, 5, 1)) * time + rng.uniform(0, 6.3, (27, 5, 1))
    whole = 0.08 * np.sin(waves).sum(axis=1).T.reshape(len(time), 9, 3)
    kept = whole[:, [NINE.index(name) for name in names]]
    return FeatureSequence(kept.reshape(len(time), -1), names, rate, ("place", "yaw", "body_size"), 3)


def strung(*pieces):
    return pieces[0].replace(values=np.concatenate([piece.values for piece in pieces]))


def cycles(count, seed=9, period=36):
    """One movement over and over."""
    phase = 2 * np.pi * np.arange(count * period) / period
    shifts = np.random.default_rng(seed).uniform(0, 6.3, 27)
    values = 0.12 * np.sin(phase[:, None] + shifts)
    return FeatureSequence(values, NINE, 30.0, ("place", "yaw", "body_size"), 3)


def told(found):
    """Kind, recordings and occurrences of each pattern, whatever its letter."""
    return sorted((p.kind, [place[:3] for place in p.occurrences]) for p in found)


@given(
    st.lists(
        st.tuples(st.integers(1, 300), st.sampled_from([16.0, 24.0, 30.0, 119.88, 240.0])),
        min_size=2,
        max_size=5,
    )
)
def test_every_moment_is_of_its_recording_and_at_its_frame(shapes):
    sequences = [FeatureSequence(np.zeros((count, 3)), ("a",), rate, (), 3) for count, rate in shapes]
    joined = join(sequences, [str(k) for k in range(len(shapes))])
    rate_of_all = joined.features.rate
    assert rate_of_all % 30 == 0
    assert min(120, max(rate for _, rate in shapes)) <= rate_of_all <= 120
    assert (joined.begins % (rate_of_all // 30) == 0).all()
    seen = np.flatnonzero(np.isfinite(joined.features.values).all(axis=1))
    owners = joined.owner(seen)
    frames = joined.frame(seen, owners)
    assert (np.diff(owners) >= 0).all()
    assert set(owners) == set(range(len(shapes)))
    for k, (count, rate) in enumerate(shapes):
        own = frames[owners == k]
        assert own[0] == 0
        assert (own < count).all()
        assert count - 1 - own[-1] < rate / rate_of_all + 0.5
        expected = np.minimum(np.arange(len(own)) * rate / rate_of_all, count)
        np.testing.assert_allclose(own, expected, atol=0.5)


def test_between_recordings_nothing_is_seen_for_two_seconds_and_longer_beside_long_ones():
    joined = join([smooth(0, 3), smooth(1, 20), smooth(2, 3)], "abc")
    gaps = np.flatnonzero(np.diff(np.isnan(joined.features.values[:, 0]).astype(int))).reshape(-1, 2)
    assert [stop - start for start, stop in gaps] == [240, 240]
    assert join([smooth(0, 3), smooth(1, 3)], "ab").begins.tolist() == [0, 150]


@pytest.mark.parametrize("seconds", [3, 8, 25])
def test_a_movement_done_once_in_each_of_two_recordings_is_no_cycle(seconds):
    found = find_shared_patterns([smooth(0, seconds), smooth(0, seconds)])
    (pattern,) = found.patterns
    assert pattern.kind == "acyclic"
    assert [place[0] for place in pattern.occurrences] == [0, 1]
    for _, start, stop, score in pattern.occurrences:
        assert start <= 10
        assert stop >= seconds * 30 - 10
        assert score > 0.95


def test_a_movement_is_found_wherever_it_stands_and_at_any_rate():
    shared = smooth(3, 4, rate=120)
    one = strung(smooth(10, 3, rate=120), shared)
    other = lm.features.resampling.resample(strung(shared, smooth(11, 2, rate=120)), 24)
    (pattern,) = find_shared_patterns([one, other]).patterns
    (a, a_start, a_stop, _), (b, b_start, b_stop, _) = pattern.occurrences
    assert (a, b) == (0, 1)
    np.testing.assert_allclose([a_start / 120, a_stop / 120], [3, 7], atol=0.2)
    np.testing.assert_allclose([b_start / 24, b_stop / 24], [0, 4], atol=0.2)


def test_a_pair_joins_the_same_moments_of_both():
    shared = smooth(3, 4, rate=120)
    found = find_shared_patterns([strung(smooth(10, 3, rate=120), shared), shared[::4]])
    (pair,) = found.pairs
    assert pair.recordings.tolist() == [0, 1]
    assert (pair.a[0], pair.b[0]) == (0, 1)
    np.testing.assert_allclose(pair.path[:, 0] / 120 - 3, pair.path[:, 1] / 30, atol=0.1)
    assert (pair.path.max(axis=0) < found.frames).all()


def test_cycles_of_several_recordings_are_one_pattern_and_each_is_counted():
    found = find_shared_patterns([cycles(4), smooth(1, 5), cycles(6)])
    (pattern,) = found.shared
    assert pattern.kind == "cyclic"
    assert pattern.recordings == (0, 2)
    assert found.counts[[0, 2], 0].tolist() == [4, 6]
    assert found.counts[1].sum() == 0
    assert pattern.cycles == 10


def test_alone_a_recording_is_answered_as_by_itself():
    recording = strung(cycles(4), smooth(1, 3), smooth(2, 2), smooth(1, 3))
    alone = find_recurrences(recording)
    found = find_shared_patterns([smooth(5, 4), recording])
    assert found.shared == ()
    assert told(found) == sorted(
        (p.kind, [(1, start, stop) for start, stop, _, _ in p.occurrences]) for p in alone.patterns
    )
    assert len(found) == 2


def test_the_order_of_the_recordings_does_not_matter():
    recordings = [
        strung(smooth(1, 3), cycles(3)),
        strung(cycles(4), smooth(2, 4)),
        strung(smooth(2, 4), smooth(1, 3)),
    ]
    forward = find_shared_patterns(recordings)
    backward = find_shared_patterns(recordings[::-1])
    assert len(forward) == 3

    def by_recording(found, place):
        return sorted((p.kind, tuple(sorted(place(k) for k in p.recordings))) for p in found)

    assert by_recording(forward, lambda k: k) == by_recording(backward, lambda k: 2 - k)


def test_shared_ones_stand_first_with_the_first_letters():
    found = find_shared_patterns([strung(cycles(12), smooth(1, 3)), smooth(1, 3)])
    assert [(p.id, p.kind, p.recordings) for p in found] == [("A", "acyclic", (0, 1)), ("B", "cyclic", (0,))]
    assert {pair.pattern for pair in found.pairs} == {"A", "B"}
    assert [p.id for p in found.shared] == ["A"]


def test_only_what_all_have_is_compared():
    found = find_shared_patterns([smooth(1, 3), smooth(1, 3, names=NINE[::-1][:7])])
    assert found.parameters["features"] == list("cdefghi")
    assert len(found.shared) == 1


def test_gaps_of_a_recording_hurt_no_other():
    values = smooth(1, 4).values.copy()
    values[100:] = np.nan
    (pattern,) = find_shared_patterns([smooth(1, 4), smooth(1, 4).replace(values=values)]).patterns
    assert pattern.occurrences.of(1)[0][1] <= 101


def test_what_cannot_be_compared_is_refused_in_a_sentence_that_names_it():
    flat = FeatureSequence(np.zeros((90, 18)), NINE, 30.0, ("place", "yaw"), 2)
    unturned = smooth(1, 3).replace(invariant_to=("place",))
    slow = smooth(1, 10).replace(rate=3.0)
    poor = smooth(1, 3, names=NINE[:2])
    with pytest.raises(ParameterError, match="two recordings or more, got 1"):
        find_shared_patterns([smooth(1, 3)])
    with pytest.raises(ParameterError, match="2 recordings, but 1 names"):
        find_shared_patterns([smooth(1, 3)] * 2, names=["a"])
    with pytest.raises(DataError, match=r"b\.bvh is in a plane and a\.bvh in space"):
        find_shared_patterns([smooth(1, 3), flat], names=["a.bvh", "b.bvh"])
    with pytest.raises(DataError, match=r"known in a\.bvh and not in b\.bvh"):
        find_shared_patterns([smooth(1, 3), unturned], names=["a.bvh", "b.bvh"])
    with pytest.raises(DataError, match=r"b\.bvh: Patterns need 4 frames a second or more, got 3"):
        find_shared_patterns([smooth(1, 3), slow], names=["a.bvh", "b.bvh"])
    with pytest.raises(DataError, match="only a, b") as told:
        find_shared_patterns([smooth(1, 3), poor, smooth(2, 3)], names=["a.bvh", "b.bvh", "c.bvh"])
    assert told.value.remedy.startswith("b.bvh shares fewest")
    assert find_shared_patterns([poor, poor]).parameters["features"] == ["a", "b"]


def test_places_must_stand_in_order():
    with pytest.raises(ParameterError, match="in order"):
        Places([0, 0], [0, 5], [6, 9])
    with pytest.raises(ParameterError, match="in order"):
        Places([1, 0], [0, 5], [6, 9])
    with pytest.raises(ParameterError, match="end after they begin"):
        Places([0], [3], [3])


def test_what_was_found_is_saved_and_loaded(tmp_path):
    found = find_shared_patterns([cycles(4), cycles(3)], names=["a", "a"])
    again = lm.load(lm.save(found, tmp_path / "found.npz"))
    assert isinstance(again, SharedPatterns)
    assert again == found


def test_the_body_may_be_of_any_size_place_and_direction():
    session = lm.compose_session(seed=3, rate=30.0).motion[:900]
    turned = session.replace(
        local_positions=session.local_positions * 1.3,
        skeleton=session.skeleton.replace(offsets=session.skeleton.offsets * 1.3),
    )
    found = lm.find_shared_patterns([session, turned], names=["short", "tall"])
    assert found.names == ("short", "tall")
    assert len(found.shared) == len(found) > 0
    np.testing.assert_array_equal(found.counts[0], found.counts[1])


def test_the_proportions_of_a_body_do_not_matter():
    session = lm.compose_session(seed=3, rate=30.0).motion[:900]
    longer = {name: 1.5 for name in session.skeleton.names if name.endswith(("ForeArm", "UpLeg", "Leg"))}
    by = np.array([longer.get(name, 1.0) for name in session.skeleton.names])[:, None]
    assert len(longer) >= 4
    other = session.replace(
        local_positions=session.local_positions * by,
        skeleton=session.skeleton.replace(offsets=session.skeleton.offsets * by),
    )
    found, same = (lm.find_shared_patterns([session, one]) for one in (other, session))
    assert told(found) == told(same)
    assert len(found.shared) == len(found) > 0


def test_limits_are_those_of_the_features():
    places, directions = smooth(1, 3), smooth(1, 3).replace(unit="rad")
    for one, limits in ((places, PLACES), (directions, DIRECTIONS)):
        parameters = find_shared_patterns([one, one]).parameters
        assert parameters["max_distance"] == limits.max_distance
        assert parameters["amplitude_share"] == limits.amplitude_share
        assert find_shared_patterns([one, one], min_contrast=0.1).parameters["min_contrast"] == 0.1


def test_places_are_compared_where_directions_cannot_be_or_joints_are_named():
    session = lm.compose_session(seed=3, rate=30.0).motion[:300]
    body = lm.embody(session)

    def feature(one, **options):
        return lm.find_shared_patterns([one, one], **options).parameters["feature"]

    upper = [k for k, role in enumerate(body.roles) if "hip" not in role and "knee" not in role]
    armed = body.replace(roles=tuple(body.roles[k] for k in upper), positions=body.positions[:, upper])
    assert feature(session) == feature(body) == "limb_directions"
    assert feature(armed) == "posture"  # five limbs
    assert feature(body.replace(positions=body.positions[..., :2])) == "posture"
    assert feature(session, joints="left_*") == feature(session, exclude="head") == "posture"
    assert feature(session, features="posture") == "posture"


def test_other_features_may_be_compared():
    session = lm.compose_session(seed=3, rate=30.0).motion[:600]
    found = lm.find_shared_patterns([session, session], features="joint_angles")
    assert found.parameters["feature"] == "joint_angles"
    assert found.parameters["unit"] == "rad"
    assert found.shared
    with pytest.raises(ParameterError, match="compares the markers of a recording, and this is a skeleton"):
        lm.find_shared_patterns([session, session], features="marker_posture")


def test_options_and_joints_that_do_not_exist_are_refused():
    session = lm.compose_session(seed=3, rate=30.0).motion[:300]
    with pytest.raises(ParameterError, match=f"^{session.name}: The body has no joint 'hed'"):
        lm.find_shared_patterns([session, session], joints="hed")
    with pytest.raises(ParameterError, match="without an option 'stillness'"):
        lm.find_shared_patterns([session, session], stillness=True)


@pytest.mark.data
def test_takes_of_one_actor_are_told_apart_by_what_they_show(data):
    bandai = data / "bandai_namco"
    names = ("walk_normal_010", "walk-turn-left_normal_032", "wave-left-hand_normal_026",
             "raise-up-both-hands_active_058", "wave-both-hands_active_023")  # fmt: skip
    found = lm.find_shared_patterns([lm.read(bandai / f"dataset-2_{name}.bvh") for name in names])
    joined = {pattern.recordings for pattern in found.shared}
    assert (0, 1) in joined
    assert (3, 4) in joined  # raising both hands begins the wave
    assert not any({0, 1} & set(some) and {2, 3, 4} & set(some) for some in joined)


@pytest.mark.data
def test_people_formats_and_rates_are_mixed(data):
    walk = lm.read(data / "bandai_namco" / "dataset-2_walk_normal_010.bvh")
    other = lm.read(data / "cmu_amc" / "02_01.amc")
    found = lm.find_shared_patterns([walk, other])
    assert found.rates.tolist() == [30.0, 120.0]
    assert found.parameters["feature"] == "limb_directions"
    assert len(found.parameters["features"]) == 9


@pytest.mark.data
def test_a_walk_of_one_person_is_a_walk_of_another_and_no_run(data):
    clips = ("bandai_namco/dataset-1_walk_normal_001.bvh", "bandai_namco/dataset-1_run_active_001.bvh",
             "cmu_amc/02_01.amc", "cmu_amc/02_03.amc")  # fmt: skip
    found = lm.find_shared_patterns([lm.read(data / clip) for clip in clips])
    assert sorted(pattern.recordings for pattern in found.shared) == [(0, 2), (1, 3)]
    assert {pattern.kind for pattern in found.shared} == {"cyclic"}
