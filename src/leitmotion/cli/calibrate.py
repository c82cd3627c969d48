"""``leitmotion calibrate``: from labelled pairs of postures to how near alike postures are."""

from __future__ import annotations

import math
import shlex
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.documents import Document, calibrate_result, reading_parameters, source_entry
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options, as_json, common, examples, force, output, some
from leitmotion.cli.outputs import PICTURES, TABLES, check_output, keep_table, write_figure
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Calibration
    from leitmotion.calibration import Looked

COLUMNS = ("threshold", "false_match", "false_non_match")
"""Columns of the table, one row per threshold."""
FEW = 20
"""Pairs of either kind below which the intervals say too little: resampled, a few pairs never show what they lack."""


@click.command(
    epilog=examples(
        "leitmotion calibrate pairs.csv",
        "leitmotion calibrate pairs.csv dance.bvh -o errors.png",
        "leitmotion calibrate pairs.csv --group fit --check check --features joint_angles",
    )
)
@click.argument("pairs", metavar="PAIRS", callback=some)
@click.argument("recording", metavar="[INPUT]", required=False, callback=some)
@click.option(
    "--folder",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    metavar="DIR",
    help="Where the recordings are that the pairs name, when not beside the table.",
)
@click.option("--group", metavar="NAME", help="Calibrate on the pairs of this group.")
@click.option("--check", "check_group", metavar="NAME", help="Try the threshold on the pairs of this group.")
@output("Also write the error curves, by the ending: .png, .svg, .pdf, .csv or .json.")
@force
@as_json
@common(searching=False, describing=True)
def calibrate(
    pairs: str,
    recording: str | None,
    folder: Path | None,
    group: str | None,
    check_group: str | None,
    options: Options,
) -> None:
    """Tell from labelled pairs how near alike postures are.

    PAIRS is a table with the columns recording_a, frame_a, recording_b, frame_b, alike (1 or 0), and perhaps person and
    group. Without the columns of recordings, INPUT is the one that the pairs are of.
    """

    def look(given: Input, progress: Progress) -> Answer:
        from leitmotion.calibration import concluded, measure
        from leitmotion.features import FEATURES

        progress.say(f"Measuring the pairs of {given.path.name}")
        measured = measure(
            given.path,
            recording,
            group=group,
            check=check_group,
            folder=Path() if folder is None and given.shown == "-" else folder,
            body_map=options.map_entries(),
            swap_sides=options.swap_sides,
            **options.describing,
            **options.reading,
        )
        found = concluded(measured)
        unit = FEATURES[options.features].measured_in
        kept = []
        if options.output is not None and options.output.suffix.lower() in PICTURES:
            from leitmotion.view import plot_calibration

            kept.append(write_figure(options.output, plot_calibration(found, measured_in=unit)))
        asked = {"group": group, "check": check_group, "joints": options.joints, "exclude": options.exclude}
        return Answer(
            source=[_source(looked) for looked in measured.recordings],
            result=calibrate_result(found, measured_in=unit),
            show=lambda console: _show(console, found, unit, options),
            parameters={
                "pairs": given.shown,
                "features": options.features,
                "weights": options.weights,
                **{name: value for name, value in asked.items() if value},
                **reading_parameters(options.reading, None, swap_sides=options.swap_sides),
            },
            warnings=[
                f"{looked.source}: {each}" for looked in measured.recordings for each in looked.warnings
            ]
            + _few(found),
            written=kept,
        )

    def check(given: Sequence[Input]) -> None:
        from leitmotion.io.sources import split_window

        if len(given) != 1 or given[0].shown != pairs or given[0].path.is_dir():
            raise click.UsageError(
                f"PAIRS is one table of labelled pairs, and {pairs} is a folder or an archive."
            )
        if options.output is not None:
            others = [] if recording is None else [Input(recording, split_window(recording)[0])]
            check_output(options.output, [*given, *others], endings=PICTURES + TABLES, force=options.force)

    outcome = answer_each("calibrate", [pairs], options, look, check=check)
    keep_table(outcome.documents, options, COLUMNS, _rows)
    finish(outcome)


def _source(looked: Looked) -> Document:
    from leitmotion.io.sources import split_window

    given = Input(looked.source, split_window(looked.source)[0])
    return source_entry(given, frames=looked.frames, rate=looked.rate)


def _show(console: Console, found: Calibration, unit: str, options: Options) -> None:
    from leitmotion.view.counting import plural

    what = "Moments" if options.features == "velocity" else "Postures"
    console.print(f"{what} at most {found.threshold:.3g} {unit} apart are alike.", style="bold")
    rows = [
        ("threshold", f"{found.threshold:.3g}", _between(found.threshold_interval, "{:.3g}"), unit),
        (
            "equal error rate",
            f"{found.equal_error_rate:.1%}",
            _between(found.rate_interval, "{:.1%}"),
            f"of {plural(found.alike, 'pair')} alike and {found.not_alike} not",
        ),
    ]
    if found.check is not None:
        check = found.check
        kinds = f"{check.false_non_match:.1%} of {plural(check.alike, 'pair')} alike missed"
        rows.append(
            (
                "error of the check group",
                f"{check.error:.1%}",
                _between(check.interval, "{:.1%}"),
                f"{kinds}, {check.false_match:.1%} of {check.not_alike} others taken for alike",
            )
        )
    print_table(console, ("", ">", "95 %", ""), rows)
    compared = {
        "--features": options.features if options.features != "posture" else "",
        "--weights": options.weights if options.weights != "equal" else "",
        "--joints": ",".join(options.joints),
        "--exclude": ",".join(options.exclude),
        "--max-distance": f"{found.threshold:.3g}",
    }
    given = [word for option, value in compared.items() if value for word in (option, value)]
    console.print(f"To search with it: leitmotion patterns INPUT {shlex.join(given)}")


def _few(found: Calibration) -> list[str]:
    """Say that a threshold of a few pairs is not to be relied on, however narrow its interval."""
    if min(found.alike, found.not_alike) >= FEW:
        return []
    told = f"{found.alike} alike and {found.not_alike} not"
    return [
        f"So few pairs, {told}, settle no threshold, however narrow the interval: label about a hundred of each."
    ]


def _between(interval: tuple[float, float], form: str) -> str:
    low, high = (form.format(end) for end in interval)
    return "" if math.isnan(interval[0]) else f"{low} to {high}"


def _rows(document: Document) -> Iterator[dict[str, object]]:
    """One row per threshold; a failure has none."""
    if "error" not in document:
        yield from document["result"]["curve"]
