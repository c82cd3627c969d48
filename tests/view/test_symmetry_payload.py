"""What the Symmetry view holds: what was found, as it was found."""

import base64
from typing import Any

import numpy as np
import pytest

from leitmotion.body import ANALYSIS_ROLES, Dynamics, dynamics, mirror_role
from leitmotion.datasets import compose_session
from leitmotion.discovery import SymmetrySpan
from leitmotion.similarity import DoubleMetric, likeness
from leitmotion.view import Mirroring, page_payload
from leitmotion.view.curve_payload import curves_payload
from leitmotion.view.symmetry_fit import fit
from leitmotion.view.symmetry_payload import ROWS

RATE = 30.0


def unpacked(array: dict[str, Any]) -> np.ndarray:
    kinds = {"Int16Array": "<i2", "Uint8Array": "u1", "Uint16Array": "<u2"}
    return np.frombuffer(base64.b64decode(array["data"]), kinds[array["type"]]).reshape(array["shape"])


@pytest.fixture(scope="module")
def held(known: Any, mirroring: Mirroring) -> dict[str, Any]:
    found: dict[str, Any] = page_payload(
        known.body, known.patterns, known.matrix, source={}, mirroring=mirroring
    )["symmetry"]
    return found


@pytest.fixture(scope="module")
def moved() -> Dynamics:
    return dynamics(compose_session(rate=RATE).motion)


