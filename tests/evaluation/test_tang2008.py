"""The rates of paper P: by hand, in its bounds, and what they refuse."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from leitmotion.evaluation import paper_error_rates
from leitmotion.motion import ParameterError


def test_by_hand():
    assert paper_error_rates(found=10, false=2, missed=2) == (0.2, 0.2)
    assert paper_error_rates(found=0, false=0, missed=3) == (0.0, 1.0)


def test_the_papers_pop_dance():
    """Table 2: 12.5 % and 0 %, which one false pair of nine gives."""
    assert paper_error_rates(9, 1, 0) == (0.125, 0.0)


@given(found=st.integers(0, 99), right=st.integers(0, 99), missed=st.integers(0, 99))
def test_true_pairs_times_the_rates_are_the_counts(found, right, missed):
    false = max(0, found - right)
    rates = paper_error_rates(found, false, missed)
    true = found - false + missed
    if true:
        assert rates.type_one * true == pytest.approx(false)
        assert rates.type_two * true == pytest.approx(missed)
        assert 0 <= rates.type_two <= 1
    else:
        assert all(math.isnan(rate) for rate in rates)


@pytest.mark.parametrize(
    ("counts", "complaint"),
    [
        ((-1, 0, 0), "found must be a number of pairs, 0 or more, got -1"),
        ((1, 0.5, 0), "false must be a number of pairs"),
        ((1, 0, math.nan), "missed must be a number of pairs"),
        ((2, 3, 0), "Of 2 pairs found, 3 cannot be false"),
    ],
)
def test_counts_must_be_counts(counts, complaint):
    with pytest.raises(ParameterError, match=complaint):
        paper_error_rates(*counts)
