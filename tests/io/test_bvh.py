"""BVH: the hard cases of the format, the writer, the rate, what is judged."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from leitmotion import io
from leitmotion.datasets import Action, compose
from leitmotion.io.bvh import read as parse
from leitmotion.io.bvh import write
from leitmotion.io.bvh_frames import frame_rate
from leitmotion.io.reading import Source
from leitmotion.motion import FormatError, Motion, ParameterError, Skeleton, forward_kinematics, rotations

PLAIN = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Head
  {
    OFFSET 0 70 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 20 0
    }
  }
  JOINT LeftFoot
  {
    OFFSET 10 -90 0
    CHANNELS 3 Yrotation Zrotation Xrotation
  }
}
MOTION
Frames: 2
Frame Time: 0.0083333
1 95 3 10 20 30 40 50 60 70 80 90
2 96 4 11 21 31 41 51 61 71 81 91
"""


def put(tmp_path, text):
    path = tmp_path / "clip.bvh"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def read(tmp_path, text, **options):
    return io.open_recording(put(tmp_path, text), **options)


def test_what_a_plain_file_says(tmp_path):
    reading = read(tmp_path, PLAIN)
    (motion,) = reading.recordings
    assert motion.skeleton.names == ("Hips", "Head", "LeftFoot")
    assert motion.rate == 120.0
    assert reading.warnings == ()
    np.testing.assert_allclose(motion.local_positions[0], [[0.01, 0.95, 0.03], [0, 0.7, 0], [0.1, -0.9, 0]])
    expected = [
        rotations.from_euler("zxy", np.deg2rad([10, 20, 30])),
        rotations.from_euler("zxy", np.deg2rad([40, 50, 60])),
        rotations.from_euler("yzx", np.deg2rad([70, 80, 90])),
    ]
    np.testing.assert_allclose(motion.local_rotations[0], expected, atol=1e-12)
    np.testing.assert_allclose(motion.skeleton.end_offsets, [[0, 0.2, 0]])


@pytest.mark.parametrize(
    "change",
    [
        lambda s: s.replace("\n", "\r\n"),
        lambda s: (
            s.replace("  ", "\t")
            .replace(" ", "\t")
            .replace("End\tSite", "End Site")
            .replace("Time:", "Time: ")
        ),
        lambda s: "\ufeff" + s,
        lambda s: s.replace("\n  {", " {").replace("ROOT Hips\n{", "ROOT Hips {"),
        lambda s: s.replace("Frame Time: 0.0083333", "Frame Time:\t8.3333e-03"),
        lambda s: s.replace("1 95 3", "1.0e0 +95. 0.3E+1"),
        lambda s: s + "\n\n  \n",
        lambda s: s.rstrip("\n"),
        lambda s: s.lower().replace("hips", "Hips").replace("head", "Head").replace("leftfoot", "LeftFoot"),
    ],
    ids=[
        "crlf",
        "tabs",
        "bom",
        "brace",
        "exponent-time",
        "exponents",
        "blank-end",
        "no-newline",
        "lower-case",
    ],
)
def test_spellings_of_one_file_are_one(tmp_path, change):
    assert read(tmp_path, change(PLAIN)).recordings == read(tmp_path, PLAIN).recordings


@pytest.mark.parametrize("name", ["Left Foot", "mixamorig:LeftFoot", "end", "End Effector", "JOINT", "Fuß"])
def test_names_with_blanks_colons_and_words_of_the_format(tmp_path, name):
    motion = read(tmp_path, PLAIN.replace("LeftFoot", name)).recordings[0]
    assert motion.skeleton.names[2] == name


@pytest.mark.parametrize("encoding", ["latin-1", "utf-8", "utf-16"])
def test_a_name_is_the_same_in_any_encoding(tmp_path, encoding):
    motion = read(tmp_path, PLAIN.replace("LeftFoot", "linker Fuß").encode(encoding)).recordings[0]
    assert motion.skeleton.names[2] == "linker Fuß"


