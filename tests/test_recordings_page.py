"""The page of recordings and its sheets: made alike each time, and of no machine in particular."""

import importlib
import sys
import zipfile
from pathlib import Path
from types import ModuleType

import pytest

import leitmotion as lm
from leitmotion.datasets import Action, compose
from leitmotion.motion import joint_points

DOCS = Path(__file__).resolve().parents[1] / "docs"


@pytest.fixture
def maker(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.setattr(sys, "path", [str(DOCS), *sys.path])
    module = importlib.import_module("make_recordings")
    monkeypatch.setattr(module, "PAGE", tmp_path / "recordings.md")
    monkeypatch.setenv("LEITMOTION_DATA", str(tmp_path / "data"))
    monkeypatch.setenv("LEITMOTION_CACHE", str(tmp_path / "cache"))
    motion = compose([Action("squat", 1)], rate=30, name="b").motion
    lm.write(motion, tmp_path / "data" / "b" / "b.bvh")
    lm.write(joint_points(motion), tmp_path / "data" / "a.npz")
    for name in ("x.bvh", "y.bvh"):
        (tmp_path / "data" / name).write_text("HIERARCHY\n", encoding="utf-8")
    (tmp_path / "data" / "notes.md").write_text("notes", encoding="utf-8")
    with zipfile.ZipFile(tmp_path / "data" / "more.zip", "w") as box:
        for k in range(20):
            box.write(tmp_path / "data" / "b" / "b.bvh", f"in/{k:02d}.bvh")
    return module


def test_the_page_is_the_same_each_time_and_names_no_folder_of_the_machine(
    maker: ModuleType, tmp_path: Path
) -> None:
    assert maker.main([]) == 0
    text = maker.PAGE.read_text(encoding="utf-8")
    rows = [line.split(" | ") for line in text.splitlines() if line.startswith("| ")]
    names = [row[0].removeprefix("| ") for row in rows]
    assert names == [
        "recording", "a.npz", "b/b.bvh", *[f"more.zip/in/{k:02d}.bvh" for k in (0, 4, 8, 12, 16)],
        "files", "x.bvh and 1 more",
    ]  # fmt: skip
    assert rows[1][1:6] == ["archive", rows[2][2], "30 Hz", "m", "y"]
    assert rows[2][4] == "cm?"
    assert "15" in rows[2]
    assert str(tmp_path) not in text
    maker.main([])
    assert maker.PAGE.read_text(encoding="utf-8") == text


def test_every_recording_is_drawn(maker: ModuleType, tmp_path: Path) -> None:
    assert maker.main([str(tmp_path / "sheets")]) == 0
    (sheet,) = (tmp_path / "sheets").iterdir()
    assert sheet.read_bytes()[:4] == b"\x89PNG"
    from matplotlib import image

    pixels = image.imread(sheet)[..., :3]
    red = (pixels[..., 0] > 0.6) & (pixels[..., 1:] < 0.3).all(axis=2)
    blue = (pixels[..., 2] > 0.6) & (pixels[..., 0] < 0.25)
    cell = pixels.shape[1] // 7
    for k in range(7):  # the person faces the viewer: the left is on the right
        columns = slice(k * cell, (k + 1) * cell)
        rows = slice(0, pixels.shape[0] // 4)
        assert red[rows, columns].any()
        assert red[rows, columns].nonzero()[1].mean() > blue[rows, columns].nonzero()[1].mean()


def test_without_recordings_it_says_so(
    maker: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv("LEITMOTION_DATA")
    assert maker.main([]) == 2
    assert "LEITMOTION_DATA must name" in capsys.readouterr().err
