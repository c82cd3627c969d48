"""Recordings that are packed: read as if they were not, and never trusted about their size."""

import bz2
import gzip
import io as streams
import lzma
import struct
import tarfile
import time
import zipfile

import pytest

from fuzzing.law import bounded
from fuzzing.seeds import SEEDS, amc, taped, zipped
from leitmotion import io
from leitmotion.io import tape
from leitmotion.io.containers import exists, is_archive, on_disk, recordings_in
from leitmotion.motion import DataError, FormatError

BVH = SEEDS["BVH of a skeleton"]()["clip.bvh"]
PACKERS = {".gz": gzip.compress, ".bz2": bz2.compress, ".xz": lzma.compress}
ONE = ["AMC", "BVH of a skeleton", "C3D", "TRC", "table", "archive of points"]


@pytest.fixture
def plain(tmp_path):
    (tmp_path / "clip.bvh").write_bytes(BVH)
    return io.open_recording(tmp_path / "clip.bvh")


def put(folder, name, content):
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)
    return path


@pytest.mark.parametrize("ending", PACKERS)
@pytest.mark.parametrize("seed", ONE)
def test_what_is_compressed_reads_as_it_does_unpacked(tmp_path, seed, ending):
    files = SEEDS[seed]()
    for name, content in files.items():
        put(tmp_path, name, content)
        put(tmp_path / "packed", name + ending, PACKERS[ending](content))
    first = next(iter(files))
    expected = io.open_recording(tmp_path / first)
    reading = io.open_recording(tmp_path / "packed" / (first + ending))
    assert reading.recordings == expected.recordings  # the name among the rest
    assert reading.warnings == expected.warnings


@pytest.mark.parametrize("seed", [*ONE, "poses of OpenPose", "UI-PRMD"])
def test_what_is_zipped_reads_as_it_does_unpacked(tmp_path, seed):
    files = SEEDS[seed]()
    paths = [put(tmp_path, name, content) for name, content in files.items()]
    pack = put(tmp_path, "pack/pack.zip", zipped({f"a/b/{name}": content for name, content in files.items()}))
    expected = io.read_all(paths[0])
    assert io.read_all(pack) == expected
    assert io.read_all(pack / "a" / "b" / paths[0].name) == expected
    assert io.read_all(f"{pack}[2:5]") == [one[2:5] for one in expected]


@pytest.mark.parametrize("name", ["clip.gz", "clip", "clip.bvh", "clip.bvh.gz.xz"])
def test_a_compression_is_told_by_how_the_file_begins(tmp_path, plain, name):
    (read,) = io.open_recording(put(tmp_path / "packed", name, gzip.compress(BVH))).recordings
    assert read.replace(name="clip") == plain.recordings[0]


def test_streams_that_follow_one_another_are_one(tmp_path, plain):
    for ending, pack in PACKERS.items():
        half = len(BVH) // 2
        path = put(tmp_path, f"clip.bvh{ending}", pack(BVH[:half]) + pack(BVH[half:]))
        assert io.read(path) == plain.recordings[0]


def test_a_file_that_was_unpacked_on_its_way_keeps_its_ending(tmp_path, plain):
    assert io.read(put(tmp_path / "loaded", "clip.bvh.gz", BVH)) == plain.recordings[0]


def test_of_several_recordings_one_is_named(tmp_path, plain):
    pack = put(
        tmp_path, "pack.zip",
        zipped({"inner/clip.bvh": BVH, "b.bvh": BVH, "A.BVH.gz": gzip.compress(BVH), "readme.md": b"x",
                "labels.csv": b"x", "__MACOSX/._b.bvh": b"x", ".DS_Store": b"x", "inner/.hidden.bvh": b"x"}),
    )  # fmt: skip
    names = ["A.BVH.gz", "b.bvh", "labels.csv", "inner/clip.bvh"]
    assert [path.relative_to(pack).as_posix() for path in recordings_in(pack)] == names
    with pytest.raises(
        DataError,
        match=r"pack.zip holds 3 recordings: A.BVH.gz, b.bvh, inner/clip.bvh. Name one .*pack.zip/A.BVH.gz",
    ):
        io.read(pack)
    assert io.read(pack / "inner/clip.bvh") == plain.recordings[0]
    assert io.read(pack / "A.BVH.gz").name == "A"
    with pytest.raises(FormatError, match=r"no inner/klip.bvh in .*pack.zip. Did you mean inner/clip.bvh"):
        io.read(pack / "inner/klip.bvh")
    assert on_disk(pack / "inner/clip.bvh") == pack
    assert exists(pack / "b.bvh")
    assert not exists(pack / "c.bvh")


