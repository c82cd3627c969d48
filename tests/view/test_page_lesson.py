"""The lesson on the page: ranked, played time after time, at hand by keys, on every width; absent where it is empty."""

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


def wait_until(page: Any, holds: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """Wait for a state; the page's policy forbids what Playwright's own waiting does."""
    for _ in range(300):
        if holds(now := state(page)):
            return now
        page.wait_for_timeout(40)
    raise AssertionError(f"never came: {now}")


def steps(page: Any) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = page.evaluate("leitmotion.payload.lesson.steps")
    return found


def test_the_panel_is_most_like_now_until_the_lesson_is_asked_for(page: Any) -> None:
    assert not page.locator("#lesson").is_visible()
    page.locator("#tab-lesson").click()
    assert state(page)["lesson"]
    assert page.locator("#lesson").is_visible()
    assert not page.locator("#panel").is_visible()
    assert page.locator("#lesson").bounding_box()["width"] == pytest.approx(252, abs=1)
    page.locator("#tab-repeats").click()
    assert page.locator("#panel h2").inner_text() == "Most like now"


def test_most_frequent_first(page: Any, known: Any) -> None:
    page.keyboard.press("l")
    counts = [len(step["takes"]) for step in steps(page)]
    assert counts == sorted(counts, reverse=True)
    assert counts == sorted((len(p.occurrences) for p in known.patterns.patterns), reverse=True)
    chips = page.locator(".step .chip").all_inner_texts()
    assert chips == ["ABCDEFGH"[step["pattern"]] for step in steps(page)]


def test_choosing_one_plays_its_typical_time(page: Any) -> None:
    page.keyboard.press("l")
    page.locator(".step-head").nth(1).click()
    now, step = state(page), steps(page)[1]
    assert now["playing"]
    assert (now["pattern"], now["take"]) == (step["pattern"], 0)
    assert step["takes"][0]["start"] <= now["time"] < step["takes"][0]["stop"]
    assert page.locator(".take[aria-current]").inner_text().startswith("Typical")
    assert page.locator("#looping").inner_text().endswith(f"1 of {len(step['takes'])}, typical")
    page.keyboard.press("Escape")
    assert state(page)["take"] is None
    assert page.locator(".take[aria-current]").count() == 0


def test_then_its_variations_one_after_another_and_stops(open_page: Open, practice: Path) -> None:
    page = open_page(practice, "lesson=1")
    step = steps(page)[-1]
    at = len(steps(page)) - 1
    page.keyboard.press("]")
    page.locator(".step-head").nth(at).click()
    second, now = step["takes"][1], wait_until(page, lambda now: now["take"] == 1)
    assert second["start"] <= now["time"] <= second["stop"]
    now = wait_until(page, lambda now: not now["playing"])
    assert now["take"] == len(step["takes"]) - 1
    assert now["time"] == pytest.approx(step["takes"][-1]["stop"], abs=0.05)
    page.keyboard.press("Space")
    assert state(page)["take"] == 0


def test_looping_stays_with_the_one(open_page: Open, practice: Path) -> None:
    page = open_page(practice, "lesson=1&repeat=1")
    take = steps(page)[-1]["takes"][0]
    page.keyboard.press("]")
    page.locator(".step-head").last.click()
    before = page.evaluate("leitmotion.state.time")
    page.wait_for_timeout(1000 * (take["stop"] - take["start"]) / 2 + 300)
    now = state(page)
    assert now["take"] == 0
    assert now["playing"]
    assert before <= take["stop"]
    page.keyboard.press("r")
    assert not state(page)["repeat"]


def test_keys_go_on_and_back_across_movements(page: Any) -> None:
    page.keyboard.press("n")
    now, first = state(page), steps(page)[0]
    assert (now["lesson"], now["pattern"], now["take"]) == (True, first["pattern"], 0)
    page.keyboard.press("n")
    assert state(page)["take"] == 1
    page.keyboard.press("p")
    page.keyboard.press("p")
    assert (state(page)["pattern"], state(page)["take"]) == (first["pattern"], 0)
    for _ in first["takes"]:
        page.keyboard.press("n")
    now = state(page)
    assert (now["pattern"], now["take"]) == (steps(page)[1]["pattern"], 0)
    page.keyboard.press("p")
    now = state(page)
    assert (now["pattern"], now["take"]) == (first["pattern"], len(first["takes"]) - 1)


def test_a_variation_is_shown_over_the_typical_time(page: Any) -> None:
    step = steps(page)[0]
    take, typical = step["takes"][1], step["takes"][0]
    middle = (take["start"] + take["stop"]) / 2
    page.evaluate(f"location.hash = 'pattern={'ABCDEFGH'[step['pattern']]}&take=2&t={middle:.2f}'")
    assert state(page)["take"] == 1
    lines = page.locator(".moment")
    assert not lines.nth(1).evaluate("(line) => line.hidden")
    minutes, seconds = lines.nth(1).inner_text().removeprefix("2 ").split(":")
    assert typical["start"] <= 60 * int(minutes) + float(seconds) <= typical["stop"]
    with_ghost = page.locator("#stage").screenshot()
    page.locator("[data-toggle=ghost]").first.click()
    state(page)
    assert page.locator("#stage").screenshot() != with_ghost
    page.locator("[data-toggle=ghost]").first.click()


def test_the_words_are_of_the_present_one_only(page: Any) -> None:
    page.keyboard.press("n")
    page.keyboard.press("n")
    state(page)
    shown = [each for each in page.locator(".take small").all() if each.is_visible()]
    (words,) = [each.inner_text().replace("\u00a0", " ") for each in shown]
    assert words == ", ".join(steps(page)[0]["takes"][1]["words"])


def test_pointing_at_a_cell_gives_the_panel_back_meanwhile(page: Any) -> None:
    page.keyboard.press("l")
    box, at = page.locator("#matrix").bounding_box(), page.evaluate("leitmotion.matrix")
    page.mouse.move(box["x"] + at["left"] + at["side"] * 0.4, box["y"] + at["upper"] + at["side"] * 0.2)
    state(page)
    assert page.locator("#panel h2").inner_text() == "Two moments"
    assert not page.locator("#lesson").is_visible()
    page.mouse.move(700, 40)
    state(page)
    assert page.locator("#lesson").is_visible()


def test_the_address_opens_the_same_view(page: Any, open_page: Open, practice: Path) -> None:
    for _ in range(3):
        page.keyboard.press("n")
    page.keyboard.press("Space")
    page.wait_for_timeout(300)
    hash_ = page.evaluate("location.hash.slice(1)")
    again = state(open_page(practice, hash_))
    now = state(page)
    assert {key: again[key] for key in ("lesson", "pattern", "take", "repeat")} == {
        key: now[key] for key in ("lesson", "pattern", "take", "repeat")
    }
    assert again["time"] == pytest.approx(now["time"], abs=0.01)


def test_the_present_one_is_in_sight_in_a_long_list(open_page: Open, practice: Path) -> None:
    probe = open_page(practice, "lesson=1")
    count = len(steps(probe)[0]["takes"])
    name = "ABCDEFGH"[steps(probe)[0]["pattern"]]
    page = open_page(practice, f"pattern={name}&take={count}", height=700)
    now = state(page)
    assert now["time"] == pytest.approx(steps(page)[0]["takes"][-1]["start"], abs=0.01)
    box, present = page.locator(".steps").bounding_box(), page.locator(".take[aria-current]").bounding_box()
    assert box["y"] <= present["y"]
    assert present["y"] + present["height"] <= box["y"] + box["height"]


@pytest.mark.parametrize(
    "hash_", ["take=3", "pattern=A&take=x", "pattern=A&take=999", "pattern=Q&take=1&lesson=1"]
)
def test_an_address_that_cannot_be_opens_all_the_same(open_page: Open, practice: Path, hash_: str) -> None:
    now = state(open_page(practice, hash_))
    assert now["take"] is None or now["take"] < 99


@pytest.mark.parametrize(("width", "height"), [(900, 1300), (390, 844)])
def test_where_nothing_stands_beside_the_stage_it_is_a_card(
    open_page: Open, practice: Path, width: int, height: int
) -> None:
    page = open_page(practice, "t=12", width=width, height=height, has_touch=True)
    lesson = page.locator("#lesson").bounding_box()
    scene, line = page.locator(".scene").bounding_box(), page.locator("#timeline").bounding_box()
    assert scene["y"] + scene["height"] <= lesson["y"]
    assert lesson["y"] + lesson["height"] <= line["y"]
    assert lesson["width"] == pytest.approx(line["width"])
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    page.locator(".step-head").first.click()
    assert state(page)["take"] == 0
    heights = [each.bounding_box()["height"] for each in page.locator(".take").all() if each.is_visible()]
    touched = page.evaluate("matchMedia('(pointer: coarse)').matches")
    assert len(heights) == len(steps(page)[0]["takes"])
    assert min(heights) >= (44 if touched else 20)


def test_reduced_motion_shows_but_does_not_play(open_page: Open, practice: Path) -> None:
    page = open_page(practice, "lesson=1", reduced_motion="reduce")
    page.locator(".step-head").first.click()
    now = state(page)
    assert not now["playing"]
    assert now["time"] == pytest.approx(steps(page)[0]["takes"][0]["start"], abs=0.01)


def test_it_is_absent_where_nothing_recurs(open_page: Open, nothing: Any, folder: Path) -> None:
    (folder / "nothing-to-learn.html").write_text(nothing.page(), encoding="utf-8")
    page = open_page(folder / "nothing-to-learn.html", "lesson=1&take=1")
    assert page.evaluate("leitmotion.payload.lesson") is None
    assert page.locator("#lesson").count() == 0
    assert not page.locator("#tab-lesson").is_visible()
    for key in "lnpr":
        page.keyboard.press(key)
    assert not state(page)["lesson"]


def test_it_is_not_printed(open_page: Open, practice: Path) -> None:
    page = open_page(practice, "lesson=1")
    page.emulate_media(media="print")
    page.wait_for_timeout(100)
    assert not page.locator("#lesson").is_visible()


def test_what_is_played_is_what_the_library_says(page: Any, known: Any) -> None:
    from leitmotion.discovery import make_lesson
    from leitmotion.features import posture

    lesson = make_lesson(posture(known.body), known.patterns)
    for told, step in zip(steps(page), lesson.steps, strict=True):
        assert known.patterns.patterns[told["pattern"]].id == step.pattern
        spans = [(step.start, step.stop), *((each.start, each.stop) for each in step.variations)]
        np.testing.assert_allclose(
            [(t["start"], t["stop"]) for t in told["takes"]], np.array(spans) / lesson.rate
        )
