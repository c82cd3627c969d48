"""What is no recording, cannot be read or promises too much: one sentence, soon and in bounded memory."""

import errno
import json
import os
import re
import resource
import stat
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from fuzzing.law import bounded, check, check_sentence, put
from fuzzing.seeds import SEEDS, markers, motion
from leitmotion import io
from leitmotion.io.files import LARGEST, read_bytes, write_whole
from leitmotion.motion import DataError, FormatError, LeitmotionError

ROOM = 256 << 20
BVH = SEEDS["BVH of a skeleton"]()["clip.bvh"]


def refused(path: Path, **options: object) -> str:
    """The sentence with which a path is refused, within a second and little memory."""
    with bounded(seconds=1, room=ROOM), pytest.raises(LeitmotionError) as caught:
        io.read(path, **options)
    check_sentence(caught.value)
    return str(caught.value)


# --- paths that are no files


@pytest.mark.skipif(os.name != "posix", reason="devices and pipes are POSIX's")
def test_devices_and_pipes_are_refused_and_never_opened(tmp_path):
    os.mkfifo(tmp_path / "pipe.bvh")
    for path in ("/dev/zero", "/dev/null", "/dev/full", "/dev/tty", tmp_path / "pipe.bvh"):
        assert "is a device or a pipe. What comes from a pipe is read as standard input" in refused(path)


def test_a_folder_is_no_file(tmp_path):
    (tmp_path / "folder.bvh").mkdir()
    assert "is a folder. Name a recording in it" in refused(tmp_path / "folder.bvh")


def test_a_link_that_leads_to_itself_or_nowhere(tmp_path):
    (tmp_path / "loop.bvh").symlink_to(tmp_path / "loop.bvh")
    (tmp_path / "gone.bvh").symlink_to(tmp_path / "nowhere.bvh")
    assert "loop.bvh cannot be read: Too many levels of symbolic links" in refused(tmp_path / "loop.bvh")
    assert "is a link to" in refused(tmp_path / "gone.bvh")


@pytest.mark.parametrize(
    "name",
    [
        "new\nline.bvh",
        "tab\t.bvh",
        "sur\udcffrogate.bvh",
        "half\ud800.bvh",
        "nul\0.bvh",
        "a" * 300,
        "a/" * 2000,
    ],
)
def test_names_that_are_odd_are_spelled_in_one_line(tmp_path, name):
    refused(tmp_path / name)
    refused(Path(f"{tmp_path / name}/inner.bvh"))


@pytest.mark.skipif(sys.platform != "linux", reason="other systems refuse such names themselves")
@pytest.mark.parametrize("name", ["new\nline.bvh", "sur\udcffrogate.bvh", " .bvh", "-.bvh", "a[1:2].bvh"])
def test_files_of_odd_names_are_read_or_refused_in_one_line(tmp_path, name):
    (tmp_path / name).write_bytes(BVH)
    assert len(io.read(tmp_path / name)) == 12
    (tmp_path / name).write_bytes(b"HIERARCHY\nROOT\n")
    refused(tmp_path / name)


@pytest.mark.parametrize(
    ("error", "match"),
    [
        (PermissionError(errno.EACCES, "Permission denied"), "may not be read. Check its permissions"),
        (OSError(errno.EIO, "Input/output error"), "cannot be read: Input/output error"),
        (FileNotFoundError(errno.ENOENT, "No such file"), "There is no file"),
        (MemoryError(), "needs more memory than there is"),
    ],
)
def test_what_the_system_refuses_is_a_sentence(tmp_path, monkeypatch, error, match):
    path = put(tmp_path, {"clip.bvh": BVH})

    def fail(_: Path) -> bytes:
        raise error

    monkeypatch.setattr(Path, "read_bytes", fail)
    with pytest.raises(LeitmotionError, match=match):
        io.read(path)


def test_a_file_that_is_larger_than_any_recording(tmp_path):
    path = tmp_path / "clip.bvh"
    with path.open("wb") as file:
        file.truncate(LARGEST + 1)  # takes no room on the disk
    assert "clip.bvh is 4.3 GB, and files of up to 4.3 GB are read. Cut it" in refused(path)


