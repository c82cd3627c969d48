"""The façade: what a person types, and that importing it loads nothing."""

import ast
import subprocess
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest

import leitmotion as lm
from leitmotion import api

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "src" / "leitmotion" / "__init__.py"


@pytest.fixture(scope="module")
def session() -> object:
    return lm.compose_session(seed=3, rate=30.0)


def test_version_is_that_of_the_project() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    assert lm.__version__ == project["project"]["version"]


def test_every_promised_name_is_there_and_the_same_as_behind_the_facade() -> None:
    assert lm.__all__ == sorted(lm.__all__)
    assert lm.__all__ == api.__all__
    for name in lm.__all__:
        assert getattr(lm, name) is getattr(api, name)
    assert set(lm.__all__) < set(dir(lm))


def test_type_checkers_see_what_is_promised() -> None:
    guarded = next(
        node for node in ast.parse(SOURCE.read_text(encoding="utf-8")).body if isinstance(node, ast.If)
    )
    seen = [alias.name for node in guarded.body if isinstance(node, ast.ImportFrom) for alias in node.names]
    assert sorted(seen) == lm.__all__


def test_rooms_are_reached_by_name() -> None:
    assert lm.io.read is lm.read
    assert lm.body.embody is lm.embody


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'find_everything'"):
        lm.find_everything  # noqa: B018


def test_import_loads_nothing_heavy() -> None:
    code = "import leitmotion, sys; print(*sorted({name.partition('.')[0] for name in sys.modules}))"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    assert not set(ran.stdout.split()) & {"matplotlib", "numba", "numpy", "rich", "scipy", "sklearn", "click"}


def test_the_functions_of_the_facade_load_neither_compiler_nor_plots() -> None:
    code = "import leitmotion.api, sys; print(*sorted({name.partition('.')[0] for name in sys.modules}))"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    assert not set(ran.stdout.split()) & {"matplotlib", "numba", "rich", "scipy", "sklearn", "click"}


def test_the_three_lines_of_the_readme(session: lm.datasets.Session, tmp_path: Path) -> None:
    lm.write(session.motion, tmp_path / "dance.bvh")
    motion = lm.read(tmp_path / "dance.bvh")
    patterns = lm.find_patterns(motion)
    assert len(patterns) >= 4
    page = lm.report(motion, tmp_path / "dance.html")
    assert page == tmp_path / "dance.html"
    assert page.read_text(encoding="utf-8").lower().startswith("<!doctype html>")


@pytest.mark.parametrize(
    ("name", "page"),
    [
        ("../a/b", "b.html"),
        ("/tmp/dance", "dance.html"),
        ("..\\..\\dance", "dance.html"),
        ("..", "recording.html"),
        ("a/", "recording.html"),
        ("", "recording.html"),
        (".hidden", "hidden.html"),
        ("one\x00two\nthree", "onetwothree.html"),
        ("86_01.v2", "86_01.v2.html"),
        ("é" * 400, "é" * 100 + ".html"),
    ],
)
def test_a_recording_cannot_say_where_its_page_goes(
    session: lm.datasets.Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, page: str
) -> None:
    inside = tmp_path / "in" / "side"
    inside.mkdir(parents=True)
    monkeypatch.chdir(inside)
    none = lm.Patterns((), (), rate=30.0, parameters={})
    assert lm.report(session.motion[:30].replace(name=name), patterns=none) == Path(page)
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == [inside / page]


def test_a_page_replaces_neither_recordings_nor_somebody_elses_pages(
    session: lm.datasets.Session, tmp_path: Path
) -> None:
    piece, none = session.motion[:30], lm.Patterns((), (), rate=30.0, parameters={})
    recording, foreign = tmp_path / "victim.bvh", tmp_path / "thesis.html"
    lm.write(piece, recording)
    before = recording.read_bytes()
    foreign.write_text("<!doctype html><title>My thesis</title>", encoding="utf-8")
    with pytest.raises(lm.ParameterError, match=r"ends in \.html, got 'victim\.bvh'"):
        lm.report(piece, recording, patterns=none)
    with pytest.raises(lm.ParameterError, match="Leitmotion did not write it"):
        lm.report(piece, foreign, patterns=none)
    assert recording.read_bytes() == before
    assert "My thesis" in foreign.read_text(encoding="utf-8")
    for _ in range(2):
        lm.report(piece, foreign, patterns=none, force=True)
        lm.report(piece, foreign, patterns=none)


