"""The Symmetry view: its matrix, its mirrored figure, its lanes and curves; keys, hash, widths, print, names."""

from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs

import numpy as np
import pytest

from leitmotion.view.symmetry_answer import NOT_COMPUTED

pytestmark = pytest.mark.browser

Open = Callable[..., Any]
At = Callable[[str], Any]
WALK, JACK, KICK = (
    0,
    2,
    4,
)  # of all stretches in the order of the lanes: walks 0 1, jacks 2, squats 3, kicks 4


def state(page: Any) -> dict[str, Any]:
    """What the page tells of itself, once it has drawn."""
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    told: dict[str, Any] = page.evaluate("leitmotion.state")
    return told


def written(page: Any) -> dict[str, list[str]]:
    """What stands in the address once it is written."""
    page.wait_for_timeout(320)
    return parse_qs(page.evaluate("location.hash.slice(1)"))


def cell(page: Any, one: float, two: float) -> tuple[float, float]:
    """Where the cell of two moments lies on the screen."""
    box = page.locator("#matrix").bounding_box()
    x, y = page.evaluate("([one, two]) => leitmotion.place(one, two)", [one, two])
    return box["x"] + x, box["y"] + y


def colour(page: Any, canvas: str, x: float, y: float) -> np.ndarray:
    """Of a pixel of a canvas, at CSS pixels."""
    found = page.evaluate(
        """([id, x, y]) => { const canvas = document.getElementById(id); const d = canvas.width / canvas.offsetWidth;
        return [...canvas.getContext("2d").getImageData(Math.round(x * d), Math.round(y * d), 1, 1).data]; }""",
        [canvas, x, y],
    )
    return np.array(found[:3])


def moments_like(page: Any, *, mirrored: bool) -> tuple[float, float]:
    """Two moments of the first walk that are alike, as they are or in the mirror, and clearly not the other way."""
    return tuple(
        page.evaluate(
            """(mirrored) => { let best = null;
            for (let one = 3; one < 6; one += 0.1) for (let two = one + 0.4; two < 7; two += 0.1) {
              const [own, other] = [false, true].map((way) => leitmotion.compareSides(one, two, way).distance);
              const gain = mirrored ? own - other : other - own;
              if (!best || gain > best.gain) best = { gain, one, two };
            } return [best.one, best.two]; }""",
            mirrored,
        )
    )


def test_m_opens_it_and_the_address_keeps_it(open_page: Open, symmetric_page: Path) -> None:
    page = open_page(symmetric_page, "t=4")
    assert state(page)["view"] == "repeats"
    page.keyboard.press("m")
    assert state(page)["view"] == "symmetry"
    assert page.locator("h1").inner_text() == "Both sides move together in two stretches"
    assert page.title().startswith("Both sides move together in two stretches")
    assert page.locator("#matrix-title").inner_text() == "Like itself, like its mirror image"
    assert page.locator("#tab-symmetry").get_attribute("aria-pressed") == "true"
    assert page.locator("#tab-repeats").get_attribute("aria-pressed") == "false"
    assert written(page)["view"] == ["symmetry"]
    again = open_page(symmetric_page, page.evaluate("location.hash.slice(1)"))
    assert state(again)["view"] == "symmetry"
    page.keyboard.press("m")
    assert state(page)["view"] == "repeats"
    assert "recur" in page.locator("h1").inner_text()
    assert "view" not in written(page)


def test_without_symmetry_the_tab_says_why(page: Any) -> None:
    tab = page.locator("#tab-symmetry")
    assert tab.get_attribute("aria-disabled") == "true"
    page.keyboard.press("m")
    assert page.locator("#tip").inner_text() == NOT_COMPUTED
    assert page.locator("#live").inner_text() == NOT_COMPUTED
    assert state(page)["view"] == "repeats"


def test_red_is_itself_cyan_is_mirrored_white_is_both(at: At) -> None:
    page = at("view=symmetry&t=58&theme=light")
    places = {
        way: page.evaluate("([a, b]) => leitmotion.place(a, b)", moments_like(page, mirrored=way))
        for way in (False, True)
    }
    red, cyan = colour(page, "matrix-base", *places[False]), colour(page, "matrix-base", *places[True])
    assert red[0] > red[2] + 60
    assert cyan[2] > cyan[0] + 60
    still = colour(page, "matrix-base", *page.evaluate("leitmotion.place(0.3, 1.7)"))
    assert still.min() > 225
    far = colour(page, "matrix-base", *page.evaluate("leitmotion.place(5, 11)"))
    assert far.max() < 60
    assert "half alike at" in page.locator("#matrix-legend").inner_text()