# --- headers that promise too much


def bvh(
    joints: int = 1, channels: str = "CHANNELS 1 Zrotation", frames: str = "1", rows: str = "0\n"
) -> bytes:
    tree = "".join(f"{'JOINT' if k else 'ROOT'} j{k}\n{{\nOFFSET 0 1 0\n{channels}\n" for k in range(joints))
    closed = "}\n" * joints
    return f"HIERARCHY\n{tree}{closed}MOTION\nFrames: {frames}\nFrame Time: 0.01\n{rows}".encode()


def npy(shape: str, body: bytes = b"\0" * 64) -> bytes:
    header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\x01\0" + struct.pack("<H", len(header)) + header.encode() + body


def c3d(at: int, value: int) -> bytes:
    content = bytearray(SEEDS["C3D"]()["clip.c3d"])
    content[at : at + 2] = struct.pack("<H", value)
    return bytes(content)


TRC = SEEDS["TRC"]()["clip.trc"]
NTU = SEEDS["NTU RGB+D"]()["clip.skeleton"]
PROMISES = {
    "a million joints": ("clip.bvh", bvh(channels="CHANNELS 1000000 Zrotation")),
    "joints without end": ("clip.bvh", b"HIERARCHY\n" + b"ROOT a\n{\nOFFSET 0 0 0\nCHANNELS 0\n}\n" * 5000),
    "closing braces": ("clip.bvh", b"HIERARCHY\n" + b"}" * 100_000),
    "parameters": ("clip.c3d", c3d(0, 0x50FF)),
    "an array": ("clip.npy", npy("(1000000000, 1000000, 3)")),
    "a negative array": ("clip.npy", npy("(-1, 22, 3)")),
    "an array of arrays": ("clip.npy", npy("(" + "1," * 500 + ")")),
    "frames of NTU": ("clip.skeleton", NTU.replace(b"2\n1\n", b"999999999\n999999999\n", 1)),
    "joints of NTU": ("clip.skeleton", NTU.replace(b"\n25\n", b"\n999999999\n", 1)),
    "deep lists": ("clip.json", b"[" * 200_000 + b"]" * 200_000),
    "deep objects": ("clip.json", b'{"people":' * 200_000),
    "a long number": ("clip.json", b'[{"keypoints": [' + b"9" * 100_000 + b"]}]"),
    "columns": (
        "clip.csv",
        ",".join(f"a{k}_x,a{k}_y,a{k}_z" for k in range(20_000)).encode() + b"\n" + b"\n1,2" * 20_000,
    ),
    "an archive's header": ("clip.npz", b"PK\x03\x04" + b"\xff" * 26 + b"header.npy" + b"\xff" * 100),
}


@pytest.mark.parametrize("promise", PROMISES)
def test_a_promise_that_cannot_be_kept_is_a_sentence(tmp_path, promise):
    name, content = PROMISES[promise]
    refused(put(tmp_path, {name: content}), rate=30)


KEPT = {
    "frames of a BVH": ("clip.bvh", bvh(frames="1000000000"), "promises 1000000000 frames, the file has 1"),
    "more than there are": ("clip.bvh", bvh(frames="9" * 400), "states .* as the count of frames; the 1"),
    "frames of a TRC": ("clip.trc", TRC.replace(b"\t6\t2", b"\t1000000000\t2"), "1000000000 frames, the file has 6"),
    "markers of a TRC": ("clip.trc", TRC.replace(b"\t6\t2\t", b"\t6\t1000000000\t"), ""),
    "frames of a C3D": ("clip.c3d", c3d(8, 65535), "promises .* frames"),
    "frames of NTU": ("clip.skeleton", NTU.replace(b"2\n", b"999999999\n", 1), "999999999 frames, the file has 2"),
    "a deep chain": ("clip.bvh", bvh(joints=2000, rows="0 " * 2000), ""),
}  # fmt: skip


