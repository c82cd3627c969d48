"""Sources: windows, people, formats told by content, and a sentence for everything that goes wrong."""

import os

import numpy as np
import pytest

from leitmotion import io
from leitmotion.datasets import compose_session
from leitmotion.io.files import write_whole
from leitmotion.io.units import METRES
from leitmotion.motion import DataError, FormatError, ParameterError

TABLE = "time,A_x,A_y,A_z\n" + "".join(f"{k / 10},{k},0,0\n" for k in range(100))


@pytest.fixture
def clip(tmp_path):
    path = tmp_path / "clip.csv"
    path.write_text(TABLE)
    return path


def first_and_last(points):
    return points.positions[0, 0, 0], points.positions[-1, 0, 0]


@pytest.mark.parametrize(
    ("window", "first", "last", "frames"),
    [
        ("[2s:5s]", 20, 49, (20, 50)), ("[20:50]", 20, 49, (20, 50)), ("[20:]", 20, 99, (20, 100)),
        ("[:5s]", 0, 49, (0, 50)), ("[ 2.5 s : 5 s]", 25, 49, (25, 50)), ("[.5s:1e9s]", 5, 99, (5, 100)),
        ("[90:1000]", 90, 99, (90, 100)), ("[:]", 0, 99, (0, 100)),
    ],
)  # fmt: skip
def test_windows_in_frames_and_seconds(clip, window, first, last, frames):
    if "1e9" in window:
        window = window.replace("1e9", "1000000000")
    reading = io.open_recording(f"{clip}{window}", unit="m", up="y")
    assert first_and_last(reading.recordings[0]) == (first, last)
    assert reading.window == frames
    assert reading.path == clip


@pytest.mark.parametrize(
    ("window", "error", "match"),
    [
        ("[5s:2s]", DataError, "holds no frame of clip.csv, which has 100"),
        ("[100:]", DataError, "holds no frame"),
        ("[a:b]", ParameterError, r"seconds or frames such as \[12s:45s\]"),
        ("[-5:7]", ParameterError, "seconds or frames"),
        ("[1s:2]", ParameterError, r"in seconds or in frames.*got both in \[1s:2\]"),
        ("[1:2s]", ParameterError, "got both"),
    ],
)
def test_windows_that_hold_nothing(clip, window, error, match):
    with pytest.raises(error, match=match):
        io.read(f"{clip}{window}")


@pytest.mark.parametrize("window", ["[90:1000]", "[9s:12s]", "[9s:]", "[9s:10s]"])
def test_a_window_that_is_cut_is_told(clip, window):
    reading = io.open_recording(f"{clip}{window}", unit="m", up="y")
    assert reading.window == (90, 100)
    told = [warning for warning in reading.warnings if "reaches beyond" in warning]
    if "1000" in window or "12s" in window:
        assert told == [
            f"The window {window} reaches beyond the recording, which has 100 frames (10.00 s): "
            "it was cut to the frames [90:100]."
        ]
    else:
        assert not told


def test_a_file_whose_name_ends_in_brackets_wins(clip):
    odd = clip.with_name("clip.csv[2:5]")
    odd.write_text(TABLE)
    assert len(io.read(odd)) == 100  # its extension is ".csv[2:5]": told by content, not cut to a window
    other = clip.with_name("take[1:3].csv")
    other.write_text(TABLE)
    assert len(io.read(other)) == 100
    assert len(io.read(f"{other}[4:6]")) == 2


@pytest.mark.parametrize(
    ("name", "content", "match"),
    [
        ("a.bvh", b"", "a.bvh is empty"),
        ("a.bvh", b" \n\n", "a.bvh is empty"),
        ("a.bvh", b"<!DOCTYPE html><html><body>404</body></html>", "is a web page.*the file itself"),
        ("a.bvh", bytes(range(1, 256)) * 8, "expected the word HIERARCHY"),
        ("a.bvh", b"hello\nthere\n", "expected the word HIERARCHY, found 'hello'"),
        ("a.bvh", bytes(range(256)) * 8, "line 1: expected text, found NUL bytes"),
        ("a.bvh", b"\0" * 500, "line 1: expected text, found NUL bytes"),
        ("a.bvh", "HIERARCHY\nROOT Hips\n".encode("utf-16"), "expected a section MOTION"),
        ("a.amc", bytes(range(1, 256)) * 8, "skeleton"),
        ("a.c3d", b"rubbish\n" * 50, "mark 0x50 .* in its second byte, found 75"),
        ("a.c3d", b"HIERARCHY\nROOT Hips\n" * 50, "line 4: expected a ROOT outside joints"),
        ("a.trc", b"\x02\x01\n" * 50, "PathFileType"),
        ("a.csv", b"\x02\xff\xfe\n" * 50, "columns such as"),
        ("a.csv", b"time,A_x,A_y,A_z\n0,1,\0,3\n", "line 2: expected text, found NUL"),
        ("a.npz", b"PK\x03\x04rubbish", "damaged"),
        ("a.xyz", b"rubbish", r"ends in '.xyz'.*These are read: .*\.bvh"),
        ("noext", b"rubbish", "noext does not begin like any format known here"),
        ("a.fbx", b"Kaydara", "FBX files are not read.*BVH"),
        ("a.mat", b"MATLAB", "MATLAB files are not read"),
        ("a.h5", b"\x89HDF", "HDF5 files are not read"),
        ("a.npy", b"\x93NUMPY", "is damaged"),
        ("a.asf", b":version", "read the AMC that belongs to it"),
        ("a.mp4", b"ftyp", "video files are not read"),
    ],
)
def test_what_is_no_recording_is_one_sentence(tmp_path, name, content, match):
    path = (
        tmp_path / "1" / "2" / "3" / name
    )  # so deep that the search for a skeleton does not leave the test's folder
    path.parent.mkdir(parents=True)
    path.write_bytes(content)
    with pytest.raises(FormatError, match=match) as caught:
        io.read(path)
    assert "\n" not in str(caught.value)


