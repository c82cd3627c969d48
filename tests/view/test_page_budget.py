"""Ten minutes at 120 frames a second: how large the page is, how fast it opens and draws."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from leitmotion.discovery import PatternPair, Patterns
from leitmotion.similarity import SimilarityMatrix
from leitmotion.view import Mirroring

pytestmark = pytest.mark.browser

Open = Callable[..., Any]
SECONDS = 600


@pytest.fixture(scope="module")
def long_page(known: Any, mirroring: Mirroring, folder: Path) -> Path:
    """The practice session again and again for ten minutes, every frame read four times."""
    rounds = SECONDS * 30 // len(known.body)
    once = len(known.body) * 4
    body = known.body.replace(
        positions=np.tile(known.body.positions.repeat(4, axis=0), (rounds, 1, 1)),
        facing=np.tile(known.body.facing.repeat(4), rounds),
        rate=120.0,
    )
    small = known.matrix.values[::6, ::6]
    values = np.tile(small, (rounds, rounds))
    rate = values.shape[0] / (len(body) / 120)
    matrix = SimilarityMatrix(values, "mean_norm", rate, rate, scale=known.matrix.scale)
    patterns, pairs = [], []
    for pattern in known.patterns.patterns:
        spans = {}
        for what in ("occurrences", "stretches"):
            one = getattr(pattern, what)
            moved = [(a * 4 + k * once, b * 4 + k * once) for k in range(rounds) for a, b, _, _ in one]
            spans[what] = type(one)([a for a, _ in moved], [b for _, b in moved], rate=120.0)
        patterns.append(pattern.replace(**spans))
    for pair in known.patterns.stripes:
        for k in range(rounds):
            pairs += [
                PatternPair(pair.pattern, pair.path * 4 + [k * once, j * once], 0.03)
                for j in range(k, rounds)
            ]
    page = known._replace(
        body=body,
        matrix=matrix,
        patterns=Patterns(tuple(patterns), (), 120.0, {}, stripes=tuple(pairs)),
        labels=None,
    )
    path = folder / "long.html"
    own, mirror = (
        np.tile(each[::6, ::6], (rounds, rounds))
        for each in (mirroring.distances.own, mirroring.distances.mirror)
    )
    found, distances = mirroring.found, mirroring.distances.replace(own=own, mirror=mirror, rate=rate)
    spans = [
        span.replace(
            start=span.start * 4 + k * once,
            stop=span.stop * 4 + k * once,
            marks=span.marks * 4 + k * once,
            partner=None if span.partner is None else tuple(moment * 4 + k * once for moment in span.partner),
        )
        for k in range(rounds)
        for span in found.spans
    ]
    many = Mirroring(found.replace(spans=tuple(spans), rate=120.0, frames=len(body)), distances)
    path.write_text(page.page(mirroring=many), encoding="utf-8")
    return path


def test_ten_minutes_within_the_budget(open_page: Open, long_page: Path) -> None:
    assert os.path.getsize(long_page) <= 15e6
    page = open_page(long_page)
    loaded = "performance.getEntriesByType('navigation')[0].loadEventEnd"
    opened = [page.evaluate(loaded)]
    page.reload()
    opened.append(page.evaluate(loaded))
    assert min(opened) <= 2000
    page.keyboard.press("m")
    for _ in ("symmetry", "repeats"):
        costs = page.evaluate("Array.from({ length: 20 }, () => leitmotion.draw())")
        assert np.median(costs) <= 1000 / 30
        page.keyboard.press("m")
    page.keyboard.press(" ")
    page.wait_for_timeout(150)
    bitmap = "document.getElementById('matrix-base').toDataURL().length"
    before, drawn = page.evaluate(bitmap), page.evaluate("leitmotion.cost.frames")
    page.wait_for_timeout(1000)
    assert page.evaluate("leitmotion.cost.frames") - drawn >= 10
    assert page.evaluate(bitmap) == before
    page.keyboard.press(" ")


def test_a_playing_frame_redraws_no_bitmap(page: Any) -> None:
    page.evaluate(
        """() => { window.drawn = {}; const drawImage = CanvasRenderingContext2D.prototype.clearRect;
        CanvasRenderingContext2D.prototype.clearRect = function (...box) {
          const key = this.canvas.id || this.canvas.parentElement?.className || "layer";
          drawn[key] = (drawn[key] || 0) + 1; return drawImage.apply(this, box); }; }"""
    )
    page.keyboard.press(" ")
    page.wait_for_timeout(400)
    page.keyboard.press(" ")
    drawn = page.evaluate("drawn")
    assert drawn["stage"] > 3
    assert drawn["matrix"] > 3
    # Pressing play and pausing are choices: each draws the bitmaps once.
    assert drawn.get("matrix-base", 0) <= 2
    assert drawn.get("row strip", 0) == 0
    assert drawn.get("lane-head", 0) == 0
