"""The default way to find patterns: known movements, what must not change the answer, real recordings."""

from itertools import pairwise

import numpy as np
import pytest

from leitmotion import body, features, io
from leitmotion.datasets import compose_session
from leitmotion.discovery import Patterns, find_patterns, recurrence
from leitmotion.discovery.pattern import letter
from leitmotion.discovery.refine import Refiner
from leitmotion.discovery.search import Criteria, Seen
from leitmotion.discovery.search import search as search_stretches
from leitmotion.discovery.writing import Scribe, joined_spans
from leitmotion.features import FeatureSequence
from leitmotion.motion import DataError, Motion, ParameterError, Trajectories, rotations
from leitmotion.similarity import Distances


@pytest.fixture(scope="module")
def session():
    return compose_session(seed=0)


@pytest.fixture(scope="module")
def found(session):
    return search(session.motion)


def search(recording, **options):
    return find_patterns(features.posture(body.embody(recording)), **options)


def swings(*counts, pause_s=2.0, period_s=1.0, rate=30.0):
    """One movement, so many times without a break in each run; the body is still between."""
    parts = []
    for count in counts:
        phase = 2 * np.pi * np.arange(round(count * period_s * rate)) / (period_s * rate)
        parts.append(np.stack([0.1 * (1 - np.cos(phase + 0.1 * k)) for k in range(9)], axis=1))
        parts.append(np.tile(parts[-1][0], (round(pause_s * rate), 1)))
    return FeatureSequence(np.concatenate(parts), ("a", "b", "c"), rate, ("place",), 3)


def by_time(patterns):
    """What was found, without letters: kind, and the start and stop of each occurrence in seconds."""
    return sorted(
        (
            p.kind,
            tuple(np.round(np.stack((p.occurrences.starts, p.occurrences.stops)) / patterns.rate, 1).ravel()),
        )
        for p in patterns.patterns
    )


def times_agree(one, other, within_s=0.15):
    a, b = by_time(one), by_time(other)
    assert [(kind, len(times)) for kind, times in a] == [(kind, len(times)) for kind, times in b]
    for (_, first), (_, second) in zip(a, b, strict=True):
        np.testing.assert_allclose(first, second, atol=within_s)


def test_every_action_of_the_practice_session_is_found_and_nothing_else(session, found):
    owners = [_owner(pattern, session.stretches) for pattern in found.patterns]
    assert None not in owners
    assert set(owners) == set(session.stretches.labels) - {"still"}


def _owner(pattern, truth):
    """The action that at least 80 % of every occurrence belongs to."""
    owners = set()
    for start, stop, _, _ in pattern.occurrences:
        shares = dict.fromkeys(truth.labels, 0.0)
        for a, b, label, _ in truth:
            shares[label] += max(0, min(stop, b) - max(start, a)) / (stop - start)
        label = max(shares, key=shares.get)
        owners.add(label if shares[label] >= 0.8 else None)
    return owners.pop() if len(owners) == 1 else None


def test_swings_are_counted_in_each_run():
    patterns = find_patterns(swings(4, 3)).patterns
    assert [(p.kind, p.cycles, len(p.stretches)) for p in patterns] == [("cyclic", 7, 2)]
    assert patterns[0].period_s == pytest.approx(1.0, abs=0.05)


@pytest.mark.parametrize("periods", [[1.0] * 4 + [1.4] * 4, [1, 1.2, 1.4, 1.6, 1.8, 2, 2.2]])
def test_a_run_that_begins_with_the_recording_is_told_once(periods):
    values = np.concatenate([swings(1, period_s=period, pause_s=0).values for period in periods])
    (pattern,) = find_patterns(
        swings(1).replace(values=np.concatenate((values, np.tile(values[0], (60, 1)))))
    )
    assert (pattern.kind, pattern.cycles) == ("cyclic", len(periods))


def test_two_cycles_are_cyclic():
    (pattern,) = find_patterns(swings(2)).patterns
    assert (pattern.kind, pattern.cycles) == ("cyclic", 2)


