"""Make the pictures of the documentation anew, from real recordings: ``make docs-pictures``.

Needs the folder of recordings (``LEITMOTION_DATA``) and a Chromium (``CHROMIUM``, or its usual names on PATH).
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import leitmotion as lm

PICTURES = Path(__file__).resolve().parent / "pictures"
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


class Picture(NamedTuple):
    """A view of the page of a recording."""

    name: str
    recording: str
    width: int
    height: int
    dark: bool = False
    keys: tuple[str, ...] = ()


WANTED = (
    Picture("report", "cmu86/86_01.amc", 1440, 900),
    Picture("report-dark", "cmu86/86_01.amc", 1440, 900, dark=True),
    Picture("report-tablet", "cmu_bvh/jumping_jacks.bvh", 900, 1200),
    Picture("report-phone", "cmu_bvh/jumping_jacks.bvh", 390, 844),
)


def main() -> int:
    """Write every picture, whole."""
    data = Path(os.environ.get("LEITMOTION_DATA", ""))
    browser = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if not os.environ.get("LEITMOTION_DATA") or not data.is_dir():
        print("LEITMOTION_DATA must name the folder of recordings.", file=sys.stderr)
        return 1
    if browser is None:
        print("A Chromium must be on PATH or named by CHROMIUM.", file=sys.stderr)
        return 1
    PICTURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        pages = {
            recording: lm.report(lm.read(data / recording), Path(folder) / f"{Path(recording).stem}.html")
            for recording in sorted({picture.recording for picture in WANTED})
        }
        take(browser, pages)
    return 0


def take(browser: str, pages: dict[str, Path]) -> None:
    """Photograph the pages."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play:
        chromium = play.chromium.launch(executable_path=browser, args=["--no-sandbox", "--disable-gpu"])
        for picture in WANTED:
            page = chromium.new_page(
                viewport={"width": picture.width, "height": picture.height},
                color_scheme="dark" if picture.dark else "light",
                reduced_motion="reduce",
            )
            page.goto(pages[picture.recording].as_uri())
            page.wait_for_timeout(1500)
            for key in picture.keys:
                page.keyboard.press(key)
            target = PICTURES / f"{picture.name}.png"
            page.screenshot(path=target)
            print(f"{target.relative_to(PICTURES.parent.parent)}: {target.stat().st_size // 1024} KiB")
            page.close()
        chromium.close()


if __name__ == "__main__":
    sys.exit(main())