def test_names_that_share_an_ending_alone_are_not_near(clip):
    with pytest.raises(FormatError) as caught:
        io.read(clip.with_name("ship_a.csv"))
    assert caught.value.remedy == ""


def test_missing_files_suggest_near_names(clip):
    with pytest.raises(FormatError, match=r"There is no file .*clop\.csv\. Did you mean clip\.csv\?"):
        io.read(clip.with_name("clop.csv"))
    with pytest.raises(FormatError, match=r"Did you mean clip\.csv\?"):
        io.read(clip.with_name("clip.bvh"))
    with pytest.raises(FormatError, match="no folder"):
        io.read(clip.parent / "nowhere" / "clip.csv")
    with pytest.raises(FormatError, match="is a folder"):
        io.read(clip.parent)


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="permissions bind only an ordinary user")
def test_a_file_without_permission(clip):
    clip.chmod(0)
    with pytest.raises(FormatError, match="may not be read"):
        io.read(clip)


def test_a_format_is_told_by_content_where_the_extension_tells_nothing(tmp_path):
    path = tmp_path / "clip.txt"
    path.write_text(
        "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
        "End Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.01\n0 0 0\n"
    )
    assert io.read(path, unit="m").skeleton.names == ("a",)


@pytest.mark.parametrize("delimiter", [",", "\t", ";", " "])
@pytest.mark.parametrize("name", ["stdin", "points.txt"])
def test_a_table_is_told_by_its_header(tmp_path, name, delimiter):
    path = tmp_path / name
    path.write_text("# a comment\n\n" + TABLE.replace(",", delimiter))
    assert io.read(path, unit="m", up="y").names == ("A",)


@pytest.mark.parametrize("text", ["start,stop,label\n1,2,a\n", "one line of words\n", '{"a_x": [1, 2]}\n'])
def test_other_text_is_no_table(tmp_path, text):
    (tmp_path / "stdin").write_text(text)
    with pytest.raises(FormatError, match="does not begin like any format"):
        io.read(tmp_path / "stdin")


PERSON = """ROOT Hips
{
OFFSET 0 0 0
CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation
End Site
{
OFFSET 0 1 0
}
}
"""
COUPLE = f"HIERARCHY\n{PERSON * 2}MOTION\nFrames: 2\nFrame Time: 0.01\n" + (
    "1 0 0 0 0 0 2 0 0 0 0 0\n1 0 0 0 0 0 2 0 0 0 0 0\n"
)


def test_people_of_one_name_are_numbered(tmp_path):
    path = tmp_path / "couple.bvh"
    path.write_text(COUPLE)
    with pytest.raises(DataError, match="holds 2 people: Hips, Hips#2"):
        io.read(path)
    assert [
        io.read(path, person=who, unit="m", up="y").local_positions[0, 0, 0] for who in ("Hips", "Hips#2")
    ] == [1, 2]
    assert io.open_recording(path).people == ("Hips", "Hips#2")
    assert [motion.name for motion in io.read_all(path)] == ["couple:Hips", "couple:Hips#2"]


@pytest.mark.parametrize(("name", "text"), [("couple.bvh", COUPLE), ("clip.csv", TABLE), ("clip", TABLE)])
def test_every_line_end_is_read(tmp_path, name, text):
    read = []
    for end in ("\n", "\r\n", "\r"):
        path = tmp_path / name
        path.write_bytes(text.replace("\n", end).encode())
        read.append(io.read_all(path, unit="m", up="y"))
    assert read[0] == read[1] == read[2]


def test_zeros_at_the_end_are_told_and_left_out(tmp_path):
    (tmp_path / "clip.csv").write_bytes(TABLE.encode() + b"\0" * 7)
    reading = io.open_recording(tmp_path / "clip.csv", unit="m", up="y")
    assert len(reading.recordings[0]) == 100
    assert any("ends in 7 NUL bytes" in warning for warning in reading.warnings)


def test_every_extension_of_the_table_is_read_or_has_a_remedy():
    for extension, forms in io.EXTENSIONS.items():
        assert extension == extension.lower()
        assert extension.startswith(".")
        assert all(form.module or form.remedy for form in forms)
        assert all(form.looks for form in forms[:-1])