def test_a_report_is_of_its_own_patterns_and_labels(session: lm.datasets.Session, tmp_path: Path) -> None:
    piece, page = session.motion[:120], tmp_path / "page.html"
    whole = lm.find_patterns(session.motion)
    with pytest.raises(lm.ParameterError, match=r"The patterns reach to .* the recording lasts 4\.00 s"):
        lm.report(piece, page, patterns=whole)
    with pytest.raises(lm.ParameterError, match="at 60 Hz, this one is at 30 Hz"):
        lm.report(piece, page, patterns=lm.Patterns((), (), rate=60.0, parameters={}))
    with pytest.raises(lm.ParameterError, match=r"The labels reach to 900\.00 s"):
        lm.report(piece, page, labels=lm.Segmentation([60], [27000], ("late",), rate=30.0))
    with pytest.raises(lm.ParameterError, match="must be a Segmentation, got str"):
        lm.report(piece, page, labels="labels.csv")  # type: ignore[arg-type]
    with pytest.raises(lm.ParameterError, match="'stillness' steers a search"):
        lm.report(piece, page, patterns=lm.Patterns((), (), rate=30.0, parameters={}), stillness=True)
    assert not page.exists()


def test_a_report_takes_the_options_of_a_search(session: lm.datasets.Session, tmp_path: Path) -> None:
    page = lm.report(session.motion[:120], tmp_path / "page.html", min_duration_s=1.25, stillness=True)
    assert "at least 1.25 s" in page.read_text(encoding="utf-8")
    with pytest.raises(lm.ParameterError, match="no option 'min_length'"):
        lm.report(session.motion[:120], tmp_path / "page.html", min_length=3)


def test_joints_are_named_as_on_the_command_line(session: lm.datasets.Session) -> None:
    piece = session.motion[:300]
    assert lm.find_patterns(piece, joints="head, left_*") == lm.find_patterns(
        piece, joints=["head", "left_*"]
    )
    for wrong, said in (
        ([], "No joint is named"),
        (3, "given by their names"),
        ([3], "given by their names"),
    ):
        with pytest.raises(lm.ParameterError, match=said):
            lm.find_patterns(piece, joints=wrong)  # type: ignore[arg-type]
    with pytest.raises(lm.ParameterError, match=r"Did you mean head\?"):
        lm.find_patterns(piece, joints="hed")


def test_what_is_compared_has_a_name(session: lm.datasets.Session, tmp_path: Path) -> None:
    piece = session.motion[300:700]
    assert lm.find_patterns(piece, features="posture") == lm.find_patterns(piece)
    with pytest.raises(
        lm.ParameterError, match=r"never measured for marker_posture\. Say it with --max-distance"
    ):
        lm.find_patterns(marker_file(), features="marker_posture")
    with pytest.raises(lm.ParameterError, match="Did you mean velocity"):
        lm.find_patterns(piece, features="velocities")
    with pytest.raises(
        lm.ParameterError, match="compares the markers of a recording, and this is a skeleton"
    ):
        lm.find_patterns(piece, features="marker_posture", method="tang2008")
    with pytest.raises(lm.ParameterError, match="must be one of equal, active, got 'heavy'"):
        lm.find_patterns(piece, weights="heavy")
    with pytest.raises(lm.ParameterError, match="max_distance must be a number"):
        lm.find_patterns(piece, features="velocity", max_distance="far")
    by_angles = lm.find_patterns(piece, features="joint_angles", weights="active", joints="left_*,pelvis")
    assert by_angles.parameters["max_distance"] == lm.features.FEATURES["joint_angles"].alike["active"]
    assert by_angles.parameters["weights"] == "active"
    assert len(by_angles.parameters["features"]) == 5  # type: ignore[arg-type]
    assert [p.cycles for p in by_angles.patterns] == [p.cycles for p in lm.find_patterns(piece).patterns]
    found = lm.find_patterns(piece, features="joint_rotations", max_distance=0.2, joints="left_*")
    assert found.parameters["feature"] == "joint_rotations"
    assert found.parameters["min_amplitude"] == pytest.approx(0.04)
    assert {name[:5] for name in found.parameters["features"]} == {"left_"}  # type: ignore[attr-defined]
    page = lm.report(piece, tmp_path / "page.html", patterns=found)
    assert '"unit":"°"' in page.read_text(encoding="utf-8")


