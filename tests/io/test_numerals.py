"""Numbers in text: bit for bit what Python's float reads."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from leitmotion.io.numerals import read_rows
from leitmotion.io.reading import Source
from leitmotion.motion import FormatError


def rows(text, columns, **kwargs):
    return read_rows(Source(Path("table.txt"), text.encode()), 0, columns, **kwargs)


SPELLINGS = st.one_of(
    st.floats(-1e149, 1e149).map(repr),
    st.floats(-1e6, 1e6).map(lambda x: f"{x:.6f}"),
    st.floats(-1e6, 1e6).map(lambda x: f"{x:.5e}"),
    st.from_regex(r"[+-]?[0-9]{1,25}(\.[0-9]{0,25})?([eE][+-]?[0-9]{1,2})?", fullmatch=True),
    st.from_regex(r"[+-]?\.[0-9]{1,25}([eE][+-]?[0-9]{1,2})?", fullmatch=True),
)


@given(st.lists(SPELLINGS, min_size=1, max_size=12))
@example(["0.1", "-0.0", "9007199254740993", "1e22", "1e23", "123456789012345678901234567890"])
@example(["-1.39149e-015", "5e-324", "9.976931348623157e149", "0.00000000000000000000000000001", ".5", "5."])
@settings(max_examples=300, deadline=None)
def test_every_number_is_read_as_float_reads_it(words):
    read = rows(" ".join(words) + "\n", len(words)).values[0]
    expected = np.array([float(word) for word in words])
    assert read.tobytes() == expected.tobytes()


@pytest.mark.parametrize("word", ["1e150", "-1.7976931348623157e308", "9" * 151])
@pytest.mark.parametrize("missing", [False, True])
def test_a_number_whose_square_is_infinite_is_refused(word, missing):
    with pytest.raises(FormatError, match=r"expected a number below 1e\+150, found"):
        rows(f"1 {word}\n", 2, missing=missing)


@pytest.mark.parametrize("ending", ["\n", "\r\n", "\n\n", "\r\n \t\r\n", ""])
def test_line_endings_blank_lines_and_tabs_do_no_harm(ending):
    text = f"1 2\t3{ending or chr(10)}  4\t5 6 {ending}"
    np.testing.assert_array_equal(rows(text, 3).values, [[1, 2, 3], [4, 5, 6]])


def test_a_short_last_row_is_left_out_and_told():
    read = rows("1 2 3\n4 5", 3)
    assert read.cut
    np.testing.assert_array_equal(read.values, [[1, 2, 3]])
    assert rows("1 2 3\n4 5\n", 3).cut


@pytest.mark.parametrize("text", ["1 2 3\n4 5\n6 7 8\n", "1 2 3\n4 5 6 7\n6 7 8\n"])
def test_a_row_of_another_length_is_an_error_with_its_line(text):
    with pytest.raises(FormatError, match=r"line 2: expected 3 numbers in the row"):
        rows(text, 3)


@pytest.mark.parametrize("word", ["abc", "1_0", "nan", "inf", "1.#IND", "0x10", "1e", "--1", "1e400"])
def test_what_is_no_number_is_an_error_with_its_line(word):
    with pytest.raises(FormatError, match=r"table.txt, line 2: expected a number, found"):
        rows(f"1 2\n3 {word}\n", 2)


@pytest.mark.parametrize("word", ["", "nan", "NaN", "1.#IND", "-1.#IND", "1.#QNAN", "NA", "null"])
@pytest.mark.parametrize("delimiter", [",", "\t", ";"])
def test_missing_cells_are_nan_where_they_may_be(word, delimiter):
    text = delimiter.join(["1", word, "3"]) + "\n" + delimiter.join([word, "5", word]) + "\n"
    expected = [[1, np.nan, 3], [np.nan, 5, np.nan]]
    np.testing.assert_array_equal(rows(text, 3, delimiter=delimiter, missing=True).values, expected)


def test_a_cell_of_words_keeps_its_column():
    read = rows("a b c,1\n  d e,2\n", 2, delimiter=",", missing=True, wanted=[1])
    np.testing.assert_array_equal(read.values[:, 1], [1, 2])
    with pytest.raises(FormatError, match="line 1"):
        rows("1 2,3\n", 2, delimiter=",", missing=True)


def test_short_rows_of_a_table_end_in_missing_cells():
    read = rows("1\t2\t3\n4\n\n\t\t6\n", 3, delimiter="\t", missing=True)
    np.testing.assert_array_equal(read.values, [[1, 2, 3], [4, np.nan, np.nan], [np.nan, np.nan, 6]])


@pytest.mark.parametrize(
    ("delimiter", "last"),
    [(",", "7,8"), (",", "7,8\n"), ("\t", "7\t8"), (" ", "7 8"), (",", "7,n"), (",", "7"), ("\t", "7\t1e")],
)
def test_a_last_row_of_fewer_cells_than_all_others_is_left_out_and_told(delimiter, last):
    text = (
        "1,2,3\n4,5,\n\n4,,6\n".replace(",", delimiter) if delimiter != " " else "1 2 3\n4 5 nan\n4 nan 6\n"
    )
    read = rows(text + last, 3, delimiter=delimiter, missing=True)
    warnings = []
    read.tell_cut(Source(Path("table.txt"), (text + last).encode()), warnings)
    assert len(read.values) == 3
    assert warnings == ["The file ends within its row 4; the whole rows before it were read."]


@pytest.mark.parametrize(
    "text",
    [
        "1,2,3\n4,5,6",  # nothing follows the last row: many programs leave the line feed out
        "1,2,3\n4,5,",  # the last point is unseen in a table of few rows
        "1,2\n4,5\n",  # no row has the last column
        "1,2,3\n4\n5\n",  # rows are short, whichever
        "1,2,3,\n4,5,6",  # what ends the others is no cell
        "4,5",  # nothing to compare with
        "1.25,0.5,2.5\n" * 19 + "1.25,0.5,2",  # too few rows to tell how the writer rounds
        "1.25,0.5,2.5\n" * 30 + "1.25,0.5,2\n",  # a line feed follows
        "1.25,0.5,2.5\n" * 30 + "1.25,0.5,2.75",
        "1.25,0.5,2.5\n" + "1.25,0.5,2.25\n" * 18 + "1,1,1.5\n1,1,1",
        "1,1,7\n" * 30 + "1,1,7",
    ],
)
def test_a_last_row_that_may_be_whole_is_read(text):
    read = rows(text, text.partition("\n")[0].count(",") + 1, delimiter=",", missing=True)
    assert not read.cut
    assert len(read.values) == text.rstrip().count("\n") + 1


@pytest.mark.parametrize("last", ["0.12", "0.1", "0.", "0", "-", ""])
def test_a_last_number_with_fewer_decimals_than_all_others_is_cut(last):
    text = "".join(f"{k},{k / 7:.3f}\n" for k in range(40)) + f"40,{last}"
    read = rows(text, 2, delimiter=",", missing=True)
    assert read.cut
    assert len(read.values) == 40


@pytest.mark.parametrize("last", ["1.25e-0", "1.25e-", "1.25e", "1.25", "1.2"])
def test_a_last_number_with_a_shorter_exponent_than_all_others_is_cut(last):
    text = "".join(f"{k / 7:.2e} {k / 7:.2e}\n" for k in range(40)) + f"1.25e-01 {last}"
    assert len(rows(text, 2, missing=True, whole=True).values) == 40