def test_positions_on_any_joint_in_any_place(tmp_path):
    text = (
        PLAIN.replace(
            "CHANNELS 3 Yrotation Zrotation Xrotation",
            "CHANNELS 6 Yrotation Zposition Zrotation Xposition Xrotation Yposition",
        )
        .replace("70 80 90", "70 3 80 1 90 2")
        .replace("71 81 91", "71 6 81 4 91 5")
    )
    motion = read(tmp_path, text, unit="cm").recordings[0]
    np.testing.assert_allclose(motion.local_positions[:, 2], [[0.01, 0.02, 0.03], [0.04, 0.05, 0.06]])
    np.testing.assert_allclose(
        motion.local_rotations[0, 2], rotations.from_euler("yzx", np.deg2rad([70, 80, 90]))
    )


def test_a_position_channel_takes_the_place_of_the_offset(tmp_path):
    text = PLAIN.replace("OFFSET 0 0 0", "OFFSET 5 94 7")
    motion = read(tmp_path, text, unit="cm").recordings[0]
    np.testing.assert_allclose(motion.local_positions[0, 0], [0.01, 0.95, 0.03])
    np.testing.assert_allclose(motion.skeleton.offsets[0], [0.05, 0.94, 0.07])


def test_several_roots_are_several_people(tmp_path):
    tree, rest = PLAIN.split("MOTION")
    header, rows = rest.split("0.0083333\n")
    second = tree.replace("HIERARCHY\n", "").replace("Hips", "Hips2")
    doubled = "\n".join(f"{row} {row}" for row in rows.strip().split("\n"))
    reading = read(tmp_path, tree + second + "MOTION" + header + "0.0083333\n" + doubled + "\n")
    a, b = reading.recordings
    assert reading.people == ("Hips", "Hips2")
    assert (a.name, b.name) == ("clip:Hips", "clip:Hips2")
    np.testing.assert_array_equal(a.local_rotations, b.local_rotations)
    assert read(tmp_path, PLAIN).recordings[0] == a.replace(name="clip")


def test_joints_of_one_name_are_numbered(tmp_path):
    reading = read(tmp_path, PLAIN.replace("LeftFoot", "Head"))
    assert reading.recordings[0].skeleton.names == ("Hips", "Head", "Head#2")
    assert any("Head" in warning for warning in reading.warnings)


@pytest.mark.parametrize("promised", ["1", "7", "1000000000"])
def test_a_wrong_count_of_frames_is_told_with_both_numbers(tmp_path, promised):
    reading = read(tmp_path, PLAIN.replace("Frames: 2", f"Frames: {promised}"))
    assert len(reading.recordings[0]) == 2
    assert any(f"promises {promised} frames, the file has 2" in warning for warning in reading.warnings)


def test_a_short_last_row_is_left_out_and_told(tmp_path):
    reading = read(tmp_path, PLAIN[: PLAIN.rindex("61")])
    assert len(reading.recordings[0]) == 1
    assert any("ends within its row 2" in warning for warning in reading.warnings)


@pytest.mark.parametrize(
    ("old", "new", "match"),
    [
        ("HIERARCHY", "", "line 1: expected the word HIERARCHY"),
        ("JOINT Head", "JINT Head", "line 6: expected ROOT, JOINT"),
        ("OFFSET 0 70 0", "\x0b{", "line 8: expected ROOT, JOINT"),
        ("OFFSET 0 70 0", "OFFSET 0 70", "line 8: expected 3 numbers"),
        ("OFFSET 0 70 0", "OFFSET 0 nan 0", "line 8: expected 3 numbers"),
        ("CHANNELS 6", "CHANNELS 5", "line 5: expected 5 channels, found 6"),
        ("Xposition", "Wposition", "line 5: expected channels such as"),
        ("}\nMOTION", "MOTION", "closing braces before MOTION"),
        ("}\nMOTION", "}\n}\nMOTION", "no more closing braces"),
        ("MOTION", "", "line 22: expected ROOT, JOINT"),
        (PLAIN[PLAIN.index("MOTION") :], "", "section MOTION.*cut short"),
        ("Frame Time: 0.0083333", "", "'Frames:' and 'Frame Time:'"),
        ("0.0083333", "0", "frame time above 0.*--rate"),
        ("11 21", "11 x", "line 25: expected a number, found 'x'"),
        ("1 95 3", "1 95", "line 24: expected 12 numbers in the row, found 11"),
    ],
)
def test_faults_name_their_line(tmp_path, old, new, match):
    with pytest.raises(FormatError, match=match):
        read(tmp_path, PLAIN.replace(old, new, 1))


