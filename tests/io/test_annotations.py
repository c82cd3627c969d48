"""Annotations: both ways, and the two layouts of public data sets."""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from leitmotion import io
from leitmotion.motion import FormatError, ParameterError, Segmentation

LETTER = st.characters(blacklist_categories=("Cs", "Cc")) | st.sampled_from("\"',;\t\n\r &<>]")
LABEL = st.text(LETTER, max_size=12) | st.sampled_from(
    ['say "walk"', " walk ", "a,b;c", "\r", "]]>", "NaN", "1.5"]
)


@pytest.mark.parametrize("extension", ["csv", "json"])
@given(
    spans=st.lists(
        st.tuples(st.integers(0, 10**6), st.integers(1, 10**4), LABEL, st.none() | st.floats(-1e6, 1e6)),
        max_size=6,
    ),
    rate=st.sampled_from([120.0, 30.0, 119.88, 30000 / 1001]),
)
@settings(max_examples=60, deadline=None)
def test_what_is_written_reads_back(tmp_path_factory, extension, spans, rate):
    path = tmp_path_factory.mktemp("spans") / f"spans.{extension}"
    segmentation = Segmentation(
        [s for s, _, _, _ in spans], [s + n for s, n, _, _ in spans], [label for _, _, label, _ in spans],
        [np.nan if score is None else score for _, _, _, score in spans], rate,
    )  # fmt: skip
    assert io.read_annotations(io.write_annotations(segmentation, path), rate=rate) == segmentation


def read(tmp_path, name, text, **options):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return io.read_annotations(path, **{"rate": 120, **options})


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.csv", "start,stop,label\n0,60,walk\n60,180,punch\n"),
        ("a.csv", "start_s,stop_s,label\n0,0.5,walk\n0.5,1.5,punch\n"),
        ("a.csv", "start,stop,label\n0,0.5,walk\n0.5,1.5,punch\n"),
        ("a.csv", "start;stop;label;score\r\n0;60;walk;\r\n60;180;punch;\r\n"),
        ("a.tsv", "Start\tEnd\tName\n0\t60\twalk\n60\t180\tpunch\n\n"),
        ("a.csv", "0,60,walk\n60,180,punch\n"),
        ("a.csv", '\ufeffstart,stop,label\n0,60,"walk"\n60,180,punch\n'),
        ("a.json", '[{"start": 0, "stop": 60, "label": "walk"}, {"start": 60, "stop": 180, "label": "punch"}]'),
        ("a.json", '{"segments": [{"start_s": 0, "stop_s": 0.5, "label": "walk"}, '
                   '{"start_s": 0.5, "stop_s": 1.5, "label": "punch"}]}'),
        ("a.json", '{"verb": "segment", "result": {"segments": [{"start": 0, "stop": 60, "label": "walk", '
                   '"score": null}, {"start": 60, "stop": 180, "label": "punch", "score": null}]}}'),
    ],
)  # fmt: skip
def test_spellings_of_one_annotation(tmp_path, name, text):
    assert read(tmp_path, name, text) == Segmentation([0, 60], [60, 180], ("walk", "punch"), rate=120)


def test_frames_of_another_rate_give_way_to_seconds(tmp_path):
    spans = Segmentation([0, 30], [30, 90], ("a", "b"), rate=30)
    for name in ("a.csv", "a.json"):
        path = io.write_annotations(spans, tmp_path / name)
        assert io.read_annotations(path, rate=120) == Segmentation([0, 120], [120, 360], ("a", "b"), rate=120)


@pytest.mark.parametrize(
    ("name", "text", "match"),
    [
        ("a.csv", '""\n', "expected a table of stretches, found empty lines"),
        ("a.csv", 'start,stop,label\n0,1,"' + "x" * 200_000, "found that a cell does not end"),
        ("a.csv", "from,to\n1,2\n", "line 1: expected the columns start, stop"),
        ("a.csv", "start,stop,label\n1,x,a\n", "line 2: expected a number as stop, found 'x'"),
        ("a.csv", "start,stop,label\n5,,a\n", "line 2: expected start and stop"),
        ("a.csv", "start,stop,label\n5,5,a\n", "stop after its start"),
        ("a.csv", "start,stop,label\n-5,5,a\n", "frame 0 or later"),
        ("a.csv", "start,stop,label\n0,inf,a\n", "finite stop"),
        ("a.csv", "start,stop,label\n0,99999999999999999999,a\n", "line 2: expected frames below"),
        ("a.txt", "86 01\nwalk 1 2² 3\njump 1 2 3\n", "line 2: expected a trial or a name"),
        ("a.json", "{", "no JSON"),
        (
            "a.csv",
            "start_s,stop_s\n0,1\n",
            r"line 1: expected a column label \(or pattern, or motif\), found start_s, stop_s",
        ),
        ("a.csv", "0,60\n60,90\n", "expected a column label"),
        (
            "a.csv",
            "path,pattern,start,stop\na,A,0,9\nb,A,0,9\n",
            "stretches of one recording, found those of 2",
        ),
        ("a.json", '{"result": {}}\n{"result": {}}\n', "one recording, found 2 answers"),
        ("a.json", '[{"result": {}}, {"result": {}}]', "one recording, found 2 answers"),
        ("a.json", '{"patterns": [{"id": "A"}]}', "expected a list of stretches"),
        ("a.json", '{"x": 1}', "expected a list of stretches"),
        ("a.json", "[1, 2]", "expected a list of stretches"),
        ("a.json", '[{"label": "x"}]', "stretch 1: expected start and stop"),
        ("a.txt", "86 01\nwalk 1 2 3\nrubbish\n", "line 3: expected a trial or a name"),
    ],
)
def test_faults_are_one_sentence(tmp_path, name, text, match):
    with pytest.raises(FormatError, match=match):
        read(tmp_path, name, text)