def test_one_recording_among_what_may_be_one_is_it(tmp_path, plain):
    pack = put(tmp_path, "pack.zip", zipped({"clip.bvh": BVH, "labels.csv": b"start,stop,label\n0,1,a\n"}))
    assert io.read(pack) == plain.recordings[0]


def test_the_skeleton_of_a_zipped_amc_may_lie_above_it_in_the_archive_or_beside_the_archive(tmp_path):
    files = amc()
    above = put(
        tmp_path / "1", "pack.zip", zipped({"x/y/s_01.amc": files["s_01.amc"], "x/s.asf": files["s.asf"]})
    )
    reading = io.open_recording(above)
    assert reading.findings["skeleton"].value == str(above / "x" / "s.asf")
    alone = put(tmp_path / "2", "pack.zip", zipped({"s_01.amc": files["s_01.amc"]}))
    put(tmp_path / "2", "s.asf", files["s.asf"])
    assert io.read(alone) == reading.recordings[0]
    assert io.read(alone, skeleton=above / "x" / "s.asf") == reading.recordings[0]


def test_folders_parted_by_backslashes_are_folders(tmp_path, plain):
    pack = put(tmp_path, "pack.zip", zipped({"inner\\clip.bvh": BVH}))
    assert io.read(pack / "inner/clip.bvh") == plain.recordings[0]


# --- what is not to be trusted


def bomb(ending):
    """Twelve gigabytes of zeros in little."""
    if ending == ".zip":
        return zipped({"clip.bvh": b"0" * (90 << 20)})
    return PACKERS[ending](b"0" * (64 << 20)) * 200


def patched(content, places, value):
    """A zip whose one member states something else in both of its headers."""
    changed = bytearray(content)
    for mark, offset in zip((b"PK\x03\x04", b"PK\x01\x02"), places):
        start = content.index(mark) + offset
        changed[start : start + len(value)] = value
    return bytes(changed)


@pytest.mark.parametrize("ending", [*PACKERS, ".zip"])
def test_what_unpacks_beyond_reason_is_refused_soon(tmp_path, ending):
    path = put(tmp_path, f"clip.bvh{ending}", bomb(ending))
    began = time.process_time()
    with (
        bounded(room=1200 << 20),
        pytest.raises(FormatError, match=r"clip.bvh.* unpacks to more than \d+ MB"),
    ):
        io.read(path)
    assert time.process_time() - began < 3


ZIP = zipped({"clip.bvh": BVH})
SIZE, METHOD, FLAGS = (22, 24), (8, 10), (6, 8)