def test_pointing_at_a_cell_lays_the_nearer_of_both_over_it(at: At) -> None:
    page = at("view=symmetry&t=58")
    for mirrored in (True, False):
        one, two = moments_like(page, mirrored=mirrored)
        page.mouse.move(*cell(page, one, two))
        state(page)
        pair = page.evaluate("leitmotion.pair")
        assert pair["mirrored"] is mirrored
        assert (pair["one"], pair["two"]) == pytest.approx((one, two), abs=0.1)
        panel = page.locator("#panel")
        assert ("mirrored" in panel.locator("figure").nth(1).inner_text()) is mirrored
        distance = page.evaluate("(p) => leitmotion.compareSides(p.one, p.two, p.mirrored).distance", pair)
        other = page.evaluate("(p) => leitmotion.compareSides(p.one, p.two, !p.mirrored).distance", pair)
        assert float(panel.locator(".apart b").inner_text()) == pytest.approx(100 * distance, abs=0.051)
        assert distance < other
        assert f"{100 * other:.1f} cm" in panel.locator(".verdict").inner_text()
    page.mouse.click(*cell(page, one, two))
    assert state(page)["held"]
    page.keyboard.press("Escape")
    assert not state(page)["held"]


def test_the_number_is_that_of_the_library(at: At) -> None:
    page = at("view=symmetry&t=4")
    for time in (4.0, 12.2, 31.0, 44.0):
        page.evaluate(f"location.hash = 'view=symmetry&t={time}'")
        state(page)
        drawn = page.evaluate(f"leitmotion.compareSides({time}, {time}, true).distance")
        assert float(page.locator("#panel .apart b").inner_text()) == pytest.approx(100 * drawn, abs=0.15)
    assert page.locator("#panel h2").inner_text() == "Now, and its mirror image"
    assert page.locator("#panel figure").count() == 2


def test_the_panel_tells_the_stretch_of_now(at: At) -> None:
    page = at("view=symmetry&t=4")
    told = page.locator("#panel .verdict")
    assert told.inner_text() == (
        "Pattern A alternates: half a cycle later the body is its own mirror image. "
        "In the matrix, cyan stripes run midway between the red ones."
    )
    page.evaluate("location.hash = 'view=symmetry&t=1'")
    state(page)
    assert told.inner_text().startswith("The body keeps still.")


def test_a_click_on_a_bar_plays_it_over_what_it_is_like(at: At) -> None:
    page = at("view=symmetry&t=20")
    assert page.evaluate("leitmotion.mirrorMoment(4)") == {
        "time": 4,
        "mirrored": True,
        "words": "its mirror image",
    }
    page.locator(".motifs .stretch").first.click()
    page.keyboard.press(" ")
    now = state(page)
    span = page.evaluate("leitmotion.payload.symmetry.lanes[0].spans[0]")
    assert now["span"] == WALK
    assert span["start"] <= now["time"] <= span["stop"]
    marks = span["marks"]
    at = marks[2] + 0.4 * (marks[3] - marks[2])
    ghost = page.evaluate(f"leitmotion.mirrorMoment({at})")
    assert ghost["mirrored"]
    assert ghost["time"] == pytest.approx(marks[3] + 0.4 * (marks[4] - marks[3]), abs=0.15)
    # Half a cycle later the body is its own mirror image, at once it is not.
    fits = page.evaluate(f"leitmotion.compareSides({at}, {ghost['time']}, true).distance")
    assert fits < 0.5 * page.evaluate(f"leitmotion.compareSides({at}, {at}, true).distance")
    page.evaluate(f"location.hash = 'view=symmetry&span=1&t={at}'")
    state(page)
    assert page.locator("#mirror-words").inner_text() == "its mirror image, half a cycle later"
    assert (
        f"{100 * fits:.1f} cm from its mirror image, half a cycle later."
        in page.locator("#panel").inner_text()
    )
    assert page.locator(".moment b").nth(1).inner_text() == f"2 0:0{ghost['time']:.1f}"
    assert page.locator("#looping").inner_text() == "Looping A Alternates sides, 1 of 2"
    assert page.locator(".motifs .stretch").first.get_attribute("aria-pressed") == "true"
    page.keyboard.press("Escape")
    assert state(page)["span"] is None


