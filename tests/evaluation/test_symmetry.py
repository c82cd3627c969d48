"""Laws of the protocol by which motifs of symmetry are judged, and its cases by hand."""

import numpy as np
import pytest

from leitmotion.discovery import MOTIFS
from leitmotion.discovery.symmetry_span import PAIRED
from leitmotion.evaluation import SymmetryLabel, evaluate_symmetry
from leitmotion.evaluation.symmetry import ENTAILS, SHOWS
from leitmotion.motion import ParameterError, Segmentation

RATE = 50.0
WALK = SymmetryLabel(100, 200, "alternate", "cycle", ("anti_phase",))
RAISED = SymmetryLabel(100, 200, "together", "one_way", ("symmetric_path",))


def spans(*rows):
    starts, stops, motifs, confidences = zip(*rows, strict=True) if rows else ((),) * 4
    return Segmentation(starts, stops, motifs, confidences, rate=RATE)


def labelled(motif, start=100, stop=200):
    sides, course = SHOWS[motif]
    return SymmetryLabel(start, stop, sides or "one", course, (motif,))


def verdict(label, *rows, window=(0, 1000)):
    return evaluate_symmetry([label], spans(*rows), window=window).verdicts[0]


def test_the_words_are_those_of_the_taxonomy():
    assert set(SHOWS) == set(MOTIFS) - set(PAIRED)
    assert set(ENTAILS) | set(ENTAILS.values()) <= set(SHOWS)


@pytest.mark.parametrize("motif", SHOWS)
def test_what_was_seen_agrees_in_everything(motif):
    scores = evaluate_symmetry([labelled(motif)], spans((100, 200, motif, 0.9)))
    found = scores.verdicts[0]
    assert (found.told, found.confidence, found.fit) == (motif, pytest.approx(0.9), 1.0)
    assert found.agrees
    assert found.sides_agree
    assert found.course_agrees
    assert (scores.spans, scores.wrong_spans) == (1, 0)


@pytest.mark.parametrize("seen", SHOWS)
def test_every_other_motif_is_wrong(seen):
    for told in set(SHOWS) - {seen}:
        assert not verdict(labelled(seen), (100, 200, told, 0.9)).agrees, told


@pytest.mark.parametrize("seen", SHOWS)
def test_nothing_told_is_wrong_where_something_was_seen(seen):
    found = verdict(labelled(seen))
    assert found.told == "none"
    assert not found.agrees
    assert not found.sides_agree
    assert not found.course_agrees


def test_where_nothing_was_seen_only_nothing_agrees():
    nothing = SymmetryLabel(100, 200, "one", "one_way")
    assert verdict(nothing).agrees
    assert verdict(nothing, (100, 149, "anti_phase", 0.9)).agrees
    assert verdict(nothing, (100, 200, "anti_phase", 0.49)).agrees
    for motif in SHOWS:
        scores = evaluate_symmetry([nothing], spans((100, 200, motif, 0.5)))
        assert not scores.verdicts[0].agrees
        assert scores.wrong_spans == 1


def test_any_accepted_motif_is_right():
    jog = labelled("anti_palindrome").replace(motifs=("anti_palindrome", "anti_phase"))
    for motif in jog.motifs:
        assert verdict(jog, (100, 200, motif, 0.6)).agrees


@pytest.mark.parametrize(
    ("start", "stop", "confidence", "told"),
    [
        (100, 150, 0.5, "anti_phase"),
        (100, 149, 0.5, "none"),  # covers less than half
        (150, 1000, 0.5, "anti_phase"),
        (100, 200, 0.499, "none"),
    ],
)
def test_told_is_what_covers_half_with_a_confidence_of_half(start, stop, confidence, told):
    assert verdict(WALK, (start, stop, "anti_phase", confidence)).told == told


def test_spans_of_one_motif_cover_a_stretch_together():
    cycles = [(start, start + 20, "anti_phase", 0.6) for start in range(100, 200, 25)]
    found = verdict(WALK, *cycles)
    assert found.agrees
    assert found.fit == pytest.approx(0.8)
    assert not verdict(WALK, *cycles[:2]).agrees
    mixed = verdict(WALK, (100, 140, "anti_phase", 0.9), (160, 200, "anti_palindrome", 0.9))
    assert mixed.told == "none"


def test_confidence_is_the_mean_of_the_greatest_over_the_frames_covered():
    found = verdict(WALK, (100, 150, "anti_phase", 0.6), (140, 180, "anti_phase", 0.9))
    assert found.confidence == pytest.approx((40 * 0.6 + 40 * 0.9) / 80)


@pytest.mark.parametrize(("strong", "weak"), ENTAILS.items())
def test_a_weaker_truth_beside_the_motif_does_not_stand_for_it(strong, weak):
    both = [(100, 200, weak, 1.0), (120, 200, strong, 0.5)]
    assert verdict(labelled(strong), *both).agrees
    assert not verdict(labelled(weak), *both).agrees
    assert set(verdict(labelled(strong), *both).all_told) == {strong, weak}


def test_an_entailing_motif_of_a_much_longer_stretch_leaves_the_short_one_alone():
    kick = labelled("asymmetric_palindrome")
    found = verdict(kick, (100, 200, "asymmetric_palindrome", 0.6), (0, 900, "anti_palindrome", 0.9))
    assert found.told == "asymmetric_palindrome"


