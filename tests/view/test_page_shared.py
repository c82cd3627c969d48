"""The page of several recordings: one time through all, a lane each, two times of a movement together."""

import base64
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.body import Body, embody
from leitmotion.discovery import SharedPattern, SharedPatterns
from leitmotion.discovery.shared import Places
from leitmotion.motion import ParameterError
from leitmotion.similarity import self_distance
from leitmotion.view import shared_payload
from leitmotion.view.in_a_row import FINE, features_in_a_row, in_a_row
from leitmotion.view.shared import pattern_head

Open = Callable[..., Any]
NAMES = ("ann/first.bvh", "bea/second.bvh", "cat/third.bvh")


class Shared(NamedTuple):
    """Three recordings and what they share."""

    bodies: list[Body]
    found: SharedPatterns
    page: Path


@pytest.fixture(scope="module")
def shared(folder: Path) -> Shared:
    """Two sessions at two rates, and a larger person who repeats part of the first."""
    one, two = (lm.compose_session(seed=seed, rate=30.0).motion[:400] for seed in (0, 1))
    bodies = [embody(motion) for motion in (one, two.replace(rate=24.0), one[60:360])]
    large = bodies[2]
    bodies[2] = large.replace(positions=1.3 * large.positions, size=1.3 * large.size)
    found = lm.find_shared_patterns(bodies, names=NAMES, features="posture")
    page = lm.report_shared(bodies, folder / "shared.html", shared=found)
    return Shared(bodies, found, page)


@pytest.fixture
def opened(open_page: Open, shared: Shared) -> Any:
    return open_page(shared.page)


def state(page: Any) -> dict[str, Any]:
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    told: dict[str, Any] = page.evaluate("leitmotion.state")
    return told


def takes(page: Any, pattern: int) -> list[dict[str, Any]]:
    steps = page.evaluate("leitmotion.payload.lesson.steps")
    found: list[dict[str, Any]] = next(step["takes"] for step in steps if step["pattern"] == pattern)
    return found


def part_of(page: Any, time: float) -> int:
    starts = [part["start"] for part in page.evaluate("leitmotion.payload.parts")]
    return int(np.searchsorted(starts, time + 1e-6, side="right")) - 1


def test_in_a_row_everybody_is_as_large_and_begins_on_a_frame(shared: Shared) -> None:
    row = in_a_row(shared.bodies, shared.found)
    lengths = [round((len(body) - 1) * 30 / body.rate) + 1 for body in shared.bodies]
    assert (row.stops - row.starts).tolist() == pytest.approx(lengths, abs=1)
    assert row.body.size == pytest.approx(np.mean([body.size for body in shared.bodies]))
    first = shared.bodies[0].positions * row.body.size / shared.bodies[0].size
    third = row.body.positions[row.starts[2] :]
    assert np.allclose(row.body.positions[: len(first)], first)
    assert np.allclose(third, first[60:360], atol=1e-3)  # sizes are medians of each recording


def test_in_a_row_every_occurrence_stays_in_its_recording(shared: Shared) -> None:
    row = in_a_row(shared.bodies, shared.found)
    for told, pattern in zip(row.patterns, shared.found, strict=True):
        for (start, stop, _, _), (recording, first, last, _) in zip(
            told.occurrences, pattern.occurrences, strict=True
        ):
            assert row.starts[recording] * FINE <= start < stop <= row.stops[recording] * FINE
            rate = shared.found.rates[recording]
            own = (np.array([start, stop]) - row.starts[recording] * FINE) / row.patterns.rate
            assert own == pytest.approx([first / rate, last / rate], abs=1 / 25)


def test_the_distances_of_the_matrix_are_those_of_the_drawn_bodies(shared: Shared) -> None:
    row = in_a_row(shared.bodies, shared.found)
    compared = features_in_a_row([lm.features.posture(body) for body in shared.bodies])
    drawn = lm.features.posture(row.body)
    assert compared.names == drawn.names
    assert np.allclose(compared.values, drawn.values, atol=2e-3)


