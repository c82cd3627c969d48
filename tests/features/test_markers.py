"""Marker posture: paper P's eq. 1, marker by marker."""

import numpy as np
import pytest

from leitmotion.features import marker_posture
from leitmotion.motion import DataError, ParameterError
from oracles.body import human, moved, points_of

SUIT = {
    "Spine1": "T10", "Neck": "C7", "Head": "LFHD", "LeftArm": "LSHO", "RightArm": "RSHO", "LeftForeArm": "LELB",
    "RightForeArm": "RELB", "LeftUpLeg": "LASI", "RightUpLeg": "RASI", "LeftLeg": "LKNE", "RightLeg": "RKNE",
}  # fmt: skip


@pytest.fixture
def dancer(rng):
    return human(rng, frames=60)


def suit(motion):
    return points_of(motion, SUIT, kind="marker")


def test_invariant_to_place_and_yaw(dancer):
    own, other = (marker_posture(suit(m)).values for m in (dancer, moved(dancer, yaw=2.5, by=[3, 0, 1])))
    assert np.allclose(own, other)


def test_is_equation_1_written_out(dancer):
    markers = suit(dancer)
    p = {name: markers.positions[:, i] for i, name in enumerate(markers.names)}
    for frame, row in enumerate(marker_posture(markers).values.reshape(60, -1, 3)):
        left, right, back = p["LSHO"][frame], p["RSHO"][frame], p["T10"][frame]
        normal = np.cross(left - right, (left + right) / 2 - back)
        cosine, sine = normal[[2, 0]] / np.hypot(normal[0], normal[2])
        turn = np.array([[cosine, 0, -sine], [0, 1, 0], [sine, 0, cosine]])
        for marker, value in zip(markers.names, row):
            assert np.allclose(turn @ (p[marker][frame] - back * [1, 0, 1]), value)


def test_lengths_and_heights_stay(dancer):
    markers = suit(dancer)
    values = marker_posture(markers).values.reshape(60, -1, 3)
    assert np.allclose(values[..., 1], markers.positions[..., 1])
    assert np.allclose(
        np.linalg.norm(values[:, 0] - values[:, 5], axis=1),
        np.linalg.norm(markers.positions[:, 0] - markers.positions[:, 5], axis=1),
    )


def test_without_a_mid_back_the_pelvis_is_the_centre(dancer):
    names = {joint: name for joint, name in SUIT.items() if name != "T10"}
    values = marker_posture(points_of(dancer, names, kind="marker")).values.reshape(60, -1, 3)
    waist = [list(names.values()).index(name) for name in ("LASI", "RASI")]
    assert np.allclose(values[:, waist].mean(axis=1)[:, [0, 2]], 0)


def test_named_markers_are_taken(dancer):
    markers = suit(dancer)
    given = marker_posture(markers, mid_back="T10", trunk=("LSHO", "RSHO", "T10"))
    assert given == marker_posture(markers)


def test_an_unseen_centre_hides_the_frame(dancer):
    markers = suit(dancer)
    holes = markers.positions.copy()
    holes[7, markers.names.index("T10")] = np.nan
    unseen = np.isnan(marker_posture(markers.replace(positions=holes)).values).all(axis=1)
    assert np.flatnonzero(unseen).tolist() == [7]


def test_errors_name_what_is_missing(dancer):
    markers = suit(dancer)
    with pytest.raises(ParameterError, match="'T11'"):
        marker_posture(markers, mid_back="T11")
    with pytest.raises(DataError, match="pelvis"):
        marker_posture(points_of(dancer, {"Head": "M1", "Neck": "M2"}, kind="marker"))
    with pytest.raises(DataError, match="three dimensions"):
        marker_posture(markers.replace(positions=markers.positions[..., :2]))
