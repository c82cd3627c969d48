"""``leitmotion demo``: the whole way once, on a practice session of which the truth is known, or on a recording."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import click

from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.documents import patterns_result
from leitmotion.cli.finding import search, show_patterns, warnings_of
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options, common, examples, force, output, some
from leitmotion.cli.outputs import check_output, tell_written
from leitmotion.cli.pages import open_page, write_page
from leitmotion.cli.printing import answer_console, print_table
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import Opened, open_one

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Pattern, Patterns
    from leitmotion.datasets import Session

PAGE = Path("leitmotion-demo.html")


@click.command(epilog=examples("leitmotion demo", "leitmotion demo --data dance.bvh"))
@click.option(
    "--data", metavar="FILE", callback=some, help="Look at this recording instead of the practice session."
)
@click.option("--no-open", is_flag=True, help="Write the page, but do not open it in the browser.")
@output(f"The page to write; {PAGE} in the current folder by default.")
@force
@common()
def demo(data: str | None, no_open: bool, options: Options) -> None:
    """Show what Leitmotion does, on a practice session or a recording.

    Composes a minute of a person who walks, jumps, squats, kicks and raises the arms, finds what recurs in it, puts
    that beside the truth, and writes the page that shows it.
    """
    page = options.output or PAGE
    check_output(page, [], endings=(".html",), force=options.force)
    if data is None:
        tell_written(_practice(page, options), options)
    else:
        _recording(data, page, options)
    if not no_open:
        open_page(page)


class Row(NamedTuple):
    """One action of the practice session, and what was found of it."""

    action: str
    start_s: float
    stop_s: float
    cycles: int
    found: Pattern | None
    found_cycles: int


def compare(session: Session, found: Patterns) -> list[Row]:
    """Put what was found beside the truth.

    Parameters
    ----------
    session : Session
        The practice session.
    found : Patterns
        What recurs in it.

    Returns
    -------
    list of Row
        One per action that is not stillness; its pattern is the one that covers most of it, if that is over half.
    """
    from leitmotion.datasets import STILL

    rows = []
    rate = session.motion.rate
    for start, stop, action, _ in session.stretches:
        if action == STILL:
            continue
        cycles = sum(start <= (a + b) / 2 < stop for a, b, _, _ in session.cycles)
        best = max(found.patterns, key=lambda pattern: _shared(pattern, start, stop), default=None)
        if best is not None and _shared(best, start, stop) < (stop - start) / 2:
            best = None
        inside = 0 if best is None else sum(start <= (a + b) / 2 < stop for a, b, _, _ in best.occurrences)
        rows.append(Row(action, start / rate, stop / rate, cycles, best, inside))
    return rows


def _shared(pattern: Pattern, start: int, stop: int) -> int:
    """Frames of an action that a pattern's stretches cover."""
    return sum(max(0, min(b, stop) - max(a, start)) for a, b, _, _ in pattern.stretches)


def _practice(page: Path, options: Options) -> str:
    from leitmotion.api import compose_session, embody

    with Progress(1, quiet=options.quiet) as progress:
        progress.say("Composing the practice session")
        session = compose_session()
        body = embody(session.motion)
        opened = Opened(session.motion, body, source=[])
        found = search(opened, options, progress)
        kept = write_page(
            page, opened, found, options, progress, labels=session.stretches, labels_from="the composition"
        )
    if options.quiet:
        return kept
    console = answer_console()
    console.print(
        f"A practice session of {session.motion.duration:.0f} s, composed here, so that the truth is known."
    )
    show_patterns(console, found, seconds=session.motion.duration, body=body)
    console.print()
    _show_truth(console, compare(session, found))
    console.print()
    return kept


def _show_truth(console: Console, rows: list[Row]) -> None:
    from leitmotion.view.counting import clock

    print_table(
        console,
        ("the truth", "from and to", ">cycles", "found", ">cycles"),
        [
            (
                row.action,
                f"{clock(row.start_s)}–{clock(row.stop_s)}",
                str(row.cycles),
                row.found.id if row.found else "not found",
                str(row.found_cycles) if row.found else "",
            )
            for row in rows
        ],
    )


def _recording(data: str, page: Path, options: Options) -> None:
    def look(given: Input, progress: Progress) -> Answer:
        opened = open_one(given, options, progress)
        found = search(opened, options, progress)
        kept = write_page(page, opened, found, options, progress)
        return Answer(
            source=opened.source,
            result=patterns_result(found),
            show=lambda console: show_patterns(
                console, found, seconds=opened.source[0]["seconds"], body=opened.body
            ),
            parameters=found.parameters,
            warnings=warnings_of(opened, found),
            written=[kept],
        )

    finish(answer_each("demo", [data], options, look))
