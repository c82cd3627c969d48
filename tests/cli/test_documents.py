"""The parts of a document."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from leitmotion.cli.documents import as_line, plain, rounded, stretch


@given(st.integers(0, 10**6), st.integers(1, 10**6), st.sampled_from([16, 29.97, 30, 100, 119.88, 120, 480]))
def test_seconds_of_a_stretch_name_its_frames_again(start: int, length: int, rate: float) -> None:
    made = stretch(start, start + length, rate=rate)
    assert list(made) == ["start", "stop", "start_s", "stop_s", "label", "score"]
    assert round(made["start_s"] * rate) == start
    assert round(made["stop_s"] * rate) == start + length


@pytest.mark.parametrize("score", [np.nan, np.inf, -np.inf])
def test_a_score_that_nobody_gave_is_null(score: float) -> None:
    assert stretch(0, 1, rate=1.0, score=score)["score"] is None


def test_values_become_plain_json() -> None:
    held = {
        "a": np.float32(0.1),
        "b": np.arange(3),
        "c": (np.nan, [np.inf]),
        "d": Path("x"),
        "e": np.bool_(True),
        "f": {"z", "y"},
        1: None,
    }
    assert json.loads(as_line(plain(held))) == {
        "a": 0.100000001,
        "b": [0, 1, 2],
        "c": [None, [None]],
        "d": "x",
        "e": True,
        "f": ["y", "z"],
        "1": None,
    }


def test_a_document_is_one_line_whatever_it_holds() -> None:
    assert "\n" not in as_line({"path": "two\nlines \u2028 ü"})


@given(st.floats(allow_nan=False, allow_infinity=False, allow_subnormal=False))
def test_rounding_keeps_nine_digits(value: float) -> None:
    assert rounded(value, significant=9) == pytest.approx(value, rel=1e-8)
