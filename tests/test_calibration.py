"""The façade's calibration: distances as the search has them, tables as people write them, faults in words."""

import re
from pathlib import Path

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.calibration import measure
from leitmotion.features import FEATURES, active_weights, extract, weighted
from leitmotion.io import LabelledPair
from leitmotion.similarity import cross_distance, pair_distances, self_distance

ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def session():
    return lm.compose_session(seed=3, rate=30.0)


@pytest.fixture
def folder(session, tmp_path):
    """A folder with two recordings and a table of pairs of both, within and across."""
    lm.write(session.motion[:400], tmp_path / "one.bvh")
    lm.write(session.motion[400:800], tmp_path / "two.bvh")
    table = ["recording_a,frame_a,recording_b,frame_b,alike,person,group,note"]
    table += [f"one.bvh,{10 * k},one.bvh,{10 * k + 1},1,p{k % 4},fit," for k in range(1, 20)]
    table += [f"one.bvh,{10 * k},two.bvh,{390 - 7 * k},0,p{k % 4},fit," for k in range(1, 20)]
    table += [f"two.bvh,{10 * k},two.bvh,{10 * k + 1},yes,q,check," for k in range(1, 9)]
    table += [f"two.bvh,{10 * k},two.bvh,{10 * k + 120},no,q,check," for k in range(1, 9)]
    (tmp_path / "pairs.csv").write_text("\n".join(table) + "\n", encoding="utf-8")
    return tmp_path