def test_a_movement_that_comes_back_later_is_acyclic():
    (pattern,) = find_patterns(swings(1, 1, pause_s=3.0)).patterns
    assert (pattern.kind, len(pattern.occurrences)) == ("acyclic", 2)


def test_one_posture_held_throughout_is_told_as_what_was_asked_for():
    held = FeatureSequence(np.ones((90, 9)), ("a", "b", "c"), 30.0, ("place",), 3)
    assert "stillness does not count" in find_patterns(held).nearest_miss
    assert "no posture is held again" in find_patterns(held, stillness=True).nearest_miss


def test_what_bounded_the_second_look_is_told_too(monkeypatch):
    bent = [np.zeros((60, 9)), swings(1).values + np.linspace(0, 1, 90)[:, None], np.zeros((60, 9))]
    values = FeatureSequence(np.concatenate(bent), ("a", "b", "c"), 30.0, ("place",), 3)
    seen = []

    def bounded(distances, criteria, refine):
        seen.append(criteria)
        return Seen([], [], {"compared_within_s": 40.0 / len(seen)})

    monkeypatch.setattr(recurrence, "search", bounded)
    parameters = find_patterns(values).parameters
    assert (parameters["compared_within_s"], parameters["second_compared_within_s"]) == (40.0, 20.0)


def test_stillness_is_no_pattern_unless_asked_for(rng):
    held = np.repeat([0.0, 0.4, 0.0], 90)[:, None] + rng.normal(scale=1e-3, size=(270, 9))
    postures = FeatureSequence(held, ("a", "b", "c"), 30.0, ("place",), 3)
    assert find_patterns(postures).patterns == ()
    (pattern,) = find_patterns(postures, stillness=True).patterns
    assert len(pattern.occurrences) == 2


def holds(rng, hidden):
    """A posture held for 3 s, another, and the first again; some moments of it were not seen."""
    values = np.repeat([0.0, 0.4, 0.0], 90)[:, None] + rng.normal(scale=1e-3, size=(270, 9))
    values[hidden] = np.nan
    return FeatureSequence(values, ("a", "b", "c"), 30.0, ("place",), 3)


@pytest.mark.parametrize("hidden", [slice(26, 34), slice(0, 8), slice(80, 95), slice(230, 255), [3, 30, 31]])
def test_a_gap_of_unseen_moments_ends_no_hold(rng, hidden):
    (pattern,) = find_patterns(holds(rng, hidden), stillness=True).patterns
    (whole,) = find_patterns(holds(rng, []), stillness=True).patterns
    for what in ("starts", "stops"):
        told, meant = (getattr(it.occurrences, what) for it in (pattern, whole))
        np.testing.assert_allclose(told, meant, atol=8)


def test_what_was_not_seen_for_long_is_no_hold(rng):
    values = holds(rng, slice(60, 210)).values  # between two holds of one posture anything may have happened
    twice = FeatureSequence(
        np.concatenate((values, np.full((60, 9), np.nan))), ("a", "b", "c"), 30.0, ("place",), 3
    )
    (pattern,) = find_patterns(twice, stillness=True).patterns
    assert [(start, stop) for start, stop, _, _ in pattern.occurrences] == [(0, 60), (210, 270)]


def test_a_movement_made_once_is_no_pattern():
    once = np.cumsum(np.full((90, 9), 0.01), axis=0)
    found = find_patterns(FeatureSequence(once, ("a", "b", "c"), 30.0, ("place",), 3))
    assert found.patterns == ()


def test_a_recording_too_short_for_two_stretches_says_so():
    found = find_patterns(FeatureSequence(np.zeros((20, 3)), ("a",), 30.0, ("place",), 3))
    assert "too short" in found.nearest_miss


@pytest.mark.parametrize("rate", [60.0, 50.0, 30.0])
def test_the_answer_is_the_same_at_another_frame_rate(found, rate):
    again = search(compose_session(seed=0, rate=rate).motion)
    times_agree(found, again, within_s=0.25)


def test_the_answer_is_the_same_for_another_body_size(session, found):
    motion = session.motion
    skeleton = motion.skeleton.replace(
        offsets=1.3 * motion.skeleton.offsets, end_offsets=1.3 * motion.skeleton.end_offsets
    )
    larger = Motion(skeleton, 1.3 * motion.local_positions, motion.local_rotations, motion.rate)
    times_agree(found, search(larger), within_s=0.05)


