"""EAF of ELAN: what is written reads back, here and by pympi; times left out, references, tiers, hostile files."""

import itertools
import time
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pympi.Elan import Eaf

from leitmotion import io
from leitmotion.motion import FormatError, ParameterError, Segmentation

LETTER = st.characters(blacklist_categories=("Cs", "Cc", "Cn")) | st.sampled_from("\"',;\t\n\r &<>]")
LABEL = st.text(LETTER, max_size=12) | st.sampled_from(["]]>", " walk ", "<b>", "&amp;", "\r\n"])


@st.composite
def segmentations(draw):
    rate = draw(st.sampled_from([25.0, 30.0, 120.0, 119.88, 240.0]))
    spans = draw(st.lists(st.tuples(st.integers(0, 10**5), st.integers(1, 10**4), LABEL), max_size=6))
    spans = sorted((start, start + length, label) for start, length, label in spans)
    return Segmentation(
        [a for a, _, _ in spans], [b for _, b, _ in spans], tuple(c for _, _, c in spans), rate=rate
    )


@given(segmentation=segmentations(), tier=LABEL.filter(bool))
@settings(max_examples=80, deadline=None)
def test_what_is_written_reads_back_in_the_order_of_time(tmp_path_factory, segmentation, tier):
    path = io.write_annotations(segmentation, tmp_path_factory.mktemp("spans") / "spans.eaf", tier=tier)
    again = io.read_annotations(path, rate=segmentation.rate)
    assert np.isnan(again.scores).all()  # an EAF has no place for them
    assert [span[:3] for span in sorted(again)] == [span[:3] for span in sorted(segmentation)]


@given(segmentation=segmentations())
@settings(max_examples=30, deadline=None)
def test_another_reader_finds_the_same(tmp_path_factory, segmentation):
    path = io.write_annotations(segmentation, tmp_path_factory.mktemp("spans") / "spans.eaf", tier="moves")
    eaf = Eaf(str(path))
    found = []
    for name in eaf.get_tier_names():
        tier = sorted(eaf.get_annotation_data_for_tier(name))
        assert all(
            one[1] <= other[0] for one, other in itertools.pairwise(tier)
        )  # on a tier nothing overlaps
        found += tier
    expected = [
        (round(start * 1000 / segmentation.rate), round(stop * 1000 / segmentation.rate), label)
        for start, stop, label, _ in segmentation
    ]
    assert sorted(found) == sorted(expected)


def test_what_another_writer_wrote_is_read(tmp_path):
    eaf = Eaf()
    eaf.add_tier("moves")
    for start, stop, label in ((0, 500, "walk"), (500, 1500, 'say "hop"\n& <turn>'), (2000, 2500, "")):
        eaf.add_annotation("moves", start, stop, label)
    eaf.to_file(str(tmp_path / "theirs.eaf"))
    assert [span[:3] for span in io.read_annotations(tmp_path / "theirs.eaf", rate=120)] == [
        (0, 60, "walk"), (60, 180, 'say "hop"\n& <turn>'), (240, 300, "")
    ]  # fmt: skip


def test_the_file_is_an_eaf_3_and_names_its_medium(tmp_path):
    spans = Segmentation([0, 10], [20, 30], ("a", "b"), rate=25)
    path = io.write_annotations(spans, tmp_path / "spans.eaf", media=tmp_path / "my dance.mp4")
    root = ElementTree.parse(path).getroot()
    assert (root.tag, root.attrib["FORMAT"], root.attrib["VERSION"]) == ("ANNOTATION_DOCUMENT", "3.0", "3.0")
    assert [child.tag for child in root] == ["HEADER", "TIME_ORDER", "TIER", "TIER", "LINGUISTIC_TYPE"]
    assert root.find("HEADER").attrib["TIME_UNITS"] == "milliseconds"
    medium = root.find("HEADER/MEDIA_DESCRIPTOR").attrib
    assert medium["MEDIA_URL"].startswith("file:///")
    assert medium["MEDIA_URL"].endswith("/my%20dance.mp4")
    assert medium["MIME_TYPE"] == "video/mp4"
    times = [int(slot.attrib["TIME_VALUE"]) for slot in root.iter("TIME_SLOT")]
    assert times == sorted(times)
    types = {kind.attrib["LINGUISTIC_TYPE_ID"] for kind in root.iter("LINGUISTIC_TYPE")}
    assert {tier.attrib["LINGUISTIC_TYPE_REF"] for tier in root.iter("TIER")} <= types
    assert (
        path.read_bytes() == io.write_annotations(spans, path, media=tmp_path / "my dance.mp4").read_bytes()
    )