def test_a_rate_given_mends_a_missing_frame_time(tmp_path):
    assert read(tmp_path, PLAIN.replace("0.0083333", "0"), rate=60).recordings[0].rate == 60


@pytest.mark.parametrize(
    ("text", "rate"),
    [
        ("0.0083333", 120), ("0.008333", 120), (".0083333", 120), (".03333", 30), ("0.0333333", 30), ("0.025000", 40),
        ("0.010000", 100), ("0.0166667", 60), ("0.016666", 60), ("0.041667", 24), ("3.33333e-02", 30),
        ("0.008342", 120000 / 1001), ("0.033367", 30000 / 1001), ("0.0417083", 24000 / 1001),
        ("0.0167", 60), ("0.0417", 24), ("0.0083", 120), ("0.00833", 120), ("0.0333", 30),
        ("0.033", 30), ("0.0334", 30),
        ("0.016683", 60000 / 1001), ("0.3", 1 / 0.3), ("0.0215", 1 / 0.0215),
        ("0.033333344444", 1 / 0.033333344444), ("2", 0.5),
    ],
)  # fmt: skip
def test_the_rate_that_a_rounded_frame_time_stands_for(tmp_path, text, rate):
    finding = frame_rate(text, Source(tmp_path, b""))
    assert finding.value == rate
    assert text in finding.reason


def test_a_vertical_of_z_is_found_and_turned(tmp_path):
    text = PLAIN.replace("0 70 0", "0 0 70").replace("10 -90 0", "10 0 -90").replace("0 20 0", "0 0 20")
    text = text[: text.index("1 95 3")] + "1 3 95 0 0 0 0 0 0 0 0 0\n2 4 96 0 0 0 0 0 0 0 0 0\n"
    reading = read(tmp_path, text)
    assert (reading.findings["up"].value, reading.findings["up"].how) == ("z", "guessed")
    (motion,) = reading.recordings
    np.testing.assert_allclose(motion.skeleton.offsets, [[0, 0, 0], [0, 0.7, 0], [0.1, -0.9, 0]], atol=1e-12)
    np.testing.assert_allclose(forward_kinematics(motion).positions[0, 1], [0.01, 1.65, -0.03], atol=1e-12)


def test_turning_the_axes_turns_every_place(tmp_path):
    as_is = forward_kinematics(read(tmp_path, PLAIN, up="y", unit="cm").recordings[0]).positions
    turned = forward_kinematics(read(tmp_path, PLAIN, up="z", unit="cm").recordings[0]).positions
    np.testing.assert_allclose(
        turned, np.stack([as_is[..., 0], as_is[..., 2], -as_is[..., 1]], -1), atol=1e-12
    )


# --- the writer


def random_motion(rng, joints=9, frames=5, moving=()):
    parents = np.array([-1, *(rng.integers(0, k) for k in range(1, joints))])
    offsets = rng.normal(0, 0.3, (joints, 3))
    skeleton = Skeleton(
        tuple(f"joint {k}" for k in range(joints)), parents, offsets, [joints - 1], [[0, 0.1, 0]]
    )
    positions = np.tile(offsets, (frames, 1, 1))
    positions[:, [0, *moving]] += rng.normal(0, 0.5, (frames, 1 + len(moving), 3))
    quaternions = rotations.normalize(rng.normal(size=(frames, joints, 4)))
    return Motion(skeleton, positions, rotations.continuous(quaternions), 119.88, "clip")