@pytest.mark.parametrize(
    ("a", "b"),
    [
        ("symmetric_cycle", "symmetric_palindrome"),
        ("asymmetric_cycle", "asymmetric_palindrome"),
        ("anti_phase", "anti_palindrome"),
    ],
)
def test_between_cycle_and_palindrome_confidence_decides(a, b):
    assert verdict(WALK, (100, 200, a, 0.6), (100, 200, b, 0.7)).told == b
    assert verdict(WALK, (100, 200, a, 0.7), (100, 200, b, 0.6)).told == a


def test_a_hold_within_a_movement_and_the_movement_are_both_right():
    whole = labelled("asymmetric_cycle", 0, 300)
    hold = labelled("stillness", 100, 160)
    told = spans((0, 300, "asymmetric_cycle", 0.95), (105, 155, "stillness", 0.7))
    assert [found.agrees for found in evaluate_symmetry([whole, hold], told).verdicts] == [True, True]


@pytest.mark.parametrize("motif", ["symmetric_palindrome", "symmetric_cycle"])
def test_one_way_of_a_longer_symmetric_movement_is_a_symmetric_path(motif):
    assert verdict(RAISED, (100, 250, motif, 0.8)).agrees
    assert verdict(RAISED, (0, 200, motif, 0.8)).course_agrees
    assert not verdict(RAISED, (100, 249, motif, 0.8)).agrees
    assert not verdict(RAISED, (100, 400, "asymmetric_palindrome", 0.8)).agrees


def test_spans_beyond_what_the_labeller_saw_do_not_count():
    assert not verdict(RAISED, (100, 400, "symmetric_palindrome", 0.8), window=(100, 200)).agrees
    found = verdict(WALK, (0, 1000, "anti_phase", 0.8), (100, 200, "anti_palindrome", 0.7), window=(100, 200))
    assert found.agrees


def test_sides_and_course_alone():
    lopsided = verdict(WALK, (100, 200, "asymmetric_cycle", 0.9))
    assert (lopsided.agrees, lopsided.sides_agree, lopsided.course_agrees) == (False, False, True)
    returned = verdict(WALK, (100, 200, "anti_palindrome", 0.9))
    assert (returned.agrees, returned.sides_agree, returned.course_agrees) == (False, True, False)
    dribble = SymmetryLabel(100, 200, "one", "cycle", ("asymmetric_cycle", "anti_phase"))
    assert verdict(dribble, (100, 200, "anti_palindrome", 0.9)).sides_agree


def test_a_still_body_is_symmetric_by_what_is_told_beside():
    bow = labelled("symmetric_palindrome")
    still = (100, 200, "stillness", 0.9)
    assert not verdict(bow, still).sides_agree
    assert verdict(bow, still, (100, 200, "symmetric_path", 0.8)).sides_agree


def test_a_span_is_wrong_when_the_stretch_it_is_about_accepts_nothing_it_says():
    told = spans(
        (100, 200, "anti_phase", 0.9),  # right
        (110, 190, "asymmetric_cycle", 0.9),  # less, and true
        (100, 180, "anti_palindrome", 0.9),  # wrong
        (100, 140, "symmetric_path", 0.9),  # about a part of it only
        (100, 200, "stillness", 0.4),  # not told
        (100, 200, "path_repetition", 0.9),  # not of a whole course
    )
    scores = evaluate_symmetry([WALK], told)
    assert (scores.spans, scores.wrong_spans) == (3, 1)


def test_time_without_a_label_is_counted():
    told = spans((0, 150, "anti_phase", 0.9), (180, 320, "anti_phase", 0.9), (250, 400, "stillness", 0.9))
    scores = evaluate_symmetry([WALK], told, window=(50, 300))
    assert (scores.seconds, scores.unlabelled_s, scores.told_unlabelled_s) == (5.0, 3.0, 3.0)
    fewer = evaluate_symmetry([WALK], told[:1], window=(50, 300))
    assert fewer.told_unlabelled_s == 1.0


def test_the_order_of_spans_does_not_matter():
    rng = np.random.default_rng(3)
    starts = rng.integers(0, 200, 60)
    told = [
        (int(start), int(start + length), str(motif), float(confidence))
        for start, length, motif, confidence in zip(
            starts, rng.integers(5, 150, 60), rng.choice(list(SHOWS), 60), rng.random(60), strict=True
        )
    ]
    labels = [labelled(motif, 10 * k, 10 * k + 60) for k, motif in enumerate(SHOWS)]
    first = evaluate_symmetry(labels, spans(*told), window=(0, 250))
    assert first == evaluate_symmetry(labels, spans(*told[::-1]), window=(0, 250))
    assert first.spans


@pytest.mark.parametrize(
    "change",
    [
        {"sides": "both"},
        {"course": "round"},
        {"motifs": ("none",)},
        {"motifs": ("path_reversal",)},
        {"stop": 100},
    ],
)
def test_a_label_says_known_words(change):
    with pytest.raises(ParameterError):
        WALK.replace(**change)


def test_what_cannot_be_judged_is_refused():
    with pytest.raises(ParameterError, match="without a label"):
        evaluate_symmetry([], spans())
    with pytest.raises(ParameterError, match="within"):
        evaluate_symmetry([WALK], spans(), window=(0, 150))
    with pytest.raises(ParameterError, match="confidence"):
        evaluate_symmetry([WALK], spans((0, 10, "anti_phase", np.nan)))
