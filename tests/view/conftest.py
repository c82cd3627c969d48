"""A recording of which everything is known, the page of it, and one browser for all tests of pages."""

import itertools
import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from leitmotion.body import Body, dynamics, embody
from leitmotion.datasets import compose_session
from leitmotion.discovery import Pattern, PatternPair, Patterns, Symmetry, SymmetrySpan
from leitmotion.features import kinematic_chain
from leitmotion.motion import Segmentation
from leitmotion.similarity import SimilarityMatrix, double_metric
from leitmotion.view import Mirroring, report_page

RATE = 30.0
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
SWITCHES = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update"]


class Known(NamedTuple):
    """What a page is made of."""

    body: Body
    patterns: Patterns
    matrix: SimilarityMatrix
    labels: Segmentation | None = None

    def page(self, **options: Any) -> str:
        """The page."""
        given = {"source": {"path": "practice.bvh"}, "labels": self.labels, "labels_from": "truth.csv"}
        return report_page(self.body, self.patterns, self.matrix, **given | options)


def eq2(body: Body) -> SimilarityMatrix:
    """Paper P, eq. 2, on the roles that have a name in the body, written to be obviously right."""
    from leitmotion.body import ANALYSIS_ROLES

    points = body.positions[:, [body.roles.index(role) for role in ANALYSIS_ROLES if role in body.roles]]
    root = body.positions[:, body.roles.index("pelvis")] * [1, 0, 1]
    c, s = np.cos(-body.facing)[:, None], np.sin(-body.facing)[:, None]
    x, y, z = np.moveaxis(points - root[:, None], 2, 0)
    straight = np.stack([c * x + s * z, y, c * z - s * x], axis=2)
    values = np.zeros((len(body), len(body)), dtype=np.float32)
    for joint in range(straight.shape[1]):
        values += np.linalg.norm(straight[:, None, joint] - straight[None, :, joint], axis=2).astype(
            np.float32
        )
    return SimilarityMatrix(
        values / straight.shape[1] / body.size, "mean_norm", body.rate, body.rate, scale=body.size
    )


def segments(spans: list[tuple[int, int]], rate: float = RATE) -> Segmentation:
    """Stretches without a name."""
    return Segmentation([a for a, _ in spans], [b for _, b in spans], rate=rate)


def straight_path(a: tuple[int, int], b: tuple[int, int]) -> np.ndarray:
    """A path at even pace from one stretch to another."""
    steps = np.linspace(0, 1, max(a[1] - a[0], b[1] - b[0]))
    return (
        np.stack([a[0] + steps * (a[1] - a[0] - 1), b[0] + steps * (b[1] - b[0] - 1)], axis=1)
        .round()
        .astype(int)
    )


def patterns_of(session: Any) -> Patterns:
    """The truth of a session as patterns: a kind of action each, a stripe for every two neighbouring cycles."""
    found, pairs = [], []
    kinds = dict.fromkeys(label for _, _, label, _ in session.cycles)
    for name, letter in zip(kinds, "ABCDEFGHIJ"):
        cycles = [(a, b) for a, b, label, _ in session.cycles if label == name]
        stretches = [(a, b) for a, b, label, _ in session.stretches if label == name]
        period = float(np.median([b - a for a, b in cycles]) / RATE)
        sure = 0.4 if letter == "F" else 0.9
        found.append(
            Pattern(
                letter,
                "cyclic",
                segments(cycles),
                segments(stretches),
                period,
                0.03,
                sure,
                f"truth of {name}",
            )
        )
        pairs += [PatternPair(letter, straight_path(a, b), 0.03) for a, b in itertools.pairwise(cycles)]
    return Patterns(tuple(found), (), RATE, {"min_duration_s": 0.5}, stripes=tuple(pairs))


@pytest.fixture(scope="session")
def known() -> Known:
    """The composed session with its truth as patterns: A walks in two stretches, F is uncertain."""
    session = compose_session(rate=RATE)
    body = embody(session.motion)
    return Known(body.replace(name="practice"), patterns_of(session), eq2(body), session.stretches)


