"""Every state of the page: idle, pointing, held, led along a stripe, a pattern chosen, a bar pointed at; keys; hash."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytestmark = pytest.mark.browser

Open = Callable[..., Any]


def state(page: Any) -> dict[str, Any]:
    """What the page tells of itself, once it has drawn."""
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    told: dict[str, Any] = page.evaluate("leitmotion.state")
    return told


def cell(page: Any, one: float, two: float) -> tuple[float, float]:
    """Where the cell of two moments lies on the screen."""
    box = page.locator("#matrix").bounding_box()
    at = page.evaluate("leitmotion.matrix")
    scale = at["side"] / page.evaluate("leitmotion.payload.source.seconds")
    return box["x"] + at["left"] + two * scale, box["y"] + at["upper"] + one * scale


def line(page: Any, which: int) -> float:
    """Where a line of the time line stands, as a moment; NaN where it is hidden."""
    x = (
        page.locator(".moment")
        .nth(which)
        .evaluate("(line) => (line.hidden ? NaN : line.getBoundingClientRect().x)")
    )
    at = page.evaluate("leitmotion.timeline")
    seconds = page.evaluate("leitmotion.payload.source.seconds")
    left = page.locator("#timeline").bounding_box()["x"] + 1 + at["left"]
    return float((x - left) / at["width"] * seconds)


def test_idle_shows_now_and_what_is_most_like_it(page: Any) -> None:
    now = state(page)
    assert not now["playing"]
    assert now["hover"] is None
    assert not now["held"]
    panel = page.locator("#panel")
    assert panel.locator("h2").inner_text() == "Most like now"
    near = panel.locator(".near")
    assert near.count() == 3
    moments = [20.2] + [
        60 * int(m) + float(s) for m, s in (t.split(":") for t in near.locator("b").all_inner_texts())
    ]
    assert np.diff(np.sort(moments)).min() > 0.85
    cap = page.evaluate("leitmotion.payload.distance.cap * 100")
    assert all(float(text.split()[0]) <= cap for text in near.locator("small").all_inner_texts())
    assert line(page, 0) == pytest.approx(20.2, abs=0.05)
    assert np.isnan(line(page, 1))
    assert page.locator(".moment b").first.inner_text() == "0:20.2"
    assert page.locator("#clock").inner_text() == "0:20.2"


def test_pointing_at_a_cell_shows_the_pair(page: Any) -> None:
    page.mouse.move(*cell(page, 12.0, 14.0))
    now = state(page)
    assert now["hover"] == pytest.approx({"one": 12.0, "two": 14.0}, abs=0.1)
    assert not now["held"]
    panel = page.locator("#panel")
    assert panel.locator("h2").inner_text() == "Two moments"
    assert panel.locator("figure").count() == 2
    assert panel.locator(".apart b").inner_text().replace(".", "").isdigit()
    assert panel.locator(".joints i").count() == 5
    assert "Both in pattern" in panel.locator(".verdict").inner_text()
    assert line(page, 0) == pytest.approx(12.0, abs=0.1)
    assert line(page, 1) == pytest.approx(14.0, abs=0.1)
    assert page.locator(".moment b").all_inner_texts()[1].startswith("2 0:1")
    page.mouse.move(700, 40)
    assert state(page)["hover"] is None
    assert state(page)["time"] == pytest.approx(20.2)


def test_the_other_half_is_folded_over(page: Any) -> None:
    page.mouse.move(*cell(page, 30.0, 10.0))
    assert state(page)["hover"] == pytest.approx({"one": 10.0, "two": 30.0}, abs=0.1)


def test_the_number_is_the_distance_of_the_matrix(page: Any, known: Any) -> None:
    for one, two in ((3.0, 54.0), (12.0, 14.0), (5.0, 45.0)):
        told = page.evaluate("([a, b]) => leitmotion.compare(a, b).distance", [one, two])
        wanted = known.matrix.values[round(one * 30), round(two * 30)] * known.matrix.scale
        assert told == pytest.approx(wanted, abs=0.0012)


def test_pointing_neither_dims_nor_scrolls(page: Any) -> None:
    before = page.evaluate("[scrollX, scrollY]")
    page.mouse.move(*cell(page, 12.0, 14.0))
    state(page)
    assert page.locator(".dimmed").count() == 0
    assert page.evaluate("[scrollX, scrollY]") == before


def test_a_click_holds_the_pair_until_escape(page: Any) -> None:
    page.mouse.click(*cell(page, 12.0, 14.0))
    now = state(page)
    assert now["held"]
    assert now["time"] == pytest.approx(12.0, abs=0.1)
    assert now["second"] == pytest.approx(14.0, abs=0.1)
    page.mouse.move(700, 40)
    assert state(page)["held"]
    assert page.locator("#panel h2").inner_text() == "Two moments"
    page.keyboard.press("Escape")
    now = state(page)
    assert not now["held"]
    assert now["time"] == pytest.approx(12.0, abs=0.1)


def test_a_click_beside_lets_the_pair_go(page: Any) -> None:
    page.mouse.click(*cell(page, 12.0, 14.0))
    x, y = cell(page, 0.0, 0.0)
    page.mouse.click(x + 40, y - 40)
    assert not state(page)["held"]
    page.mouse.click(*cell(page, 12.0, 14.0))
    assert state(page)["held"]
    page.mouse.click(800, 75)
    assert not state(page)["held"]


def test_a_drag_follows_the_warping_path(page: Any) -> None:
    stripe = page.evaluate("leitmotion.stripes.findIndex((s) => s.pattern === 1)")
    path = np.array(page.evaluate(f"leitmotion.stripes[{stripe}].path")).reshape(-1, 2)
    first, last = path[3], path[-4]
    x0, y0 = cell(page, *first)
    x1, y1 = cell(page, *last)
    page.mouse.move(x0, y0)
    page.mouse.down()
    seen = []
    for part in np.linspace(0.2, 1, 5):
        # Three pixels beside the stripe: within reach of it.
        page.mouse.move(x0 + part * (x1 - x0) + 3, y0 + part * (y1 - y0) - 3)
        now = state(page)
        assert now["stripe"] is not None
        seen.append((now["time"], now["second"], line(page, 0), line(page, 1)))
        on_path = np.hypot(*(path - [now["time"], now["second"]]).T).min()
        assert on_path < 0.05
    page.mouse.up()
    seen = np.array(seen)
    assert (np.diff(seen, axis=0) > 0).all()
    assert state(page)["held"]
    page.mouse.move(700, 40)
    page.keyboard.press(" ")
    page.wait_for_timeout(250)
    later = state(page)
    page.keyboard.press(" ")
    assert later["playing"]
    assert (later["time"], later["second"]) != (seen[-1][0], seen[-1][1])


def test_a_drag_beside_every_stripe_is_free(page: Any) -> None:
    page.mouse.move(*cell(page, 5.0, 40.0))
    page.mouse.down()
    page.mouse.move(*cell(page, 6.0, 43.0), steps=3)
    now = state(page)
    page.mouse.up()
    assert now["stripe"] is None
    assert now["second"] == pytest.approx(43.0, abs=0.1)


def test_a_chosen_pattern_loops_its_stretches_in_turn(page: Any) -> None:
    page.locator(".lane-head").first.click()
    now = state(page)
    assert now["pattern"] == 0
    assert now["playing"]
    assert page.locator("#looping").inner_text() == "Looping A, stretch 1 of 2"
    first, second = page.evaluate("leitmotion.payload.patterns[0].stretches")
    page.keyboard.press("]")
    page.keyboard.press(" ")
    assert first["start"] <= state(page)["time"] < first["stop"]
    dim = page.locator(".lane:not(.chosen) .stretch").first
    page.wait_for_timeout(160)
    assert float(dim.evaluate("(bar) => getComputedStyle(bar).opacity")) == pytest.approx(0.3)
    assert page.locator(".stretch.playing").count() == 1
    page.keyboard.press("ArrowRight")
    stop = first["stop"] - 0.05
    page.evaluate(f"location.hash = location.hash.replace(/t=[^&]*/, 't={stop}')")
    page.wait_for_timeout(100)
    assert state(page)["pattern"] == 0
    page.keyboard.press(" ")
    page.wait_for_timeout(400)
    now = state(page)
    assert now["loop"] == 1
    assert second["start"] <= now["time"] < second["stop"]
    assert page.locator("#looping").inner_text() == "Looping A, stretch 2 of 2"
    page.keyboard.press("Escape")
    now = state(page)
    assert now["pattern"] is None
    assert not now["playing"]


def test_pointing_at_a_bar_widens_its_stripes_and_tells(page: Any) -> None:
    page.locator(".stretch").nth(2).hover()
    now = state(page)
    assert now["bar"] == 1
    tip = page.locator("#tip")
    assert tip.is_visible()
    assert tip.inner_text() == page.evaluate("leitmotion.payload.patterns[1].stretches[0].tip")
    assert now["time"] == pytest.approx(20.2)
    page.mouse.move(700, 40)
    assert state(page)["bar"] is None
    assert tip.is_hidden()


def test_keys(page: Any) -> None:
    frame = 1 / 30
    page.keyboard.press("ArrowRight")
    assert state(page)["time"] == pytest.approx(20.2 + frame)
    page.keyboard.press("Shift+ArrowLeft")
    assert state(page)["time"] == pytest.approx(19.2 + frame)
    page.keyboard.press("b")
    assert state(page)["pattern"] == 1
    page.keyboard.press(" ")
    assert not state(page)["playing"]
    page.keyboard.press("Escape")
    assert state(page)["pattern"] is None
    for key, speed in (("]", 2), ("]", 2), ("[", 1), ("[", 0.5)):
        page.keyboard.press(key)
        assert state(page)["speed"] == speed
    for key, camera in (("2", "front"), ("3", "side"), ("4", "top"), ("1", "room")):
        page.keyboard.press(key)
        assert state(page)["camera"] == camera
    page.keyboard.press("?")
    assert page.locator("#help-sheet").is_visible()
    page.keyboard.press("Escape")
    assert page.locator("#help-sheet").is_hidden()
    page.keyboard.press("m")
    assert page.locator("#tip").inner_text() == "The symmetry of this recording was not computed."


def test_arrow_keys_on_the_matrix_move_the_cell(page: Any) -> None:
    page.locator("#matrix").focus()
    page.keyboard.press("ArrowRight")
    first = state(page)["hover"]
    page.keyboard.press("Shift+ArrowRight")
    page.keyboard.press("ArrowDown")
    second = state(page)["hover"]
    assert second["two"] > first["two"]
    assert second["one"] > first["one"]
    page.keyboard.press("Enter")
    now = state(page)
    assert now["held"]
    assert now["time"] == pytest.approx(second["one"])
    page.keyboard.press("Escape")
    assert not state(page)["held"]


def test_the_address_opens_the_same_view(open_page: Open, practice: Path, page: Any) -> None:
    page.mouse.click(*cell(page, 12.0, 14.0))
    page.keyboard.press("3")
    page.keyboard.press("]")
    page.locator("#theme").click()
    page.locator("[data-toggle=trails]").first.click()
    page.wait_for_timeout(350)
    again = open_page(practice, page.evaluate("location.hash").lstrip("#"))
    told, kept = state(again), state(page)
    for name in ("time", "second"):
        assert told[name] == pytest.approx(kept[name], abs=0.01)
    for name in ("held", "pattern", "camera", "speed", "theme", "trails", "ghost", "follow", "names"):
        assert told[name] == kept[name]


@pytest.mark.parametrize(
    "hash_", ["t=NaN&u=-4&camera=%00&pattern=ZZ&speed=9", "t=1e9&zoom=abc&name.=x", "&&&=%E0%A4%A"]
)
def test_a_broken_address_opens_the_page_all_the_same(open_page: Open, practice: Path, hash_: str) -> None:
    now = state(open_page(practice, hash_))
    assert 0 <= now["time"] <= 60
    assert now["camera"] == "room"


def test_nothing_plays_by_itself(open_page: Open, practice: Path) -> None:
    for hash_ in ("", "pattern=B&t=10"):
        page = open_page(practice, hash_)
        before = state(page)["time"]
        page.wait_for_timeout(120)
        assert state(page)["time"] == before


def test_play_goes_on_at_its_speed_and_stops_at_the_end(page: Any) -> None:
    page.locator("#play").click()
    page.wait_for_timeout(300)
    assert state(page)["time"] > 20.3
    assert page.locator("#play").get_attribute("aria-label") == "Pause"
    page.evaluate("location.hash = 't=59.2'")
    page.wait_for_timeout(60)
    page.locator("#play").click()
    page.wait_for_timeout(400)
    assert not state(page)["playing"]
    assert state(page)["time"] == pytest.approx(1779 / 30)


def test_a_click_in_the_strip_goes_there(page: Any) -> None:
    box = page.locator(".row.strip").bounding_box()
    at = page.evaluate("leitmotion.timeline")
    page.mouse.click(box["x"] + at["left"] + at["width"] / 2, box["y"] + 20)
    assert state(page)["time"] == pytest.approx(29.67, abs=0.1)


def test_a_name_stands_first_and_stays_in_the_address(open_page: Open, practice: Path, page: Any) -> None:
    page.locator(".lane-head").first.dblclick()
    page.keyboard.type("walk & turn")
    page.keyboard.press("Enter")
    assert state(page)["pattern"] is None
    assert page.locator(".lane-head strong").first.inner_text() == "walk & turn"
    page.wait_for_timeout(350)
    again = open_page(practice, page.evaluate("location.hash").lstrip("#"))
    assert again.locator(".lane-head strong").first.inner_text() == "walk & turn"
    label = again.locator(".stretch").first.get_attribute("aria-label")
    assert label.startswith("walk & turn: Pattern A, stretch 1 of 2")


def test_the_camera_turns_zooms_and_comes_back(page: Any) -> None:
    box = page.locator("#stage").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y + 20, steps=3)
    page.mouse.up()
    page.mouse.wheel(0, -200)
    now = state(page)
    assert now["turn"] != 0
    assert now["tilt"] != 0
    assert now["zoom"] > 1
    page.mouse.dblclick(x, y)
    now = state(page)
    assert (now["turn"], now["tilt"], now["zoom"]) == (0, 0, 1)


def test_the_table_saves_as_csv_without_a_request(page: Any) -> None:
    page.locator("#save").click()
    with page.expect_download() as download:
        page.locator("#save-sheet").get_by_text("Table (CSV)").click()
    assert download.value.suggested_filename == "practice-stretches.csv"
    lines = Path(download.value.path()).read_text().splitlines()
    assert lines[0].startswith("pattern,name,stretch,start_s,stop_s,cycles")
    assert len(lines) == 1 + page.locator("tbody tr").count()
    page.locator("#save").click()
    with page.expect_download() as download:
        page.locator("#save-sheet").get_by_text("Matrix (PNG)").click()
    assert Path(download.value.path()).read_bytes().startswith(b"\x89PNG")


def test_touch_points_then_holds(open_page: Open, practice: Path) -> None:
    page = open_page(practice, "t=20.2", width=390, height=844, has_touch=True, is_mobile=True)
    page.locator("#matrix").scroll_into_view_if_needed()
    x, y = cell(page, 12.0, 14.0)
    page.touchscreen.tap(x, y)
    now = state(page)
    assert now["hover"] is not None
    assert not now["held"]
    x, y = cell(page, 12.0, 14.0)
    page.touchscreen.tap(x, y)
    assert state(page)["held"]


def test_nothing_repeats_is_worth_opening(open_page: Open, nothing: Any, folder: Path) -> None:
    path = folder / "nothing.html"
    path.write_text(nothing.page(labels=None), encoding="utf-8")
    page = open_page(path)
    assert page.locator("h1").inner_text() == "Nothing repeats here"
    assert "You can still play it and compare any two moments." in page.locator(".empty").inner_text()
    assert page.locator("#table h2").inner_text() == "What was looked for"
    assert page.locator(".lane").count() == 0
    page.mouse.move(*cell(page, 1.0, 3.0))
    assert state(page)["hover"] is not None
    assert page.locator("#panel .verdict").inner_text() == "Not part of one pattern."
    page.keyboard.press(" ")
    assert state(page)["playing"]
