"""Files that belong together, by their names."""

from pathlib import Path

import pytest

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
