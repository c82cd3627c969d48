"""Work for the processes of the tests: what a spawned process is given has to stand in a module."""

import os
import signal
import time
from typing import Any

from leitmotion.cli import converting
from leitmotion.io import files


def double(number: int) -> int:
    """Take the longer the smaller the number, so that the last is done first."""
    time.sleep(0.1 * max(0, 3 - number))
    return 2 * number


def doubled_but_three_kills(number: int) -> int:
    if number == 3:
        os.kill(os.getpid(), signal.SIGKILL)
    return 2 * number


def process(number: int) -> int:
    time.sleep(0.05)
    return os.getpid()


def work_but_two_dies(order: Any, task: Any) -> Any:
    """Convert, but be killed in the middle of writing ``two.bvh``."""
    if task.given.path.name == "two.bvh":
        order.folder.mkdir(exist_ok=True)
        part = f".two.npz.{files.owner(os.getpid())}-0123456789abcdef.part"
        (order.folder / part).write_bytes(b"half")
        os.kill(os.getpid(), signal.SIGKILL)
    return converting.work(order, task)


def slow_work(order: Any, task: Any) -> Any:
    """Convert, after a while."""
    time.sleep(1.0)
    return converting.work(order, task)


def endless_work(order: Any, task: Any) -> Any:
    """Never be done, and leave half a file behind unless ended properly."""
    print("working", flush=True)
    files.os.fsync = lambda handle: time.sleep(60)
    files.write_whole(task.target, b"half")
