"""What recurs in a recording that is open: searched, and printed for a person."""

from __future__ import annotations

from typing import TYPE_CHECKING

from leitmotion.cli.options import Options
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress, compiling_noted
from leitmotion.cli.recordings import Opened

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Body, Patterns, Residual

TOLD = 10
"""Candidates for what was missed that a person is told at most."""


def search(opened: Opened, options: Options, progress: Progress) -> Patterns:
    """Find what recurs, telling what goes on.

    Parameters
    ----------
    opened : Opened
        The person.
    options : Options
        How to search.
    progress : Progress
        Told what is being done.

    Returns
    -------
    Patterns
        What recurs.
    """
    from leitmotion.api import find_patterns

    progress.say(f"Looking for what recurs in {opened.body.name}")
    recording, roles = opened.compared_by(options.features)
    with compiling_noted(progress):
        return find_patterns(recording, body_map=roles, **options.searching)


def search_left_over(opened: Opened, found: Patterns, progress: Progress) -> Residual:
    """Search what the patterns left over, telling what goes on."""
    from leitmotion.api import search_residual

    progress.say(f"Looking through what is left of {opened.body.name}")
    recording, roles = opened.compared_by(str(found.parameters["feature"]))
    return search_residual(recording, found, body_map=roles)


def warnings_of(opened: Opened, found: Patterns) -> list[str]:
    """List what the person should know about a recording and about how it was compared."""
    from leitmotion.view.words import as_they_stand

    return [*opened.warnings, *filter(None, [as_they_stand(found, opened.body), _not_compared(found)])]


def _not_compared(found: Patterns) -> str:
    """Tell that stretches far apart were not compared, where that was so."""
    from leitmotion.view.counting import clock

    within = found.parameters.get("compared_within_s")
    if not isinstance(within, float):
        return ""
    return f"So much recurs that only stretches within {clock(within)} of one another were compared."


def show_patterns(console: Console, found: Patterns, *, seconds: float, body: Body) -> None:
    """Print what recurs: the answer in a sentence, then a row for each pattern.

    Parameters
    ----------
    console : Console
        Where to print.
    found : Patterns
        What recurs.
    seconds : float
        Length of the recording.
    body : Body
        The person.
    """
    from leitmotion.view.counting import clock
    from leitmotion.view.words import lead, looked_for, title

    console.print(f"{title(found)}.", style="bold")
    pieces = lead(found, seconds, body)
    console.print("".join(piece if isinstance(piece, str) else piece.id for piece in pieces))
    if not found.patterns:
        if found.nearest_miss:
            console.print(found.nearest_miss)
        sought = looked_for(found)
        console.print(f"Looked for: {sought[:1].lower()}{sought[1:]}", style="dim")
        return
    console.print()
    print_table(
        console,
        ("", "kind", ">stretches", ">cycles", ">each", ">confidence", "from and to"),
        [
            (
                pattern.id,
                pattern.kind,
                str(len(pattern.stretches)),
                str(pattern.cycles) if pattern.cycles else "",
                f"{pattern.period_s:.2f} s",
                f"{pattern.confidence:.2f}",
                ", ".join(
                    f"{clock(start / found.rate)}–{clock(stop / found.rate)}"
                    for start, stop, _, _ in pattern.stretches
                ),
            )
            for pattern in found.patterns
        ],
    )


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
    some = f", the best {TOLD}" if len(missed) > TOLD else ""
    console.print(f"Of {left}, {plural(len(missed), 'pair')} may have been missed{some}; many are chance:")
    for candidate in missed.candidates[:TOLD]:
        a, b = (
            f"{start / missed.rate:.1f}–{stop / missed.rate:.1f} s"
            for start, stop in (candidate.a, candidate.b)
        )
        console.print(f"  {a} and {b}, correlation {candidate.correlation:.2f}")
