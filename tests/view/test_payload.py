"""What the page holds is what the library found."""

import base64
import hashlib
import json
import re
from html.parser import HTMLParser
from typing import Any

import numpy as np
import pytest

from leitmotion.discovery import Patterns
from leitmotion.motion import ParameterError
from leitmotion.similarity import SimilarityMatrix
from leitmotion.view import page_payload, report_page
from leitmotion.view.report import SCRIPTS

TYPES = {
    "Int16Array": "<i2",
    "Int32Array": "<i4",
    "Uint8Array": "u1",
    "Uint16Array": "<u2",
    "Float32Array": "<f4",
}


def unpack(array: dict[str, Any]) -> np.ndarray:
    return np.frombuffer(base64.b64decode(array["data"]), TYPES[array["type"]]).reshape(array["shape"])


@pytest.fixture(scope="module")
def payload(known: Any) -> dict[str, Any]:
    return page_payload(
        known.body,
        known.patterns,
        known.matrix,
        source={"path": "p.bvh"},
        labels=known.labels,
        labels_from="t.csv",
    )


def test_the_payload_is_strict_json(payload: dict[str, Any]) -> None:
    assert json.loads(json.dumps(payload, allow_nan=False)) == payload


def test_positions_are_millimetres(payload: dict[str, Any], known: Any) -> None:
    drawn = unpack(payload["body"]["positions"])
    assert drawn.dtype == np.int16
    np.testing.assert_allclose(drawn / 1000, known.body.positions, atol=0.00051)
    np.testing.assert_allclose(unpack(payload["body"]["facing"]), known.body.facing, atol=1e-5)


def test_a_fast_recording_is_drawn_at_30_a_second(known: Any) -> None:
    fast = known.body.replace(
        positions=known.body.positions.repeat(4, axis=0), facing=known.body.facing.repeat(4), rate=120.0
    )
    drawn = page_payload(fast, known.patterns, known.matrix, source={})
    assert drawn["clock"] == {"frames": len(known.body), "rate": 30.0}
    assert drawn["source"]["frames"] == 4 * len(known.body)


def test_a_point_that_was_not_seen_stays_missing(known: Any) -> None:
    positions = known.body.positions.copy()
    positions[10, 3] = np.nan
    holed = page_payload(known.body.replace(positions=positions), known.patterns, known.matrix, source={})
    assert (unpack(holed["body"]["positions"])[10, 3] == -32768).all()


def test_a_walk_beyond_32_m_takes_wider_numbers(known: Any) -> None:
    far = page_payload(
        known.body.replace(positions=known.body.positions + np.array([50, 0, 0])),
        known.patterns,
        known.matrix,
        source={},
    )
    assert far["body"]["positions"]["type"] == "Int32Array"