@pytest.mark.parametrize("unit", ["cm", "m", "inch", 0.5])
@pytest.mark.parametrize("moving", [(), (3, 7)])
def test_what_is_written_reads_back(tmp_path, rng, unit, moving):
    motion = random_motion(rng, moving=moving)
    path = io.write(motion, tmp_path / "clip.bvh", unit=unit)
    back = io.read(path, unit=unit, up="y")
    order = [back.skeleton.index(name) for name in motion.skeleton.names]
    assert back.rate == motion.rate
    np.testing.assert_allclose(back.local_positions[:, order], motion.local_positions, atol=1e-6)
    assert rotations.geodesic_angle(back.local_rotations[:, order], motion.local_rotations).max() < 1e-6
    theirs, ours = forward_kinematics(back).positions[:, order], forward_kinematics(motion).positions
    np.testing.assert_allclose(theirs, ours, atol=1e-6)


@pytest.mark.parametrize("rate", [120.0, 30000 / 1001, 119.88, 59.94, 7.3, 1000 / 7, 480.0, 65.0533447265625])
def test_the_rate_is_kept_exactly(tmp_path, rng, rate):
    motion = random_motion(rng).replace(rate=rate)
    assert io.read(io.write(motion, tmp_path / "clip.bvh")).rate == rate


def test_only_joints_that_move_get_positions(tmp_path, rng):
    path = io.write(random_motion(rng, moving=(4,)), tmp_path / "clip.bvh")
    assert path.read_text().count("CHANNELS 6") == 2


TRICKY = [
    "c{",
    "{",
    "}",
    "{}",
    "c {",
    "{c",
    "End Site",
    "MOTION",
    "OFFSET 1 2 3",
    "a\ufeff",
    "a\u2028b",
    "ä:#;",
    "x{{",
]


@given(st.lists(st.text(min_size=1, max_size=6) | st.sampled_from(TRICKY), min_size=3, max_size=3))
@example(["c{", "{", "}"])
@example(["}", "c {", "{}"])
def test_any_name_that_is_written_reads_back(names):
    names = [" ".join(name.split()) or "blank" for name in names]
    assume(len(set(names)) == 3)
    still = np.tile(rotations.IDENTITY, (2, 3, 1))
    motion = Motion(Skeleton(names, [-1, 0, 1], np.eye(3)), np.tile(np.eye(3), (2, 1, 1)), still, 30)
    (take,) = parse(Source(Path("clip.bvh"), write(motion))).takes
    assert take.names == names


def test_a_name_that_is_no_text_is_refused():
    motion = Motion(Skeleton(["\ud800"], [-1], [[0, 0, 0]]), [[[0, 0, 0]]], [[rotations.IDENTITY]], 30)
    with pytest.raises(ParameterError, match="UTF-8"):
        write(motion)


def test_points_are_no_bvh(tmp_path):
    markers = io.read(_marker_table(tmp_path))
    with pytest.raises(ParameterError, match="skeleton"):
        io.write(markers, tmp_path / "clip.bvh")
    with pytest.raises(ParameterError, match="options none, got unit"):
        io.write(markers, tmp_path / "clip.npz", unit="cm")
    with pytest.raises(ParameterError, match=r"written as .*\.bvh"):
        io.write(markers, tmp_path / "clip.fbx")


def assert_comes_back(motion, path, **how):
    reading = io.open_recording(io.write(motion, path, **how))
    (back,) = reading.recordings
    order = [back.skeleton.index(name) for name in motion.skeleton.names]
    np.testing.assert_allclose(
        forward_kinematics(back).positions[:, order], forward_kinematics(motion).positions, atol=1e-6
    )
    return reading


@pytest.mark.parametrize("unit", ["cm", "m", "mm"])
@pytest.mark.parametrize("height", [1.0, 1.2, 1.5, 1.75, 2.1])
def test_a_body_of_any_height_survives_the_way_out_and_in(tmp_path, height, unit):
    motion = compose([Action("squat", 1)], seed=1, rate=15, height=height).motion
    reading = assert_comes_back(motion, tmp_path / "clip.bvh", unit=unit)
    assert reading.findings["unit"].value == unit
    assert any("--unit" in warning for warning in reading.warnings) == (height < 1.25)


