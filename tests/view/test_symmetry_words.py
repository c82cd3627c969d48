"""What motifs are called, and how their stretches are told."""

from leitmotion.discovery import MOTIFS, SymmetrySpan
from leitmotion.discovery.symmetry_span import PAIRED
from leitmotion.view.symmetry_words import CHIEF, TOLD, lane_words, span_name, span_sentence, span_tip


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
    assert lane_words("asymmetric_palindrome", [span("asymmetric_palindrome", cyclic=True)]) == (
        "One side, out and back",
        "asymmetric palindrome, cyclic",
    )


def test_the_tip_says_all() -> None:
    walk = span("anti_phase", 30, 120, 0.823, marks=[30, 60, 90, 120], reason="near.")
    assert span_tip(walk, 30.0, "A") == (
        "A, alternates sides · 0:01.0 to 0:04.0 · 3 half-cycles of 1.00 s · confidence 0.82: near"
    )
    again = span("reflected_path_repetition", 30, 120)
    assert "0:01.0 to 0:04.0 · and 0:05.0 to 0:08.0" in span_tip(again, 30.0)
    assert span_name(walk, 30.0, "A", 0, 3) == "Alternates sides, pattern A, 1 of 3, 1.0 to 4.0 seconds"