def test_the_matrix_is_bytes_of_distance(payload: dict[str, Any], known: Any) -> None:
    cells = unpack(payload["matrix"]["values"])
    assert cells.dtype == np.uint8
    assert cells.shape[0] <= 600
    assert (np.diagonal(cells) == 0).all()
    assert np.array_equal(cells, cells.T)
    stride = -(-len(known.body) // 600)
    block = (
        known.matrix.values[stride * 10 : stride * 11, stride * 200 : stride * 201].mean()
        * known.matrix.scale
    )
    assert cells[10, 200] / 254 * payload["matrix"]["top"] == pytest.approx(
        min(block, payload["matrix"]["top"]), abs=1e-3
    )
    assert payload["matrix"]["top"] == pytest.approx(1.5 * payload["distance"]["cap"])


def test_the_cap_is_the_60th_percentile_in_whole_centimetres(known: Any) -> None:
    def cap(values: np.ndarray) -> float:
        matrix = SimilarityMatrix(values, "mean_norm", 30.0, 30.0, scale=known.body.size)
        found = page_payload(known.body, Patterns((), (), 30.0, {}), matrix, source={})["distance"]
        return float(found["cap"] * found["factor"])

    n = len(known.body)
    ramp = np.abs(np.subtract.outer(np.arange(n), np.arange(n))) / n / known.body.size
    off = ramp[~np.eye(n, dtype=bool)] * known.body.size * 100
    assert np.percentile(off, 60) > 16
    assert cap(ramp) == pytest.approx(16)
    wanted = np.ceil(np.percentile(off * 0.3, 60))
    assert 8 < wanted < 16
    assert cap(ramp * 0.3) == pytest.approx(wanted, abs=1)
    assert cap(ramp * 0.01) == pytest.approx(8)


def test_nearest_moments_carry_their_distance(payload: dict[str, Any], known: Any) -> None:
    nearest = payload["nearest"]
    seconds, distances = unpack(nearest["seconds"]), unpack(nearest["distances"])
    row, column = 400, round(float(seconds[400, 0]) * nearest["rate"])
    wanted = known.matrix.values[row, column] * known.matrix.scale
    assert distances[row, 0] * nearest["quantum"] == pytest.approx(wanted, abs=1e-4)
    assert (distances[np.isnan(seconds)] == 65535).all()


def test_a_body_without_facing_says_so(nothing: Any) -> None:
    unturned = nothing.body.replace(facing_told=False)
    for body, said in ((nothing.body, False), (unturned, True)):
        page = page_payload(body, nothing.patterns, nothing.matrix, source={})
        for text in (page["empty"], page["looked_for"]):
            assert ("compared as they stand" in text) is said


def test_stripes_are_the_paths_in_seconds(payload: dict[str, Any], known: Any) -> None:
    stripes = payload["stripes"]
    points = unpack(stripes["points"])
    assert len(stripes["length"]) == len(stripes["pattern"]) == len(known.patterns.stripes)
    at = 0
    for length, pair in zip(stripes["length"], known.patterns.stripes):
        path = points[at : at + length]
        at += length
        np.testing.assert_allclose(path[0] * 30, pair.path[0], atol=1e-3)
        np.testing.assert_allclose(path[-1] * 30, pair.path[-1], atol=1e-3)
        assert (np.diff(path, axis=0) >= 0).all()


def test_patterns_carry_stretches_and_cycles(payload: dict[str, Any], known: Any) -> None:
    for drawn, pattern in zip(payload["patterns"], known.patterns.patterns):
        assert drawn["id"] == pattern.id
        assert len(drawn["stretches"]) == len(pattern.stretches)
        assert sum(len(stretch["cycles"]) for stretch in drawn["stretches"]) == len(pattern.occurrences)
        assert any(stretch["start"] <= drawn["key"] <= stretch["stop"] for stretch in drawn["stretches"])


def test_the_labels_name_their_file(payload: dict[str, Any], known: Any) -> None:
    assert payload["labels"]["title"] == "Labels in t.csv"
    assert len(payload["labels"]["items"]) == len(known.labels)
    without = page_payload(known.body, known.patterns, known.matrix, source={})
    assert without["labels"] is None


def test_another_unit_is_told_as_parts_of_the_body(known: Any) -> None:
    pixels = known.body.replace(
        positions=known.body.positions[..., :2] * 300, size=known.body.size * 300, unit="px"
    )
    matrix = known.matrix.replace(scale=known.matrix.scale * 300, unit="px")
    drawn = page_payload(pixels, known.patterns, matrix, source={})
    assert drawn["body"]["flat"]
    assert not drawn["body"]["metres"]
    assert drawn["distance"]["unit"] == "% of body size"
    assert drawn["distance"]["factor"] * 1.6 == pytest.approx(100)
    positions = unpack(drawn["body"]["positions"]) / 1000
    np.testing.assert_allclose(
        positions[..., 1] / 1.6, known.body.positions[..., 1] / known.body.size, atol=1e-3
    )


def test_angles_are_told_in_degrees(known: Any) -> None:
    drawn = page_payload(
        known.body, known.patterns, known.matrix.replace(metric="geodesic", unit="rad", scale=1.0), source={}
    )
    assert drawn["distance"]["unit"] == "°"
    assert drawn["body"]["compared"] == []


def test_points_without_a_role_are_dots(known: Any) -> None:
    names = tuple(f"M{k}" for k in range(len(known.body.roles)))
    drawn = page_payload(known.body.replace(roles=names), known.patterns, known.matrix, source={})
    assert drawn["body"]["dots"]
    assert drawn["body"]["links"] == []
    assert drawn["body"]["compared"] == list(range(len(names)))


def test_only_what_was_searched_is_compared(known: Any) -> None:
    searched = known.patterns.replace(parameters={"features": ["head", "left_knee", "gone"]})
    drawn = page_payload(known.body, searched, known.matrix, source={})
    assert [drawn["body"]["roles"][r] for r in drawn["body"]["compared"]] == ["head", "left_knee"]


def test_a_matrix_of_another_recording_is_refused(known: Any) -> None:
    values = known.matrix.values
    with pytest.raises(ParameterError, match="square"):
        page_payload(known.body, known.patterns, known.matrix.replace(values=values[:10]), source={})
    with pytest.raises(ParameterError, match="must be one recording"):
        page_payload(known.body, known.patterns, known.matrix.replace(values=values[:90, :90]), source={})


class Outside(HTMLParser):
    """Collects every address that an element of the page points to."""

    def __init__(self) -> None:
        super().__init__()
        self.addresses: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.addresses += [
            value or "" for name, value in attrs if name in ("src", "href", "action", "data", "poster")
        ]


def test_the_page_points_at_nothing_outside(known: Any) -> None:
    parser = Outside()
    parser.feed(known.page())
    assert parser.addresses == ["#answer"]
    style = re.search(r"<style>(.*?)</style>", known.page(), re.S)
    assert style
    assert "url(" not in style[1]
    assert "@import" not in style[1]


def test_the_policy_forbids_all_but_the_one_script_and_style(known: Any) -> None:
    page = known.page()
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', page)
    assert policy
    rules = dict(rule.strip().split(" ", 1) for rule in policy[1].split(";"))
    assert rules["default-src"] == "'none'"
    assert rules["img-src"] == "data: blob:"
    for kind, pattern in (("script-src", r"<script>(.*?)</script>"), ("style-src", r"<style>(.*?)</style>")):
        inline = re.search(pattern, page, re.S)
        assert inline
        digest = base64.b64encode(hashlib.sha256(inline[1].encode()).digest()).decode()
        assert rules[kind] == f"'sha256-{digest}'"


def test_every_script_is_in_the_page() -> None:
    from importlib.resources import files

    parts = files("leitmotion.view").joinpath("page", "js").iterdir()
    assert {part.name.removesuffix(".js") for part in parts} == set(SCRIPTS)
    assert len(SCRIPTS) == len(set(SCRIPTS))


def test_names_cannot_break_out_of_the_page(known: Any) -> None:
    nasty = "</script><script>alert(1)</script> {{script}} & <b>"
    labels = known.labels.replace(labels=(nasty,) * len(known.labels))
    page = report_page(
        known.body.replace(name=nasty),
        known.patterns,
        known.matrix,
        source={},
        labels=labels,
        labels_from=nasty,
    )
    assert page.count("<script") == 2
    assert "alert(1)</script>" not in page


def test_same_nouns_same_page(known: Any) -> None:
    assert known.page() == known.page()