@pytest.mark.parametrize("promise", KEPT)
def test_a_promise_that_does_no_harm_is_told(tmp_path, promise):
    name, content, match = KEPT[promise]
    with bounded(seconds=5, room=ROOM):
        reading = io.open_recording(put(tmp_path, {name: content}))
    assert not match or any(re.search(match, warning) for warning in reading.warnings), reading.warnings


@pytest.mark.parametrize("at", range(2, 24, 2))
@pytest.mark.parametrize("value", [0, 1, 0x7FFF, 0x8000, 0xFFFF])
def test_any_word_in_the_first_block_of_a_c3d(at, value):
    check({"clip.c3d": c3d(at, value)})


# --- little


ONE_FRAME = {
    "BVH": ("clip.bvh", bvh()),
    "table": ("clip.csv", b"time,A_x,A_y,A_z\n0,1,2,3\n"),
    "TRC": ("clip.trc", TRC[: TRC.index(b"2\t0.0167")]),
    "C3D": ("clip.c3d", c3d(8, 1)),
    "NTU RGB+D": ("clip.skeleton", NTU.replace(b"2\n1\n", b"1\n1\n", 1)),
    "NumPy array": ("clip.npy", npy("(1, 22, 3)", np.ones(66).tobytes())),
    "poses": ("clip.json", json.dumps([{"image_id": "1.jpg", "keypoints": [1, 2, 0.9] * 17}]).encode()),
}


@pytest.mark.parametrize("name", ONE_FRAME)
def test_one_frame_is_a_recording(tmp_path, name):
    path = put(tmp_path, dict([ONE_FRAME[name]]))
    assert len(io.read(path, rate=30)) == 1
    check({path.name: path.read_bytes()})


def test_one_frame_of_every_noun_comes_back(tmp_path):
    for noun, ending in ((motion(), ".bvh"), (motion(), ".npz"), (markers(), ".npz"), (markers(), ".c3d")):
        path = io.write(noun[:1], tmp_path / f"clip{ending}")
        assert len(io.read(path)) == 1


def test_no_frame_is_a_sentence(tmp_path):
    for name, content in {
        "clip.bvh": bvh(rows=""),
        "clip.csv": b"time,A_x,A_y,A_z\n",
        "clip.trc": TRC[: TRC.index(b"1\t0.0000")],
        "clip.amc": b":DEGREES\n",
        "clip.npy": npy("(0, 22, 3)", b""),
        "clip.skeleton": b"0\n",
        "clip.json": b"[]",
    }.items():
        refused(put(tmp_path, {name: content}), rate=30)
    path = io.save(markers()[:0], tmp_path / "none.npz")
    assert "none.npz: expected at least one frame, found none" in refused(path)


def test_points_that_are_never_seen(tmp_path):
    path = put(
        tmp_path, {"clip.csv": b"time,A_x,A_y,A_z\n" + b"".join(b"%d,nan,nan,nan\n" % k for k in range(9))}
    )
    assert np.isnan(io.read(path).positions).all()
    check({"clip.csv": path.read_bytes()})


def test_a_coordinate_out_of_reach_is_unseen_and_told(tmp_path):
    path = put(tmp_path, {"clip.csv": b"time,A_x,A_y,A_z\n0,1,2,3\n1,1e15,2,3\n2,1,2,3\n"})
    with np.errstate(all="raise"):
        reading = io.open_recording(path, unit="m", up="y")
    np.testing.assert_array_equal(np.isnan(reading.recordings[0].positions[:, 0, 0]), [False, True, False])
    assert reading.warnings == ("1 places lie beyond 1e+12 from the origin and were taken as unseen.",)


def test_a_rate_that_cannot_be_is_a_sentence(tmp_path):
    path = put(tmp_path, {"clip.csv": b"# rate: 1e9\nA_x,A_y,A_z\n1,2,3\n1,2,3\n"})
    assert "rate" in refused(path)
    assert io.read(path, rate=30).rate == 30


# --- writing