@pytest.fixture(scope="module")
def points(session):
    """The practice session as the joints that have a role."""
    person = body.embody(session.motion)
    return Trajectories(person.roles, person.positions, person.rate, kind="joint")


def test_the_answer_is_the_same_for_points_and_for_fewer_of_them(points, found):
    times_agree(found, search(points), within_s=0.05)
    kept = [k for k, role in enumerate(points.names) if role in body.ANALYSIS_ROLES]
    fewer = points.replace(names=tuple(points.names[k] for k in kept), positions=points.positions[:, kept])
    times_agree(found, search(fewer), within_s=0.05)


def test_the_answer_is_the_same_in_another_unit(points, found):
    times_agree(
        found, search(points.replace(positions=1000 * points.positions, unit="relative")), within_s=0.05
    )


def test_the_answer_is_the_same_in_the_mirror(points, found):
    mirrored = points.replace(
        names=tuple(body.mirror_role(name) for name in points.names), positions=points.positions * [-1, 1, 1]
    )
    times_agree(found, search(mirrored), within_s=0.05)


def test_the_answer_is_the_same_elsewhere_and_turned(points, found):
    turn = rotations.yaw_rotation(2.0)
    moved = points.replace(positions=rotations.rotate(turn, points.positions) + np.array([3.0, 0.0, -7.0]))
    times_agree(found, search(moved), within_s=0.05)


def test_the_same_input_gives_the_same_answer_to_the_bit(session, found):
    assert search(session.motion) == found


def test_what_is_found_is_well_formed(found):
    assert [p.id for p in found.patterns] == [letter(k) for k in range(len(found))]
    for pattern in found.patterns:
        assert 0 <= pattern.confidence <= 1
        assert pattern.reason
        assert set(pattern.occurrences.labels) == {pattern.id}
    by_id = {pattern.id: pattern for pattern in found}
    for pair in found.pairs:
        earlier, later = (_holding(by_id[pair.pattern].occurrences, span) for span in (pair.a, pair.b))
        assert earlier < later
    for stripe in found.stripes:
        for span in (stripe.a, stripe.b):
            _holding(by_id[stripe.pattern].stretches, span, slack=4)
    for path in (pair.path for pair in (*found.pairs, *found.stripes)):
        assert (np.diff(path, axis=0) >= 0).all()
        assert (path[:, 0] < path[:, 1]).all()


def _holding(spans, span, slack=0):
    """Which of some stretches holds this one."""
    (which,) = np.flatnonzero((spans.starts - slack <= span[0]) & (span[1] <= spans.stops + slack))
    return which


def test_what_comes_near_is_told_whatever_contrast_is_asked():
    found = find_patterns(swings(1, 1), max_distance=0.001, min_contrast=0.0)
    assert isinstance(found.nearest_miss, str)
    steps = np.cumsum(np.random.default_rng(0).normal(size=(600, 6)), axis=0) * 0.01
    walk = FeatureSequence(steps, ("a", "b"), 30.0, ("place",), 3)
    assert find_patterns(walk, max_distance=0.04, min_contrast=0.0).nearest_miss.startswith("The nearest")


def test_a_recording_of_which_nothing_was_seen_says_so():
    hidden = FeatureSequence(np.full((300, 6), np.nan), ("a", "b"), 30.0, ("place",), 3)
    assert find_patterns(hidden).nearest_miss == "Nothing was seen in this recording."


def test_stretches_too_short_for_a_movement_are_refused():
    with pytest.raises(ParameterError, match=r"0\.1 s or more, got 0\.034"):
        find_patterns(swings(3), min_duration_s=0.034)