def _marker_table(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("time,A_x,A_y,A_z\n0,1,2,3\n0.1,1,2,3\n")
    return path


@pytest.mark.data
@pytest.mark.parametrize("unit", ["cm", "m"])
@pytest.mark.parametrize(
    "name",
    [
        "bandai_namco/dataset-1_walk_normal_001.bvh", "cmu_amc/01_01.amc", "cmu_amc/131_04-dance.amc",
        "cmu_bvh/01_01.bvh", "cmu_bvh/131_03.bvh", "cmu_bvh/jumping_jacks.bvh", "cmu_bvh/crossover.bvh",
        "hdm05/lieDownFloor/HDM_bd_lieDownFloor_001_120.amc", "hdm05/squat1Reps/HDM_bd_squat1Reps_001_120.amc",
        "perfume_dance/A_test.bvh",
    ],
)  # fmt: skip
def test_a_real_recording_survives_the_way_out_and_in(data, tmp_path, name, unit):
    motion = io.read(f"{data / name}[0:600]")
    reading = assert_comes_back(motion, tmp_path / "clip.bvh", unit=unit)
    assert (reading.findings["unit"].value, reading.warnings) == (unit, ())


@pytest.mark.parametrize(
    ("time", "match"),
    [
        ("120", "expected a frame time in seconds, found 120, which looks like the rate.*here --rate 120"),
        ("33.333", "found 33.333, which looks like milliseconds.*here --rate 30"),
        ("16.6667", "looks like milliseconds.*--rate 60"),
        ("8.3333", "looks like milliseconds.*--rate 120"),
    ],
)
def test_a_frame_time_that_is_none_is_refused(tmp_path, time, match):
    text = PLAIN.replace("0.0083333", time)
    with pytest.raises(FormatError, match=match):
        read(tmp_path, text)
    assert read(tmp_path, text, rate=30).recordings[0].rate == 30


@pytest.mark.parametrize(("time", "told"), [("7200", True), ("2", True), ("0.5", False)])
def test_a_long_frame_time_is_told(tmp_path, time, told):
    text = PLAIN.replace("0.0083333", time)
    assert any(f"A frame lasts {time} s" in warning for warning in read(tmp_path, text).warnings) == told
    assert not any("A frame lasts" in warning for warning in read(tmp_path, text, rate=30).warnings)


def test_a_missing_frame_time_shows_both_lines(tmp_path):
    with pytest.raises(FormatError, match="found 'Frames: 2' and '1 95 3 10"):
        read(tmp_path, PLAIN.replace("Frame Time: 0.0083333\n", ""))


# --- what programs make of the format

TREE, REST = PLAIN.split("MOTION\n")
ROWS = REST.partition("0.0083333\n")[2]


def changed(old, new):
    assert old in PLAIN
    return PLAIN.replace(old, new)


def with_rows(change):
    return PLAIN[: -len(ROWS)] + change(ROWS)


@pytest.mark.parametrize(
    "text",
    [
        changed("\n", "\r"),
        changed("\n", "\r\r\n"),
        PLAIN.encode("utf-16"),
        PLAIN.encode("utf-16-le"),
        PLAIN + "\x1a",
        "# made by hand\n// twice\n\n" + PLAIN,
        changed("  JOINT Head", "# remark\n  // another\n  JOINT Head"),
        changed("HIERARCHY\nROOT", "HIERARCHY ROOT"),
        changed("\nMOTION", "\n  Motion: "),
        changed("Frames: 2\nFrame Time: ", "Frames:2\nFrame Time:"),
        changed("Frames: 2\nFrame Time: ", "Frames 2 Frame Time "),
        changed("Frames: 2\nFrame Time: 0.0083333", "FrameTime: 0.0083333\n\nFRAMES:\t2"),
        changed("Frame Time: 0.0083333", "Frame Time: 0,0083333"),
        changed("OFFSET 10 -90 0", "OFFSET 10,0 -90,00 0"),
        changed("OFFSET 10 -90 0", "OFFSET 10, -90, 0"),
        changed("OFFSET 0 20 0\n    }\n  }", "OFFSET 0 20 0 } }"),
        changed("End Site", "End Site HeadTop"),
        changed("End Site", "End"),
        changed("End Site", "EndSite"),
        changed("End Site", "end_site"),
        changed("OFFSET 0 20 0", "OFFSET 0 20 0\n      CHANNELS 0"),
        with_rows(lambda rows: rows.replace(" ", ",0 ").replace("\n", ",0\n")),
        with_rows(lambda rows: rows.replace(" ", ",")),
        with_rows(lambda rows: rows.replace(" ", ", ")),
        with_rows(lambda rows: rows.replace(" ", "  \t").replace("\n", " \n\n")),
        with_rows(lambda rows: rows.replace("10 20", "1e1 2.0E+01").replace(" 3 ", " +3. ")),
    ],
)
def test_quirks_that_change_nothing(tmp_path, text):
    reading = read(tmp_path, text)
    assert reading.recordings == read(tmp_path, PLAIN).recordings
    assert reading.warnings == ()


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            changed("Frames: 2", "Frames: two"),
            "states 'two' as the count of frames; the 2 that the file has were read",
        ),
        (changed("Frames: 2\n", ""), "does not state the count of frames; the 2"),
        (changed("Frames: 2", "Frames: 0"), "promises 0 frames, the file has 2"),
        (changed("Frames: 2", "Frames: -3"), "promises -3 frames, the file has 2"),
        (PLAIN + "made by hand\n", "The last line is no row of numbers and was left out: 'made by hand'."),
        (PLAIN + "# 1 2 3", "no row of numbers and was left out: '# 1 2 3'."),
        (
            with_rows(lambda rows: rows.replace(" 30 ", " 30\n")),
            "Lines are no frames: the numbers, as many as promised",
        ),
        (with_rows(lambda rows: rows.replace("\n", " ")), "Lines are no frames"),
        (with_rows(lambda rows: rows.replace(" ", "\n")), "Lines are no frames"),
    ],
)
def test_quirks_that_are_told(tmp_path, text, told):
    reading = read(tmp_path, text)
    assert reading.recordings == read(tmp_path, PLAIN).recordings
    assert len(reading.warnings) == 1
    assert told in reading.warnings[0]