def test_both_likenesses_stand_in_one_square(held: dict[str, Any], mirroring: Mirroring) -> None:
    cells = unpacked(held["matrix"]["values"])
    distances = mirroring.distances
    step = -(-len(distances) // 600)
    assert len(cells) == -(-len(distances) // step) <= 600
    assert held["matrix"]["rate"] == pytest.approx(RATE / step)

    def mean(values: np.ndarray, i: int, j: int) -> float:
        block = values[i * step : (i + 1) * step, j * step : (j + 1) * step]
        return float(likeness(block, distances.beta).mean())

    rng = np.random.default_rng(3)
    for i, j in np.sort(rng.integers(0, len(cells), (40, 2)), axis=1):
        if i < j:
            assert cells[i, j] == pytest.approx(254 * mean(distances.own, i, j), abs=0.51)
        assert cells[j, i] == pytest.approx(254 * mean(distances.mirror, i, j), abs=0.51)


def test_what_is_unseen_is_unknown(known: Any, mirroring: Mirroring) -> None:
    found = mirroring.distances
    own, mirror = found.own.copy(), found.mirror.copy()
    for values in (own, mirror):
        values[30:60] = np.nan
        values[:, 30:60] = np.nan
    blind = Mirroring(mirroring.found, found.replace(own=own, mirror=mirror))
    drawn = page_payload(known.body, known.patterns, known.matrix, source={}, mirroring=blind)["symmetry"]
    cells, speed = unpacked(drawn["matrix"]["values"]), unpacked(drawn["speed"]["values"])
    assert (cells[10:20] == 255).all()
    assert (cells[:, 10:20] == 255).all()
    assert (cells[:10, :10] < 255).all()
    assert (speed[11:19] == 255).all()


def test_lopsidedness_is_the_mean_distance_of_joints_from_their_mirror_images(
    held: dict[str, Any], known: Any
) -> None:
    curve = unpacked(held["lopsidedness"]["values"]) * held["lopsidedness"]["quantum"]
    body = known.body
    at = {role: k for k, role in enumerate(body.roles)}
    names = [role for role in ANALYSIS_ROLES if role in at]
    assert [body.roles[k] for k in held["compared"]] == names
    for frame in (100, 500, 1000, 1400):
        turn, apart = body.facing[frame], []
        left = np.array([np.cos(turn), 0.0, -np.sin(turn)])
        for role in names:
            here, other = body.positions[frame, at[role]], body.positions[frame, at[mirror_role(role)]]
            off = (other - body.positions[frame, at["pelvis"]]) @ left
            apart.append(np.linalg.norm(here - (other - 2 * off * left)))
        assert curve[frame] == pytest.approx(np.mean(apart), abs=6e-4)
    assert held["told"] == {"factor": 100.0, "unit": "cm"}


def test_lanes_hold_every_span_with_the_pattern_around_it(
    held: dict[str, Any], known: Any, mirroring: Mirroring
) -> None:
    lanes = {lane["motif"]: lane for lane in held["lanes"]}
    assert sum(len(lane["spans"]) for lane in lanes.values()) == len(mirroring.found.spans)
    assert next(iter(lanes)) == "anti_phase"
    assert list(lanes)[-1] == "stillness"
    walks = lanes["anti_phase"]["spans"]
    assert [known.patterns.patterns[span["pattern"]].reason for span in walks] == ["truth of walk"] * 2
    assert lanes["stillness"]["spans"][0]["pattern"] is None
    assert not lanes["reflected_path_repetition"]["chief"]
    assert lanes["reflected_path_repetition"]["spans"][0]["partner"][0] > 30
    assert all(1 <= lane["rows"] <= ROWS for lane in lanes.values())
    assert held["title"] == "Both sides move together in two stretches"
    assert held["strikes"] == [30.0, 31.0]


def test_what_overlaps_lies_in_rows(known: Any, mirroring: Mirroring) -> None:
    spans = [
        SymmetrySpan("stillness", a, b, 1.0) for a, b in ((0, 90), (30, 60), (45, 120), (50, 70), (100, 130))
    ]
    many = Mirroring(mirroring.found.replace(spans=tuple(spans)), mirroring.distances)
    drawn = page_payload(known.body, known.patterns, known.matrix, source={}, mirroring=many)["symmetry"]
    lane = drawn["lanes"][0]
    assert lane["rows"] == ROWS
    assert [span["row"] for span in lane["spans"]] == [0, 1, 2, 2, 0]


@pytest.mark.parametrize(
    ("motif", "to", "mirrored"),
    [
        ("anti_phase", [[1, 2], [2, 3], [1, 2]], True),
        ("anti_palindrome", [[2, 1], [1, 0], [2, 1]], True),
        ("asymmetric_palindrome", [[2, 1], [1, 0], [2, 1]], False),
        ("asymmetric_cycle", [[1, 2], [2, 3], [1, 2]], False),
        ("symmetric_cycle", [[0, 3]], True),
        ("symmetric_path", [[0, 3]], True),
    ],
)
def test_a_stretch_tells_what_should_look_like_now(motif: str, to: list[list[float]], mirrored: bool) -> None:
    found = fit(SymmetrySpan(motif, 0, 90, 0.9, marks=[0, 30, 60, 90]), RATE)
    assert found["to"] == to
    assert found["mirrored"] is mirrored
    assert len(found["at"]) == len(to)


def test_a_partner_is_what_should_look_like_now() -> None:
    for motif, to, mirrored in (
        ("path_repetition", [4.0, 6.0], False),
        ("reflected_path_repetition", [4.0, 6.0], True),
        ("path_reversal", [6.0, 4.0], False),
    ):
        found = fit(SymmetrySpan(motif, 0, 90, 0.9, partner=(120, 180)), RATE)
        assert (found["at"], found["to"], found["mirrored"]) == ([[0.0, 3.0]], [to], mirrored)


def belonging(told: dict[str, Any], now: np.ndarray) -> np.ndarray:
    """What a fit says to each moment, moments."""
    ways = np.clip(np.searchsorted([at[0] for at in told["at"]], now / RATE, side="right") - 1, 0, None)
    there = [np.interp(t / RATE, told["at"][k], told["to"][k]) for t, k in zip(now, ways)]
    return np.rint(np.array(there) * RATE).astype(int)


def test_the_ghost_of_a_walk_fits_where_its_mirror_image_at_once_does_not(mirroring: Mirroring) -> None:
    distances: DoubleMetric = mirroring.distances
    walk = next(span for span in mirroring.found.spans if span.motif == "anti_phase")
    now = np.arange(walk.marks[0], walk.marks[-1])
    at_once = distances.mirror[now, now].mean()
    evenly, warped = (
        distances.mirror[now, belonging(fit(walk, RATE, by), now)].mean() for by in (None, distances)
    )
    assert evenly < 0.3 * at_once
    assert warped < evenly


def test_a_kick_is_laid_over_its_way_back(mirroring: Mirroring) -> None:
    distances: DoubleMetric = mirroring.distances
    kick = next(span for span in mirroring.found.spans if span.motif == "asymmetric_palindrome")
    now = np.arange(kick.marks[0], kick.marks[-1])
    told = fit(kick, RATE, distances)
    assert not told["mirrored"]
    for at, to in zip(told["at"], told["to"]):
        assert (np.diff(at) > 0).all()
        assert (np.diff(to) <= 0).all()
    shuffled = distances.own[now, np.roll(now, len(now) // 3)].mean()
    assert distances.own[now, belonging(told, now)].mean() < 0.3 * shuffled


def test_where_nothing_was_seen_it_runs_evenly(mirroring: Mirroring) -> None:
    walk = next(span for span in mirroring.found.spans if span.motif == "anti_phase")
    blind = np.full_like(mirroring.distances.mirror, np.nan)
    assert fit(walk, RATE, mirroring.distances.replace(mirror=blind)) == fit(walk, RATE)


def test_without_symmetry_a_sentence_says_why(known: Any) -> None:
    drawn = page_payload(known.body, known.patterns, known.matrix, source={}, mirroring="It is flat.")
    assert drawn["symmetry"] == {"none": "It is flat."}
    assert drawn["curves"] is None


def test_curves_are_those_of_the_library(moved: Dynamics) -> None:
    held = curves_payload(moved, step=2)
    curves = {item["id"]: unpacked(item["values"]) * item["quantum"] for item in held["items"]}
    assert list(curves) == ["speed", "height", "energy", "turning"]
    assert curves["height"] == pytest.approx(moved.centre_of_mass[::2, 1], abs=1e-4)
    assert curves["energy"] == pytest.approx(moved.kinetic_energy[::2], abs=moved.kinetic_energy.max() / 3e4)
    speed = np.linalg.norm(moved.linear_momentum, axis=1)[::2] / moved.mass
    assert curves["speed"] == pytest.approx(speed, abs=speed.max() / 3e4)
    assert len(held["flights"]) == len(moved.flights)
    notes = {item["id"]: item["note"] for item in held["items"]}
    assert notes["energy"] == "if it weighs 70 kg"


def test_unseen_frames_have_no_value(moved: Dynamics) -> None:
    centre = moved.centre_of_mass.copy()
    centre[10:20] = np.nan
    held = curves_payload(moved.replace(centre_of_mass=centre), step=1)
    height = unpacked(held["items"][1]["values"])
    assert (height[10:20] == -32768).all()
    assert (height[:10] > 0).all()