@pytest.mark.parametrize("unit", [*METRES, 0.5, "0.5", "Millimeters"])
def test_a_unit_given_scales(clip, unit):
    metres = {"Millimeters": 0.001}.get(unit) or METRES.get(unit) or float(unit)
    reading = io.open_recording(clip, unit=unit, up="y")
    assert reading.recordings[0].positions[1, 0, 0] == pytest.approx(metres)
    assert reading.findings["unit"].how == "given"


@pytest.mark.parametrize(
    ("options", "match"),
    [
        ({"unit": "furlong"}, "unit must be one of"), ({"unit": -1}, "positive"), ({"up": "w"}, "up must be one of"),
        ({"rate": 0}, "rate must be a positive"), ({"rate": float("nan")}, "rate must be a positive"),
    ],
)  # fmt: skip
def test_options_are_checked(clip, options, match):
    with pytest.raises(ParameterError, match=match):
        io.read(clip, **options)


@pytest.mark.parametrize("up", ["x", "y", "z", "-x", "-y", "-z", "+z", "Z"])
def test_every_vertical_comes_up_by_a_proper_turn(tmp_path, up):
    path = tmp_path / "axes.csv"
    axis = "xyz".index(up[-1].lower())
    vertical = np.zeros(3)
    vertical[axis] = -1 if up[0] == "-" else 1
    points = np.vstack([vertical, np.eye(3)])
    path.write_text("time,A_x,A_y,A_z,B_x,B_y,B_z,C_x,C_y,C_z,D_x,D_y,D_z\n" + "\n".join(
        f"{k}," + ",".join(map(str, points.ravel())) for k in range(2)) + "\n")  # fmt: skip
    placed = io.read(path, up=up, unit="m").positions[0]
    np.testing.assert_allclose(placed[0], [0, 1, 0])
    assert np.linalg.det(placed[1:]) == pytest.approx(1)


def test_people_are_chosen_by_name_or_number(tmp_path):
    path = tmp_path / "two.csv"
    path.write_text("time,Ann:A_x,Ann:A_y,Ann:A_z,Bob:A_x,Bob:A_y,Bob:A_z\n0,1,1,1,2,2,2\n1,1,1,1,2,2,2\n")
    options = {"unit": "m", "up": "y"}
    assert io.read(path, person="Bob", **options) == io.read(path, person=2, **options)
    assert io.read(path, person="Bob", **options).name == "two:Bob"
    assert [p.name for p in io.read_all(path, **options)] == ["two:Ann", "two:Bob"]
    with pytest.raises(DataError, match="no person 'Eve'; it holds Ann, Bob"):
        io.read(path, person="Eve")
    with pytest.raises(DataError, match="no person 3"):
        io.read(path, person=3)


# --- files


def test_a_file_is_written_whole_or_not_at_all(tmp_path, monkeypatch):
    path = tmp_path / "folder" / "out.txt"
    assert write_whole(path, "first\r\nline") == path
    assert path.read_bytes() == b"first\r\nline"

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(FormatError, match="cannot be written: No space left on device"):
        write_whole(path, "second")
    monkeypatch.setattr(os, "fsync", lambda _: (_ for _ in ()).throw(KeyboardInterrupt))
    with pytest.raises(KeyboardInterrupt):
        write_whole(path, "third")
    monkeypatch.undo()
    assert path.read_bytes() == b"first\r\nline"
    assert [p.name for p in path.parent.iterdir()] == ["out.txt"]


def test_a_folder_cannot_be_written_over(tmp_path):
    with pytest.raises(FormatError, match="cannot be written"):
        write_whole(tmp_path, b"x")


@pytest.mark.parametrize("source", [3, None, b"clip.bvh"])
def test_what_is_no_path_is_refused(source):
    with pytest.raises(ParameterError, match="named by a path"):
        io.read(source)


def test_a_file_under_the_ending_of_another_format_is_read_and_told(tmp_path):
    motion = compose_session(seed=1, rate=30).motion
    right, wrong = tmp_path / "right", tmp_path / "wrong"
    for extension, other in ((".bvh", ".c3d"), (".c3d", ".bvh"), (".npz", ".npy"), (".trc", ".amc")):
        named = io.write(motion[:60], right.with_suffix(extension))
        misnamed = wrong.with_suffix(other)
        misnamed.write_bytes(named.read_bytes())
        reading = io.open_recording(misnamed)
        assert reading.recordings[0] == io.read(named).replace(name=reading.recordings[0].name)
        assert any(f"ends in {other}, but it begins like" in warning for warning in reading.warnings)


@pytest.mark.skipif(os.name != "posix", reason="links need no permission on POSIX alone")
def test_a_link_to_nowhere_says_where_it_leads(tmp_path):
    (tmp_path / "clip.bvh").symlink_to(tmp_path / "gone.bvh")
    with pytest.raises(FormatError, match=r"clip.bvh is a link to .*gone.bvh, where there is no file"):
        io.read(tmp_path / "clip.bvh")
