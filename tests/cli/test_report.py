"""``leitmotion report`` and ``leitmotion demo``: the page, where it goes, and what it never replaces."""

import json
import re
from pathlib import Path

import pytest

import leitmotion as lm
from cli.conftest import Run
from leitmotion import io
from leitmotion.cli import demo
from leitmotion.cli.ours import is_ours

PAGE_OF_SOMEBODY = "<!doctype html><title>My thesis</title>"


def is_page(path: Path) -> bool:
    return is_ours(path)


def test_the_page_has_the_name_of_the_recording_in_the_current_folder(run: Run, made: Path) -> None:
    told = run("report", made / "jacks.bvh")
    assert told.exit_code == 0
    assert told.stdout == "One movement recurs, four times.\nWrote jacks.html.\n"
    assert is_page(Path("jacks.html"))


def test_nothing_repeats_has_a_page_as_well(run: Run, made: Path) -> None:
    assert run("report", made / "once.bvh").stdout.startswith("Nothing repeats here.")
    assert is_page(Path("once.html"))


def test_o_names_the_page_or_the_folder(run: Run, made: Path) -> None:
    run("report", made / "jacks.bvh", "-o", "here/there.html")
    assert is_page(Path("here/there.html"))
    Path("pages").mkdir()
    run("report", made / "jacks.bvh", "-o", "pages")
    assert is_page(Path("pages/jacks.html"))


def test_recordings_of_one_name_get_pages_of_two_names(run: Run, made: Path) -> None:
    Path("other").mkdir()
    Path("other/jacks.bvh").write_bytes((made / "once.bvh").read_bytes())
    told = run("report", made / "jacks.bvh", "other/jacks.bvh", made / "bad.bvh", "-o", "pages")
    assert told.exit_code == 1
    assert sorted(path.name for path in Path("pages").iterdir()) == ["jacks-2.html", "jacks.html"]


def test_our_own_page_is_replaced_and_somebody_elses_is_not(run: Run, made: Path) -> None:
    assert run("report", made / "jacks.bvh").exit_code == 0
    assert run("report", made / "jacks.bvh").exit_code == 0
    Path("jacks.html").write_text(PAGE_OF_SOMEBODY, encoding="utf-8")
    told = run("report", made / "jacks.bvh")
    assert told.exit_code == 2
    assert "--force" in told.stderr
    assert Path("jacks.html").read_text(encoding="utf-8") == PAGE_OF_SOMEBODY
    assert run("report", made / "jacks.bvh", "--force").exit_code == 0
    assert is_page(Path("jacks.html"))


@pytest.mark.parametrize("name", ["all.html", "deep/all.html", "all.png"])
def test_a_folder_for_pages_of_several_is_not_called_as_a_file(run: Run, made: Path, name: str) -> None:
    told = run("report", made / "jacks.bvh", made / "once.bvh", "-o", name)
    assert told.exit_code == 2
    assert f"Name a folder: -o {Path(name).with_suffix('')}." in told.stderr
    assert not list(Path().iterdir())


def test_a_folder_that_is_there_takes_pages_whatever_it_is_called(run: Run, made: Path) -> None:
    Path("pages.html").mkdir()
    assert run("report", made / "jacks.bvh", made / "once.bvh", "-o", "pages.html").exit_code == 0
    assert sorted(path.name for path in Path("pages.html").iterdir()) == ["jacks.html", "once.html"]


def test_a_folder_in_the_page_s_place_is_wrong_usage(run: Run, made: Path) -> None:
    Path("jacks.html").mkdir()
    told = run("report", made / "jacks.bvh")
    assert told.exit_code == 2
    assert "jacks.html is a folder" in told.stderr


