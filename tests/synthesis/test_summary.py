"""A summary: each movement once, whole, where the table of contents says."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.discovery import Pattern, Patterns, typical_occurrence
from leitmotion.features import posture
from leitmotion.motion import Motion, forward_kinematics, joint_points
from leitmotion.motion.rotations import geodesic_angle
from leitmotion.synthesis import summarize

RATE = 30.0


@pytest.fixture(scope="module")
def session() -> lm.datasets.Session:
    """The practice session."""
    return lm.compose_session(seed=0, rate=RATE)


@pytest.fixture(scope="module")
def truth(session: lm.datasets.Session) -> Patterns:
    """What the session holds: a pattern a kind of action."""
    found = []
    for name, letter in zip(dict.fromkeys(session.cycles.labels), "ABCDEFGH", strict=False):
        spans = [(a, b) for a, b, label, _ in session.cycles if label == name]
        occurrences = lm.Segmentation(
            [a for a, _ in spans], [b for _, b in spans], (letter,) * len(spans), rate=RATE
        )
        period = float(np.median(occurrences.stops - occurrences.starts)) / RATE
        if len(spans) >= 2:
            found.append(Pattern(letter, "cyclic", occurrences, occurrences, period, 0.0, 1.0))
    return Patterns(tuple(found), (), RATE, {})


def test_each_pattern_once_in_order_of_first_appearance(
    session: lm.datasets.Session, truth: Patterns
) -> None:
    summary = summarize(session.motion, truth, posture(lm.embody(session.motion)))
    order = sorted(truth.patterns, key=lambda pattern: pattern.occurrences.starts[0])
    assert summary.contents.labels == tuple(pattern.id for pattern in order) == summary.sources.labels
    assert summary.recording.skeleton == session.motion.skeleton
    assert len(summary.recording) < len(session.motion) / 2
    assert (np.diff(summary.contents.starts) > 0).all()


def test_every_movement_is_whole_and_as_it_was(session: lm.datasets.Session, truth: Patterns) -> None:
    summary = summarize(session.motion, truth, posture(lm.embody(session.motion)))
    for (start, stop, *_), (first, last, *_) in zip(summary.contents, summary.sources, strict=True):
        assert stop - start == last - first
        shown = summary.recording.local_rotations[start:stop, 1:]
        assert geodesic_angle(shown, session.motion.local_rotations[first:last, 1:]).max() < 1e-6


def test_two_cycles_that_follow_one_another_are_shown_the_typical_one_among_them(
    session: lm.datasets.Session, truth: Patterns
) -> None:
    features = posture(lm.embody(session.motion))
    summary = summarize(session.motion, truth, features)
    of = {label: (first, last) for first, last, label, _ in summary.sources}
    for pattern in truth.patterns:
        typical = typical_occurrence(pattern, features)
        first, last = of[pattern.id]
        inside = (pattern.occurrences.starts >= first) & (pattern.occurrences.stops <= last)
        assert inside[typical]
        assert inside.sum() == 2


def test_an_acyclic_pattern_is_shown_once(session: lm.datasets.Session, truth: Patterns) -> None:
    once = truth.patterns[0].replace(kind="acyclic")
    summary = summarize(session.motion, truth.replace(patterns=(once,)), posture(lm.embody(session.motion)))
    assert (summary.sources.starts[0], summary.sources.stops[0]) in zip(
        once.occurrences.starts, once.occurrences.stops, strict=True
    )
    # a lead-in and a rest of 0.3 s, and nothing to be joined
    assert len(summary.recording) == int(summary.sources.stops[0] - summary.sources.starts[0]) + 18


def test_movements_that_follow_one_another_stay_together(session: lm.datasets.Session) -> None:
    spans = {"A": [(100, 130), (400, 430)], "B": [(132, 160), (600, 628)]}
    patterns = [
        Pattern(
            name,
            "acyclic",
            *[lm.Segmentation([a for a, _ in at], [b for _, b in at], rate=RATE)] * 2,
            1.0,
            0.0,
            1.0,
        )
        for name, at in spans.items()
    ]
    summary = summarize(
        session.motion, Patterns(tuple(patterns), (), RATE, {}), posture(lm.embody(session.motion))
    )
    np.testing.assert_array_equal(summary.recording.local_rotations, session.motion.local_rotations[91:169])
    assert list(zip(summary.contents.starts, summary.contents.stops, strict=True)) == [(9, 39), (41, 69)]


def test_a_movement_at_either_end_of_the_recording_has_no_context_to_give(
    session: lm.datasets.Session,
) -> None:
    frames = len(session.motion)
    spans = {"A": [(0, 30), (300, 330)], "B": [(500, 530), (frames - 30, frames)]}
    patterns = [
        Pattern(
            name,
            "acyclic",
            *[lm.Segmentation([a for a, _ in at], [b for _, b in at], rate=RATE)] * 2,
            1.0,
            0.0,
            1.0,
        )
        for name, at in spans.items()
    ]
    summary = summarize(
        session.motion, Patterns(tuple(patterns), (), RATE, {}), posture(lm.embody(session.motion))
    )
    assert len(summary.contents) == 2
    assert summary.contents.stops.max() <= len(summary.recording)


def test_points_are_summarised_alike(session: lm.datasets.Session, truth: Patterns) -> None:
    motion = lm.summarize(session.motion, truth)
    points = lm.summarize(joint_points(session.motion), truth)
    assert points.sources == motion.sources
    assert points.contents.labels == motion.contents.labels
    assert isinstance(points.recording, lm.Trajectories)
    first = int(motion.contents.stops[0])
    np.testing.assert_allclose(
        points.recording.positions[:first], forward_kinematics(motion.recording).positions[:first], atol=1e-9
    )


def test_nothing_recurs_nothing_to_summarise(session: lm.datasets.Session) -> None:
    with pytest.raises(lm.DataError, match="Nothing recurs"):
        lm.summarize(session.motion, Patterns((), (), RATE, {}))


def test_what_is_no_recording_or_of_another_one_is_refused(
    session: lm.datasets.Session, truth: Patterns
) -> None:
    with pytest.raises(lm.ParameterError, match="got a Body"):
        lm.summarize(lm.embody(session.motion), truth)  # type: ignore[arg-type]
    with pytest.raises(lm.ParameterError, match="reaches to"):
        lm.summarize(session.motion[:200], truth)
    with pytest.raises(lm.ParameterError, match="steers a search"):
        lm.summarize(session.motion, truth, stillness=True)


@pytest.mark.data
@pytest.mark.parametrize("name", ["cmu86/86_01.amc", "bandai_namco/dataset-1_dance-short_normal_001.bvh"])
def test_no_point_is_faster_in_a_seam_than_people_move(data, name: str) -> None:  # type: ignore[no-untyped-def]
    recording = lm.read(data / name)
    assert isinstance(recording, Motion)
    summary = lm.summarize(recording)
    places = forward_kinematics(summary.recording).positions
    speeds = np.linalg.norm(np.diff(places, axis=0), axis=2).max(axis=1) * recording.rate
    inside = np.zeros(len(places), dtype=bool)
    for start, stop, *_ in summary.contents:
        inside[start:stop] = True
    assert speeds[~inside[:-1]].max() < 8.0
