"""Answers as a person reads them on standard output: plain text as it is, tables in columns."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from rich.console import Console


def answer_console() -> Console:
    """Return the console that answers are printed on, never wrapped where they go into a file or a pipe."""
    from rich.console import Console

    class Answers(Console):
        def on_broken_pipe(self) -> None:
            raise BrokenPipeError  # as all else that prints: what is to be written is written all the same

    console = Answers(markup=False, highlight=False, emoji=False, soft_wrap=True)
    if not console.is_terminal:
        console.width = 10_000
    return console


def print_table(console: Console, headings: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print rows in columns; the last column wraps on a narrow terminal.

    Parameters
    ----------
    console : Console
        Where to print.
    headings : sequence of str
        One per column; a column of numbers begins with ``>`` and stands to the right. All empty: no heading.
    rows : sequence of sequence of str
        The cells.
    """
    from rich.table import Table

    names = [heading.removeprefix(">") for heading in headings]
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim", show_header=any(names))
    for place, (heading, name) in enumerate(zip(headings, names, strict=True)):
        right = heading.startswith(">")
        table.add_column(name, justify="right" if right else "left", no_wrap=place < len(names) - 1)
    for row in rows:
        table.add_row(*row)
    if console.is_terminal:
        console.print(table, soft_wrap=False)
        return
    with console.capture() as printed:
        console.print(table, soft_wrap=False)
    for line in printed.get().splitlines():
        click.echo(line.rstrip())
