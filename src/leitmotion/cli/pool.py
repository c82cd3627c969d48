"""Several processes at work: each takes the next piece; one that dies costs the piece that it had, and no other.

The workers are started anew (no fork), hear nothing of Ctrl-C, which is for the program to judge, and end when it does:
their pipe to it closes.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import signal
import sys
from collections.abc import Callable, Generator, Iterator, Sequence
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from typing import Any, TypeVar

Piece = TypeVar("Piece")
Result = TypeVar("Result")

PATIENCE_S = 2.0
"""How long a worker that was told to end may take before it is killed."""


@dataclass(frozen=True)
class Died:
    """A worker ended in the middle of its piece."""

    process: int
    """The number that the process had."""

    status: int
    """Its exit status; of a signal the negative number."""


class _Worker:
    """A process that works on one piece after another."""

    def __init__(self, work: Callable[[Any], Any]) -> None:
        context = get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_serve, args=(work, theirs), daemon=True)
        with _ctrl_c_held():
            self.process.start()
        theirs.close()  # so that the pipe ends with the process
        self.place = -1

    def give(self, place: int, piece: object) -> None:
        self.place = place
        with contextlib.suppress(OSError):  # a worker that has died is noticed where its answer is awaited
            self.pipe.send(piece)

    def take(self) -> Any:
        try:
            return self.pipe.recv()
        except (EOFError, OSError):
            self.process.join()
            return Died(self.process.pid or 0, self.process.exitcode or 0)

    def end(self) -> None:
        self.process.terminate()
        self.process.join(PATIENCE_S)
        if self.process.is_alive():
            self.process.kill()
            self.process.join()
        self.pipe.close()


def usable_processors() -> int:
    """Count the processors that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def each_as_done(
    work: Callable[[Piece], Result], pieces: Sequence[Piece], jobs: int
) -> Generator[tuple[int, Result | Died]]:
    """Do pieces of work in several processes.

    Parameters
    ----------
    work : callable
        What to do with a piece; a function of a module, as are its pieces and results what can be sent.
    pieces : sequence
        What to do it with.
    jobs : int
        How many processes at most.

    Yields
    ------
    tuple of int and Result or Died
        The place of a piece and what came of it, in the order in which they are done. Closing the iterator, or an
        interruption, ends all workers at once.
    """
    waiting = iter(enumerate(pieces))
    busy: list[_Worker] = []
    try:
        for place, piece in itertools.islice(waiting, jobs):
            busy.append(_Worker(work))
            busy[-1].give(place, piece)
        while busy:
            ready: Any = wait([worker.pipe for worker in busy])
            for worker in [worker for worker in busy if worker.pipe in ready]:
                place, result = worker.place, worker.take()
                following = next(waiting, None)
                if following is None or isinstance(result, Died):
                    worker.end()
                    busy.remove(worker)
                if following is not None:
                    if worker not in busy:
                        worker = _Worker(work)
                        busy.append(worker)
                    worker.give(*following)
                yield place, result
    finally:
        for worker in busy:
            worker.process.terminate()  # all at once, then each is waited for
        for worker in busy:
            worker.end()


@contextlib.contextmanager
def _ctrl_c_held() -> Iterator[None]:
    """Keep Ctrl-C from a process that is started now, from its first moment on; here it comes a moment later."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _serve(work: Callable[[Any], Any], pipe: Connection) -> None:
    """Work on what comes through the pipe until it closes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(
        signal.SIGTERM, lambda number, frame: sys.exit(128 + number)
    )  # so that half a file is removed
    with contextlib.suppress(EOFError, BrokenPipeError, ConnectionResetError):
        while True:
            pipe.send(work(pipe.recv()))
