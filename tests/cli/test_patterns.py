"""``leitmotion patterns``: the answer first, then where."""

import csv
import inspect
import io
import json
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import leitmotion as lm
from cli.conftest import Run
from leitmotion.motion import Trajectories


def test_the_answer_comes_first(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh")
    assert told.exit_code == 0
    assert told.stderr == ""
    assert told.stdout.startswith("One movement recurs, four times.\n")
    row = next(line for line in told.stdout.splitlines() if line.startswith("A  "))
    assert row.split()[:4] == ["A", "cyclic", "1", "4"]


def test_plain_output_is_never_wrapped_or_padded(run: Run, made: Path) -> None:
    lines = run("patterns", made / "jacks.bvh").stdout.splitlines()
    assert all(line == line.rstrip() for line in lines)
    assert not any("\x1b" in line for line in lines)


def test_nothing_repeats_is_an_answer(run: Run, made: Path) -> None:
    told = run("patterns", made / "once.bvh")
    assert told.exit_code == 0
    assert told.stdout.startswith("Nothing repeats here.\n")


def test_points_without_roles_say_that_they_were_compared_as_they_stand(run: Run) -> None:
    swing = np.cumsum(np.random.default_rng(4).normal(size=(90, 8, 3)) / 100, axis=0)
    lm.write(lm.Trajectories(tuple(f"m{k}" for k in range(8)), swing, rate=30.0), "unnamed.npz")
    told = run("patterns", "unnamed.npz")
    assert "compared as they stand" in told.stderr
    assert "--map FILE" in told.stderr
    for verb in ("patterns", "report"):
        (warning,) = json.loads(run(verb, "unnamed.npz", "--json").stdout)["warnings"]
        assert "compared as they stand" in warning


def test_stretches_that_were_not_compared_are_told(
    run: Run, made: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from leitmotion.discovery import tracing

    monkeypatch.setattr(tracing, "LIVE", 600)
    told = json.loads(run("patterns", made / "jacks.bvh", "--json").stdout)
    (warning,) = told["warnings"]
    assert warning.startswith("So much recurs that only stretches within 0:0")
    assert told["parameters"]["compared_within_s"] < told["source"][0]["seconds"]


@pytest.mark.parametrize(
    ("limit", "what"),
    [
        ("second_compared_within_s", "stretches of what was left over"),
        ("moves_compared_within_s", "whole movements"),
    ],
)
def test_limits_on_what_was_left_over_are_told(limit: str, what: str) -> None:
    from leitmotion.cli.finding import _not_compared
    from leitmotion.discovery import Patterns

    told = _not_compared(Patterns((), (), 30.0, {limit: 75.0}, ""))
    assert told.startswith(f"So much recurs that only {what}")
    assert "1:15" in told


def test_several_inputs_are_told_apart_and_the_bad_one_is_a_sentence(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh", made / "missing.bvh", made / "once.bvh")
    assert told.exit_code == 1
    assert f"{made / 'jacks.bvh'}\nOne movement recurs" in told.stdout
    assert f"\n\n{made / 'once.bvh'}\nNothing repeats here." in told.stdout
    missing = made / "missing.bvh"
    assert told.stderr == f"{missing}: Error: There is no file {missing}.\n"


def test_json_output_file_is_what_json_prints(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh", "--json", "-o", "found.json")
    assert json.loads(Path("found.json").read_text(encoding="utf-8")) == json.loads(told.stdout)


def test_json_of_several_is_a_list_with_the_failures_in_place(run: Run, made: Path) -> None:
    told = run("patterns", made / "bad.bvh", made / "jacks.bvh", "-o", "found.json")
    assert told.exit_code == 1
    assert [
        "error" in document for document in json.loads(Path("found.json").read_text(encoding="utf-8"))
    ] == [
        True,
        False,
    ]


def test_csv_is_one_table_of_occurrences(run: Run, made: Path) -> None:
    run("patterns", made, "-o", "found.csv")
    rows = list(csv.DictReader(io.StringIO(Path("found.csv").read_text(encoding="utf-8"))))
    assert [row["occurrence"] for row in rows] == ["1", "2", "3", "4"]
    assert {row["pattern"] for row in rows} == {"A"}
    assert all(float(row["stop_s"]) * 30 == pytest.approx(int(row["stop"]), abs=0.01) for row in rows)


def test_a_table_of_nothing_has_its_header(run: Run, made: Path) -> None:
    run("patterns", made / "once.bvh", "-o", "found.csv")
    assert Path("found.csv").read_text(encoding="utf-8").startswith("path,pattern,occurrence,start,stop")


def test_archive_holds_the_patterns(run: Run, made: Path) -> None:
    run("patterns", made / "jacks.bvh", "-o", "found.npz")
    assert lm.load("found.npz") == lm.find_patterns(lm.read(made / "jacks.bvh"))


@pytest.mark.parametrize("ending", [".png", ".svg", ".pdf"])
def test_picture(run: Run, made: Path, ending: str) -> None:
    told = run("patterns", made / "jacks.bvh", "-o", f"found{ending}")
    assert told.exit_code == 0
    signs = {".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}
    assert Path(f"found{ending}").read_bytes().startswith(signs[ending])


@pytest.mark.parametrize(
    ("name", "complaint"),
    [("found.doc", "end it in .json, .csv"), ("found", "end it in .json, .csv"), ("in.bvh", "end it in")],
)
def test_an_unknown_ending_is_wrong_usage_before_any_work(
    run: Run, made: Path, name: str, complaint: str
) -> None:
    told = run("patterns", made / "missing.bvh", "-o", name)
    assert told.exit_code == 2
    assert complaint in " ".join(told.stderr.split())


def test_a_page_or_a_picture_shows_one_recording(run: Run, made: Path) -> None:
    told = run("patterns", made, "-o", "all.png")
    assert told.exit_code == 2
    assert "leitmotion report INPUT... -o FOLDER" in told.stderr


def test_an_input_is_never_written_over(run: Run) -> None:
    Path("found.json").write_text("{}", encoding="utf-8")
    told = run("patterns", "found.json", "-o", "found.json")
    assert told.exit_code == 2
    assert "inputs are never written over" in told.stderr
    assert Path("found.json").read_text(encoding="utf-8") == "{}"


def test_joints_may_be_chosen_and_excluded(run: Run, made: Path) -> None:
    def compared(*options: str) -> list[str]:
        document = json.loads(run("patterns", made / "jacks.bvh", "--json", *options).stdout)
        features: list[str] = document["parameters"]["features"]
        return features

    assert compared("--joints", "head,left_knee", "--joints", "neck") == ["neck", "head", "left_knee"]
    assert set(compared("--joints", "left_*", "--exclude", "left_t*")) >= {"left_hip", "left_wrist"}
    assert "left_toe" not in compared("--joints", "left_*", "--exclude", "left_t*")
    assert "head" not in compared("--exclude", "head")


def test_an_unknown_joint_is_told_with_those_there_are(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh", "--joints", "tail")
    assert told.exit_code == 1
    assert "no joint 'tail'" in told.stderr
    assert "left_knee" in told.stderr


@pytest.mark.parametrize("typed", ["hed", "Head"])
def test_a_joint_nearly_right_is_told_which_is_meant(run: Run, made: Path, typed: str) -> None:
    assert "Did you mean head? It has" in run("patterns", made / "jacks.bvh", "--joints", typed).stderr


@pytest.mark.parametrize("option", ["--joints", "--exclude"])
@pytest.mark.parametrize("typed", ["", ",", " , "])
def test_a_list_without_a_name_is_wrong_usage(run: Run, made: Path, option: str, typed: str) -> None:
    told = run("patterns", made / "jacks.bvh", "--joints", "head", option, typed)
    assert told.exit_code == 2
    assert f"Invalid value for '{option}': {typed!r} names no role." in told.stderr


def test_a_map_file_names_the_roles(run: Run, made: Path) -> None:
    Path("map.json").write_text("[]", encoding="utf-8")
    told = run("patterns", made / "jacks.bvh", "--map", "map.json")
    assert told.exit_code == 2
    assert "left_knee" in told.stderr


def test_stillness_and_shortest_length_are_options(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh", "--json", "--stillness", "--min-duration", "0.8")
    parameters = json.loads(told.stdout)["parameters"]
    assert parameters["stillness"] is True
    assert parameters["min_duration_s"] == 0.8


@pytest.mark.parametrize(
    "options",
    [
        ["--method", "tang2008", "--stillness"],
        ["--min-duration", "0"],
        ["--rate", "-30"],
        ["--rate", "nan"],
        ["--rate", "inf"],
        ["--min-duration", "nan"],
        ["--unit", "foo"],
        ["--unit", "-1"],
        ["--up", "q"],
        ["--skeleton", "nowhere.asf"],
        ["--method", "magic"],
    ],
)
def test_options_that_cannot_be_are_wrong_usage(run: Run, made: Path, options: list[str]) -> None:
    told = run("patterns", made / "jacks.bvh", *options)
    assert told.exit_code == 2
    assert told.stdout == ""
    assert "--" in told.stderr.partition("Error: ")[2]


def test_reading_options_stand_in_the_parameters(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh", "--json", "--rate", "60", "--unit", "m")
    document = json.loads(told.stdout)
    assert document["parameters"]["reading"] == {"unit": "m", "rate": 60.0}
    assert document["source"][0]["rate"] == 60.0


def test_an_axis_may_bear_either_sign(run: Run, made: Path) -> None:
    for typed, up in (("+y", "y"), ("Y", "y"), ("-z", "-z")):
        document = json.loads(run("patterns", made / "jacks.bvh", "--json", "--up", typed).stdout)
        assert document["parameters"]["reading"] == {"up": up}


def test_help_lists_every_axis_that_is_taken(run: Run) -> None:
    assert "points up: x, y, z, -x, -y or -z," in " ".join(run("patterns", "--help").stdout.split())


def test_an_axis_that_a_plane_has_not_is_told_in_plain_words(run: Run) -> None:
    rows = "".join(f"{frame / 30:.4f},{frame},{frame},1,2\n" for frame in range(90))
    Path("flat.csv").write_text(f"time,head_x,head_y,hip_x,hip_y\n{rows}", encoding="utf-8")
    told = run("patterns", "flat.csv", "--up", "x")
    assert told.exit_code == 1
    assert told.stderr == "Error: The vertical of points in a plane is y or -y, got 'x'.\n"


@pytest.mark.parametrize("verb", ["patterns", "report"])
@pytest.mark.parametrize(
    ("options", "note"),
    [
        (["--unit", "mm"], "people measure 0.5 to 2.5 m"),
        (["--up", "-y"], "The head is not above the feet in 100% of the frames"),
    ],
)
def test_a_unit_or_a_vertical_that_makes_no_person_is_noted(
    run: Run, made: Path, verb: str, options: list[str], note: str
) -> None:
    (line,) = [line for line in run(verb, made / "jacks.bvh", *options).stderr.splitlines() if note in line]
    assert line.startswith("Note: ")
    (document,) = [json.loads(run(verb, made / "jacks.bvh", *options, "--json").stdout)]
    assert any(note in warning for warning in document["warnings"])


@pytest.mark.parametrize("verb", ["info", "patterns", "report"])
def test_a_skeleton_for_a_file_that_has_its_own_is_noted(run: Run, made: Path, verb: str) -> None:
    Path("other.asf").touch()
    told = run(verb, made / "jacks.bvh", "--skeleton", "other.asf")
    assert told.exit_code == 0
    assert "Note: --skeleton was not used" in told.stderr


def test_each_line_about_one_of_several_begins_with_its_path(run: Run, made: Path) -> None:
    Path("in").mkdir()
    for name in ("bad.bvh", "jacks.bvh"):
        Path("in", name).write_bytes((made / name).read_bytes())
    Path("in/labels.csv").write_text("start_s,stop_s,label\n0.5,1.0,jump\n", encoding="utf-8")
    told = run("patterns", "in", "--unit", "mm")
    assert [line.partition(": ")[0] for line in told.stderr.splitlines()] == [
        str(Path("in", name)) for name in ("bad.bvh", "jacks.bvh", "labels.csv")
    ]
    error, note, left_out = (line.split(": ", 1)[1] for line in told.stderr.splitlines())
    assert error.startswith("Error: line 4: expected")
    assert note.startswith("Note: The body measures")
    assert left_out.startswith("Left out, as no recording: ")


@pytest.mark.parametrize("verb", ["info", "patterns", "report"])
@pytest.mark.parametrize("place", ["taken/found", "taken/new/found", "/proc/found"])
def test_a_place_that_takes_no_file_is_wrong_usage_before_any_work(run: Run, verb: str, place: str) -> None:
    if place.startswith("/proc") and not Path("/proc/self").exists():
        pytest.skip("there is no /proc here")
    Path("taken").touch()
    told = run(verb, "missing.bvh", "-o", f"{place}.{'html' if verb == 'report' else 'json'}")
    assert told.exit_code == 2
    why = "takes no such file" if place.startswith("/proc") else "taken is a file, not a folder"
    assert "cannot be written: " in told.stderr
    assert why in " ".join(told.stderr.split())


def test_a_name_that_is_too_long_is_wrong_usage(run: Run) -> None:
    told = run("patterns", "missing.bvh", "-o", f"{'x' * 260}.csv")
    assert told.exit_code == 2
    assert "cannot be written: . takes no such file" in told.stderr


def test_the_one_recording_of_a_folder_is_named(run: Run, made: Path) -> None:
    for name in ("jacks.bvh", "bad.bvh"):
        Path(name).mkdir()
        Path(name, "in.bvh").write_bytes((made / name).read_bytes())
    assert run("patterns", "jacks.bvh").stdout.startswith(f"{Path('jacks.bvh', 'in.bvh')}\nOne movement")
    assert run("patterns", "bad.bvh").stderr.startswith(f"{Path('bad.bvh', 'in.bvh')}: Error: line 4")


def test_looking_whether_a_place_takes_a_file_leaves_nothing_there(run: Run) -> None:
    assert run("patterns", "missing.bvh", "-o", "deep/found.npz").exit_code == 1
    assert not list(Path().iterdir())


def test_an_eaf_holds_the_occurrences_in_the_time_of_the_whole_file(run: Run, made: Path) -> None:
    window = f"{made / 'jacks.bvh'}[1s:]"
    told = run("patterns", window, "--json", "-o", "found.eaf")
    (source,) = json.loads(told.stdout)["source"]
    found = lm.read_annotations("found.eaf", rate=source["rate"])
    expected = [
        (stretch["start"] + round(source["rate"]), stretch["stop"] + round(source["rate"]), pattern["id"])
        for pattern in json.loads(told.stdout)["result"]["patterns"]
        for stretch in pattern["occurrences"]
    ]
    assert len(expected) > 1
    assert [span[:3] for span in found] == sorted(expected)
    assert run("report", window, "--labels", "found.eaf").exit_code == 0
    two = run("patterns", made / "jacks.bvh", made / "once.bvh", "-o", "all.eaf")
    assert two.exit_code == 2
    assert "shows one recording" in two.stderr


def test_nothing_found_is_an_empty_eaf(run: Run, made: Path) -> None:
    assert run("patterns", made / "once.bvh", "-o", "none.eaf").exit_code == 0
    assert len(lm.read_annotations("none.eaf", rate=30)) == 0


def test_what_may_have_been_missed_is_told_when_asked(run: Run, made: Path) -> None:
    options = (made / "jacks.bvh", "--min-duration", "60")  # nothing is that long, so that all is left over
    assert "missed" not in run("patterns", *options).stdout
    told = run("patterns", *options, "--residual")
    assert told.exit_code == 0
    lines = told.stdout.splitlines()
    head = next(k for k, line in enumerate(lines) if "may have been missed" in line)
    assert re.fullmatch(
        r"  \d+\.\d–\d+\.\d s and \d+\.\d–\d+\.\d s, correlation (0\.\d\d|1\.00)", lines[head + 1]
    )
    assert len(lines) - head - 1 <= 10
    (document,) = [json.loads(run("patterns", *options, "--residual", "--json").stdout)]
    residual = document["result"]["residual"]
    recording = lm.read(made / "jacks.bvh")
    expected = lm.search_residual(recording, lm.find_patterns(recording, min_duration_s=60.0))
    assert [(one["a"]["start"], one["b"]["stop"]) for one in residual["candidates"]] == [
        (one.a[0], one.b[1]) for one in expected
    ]
    assert [(one["start"], one["stop"]) for one in residual["left_over"]] == [(0, len(recording))]


def test_a_file_that_does_not_hold_what_may_have_been_missed_is_named(run: Run, made: Path) -> None:
    options = ("patterns", made / "jacks.bvh", "--min-duration", "60", "--residual", "-o")
    told = "does not hold what may have been missed; write a .csv or .json to keep that."
    for name in ("missed.html", "missed.eaf"):
        assert f"Note: {name} {told}" in run(*options, name).stderr
    assert told not in run(*options, "missed.json").stderr
    assert told not in run(*options[:-2], "-o", "found.html").stderr


def test_who_searches_one_repetition_a_file_is_told_of_across(run: Run, made: Path) -> None:
    once, jacks = made / "once.bvh", made / "jacks.bvh"
    hint = "Note: Each recording was searched for itself; --across tells what they share.\n"
    assert run("patterns", once, f"{once}[1s:3s]").stderr.endswith(hint)
    for others in ((once,), (once, jacks), (once, once, "--quiet"), (once, once, "--json")):
        assert "--across" not in run("patterns", *others).stderr


def test_nothing_missed_is_an_answer(run: Run) -> None:
    still = np.zeros((90, 15, 3)) + np.arange(15)[:, None] / 10
    lm.write(lm.Trajectories(tuple(f"m{k}" for k in range(15)), still, rate=30.0), "still.npz")
    told = run("patterns", "still.npz", "--residual")
    assert told.stdout.endswith(
        "Of 3.0 s in 1 stretch left over by the patterns, nothing moves like anything else there.\n"
    )


def test_features_that_a_recording_does_not_have_are_refused_in_words(run: Run, made: Path) -> None:
    told = run("patterns", made / "jacks.bvh", "--features", "marker_posture")
    assert told.stderr == (
        "Error: The feature marker_posture compares the markers of a recording, and this is a skeleton. Compare one of "
        "posture, velocity, joint_angles, limb_directions, joint_rotations.\n"
    )


@pytest.mark.parametrize("features", ["joint_angles", "marker_posture"])
def test_of_many_points_without_a_role_the_first_are_named(run: Run, features: str) -> None:
    rng = np.random.default_rng(0)
    points = Trajectories([f"P{k}" for k in range(40)], rng.normal(size=(90, 40, 3)), rate=30.0)
    lm.write(points, "cloud.csv")
    told = run("patterns", "cloud.csv", "--features", features)
    assert told.exit_code == 1
    assert "P7 and 32 more. " in told.stderr
    assert len(told.stderr) < 300
    assert "P9" not in told.stderr


@pytest.mark.parametrize(
    ("option", "value", "remark"),
    [
        (
            "--max-distance",
            "100",
            "100 is far above the default, 0.054 body sizes: nearly all moments count as alike",
        ),
        (
            "--max-distance",
            "0.0001",
            "0.0001 is far below the default, 0.054 body sizes: hardly any two moments",
        ),
        ("--max-distance", "0.08", ""),
        ("--threshold", "5", "5 is far above the default, 0.26 of the largest distance"),
        ("--threshold", "0.2", ""),
    ],
)
def test_what_is_far_from_usual_is_remarked(
    run: Run, made: Path, option: str, value: str, remark: str
) -> None:
    method = ("--method", "tang2008") if option == "--threshold" else ()
    told = run("patterns", made / "jacks.bvh", option, value, *method, "--json")
    warnings = json.loads(told.stdout)["warnings"]
    assert any(remark in each for each in warnings) if remark else warnings == []


def test_the_help_names_the_defaults_that_are(run: Run) -> None:
    from leitmotion.discovery.across import DIRECTIONS, PLACES
    from leitmotion.discovery.recurrence import find_recurrences
    from leitmotion.discovery.tang2008 import find_patterns_tang2008
    from leitmotion.features import FEATURES

    told = " ".join(run("patterns", "--help").stdout.split())
    for name, feature in FEATURES.items():
        if feature.alike:
            measured = feature.measured_in
            assert f"{feature.alike['equal']:g} {measured} of {name}" in told
    active = ", ".join(f"{feature.alike['active']:g}" for feature in FEATURES.values() if feature.alike)
    assert f"with --weights active {active}" in told
    across = f"{DIRECTIONS.max_distance:g} of limb_directions, {PLACES.max_distance:g} of posture"
    assert f"with --across {across}" in told
    assert f"largest distance; {_default(find_patterns_tang2008, 'threshold'):g} by default" in told
    assert f"stretch that counts; {_default(find_recurrences, 'min_duration_s'):g} by default" in told


def _default(function: Callable[..., object], name: str) -> float:
    return float(inspect.signature(function).parameters[name].default)
