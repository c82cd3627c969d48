"""Several processes: every piece is done once, a death costs one piece, and nobody stays behind."""

import contextlib
import os
import signal

import pytest

from cli.pieces import double, doubled_but_three_kills, process
from leitmotion.cli.pool import Died, each_as_done, usable_processors


@pytest.mark.parametrize("jobs", [1, 2, 9])
def test_every_piece_is_done_once(jobs: int) -> None:
    done = list(each_as_done(double, range(5), jobs))
    assert sorted(done) == [(k, 2 * k) for k in range(5)]


def test_no_piece_no_process() -> None:
    assert list(each_as_done(double, [], 4)) == []


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize("jobs", [1, 2])
def test_a_death_costs_the_piece_that_was_in_work_and_no_other(jobs: int) -> None:
    done = dict(each_as_done(doubled_but_three_kills, range(6), jobs))
    died = done.pop(3)
    assert isinstance(died, Died)
    assert died.status == -signal.SIGKILL
    assert died.process > 0
    assert done == {k: 2 * k for k in (0, 1, 2, 4, 5)}


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_closing_ends_every_process() -> None:
    with contextlib.closing(each_as_done(process, range(100), 2)) as results:
        numbers = {next(results)[1] for _ in range(8)}
    assert len(numbers) == 2
    for number in numbers:
        with pytest.raises(ProcessLookupError):
            os.kill(number, 0)


def test_the_processors_are_those_that_one_may_use() -> None:
    assert 1 <= usable_processors() <= (os.cpu_count() or 1)