def test_unknown_methods_and_options_are_refused(found):
    postures = swings(3)
    with pytest.raises(ParameterError, match="one of recurrence, tang2008"):
        find_patterns(postures, method="tang")
    with pytest.raises(ParameterError, match="no option 'treshold'"):
        find_patterns(postures, treshold=3)
    for options in (
        {"max_distance": 0},
        {"min_duration_s": np.inf},
        {"min_amplitude": -1},
        {"min_contrast": 1},
    ):
        with pytest.raises(ParameterError, match=next(iter(options))):
            find_patterns(postures, **options)
    with pytest.raises(ParameterError, match="min_duration_s must be a number, got 'half'"):
        find_patterns(postures, min_duration_s="half")


@pytest.mark.parametrize("method", ["recurrence", "tang2008"])
def test_recordings_of_few_frames_a_second_are_refused(method):
    with pytest.raises(DataError, match="4 frames a second"):
        find_patterns(swings(3, rate=2.0), method=method)
    assert isinstance(find_patterns(swings(3, rate=5.0), method=method), Patterns)


@pytest.mark.data
def test_jumping_jacks(data):
    (pattern,) = search(io.read(data / "cmu_bvh/jumping_jacks.bvh")).patterns
    assert (pattern.kind, pattern.cycles) == ("cyclic", 3)


@pytest.mark.data
def test_walks_punches_jumps_and_kicks_of_cmu_86_01(data):
    motion = io.read(data / "cmu86/86_01.amc")
    found = search(motion)
    truth = io.read_annotations(data / "cmu86/mocap.txt", rate=motion.rate, trial="86_01")
    owners = {pattern.id: _owner(pattern, truth) for pattern in found.patterns}
    assert set(owners.values()) == {"jump", "leg_kick", "punch", "walk"}
    kinds = {(owners[p.id], p.kind, len(p.stretches)) for p in found.patterns if owners[p.id] != "punch"}
    assert kinds == {("walk", "cyclic", 3), ("jump", "cyclic", 1), ("leg_kick", "cyclic", 1)}


@pytest.mark.data
def test_steps_of_a_walk(data):
    (pattern,) = search(io.read(data / "bandai_namco/dataset-1_walk_normal_001.bvh")).patterns
    assert pattern.kind == "cyclic"
    assert pattern.period_s == pytest.approx(1.08, abs=0.06)


@pytest.mark.data
def test_nothing_recurs_when_a_person_lies_down(data):
    (clip,) = (data / "hdm05/lieDownFloor").glob("*.amc")
    assert search(io.read(clip)).patterns == ()


def closed(which, count=45, size=0.6):
    """One joint of three leaves its place and comes back, (count, 9)."""
    values = np.zeros((count, 9))
    away = 0.5 * (1 - np.cos(2 * np.pi * np.arange(count) / count))
    for k in range(3):
        values[:, 3 * which + k] = size * away * np.cos(0.9 * k)
    return values


def in_turn(which, pause_s=0.8, sizes=None):
    """Closed movements one after another, a pause after each; and where each begins and ends, seconds.

    One frame differs by a thousandth of the body, so that they are no loop of copies.
    """
    parts, spans, at = [np.zeros((15, 9))], [], 15
    for k, joint in enumerate(which):
        movement = closed(joint, size=0.6 if sizes is None else sizes[k])
        parts += [movement, np.zeros((round(30 * pause_s), 9))]
        spans.append((at / 30, (at + len(movement)) / 30))
        at += len(movement) + len(parts[-1])
    values = np.concatenate(parts)
    values[0] += 0.001
    return FeatureSequence(values, ("a", "b", "c"), 30.0, ("place",), 3), spans


def shown_by(pattern, spans, rate=30.0):
    """Which of some spans the occurrences of a pattern lie in, each with its pauses, in order."""
    middles = 0.5 * (pattern.occurrences.starts + pattern.occurrences.stops) / rate
    return [k for m in middles for k, (start, stop) in enumerate(spans) if start <= m <= stop]


def test_of_two_movements_in_turn_the_one_that_comes_back_oftener_goes_first():
    postures, spans = in_turn((0, 1, 0, 1, 0))
    patterns = find_patterns(postures).patterns
    assert [shown_by(p, spans) for p in patterns] == [[0, 2, 4], [1, 3]]
    for pattern in patterns:
        lengths = (pattern.occurrences.stops - pattern.occurrences.starts) / 30
        assert lengths.max() <= 1.5 + 0.8


