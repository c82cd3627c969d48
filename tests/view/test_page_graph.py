"""The Graph view of the page: drawn as it was laid out, every state and path a button, its times over one another."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from leitmotion.body import embody
from leitmotion.discovery import MotionGraph, Patterns
from leitmotion.features import posture
from leitmotion.motion import ParameterError
from leitmotion.similarity import self_distance
from leitmotion.view.graph_payload import graph_payload
from leitmotion.view.graph_visited import most_visited
from leitmotion.view.graph_words import NO_STATES, NOT_COMPUTED
from oracles.performing import GRAPHS, perform

Open = Callable[..., Any]
HALF_KICKS = "aa aa ax -ax aa"


@pytest.fixture(scope="module")
def kicks() -> tuple[Any, MotionGraph]:
    motion, graph = perform(GRAPHS["racemized"], HALF_KICKS)
    return embody(motion), graph


@pytest.fixture(scope="module")
def kicks_page(kicks: tuple[Any, MotionGraph], known: Any, folder: Path) -> Path:
    body, graph = kicks
    patterns = Patterns((), (), body.rate, {"min_duration_s": 0.5})
    told = known._replace(body=body, patterns=patterns, matrix=self_distance(posture(body)), labels=None)
    path = folder / "kicks.html"
    path.write_text(told.page(graph=graph, opens_with="graph"), encoding="utf-8")
    return path


def state(page: Any) -> dict[str, Any]:
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    told: dict[str, Any] = page.evaluate("leitmotion.state")
    return told


def test_the_payload_holds_what_was_laid_out(kicks):
    body, graph = kicks
    told = graph_payload(body, graph)
    assert [item["name"] for item in told["states"]] == ["A", "X", "A*"]
    assert told["title"] == "Two postures, two ways between them"
    assert told["lead"] == ["A, X̄; aa →, ax ↔"]
    places = {item["name"]: item["at"] for item in told["states"]}
    assert places["X"] == [0, 0]
    assert places["A*"] == [-places["A"][0], places["A"][1]]
    assert [len(item["visits"]) for item in told["paths"]] == [3, 2, 0, 0]
    assert [visit["back"] for visit in told["paths"][1]["visits"]] == [False, True]
    assert told["states"][2]["mirrored"]
    assert told["states"][2]["key"] == told["states"][0]["key"]
    left = body.roles.index("left_wrist")
    assert body.roles[told["partner"][left]] == "right_wrist"


def test_a_graph_of_nothing_or_of_another_recording(kicks):
    body, graph = kicks
    nothing = MotionGraph((), (), ("rest",), (30.0,), 0.0, {})
    assert graph_payload(body, nothing) == {"none": NO_STATES}
    with pytest.raises(ParameterError, match="the graph of one recording, got one of 2"):
        graph_payload(body, graph.replace(recordings=("a", "b"), rates=(30.0, 30.0)))
    with pytest.raises(ParameterError, match="The graph reaches to"):
        graph_payload(
            body.replace(positions=body.positions[:30], facing=body.facing[:30]),
            graph,
        )


@pytest.mark.browser
def test_without_a_graph_its_tab_says_so(open_page: Open, practice: Path) -> None:
    page = open_page(practice, "view=graph")
    assert state(page)["view"] == "repeats"
    tab = page.locator("#tab-graph")
    assert tab.get_attribute("aria-disabled") == "true"
    tab.click(force=True)
    assert state(page)["view"] == "repeats"
    assert page.locator("#live").text_content() == NOT_COMPUTED
    assert page.locator("#graph").count() == 0


@pytest.mark.browser
def test_it_opens_with_the_graph_and_draws_what_was_performed(open_page: Open, kicks_page: Path) -> None:
    page = open_page(kicks_page)
    assert state(page)["view"] == "graph"
    assert page.locator("h1").inner_text() == "Two postures, two ways between them"
    assert page.locator(".node:visible").count() == 2
    assert page.locator(".edge-name:visible").count() == 2
    names = [page.locator(".node:visible").nth(k).get_attribute("aria-label") for k in range(2)]
    assert names == ["State A, mirror image of A star, 5 times", "State X, its own mirror image, once"]
    boxes = [page.locator(".node:visible").nth(k).bounding_box() for k in range(2)]
    assert boxes[0]["x"] + boxes[0]["width"] < boxes[1]["x"]
    field = page.locator("#matrix-card").bounding_box()
    for box in boxes:
        assert field["x"] < box["x"]
        assert box["y"] + box["height"] < field["y"] + field["height"]
    assert not page.locator("#matrix").is_visible()
    assert page.locator(".visit").count() == 6 + 5


@pytest.mark.browser
def test_mirror_images_are_shown_dotted_and_across_the_axis(open_page: Open, kicks_page: Path) -> None:
    page = open_page(kicks_page)
    page.get_by_role("button", name="With mirror images").click()
    assert state(page)["images"]
    assert page.locator(".node:visible").count() == 3
    a, x, image = (page.locator(".node").nth(k).bounding_box() for k in range(3))
    assert x["x"] - a["x"] == pytest.approx(image["x"] - x["x"], abs=1)
    assert page.locator(".graph-field g.reflected .line").count() == 2
    dashes = page.locator(".graph-field g.reflected .line").first.evaluate(
        "(e) => getComputedStyle(e).strokeDasharray"
    )
    assert dashes != "none"
    page.keyboard.press("i")
    assert not state(page)["images"]
    assert page.locator(".node:visible").count() == 2


@pytest.mark.browser
def test_a_click_plays_all_times_over_one_another(open_page: Open, kicks_page: Path, kicks: Any) -> None:
    _, graph = kicks
    page = open_page(kicks_page)
    page.locator(".edge-name", has_text="aa").first.click()
    now = state(page)
    visits = graph.paths[0].visits
    assert (now["item"], now["visit"], now["playing"]) == ("aa", 0, True)
    page.keyboard.press(" ")
    assert visits[0].start / 30 <= state(page)["time"] < visits[0].stop / 30
    part = 0.4
    lead = visits[0]
    time = (lead.start + part * (lead.stop - lead.start)) / 30
    told = page.evaluate("(time) => leitmotion.overlaid(time)", time)
    wanted = [(v.start + part * (v.stop - v.start)) / 30 for v in visits[1:]]
    assert [each["time"] for each in told] == pytest.approx(wanted, abs=1e-3)
    assert not any(each["mirrored"] for each in told)
    assert page.evaluate("leitmotion.overlaid(0)") == []  # out of the time that plays
    page.locator(".time").nth(2).click()
    assert state(page)["visit"] == 2
    page.keyboard.press("Escape")
    assert state(page)["item"] is None
    page.locator(".node").first.click()
    assert state(page)["item"] == "A"
    page.locator(".graph-field g").first.dispatch_event("click")
    assert state(page)["item"] == "aa"


@pytest.mark.browser
def test_a_way_gone_back_is_aligned_from_its_source(open_page: Open, kicks_page: Path, kicks: Any) -> None:
    _, graph = kicks
    there, back = graph.paths[1].visits
    page = open_page(kicks_page, "view=graph&item=ax")
    told = page.evaluate(
        "(time) => leitmotion.overlaid(time)", (there.start + 0.25 * (there.stop - there.start)) / 30
    )
    assert told[0]["time"] == pytest.approx((back.stop - 0.25 * (back.stop - back.start)) / 30, abs=1e-3)


@pytest.mark.browser
def test_a_reflected_way_plays_mirrored(open_page: Open, kicks_page: Path) -> None:
    page = open_page(kicks_page, "view=graph&images=1&item=(aa)*", reduced_motion="reduce")
    assert state(page)["item"] == "(aa)*"
    assert page.locator("#looping").inner_text() == "Looping (aa)*, 1 of 3, mirrored"
    assert page.locator("#mirror-note").inner_text() == "mirrored"
    mirrored = pixels(page)
    page.evaluate("location.hash = location.hash.replace('(aa)*', 'aa').replace('%28aa%29*', 'aa')")
    assert state(page)["item"] == "aa"
    assert mirrored != pixels(page)


def pixels(page: Any) -> str:
    state(page)
    told: str = page.evaluate("document.getElementById('stage').toDataURL()")
    return told


@pytest.mark.browser
def test_keys_choose_and_the_address_brings_it_back(open_page: Open, kicks_page: Path) -> None:
    page = open_page(kicks_page, reduced_motion="reduce")
    page.keyboard.press("n")
    assert state(page)["item"] == "A"
    page.keyboard.press("x")
    assert state(page)["item"] == "X"
    page.keyboard.press("n")
    assert state(page)["item"] == "aa"
    page.wait_for_timeout(400)
    hash_ = page.evaluate("location.hash")
    again = open_page(kicks_page, hash_[1:])
    assert state(again)["item"] == "aa"
    page.keyboard.press("g")
    assert state(page)["view"] == "repeats"
    assert state(page)["item"] is None
    page.keyboard.press("g")
    assert state(page)["view"] == "graph"


@pytest.mark.browser
@pytest.mark.parametrize("width", [390, 900, 1440])
def test_nothing_lies_beyond_the_screen(open_page: Open, kicks_page: Path, width: int) -> None:
    page = open_page(kicks_page, "view=graph&images=1", width=width)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.locator(".node").first.is_visible()
    assert page.locator(".item").first.is_visible()
    labels = page.locator(".graph-field button, #graph button, .walk button").evaluate_all(
        "(all) => all.map((b) => b.getAttribute('aria-label') || b.textContent)"
    )
    assert all(labels)


@pytest.fixture
def large(kicks: tuple[Any, MotionGraph], monkeypatch: pytest.MonkeyPatch) -> tuple[Any, MotionGraph]:
    """The kicks, as if one state and one path were as many as a picture holds."""
    monkeypatch.setattr(
        "leitmotion.view.graph_payload.most_visited", partial(most_visited, states=1, paths=1)
    )
    return kicks


def test_of_a_large_graph_the_payload_lays_the_most_visited_out_by_itself(large):
    body, graph = large
    told = graph_payload(body, graph)["most"]
    assert told["said"] == "The most visited: 1 of 2 postures, 1 of 2 ways."
    assert told["states"].keys() == {"A", "A*"}
    assert told["paths"].keys() == {"aa", "(aa)*"}


def test_of_a_small_graph_all_is_laid_out_once(kicks):
    assert graph_payload(*kicks)["most"] is None


@pytest.mark.browser
def test_a_large_graph_shows_the_most_visited_and_all_on_request(
    open_page: Open, large: Any, known: Any, tmp_path: Path
) -> None:
    body, graph = large
    told = known._replace(
        body=body,
        patterns=Patterns((), (), body.rate, {"min_duration_s": 0.5}),
        matrix=self_distance(posture(body)),
        labels=None,
    )
    path = tmp_path / "large.html"
    path.write_text(told.page(graph=graph, opens_with="graph"), encoding="utf-8")
    page = open_page(path)
    line = page.locator(".graph-most")
    assert line.inner_text() == "The most visited: 1 of 2 postures, 1 of 2 ways. Show all"
    assert page.locator(".node:visible").count() == 1
    assert page.locator(".edge-name:visible").count() == 1
    line.get_by_role("button").click()
    assert state(page)["whole"]
    assert page.locator(".node:visible").count() == 2
    line.get_by_role("button").click()
    assert not state(page)["whole"]
    assert page.locator(".node:visible").count() == 1
    page.locator(".item:visible").nth(1).click()  # X, from the list
    assert (state(page)["item"], state(page)["whole"]) == ("X", True)
    assert page.locator(".node:visible").count() == 2
    for node in page.locator(".node:visible").all():
        assert node.evaluate(
            "(e) => { const r = e.getBoundingClientRect();"
            " return e.contains(document.elementFromPoint(r.x + r.width / 2, r.y + r.height / 2)); }"
        )
    page.keyboard.press("Escape")
    page.get_by_role("button", name="Repeats").click()
    assert state(page)["view"] == "repeats"
    assert not line.is_visible()
