"""What motifs are called, and how their stretches are told."""

from leitmotion.discovery import MOTIFS, SymmetrySpan
from leitmotion.discovery.symmetry_span import PAIRED
from leitmotion.view.symmetry_words import (
    CHIEF,
    TOLD,
    lane_words,
    limb_words,
    motif_name,
    side_words,
    span_name,
    span_sentence,
    span_tip,
)


def span(motif: str, start: int = 0, stop: int = 90, sure: float = 0.9, **more: object) -> SymmetrySpan:
    partner = (stop + 30, stop + 120) if motif in PAIRED else None
    return SymmetrySpan(motif, start, stop, sure, partner=partner, **more)  # type: ignore[arg-type]


def test_every_motif_has_its_words() -> None:
    assert set(TOLD) == set(MOTIFS)
    assert not set(CHIEF) & set(PAIRED)
    names = [told.name for told in TOLD.values()]
    assert len(set(names)) == len(names)
    for motif in MOTIFS:
        sentence, picture = span_sentence(span(motif), 30.0)
        assert sentence.endswith(".")
        assert picture.startswith("In the matrix, ")
        assert ("{it}" in sentence) == (motif in CHIEF)
        assert "{when}" not in sentence


def test_lanes_carry_the_plain_name_and_the_term() -> None:
    assert lane_words("anti_phase", [span("anti_phase", cyclic=True)]) == (
        "Alternates sides",
        "anti-phase cycle",
    )
    assert lane_words("anti_phase", [span("anti_phase")]) == ("Alternates sides", "anti-phase")
    assert lane_words(
        "asymmetric_palindrome", [span("asymmetric_palindrome", cyclic=True, left_share=0.7)]
    ) == (
        "One side, out and back",
        "asymmetric palindrome, cyclic",
    )


def test_one_side_is_said_only_where_one_side_moves_more() -> None:
    arm = span("asymmetric_cycle", left_share=0.15, links=("right_humerus", "right_radius"))
    leg = span("asymmetric_palindrome", left_share=0.7, links=("left_tibia",))
    phrase = span("asymmetric_cycle", left_share=0.6)
    assert [motif_name(each) for each in (arm, leg, phrase)] == [
        "One side, repeating",
        "One side, out and back",
        "Comes round, not mirrored",
    ]
    assert motif_name(span("asymmetric_palindrome")) == "Out and back, not mirrored"
    assert lane_words("asymmetric_cycle", [arm])[0] == "One side, repeating"
    assert lane_words("asymmetric_cycle", [arm, phrase])[0] == "Comes round, not mirrored"
    assert side_words(arm) == "the right side moves more (85% of the way): arm"
    assert side_words(leg) == "the left side moves more (70% of the way): leg"
    assert side_words(phrase) == side_words(span("asymmetric_cycle")) == ""
    assert span_sentence(arm, 30.0)[0].endswith("image: the right side moves more (85% of the way): arm.")
    assert "side" not in span_sentence(phrase, 30.0)[0]
    assert "the left side moves more (70% of the way): leg" in span_tip(leg, 30.0)


def test_limbs_are_named_in_words() -> None:
    assert limb_words(("left_radius", "left_femur")) == "arm and leg"
    assert limb_words(()) == ""


def test_the_tip_says_all() -> None:
    walk = span("anti_phase", 30, 120, 0.823, marks=[30, 60, 90, 120], reason="near.")
    assert span_tip(walk, 30.0, "A") == (
        "A, alternates sides · 0:01.0 to 0:04.0 · 3 half-cycles of 1.00 s · confidence 0.82: near"
    )
    again = span("reflected_path_repetition", 30, 120)
    assert "0:01.0 to 0:04.0 · and 0:05.0 to 0:08.0" in span_tip(again, 30.0)
    assert span_name(walk, 30.0, "A", 0, 3) == "Alternates sides, pattern A, 1 of 3, 1.0 to 4.0 seconds"
