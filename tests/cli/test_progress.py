"""What is going on, and where it is told."""

import time

import pytest

from leitmotion.cli import progress as module
from leitmotion.cli.progress import COMPILING, Progress, compiling_noted


def test_nothing_is_shown_where_nobody_looks(capfd: pytest.CaptureFixture[str]) -> None:
    with Progress(2) as progress:
        progress.say("Reading")
        time.sleep(module.PATIENCE_S + 0.1)
        progress.step()
    assert capfd.readouterr() == ("", "")


def test_a_terminal_sees_what_is_done(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    monkeypatch.setattr(module, "PATIENCE_S", 0.0)
    with Progress(3) as progress:
        progress.say("Reading dance.bvh[1s:2s]")
        time.sleep(0.3)
    out, err = capsys.readouterr()
    assert out == ""
    assert "Reading dance.bvh[1s:2s]" in err


def test_quiet_leaves_no_remark(capsys: pytest.CaptureFixture[str]) -> None:
    Progress(1, quiet=True).note("by the way")
    Progress(1).note("mind this")
    assert capsys.readouterr() == ("", "mind this\n")


def compile_for(seconds: float) -> None:
    from numba.core import event

    with event.trigger_event("numba:compile"), event.trigger_event("numba:compile"):
        time.sleep(seconds)


def test_compiling_is_noted_once_when_it_takes_long(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "COMPILING_S", 0.1)
    with Progress(1) as progress, compiling_noted(progress):
        for seconds in (0.06, 0.1, 0.1):
            compile_for(seconds)
    assert capsys.readouterr().err == COMPILING + "\n"


def test_compiling_for_the_next_input_is_not_noted_again(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "COMPILING_S", 0.05)
    with Progress(2) as progress:
        for _ in range(2):
            with compiling_noted(progress):
                compile_for(0.15)
    assert capsys.readouterr().err == COMPILING + "\n"


def test_a_short_compilation_is_not_worth_a_word(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "COMPILING_S", 0.2)
    with Progress(1) as progress, compiling_noted(progress):
        compile_for(0.01)
        time.sleep(0.3)
    assert capsys.readouterr().err == ""