def open_movements(*through):
    """From one posture to the next at an even speed, 45 frames each, so that no pause parts them."""
    legs = [np.linspace(a, b, 45, endpoint=False) for a, b in pairwise(np.array(through, float))]
    return FeatureSequence(
        0.6 * np.repeat(np.concatenate(legs), 3, axis=1), ("a", "b", "c"), 30.0, ("place",), 3
    )


def test_a_part_that_comes_back_where_the_whole_does_not_goes_first():
    a, b, c = (0, 0, 0), (1, 0, 0), (1, 0, 1)
    whole, back = (a, b, c), ((2, 1, 1), (-1, 1, 1), (-1, 2, -1), (2, -1, 0), (1, -2, 0))
    found = find_patterns(open_movements(*whole, *back[:2], *whole, *back[2:], a, b, (2, 0, -1), (2, 1, -2)))
    starts = [0, 5, 11]  # legs that lead from a to b
    first, *_ = sorted(found.patterns, key=lambda p: -len(p.occurrences))
    assert shown_by(first, [(1.5 * k, 1.5 * (k + 1)) for k in starts]) == [0, 1, 2]
    assert len(first.occurrences) == 3


def test_stretches_without_a_break_are_joined():
    assert joined_spans([(0, 10), (10, 20), (20, 30)]) == [(0, 30)]
    assert joined_spans([(0, 10)]) == [(0, 10)]
    assert joined_spans([(0, 10), (40, 50), (51, 60)]) == [(0, 10), (40, 60)]


def test_a_pause_of_a_quarter_of_the_lag_still_joins_and_a_longer_one_does_not():
    assert joined_spans([(0, 15), (20, 35)]) == [(0, 35)]
    assert joined_spans([(0, 14.9), (20, 35)]) == [(0, 14.9), (20, 35)]


def test_what_the_second_look_finds_does_not_overlap_what_the_first_found():
    shift = np.zeros((1, 9))
    shift[:, :3] = 0.095  # alike only to the wider look
    first, _ = in_turn((0, 0), pause_s=1.5)
    second = closed(2)
    rest = np.zeros((45, 9))
    values = np.concatenate((first.values, second, rest, second + shift, rest + shift))
    postures = FeatureSequence(values, ("a", "b", "c"), 30.0, ("place",), 3)
    criteria = Criteria(recurrence.MAX_DISTANCE, recurrence.MIN_CONTRAST, recurrence.MIN_AMPLITUDE, 15)
    once = search_once(postures, criteria)
    found, _ = recurrence.look(postures, Distances(postures), criteria)
    assert len(found) > len(once) > 0
    for early in (item.pattern.stretches for item in found[: len(once)]):
        for late in (item.pattern.stretches for item in found[len(once) :]):
            assert not ((early.starts[:, None] < late.stops) & (late.starts < early.stops[:, None])).any()


@pytest.mark.parametrize("asked", [{}, {"max_distance": 0.1, "min_contrast": 0.6}])
def test_what_the_second_look_counts_as_alike_is_told(asked, monkeypatch):
    looks = []
    usual = recurrence.search

    def noted(distances, criteria, refine):
        looks.append(criteria)
        return usual(distances, criteria, refine)

    monkeypatch.setattr(recurrence, "search", noted)
    postures = in_turn((0, 0))[0].replace(scale=1.8)
    told = find_patterns(postures, **asked).parameters
    assert len(looks) == 2
    for look, first in zip(looks, ("", "second_"), strict=True):
        assert told[f"{first}max_distance"] == look.max_distance
        assert told[f"{first}max_distance_own_unit"] == pytest.approx(1.8 * look.max_distance)
        assert told[f"{first}min_contrast"] == look.min_contrast
    assert looks[1].max_distance > looks[0].max_distance
    assert looks[1].min_contrast >= looks[0].min_contrast


def search_once(postures, criteria):
    """What the first look alone finds."""
    distances = Distances(postures)
    seen = search_stretches(distances, criteria, Refiner(postures, postures.rate, criteria.max_distance))
    return Scribe(postures, distances, criteria).describe(seen)