def test_numbers_in_lines_that_are_no_frames_name_their_line_all_the_same(tmp_path):
    text = with_rows(lambda rows: rows.replace(" 30 ", " 30\n").replace("51", "x"))
    with pytest.raises(FormatError, match="line 26: expected a number, found 'x'"):
        read(tmp_path, text)
    with pytest.raises(FormatError, match="line 24: expected 12 numbers in the row, found 6"):
        read(tmp_path, with_rows(lambda rows: rows.replace(" 30 ", " 30\n") + "1"))  # not as many as promised


def channels(text, first, second):
    """The file with other channels of the left foot."""
    spelled = PLAIN.replace("    CHANNELS 3 Yrotation Zrotation Xrotation\n", text)
    return spelled.replace(" 70 80 90", first).replace(" 71 81 91", second)


@pytest.mark.parametrize(
    ("text", "first", "turns", "place"),
    [
        ("", "", "", [10, -90, 0]),
        ("CHANNELS 0\n", "", "", [10, -90, 0]),
        ("CHANNELS 1 Zrotation\n", " 30", "z", [10, -90, 0]),
        ("CHANNELS 2 Xrotation Zrotation\n", " 30 40", "xz", [10, -90, 0]),
        ("CHANNELS 2 Yposition Xrotation\n", " -95 40", "x", [10, -95, 0]),
        ("CHANNELS 3 Xposition Yposition Zposition\n", " 1 -95 3", "", [1, -95, 3]),
        ("CHANNELS 3 Yrotation Zrotation Yrotation\n", " 10 20 30", "yzy", [10, -90, 0]),
        ("channels 4 xRotation Zposition YROTATION zrotation\n", " 10 7 20 30", "xyz", [10, -90, 7]),
        (
            "CHANNELS 5 Yrotation Zrotation Xrotation Yrotation Zrotation\n",
            " 1 2 3 4 5",
            "yzxyz",
            [10, -90, 0],
        ),
    ],
)
def test_any_channels(tmp_path, text, first, turns, place):
    motion = read(tmp_path, channels(text, first, first), unit="cm").recordings[0]
    values = [float(word) for word in first.split()]
    spoken = [word for word in text.split()[2:]]
    angles = [value for word, value in zip(spoken, values, strict=True) if "rot" in word.lower()]
    expected = rotations.IDENTITY
    for letter, angle in zip(turns, angles, strict=True):
        expected = rotations.multiply(expected, rotations.from_axis_angle(letter, np.deg2rad(angle)))
    assert rotations.geodesic_angle(motion.local_rotations[0, 2], expected) < 1e-7
    np.testing.assert_allclose(motion.local_positions[0, 2], np.array(place) / 100)


