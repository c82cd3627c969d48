"""Whatever is in a file: a recording or one sentence. ``tests/fuzz.py`` goes on for as long as one likes."""

import io as streams
import itertools
import json
import struct
import zipfile
from collections.abc import Iterator
from random import Random

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from fuzzing.law import bounded, check, check_labels, put
from fuzzing.seeds import LABELS, SEEDS, SPOILED, Files, amc, cuts, zipped
from fuzzing.spoil import DAMAGES, spoil
from leitmotion import io
from leitmotion.io import formats
from leitmotion.io.formats import FORMATS
from leitmotion.motion import LeitmotionError

EXAMPLES = 60  # of each format; they take half a minute together
REAL = 12  # of each real recording
QUICK = settings(
    max_examples=EXAMPLES,
    derandomize=True,
    deadline=None,
    database=None,
    suppress_health_check=list(HealthCheck),
)


def spoiled(name: str, files: Files, rng: Random) -> Files:
    target = SPOILED.get(name, next(iter(files)))
    return files | {target: spoil(files[target], rng)}


def test_every_format_that_is_read_has_a_seed():
    """Add a function to ``fuzzing/seeds.py`` that makes a small valid file, and its line in ``SEEDS``."""
    without = [
        form.name
        for form in FORMATS
        if form.module and not any(seed == form.name or seed.startswith(f"{form.name} ") for seed in SEEDS)
    ]
    assert without == []


@pytest.mark.parametrize("name", SEEDS)
def test_a_seed_is_a_recording_of_its_format(tmp_path, monkeypatch, name):
    told = []

    def recognise(head: bytes, extension: str = "") -> formats.Format | None:
        told.append(formats.recognise(head, extension))
        return told[-1]

    monkeypatch.setattr("leitmotion.io.sources.recognise", recognise)
    reading = io.open_recording(put(tmp_path, SEEDS[name]()))
    assert len(reading.recordings[0]) > 1
    expected = {"ASF": "AMC"}.get(name, name)
    assert expected.startswith(told[-1].name)


@pytest.mark.parametrize("name", SEEDS)
@QUICK
@given(rng=st.randoms(use_true_random=False))
def test_a_spoiled_file_gives_a_recording_or_a_sentence(name, rng):
    check(spoiled(name, SEEDS[name](), rng))


@pytest.mark.parametrize("name", LABELS)
@QUICK
@given(rng=st.randoms(use_true_random=False))
def test_spoiled_labels_are_labels_or_a_sentence(name, rng):
    check_labels(spoiled(name, LABELS[name](), rng))


@pytest.mark.data
def test_a_spoiled_real_recording_gives_a_recording_or_a_sentence(data):
    rng = Random(2008)
    for name, files in cuts(data).items():
        for _ in range(REAL):
            check(spoiled(name, files, rng))