def test_paper_p_may_compare_the_recordings_own_markers() -> None:
    markers = marker_file()
    found = lm.find_patterns(markers, method="tang2008", features="marker_posture", exclude="LFHD,RFHD")
    assert found.parameters["features"] == list(markers.names[2:])
    assert found.parameters["invariant_to"] == ["place", "yaw"]


def test_what_is_left_over_is_compared_by_what_was_searched(session: lm.datasets.Session) -> None:
    piece = session.motion[:600]
    for options in ({}, {"joints": "left_*"}, {"features": "velocity", "max_distance": 1.0}):
        found = lm.find_patterns(piece, **options)  # type: ignore[arg-type]
        name = str(found.parameters["feature"])
        described = lm.features.extract(name, lm.embody(piece), roles=found.parameters["features"])
        assert lm.search_residual(piece, found) == lm.discovery.search_residual(described, found)
    assert lm.search_residual(lm.embody(piece), found) == lm.search_residual(piece, found)
    with pytest.raises(lm.ParameterError, match="The patterns reach to frame"):
        lm.search_residual(piece[:90], lm.find_patterns(piece))


def test_markers_of_any_name_are_searched_for_what_was_left_over() -> None:
    markers = marker_file()
    odd = markers.replace(
        names=tuple(f"{name}[*]" if k < 2 else name for k, name in enumerate(markers.names))
    )
    found = lm.find_patterns(odd, method="tang2008", features="marker_posture")
    assert "LFHD[*]" in found.parameters["features"]  # type: ignore[operator]
    assert len(lm.search_residual(odd, found).left_over)


def test_a_body_is_as_good_as_its_recording(session: lm.datasets.Session) -> None:
    piece = session.motion[:600]
    assert lm.find_patterns(lm.embody(piece)) == lm.find_patterns(piece)


def test_a_map_may_be_written_as_names(session: lm.datasets.Session) -> None:
    piece = session.motion[300:700]
    found = lm.find_roles(piece)
    entries = {role: list(members) for role, members in zip(found.roles, found.members, strict=True)}
    assert lm.find_patterns(piece, body_map=entries) == lm.find_patterns(piece, body_map=found)


def test_options_of_the_method_are_passed_and_unknown_ones_refused(session: lm.datasets.Session) -> None:
    found = lm.find_patterns(session.motion[:300], min_duration_s=0.7)
    assert found.parameters["min_duration_s"] == 0.7
    with pytest.raises(lm.ParameterError, match="no option 'min_length'"):
        lm.find_patterns(session.motion[:300], min_length=3)


def test_a_path_in_place_of_a_recording_is_explained() -> None:
    with pytest.raises(lm.ParameterError, match=r"A recording was expected, got str\. Read the file first"):
        lm.find_patterns("dance.bvh")  # type: ignore[arg-type]


def test_a_role_that_this_body_lacks_may_be_excluded_but_not_compared(session: lm.datasets.Session) -> None:
    piece = session.motion[:300]
    absent = next(role for role in lm.body.ROLES if role not in lm.embody(piece).roles)
    assert lm.find_patterns(piece, exclude=absent) == lm.find_patterns(piece)
    with pytest.raises(lm.ParameterError, match=f"no joint '{absent}'"):
        lm.find_patterns(piece, joints=absent)
    with pytest.raises(lm.ParameterError, match="no joint 'tail'"):
        lm.find_patterns(piece, exclude=["head", "tail"])


