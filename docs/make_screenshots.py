"""Take a picture of every view of the page, and draw motion graphs: ``python docs/make_screenshots.py [VIEW...]``.

Needs the folder of recordings (``LEITMOTION_DATA``) and a Chromium (``CHROMIUM``, or its usual names on PATH). The
pictures lie in ``screenshots/``; ``page.md`` shows them. Keep them beside an older set before a change of the page.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from typing import Any, NamedTuple

import leitmotion as lm
from leitmotion.datasets import compose_motif
from leitmotion.io import read_annotations
from leitmotion.view import plot_graph

SCREENSHOTS = Path(__file__).resolve().parent / "screenshots"
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
WALK, LIE = "cmu86/86_01.amc", "hdm05/lieDownFloor/*.amc"
SEVERAL = "mocap6/13_*.amc"
KICKS = "side kicks"
GRAPHS = ("side kicks", "sun salutation")
PAPER = 688
DENSITY = 1.5


class View(NamedTuple):
    """One picture: which recording, how wide, what the address says, and what is done before it is taken."""

    name: str
    recording: str = WALK
    address: str = "t=19.7"
    width: int = 1440
    height: int = 900
    dark: bool = False
    whole: bool = False
    prepare: Callable[[Any], None] = lambda page: None


def point_at_a_cell(page: Any) -> None:
    """Move the pointer to the cell of 0:19.3 and 0:36.3."""
    field = page.evaluate("leitmotion.matrix")
    scale = field["side"] / page.evaluate("leitmotion.payload.source.seconds")
    box = page.locator("#matrix").bounding_box()
    page.mouse.move(box["x"] + field["left"] + 36.3 * scale, box["y"] + field["upper"] + 19.3 * scale)


def hold_a_stripe(page: Any) -> None:
    """Drag a little way along the first stripe."""
    field = page.evaluate("leitmotion.matrix")
    scale = field["side"] / page.evaluate("leitmotion.payload.source.seconds")
    box = page.locator("#matrix").bounding_box()
    path = page.evaluate("leitmotion.stripes[0].path")
    for k, act in ((0, page.mouse.down), (len(path) // 4 * 2, page.mouse.up)):
        page.mouse.move(
            box["x"] + field["left"] + path[k + 1] * scale, box["y"] + field["upper"] + path[k] * scale
        )
        act()
    page.mouse.move(700, 40)


def on_paper(page: Any) -> None:
    """Lay the page out as it is printed."""
    page.set_viewport_size({"width": PAPER, "height": 900})
    page.emulate_media(media="print")


VIEWS = (
    View("desktop-light"),
    View("desktop-dark", address="t=30.2", dark=True),
    View("linked-hover", prepare=point_at_a_cell),
    View("held-on-stripe", prepare=hold_a_stripe),
    View("pattern-chosen", address="t=35.4&pattern=B"),
    View("lesson", address="pattern=B&take=2&t=17.3"),
    View("shared", recording=SEVERAL, address="pattern=D&take=1&beside=1&t=42.1"),
    View("symmetry", address="view=symmetry&t=22.3"),
    View("graph", recording=KICKS, address="view=graph&item=aa&visit=2&camera=front&t=3.2"),
    View("empty", recording=LIE, address="t=2.2"),
    View("tablet", width=900, height=1300, whole=True),
    View("tablet-pair", width=900, height=1000, address="t=19.3&u=36.3"),
    View("phone", width=390, height=844, address="t=7.1", whole=True),
    View("print", prepare=on_paper, whole=True),
)


def main() -> int:
    """Write every picture, small enough to keep."""
    data = Path(os.environ.get("LEITMOTION_DATA", ""))
    browser = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if not os.environ.get("LEITMOTION_DATA") or not data.is_dir():
        print("LEITMOTION_DATA must name the folder of recordings.", file=sys.stderr)
        return 1
    if browser is None:
        print("A Chromium must be on PATH or named by CHROMIUM.", file=sys.stderr)
        return 1
    SCREENSHOTS.mkdir(exist_ok=True)
    draw_graphs()
    with tempfile.TemporaryDirectory() as folder:
        pages = {}
        for recording in (WALK, LIE):
            path = next(data.glob(recording))
            labels, name = None, ""
            if recording == WALK:
                name = "mocap.txt"
                labels = read_annotations(path.with_name(name), rate=120, trial=path.stem)
            target = Path(folder) / f"{path.stem}.html"
            pages[recording] = lm.report(lm.read(path), target, labels=labels, labels_from=name)
        several = [lm.read(path) for path in sorted(data.glob(SEVERAL))]
        pages[KICKS] = lm.report(compose_motif(KICKS, seed=1, rate=60.0).motion, Path(folder) / "kicks.html")
        pages[SEVERAL] = lm.report_shared(several, Path(folder) / "shared.html")
        take(browser, pages)
    return 0


def draw_graphs() -> None:
    """Draw the graphs of composed motions."""
    from PIL import Image

    for name in GRAPHS:
        path = SCREENSHOTS / f"graph-{name.replace(' ', '-')}.webp"
        if sys.argv[1:] and path.stem not in sys.argv[1:]:
            continue
        motion = compose_motif(name, rate=60.0, variation=None).motion
        picture = BytesIO()
        plot_graph(lm.motion_graph(motion), motion).savefig(picture, format="png")
        with Image.open(picture) as drawn:
            drawn.convert("RGB").save(path, quality=90, method=6)
        print(path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path)


def take(browser: str, pages: dict[str, Path]) -> None:
    """Open each page as its view wants it and keep what is seen."""
    from PIL import Image
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play:
        chromium = play.chromium.launch(executable_path=browser, args=["--no-sandbox", "--disable-gpu"])
        for view in VIEWS:
            if sys.argv[1:] and view.name not in sys.argv[1:]:
                continue
            context = chromium.new_context(
                viewport={"width": view.width, "height": view.height},
                device_scale_factor=DENSITY,
                color_scheme="dark" if view.dark else "light",
            )
            page = context.new_page()
            page.goto(f"{pages[view.recording].as_uri()}#{view.address}")
            view.prepare(page)
            page.wait_for_timeout(400)
            path = SCREENSHOTS / f"{view.name}.webp"
            size = page.viewport_size
            if view.whole:
                size["height"] = page.evaluate(
                    "Math.ceil(document.getElementById('app').getBoundingClientRect().bottom)"
                )
                page.set_viewport_size(size)
                page.wait_for_timeout(200)
            with Image.open(BytesIO(page.screenshot())) as picture:
                picture.convert("RGB").save(path, quality=90, method=6)
            print(path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path)
            context.close()
        chromium.close()


if __name__ == "__main__":
    sys.exit(main())
