"""Recordings that are unlike the usual: the page draws what there is and says what is true, without a fault."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from leitmotion.discovery import Pattern, Patterns
from leitmotion.motion import Segmentation

pytestmark = pytest.mark.browser


def flat(known: Any) -> Any:
    """Pixels of a camera: two numbers a joint, no metres."""
    body = known.body.replace(
        positions=known.body.positions[..., :2] * 300, size=known.body.size * 300, unit="px"
    )
    return known._replace(body=body, matrix=known.matrix.replace(scale=known.matrix.scale * 300, unit="px"))


def holed(known: Any) -> Any:
    """A person who leaves the view for a second, and a hand that is seen now and then."""
    positions, values = known.body.positions.copy(), known.matrix.values.copy()
    positions[100:130] = np.nan
    positions[::3, known.body.roles.index("left_wrist")] = np.nan
    values[100:130] = np.nan
    values[:, 100:130] = np.nan
    return known._replace(
        body=known.body.replace(positions=positions), matrix=known.matrix.replace(values=values)
    )


def dots(known: Any) -> Any:
    """Markers whose place on the body is unknown."""
    return known._replace(body=known.body.replace(roles=tuple(f"M{k}" for k in range(len(known.body.roles)))))


def moment(known: Any) -> Any:
    """A single frame."""
    body = known.body.replace(positions=known.body.positions[:1], facing=known.body.facing[:1])
    return known._replace(
        body=body,
        matrix=known.matrix.replace(values=known.matrix.values[:1, :1]),
        patterns=Patterns((), (), 30.0, {}),
        labels=None,
    )


def returning(known: Any) -> Any:
    """An acyclic pattern: two stretches, no cycles."""
    spans = Segmentation([60, 900], [160, 1000], rate=30.0)
    pattern = Pattern("A", "acyclic", spans, spans, 3.3, 0.04, 0.7, "alike")
    return known._replace(patterns=Patterns((pattern,), (), 30.0, {}))


def angles(known: Any) -> Any:
    """Joint rotations were searched: distances in degrees, read from the matrix."""
    return known._replace(matrix=known.matrix.replace(metric="geodesic", unit="rad", scale=1.0))


@pytest.mark.parametrize("change", [flat, holed, dots, moment, returning, angles])
def test_it_draws_without_a_fault(
    open_page: Callable[..., Any], known: Any, folder: Path, change: Any
) -> None:
    path = folder / f"{change.__name__}.html"
    path.write_text(change(known).page(), encoding="utf-8")
    page = open_page(path)
    seconds = page.evaluate("leitmotion.payload.source.seconds")
    for part in (0.0, 0.06, 0.5, 0.99):
        page.evaluate(f"location.hash = 't={part * seconds}&u={seconds}&camera=side'")
        page.wait_for_timeout(30)
        assert page.evaluate("leitmotion.draw()") < 1000
    page.keyboard.press("4")
    page.keyboard.press(" ")
    page.wait_for_timeout(60)
    told = {
        "flat": ("#matrix-legend", "% of body size"),
        "holed": ("#matrix-legend", "cm apart"),
        "dots": ("#panel", "cm apart"),
        "moment": ("h1", "Nothing repeats here"),
        "returning": (".lane-head", "of 3.30 s"),
        "angles": ("#panel", "° apart"),
    }
    where, words = told[change.__name__]
    assert words in page.locator(where).first.inner_text()


def test_the_unseen_is_said_not_guessed(open_page: Callable[..., Any], known: Any, folder: Path) -> None:
    path = folder / "holed.html"
    path.write_text(holed(known).page(), encoding="utf-8")
    page = open_page(path, "t=3.8&u=30")
    assert (
        page.locator("#panel .verdict").inner_text() == "Too little of the body was seen to compare the two."
    )
    pixel = (
        "Array.from(document.getElementById('matrix-base').getContext('2d').getImageData(%d, %d, 1, 1).data)"
    )
    at = page.evaluate("leitmotion.matrix")
    scale = at["side"] / page.evaluate("leitmotion.payload.source.seconds")
    unknown = page.evaluate(pixel % (at["left"] + 50 * scale, at["upper"] + 3.8 * scale))
    assert unknown[:3] == [0xF0, 0xEF, 0xEB]