def test_it_loops(at: At) -> None:
    page = at("view=symmetry&span=1&t=7.5")
    page.keyboard.press(" ")
    page.wait_for_timeout(500)
    page.keyboard.press(" ")
    assert 2 <= state(page)["time"] < 3


def test_the_mirrored_figure_is_a_toggle(at: At) -> None:
    page = at("view=symmetry&t=31&trails=0")
    drawn = "document.getElementById('stage').toDataURL()"
    with_ghost = page.evaluate(drawn)
    page.locator("#toggles [data-toggle=ghost]").click()
    state(page)
    assert page.evaluate(drawn) != with_ghost
    assert page.locator("#mirror-note").is_hidden()


def test_keys_step_from_stretch_to_stretch(open_page: Open, symmetric_page: Path) -> None:
    page = open_page(symmetric_page, "view=symmetry", reduced_motion="reduce")
    seen = []
    for key in "nnnpp":
        page.keyboard.press(key)
        seen.append(state(page)["span"])
    assert seen == [0, 1, 2, 1, 0]
    page.keyboard.press("p")
    assert state(page)["span"] == KICK  # the last one of the lanes that are shown
    assert not state(page)["playing"]


def test_what_merely_comes_again_waits_behind_a_button(at: At) -> None:
    page = at("view=symmetry")
    heads = page.locator(".motif-head:visible strong")
    assert heads.all_inner_texts() == [
        "Alternates sides",
        "Both, out and back",
        "Both sides, repeating",
        "One side, out and back",
    ]
    more = page.locator(".more-lanes")
    assert more.inner_text() == "2 more: again, mirrored · keeps still"
    assert more.get_attribute("aria-expanded") == "false"
    more.click()
    assert state(page)["more"]
    assert heads.all_inner_texts()[4:] == ["Again, mirrored", "Keeps still"]
    assert written(page)["more"] == ["1"]
    # Two stretches that belong together: the second is dashed, and both say so.
    pair = page.locator(".lane", has_text="Again, mirrored").locator(".stretch")
    assert pair.count() == 2
    assert pair.nth(1).get_attribute("aria-label").endswith("the second time")
    assert pair.nth(1).evaluate("(bar) => getComputedStyle(bar).outlineStyle") == "dashed"
    pair.nth(0).click()
    page.keyboard.press(" ")
    ghost = page.evaluate("leitmotion.mirrorMoment(leitmotion.state.time)")
    assert ghost["mirrored"]
    assert ghost["time"] > 35


def test_bars_show_marks_doubt_and_words(at: At) -> None:
    page = at("view=symmetry")
    bars = page.locator(".motifs .stretch")
    marks = page.evaluate("leitmotion.payload.symmetry.lanes[0].spans[0].marks.length")
    assert bars.nth(WALK).locator("span").count() == marks - 1
    assert bars.nth(WALK).locator(".letter").inner_text() == "A"
    assert "unsure" in bars.nth(KICK).get_attribute("class")
    assert "unsure" not in bars.nth(WALK).get_attribute("class")
    base = page.locator("#matrix-base").evaluate("(canvas) => canvas.toDataURL()")
    bars.nth(WALK).hover()
    state(page)
    assert page.locator("#tip").inner_text().startswith("A, alternates sides · 0:02.0 to 0:07.6")
    assert "truth of walk" in page.locator("#tip").inner_text()
    assert page.locator("#matrix-base").evaluate("(canvas) => canvas.toDataURL()") != base  # outlined there
    assert (
        bars.nth(WALK).get_attribute("aria-label")
        == "Alternates sides, pattern A, 1 of 2, 2.0 to 7.6 seconds"
    )


def test_a_pattern_chosen_here_dims_the_others(open_page: Open, symmetric_page: Path) -> None:
    page = open_page(symmetric_page, "view=symmetry", reduced_motion="reduce")
    page.keyboard.press("a")
    assert state(page)["pattern"] == 0
    opacity = [
        float(bar.evaluate("(bar) => getComputedStyle(bar).opacity"))
        for bar in page.locator(".motifs .stretch").all()[:3]
    ]
    assert opacity == pytest.approx([1, 1, 0.3])
    page.locator(".motifs .stretch").nth(JACK).click()
    assert state(page)["pattern"] is None
    assert state(page)["span"] == JACK