def test_bodies_that_were_not_searched_are_refused(shared: Shared) -> None:
    with pytest.raises(ParameterError, match="bodies of"):
        in_a_row(shared.bodies[:2], shared.found)


def test_the_payload_tells_parts_and_times_of_each_recording(shared: Shared) -> None:
    matrix = self_distance(features_in_a_row([lm.features.posture(body) for body in shared.bodies])[::2])
    page = shared_payload(shared.bodies, shared.found, matrix, paths=NAMES)
    assert page["title"].startswith("Three recordings share ")
    assert [part["name"] for part in page["parts"]] == [name.removesuffix(".bvh") for name in NAMES]
    starts = [part["start"] for part in page["parts"]]
    for told, pattern in zip(page["patterns"], shared.found, strict=True):
        where = {
            int(np.searchsorted(starts, each["start"] + 1e-6, side="right")) - 1 for each in told["stretches"]
        }
        assert where == set(pattern.recordings)
    points = np.frombuffer(base64.b64decode(page["stripes"]["points"]["data"]), "<f4").reshape(-1, 2)
    assert (points[:, 0] <= points[:, 1]).mean() > 0.99


def test_a_page_of_nothing_shared_says_so_and_what_came_nearest(shared: Shared) -> None:
    none = shared.found.replace(patterns=(), pairs=(), nearest_miss="The nearest: this and that.")
    matrix = self_distance(features_in_a_row([lm.features.posture(body) for body in shared.bodies])[::6])
    page = shared_payload(shared.bodies, none, matrix)
    assert page["title"] == "Three recordings share nothing"
    assert "The nearest: this and that." in page["empty"]
    assert page["lesson"] is None


@pytest.mark.browser
def test_a_lane_a_recording_and_a_button_a_movement(opened: Any, shared: Shared) -> None:
    assert opened.locator(".parts .lane").count() == 3
    assert opened.locator(".movement").count() == len(shared.found)
    bars = sum(len(pattern.stretches) for pattern in shared.found)
    assert opened.locator(".parts .stretch").count() == bars
    letters = opened.locator(".movement .chip").all_inner_texts()
    assert letters == [pattern.id for pattern in shared.found]
    assert opened.locator("#lesson").is_visible()


@pytest.mark.browser
def test_a_click_on_an_occurrence_plays_it_over_one_of_another_recording(opened: Any) -> None:
    opened.locator(".parts .lane").nth(1).locator(".stretch").first.click()
    now = state(opened)
    assert now["playing"]
    take = takes(opened, now["pattern"])[now["take"]]
    assert take["start"] - 0.01 <= now["time"] <= take["stop"]
    assert part_of(opened, now["time"]) == 1
    assert opened.locator(".parts .lane").nth(1).locator(".one").count() == 1
    if len({part_of(opened, each["start"]) for each in takes(opened, now["pattern"])}) > 1:
        assert opened.locator(".parts .lane").nth(1).locator(".two").count() == 0
    opened.keyboard.press("Escape")
    assert state(opened)["take"] is None


@pytest.mark.browser
def test_all_of_it_by_keys(opened: Any) -> None:
    opened.keyboard.press("a")
    opened.keyboard.press("Space")
    first = state(opened)
    assert (first["pattern"], first["take"], first["beside"], first["inStep"]) == (0, 0, False, True)
    before = opened.locator('.other[aria-pressed="true"]').first.get_attribute("aria-label")
    opened.keyboard.press("Shift+N")
    assert state(opened)["other"] is not None
    assert opened.locator('.other[aria-pressed="true"]').first.get_attribute("aria-label") != before
    for key in "st":
        opened.keyboard.press(key)
    now = state(opened)
    assert (now["beside"], now["inStep"]) == (True, False)
    opened.keyboard.press("n")
    assert state(opened)["take"] == 1