def edited(folder: Path, line: int, old: str, new: str) -> Path:
    """The table with one line changed."""
    lines = (folder / "pairs.csv").read_text(encoding="utf-8").splitlines()
    assert old in lines[line - 1]
    lines[line - 1] = lines[line - 1].replace(old, new)
    (folder / "pairs.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return folder / "pairs.csv"


@pytest.mark.parametrize("name", ["posture", "velocity", "joint_angles", "joint_rotations"])
def test_distances_are_those_of_the_matrix(session, name):
    motion = session.motion[:300]
    pairs = [
        LabelledPair(int(a), int(b), True) for a, b in np.random.default_rng(1).integers(0, 300, (40, 2))
    ]
    rows, columns = [pair.frame_a for pair in pairs], [pair.frame_b for pair in pairs]
    features = extract(name, motion)
    for weights, told in (("equal", features), ("active", weighted(features, active_weights(features)))):
        found = measure(pairs, motion, features=name, weights=weights).distances
        assert np.allclose(found, self_distance(told).values[rows, columns], atol=1e-5)


def test_across_recordings_the_weights_are_the_mean_of_both(session):
    a, b = session.motion[:400], session.motion[400:800]
    one, other = extract("posture", a), extract("posture", b)
    mean = (active_weights(one) + active_weights(other)) / 2
    expected = cross_distance(weighted(one, mean), weighted(other, mean)).values[30, 80]
    pair = LabelledPair(30, 80, True, "a", "b")
    assert measure([pair], {"a": a, "b": b}, weights="active").distances == pytest.approx(
        [expected], rel=1e-5
    )


def test_the_sign_of_a_quaternion_is_no_distance(session):
    turns = extract("joint_rotations", session.motion[:50])
    turned = turns.replace(values=-turns.values)
    assert pair_distances(turns, np.arange(50), turned, np.arange(50)).tolist() == [0.0] * 50


def test_joints_that_one_recording_lacks_are_left_out(session):
    whole = lm.embody(session.motion[:100])
    kept = [k for k, role in enumerate(whole.roles) if not role.endswith("wrist")]
    lesser = whole.replace(roles=tuple(whole.roles[k] for k in kept), positions=whole.positions[:, kept])
    pairs = [LabelledPair(10, 80, True, "a", "b")]
    found = measure(pairs, {"a": whole, "b": lesser}).distances
    assert found == pytest.approx(measure(pairs, {"a": lesser, "b": lesser}).distances)


def test_a_table_and_what_it_names(folder):
    found = lm.calibrate(folder / "pairs.csv")
    assert isinstance(found, lm.Calibration)
    assert (found.alike, found.not_alike) == (27, 27)
    assert found.check is None
    kept = lm.calibrate(folder / "pairs.csv", group="fit", check="check")
    assert (kept.alike, kept.not_alike, kept.check.alike, kept.check.not_alike) == (19, 19, 8, 8)
    assert lm.calibrate(folder / "pairs.csv", check="check") == kept  # the rest is calibrated on
    assert kept.check.threshold == kept.threshold
    assert kept.replace(check=None) == lm.calibrate(folder / "pairs.csv", group="fit")


def test_the_check_group_decides_nothing(folder):
    before = lm.calibrate(folder / "pairs.csv", group="fit", check="check")
    text = (folder / "pairs.csv").read_text(encoding="utf-8")
    (folder / "pairs.csv").write_text(text.replace(",yes,", ",0,").replace(",no,", ",1,"), encoding="utf-8")
    after = lm.calibrate(folder / "pairs.csv", group="fit", check="check")
    assert after.replace(check=None) == before.replace(check=None)
    assert after.check.error == pytest.approx(1 - before.check.error)


def test_recordings_may_lie_elsewhere(folder, tmp_path_factory):
    elsewhere = tmp_path_factory.mktemp("tables")
    (elsewhere / "pairs.csv").write_bytes((folder / "pairs.csv").read_bytes())
    assert lm.calibrate(elsewhere / "pairs.csv", folder=folder) == lm.calibrate(folder / "pairs.csv")
    read = {name: lm.read(folder / name) for name in ("one.bvh", "two.bvh")}
    assert lm.calibrate(elsewhere / "pairs.csv", read) == lm.calibrate(folder / "pairs.csv")


def test_pairs_of_one_recording_need_no_name(folder, session):
    (folder / "short.csv").write_text("frame_a;frame_b;alike\n5;6;1\n5;300;0\n", encoding="utf-8-sig")
    by_path = lm.calibrate(folder / "short.csv", folder / "one.bvh")
    assert lm.calibrate(folder / "short.csv", lm.read(folder / "one.bvh")) == by_path
    assert by_path.equal_error_rate == 0.0
    assert lm.calibrate(folder / "short.csv", f"{folder / 'one.bvh'}[0:320]").equal_error_rate == 0.0


@pytest.mark.parametrize(
    ("line", "old", "new", "said"),
    [
        (1, "alike", "same", "pairs.csv, line 1: expected a column alike, found recording_a, frame_a"),
        (1, "recording_b", "other", "pairs.csv, line 1: expected a column recording_b, found"),
        (3, ",1,p", ",maybe,p", "pairs.csv, line 3: expected 1 or 0 under alike, found 'maybe'."),
        (3, "one.bvh,20,", "one.bvh,2.5,", "a whole number from 0 on, under frame_a, found '2.5'"),
        (3, "one.bvh,20,", "one.bvh,-2,", "a whole number from 0 on, under frame_a, found '-2'"),
        (3, "one.bvh,20,", ",20,", "line 3: expected a recording under recording_a, found an empty cell"),
        (3, ",20,", ",400,", "line 3: frame 400 is outside of one.bvh, which has frames 0 to 399."),
        (4, "one.bvh,30,", "three.bvh,30,", "pairs.csv, line 4: There is no file"),
        (4, "one.bvh,30,", "pairs.csv,30,", "pairs.csv, line 4: "),
    ],
)  # fmt: skip
def test_a_bad_table_is_told_in_a_sentence_that_names_the_line(folder, line, old, new, said):
    with pytest.raises(lm.LeitmotionError, match=re.escape(said)) as told:
        lm.calibrate(edited(folder, line, old, new))
    assert "\n" not in str(told.value)


def test_what_cannot_be_calibrated_is_a_sentence(folder, session):
    table = folder / "pairs.csv"
    with pytest.raises(lm.ParameterError, match=r"No pair is of the group 'fitt'\. There are fit, check"):
        lm.calibrate(table, group="fitt")
    with pytest.raises(lm.ParameterError, match=r"No pair is of the group 'chek'"):
        lm.calibrate(table, check="chek")
    with pytest.raises(lm.ParameterError, match="other pairs than those it is from"):
        lm.calibrate(table, group="fit", check="fit")
    with pytest.raises(lm.ParameterError, match="has no option 'feature'"):
        lm.calibrate(table, feature="posture")
    with pytest.raises(lm.ParameterError, match="must be one of equal, active"):
        lm.calibrate(table, weights="heavy")
    with pytest.raises(lm.ParameterError, match=r"the pairs name theirs, such as one\.bvh"):
        lm.calibrate(table, session.motion)
    with pytest.raises(lm.ParameterError, match="The pairs name no recordings"):
        lm.calibrate([LabelledPair(1, 2, True)])
    with pytest.raises(lm.ParameterError, match="'b', which is not among those given"):
        lm.calibrate([LabelledPair(1, 2, True, "a", "b")], {"a": session.motion})
    with pytest.raises(lm.DataError, match="no pairs"):
        lm.calibrate([], session.motion)
    with pytest.raises(lm.DataError, match=r"but the one is alike\. Label some of both"):
        lm.calibrate([LabelledPair(1, 2, True)], session.motion)
    (folder / "none.csv").write_text("frame_a,frame_b,alike\n", encoding="utf-8")
    with pytest.raises(lm.FormatError, match="expected pairs below the names of the columns, found none"):
        lm.calibrate(folder / "none.csv", session.motion)
    with pytest.raises(lm.FormatError, match="There is no file"):
        lm.calibrate(folder / "nowhere.csv")


def test_a_posture_that_is_not_seen_is_told(session):
    body = lm.embody(session.motion[:60])
    positions = body.positions.copy()
    positions[20] = np.nan
    hidden = body.replace(positions=positions)
    with pytest.raises(lm.DataError, match="Pair 1: frame 20 of the recording shows no posture"):
        lm.calibrate([LabelledPair(1, 2, True), LabelledPair(1, 20, False)], hidden)


@pytest.mark.data
def test_the_thresholds_beside_the_features_are_those_of_the_labels(data, monkeypatch):
    monkeypatch.setenv("LEITMOTION_DATA", str(data))
    monkeypatch.syspath_prepend(str(ROOT / "benchmarks"))
    bench = __import__("bench_calibration")
    for name in bench.FEATURES:
        for weights in bench.WEIGHTS:
            pairs, read = bench.labelled()
            found = lm.calibrate(pairs, read, features=name, weights=weights, group="fit")
            assert round(found.threshold, 3) == FEATURES[name].alike[weights], (name, weights)
            assert found.equal_error_rate < 0.25


def test_what_is_no_pair_is_named() -> None:
    motion = lm.compose_session(seed=0, rate=30.0).motion[:60]
    pairs = [lm.io.LabelledPair(1, 2, True), (3, 20, False)]
    with pytest.raises(lm.ParameterError, match=r"Pair 1 should be a LabelledPair, got tuple\. Make each"):
        lm.calibrate(pairs, motion)  # type: ignore[list-item]
