"""The façade of the evaluation: files and values give the same figures, and what does not fit is told."""

import pytest

import leitmotion as lm
from leitmotion.datasets import Action, compose


@pytest.fixture(scope="module")
def session():
    return compose(
        [Action("squat", 3), Action("still"), Action("jumping jack", 4)], seed=1, rate=30.0, name="moves"
    )


@pytest.fixture(scope="module")
def found(session):
    return lm.find_patterns(session.motion)


def test_a_value_and_its_files_give_the_same(session, found, tmp_path):
    from leitmotion.io import write_annotations

    truth = write_annotations(session.stretches, tmp_path / "truth.csv")
    lm.save(found, tmp_path / "found.npz")
    scores = lm.evaluate("patterns", session.stretches, found, ignore=["still"])
    assert lm.evaluate("patterns", truth, found, ignore=["still"]) == scores
    assert lm.evaluate("patterns", truth, tmp_path / "found.npz", ignore=["still"]) == scores


def test_what_was_composed_is_found_and_right(session, found):
    runs = session.stretches
    cycles = [[3 if label == "squat" else 4] * 3 if label != "still" else [1] * 3 for label in runs.labels]
    labels = tuple("" if label == "still" else label for label in runs.labels)
    truth = lm.PatternTruth(runs.replace(labels=labels), cycles=cycles)
    scores = lm.evaluate("patterns", truth, found)
    assert set(truth.recurring) == {"squat", "jumping jack"}
    assert (scores.type_one, scores.type_two, scores.counts_within) == (0, 0, 1)


def test_a_task_or_a_label_that_is_none_is_refused(session, found):
    with pytest.raises(lm.ParameterError, match="one of patterns, got 'dance'"):
        lm.evaluate("dance", session.stretches, found)
    with pytest.raises(lm.ParameterError, match="no label 'rest' to ignore"):
        lm.evaluate("patterns", session.stretches, found, ignore=["rest"])
    with pytest.raises(lm.ParameterError, match="at 60 Hz"):
        lm.evaluate("patterns", session.stretches.replace(rate=60.0), found)


def test_a_truth_that_cannot_be_of_this_recording_is_refused(found, tmp_path):
    from leitmotion.evaluating import read_truth

    (tmp_path / "long.csv").write_text("start_s,stop_s,label\n0,60,walk\n", encoding="utf-8")
    with pytest.raises(lm.DataError, match=r"reaches to 60\.00 s, but the recording lasts 10\.00 s"):
        read_truth(tmp_path / "long.csv", rate=30, frames=300)
    (tmp_path / "bare.csv").write_text("start_s,stop_s,label\n0,6,\n", encoding="utf-8")
    with pytest.raises(lm.DataError, match="holds no labelled stretch"):
        read_truth(tmp_path / "bare.csv", rate=30)
    (tmp_path / "two.csv").write_text("start_s,stop_s,label\n0,6,a\n5,9,b\n", encoding="utf-8")
    with pytest.raises(lm.DataError, match=r"two\.csv: .* in order without overlap"):
        read_truth(tmp_path / "two.csv", rate=30)


@pytest.mark.data
def test_labels_of_tenths_of_a_second_reach_to_the_end_of_the_recording(data):
    from leitmotion.evaluating import read_truth

    truth = read_truth(data / "mocap6" / "13_31.txt", rate=120, frames=3017)
    assert truth.runs.stops[-1] == 3017
    assert truth.runs.labels[0] == "Twist"
    assert (truth.which_run(3017)[366:426] == -1).all()
    assert truth.uncertain == ("KneeRaise", "ToeTouchOneHand", "Jog", "ArmCircle")