def test_channels_that_mean_nothing_here_are_left_out_and_told(tmp_path):
    scaled = channels(
        "CHANNELS 6 Yrotation Zrotation Xrotation Xscale Yscale Zscale\n",
        " 70 80 90 1 1 1",
        " 71 81 91 1 1 1",
    )
    ended = (
        PLAIN.replace("OFFSET 0 20 0", "OFFSET 0 20 0\nCHANNELS 3 Zrotation Xrotation Yrotation")
        .replace("50 60", "50 60 1 2 3")
        .replace("51 61", "51 61 4 5 6")
    )
    for text in (scaled, ended):
        reading = read(tmp_path, text)
        assert reading.recordings == read(tmp_path, PLAIN).recordings
        assert reading.warnings == ("Channels of scale or of end sites were left out, 3 in number.",)


def test_a_joint_without_an_offset_is_told(tmp_path):
    reading = read(tmp_path, changed("    OFFSET 10 -90 0\n", ""), unit="cm")
    np.testing.assert_array_equal(reading.recordings[0].skeleton.offsets[2], 0)
    assert reading.warnings == ("Joints without an OFFSET were taken to have 0 0 0: LeftFoot.",)


@pytest.mark.parametrize(
    ("old", "new", "match"),
    [
        ("OFFSET 10 -90 0", "OFFSET 10 -90 0\nOFFSET 1 2 3", "line 18: expected OFFSET once a joint"),
        (
            "OFFSET 10 -90 0",
            "OFFSET 10 -90 1e300",
            "expected an offset of joint 'LeftFoot', found 10, -90, 1e.300",
        ),
        (
            "    CHANNELS 3 Y",
            "    CHANNELS 3 Xrotation Yrotation Zrotation\n    CHANNELS 3 Y",
            "line 19: .*once a joint",
        ),
        (
            "ROOT Hips\n{\n",
            "ROOT Hips { OFFSET 0 0 0 ",
            "line 2: expected a line for each joint, OFFSET and CHANNELS",
        ),
        ("20 30", "1e300 30", r"line 24: expected a number below 1e\+150, found '1e300'"),
        (
            "1 95 3",
            "1e20 95 3",
            "expected a place of joint 'Hips' in frame 0, found 1e.20, 95, 3. Was the file damaged",
        ),
        (
            "Frame Time: 0.0083333",
            "Frame Time: 1e-320",
            "expected a frame time above 0 s, found '1e-320'.*--rate",
        ),
        ("Frame Time: 0.0083333", "Frame Time: 99e999", "expected a frame time above 0 s"),
        ("Frame Time: 0.0083333\n", "", "line 22: expected the lines 'Frames:' and 'Frame Time:'.*--rate HZ"),
        (ROWS, "", "expected at least one row of numbers after the frame time"),
    ],
)
def test_more_faults_name_their_line(tmp_path, old, new, match):
    with pytest.raises(FormatError, match=match):
        read(tmp_path, changed(old, new))


def test_a_rate_given_takes_the_place_of_a_frame_time(tmp_path):
    assert (
        read(tmp_path, changed("Frame Time: 0.0083333\n", ""), rate=120).recordings
        == read(tmp_path, PLAIN).recordings
    )


def test_a_chain_of_thousands_of_joints_is_read(tmp_path):
    count = 3000
    text = "HIERARCHY\n" + "".join(
        f"{'JOINT' if k else 'ROOT'} j{k}\n{{\nOFFSET 0 1 0\nCHANNELS 1 Zrotation\n" for k in range(count)
    )
    text += "}\n" * count + "MOTION\nFrames: 1\nFrame Time: 0.01\n" + "0 " * count + "\n"
    assert len(read(tmp_path, text, unit="cm").recordings[0].skeleton) == count
