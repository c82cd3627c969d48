"""The answer of the Symmetry view: true of what was found, and of that only."""

import numpy as np
import pytest

from leitmotion.body import Body
from leitmotion.discovery import Symmetry, SymmetrySpan
from leitmotion.discovery.symmetry_span import PAIRED
from leitmotion.view.symmetry_answer import empty_symmetry, no_symmetry, symmetry_lead, symmetry_title

FRAMES = 1000


def span(motif: str, start: int = 0, stop: int = 90, sure: float = 0.9, **more: object) -> SymmetrySpan:
    partner = (stop + 30, stop + 120) if motif in PAIRED else None
    return SymmetrySpan(motif, start, stop, sure, partner=partner, **more)  # type: ignore[arg-type]


def title(spans: list[SymmetrySpan], frames: int = FRAMES) -> str:
    return symmetry_title(Symmetry(tuple(spans), 30.0, frames, {}))


def lead(spans: list[SymmetrySpan], frames: int = FRAMES) -> str:
    return symmetry_lead(Symmetry(tuple(spans), 30.0, frames, {}))


@pytest.mark.parametrize(
    ("found", "told"),
    [
        (["anti_phase", "anti_palindrome"], "The sides alternate in two stretches"),
        (["anti_phase"], "The sides alternate in one stretch"),
        (["symmetric_cycle"], "Both sides move together in one stretch"),
        (["symmetric_path", "symmetric_path"], "Both sides move together in two stretches"),
        (["asymmetric_cycle"], "Nothing comes back mirrored clearly enough"),
        (["asymmetric_cycle", "reflected_path_repetition"], "One movement comes back mirrored"),
        (["reflected_path_repetition", "reflected_path_repetition"], "Movements come back mirrored"),
        (["path_repetition"], "No symmetry is clear here"),
        (["stillness"], "No symmetry shows here"),
        ([], "No symmetry shows here"),
    ],
)
def test_the_title_says_what_was_found(found: list[str], told: str) -> None:
    assert title([span(motif, 300 * k, 300 * k + 90) for k, motif in enumerate(found)]) == told


def test_the_title_is_of_what_has_the_most_time() -> None:
    spans = [span("symmetric_path", 0, 600), span("asymmetric_cycle", 700, 800)]
    assert title(spans) == "Both sides move together"
    assert title(spans, frames=2000) == "Both sides move together in one stretch"
    short = [span("symmetric_path", 0, 60), span("asymmetric_cycle", 100, 900)]
    assert title(short) == "Movements come back, but not mirrored"
    assert lead(short) == ("One stretch moves both sides together. One stretch comes back, but not mirrored.")


def test_which_side_moves_more_is_said() -> None:
    arm = {"left_share": 0.2, "links": ("right_humerus", "right_radius")}
    kick = {"left_share": 0.9, "links": ("left_femur",)}
    right = [span("asymmetric_palindrome", 0, 90, **arm), span("asymmetric_cycle", 100, 190, **arm)]
    assert title(right) == "The right side moves more in two stretches"
    assert lead(right) == "Two stretches move the right side more: arm."
    assert title(right, frames=200) == "The right side moves more"
    turns = [*right, span("asymmetric_palindrome", 200, 290, **kick)]
    assert title(turns) == "One side moves more, now the left, now the right"
    assert lead(turns) == (
        "One stretch moves the left side more: leg. Two stretches move the right side more: arm."
    )
    assert "side" not in lead([span("asymmetric_cycle", left_share=0.6)])


def test_stretches_are_counted_once_each() -> None:
    spans = [
        span("anti_phase", 0, 90),
        span("anti_phase", 200, 300),
        span("anti_palindrome", 210, 290),
        span("asymmetric_palindrome", 220, 240),
    ]
    assert title(spans) == "The sides alternate in two stretches"
    assert lead(spans) == "Two stretches alternate sides."
    again = [span("asymmetric_cycle"), span("reflected_path_repetition")]
    assert lead(again) == (
        "One stretch comes back, but not mirrored. One stretch comes again with the sides exchanged."
    )


def test_what_is_more_likely_wrong_than_right_is_not_said_but_as_the_nearest_miss() -> None:
    spans = [span("anti_phase", sure=0.4), span("anti_palindrome", sure=0.2)]
    assert title(spans) == "No symmetry is clear here"
    assert "none is more likely right than wrong" in lead(spans)
    assert lead(spans).endswith("The nearest miss, 0:00.0 to 0:03.0: alternates sides, confidence 0.40.")
    missed = [span("asymmetric_cycle", 0, 300), span("anti_phase", 30, 300, sure=0.16)]
    assert title(missed) == "Nothing comes back mirrored clearly enough"
    assert lead(missed) == (
        "One stretch comes back, but not mirrored. "
        "The nearest miss, 0:01.0 to 0:10.0: alternates sides, confidence 0.16."
    )
    assert "nearest" not in lead([*missed, span("symmetric_path", 500, 600)])


def test_a_held_pose_keeps_still() -> None:
    assert title([span("stillness", 0, 90)], frames=90) == "The body keeps still"
    assert lead([span("stillness", 0, 90)], frames=90).startswith("It moves too little")
    most = [span("stillness", 0, 70), span("stillness", 60, 75), span("path_repetition", 80, 90, sure=0.4)]
    assert title(most, frames=100) == "The body keeps still most of the time"
    assert lead(most, frames=100).startswith("It does so 75% of the time")
    assert title([*most, span("anti_phase", 76, 99)], frames=100) == "The sides alternate in one stretch"


def test_a_recording_without_symmetry_says_what_to_do() -> None:
    legs = ("pelvis", "left_hip", "right_hip", "left_knee", "right_knee")
    here = Body(legs, np.zeros((2, len(legs), 3)), np.zeros(2), rate=30.0, size=1.0)
    assert no_symmetry(here, "") == (
        "Symmetry is told from the trunk on, and no neck is known here. Name it in a map file (--map), if the "
        "recording has it."
    )
    flat = here.replace(positions=here.positions[..., :2])
    assert "with its depth" in no_symmetry(flat, "")


def test_an_empty_result_gives_its_number_where_there_is_one() -> None:
    assert "more than 12.3 cm" in empty_symmetry(12.34, "cm")
    assert "Half of the time" not in empty_symmetry(None, "cm")
