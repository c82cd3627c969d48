"""The sentences of the Symmetry view: true of what was found, and of that only."""

import pytest

from leitmotion.discovery import MOTIFS, SymmetrySpan
from leitmotion.discovery.symmetry_span import PAIRED
from leitmotion.view.symmetry_words import (
    CHIEF,
    TOLD,
    empty_symmetry,
    lane_words,
    span_name,
    span_sentence,
    span_tip,
    symmetry_lead,
    symmetry_title,
)
from leitmotion.view.words import Chip


def span(motif: str, start: int = 0, stop: int = 90, sure: float = 0.9, **more: object) -> SymmetrySpan:
    partner = (stop + 30, stop + 120) if motif in PAIRED else None
    return SymmetrySpan(motif, start, stop, sure, partner=partner, **more)  # type: ignore[arg-type]


def text(pieces: tuple[object, ...]) -> str:
    return "".join(piece.id if isinstance(piece, Chip) else str(piece) for piece in pieces)


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


@pytest.mark.parametrize(
    ("found", "title"),
    [
        ([("anti_phase", "A"), ("anti_palindrome", "C")], "Two ways of moving alternate sides"),
        ([("anti_phase", "A")], "One way of moving alternates sides"),
        ([("symmetric_cycle", "A")], "Both sides move together"),
        ([("symmetric_path", "")], "Both sides move together"),
        ([("asymmetric_cycle", "A")], "No side mirrors the other"),
        ([("asymmetric_cycle", "A"), ("reflected_path_repetition", "A")], "Movements come back mirrored"),
        ([("path_repetition", "A")], "No symmetry is clear here"),
        ([("stillness", "")], "No symmetry shows here"),
        ([], "No symmetry shows here"),
    ],
)
def test_the_title_says_what_was_found(found: list[tuple[str, str]], title: str) -> None:
    spans = [span(motif, 200 * k, 200 * k + 90) for k, (motif, _) in enumerate(found)]
    assert symmetry_title(spans, [letter for _, letter in found]) == title


def test_what_no_pattern_holds_is_counted_as_stretches_once_each() -> None:
    spans = [
        span("anti_phase", 0, 90),
        span("anti_phase", 200, 300),
        span("anti_palindrome", 210, 290),
        span("asymmetric_palindrome", 220, 240),
    ]
    letters = ["A", "", "", ""]
    assert symmetry_title(spans, letters) == "The sides alternate in two stretches"
    told = text(symmetry_lead(spans, letters))
    assert told == "A returns as its own mirror image."
    assert text(symmetry_lead(spans, [""] * 4)) == "Two stretches alternate sides."
    again = [span("asymmetric_cycle"), span("reflected_path_repetition")]
    told = text(symmetry_lead(again, ["A", ""]))
    assert told == "A favours one side. One stretch comes again with the sides exchanged."


def test_what_is_more_likely_wrong_than_right_is_not_said() -> None:
    spans = [span("anti_phase", sure=0.4)]
    assert symmetry_title(spans, ["A"]) == "No symmetry is clear here"
    assert "none is more likely right than wrong" in text(symmetry_lead(spans, ["A"]))


def test_a_pattern_is_told_once_by_what_it_is_most() -> None:
    spans = [span("anti_phase", 0, 200), span("asymmetric_cycle", 200, 260)]
    assert text(symmetry_lead(spans, ["A", "A"])) == "A returns as its own mirror image."


def test_the_lead_is_that_of_the_picture() -> None:
    spans = [
        span("anti_phase", 0, 90),
        span("symmetric_path", 100, 190),
        span("anti_phase", 200, 290),
        span("asymmetric_palindrome", 300, 390),
    ]
    told = symmetry_lead(spans, ["A", "B", "C", "D"])
    assert told[:4] == (Chip("A"), " and ", Chip("C"), " return as their own mirror image. ")
    assert text(told).endswith("B moves both sides together. D favours one side.")


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


def test_an_empty_result_gives_its_number_where_there_is_one() -> None:
    assert "more than 12.3 cm" in empty_symmetry(12.34, "cm")
    assert "Half of the time" not in empty_symmetry(None, "cm")
