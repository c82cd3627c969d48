"""Laws of the comparison with the stretches labelled by eye: perfect answers are right, and the splits stand."""

import importlib
from pathlib import Path

import pytest

from leitmotion.motion import Segmentation

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"


@pytest.fixture
def bench(monkeypatch):
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    made = importlib.reload(importlib.import_module("bench_symmetry_labels"))  # its caches empty
    monkeypatch.setattr(made, "cheap", lambda clip: dict.fromkeys(made.CHEAP, nothing()))
    return made


def nothing():
    return Segmentation([], [], rate=100.0)


def perfect(bench):
    """A detector that tells each label's first motif, of all clips of a recording."""

    def told(recording):
        spans = sorted(
            {
                (label.start, label.stop, label.motifs[0])
                for table in bench.TABLES
                for clip in bench.clips(table)
                if clip.recording == recording
                for label in clip.labels
                if label.motifs
            }
        )
        starts, stops, motifs = zip(*spans, strict=True) if spans else ((),) * 3
        return Segmentation(starts, stops, motifs, [0.8] * len(spans), rate=100.0)

    return told


def figure(rows, title, what):
    """The figure of a line of the table under a title."""
    titles = [k for k, row in enumerate(rows) if row[0] == title]
    return next(row[1] for row in rows[titles[0] :] if row[0] == what)


def test_perfect_answers_are_right_in_everything(bench, monkeypatch):
    monkeypatch.setattr(bench, "detected", perfect(bench))
    rows = bench.rows()
    for name in bench.NAMES.values():
        for split in bench.SPLITS:
            assert "100.0%" in figure(rows, f"{name}, {split}", "The motif agrees")
            assert figure(rows, f"{name}, {split}", "Wrong spans").startswith("0 of")
    for what, said, _ in bench.named():
        for part in said.split(", "):
            right, of = part.split()[1::2]
            assert right == of, what
    assert not list(bench.disagreements("both"))


def test_silence_is_right_only_where_no_motif_was_seen(bench, monkeypatch):
    monkeypatch.setattr(bench, "detected", lambda _: nothing())
    for table in bench.TABLES:
        for one in bench.judged(table):
            assert [found.agrees for found in one.verdicts] == [not label.motifs for label in one.clip.labels]
    of = sum(
        bool(label.motifs) for table in bench.TABLES for clip in bench.clips(table) for label in clip.labels
    )
    assert len(list(bench.disagreements("both"))) == of
    apart = [len(list(bench.disagreements(split))) for split in bench.SPLITS]
    assert sum(apart) == of
    assert min(apart)


def test_a_recording_that_is_refused_counts_as_silence_and_is_named(bench, monkeypatch):
    monkeypatch.setattr(bench, "detected", lambda _: None)
    first = bench.rows()[0]
    assert "pycgm/Movement_trial.c3d" in first[2]
    reported = [clip for clip in bench.clips("drawn") if clip.split == "reported"]
    silent = sum(not label.motifs for clip in reported for label in clip.labels)
    assert silent
    assert figure(bench.rows(), first[0], "The motif agrees").startswith(f"{silent} of")


def test_clips_of_one_recording_stand_on_one_side(bench):
    sides = {}
    for table in bench.TABLES:
        for clip in bench.clips(table):
            assert sides.setdefault(clip.recording, clip.split) == clip.split
    development = {name for name, split in sides.items() if split == "development"}
    assert {"mocap6/13_29.amc", "cmu86/86_01.amc", "cmu_bvh/jumping_jacks.bvh"} <= development
    assert not {"cmu_bvh/131_01.bvh", "mocap6/14_06.amc", "cmu_bvh/cmu_12_01_walk.bvh"} & development
    assert sum("HDM_bd_" in name for name in development) == 2
    assert all(("dataset-1" in name) == (name in development) for name in sides if "bandai" in name)


def test_every_check_by_name_asks_of_both_splits_together_at_least_once(bench, monkeypatch):
    monkeypatch.setattr(bench, "detected", lambda _: nothing())
    for what, said, _ in bench.named():
        assert sum(int(part.split()[-1]) for part in said.split(", ")) >= 1, what


def test_the_interval_is_over_clips_not_stretches(monkeypatch):
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    intervals = importlib.import_module("intervals")
    low, high = intervals.of_pooled_share([(9, 10), (0, 10), (10, 10), (10, 10)])
    assert low <= 29 / 40 <= high
    apart = intervals.of_share(29, 40)
    assert high - low > apart[1] - apart[0]
    assert intervals.of_pooled_share([(3, 3), (2, 2), (0, 0)]) == intervals.of_share(2, 2)
    assert intervals.of_pooled_share([(0, 3), (0, 2)]) == intervals.of_share(0, 2)