def test_the_table_holds_everything_the_lanes_show(at: At, mirroring: Any) -> None:
    page = at("view=symmetry")
    rows = page.locator("#table tbody tr:visible")
    assert rows.count() == len(mirroring.found.spans)
    first = rows.first.locator("td").all_inner_texts()
    assert first[:3] == ["Alternates sides", "0:02.0", "0:07.6"]
    assert first[-2:] == ["A", "0.90"]
    with page.expect_download() as download:
        page.locator("#save").click()
        page.locator("#save-sheet button", has_text="Table").click()
    lines = Path(download.value.path()).read_text(encoding="utf-8").splitlines()
    assert len(lines) == len(mirroring.found.spans) + 1
    assert lines[0].startswith("motif,term,start_s")
    assert download.value.suggested_filename == "practice-motifs.csv"


def test_curves_by_a_menu(at: At) -> None:
    page = at("view=symmetry&t=12")
    menu = page.locator(".curve-menu")
    assert menu.inner_text() == "Lopsidedness"
    menu.click()
    names = [text.split("\n")[0] for text in page.locator("#curve-sheet button").all_inner_texts()]
    assert [name.split(" ")[0] for name in names] == [
        "Likeness",
        "Lopsidedness",
        "Speed",
        "Height",
        "Kinetic",
        "Angular",
    ]
    page.locator("#curve-sheet button", has_text="Kinetic energy").click()
    assert state(page)["curve"] == "energy"
    assert menu.inner_text() == "Kinetic energy"
    assert written(page)["curve"] == ["energy"]
    flights = page.evaluate("leitmotion.payload.curves.flights.length")
    assert page.locator(".flight").count() == flights
    assert page.locator(".strike").count() == 2
    assert "stopped or thrown back" in page.locator(".strike").first.get_attribute("aria-label")
    page.keyboard.press("m")
    assert menu.inner_text() == "Likeness to now"
    assert page.locator(".strike").count() == 0


def test_flights_are_shaded_with_what_they_say(
    open_page: Open, known: Any, mirroring: Any, folder: Path
) -> None:
    from leitmotion.body import Flight, dynamics
    from leitmotion.datasets import compose_session

    moved = dynamics(compose_session(rate=30.0).motion)
    flight = Flight(300, 315, 9.43, 0.01, np.zeros(3), 0.5, 0.06)
    page_text = known.page(mirroring=mirroring, dynamics=moved.replace(flights=(flight,)))
    (folder / "flight.html").write_text(page_text, encoding="utf-8")
    page = open_page(folder / "flight.html", "curve=height")
    band = page.locator(".flight")
    assert band.get_attribute("title") == (
        "In the air: falls with 9.4 m/s² (9.8 is right), angular momentum steady within 6 %"
    )
    scale = page.evaluate("leitmotion.timeline.width / leitmotion.payload.source.seconds")
    assert band.bounding_box()["width"] == pytest.approx(0.5 * scale, abs=1)
    page.evaluate("location.hash = 'curve=likeness'")
    state(page)
    assert band.count() == 0


def test_the_triangle_is_the_same_matrix_turned(at: At) -> None:
    page = at("view=symmetry&t=58&theme=light")
    square = {
        way: colour(
            page,
            "matrix-base",
            *page.evaluate("([a, b]) => leitmotion.place(a, b)", moments_like(page, mirrored=way)),
        )
        for way in (False, True)
    }
    page.locator("#forms button[data-form=triangle]").click()
    assert state(page)["form"] == "triangle"
    assert page.evaluate("leitmotion.matrix.id") == "mirror-triangle"
    assert written(page)["form"] == ["triangle"]
    for way, hue in square.items():
        one, two = moments_like(page, mirrored=way)
        place = page.evaluate("([a, b]) => leitmotion.place(a, b)", [one, two])
        turned = colour(page, "matrix-base", *place)
        assert (turned[0] > turned[2]) == (hue[0] > hue[2])
    one, two = 12.0, 44.0
    page.mouse.move(*cell(page, one, two))
    assert state(page)["hover"] == pytest.approx({"one": one, "two": two}, abs=0.3)
    x, y = cell(page, 30, 30)
    page.mouse.move(x, y + 30)
    assert state(page)["hover"] is None
    page.keyboard.press("m")
    assert state(page)["view"] == "repeats"
    assert page.evaluate("leitmotion.matrix.id") == "distance"
    assert page.locator("#forms").is_hidden()


