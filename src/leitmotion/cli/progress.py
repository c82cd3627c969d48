"""What is going on, on standard error, and only where somebody looks at it."""

from __future__ import annotations

import contextlib
import sys
import threading
import time
from collections.abc import Iterator
from types import TracebackType
from typing import Any, Self

PATIENCE_S = 0.3
"""Work shorter than this shows nothing."""
COMPILING_S = 1.0
"""Compiling that takes longer than this is mentioned, once."""
COMPILING = "Compiling for this machine; this happens once and may take a minute."


class Progress:
    """A line that tells which input is looked at and what is being done, gone when the work is done.

    Parameters
    ----------
    total : int
        How many inputs there are.
    quiet : bool
        Whether to say nothing at all.
    """

    def __init__(self, total: int, *, quiet: bool = False) -> None:
        self._total = total
        self._quiet = quiet
        self._shown = not quiet and sys.stderr.isatty()
        self._bar: Any = None
        self._task: Any = None
        self._timer: threading.Timer | None = None
        self._done = 0
        self._text = ""
        self._noted: set[str] = set()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None
    ) -> None:
        self.hide()

    def say(self, text: str) -> None:
        """Tell what is being done now."""
        self._text = text
        if self._bar is not None:
            self._bar.update(self._task, description=text)
        elif self._shown and self._timer is None:
            self._timer = threading.Timer(PATIENCE_S, self._show)
            self._timer.daemon = True
            self._timer.start()

    def step(self) -> None:
        """Tell that one input is done."""
        self._done += 1
        if self._bar is not None:
            self._bar.update(self._task, completed=self._done)

    def hide(self) -> None:
        """Clear the line, so that something else can be printed; the next word brings it back."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer.join()
            self._timer = None
        if self._bar is not None:
            self._bar.stop()
            self._bar = None

    def note(self, text: str) -> None:
        """Leave a remark on standard error."""
        if not self._quiet:
            print(text, file=sys.stderr, flush=True)

    def note_once(self, text: str) -> None:
        """Leave a remark that need not be made again for the next input."""
        if text not in self._noted:
            self._noted.add(text)
            self.note(text)

    def _show(self) -> None:
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, SpinnerColumn, TextColumn, TimeElapsedColumn
        from rich.progress import Progress as Bar

        counted = (BarColumn(bar_width=24), MofNCompleteColumn()) if self._total > 1 else ()
        bar = Bar(
            SpinnerColumn(),
            TextColumn("{task.description}", markup=False),
            *counted,
            TimeElapsedColumn(),
            console=Console(stderr=True),
            transient=True,
            redirect_stdout=False,
            redirect_stderr=False,
        )
        self._task = bar.add_task(self._text, total=self._total, completed=self._done)
        bar.start()
        self._bar = bar


@contextlib.contextmanager
def compiling_noted(progress: Progress) -> Iterator[None]:
    """Say once that kernels are being compiled, when that takes longer than a moment."""
    from numba.core import event

    class Listener(event.Listener):
        """Adds up the time spent compiling; one compilation may hold others."""

        depth = 0
        began = 0.0
        spent = 0.0
        timer: threading.Timer | None = None

        def on_start(self, event: object) -> None:
            self.depth += 1
            if self.depth == 1 and self.spent < COMPILING_S:
                self.began = time.monotonic()
                self.timer = threading.Timer(COMPILING_S - self.spent, progress.note_once, [COMPILING])
                self.timer.daemon = True
                self.timer.start()

        def on_end(self, event: object) -> None:
            self.depth -= 1
            if self.depth == 0 and self.timer is not None:
                self.timer.cancel()
                self.timer = None
                self.spent += time.monotonic() - self.began

    listener = Listener()
    with event.install_listener("numba:compile", listener):
        try:
            yield
        finally:
            if listener.timer is not None:
                listener.timer.cancel()