def test_excluding_everything_is_refused(session: lm.datasets.Session) -> None:
    with pytest.raises(lm.ParameterError, match="No joint is left"):
        lm.find_patterns(session.motion[:300], exclude="*")


def test_a_report_of_a_long_recording_keeps_its_matrix_within_bounds() -> None:
    minutes = lm.features.FeatureSequence(np.zeros((120 * 600, 3)), ("head",), rate=120.0, width=3)
    thinned = api._thinned(minutes)
    assert len(thinned) <= api.MOST_MOMENTS
    assert thinned.rate * 4 % 1 == 0


def marker_file(**changes: object) -> lm.Trajectories:
    """Standing markers of one second, with faults."""
    names = ("LFHD", "RFHD", "LSHO", "RSHO", "LKNE", "RKNE", "LANK", "RANK", "LASI", "RASI", "LPSI", "RPSI")
    places = np.array(
        [[0.1, 1.7, 0.1], [0.2, 1.4, 0], [0.1, 0.5, 0], [0.1, 0.1, 0], [0.1, 1.0, 0.1], [0.1, 1.0, -0.1]]
    )
    both = np.repeat(places, 2, axis=0)
    both[1::2, 0] *= -1
    sway = 0.01 * np.sin(np.arange(120) / 7)[:, None, None]
    return lm.Trajectories(names, both[None] + sway, rate=100.0, name="markers").replace(**changes)  # type: ignore[no-any-return, attr-defined]


def problems(recording: lm.Trajectories) -> dict[str, str]:
    return {problem.what: problem.message for problem in lm.info(recording).problems}


def test_info_finds_no_fault_in_the_practice_session(session: lm.datasets.Session) -> None:
    told = lm.info(session.motion)
    assert told.problems == ()
    assert told.kind == "skeleton"
    assert told.people == (session.motion.name,)
    assert told.duration == session.motion.duration


def test_info_counts_gaps() -> None:
    positions = marker_file().positions.copy()
    positions[20:45, 3] = np.nan
    positions[:, 5] = np.nan
    told = problems(marker_file(positions=positions))
    assert "RKNE is never seen" in told["gaps"]
    assert "1 of 12 points have gaps, the longest 25 frames (0.25 s, RSHO)" in told["gaps"]


def test_info_counts_frames_that_repeat() -> None:
    positions = marker_file().positions.copy()
    positions[51:61] = positions[50]
    positions[80:100] = np.nan
    assert (
        "10 of 120 frames repeat the one before exactly; the longest such hold is 10 frames"
        in problems(marker_file(positions=positions))["duplicates"]
    )


def test_info_notices_a_size_that_no_person_has() -> None:
    whole = lm.compose_session(seed=3, rate=30.0).motion[:60]
    shrunk = whole.skeleton.replace(offsets=whole.skeleton.offsets / 50)
    tiny = whole.replace(skeleton=shrunk, local_positions=whole.local_positions / 50)
    assert "people measure 0.5 to 2.5 m" in {p.what: p.message for p in lm.info(tiny).problems}["size"]


def test_info_notices_a_person_upside_down() -> None:
    whole = lm.compose_session(seed=3, rate=30.0).motion[:60]
    body = lm.embody(whole)
    flipped = lm.Trajectories(body.roles, body.positions * [1, -1, 1], rate=30.0, kind="joint")
    assert "The head is not above the feet in 100% of the frames" in problems(flipped)["up"]


def test_info_tells_whether_left_is_left() -> None:
    whole = lm.compose_session(seed=3, rate=30.0).motion[:60]
    told, swapped = (
        lm.info(whole, body_map=roles)
        for roles in (None, lm.body.map_to_entries(lm.body.swap_sides(lm.find_roles(whole))))
    )
    assert (told.findings["handedness"].value, swapped.findings["handedness"].value) == ("right", "left")
    assert "sides" not in {problem.what for problem in told.problems}
    message = {problem.what: problem.message for problem in swapped.problems}["sides"]
    assert "with the sides as called the foot on the ground points backwards" in message