def test_found_patterns_are_labels(tmp_path):
    stretch = {"start": 10, "stop": 44, "start_s": 0.3333, "stop_s": 1.4667, "score": 0.5}
    later = {"start": 60, "stop": 75, "start_s": 2.0, "stop_s": 2.5, "score": None}
    patterns = [{"id": "A", "occurrences": [stretch, later]}, {"id": "B", "occurrences": [stretch]}]
    answer = json.dumps({"verb": "patterns", "result": {"patterns": patterns, "pairs": []}})
    table = (
        "path,pattern,occurrence,start,stop,start_s,stop_s,score,kind\n"
        "a.bvh,A,1,10,44,0.3333,1.4667,0.5,cyclic\na.bvh,A,2,60,75,2.0,2.5,,cyclic\n"
        "a.bvh,B,1,10,44,0.3333,1.4667,0.5,acyclic\n"
    )
    expected = Segmentation([10, 60, 10], [44, 75, 44], ("A", "A", "B"), [0.5, np.nan, 0.5], 30.0)
    assert read(tmp_path, "p.json", answer, rate=30) == expected
    assert read(tmp_path, "p.json", f"[{answer}]", rate=30) == expected
    assert read(tmp_path, "p.csv", table, rate=30) == expected
    assert read(tmp_path, "p.json", answer, rate=60).stops.tolist() == [88, 150, 88]


def test_other_extensions_are_not_written(tmp_path):
    with pytest.raises(ParameterError, match=r"\.csv, \.json or \.eaf, got '\.xlsx'"):
        io.write_annotations(Segmentation([], [], rate=30), tmp_path / "a.xlsx")


ACA = "86 01\nwalk 500 550 600\njump 1100 1150 1200\n\n86 02 \nwalk 980 1010 1100 \n"


def test_the_aca_layout_gives_ends_counted_from_one(tmp_path):
    expected = Segmentation([0, 550], [550, 1150], ("walk", "jump"), rate=120)
    assert read(tmp_path, "mocap.txt", ACA, trial="86_01") == expected
    assert read(tmp_path, "mocap.txt", ACA, trial="86 01") == expected
    at_60 = read(tmp_path, "mocap.txt", ACA, trial="86_01", rate=60)
    assert at_60.stops.tolist() == [275, 575]
    for trial in (None, "86_03"):
        with pytest.raises(ParameterError, match=r"it holds 86_01, 86_02. Choose one with --trial NAME"):
            read(tmp_path, "mocap.txt", ACA, trial=trial)


def test_block_labels_are_runs_with_names_beside(tmp_path):
    (tmp_path / "action_names.csv").write_text("id,name\n1,JumpJack\n6,Twist\n")
    spans = read(tmp_path, "13_29.txt", "1 1 1 6 6 9")
    assert spans == Segmentation([0, 36, 60], [36, 60, 72], ("JumpJack", "Twist", "9"), rate=120)
    assert read(tmp_path, "13_29.txt", "1 1 1 6 6 9", frames=62).stops.tolist() == [36, 60, 62]
    assert read(tmp_path, "13_29.txt", "1 1 1 6 6 9", frames=60).labels == ("JumpJack", "Twist")


@pytest.mark.data
def test_real_annotations_end_where_their_recordings_end(data):
    for trial, frames in {"86_01": 4579, "86_02": 10617}.items():
        spans = io.read_annotations(data / "cmu86" / "mocap.txt", rate=120, trial=trial)
        assert spans.stops[-1] == frames
        np.testing.assert_array_equal(spans.starts[1:], spans.stops[:-1])
    motion = io.read(data / "mocap6" / "13_29.amc")
    spans = io.read_annotations(data / "mocap6" / "13_29.txt", rate=120, frames=len(motion))
    assert (spans.labels[0], int(spans.stops[-1])) == ("JumpJack", len(motion))
    assert json.dumps(io.as_stretches(spans)[0])


@pytest.mark.parametrize("name", ["a.TextGrid", "a.anvil", "a.boris"])
def test_annotations_of_other_programs_are_one_sentence(tmp_path, name):
    (tmp_path / name).write_text('File type = "ooTextFile"\n')
    with pytest.raises(FormatError, match=r"annotations are not read\. Save them as CSV"):
        io.read_annotations(tmp_path / name, rate=30)
