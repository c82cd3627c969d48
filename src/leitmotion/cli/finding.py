"""What recurs in a recording that is open: searched, and printed for a person."""

from __future__ import annotations

from typing import TYPE_CHECKING

from leitmotion.cli.options import Options
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress, compiling_noted
from leitmotion.cli.recordings import Opened

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Body, Patterns


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