def test_a_label_that_xml_cannot_hold_is_refused(tmp_path):
    with pytest.raises(ParameterError, match=r"printable text, got 'a\\x00'"):
        io.write_annotations(Segmentation([0], [1], ("a\0",), rate=30), tmp_path / "spans.eaf")


# --- files of ELAN

SLOTS = {"ts1": 0, "ts2": None, "ts3": None, "ts4": 3000, "ts5": 4000, "ts6": 5000}
ALIGNED = [("a1", "ts1", "ts2", "one"), ("a2", "ts2", "ts3", "two"), ("a3", "ts3", "ts4", "three"),
           ("a4", "ts5", "ts6", "four")]  # fmt: skip


def eaf(tiers, slots=None, header='TIME_UNITS="milliseconds"'):
    order = "".join(
        f'<TIME_SLOT TIME_SLOT_ID="{name}"' + ("/>" if value is None else f' TIME_VALUE="{value}"/>')
        for name, value in (SLOTS if slots is None else slots).items()
    )
    body = "".join(f'<TIER TIER_ID="{name}">{"".join(held)}</TIER>' for name, held in tiers.items())
    return (
        f"<ANNOTATION_DOCUMENT><HEADER {header}/><TIME_ORDER>{order}</TIME_ORDER>{body}</ANNOTATION_DOCUMENT>"
    )


def aligned(own, begin, end, label):
    return (
        f'<ANNOTATION><ALIGNABLE_ANNOTATION ANNOTATION_ID="{own}" TIME_SLOT_REF1="{begin}" TIME_SLOT_REF2="{end}">'
        f"<ANNOTATION_VALUE>{label}</ANNOTATION_VALUE></ALIGNABLE_ANNOTATION></ANNOTATION>"
    )


def refers(own, parent, label, previous=""):
    before = f' PREVIOUS_ANNOTATION="{previous}"' if previous else ""
    return (
        f'<ANNOTATION><REF_ANNOTATION ANNOTATION_ID="{own}" ANNOTATION_REF="{parent}"{before}>'
        f"<ANNOTATION_VALUE>{label}</ANNOTATION_VALUE></REF_ANNOTATION></ANNOTATION>"
    )


def read(tmp_path, text, rate=10, **options):
    path = tmp_path / "labels.eaf"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return [span[:3] for span in io.read_annotations(path, rate=rate, **options)]


def test_slots_without_a_time_lie_evenly_between_their_neighbours(tmp_path):
    text = eaf({"moves": [aligned(*one) for one in ALIGNED]})
    assert read(tmp_path, text) == [(0, 10, "one"), (10, 20, "two"), (20, 30, "three"), (40, 50, "four")]


def test_slots_of_other_tiers_do_not_part_those_of_this_one(tmp_path):
    slots = {"ts1": 0, "x1": None, "ts2": None, "x2": 500, "ts4": 2000}
    tiers = {
        "a": [aligned("a1", "ts1", "ts2", "one"), aligned("a2", "ts2", "ts4", "two")],
        "b": [aligned("b1", "x1", "x2", "other")],
    }
    assert read(tmp_path, eaf(tiers, slots), tier="a") == [(0, 10, "one"), (10, 20, "two")]
    assert read(tmp_path, eaf(tiers, slots), tier="b") == [(2, 5, "other")]


def test_annotations_that_refer_to_others_have_their_span_or_share_it(tmp_path):
    tiers = {
        "words": [
            refers("w2", "a4", "second", "w1"),
            refers("w3", "a4", "third", "w2"),
            refers("w1", "a4", "first"),
        ],
        "notes": [refers("n1", "w2", "about the second")],
        "moves": [aligned(*one) for one in ALIGNED],
    }
    text = eaf(tiers)
    assert read(tmp_path, text, rate=30, tier="words") == [
        (120, 130, "first"), (130, 140, "second"), (140, 150, "third")
    ]  # fmt: skip
    assert read(tmp_path, text, rate=30, tier="notes") == [(130, 140, "about the second")]
    assert len(read(tmp_path, text, tier="*")) == 8