def every_cut(content: bytes) -> Iterator[bytes]:
    """The beginnings of a file, up to each of its first bytes and then up to ever fewer."""
    for stop in itertools.accumulate(itertools.repeat(1), lambda a, _: a + max(1, a // 40)):
        if stop >= len(content):
            return
        yield content[:stop]


@pytest.mark.parametrize("name", SEEDS)
def test_a_file_cut_anywhere_gives_a_recording_or_a_sentence(name):
    files = SEEDS[name]()
    target = SPOILED.get(name, next(iter(files)))
    for content in every_cut(files[target]):
        check(files | {target: content})


ROWS = {
    name: make
    for name, make in SEEDS.items()
    if name.startswith(("AMC", "TRC", "OpenSim", "Qualisys", "UI-PRMD", "Kinect", "Motive", "Nexus", "DeepLabCut",
                        "table", "BVH of"))
    and not name.endswith(".zip")
}  # fmt: skip
"""Seeds of texts with a row a frame."""


@pytest.mark.parametrize("name", ROWS)
def test_a_text_that_ends_within_its_last_row_is_a_warning_or_a_sentence(tmp_path, name):
    """Wherever the cut lies before the last cell; of a cut within its digits a few rows tell nothing."""
    files = ROWS[name]()
    target = next(iter(files))
    content = files[target]
    whole = content.rstrip()
    begin = whole.rfind(b"\n") + 1
    cells = [k for k in range(begin, len(whole)) if whole[k : k + 1] in b" ,;\t"]
    usual = len(io.open_recording(put(tmp_path, files)).warnings)
    first = begin + 1 + content[begin:].startswith(b'"')  # a quote alone holds nothing
    for stop in range(first, cells[-1] + 1):
        try:
            reading = io.open_recording(put(tmp_path, files | {target: content[:stop]}))
        except LeitmotionError:
            continue
        assert len(reading.warnings) > usual, content[begin:stop]


RUBBISH = {
    "nothing": b"",
    "blanks": b" \r\n\t\n",
    "zeros": bytes(5000),
    "ones": b"\xff" * 5000,
    "every byte": bytes(range(256)) * 20,
    "noise": np.random.default_rng(6).bytes(5000),
    "brackets": b"[" * 100_000,
    "braces": b'{"a":' * 100_000,
    "words": b"word " * 2000,
    "numbers": b"1 2 3\n" * 2000,
    "a long line": b"7," * 100_000,
    "a page": b"<!DOCTYPE html><html><body>404</body></html>",
    "lines": b"\n" * 100_000,
    "nan": b"nan,nan,nan\n" * 100,
}


@pytest.mark.parametrize("rubbish", RUBBISH)
def test_rubbish_of_every_ending_gives_a_sentence(rubbish):
    for extension in [*io.EXTENSIONS, "", ".zip", ".gz"]:
        check({f"clip{extension}": RUBBISH[rubbish]})
    for extension in (".csv", ".json", ".eaf", ".txt"):
        check_labels({f"labels{extension}": RUBBISH[rubbish]})


def test_every_damage_changes_something():
    content = SEEDS["table"]()["clip.csv"]
    for damage in DAMAGES:
        assert any(damage(content, Random(seed)) != content for seed in range(20)), damage


def test_the_law_catches_what_it_should(monkeypatch):
    """The checker itself: a warning, an infinity, a hang, a flood and a foreign error each break it."""
    files = SEEDS["table"]()

    def fails_by(make: object) -> bool:
        monkeypatch.setattr(io, "open_recording", make)
        try:
            check(files)
        except BaseException:
            return True
        return False

    def hang(_: object) -> None:
        with bounded(seconds=0.2):
            while True:
                pass

    assert not fails_by(io.open_recording)
    assert fails_by(lambda _: np.float64(1e300) * np.float64(1e300))
    assert fails_by(lambda _: [][0])
    assert fails_by(hang)
    assert fails_by(lambda _: np.ones(1 << 29))


# --- what was found, each as small as it gets


def members() -> dict[str, bytes]:
    """What an archive of ours holds."""
    with zipfile.ZipFile(streams.BytesIO(SEEDS["archive of points"]()["clip.npz"])) as box:
        return {name: box.read(name) for name in box.namelist()}


def archive(header: bytes) -> bytes:
    """An archive of ours with another header."""
    return zipped(members() | {"header.npy": header})


def signalling() -> bytes:
    """An archive of ours whose last number is a NaN that signals."""
    return zipped(members() | {"a0.npy": members()["a0.npy"][:-8] + struct.pack("<Q", 0x7FF0000000000001)})


def but(name: str, old: bytes, new: bytes, file: str = "") -> bytes:
    """The file of a seed, something in it replaced."""
    files = SEEDS[name]()
    content = files[file or next(iter(files))]
    assert old in content
    return content.replace(old, new)


def unseen(first: int) -> bytes:
    """An array of joints in pixels whose coordinates from one of them on are NaN."""
    places = np.full((4, 17, 3), 100.0)
    places[..., first:] = np.nan
    file = streams.BytesIO()
    np.save(file, places)
    return file.getvalue()


AMC = amc()["s_01.amc"]
SHAPE = b"(4, 22, 3)"
FOUND = {
    "a header that is no array": ("clip.npz", archive(b"rubbish")),
    "a header without end": ("clip.npy", but("NumPy array", b"}", b"(")),
    "a header of Python 2": ("clip.npy", but("NumPy array", SHAPE, b"(4L,22L,3)")),
    "a size beyond all": ("clip.npy", but("NumPy array", SHAPE, b"(10**99,3)")),
    "a magic that is none": ("clip.npy", but("NumPy array", b"NUMPY", b"NUMPa")),
    "a member without a name": ("pack.zip", zipped({"": b"x", "clip.bvh": b"x"})),
    "a frame time of nothing": ("clip.bvh", but("BVH of a skeleton", b"Time: 0", b"Time: 1e-320 ")),
    "a root without an axis": ("s_01.amc", AMC, "s.asf", but("AMC", b"axis XYZ", b"axis", "s.asf")),
    "a long direction": ("s_01.amc", AMC, "s.asf", but("AMC", b"0 1 0", b"0 1e300 0", "s.asf")),
    "a count that is no digit": ("clip.trc", but("TRC", b"\t6\t2", "\t²\t2".encode())),
    "a blank line first": ("clip.txt", b"\n1\n" + SEEDS["NTU RGB+D"]()["clip.skeleton"]),
    "tracked by nothing": ("clip.skeleton", but("NTU RGB+D", b"0.9 2", b"0.9 nan")),
    "a return within a cell": ("clip.csv", but("Nexus CSV", b"Ann:A", b"A\rA")),
    "two lines of three": ("clip.csv", b"scorer,net\nbodyparts,nose\n"),
    "a third of a point": ("clip.csv", but("table of points", b"LANK_z", b"LANK_w")),
    "a place beyond all": ("clip.json", but("poses of AlphaPose", b"100.5", b"1e300")),
    "a rate of nothing": ("clip.csv", b"# rate: 1e-320\ntime,A_x,A_y,A_z\n0,1,2,3\n1,1,2,3\n"),
    "steps of nothing": ("clip.csv", b"time,A_x,A_y,A_z\n0,1,2,3\n1e-320,1,2,3\n2e-320,1,2,3\n"),
    "steps without end": ("clip.csv", b"time,A_x,A_y,A_z\n0,1,2,3\n1e149,1,2,3\n2e149,1,2,3\n"),
    "a time beyond all": ("clip.csv", b"time,A_x,A_y,A_z\n0,1,2,3\n1e140,1,2,3\n2e-9,1,2,3\n3e-9,1,2,3\n"),
    "a NaN that signals": ("clip.npz", signalling()),
    "the last byte missing": ("clip.npz", SEEDS["archive of points"]()["clip.npz"][:-1]),
    "an array of nobody": ("clip.npy", unseen(2)),
    "an array of no depths": ("clip.npy", unseen(1)),
    "confidences of nobody": (
        "clip.json",
        json.dumps([{"image_id": "1.jpg", "keypoints": [5.0, 6.0, None] * 17}]).encode(),
    ),
}


@pytest.mark.parametrize("what", FOUND)
def test_what_was_found(what):
    parts = FOUND[what]
    check(dict(zip(parts[::2], parts[1::2])))


FOUND_IN_LABELS = {
    "a mark and nothing": ("labels.csv", b"\xef\xbb\xbf"),
    "an encoding of nobody": ("labels.eaf", b'<?xml version="1.0" encoding="UTF1000"?><A/>'),
    "digits that are none": ("mocap.txt", "86 ²\nwalk 1 2 3\n".encode()),
}


@pytest.mark.parametrize("what", FOUND_IN_LABELS)
def test_what_was_found_in_labels(what):
    check_labels(dict([FOUND_IN_LABELS[what]]))
