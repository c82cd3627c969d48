"""What must hold for any bytes: a recording or one sentence, soon, in little memory and without a word from NumPy."""

import contextlib
import os
import resource
import signal
import tempfile
import warnings
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TypeVar

import numpy as np

from leitmotion import io
from leitmotion.motion import LeitmotionError, Motion

Held = TypeVar("Held")

SECONDS = 5
ROOM = 1 << 30  # bytes that one reading may take beyond what the process has


class TooLongError(BaseException):
    """A reading took longer than it may; no `except Exception` catches this."""


def put(folder: Path, files: Mapping[str, bytes]) -> Path:
    """Write the files of a case; the first is the recording."""
    for name, content in files.items():
        (folder / name).write_bytes(content)
    return folder / next(iter(files))


def check(files: Mapping[str, bytes]) -> None:
    """Read the recording that these files make, and check what must hold.

    Raises
    ------
    AssertionError
        When it does not hold; any other exception is one that the reader let through.
    """
    reading = _read(files, io.open_recording)
    if reading is None:
        return
    assert reading.recordings
    for recording in reading.recordings:
        assert np.isfinite(recording.rate)
        assert len(recording) > 0
        if not isinstance(recording, Motion):
            assert not np.isinf(recording.positions).any()
    for warning in reading.warnings:
        check_line(warning)


def check_labels(files: Mapping[str, bytes]) -> None:
    """Read the labels that these files hold, and check what must hold; errors as of :func:`check`."""
    labels = _read(files, lambda path: io.read_annotations(path, rate=120, trial="86_01", tier="*"))
    assert labels is None or (labels.stops >= labels.starts).all()


def _read(files: Mapping[str, bytes], read: Callable[[Path], Held]) -> Held | None:
    """What a reader makes of these files within its bounds, None where it is a sentence."""
    with tempfile.TemporaryDirectory(prefix="fuzz-") as folder:
        deep = Path(folder) / "1" / "2" / "3"  # the search for a skeleton goes up to three folders up
        deep.mkdir(parents=True)
        path = put(deep, files)
        with bounded(), warnings.catch_warnings(), np.errstate(over="warn", invalid="warn", divide="warn"):
            warnings.simplefilter("error")
            try:
                return read(path)
            except LeitmotionError as error:
                check_sentence(error)
                return None


def check_sentence(error: LeitmotionError) -> None:
    """Check that an error is one line that a person can read, and tells of a defect of the file and not of ours."""
    check_line(error.message)
    assert "\n" not in error.remedy, error.remedy
    assert error.remedy.isprintable(), error.remedy
    assert "more memory than there is" not in error.message, error.message


def check_line(text: str) -> None:
    """Check that a text is one line of printable characters, and not endless."""
    assert 10 < len(text) < 1500, text
    assert text.isprintable(), text
    assert text.endswith((".", "…", "?", "!")), text


@contextlib.contextmanager
def bounded(seconds: float = SECONDS, room: int = ROOM) -> Iterator[None]:
    """Within, memory may grow by so much and time pass so long; raise where they do not suffice."""

    def late(*_: object) -> None:
        raise TooLongError(f"a reading took longer than {seconds} s")

    before = resource.getrlimit(resource.RLIMIT_AS)
    taken = int(Path("/proc/self/statm").read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    handler = signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    resource.setrlimit(resource.RLIMIT_AS, (taken + room, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, handler)