def test_several_tiers_are_named_and_one_is_chosen(tmp_path):
    tiers = {"moves": [aligned(*ALIGNED[0])], "speech": [aligned(*ALIGNED[3])], "empty": []}
    with pytest.raises(
        ParameterError, match=r"several tiers, 'moves', 'speech': choose one .*--tier NAME.*'\*'"
    ):
        read(tmp_path, eaf(tiers))
    assert read(tmp_path, eaf(tiers), tier="speech") == [(40, 50, "four")]
    assert read(tmp_path, eaf(tiers), tier="empty") == []
    with pytest.raises(ParameterError, match="no tier 'dance'; it has 'moves', 'speech', 'empty'"):
        read(tmp_path, eaf(tiers), tier="dance")
    assert read(tmp_path, eaf({**tiers, "speech": []})) == [(0, 15, "one")]


def test_an_annotation_shorter_than_a_frame_has_one(tmp_path):
    text = eaf({"a": [aligned("a1", "s", "t", "blink")]}, {"s": 1001, "t": 1004})
    assert read(tmp_path, text, rate=25) == [(25, 26, "blink")]


@pytest.mark.parametrize(("unit", "stop"), [("milliseconds", 1), ("PAL-frames", 40), ("NTSC-frames", 33)])
def test_older_files_count_in_frames_of_a_video(tmp_path, unit, stop):
    text = eaf({"a": [aligned("a1", "s", "t", "x")]}, {"s": 0, "t": 1000}, f'TIME_UNITS="{unit}"')
    assert read(tmp_path, text, rate=1) == [(0, stop, "x")]


@pytest.mark.parametrize(
    ("text", "match"),
    [
        ("<html/>", "expected an EAF of ELAN, found XML of 'html'"),
        ("<ANNOTATION_DOCUMENT>", "line 1: expected XML, found that it breaks there"),
        ("start,stop,label\n", "line 1: expected XML, found that it breaks there"),
        (b"\xff\xfe\x00", "expected XML"),
        ('<?xml version="1.0" encoding="UTF-99"?><a/>', "expected XML in a known encoding"),
        (eaf({}, header='TIME_UNITS="weeks"'), "times in milliseconds, found 'weeks'"),
        (eaf({}, {"ts1": "soon"}), "whole number as TIME_VALUE, found 'soon'"),
        (eaf({}, {"ts1": "9" * 5000}), "whole number as TIME_VALUE"),
        (eaf({"a": [aligned("a1", "ts1", "ts9", "x")]}), "slots of tier 'a' in TIME_ORDER, found no 'ts9'"),
        (eaf({"a": [aligned("a1", "ts6", "ts5", "x")]}), "stop after their start, found 'a1' from 5 to 4 s"),
        (eaf({"a": [refers("r1", "a9", "x")]}), "that 'r1' refers to, found no 'a9'"),
        (
            eaf({"a": [refers("r1", "r2", "x"), refers("r2", "r1", "x")]}),
            "that 'r1' refers to, found no 'r2'",
        ),
        (eaf({"a": [aligned("", "ts1", "ts4", "x")]}), "expected an ANNOTATION_ID"),
        ("<a>" * 100_000, "at most 64 deep"),
    ],
)
def test_faults_are_one_sentence(tmp_path, text, match):
    with pytest.raises(FormatError, match=match):
        read(tmp_path, text)


BOMB = (
    '<?xml version="1.0"?><!DOCTYPE a [<!ENTITY a0 "ha">'
    + "".join(f'<!ENTITY a{k} "{f"&a{k - 1};" * 10}">' for k in range(1, 12))
    + "]><ANNOTATION_DOCUMENT>&a11;</ANNOTATION_DOCUMENT>"
)
OUTSIDE = (
    '<!DOCTYPE a [<!ENTITY x SYSTEM "file:///etc/passwd">]><ANNOTATION_DOCUMENT>&x;</ANNOTATION_DOCUMENT>'
)


@pytest.mark.parametrize("text", [BOMB, OUTSIDE, OUTSIDE.encode("utf-16")], ids=["bomb", "outside", "utf-16"])
def test_document_types_and_entities_are_refused_at_once(tmp_path, text):
    began = time.perf_counter()
    with pytest.raises(FormatError, match="found a document type or entities"):
        read(tmp_path, text)
    assert time.perf_counter() - began < 1.0


def test_a_long_chain_of_references_is_read_in_time(tmp_path):
    count = 20_000
    chain = [refers(f"r{k}", f"r{k - 1}" if k else "a4", str(k)) for k in reversed(range(count))]
    began = time.perf_counter()
    spans = read(tmp_path, eaf({"moves": [aligned(*ALIGNED[3])], "chain": chain}), tier="chain")
    assert len(spans) == count
    assert time.perf_counter() - began < 3.0