def test_info_says_nothing_of_sides_that_cannot_be_told() -> None:
    told = lm.info(marker_file())
    assert "handedness" not in told.findings
    assert "sides" not in {problem.what for problem in told.problems}


def test_info_notices_arms_on_the_wrong_side() -> None:
    names = tuple({"LSHO": "RSHO", "RSHO": "LSHO"}.get(name, name) for name in marker_file().names)
    assert "hips and shoulders disagree" in problems(marker_file(names=names))["sides"]


def test_info_notices_a_jump_after_the_first_frame() -> None:
    positions = marker_file().positions.copy()
    positions[0, :, 2] += 3.0
    (jump,) = [
        problem for problem in lm.info(marker_file(positions=positions)).problems if problem.what == "jumps"
    ]
    assert "The first frame is nowhere near the second" in jump.message
    assert "[1:]" in jump.remedy


def test_info_counts_jumps() -> None:
    positions = marker_file().positions.copy()
    positions[40:60, 4] += 1.0
    assert "2 times, first after frame 39 (0.39 s)" in problems(marker_file(positions=positions))["jumps"]


def test_info_names_what_it_cannot_tell() -> None:
    told = lm.info(marker_file(names=tuple(f"m{k}" for k in range(12))))
    assert told.findings["facing"].value is None
    assert told.problems[0].what == "roles"
    assert "--map" in told.problems[0].remedy


def test_who_faces_ahead_has_a_facing_and_who_has_no_roles_has_none() -> None:
    ahead = marker_file()
    unnamed = ahead.replace(names=tuple(f"m{k}" for k in range(12)))
    flat = ahead.replace(positions=ahead.positions[..., :2], unit="px")
    for recording, facing in ((ahead, 0.0), (unnamed, None), (flat, None)):
        body = lm.embody(recording)
        assert not body.facing.any()
        assert lm.info(recording).findings["facing"].value == facing
        assert body.facing_told is (facing is not None)
        assert ("yaw" in lm.features.posture(body).invariant_to) is body.facing_told
        assert ("yaw" in lm.features.velocity(body).invariant_to) is body.facing_told


def test_info_describes_points_that_tell_no_size() -> None:
    for positions in (np.full((60, 2, 3), np.nan), np.zeros((60, 2, 3))):
        told = lm.info(lm.Trajectories(("a", "b"), positions, rate=30.0))
        assert (told.names, told.frames, told.findings["size"].value) == (("a", "b"), 60, None)
        assert "size of the body cannot be told" in told.problems[0].message


def test_info_of_something_else_is_explained() -> None:
    with pytest.raises(lm.ParameterError, match="A file or a recording was expected, got int"):
        lm.info(2)  # type: ignore[arg-type]


def test_info_says_when_it_is_too_short() -> None:
    assert "too short" in problems(marker_file()[:50])["short"]


def test_what_has_no_size_is_described_all_the_same():
    root = lm.Skeleton(("root",), [-1], [[0.0, 0.0, 0.0]])
    still = lm.Motion(root, np.zeros((30, 1, 3)), np.tile([1.0, 0, 0, 0], (30, 1, 1)), rate=30)
    told = lm.info(still)
    assert told.findings["size"].value is None
    assert next(problem.what for problem in told.problems) == "size"


def test_a_floor_that_cannot_be_told_leaves_the_other_remedies(rng):
    slide = np.cumsum(np.full((90, 1, 3), 0.1), axis=0) + rng.normal(0, 1e-3, (90, 1, 3))
    slide[40] += 0.7
    points = lm.Trajectories(("LANK",), slide, rate=100)
    mended = lm.repair(points, spikes=True, level=True)
    assert [change.what for change in mended.changes] == ["spike"]
    assert any("What else was asked for was done" in remark for remark in mended.remarks)
    with pytest.raises(lm.DataError, match="floor"):
        lm.repair(points, level=True)
