"""``leitmotion repair``: mend a recording by remedies that have a name."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.copies import copy_targets, write_copy
from leitmotion.cli.documents import reading_parameters, repair_result, source_entry
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options, Positive, as_json, common, examples, force, output, takes_inputs
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import read_one, unused_skeleton
from leitmotion.cli.suggestions import one_command

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Repaired


class _Frames(click.ParamType):
    """Two frames with a colon between."""

    name = "A:B"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        found = re.fullmatch(r"\s*(\d+)\s*:\s*(\d+)\s*", str(value))
        if found is None or int(found[1]) >= int(found[2]):
            self.fail(f"{value!r} is no stretch of frames such as 120:180.", param, ctx)
        return int(found[1]), int(found[2])


class _Cutoff(click.ParamType):
    """A frequency in hertz, or the word auto."""

    name = "HZ"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        if value == "auto":
            return value
        try:
            cutoff = float(value)
        except ValueError:
            cutoff = math.nan
        if not 0 < cutoff < math.inf:
            self.fail(f"{value!r} is neither a number of hertz nor auto.", param, ctx)
        return cutoff


@click.command(
    epilog=examples(
        "leitmotion repair walk.c3d",
        "leitmotion repair walk.c3d --spikes --fill rigid -o walk-repaired.npz",
        "leitmotion repair recordings/ --filter 6 -o smooth/",
    )
)
@takes_inputs
@output(
    "The file to write, by its ending, or a folder for several inputs. Without it, what would change is told.",
    folder=True,
)
@click.option("--duplicates", is_flag=True, help="Replace frames that repeat the one before.")
@click.option("--swaps", is_flag=True, help="Give points that changed places their names back.")
@click.option("--frozen", is_flag=True, help="Take points that stand still while others move for unseen.")
@click.option("--spikes", is_flag=True, help="Take out what leaps away for a moment and comes back.")
@click.option(
    "--fill", type=click.Choice(["linear", "spline", "rigid"]), help="Fill the gaps of points by this method."
)
@click.option(
    "--max-gap",
    "max_gap_s",
    type=Positive(),
    metavar="SECONDS",
    help="The longest gap to fill: 0.2 unless said otherwise, 1 by rigid.",
)
@click.option(
    "--frames", type=_Frames(), metavar="A:B", help="With --swap-sides: in these frames only, B excluded."
)
@click.option(
    "--filter", "filter_", type=_Cutoff(), metavar="HZ", help="Smooth by a low-pass of this cutoff, or auto."
)
@click.option("--level", is_flag=True, help="Turn the floor level and put it at height 0.")
@force
@as_json
@common(searching=False)
def repair(inputs: tuple[str, ...], options: Options, filter_: float | str | None, **chosen: Any) -> None:
    """Mend a recording by remedies that have a name.

    Every change is told, and nothing else changes. Where no remedy is chosen, those that would help are suggested.
    With --swap-sides, left and right are exchanged in what is written.
    """
    remedies = {name: value for name, value in chosen.items() if value} | (
        {} if filter_ is None else {"filter": filter_}
    )
    if options.swap_sides:
        remedies["swap_sides"] = True
    _check_together(remedies)
    targets: dict[str, Path] = {}

    def check(given: Sequence[Input]) -> None:
        if options.output is not None and remedies:
            targets.update(copy_targets(given, options.output, force=options.force))

    def look(given: Input, progress: Progress) -> Answer:
        from leitmotion.api import info
        from leitmotion.api import repair as mend
        from leitmotion.motion import Trajectories

        reading = read_one(given, options, progress)
        recording, entries = reading.recordings[0], options.map_entries()
        problems = () if remedies else info(recording, body_map=entries).problems
        points = isinstance(recording, Trajectories)
        suggestion = one_command(problems, given, options, points=points)
        progress.say(f"Mending {given.path.name}")
        mended = mend(recording, **remedies, body_map=entries)
        target = targets.get(given.shown)
        kept, lost = ("", ()) if target is None else write_copy(mended.recording, target, force=options.force)
        parameters = reading_parameters(options.reading, reading.window)
        return Answer(
            source=[source_entry(given, frames=len(recording), rate=recording.rate)],
            parameters={**parameters, "remedies": remedies},
            result=repair_result(mended, written=target, suggestion=suggestion),
            show=lambda console: _show(console, mended, target, suggestion, asked=bool(remedies)),
            warnings=[*reading.warnings, *lost, *unused_skeleton(options, reading.findings)],
            written=[kept],
        )

    finish(answer_each("repair", inputs, options, look, check=check))


def _check_together(remedies: dict[str, Any]) -> None:
    if "frames" in remedies and "swap_sides" not in remedies:
        raise click.UsageError("--frames says where sides are swapped: give --swap-sides as well.")
    if "max_gap_s" in remedies and "fill" not in remedies:
        raise click.UsageError("--max-gap says which gaps are filled: give --fill as well.")


def _show(console: Console, mended: Repaired, target: Path | None, suggestion: str, *, asked: bool) -> None:
    from leitmotion.view.counting import plural

    if not asked:
        console.print("No remedy was chosen, so that nothing was changed.", style="bold")
        console.print(
            f"What would help:\n  {suggestion}" if suggestion else "No problem was found that one would mend."
        )
        return
    where = "; nothing was written: name a file with -o" if target is None else ""
    console.print(f"{plural(len(mended.changes), 'change')}{where}.", style="bold")
    rate = mended.recording.rate
    rows = [
        (
            change.what,
            change.joint or "all",
            f"{change.start}–{change.stop}",
            f"{change.start / rate:.2f}–{change.stop / rate:.2f} s",
            change.detail,
        )
        for change in mended.changes
    ]
    if rows:
        print_table(console, ("what", "joint", "frames", "time", "how"), rows)
    for remark in mended.remarks:
        console.print(f"Left: {remark}")
