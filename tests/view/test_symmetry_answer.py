"""The answer of the Symmetry view: true of what was found, and of that only."""

import pytest

from leitmotion.discovery import Symmetry, SymmetrySpan
from leitmotion.discovery.symmetry_span import PAIRED
from leitmotion.view.symmetry_answer import empty_symmetry, symmetry_lead, symmetry_title
from leitmotion.view.words import Chip

FRAMES = 1000


def span(motif: str, start: int = 0, stop: int = 90, sure: float = 0.9) -> SymmetrySpan:
    partner = (stop + 30, stop + 120) if motif in PAIRED else None
    return SymmetrySpan(motif, start, stop, sure, partner=partner)


def title(spans: list[SymmetrySpan], letters: list[str], frames: int = FRAMES) -> str:
    return symmetry_title(Symmetry(tuple(spans), 30.0, frames, {}), letters)


def lead(spans: list[SymmetrySpan], letters: list[str]) -> str:
    told = symmetry_lead(Symmetry(tuple(spans), 30.0, FRAMES, {}), letters)
    return "".join(piece.id if isinstance(piece, Chip) else str(piece) for piece in told)


@pytest.mark.parametrize(
    ("found", "told"),
    [
        ([("anti_phase", "A"), ("anti_palindrome", "C")], "Two ways of moving alternate sides"),
        ([("anti_phase", "A")], "One way of moving alternates sides"),
        ([("anti_phase", "")], "The sides alternate"),
        ([("symmetric_cycle", "A")], "Both sides move together in one stretch"),
        ([("symmetric_path", ""), ("symmetric_path", "")], "Both sides move together in two stretches"),
        ([("asymmetric_cycle", "A")], "No side mirrors the other"),
        ([("asymmetric_cycle", "A"), ("reflected_path_repetition", "A")], "Movements come back mirrored"),
        ([("path_repetition", "A")], "No symmetry is clear here"),
        ([("stillness", "")], "No symmetry shows here"),
        ([], "No symmetry shows here"),
    ],
)
def test_the_title_says_what_was_found(found: list[tuple[str, str]], told: str) -> None:
    spans = [span(motif, 200 * k, 200 * k + 90) for k, (motif, _) in enumerate(found)]
    assert title(spans, [letter for _, letter in found]) == told


def test_the_title_is_of_what_has_the_most_time() -> None:
    spans = [span("symmetric_path", 0, 600), span("asymmetric_cycle", 700, 800)]
    assert title(spans, ["", "A"]) == "Both sides move together"
    assert title(spans, ["", "A"], frames=2000) == "Both sides move together in one stretch"
    short = [span("symmetric_path", 0, 60), span("asymmetric_cycle", 100, 900)]
    assert title(short, ["", "A"]) == "One side is favoured in one stretch"
    assert lead(short, ["", "A"]) == "One stretch moves both sides together. A favours one side."


def test_what_no_pattern_holds_is_counted_as_stretches_once_each() -> None:
    spans = [
        span("anti_phase", 0, 90),
        span("anti_phase", 200, 300),
        span("anti_palindrome", 210, 290),
        span("asymmetric_palindrome", 220, 240),
    ]
    letters = ["A", "", "", ""]
    assert title(spans, letters) == "The sides alternate in two stretches"
    assert lead(spans, letters) == "A returns as its own mirror image."
    assert lead(spans, [""] * 4) == "Two stretches alternate sides."
    again = [span("asymmetric_cycle"), span("reflected_path_repetition")]
    assert lead(again, ["A", ""]) == "A favours one side. One stretch comes again with the sides exchanged."


def test_what_is_more_likely_wrong_than_right_is_not_said() -> None:
    spans = [span("anti_phase", sure=0.4)]
    assert title(spans, ["A"]) == "No symmetry is clear here"
    assert "none is more likely right than wrong" in lead(spans, ["A"])


def test_a_pattern_is_told_once_by_what_it_is_most() -> None:
    spans = [span("anti_phase", 0, 200), span("asymmetric_cycle", 200, 260)]
    assert lead(spans, ["A", "A"]) == "A returns as its own mirror image."


def test_the_lead_is_that_of_the_picture() -> None:
    motifs = ("anti_phase", "symmetric_path", "anti_phase", "asymmetric_palindrome")
    spans = [span(motif, 100 * k, 100 * k + 90) for k, motif in enumerate(motifs)]
    told = symmetry_lead(Symmetry(tuple(spans), 30.0, FRAMES, {}), list("ABCD"))
    assert told[:4] == (Chip("A"), " and ", Chip("C"), " return as their own mirror image. ")
    assert lead(spans, list("ABCD")).endswith(" B moves both sides together. D favours one side.")


def test_an_empty_result_gives_its_number_where_there_is_one() -> None:
    assert "more than 12.3 cm" in empty_symmetry(12.34, "cm")
    assert "Half of the time" not in empty_symmetry(None, "cm")