@pytest.mark.browser
def test_the_address_brings_the_view_back(open_page: Open, shared: Shared) -> None:
    page = open_page(shared.page, "pattern=A&take=2&other=1&beside=1&step=0&lesson=1&repeat=0")
    now = state(page)
    told = [now[name] for name in ("take", "other", "beside", "inStep", "repeat")]
    assert told == [1, 0, True, False, False]
    assert part_of(page, now["time"]) == part_of(page, takes(page, 0)[1]["start"])


@pytest.mark.browser
def test_a_pair_is_as_far_apart_as_the_matrix_says(opened: Any, shared: Shared) -> None:
    row = in_a_row(shared.bodies, shared.found)
    posture = lm.features.posture(row.body)
    points = posture.values.reshape(len(posture), -1, 3) * row.body.size
    for one, two in ((100, row.starts[2] + 40), (row.starts[1] + 33, row.starts[2] + 200)):
        expected = np.linalg.norm(points[one] - points[two], axis=1).mean()
        told = opened.evaluate(f"leitmotion.compare({one / 30}, {two / 30}).distance")
        assert told == pytest.approx(expected, abs=2e-3)


@pytest.mark.browser
@pytest.mark.parametrize("width", [390, 900, 1440])
def test_nothing_is_cut_off_sideways(open_page: Open, shared: Shared, width: int) -> None:
    page = open_page(shared.page, "pattern=A&take=1&beside=1", width=width)
    assert page.evaluate("document.documentElement.scrollWidth") == width
    assert page.locator("#lesson").is_visible()
    assert page.locator("#tab-symmetry").is_hidden()


@pytest.mark.browser
@pytest.mark.parametrize("width", [390, 900, 1440])
def test_a_long_name_is_shortened_and_cuts_off_no_control(
    open_page: Open, shared: Shared, folder: Path, width: int
) -> None:
    found = shared.found.replace(names=tuple("a_recording_with_quite_a_long_name_" + name for name in "xyz"))
    page = open_page(
        lm.report_shared(shared.bodies, folder / "long.html", shared=found, force=True), width=width
    )
    sticks_out = """() => [...document.querySelectorAll(".transport button")].filter((button) => {
      const inside = button.getBoundingClientRect(), row = button.closest(".transport").getBoundingClientRect();
      return inside.width && (inside.right > row.right || inside.left < row.left);
    }).length"""
    assert page.evaluate(sticks_out) == 0


@pytest.mark.browser
def test_names_that_begin_and_end_alike_are_cut_where_they_do(
    open_page: Open, shared: Shared, folder: Path
) -> None:
    names = ("HDM_bd_walk_2_steps_001_120", "HDM_bk_walk_2_steps_001_120", "HDM_bd_walk_2_steps_002_120")
    page = open_page(
        lm.report_shared(shared.bodies, folder / "alike.html", shared=shared.found.replace(names=names)),
        width=390,
    )
    page.evaluate(
        """() => { window.written = []; const fillText = CanvasRenderingContext2D.prototype.fillText;
        CanvasRenderingContext2D.prototype.fillText = function (text, ...at) {
          if (this.canvas.id === "matrix-base") written.push(text); return fillText.call(this, text, ...at); }; }"""
    )
    page.evaluate("location.hash = 'pattern=A&take=1'")
    state(page)
    along_one_axis = page.evaluate("written.filter((_, k) => k % 2 === 0)")[:3]
    assert len(set(along_one_axis)) == 3
    assert all("…" in word and not word.startswith("HDM") for word in along_one_axis)


def test_times_that_differ_are_told_from_the_shortest_to_the_longest() -> None:
    places = Places([0, 1], [0, 0], [60, 60])
    uneven = SharedPattern("A", "acyclic", places, places, 2.5, 0.02, 0.8)
    found = SharedPatterns((uneven,), (), ("a", "b"), (30.0, 20.0), (90, 90), {})
    assert pattern_head(uneven, found) == ("2 of 2 recordings", "twice, 2.0–3.0 s each")
    even = uneven.replace(occurrences=Places([0, 1], [0, 0], [60, 44]), period_s=2.1)
    assert pattern_head(even, found)[1] == "twice, 2.10 s each"
