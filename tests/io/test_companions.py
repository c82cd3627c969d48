"""Files that belong together, by their names."""

import json
import zipfile
from pathlib import Path

import pytest

from leitmotion import io
from leitmotion.io.companions import first_frame_in, frame_of, partners, represented
from leitmotion.motion import FormatError


def test_frames_are_told_by_their_numbers():
    assert frame_of("clip_000000000012_keypoints.json") == ("clip", 12)
    assert frame_of("take_2_7_KEYPOINTS.json") == ("take_2", 7)
    assert frame_of("0_keypoints.json") == ("", 0)
    assert frame_of("keypoints.json") is None
    assert frame_of("clip_12.json") is None


def test_the_first_frame_stands_for_its_clip_and_positions_for_their_angles():
    folder = Path("a")
    files = [folder / f"clip_{k}_keypoints.json" for k in (10, 9, 11)]
    files += [folder / "Positions" / "m_positions.txt", folder / "Angles" / "m_angles.txt"]
    files += [folder / "alone_angles.txt", folder / "walk.bvh"]
    assert represented(files) == {files[0], files[2], files[4]}
    assert partners(files[4])[1] == files[3]
    assert partners(folder / "walk.bvh") == []


def test_a_folder_of_several_clips_names_them(tmp_path):
    assert first_frame_in(tmp_path) == tmp_path
    for name in ("b_2_keypoints.json", "b_1_keypoints.json"):
        (tmp_path / name).touch()
    assert first_frame_in(tmp_path) == tmp_path / "b_1_keypoints.json"
    (tmp_path / "a_1_keypoints.json").touch()
    with pytest.raises(FormatError, match="the poses of 2 clips: 'a', 'b'"):
        first_frame_in(tmp_path)


def test_a_zip_of_frames_is_one_recording(tmp_path):
    pose = [float(k % 3 + k) for k in range(75)]
    with zipfile.ZipFile(tmp_path / "clip.zip", "w") as box:
        for t in range(20):
            people = [{"pose_keypoints_2d": [t + value for value in pose]}]
            box.writestr(f"json/clip_{t:012d}_keypoints.json", json.dumps({"people": people}))
    read = io.read(tmp_path / "clip.zip")
    assert len(read) == 20
    assert read.positions[5, 0].tolist() == [5.0, -7.0]
    assert io.read(tmp_path / "clip.zip" / "json" / "clip_000000000003_keypoints.json") == read


def test_a_zip_of_two_halves_is_one_recording(tmp_path):
    row = ",".join(["1.5"] * 66) + "\n"
    with zipfile.ZipFile(tmp_path / "m01.zip", "w") as box:
        for kind in ("Positions", "Angles"):
            box.writestr(f"{kind}/m01_{kind.lower()}.txt", row * 30)
    assert len(io.read(tmp_path / "m01.zip", unit="cm")) == 30