@pytest.mark.parametrize(("name", "count"), [("page.txt", 1), ("taken", 1), ("taken.html", 2)])
def test_o_is_a_page_or_a_folder_and_nothing_else(run: Run, made: Path, name: str, count: int) -> None:
    for taken in ("taken", "taken.html"):
        Path(taken).write_text("mine", encoding="utf-8")
    told = run("report", *[made / "jacks.bvh", made / "once.bvh"][:count], "-o", name)
    assert told.exit_code == 2
    assert ".html" in told.stderr
    assert Path("taken").read_text(encoding="utf-8") == "mine"


def test_a_failure_leaves_the_page_that_was_there(
    run: Run, made: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run("report", made / "jacks.bvh")
    before = Path("jacks.html").read_bytes()

    def interrupted(*args: object, **options: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("leitmotion.view.report_page", interrupted)
    told = run("report", made / "jacks.bvh")
    assert told.exit_code == 130
    assert told.stderr.split() == ["Stopped."]
    assert [path.name for path in Path().iterdir()] == ["jacks.html"]
    assert Path("jacks.html").read_bytes() == before


def test_json_tells_where_the_page_is(run: Run, made: Path) -> None:
    document = json.loads(run("report", made / "jacks.bvh", "--json").stdout)
    assert document["result"]["written"] == "jacks.html"
    assert len(document["result"]["patterns"]) == 1


def test_labels_stand_in_a_lane_of_the_window(run: Run, made: Path) -> None:
    Path("labels.csv").write_text(
        "start_s,stop_s,label\n0,0.5,before\n0.5,2.0,hop along\n2.0,30,after\n", encoding="utf-8"
    )
    told = run("report", f"{made / 'jacks.bvh'}[1s:4s]", "--labels", "labels.csv", "-o", "page.html")
    assert told.exit_code == 0
    page = Path("page.html").read_text(encoding="utf-8")
    assert "hop along" in page
    assert "labels.csv" in page
    assert '"before"' not in page


@pytest.mark.parametrize(("rows", "lost"), [("5,900,a\n", "1 of 1"), ("1,2,a\n5,9,b\n90,91,c\n", "1 of 3")])
def test_labels_outside_what_was_read_are_counted(run: Run, made: Path, rows: str, lost: str) -> None:
    Path("labels.csv").write_text(f"start_s,stop_s,label\n{rows}", encoding="utf-8")
    window = f"{made / 'jacks.bvh'}[0s:{4 if lost == '1 of 1' else 6}s]"
    told = run("report", window, "--labels", "labels.csv")
    assert told.exit_code == 0
    assert f"Note: Not shown: {lost} labels in labels.csv, outside the " in told.stderr
    document = json.loads(run("report", window, "--labels", "labels.csv", "--json").stdout)
    assert any(f"Not shown: {lost} labels" in warning for warning in document["warnings"])


def test_labels_that_cannot_be_read_are_told_before_the_search(
    run: Run, made: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def searched(*args: object, **options: object) -> None:
        raise AssertionError("it was searched")

    monkeypatch.setattr("leitmotion.cli.report.search", searched)
    Path("labels.csv").write_text("when,what\n1,jump\n", encoding="utf-8")
    told = run("report", made / "jacks.bvh", "--labels", "labels.csv")
    assert told.exit_code == 1
    assert "labels.csv, line 1: expected the columns" in told.stderr


def test_labels_belong_to_one_recording(run: Run, made: Path) -> None:
    Path("labels.csv").touch()
    told = run("report", made, "--labels", "labels.csv")
    assert told.exit_code == 2
    assert "--labels belongs to one recording" in told.stderr


@pytest.mark.parametrize(("screen", "opened"), [(":0", 1), ("", 0)])
def test_the_browser_opens_where_there_is_a_screen(
    run: Run, made: Path, monkeypatch: pytest.MonkeyPatch, screen: str, opened: int
) -> None:
    opened_pages: list[str] = []
    monkeypatch.setattr("webbrowser.open", lambda url: opened_pages.append(url) or True)
    monkeypatch.setattr("sys.platform", "linux")
    for name in ("WAYLAND_DISPLAY", "WSL_DISTRO_NAME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("DISPLAY", screen)
    told = run("report", made / "jacks.bvh", "--open")
    assert told.exit_code == 0
    assert len(opened_pages) == opened
    assert ("no screen" in told.stderr) is not bool(opened)


def test_demo_puts_what_it_finds_beside_the_truth(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def no_browser(page: Path) -> bool:
        raise AssertionError("--no-open was given")

    monkeypatch.setattr(demo, "open_page", no_browser)
    told = run("demo", "--no-open")
    assert told.exit_code == 0
    assert told.stdout.endswith("Wrote leitmotion-demo.html.\n")
    assert is_page(Path("leitmotion-demo.html"))
    truth = told.stdout[told.stdout.index("\nthe truth") + 1 :]
    rows = [line.split("  ") for line in truth.splitlines()[1:] if line and not line.startswith("Wrote")]
    assert [row[0] for row in rows] == [
        "walk", "jumping jack", "squat", "left side kick", "right side kick", "arm raise", "walk",
    ]  # fmt: skip
    assert "not found" not in truth


def test_demo_of_a_recording(run: Run, made: Path) -> None:
    told = run("demo", "--data", made / "jacks.bvh", "--no-open", "-o", "page.html")
    assert told.exit_code == 0
    assert told.stdout.startswith("One movement recurs, four times.")
    assert is_page(Path("page.html"))


def test_demo_of_a_bad_file_writes_nothing(run: Run, made: Path) -> None:
    told = run("demo", "--data", made / "bad.bvh", "--no-open")
    assert told.exit_code == 1
    assert "The page" not in told.stdout
    assert not list(Path().iterdir())


def test_labels_of_an_eaf_come_from_one_tier(run: Run, made: Path) -> None:
    io.write_annotations(lm.Segmentation([0], [30], ("walk",), rate=30), "labels.eaf", tier="moves")
    text = Path("labels.eaf").read_text(encoding="utf-8")
    tier = text[text.index("  <TIER") : text.index("  <LINGUISTIC")]
    text = text.replace(
        tier, tier + tier.replace("moves", "speech").replace("walk", "hello").replace('"a1"', '"a2"')
    )
    Path("labels.eaf").write_text(text, encoding="utf-8")
    told = run("report", made / "jacks.bvh", "--labels", "labels.eaf")
    assert told.exit_code == 1
    assert "several tiers, 'moves', 'speech'" in told.stderr
    assert run("report", made / "jacks.bvh", "--labels", "labels.eaf", "--tier", "speech").exit_code == 0
    assert "hello" in Path("jacks.html").read_text(encoding="utf-8")


def test_labels_that_reach_beyond_what_was_read_are_told(run: Run, made: Path) -> None:
    Path("labels.csv").write_text("start_s,stop_s,label\n0,2,a\n1,3,b\n2,9,c\n3.5,99,b\n", encoding="utf-8")
    told = run("report", f"{made / 'jacks.bvh'}[1s:4s]", "--labels", "labels.csv")
    assert told.exit_code == 0
    assert (
        "Note: Cut: 3 labels in labels.csv (a, c, b) reach beyond the 3.00 s that were read." in told.stderr
    )


def test_what_is_odd_about_the_file_stands_on_the_page(run: Run, made: Path) -> None:
    content = (made / "jacks.bvh").read_bytes()
    Path("cut.bvh").write_bytes(content[: len(content) * 9 // 10])
    told = run("report", "cut.bvh", "--json")
    (document,) = map(json.loads, told.stdout.splitlines())
    payload = re.search(r'id="payload">(.*?)</script>', Path("cut.html").read_text(encoding="utf-8"))
    assert payload is not None
    assert document["warnings"][0].startswith("The file ends within its row ")
    assert json.loads(payload[1])["notes"] == document["warnings"]