@pytest.mark.parametrize(
    ("content", "match"),
    [
        (ZIP[:-30], "no zip archive or is damaged"),
        (ZIP[: len(ZIP) // 2], "no zip archive or is damaged"),
        (b"PK\x03\x04rubbish" * 9, "no zip archive or is damaged"),
        (b"", "no zip archive or is damaged"),
        (b"rubbish", "no zip archive or is damaged"),
        (zipped({}), "holds no recordings"),
        (zipped({"a.md": b"x", "b.md": b"x"}), "holds no recordings, but files ending in .md"),
        (zipped({"clip.bvh": b""}), "clip.bvh is empty"),
        (patched(ZIP, SIZE, struct.pack("<I", 10)), "damaged: Bad CRC-32"),
        (patched(ZIP, SIZE, struct.pack("<I", 1 << 31)), "damaged"),
        (patched(ZIP, FLAGS, b"\x01"), "clip.bvh in pack.zip is encrypted. Unpack it first"),
        (patched(ZIP, METHOD, b"\x63"), "packed in a way that is not read.*Unpack it first"),
        (zipped({"inner.zip": ZIP}), "holds an archive within an archive. Unpack the outer"),
        (zipped({"../../clip.bvh": BVH}), r"names a file outside itself, '../../clip.bvh'"),
        (zipped({"/etc/clip.bvh": BVH}), "names a file outside itself"),
        (zipped({"..\\clip.bvh": BVH}), "names a file outside itself"),
        (zipped({"a.bvh": BVH, "b.bvh/c.bvh": BVH})[:-1], "damaged|holds 2 recordings"),
    ],
)
def test_what_is_wrong_with_an_archive_is_one_sentence(tmp_path, content, match):
    with bounded(1), pytest.raises((FormatError, DataError), match=match):
        io.read(put(tmp_path, "pack.zip", content))


def test_gzip_around_a_zip_is_to_be_unpacked(tmp_path):
    with pytest.raises(FormatError, match="archive within an archive"):
        io.read(put(tmp_path, "pack.zip.gz", gzip.compress(ZIP)))


@pytest.mark.parametrize("ending", PACKERS)
@pytest.mark.parametrize("change", [lambda c: c[:-9], lambda c: c[:40] + b"\xff\xff" + c[42:]])
def test_a_damaged_stream_is_one_sentence(tmp_path, ending, change):
    path = put(tmp_path, f"clip.bvh{ending}", change(PACKERS[ending](BVH)))
    with pytest.raises(FormatError, match=r"clip.bvh\S+ is damaged where it is compressed"):
        io.read(path)


TAPES = {
    ".tar": bytes,
    ".tar.gz": gzip.compress,
    ".tgz": gzip.compress,
    ".tar.bz2": bz2.compress,
    ".txz": lzma.compress,
}


@pytest.mark.parametrize("ending", [*TAPES, ".tar.xz"])
@pytest.mark.parametrize("seed", ["AMC", "BVH of a skeleton", "poses of OpenPose"])
def test_what_is_in_a_tar_reads_as_it_does_unpacked(tmp_path, seed, ending):
    files = SEEDS[seed]()
    paths = [put(tmp_path, name, content) for name, content in files.items()]
    content = taped({f"./a/{name}": content for name, content in files.items()})
    pack = put(tmp_path, f"pack/pack{ending}", TAPES.get(ending, lzma.compress)(content))
    expected = io.read_all(paths[0])
    assert io.read_all(pack) == expected
    assert io.read_all(pack / "a" / paths[0].name) == expected
    assert io.read_all(f"{pack}[2:5]") == [one[2:5] for one in expected]


@pytest.mark.parametrize("form", [tarfile.USTAR_FORMAT, tarfile.GNU_FORMAT, tarfile.PAX_FORMAT])
@pytest.mark.parametrize("pack", TAPES.values())
def test_a_tar_is_told_by_how_it_begins_and_long_names_are_whole(tmp_path, plain, form, pack):
    name = f"{'a' * 90}/{'b' * 90}.bvh"
    path = put(tmp_path, "stdin", pack(taped({name: BVH, "readme.md": b"x"}, form)))
    assert is_archive(path)
    assert [one.relative_to(path).as_posix() for one in recordings_in(path)] == [name]
    assert io.read(path).replace(name="clip") == plain.recordings[0]


def test_a_solid_archive_is_unpacked_once(tmp_path, monkeypatch):
    pack = put(tmp_path, "pack.tar.xz", lzma.compress(taped({f"{k}.bvh": BVH for k in range(5)})))
    times = []
    original = tape.pieces
    monkeypatch.setattr(tape, "pieces", lambda content: times.append(1) or original(content))
    assert len([io.read(path) for path in reversed(recordings_in(pack))]) == 5
    assert len(times) == 1


TAR = taped({"clip.bvh": BVH})


def backwards():
    """A tar whose second header says a size of minus what stands before it, which leads back for ever."""
    first = tarfile.TarInfo("clip.bvh")
    first.size = len(BVH)
    second = bytearray(tarfile.TarInfo("again.bvh").tobuf(tarfile.GNU_FORMAT))
    second[124:136] = b"\xff" + (-2048).to_bytes(11, "big", signed=True)
    second[148:156] = b" " * 8
    second[148:156] = b"%06o\0 " % sum(second)
    return (
        first.tobuf(tarfile.GNU_FORMAT)
        + BVH.ljust(-(-len(BVH) // 512) * 512, b"\0")
        + bytes(second)
        + bytes(2048)
    )


@pytest.mark.parametrize(
    ("content", "match"),
    [
        (TAR[:700], "no tar archive or is damaged"),
        (b"", "no tar archive or is damaged"),
        (b"rubbish" * 100, "no tar archive or is damaged"),
        (lzma.compress(TAR)[:-40], "no tar archive or is damaged"),
        (taped({}), "holds no recordings"),
        (taped({"a.md": b"x", "b.md": b"x"}), "holds no recordings, but files ending in .md"),
        (taped({"clip.bvh": b""}), "clip.bvh is empty"),
        (taped({"inner.zip": ZIP}), "holds an archive within an archive. Unpack the outer"),
        (taped({"inner.tar": TAR}), "archive of files files are not read. Unpack it"),
        (taped({"../../clip.bvh": BVH}), r"names a file outside itself, '../../clip.bvh'"),
        (backwards(), "its headers contradict each other"),
        (gzip.compress(bytes(64 << 20)) * 20, "unpacks to more than"),
    ],
)
def test_what_is_wrong_with_a_tar_is_one_sentence(tmp_path, content, match):
    with bounded(room=1200 << 20), pytest.raises((FormatError, DataError), match=match):
        io.read(put(tmp_path, "pack.tar", content))


def test_links_in_a_tar_are_no_recordings(tmp_path, plain):
    file = streams.BytesIO()
    with tarfile.open(fileobj=file, mode="w") as box:
        for kind in (tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.FIFOTYPE, tarfile.DIRTYPE):
            info = tarfile.TarInfo(f"{kind.decode()}.bvh")
            info.type, info.linkname = kind, "/etc/passwd"
            box.addfile(info)
        info = tarfile.TarInfo("clip.bvh")
        info.size = len(BVH)
        box.addfile(info, streams.BytesIO(BVH))
    assert io.read(put(tmp_path, "pack.tar", file.getvalue())) == plain.recordings[0]


@pytest.mark.parametrize("name", ["pack.7z", "pack.rar"])
def test_other_archives_are_to_be_unpacked(tmp_path, name):
    with pytest.raises(FormatError, match=r"archive of files files are not read\. Unpack it"):
        io.read(put(tmp_path, name, lzma.compress(b"x" * 1000)))


def test_an_archive_of_numpy_is_no_container(tmp_path):
    for name in ("clip.npz", "stdin"):
        points = io.read(put(tmp_path, name, SEEDS["archive of points"]()["clip.npz"]))
        assert len(points) == 12


def test_an_address_within_what_is_no_archive(tmp_path):
    path = put(tmp_path, "clip.bvh", BVH)
    with pytest.raises(FormatError, match=r"clip.bvh is a file, not a folder"):
        io.read(path / "inner.bvh")


def test_a_zip_of_very_many_members_is_listed_soon(tmp_path):
    with zipfile.ZipFile(tmp_path / "pack.zip", "w") as box:
        for k in range(3000):
            box.writestr(f"{k}.bvh", b"")
    with bounded(1), pytest.raises(DataError, match=r"holds 3000 recordings: 0\.bvh, 1\.bvh.* and 2992 more"):
        io.read(tmp_path / "pack.zip")


@pytest.mark.data
def test_a_real_archive_of_one_table(data):
    joints = io.read(data / "berkeley_mhad" / "skl_s01_a01_r01_pos.zip")
    assert (len(joints.names), joints.rate) == (30, 480.0)


@pytest.mark.data
def test_a_real_archive_of_what_is_not_read_says_so(data):
    with pytest.raises((DataError, FormatError)) as caught:
        io.read(data / "cmu8" / "cmu8_train.zip")
    assert "cmu8_train.zip holds" in caught.value.message