def motifs_of(session: Any) -> Symmetry:
    """The truth of a session as motifs: walks, jacks and kicks, and the left kick again as a right one."""
    spans = []
    whole = {label: [] for _, _, label, _ in session.stretches}
    for start, stop, label, _ in session.stretches:
        whole[label].append((start, stop))
    forms = (("walk", "anti_phase"), ("jumping jack", "symmetric_palindrome"), ("squat", "symmetric_cycle"))
    for label, motif in (*forms, ("left side kick", "asymmetric_palindrome")):
        for first, last in whole[label]:
            inside = [
                (a, b) for a, b, name, _ in session.cycles if name == label and first <= a and b <= last
            ]
            halves = sorted({moment for a, b in inside for moment in (a, (a + b) // 2, b)})
            marks = (
                sorted({moment for pair in inside for moment in pair}) if motif.endswith("cycle") else halves
            )
            sure = 0.4 if motif.startswith("asymmetric") else 0.9
            share, links = (0.9, ("left_femur", "left_tibia")) if sure < 0.5 else (0.5, ())
            spans.append(
                SymmetrySpan(
                    motif,
                    first,
                    last,
                    sure,
                    cyclic=True,
                    marks=marks,
                    reason=f"truth of {label}",
                    left_share=share,
                    links=links,
                )
            )
    left, right = whole["left side kick"][0], whole["right side kick"][0]
    spans.append(
        SymmetrySpan("reflected_path_repetition", *left, 0.8, partner=right, reason="truth of kicks")
    )
    spans += [SymmetrySpan("stillness", *span, 1.0, reason="truth of still") for span in whole["still"]]
    spans.sort(key=lambda span: span.start)
    return Symmetry(tuple(spans), RATE, len(session.motion), {}, strikes=[900, 930])


@pytest.fixture(scope="session")
def mirroring() -> Mirroring:
    """The composed session beside its mirror image, with its truth as motifs."""
    session = compose_session(rate=RATE)
    return Mirroring(motifs_of(session), double_metric(kinematic_chain(session.motion)))


@pytest.fixture(scope="session")
def symmetric_page(known: Known, mirroring: Mirroring, folder: Path) -> Path:
    """The page of the known session with its symmetry and its dynamics."""
    page = known.page(mirroring=mirroring, dynamics=dynamics(compose_session(rate=RATE).motion))
    (folder / "symmetric.html").write_text(page, encoding="utf-8")
    return folder / "symmetric.html"


@pytest.fixture(scope="session")
def nothing(known: Known) -> Known:
    """Four seconds in which nothing repeats."""
    body = known.body.replace(
        positions=known.body.positions[:120], facing=known.body.facing[:120], name="once"
    )
    return Known(body, Patterns((), (), RATE, {"min_duration_s": 0.5}), eq2(body))


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where pages are written."""
    return tmp_path_factory.mktemp("pages")


@pytest.fixture(scope="session")
def practice(known: Known, folder: Path) -> Path:
    """The page of the known session."""
    (folder / "practice.html").write_text(known.page(), encoding="utf-8")
    return folder / "practice.html"


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """The system's Chromium, once for all tests."""
    sync_api = pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")
    wanted = [os.environ.get("CHROMIUM", ""), *BROWSERS]
    path = next((found for name in wanted if name and (found := shutil.which(name))), None)
    if path is None:
        pytest.skip("no Chromium on this machine: set CHROMIUM to it")
    with sync_api.sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=SWITCHES)
        yield chromium
        chromium.close()


@pytest.fixture
def open_page(browser: Any) -> Iterator[Callable[..., Any]]:
    """Open a page from disk; afterwards: no error in its console and no request but for the file itself."""
    contexts: list[Any] = []
    faults: list[str] = []

    def opened(path: Path, hash_: str = "", *, width: int = 1440, height: int = 900, **options: Any) -> Any:
        contexts.append(browser.new_context(viewport={"width": width, "height": height}, **options))
        page = contexts[-1].new_page()
        watch(page, faults)
        page.goto(path.as_uri() + (f"#{hash_}" if hash_ else ""))
        settle(page)
        return page

    yield opened
    for context in contexts:
        context.close()
    assert faults == []


@pytest.fixture(scope="session")
def practice_page(browser: Any, practice: Path) -> Iterator[tuple[Any, list[str]]]:
    """The page of the known session, opened once, with the list of its faults."""
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    page = context.new_page()
    faults: list[str] = []
    watch(page, faults)
    page.goto(practice.as_uri())
    yield page, faults
    context.close()


@pytest.fixture
def page(practice_page: tuple[Any, list[str]]) -> Iterator[Any]:
    """The page of the known session at 20.2 s, idle, nothing focused or pointed at; afterwards without a fault."""
    page, faults = practice_page
    page.mouse.move(700, 40)
    page.evaluate("document.activeElement.blur(); scrollTo(0, 0); location.hash = 't=0&theme=light'")
    settle(page)
    page.evaluate("location.hash = 't=20.2'")
    settle(page)
    yield page
    assert faults == []


@pytest.fixture(scope="session")
def symmetric_tab(browser: Any, symmetric_page: Path) -> Iterator[tuple[Any, list[str]]]:
    """The page with symmetry, opened once, with the list of its faults."""
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    page = context.new_page()
    faults: list[str] = []
    watch(page, faults)
    page.goto(symmetric_page.as_uri())
    yield page, faults
    context.close()


@pytest.fixture
def at(symmetric_tab: tuple[Any, list[str]]) -> Iterator[Callable[[str], Any]]:
    """Bring the page to an address, idle, nothing focused or pointed at; afterwards without a fault."""
    page, faults = symmetric_tab

    def brought(address: str) -> Any:
        page.mouse.move(700, 40)
        page.evaluate("document.activeElement.blur(); scrollTo(0, 0); location.hash = 't=0&theme=light'")
        settle(page)
        page.evaluate(f"location.hash = '{address}'")
        settle(page)
        return page

    yield brought
    assert faults == []


def watch(page: Any, faults: list[str]) -> None:
    """Note every error of a page and every request but for files of this machine and what it made itself."""
    page.on("console", lambda message: faults.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: faults.append(str(error)))
    local = ("file:", "blob:", "data:")
    page.on("request", lambda request: None if request.url.startswith(local) else faults.append(request.url))


def settle(page: Any) -> None:
    """Wait until what is due is drawn."""
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