@pytest.mark.parametrize(
    ("width", "height"), [(1440, 900), (1101, 800), (900, 1000), (720, 450), (390, 844), (320, 450)]
)
def test_nothing_is_cut_off_at_any_width(
    open_page: Open, symmetric_page: Path, width: int, height: int
) -> None:
    page = open_page(symmetric_page, "view=symmetry&t=4&more=1", width=width, height=height)
    sideways = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
    assert page.evaluate(sideways) == 0
    card = page.locator("#matrix-card").bounding_box()
    legend = page.locator("#matrix-legend").evaluate(
        "(box) => [...box.children].map((c) => c.getBoundingClientRect().right)"
    )
    assert max(legend) <= card["x"] + card["width"]
    switch, title = page.locator("#forms").bounding_box(), page.locator("#matrix-title").bounding_box()
    assert title["x"] + title["width"] <= switch["x"] + 1 or title["y"] + title["height"] <= switch["y"]


def test_the_picture_s_lanes_are_seen_without_scrolling(at: At) -> None:
    page = at("view=symmetry&t=4")
    fourth = page.locator(".motifs .lane:visible").nth(3).bounding_box()
    assert fourth["y"] + fourth["height"] <= 900


def test_on_paper(open_page: Open, symmetric_page: Path) -> None:
    page = open_page(symmetric_page, "view=symmetry&t=4", width=983)
    page.emulate_media(media="print")
    state(page)
    assert page.locator("#forms").is_hidden()
    assert page.locator(".more-lanes").is_hidden()
    assert page.locator("h1").inner_text() == "Both sides move together in two stretches"
    assert page.locator(".motifs .lane:visible").count() == 4


def test_what_is_heard(at: At) -> None:
    page = at("view=symmetry&t=4")
    page.wait_for_timeout(1100)
    assert "from its own mirror image, on average. Alternates sides." in page.locator("#live").inner_text()
    label = page.locator("#matrix").get_attribute("aria-label")
    assert label.startswith("Like itself, like its mirror image. Now 0:04.0.")
    page.mouse.move(*cell(page, *moments_like(page, mirrored=True)))
    state(page)
    assert "the second in the mirror" in page.locator("#matrix").get_attribute("aria-label")
    assert page.locator(".motif-head").first.get_attribute("aria-label") == (
        "Alternates sides, anti-phase cycle, 2 stretches. Play the first."
    )


def test_a_recording_without_motifs_keeps_its_view(
    open_page: Open, known: Any, mirroring: Any, folder: Path
) -> None:
    bare = mirroring._replace(found=mirroring.found.replace(spans=(), strikes=[]))
    (folder / "bare.html").write_text(known.page(mirroring=bare), encoding="utf-8")
    page = open_page(folder / "bare.html", "view=symmetry&t=4")
    assert page.locator("h1").inner_text() == "No symmetry shows here"
    assert "from its own mirror image" in page.locator(".empty:visible").inner_text()
    assert page.locator("#table").inner_text().startswith("What was looked for")
    assert page.locator("#panel .verdict").inner_text() == "No motif of symmetry was found at this moment."
    assert page.evaluate("leitmotion.payload.curves") is None


def test_the_page_opens_on_what_was_asked(open_page: Open, known: Any, mirroring: Any, folder: Path) -> None:
    for opens_with, tab in (
        ("lesson", "tab-lesson"),
        ("symmetry", "tab-symmetry"),
        ("repeats", "tab-repeats"),
    ):
        path = folder / f"opens-{opens_with}.html"
        path.write_text(known.page(mirroring=mirroring, opens_with=opens_with), encoding="utf-8")
        page = open_page(path)
        assert page.locator(f"#{tab}").get_attribute("aria-pressed") == "true"
        assert page.locator(".tabs [aria-pressed=true]").count() == 1
        page.locator("#tab-repeats").click()
        page.locator(f"#{tab}").click()
        assert "view" not in written(page)
        assert "lesson" not in written(page)