def test_a_disk_that_is_full_leaves_what_was_there(tmp_path, monkeypatch):
    path = write_whole(tmp_path / "out.bvh", b"before")
    for call in ("open", "fsync", "replace"):
        with monkeypatch.context() as patched:
            patched.setattr(os, call, _full)
            with pytest.raises(
                FormatError, match=r"cannot be written: No space left on device\. Choose another place"
            ):
                write_whole(path, b"after")
        assert path.read_bytes() == b"before"
        assert [one.name for one in tmp_path.iterdir()] == ["out.bvh"]


def _full(*_: object, **__: object) -> None:
    raise OSError(errno.ENOSPC, "No space left on device")


WRITE = """
import resource, signal, sys
from fuzzing.seeds import markers, motion
from leitmotion import io
from leitmotion.motion import LeitmotionError
resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
for noun, ending in ((motion(), ".bvh"), (motion(), ".npz"), (markers(), ".csv"), (motion(), ".c3d")):
    try:
        io.write(noun, f"{sys.argv[1]}/clip{ending}")
    except LeitmotionError as error:
        print(error)
"""


@pytest.mark.skipif(os.name != "posix", reason="limits are POSIX's")
def test_every_writer_stops_cleanly_where_no_more_can_be_written(tmp_path):
    done = subprocess.run(
        [sys.executable, "-c", WRITE, str(tmp_path)], capture_output=True, text=True, timeout=60,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) == 4
    assert all("cannot be written: File too large" in line for line in done.stdout.splitlines())
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(os.name != "posix", reason="devices and pipes are POSIX's")
def test_a_device_is_never_replaced_by_a_file(tmp_path):
    pipe = tmp_path / "pipe.bvh"
    os.mkfifo(pipe)
    with pytest.raises(FormatError, match="cannot be written: it is a device or a pipe"):
        write_whole(pipe, b"x")
    assert stat.S_ISFIFO(pipe.stat().st_mode)


@pytest.mark.parametrize("name", ["nul\0.bvh", "a" * 300, "half\ud800.bvh"])
def test_a_name_that_no_file_can_have(tmp_path, name):
    with pytest.raises(FormatError, match="cannot be written"):
        write_whole(tmp_path / name, b"x")
    assert list(tmp_path.iterdir()) == []


def test_half_a_character_is_spelled_out(tmp_path):
    assert write_whole(tmp_path / "a.txt", "sur\udcffrogate").read_text() == r"sur\udcffrogate"


# --- the program


def run(*arguments: object, **options: object) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(
        [sys.executable, "-m", "leitmotion", *map(os.fsencode, map(str, arguments))],
        stderr=subprocess.PIPE, timeout=60, **options,
    )  # fmt: skip


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
def test_the_program_says_that_its_output_cannot_be_written(tmp_path):
    path = put(tmp_path, {"clip.bvh": BVH})
    with open("/dev/full", "wb") as full:
        done = run("info", path, "--json", stdout=full)
    assert done.returncode == 1
    assert done.stderr.decode() == "Error: No space left on device.\n"


@pytest.mark.skipif(sys.platform != "linux", reason="other systems refuse such names themselves")
def test_the_program_prints_names_that_are_no_text(tmp_path):
    for name in ("a\udcff.bvh", "b\n.bvh"):
        (tmp_path / name).write_bytes(BVH)
    done = run(
        "info",
        tmp_path,
        "--quiet",
        stdout=subprocess.PIPE,
        env={**os.environ, "PYTHONIOENCODING": "utf-8:strict"},
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert rb"a\udcff.bvh" in done.stdout


def test_the_program_stays_within_its_memory(tmp_path):
    path = put(tmp_path, {"clip.npy": npy("(1000000000, 1000000, 3)")})

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))

    done = run("info", path, stdout=subprocess.PIPE, preexec_fn=limit)
    assert done.returncode == 1
    assert done.stderr.count(b"\n") == 1


def test_reading_bytes_never_trusts_a_path_to_be_one():
    with pytest.raises(FormatError):
        read_bytes(Path("\0"))
    with pytest.raises((FormatError, DataError)):
        io.read("pack.zip/\0.bvh")
