"""What recurs in a recording that is open: searched, and printed for a person."""

from __future__ import annotations

import inspect
import math
from typing import TYPE_CHECKING

from leitmotion.cli.options import Options
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress, compiling_noted
from leitmotion.cli.recordings import Opened

FAR = 3.0
"""So many times the default of what is alike, or so little of it, is told."""

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

    told = [as_they_stand(found, opened.body), _not_compared(found), _unusual(found)]
    return [*opened.warnings, *filter(None, told)]


def _unusual(found: Patterns) -> str:
    """Tell that what counts as alike is far from what does by default."""
    from leitmotion.discovery.tang2008 import find_patterns_tang2008
    from leitmotion.features import FEATURES

    parameters = found.parameters
    if parameters["method"] == "tang2008":
        option, unit = "threshold", "of the largest distance"
        usual = inspect.signature(find_patterns_tang2008).parameters[option].default
    else:
        feature = FEATURES[str(parameters["feature"])]
        option, unit = "max_distance", feature.measured_in
        usual = feature.alike.get(str(parameters["weights"]), math.nan)
    given = parameters[option]
    if not isinstance(given, float | int) or not (given > FAR * usual or given < usual / FAR):
        return ""
    far = "above" if given > usual else "below"
    few = "nearly all" if given > usual else "hardly any two"
    named = f"--{option.replace('_', '-')} {given:g}"
    return f"{named} is far {far} the default, {usual:g} {unit}: {few} moments count as alike then."


def _not_compared(found: Patterns) -> str:
    """Tell that stretches far apart were not compared, where that was so."""
    from leitmotion.view.counting import clock

    limits = {
        "compared_within_s": "stretches",
        "second_compared_within_s": "stretches of what was left over",
        "moves_compared_within_s": "whole movements of what was left over",
    }
    for name, what in limits.items():
        within = found.parameters.get(name)
        if isinstance(within, float):
            return f"So much recurs that only {what} within {clock(within)} of one another were compared."
    return ""


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
    from leitmotion.view.lengths import lasts, overlap
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
                lasts(pattern),
                f"{pattern.confidence:.2f}",
                ", ".join(
                    f"{clock(start / found.rate)}–{clock(stop / found.rate)}"
                    for start, stop, _, _ in pattern.stretches
                ),
            )
            for pattern in found.patterns
        ],
    )
    if remark := overlap(found):
        console.print(remark)
