"""What a search for patterns wrote is read again as it was; what is none is refused in a sentence."""

import json

import numpy as np
import pytest

from leitmotion.io import (
    rate_of,
    read_annotations,
    read_answers,
    read_cycles,
    read_unlabelled,
    write_annotations,
)
from leitmotion.motion import DataError, FormatError, ParameterError, Segmentation

DOCUMENT = {
    "leitmotion": "0.1.0",
    "verb": "patterns",
    "source": [{"path": "a/dance.bvh", "sha256": "0" * 64, "frames": 900, "rate": 30.0, "seconds": 30.0}],
    "parameters": {},
    "warnings": [],
    "result": {
        "patterns": [{"id": "A", "occurrences": [{"start": 0, "stop": 60}, {"start": 60, "stop": 120}]}],
        "pairs": [{"pattern": "A", "a": {"start": 0, "stop": 60}, "b": {"start": 61, "stop": 120}}],
    },
}
TABLE = """recording,start,stop,action,cycles,least,most
a/one.amc,0,300,walk,4,3,5
b/one.amc,0,200,jump,1,1,1
a/two.amc,10,100,kick,2,,
a/two.amc,100,400,walk,,,
"""


@pytest.fixture
def written(tmp_path):
    def write(name, text):
        (tmp_path / name).write_text(text, encoding="utf-8")
        return tmp_path / name

    return write


def test_a_document_gives_occurrences_pairs_and_the_recording(written):
    (answer,) = read_answers(written("found.json", json.dumps(DOCUMENT)))
    assert (answer.recording, answer.frames, answer.occurrences.rate) == ("a/dance.bvh", 900, 30.0)
    assert [tuple(one)[:3] for one in answer.occurrences] == [(0, 60, "A"), (60, 120, "A")]
    assert answer.pairs.tolist() == [[0, 60, 61, 120]]


def test_a_list_and_a_document_a_line_are_one_answer_each(written):
    assert len(read_answers(written("list.json", json.dumps([DOCUMENT] * 3)))) == 3
    assert len(read_answers(written("lines.json", "\n".join([json.dumps(DOCUMENT)] * 2)))) == 2


def test_nothing_found_is_an_answer(written):
    nothing = DOCUMENT | {"result": {"patterns": [], "pairs": [], "nearest_miss": "none"}}
    (answer,) = read_answers(written("found.json", json.dumps(nothing)))
    assert (len(answer.occurrences), answer.pairs.shape) == (0, (0, 4))


def test_a_table_gives_each_recording_and_tells_the_rate(written):
    rows = ["path,pattern,occurrence,start,stop,start_s,stop_s,score,kind,cycles"]
    rows += [f"{name}.bvh,A,1,30,90,1.0,3.0,0.9,cyclic,7" for name in ("one", "two")]
    path = written("found.csv", "\n".join(rows))
    one, two = read_answers(path)
    assert (one.recording, two.recording, one.pairs) == ("one.bvh", "two.bvh", None)
    assert (one.occurrences.rate, one.occurrences.stops.tolist()) == (30.0, [90])
    assert np.isnan(read_cycles(path, trial="one")).all()  # those of whole patterns are none of a stretch


@pytest.mark.parametrize("rate", [30.0, 120.0, 59.94, 23.976])
def test_the_rate_is_that_of_frames_and_seconds(tmp_path, rate):
    spans = Segmentation([0, 4000], [4000, 9001], ("a", "b"), rate=rate)
    for name in ("labels.csv", "labels.json"):
        assert rate_of(write_annotations(spans, tmp_path / name)) == pytest.approx(rate, rel=1e-6)


def test_an_elan_file_needs_a_rate(tmp_path):
    path = write_annotations(Segmentation([0], [60], ("A",), rate=120), tmp_path / "found.eaf")
    with pytest.raises(ParameterError, match="does not tell the frame rate"):
        read_answers(path)
    assert read_answers(path, rate=60)[0].occurrences.stops.tolist() == [30]


@pytest.mark.parametrize(
    ("document", "error", "message"),
    [
        (
            {"error": {"message": "There is no file x."}},
            FormatError,
            "no answer but an error: There is no file x.",
        ),
        ({"result": {"segments": []}}, FormatError, "expected what `leitmotion patterns` writes"),
        ([1], FormatError, "expected what `leitmotion patterns` writes"),
        (
            DOCUMENT | {"parameters": {"window": {"start": 3, "stop": 9}}},
            DataError,
            "about a part of a recording",
        ),
        (
            DOCUMENT | {"result": {"patterns": [], "pairs": [{"a": {"start": 1}}]}},
            FormatError,
            "expected what `leitmotion patterns` writes",
        ),
    ],
)
def test_what_is_no_answer_is_refused(written, document, error, message):
    with pytest.raises(error, match=message):
        read_answers(written("found.json", json.dumps(document)))


def test_rows_of_one_recording_are_chosen_by_its_path_or_name(written):
    path = written("runs.csv", TABLE)
    assert read_annotations(path, rate=120, trial="/data/b/one.amc").labels == ("jump",)
    assert read_annotations(path, rate=120, trial="two").labels == ("kick", "walk")
    assert read_cycles(path, trial="a/one.amc") == [(4, 3, 5)]
    assert read_cycles(path, trial="two")[0] == (2, 2, 2)
    assert np.isnan(read_cycles(path, trial="two")[1]).all()
    for trial in (None, "three", "one"):
        with pytest.raises(FormatError, match="expected the stretches of one recording, found those of 3"):
            read_annotations(path, rate=120, trial=trial)


def test_a_count_that_is_no_number_is_told_with_its_line(written):
    with pytest.raises(FormatError, match="line 2: expected numbers as cycles, least and most, found many"):
        read_cycles(written("runs.csv", "start,stop,label,cycles\n0,9,walk,many\n"))


def test_spans_without_a_label_are_those_of_the_layout(written):
    aca = written("mocap.txt", "86 01\nwalk 500 550 600\njump 900 900 900\n")
    assert read_unlabelled(aca, rate=120) == [(500, 600)]
    assert read_unlabelled(aca, rate=60) == [(250, 300)]
    blocks = written("13_01.txt", "1 1 1 1 1 2 2 2 2 2 7 7 7 7 7")
    assert read_unlabelled(blocks, rate=120) == [(30, 90), (90, 150)]
    assert read_unlabelled(written("runs.csv", TABLE), rate=120) == []
