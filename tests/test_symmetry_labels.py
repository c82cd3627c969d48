"""The stretches whose symmetry was labelled by eye: laws of the tables, and that the recordings hold them."""

import csv
import sys
from itertools import groupby, pairwise
from pathlib import Path

import pytest

import leitmotion

BENCHMARKS = Path(__file__).resolve().parents[1] / "benchmarks"
LABELS = BENCHMARKS / "labels"
DRAWN = "symmetry_drawn.csv"
TABLES = ("symmetry_clips.csv", "symmetry_found.csv")
COLUMNS = ["recording", "start", "stop", "sides", "course", "repeats", "motifs", "what", "sure"]
MOTIFS = {
    "stillness": ("still", {"together", "one"}),
    "symmetric_path": (None, {"together"}),
    "path_reversal": ("out_and_back", {"together", "one", "alternate"}),
    "symmetric_cycle": (None, {"together"}),
    "asymmetric_cycle": (None, {"one"}),
    "symmetric_palindrome": (None, {"together"}),
    "asymmetric_palindrome": (None, {"one"}),
    "anti_phase": (None, {"alternate", "one"}),
    "anti_palindrome": (None, {"alternate"}),
}
"""The course and the sides that a motif asks for."""


def rows(name: str, columns: list[str]) -> list[dict[str, str]]:
    with open(LABELS / name, newline="") as file:
        table = csv.DictReader(file)
        assert table.fieldnames == columns
        return list(table)


def span(row: dict[str, str]) -> tuple[int, int]:
    return int(row["start"]), int(row["stop"])


@pytest.fixture
def benchmarks(data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LEITMOTION_DATA", str(data))
    monkeypatch.setattr(sys, "path", [str(BENCHMARKS), *sys.path])


@pytest.mark.parametrize("name", TABLES)
def test_a_row_says_known_words(name: str) -> None:
    for row in rows(name, COLUMNS):
        assert 0 <= span(row)[0] < span(row)[1], row
        assert row["sides"] in {"together", "alternate", "one"}, row
        assert row["course"] in {"still", "one_way", "out_and_back", "cycle"}, row
        assert int(row["repeats"]) >= 1, row
        assert row["what"], row
        assert row["sure"] in {"yes", "no"}, row


@pytest.mark.parametrize("name", TABLES)
def test_motifs_are_known_and_fit_the_sides_and_the_course(name: str) -> None:
    for row in rows(name, COLUMNS):
        motifs = row["motifs"].split("|")
        assert len(set(motifs)) == len(motifs), row
        assert motifs == ["none"] or set(motifs) <= MOTIFS.keys(), row
        assert (row["course"] == "still") == ("stillness" in motifs), row
        for course, sides in (MOTIFS[motif] for motif in motifs if motif != "none"):
            assert course in (None, row["course"]), row
            assert row["sides"] in sides, row


@pytest.mark.parametrize("name", TABLES)
def test_stretches_of_a_recording_stand_together_in_order(name: str) -> None:
    recordings = [key for key, _ in groupby(row["recording"] for row in rows(name, COLUMNS))]
    assert len(set(recordings)) == len(recordings)
    for a, b in pairwise(rows(name, COLUMNS)):
        assert a["recording"] != b["recording"] or span(a) < span(b), b


def test_each_drawn_clip_is_labelled_and_nothing_outside_of_it() -> None:
    clips = {row["recording"]: span(row) for row in rows(DRAWN, COLUMNS[:3])}
    labelled = rows("symmetry_clips.csv", COLUMNS)
    assert len(clips) >= 40
    assert clips.keys() == {row["recording"] for row in labelled}
    for row in labelled:
        start, stop = clips[row["recording"]]
        assert start <= span(row)[0], row
        assert span(row)[1] <= stop, row


def test_no_stretch_was_found_within_a_drawn_clip() -> None:
    clips = {row["recording"]: span(row) for row in rows(DRAWN, COLUMNS[:3])}
    for row in rows("symmetry_found.csv", COLUMNS):
        start, stop = clips.get(row["recording"], (0, 0))
        assert span(row)[1] <= start or span(row)[0] >= stop, row


@pytest.mark.data
def test_the_draw_can_be_repeated(benchmarks: None) -> None:
    from choose_symmetry_clips import clips

    assert clips() == [(row["recording"], *span(row)) for row in rows(DRAWN, COLUMNS[:3])]


@pytest.mark.data
@pytest.mark.parametrize("name", TABLES)
def test_the_recordings_hold_the_stretches(name: str, benchmarks: None) -> None:
    from recordings import locate

    last = {row["recording"]: span(row)[1] for row in sorted(rows(name, COLUMNS), key=span)}
    for recording, stop in last.items():
        assert stop <= len(leitmotion.embody(leitmotion.read(locate(recording))).positions), recording
