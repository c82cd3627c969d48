"""The program as a shell sees it: help, verbs, exit statuses, what it loads."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import click
import pytest

from cli.conftest import Run
from leitmotion import __version__
from leitmotion.cli import main
from leitmotion.cli.program import VERBS

HEAVY = ("matplotlib", "numba", "numpy", "rich", "scipy", "sklearn")


def python(*arguments: str, **options: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, *arguments], capture_output=True, text=True, timeout=60, **options)  # type: ignore[call-overload, no-any-return]


def test_help_lists_every_verb(run: Run) -> None:
    told = run("--help")
    assert told.exit_code == 0
    assert all(re.search(rf"^  {verb} +\S", told.output, re.MULTILINE) for verb in VERBS)


def test_no_argument_is_a_request_for_help(run: Run) -> None:
    assert run().output == run("--help").output
    assert run().exit_code == 0


@pytest.mark.parametrize("verb", VERBS)
def test_each_verb_is_a_command_that_says_the_same_of_itself(run: Run, verb: str) -> None:
    told = run(verb, "--help")
    assert told.exit_code == 0
    assert VERBS[verb] in " ".join(told.output.split())


def test_version(run: Run) -> None:
    assert run("--version").output == f"leitmotion {__version__}\n"


@pytest.mark.parametrize(
    ("typed", "meant"), [("patern", "patterns"), ("reports", "report"), ("INFO", "info"), ("dmeo", "demo")]
)
def test_a_wrong_verb_suggests_the_near_one(run: Run, typed: str, meant: str) -> None:
    told = run(typed)
    assert told.exit_code == 2
    assert f"There is no verb {typed!r}. Did you mean {meant!r}?" in told.stderr


def test_a_verb_unlike_any_is_answered_by_their_list(run: Run) -> None:
    told = run("qqq")
    assert told.exit_code == 2
    assert (
        "The verbs are demo, info, convert, repair, calibrate, similarity, patterns, symmetry, dynamics, graph, "
        "evaluate, report." in told.stderr
    )


def test_a_file_in_place_of_the_verb_is_noticed(run: Run) -> None:
    Path("dance.bvh").touch()
    told = run("dance.bvh")
    assert told.exit_code == 2
    assert "leitmotion report dance.bvh" in told.stderr


@pytest.mark.parametrize("verb", ["info", "convert", "patterns", "report"])
def test_a_verb_without_a_file_is_wrong_usage(run: Run, verb: str) -> None:
    told = run(verb)
    assert told.exit_code == 2
    assert "Missing argument 'INPUT...'" in told.stderr


@pytest.mark.parametrize("arguments", [["--help"], ["patterns", "--help"], ["convert", "--help"], ["patern"]])
def test_help_loads_nothing_heavy(arguments: list[str]) -> None:
    ran = python("-X", "importtime", "-m", "leitmotion", *arguments)
    loaded = {
        line.rpartition("|")[2].strip().partition(".")[0] for line in ran.stderr.splitlines() if "|" in line
    }
    assert "leitmotion" in loaded
    assert not loaded & set(HEAVY)


def test_help_is_instant() -> None:
    def once() -> float:
        before = os.times()
        python("-m", "leitmotion", "--help")
        after = os.times()
        return after.children_user + after.children_system - before.children_user - before.children_system

    assert min(once() for _ in range(3)) < 0.3


def test_a_module_run_is_the_program() -> None:
    ran = python("-m", "leitmotion", "patterns", "nowhere.bvh")
    assert ran.returncode == 1
    assert ran.stderr.startswith("Error: There is no file nowhere.bvh.")
    assert "Traceback" not in ran.stderr


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_ctrl_c_stops_with_130_and_one_line(tmp_path: Path) -> None:
    slow = (
        "import signal, time\n"
        "from leitmotion.cli import info, main\n"
        "def look(*args, **options):\n    print('looking', flush=True)\n    time.sleep(30)\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # a background job inherits it ignored
        "info.info.callback = look\n"
        "main(['info', 'a.bvh'])"
    )
    with subprocess.Popen(
        [sys.executable, "-c", slow], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=tmp_path
    ) as running:
        assert running.stdout is not None
        assert running.stderr is not None
        assert running.stdout.readline() == "looking\n"
        time.sleep(0.05)
        running.send_signal(signal.SIGINT)
        assert running.wait(timeout=20) == 130
        assert running.stderr.read().split() == ["Stopped."]


@pytest.mark.skipif(os.name == "nt", reason="pipes of POSIX")
def test_a_file_is_written_though_the_reader_has_left(made: Path, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "leitmotion", "patterns", str(made / "jacks.bvh"), "-o", "found.csv"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=tmp_path) as told:
        assert told.stdout is not None
        told.stdout.close()
        told.wait(60)
    assert (tmp_path / "found.csv").read_text().startswith("path,pattern")


def test_a_reader_that_leaves_is_no_error() -> None:
    with subprocess.Popen(
        [sys.executable, "-m", "leitmotion", "--help"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as running:
        assert running.stdout is not None
        assert running.stderr is not None
        running.stdout.close()
        running.wait(timeout=20)
        assert running.stderr.read() == ""


def test_an_unexpected_error_says_that_it_is_ours(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*args: object, **options: object) -> None:
        raise ZeroDivisionError("division by zero")

    monkeypatch.setattr("leitmotion.cli.info.info.callback", broken)
    told = run("info", "a.bvh")
    assert told.exit_code == 1
    assert told.stderr.count("\n") == 1
    assert "ZeroDivisionError: division by zero." in told.stderr
    assert "a defect in Leitmotion" in told.stderr


def test_the_group_is_a_click_group_for_documentation() -> None:
    with click.Context(main) as context:
        assert main.list_commands(context) == list(VERBS)
        assert main.get_command(context, "nothing") is None


def test_the_methods_on_offer_are_those_of_the_library() -> None:
    from leitmotion.discovery import METHODS

    for verb in ("patterns", "report", "demo"):
        command = main.get_command(click.Context(main), verb)
        assert command is not None
        (method,) = [parameter for parameter in command.params if parameter.name == "method"]
        assert tuple(method.type.choices) == METHODS  # type: ignore[attr-defined]
