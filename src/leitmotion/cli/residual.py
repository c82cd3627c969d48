"""``leitmotion patterns --residual``: what may have been missed, for a person and as a table of its own."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from leitmotion.cli.documents import Document
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import Opened

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Patterns, Residual

TOLD = 10
"""Candidates that a person is told at most."""
COLUMNS = (
    "path", "rank", "correlation", "a_start", "a_stop", "a_start_s", "a_stop_s",
    "b_start", "b_stop", "b_start_s", "b_stop_s",
)  # fmt: skip
"""Columns of the table, one row per candidate, the best of each recording first."""


def table_beside(table: Path | None) -> Path | None:
    """Say where the table of the candidates stands: beside that of the patterns, which has other columns.

    Examples
    --------
    >>> table_beside(Path("found.csv"))
    PosixPath('found-residual.csv')
    """
    if table is None or table.suffix.lower() != ".csv":
        return None
    return table.with_name(f"{table.stem}-residual{table.suffix}")


def search_left_over(opened: Opened, found: Patterns, progress: Progress) -> Residual:
    """Search what the patterns left over, telling what goes on.

    Parameters
    ----------
    opened : Opened
        The person.
    found : Patterns
        What recurs.
    progress : Progress
        Told what is being done.

    Returns
    -------
    Residual
        What was left over and correlates.
    """
    from leitmotion.api import search_residual

    progress.say(f"Looking through what is left of {opened.body.name}")
    recording, roles = opened.compared_by(str(found.parameters["feature"]))
    return search_residual(recording, found, body_map=roles)


def show_residual(console: Console, missed: Residual) -> None:
    """Print what may have been missed, the best candidates one a line.

    Parameters
    ----------
    console : Console
        Where to print.
    missed : Residual
        What was left over and correlates.
    """
    from leitmotion.view.counting import plural

    seconds = sum(stop - start for start, stop, _, _ in missed.left_over) / missed.rate
    console.print()
    if not len(missed.left_over):
        console.print("Nothing is left over.")
        return
    left = f"{seconds:.1f} s in {plural(len(missed.left_over), 'stretch')} left over by the patterns"
    if not missed.candidates:
        console.print(f"Of {left}, nothing moves like anything else there.")
        return
    some = f", of which {TOLD} are shown" if len(missed) > TOLD else ""
    console.print(
        f"Of {left}, {plural(len(missed), 'pair')} may have been missed{some}; many are chance. Those that are long "
        "and correlate stand first (length times correlation):"
    )
    for candidate in missed.candidates[:TOLD]:
        a, b = (
            f"{start / missed.rate:.1f}–{stop / missed.rate:.1f} s"
            for start, stop in (candidate.a, candidate.b)
        )
        console.print(f"  {a} and {b}, correlation {candidate.correlation:.2f}")


def residual_rows(document: Document) -> Iterator[dict[str, object]]:
    """One row per candidate; a failure has none."""
    if "error" in document:
        return
    path = document["source"][0]["path"]
    for rank, candidate in enumerate(document["result"]["residual"]["candidates"], start=1):
        sides = {
            f"{side}_{end}": candidate[side][end]
            for side in ("a", "b")
            for end in ("start", "stop", "start_s", "stop_s")
        }
        yield {"path": path, "rank": rank, "correlation": candidate["correlation"]} | sides
