"""Sharing work among the processor's cores, in pieces so small that Ctrl-C is heard."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import TypeVar

WORKERS = 2
T = TypeVar("T")
R = TypeVar("R")


def share_work(do: Callable[[slice], None], count: int, size: int) -> None:
    """Do `count` things, `size` at a time, on several cores; each kernel called must let go of the interpreter.

    Parameters
    ----------
    do : callable
        Told which things; pieces must not depend on one another.
    count, size : int
        How many there are, and how many at a time. A single piece is short enough to need no thread.
    """
    if 0 < count <= size:
        do(slice(0, count))
        return
    for _ in ahead(do, (slice(k, min(count, k + size)) for k in range(0, count, size))):
        pass


def aside(do: Callable[..., R], *arguments: object) -> R:
    """Run a kernel in another thread and wait for it: Ctrl-C that falls into a kernel of the main thread is garbled.

    Parameters
    ----------
    do : callable
        A kernel that lets go of the interpreter.
    *arguments
        What it takes.

    Returns
    -------
    result
        What it gives.
    """
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(do, *arguments).result()


def ahead(do: Callable[[T], R], pieces: Iterable[T]) -> Iterator[R]:
    """Work on the next pieces while one is used; results come in order.

    Parameters
    ----------
    do : callable
        What is done to a piece.
    pieces : iterable
        The pieces.

    Yields
    ------
    result
        Of each piece, in order.
    """
    pieces = iter(pieces)
    waiting: deque[Future[R]] = deque()
    with ThreadPoolExecutor(WORKERS) as pool:
        try:
            for piece in pieces:
                waiting.append(pool.submit(do, piece))
                if len(waiting) > 2 * WORKERS:
                    yield waiting.popleft().result()
            while waiting:
                yield waiting.popleft().result()
        finally:
            for future in waiting:
                future.cancel()
