"""``leitmotion report``: write the page that shows what recurs."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.documents import patterns_result
from leitmotion.cli.finding import search, warnings_of
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options, as_json, common, examples, force, output, takes_inputs
from leitmotion.cli.outputs import check_output
from leitmotion.cli.pages import open_page, write_page
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import Opened, open_one

if TYPE_CHECKING:
    from leitmotion.api import Segmentation


@click.command(
    epilog=examples(
        "leitmotion report dance.bvh --open",
        "leitmotion report recordings/ -o pages/",
    )
)
@takes_inputs
@output(
    "The page to write, or a folder for pages of several inputs. By default NAME.html in the current folder.",
    folder=True,
)
@click.option(
    "--labels",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Labels from elsewhere (.csv, .json, .eaf, .txt), shown in a lane of their own.",
)
@click.option("--tier", metavar="NAME", help="Which tier of an .eaf, where it has several; '*' for all.")
@click.option("--open", "open_it", is_flag=True, help="Open the page in the browser.")
@force
@as_json
@common()
def report(
    inputs: tuple[str, ...],
    labels: Path | None,
    tier: str | None,
    open_it: bool,
    options: Options,
) -> None:
    """Write the page that shows what recurs.

    One HTML file that opens in any browser, needs nothing beside it, and sends nothing anywhere.
    """
    pages: dict[str, Path] = {}

    def check(given: Sequence[Input]) -> None:
        pages.update(_pages(given, options.output))
        if labels is not None and len(given) > 1:
            raise click.UsageError(f"--labels belongs to one recording, but there are {len(given)}.")
        for page in pages.values():
            check_output(page, given, endings=(".html",), force=options.force)

    def look(given: Input, progress: Progress) -> Answer:
        from leitmotion.view.words import title

        opened = open_one(given, options, progress)
        lane, notes = (None, []) if labels is None else _read_labels(labels, tier, opened)
        found = search(opened, options, progress)
        page = pages[given.shown]
        kept = write_page(
            page,
            opened,
            found,
            options,
            progress,
            labels=lane,
            labels_from="" if labels is None else labels.name,
            notes=notes,
        )
        if open_it and not open_page(page):
            progress.note_once("There is no screen here to open the page on.")
        return Answer(
            source=opened.source,
            result=patterns_result(found) | {"written": str(page)},
            show=lambda console: console.print(f"{title(found)}.", style="bold"),
            parameters={**found.parameters, **opened.parameters},
            warnings=[*warnings_of(opened, found), *notes],
            written=[kept],
        )

    finish(answer_each("report", inputs, options, look, check=check))


def _read_labels(path: Path, tier: str | None, opened: Opened) -> tuple[Segmentation, list[str]]:
    """Read labels of the whole file, keep those of the window that was read, and say how many are not, or not whole."""
    from leitmotion.api import Segmentation, read_annotations

    labels = read_annotations(path, rate=opened.recording.rate, trial=opened.recording.name, tier=tier)
    first, frames = opened.first_frame, len(opened.recording)
    inside = (labels.starts < first + frames) & (labels.stops > first)
    kept = Segmentation(
        starts=(labels.starts[inside] - first).clip(min=0),
        stops=(labels.stops[inside] - first).clip(max=frames),
        labels=tuple(itertools.compress(labels.labels, inside)),
        scores=labels.scores[inside],
        rate=labels.rate,
    )
    notes, read = [], f"the {opened.recording.duration:.2f} s that were read"
    if not inside.all():
        lost = f"{len(labels) - len(kept)} of {len(labels)} labels in {path.name}"
        notes.append(f"Not shown: {lost}, outside {read}.")
    cut = inside & ((labels.starts < first) | (labels.stops > first + frames))
    if cut.any():
        names = ", ".join(dict.fromkeys(itertools.compress(labels.labels, cut)))
        notes.append(f"Cut: {int(cut.sum())} labels in {path.name} ({names}) reach beyond {read}.")
    return kept, notes


def _pages(inputs: Sequence[Input], output: Path | None) -> dict[str, Path]:
    """Say which page each input is written to; two inputs of one name get pages of two names."""
    if output is not None and len(inputs) == 1 and output.suffix and not output.is_dir():
        return {inputs[0].shown: output}
    if output is not None and output.suffix and not output.is_dir():
        raise click.UsageError(
            f"{output} names one file, but there are {len(inputs)} recordings. "
            f"Name a folder: -o {output.with_suffix('')}."
        )
    if output is not None and output.exists() and not output.is_dir():
        raise click.UsageError(f"{output} is neither a folder nor a file that ends in .html.")
    pages: dict[str, Path] = {}
    for given in inputs:
        names = itertools.chain((given.name,), (f"{given.name}-{count}" for count in itertools.count(2)))
        candidates = ((output or Path()) / f"{name}.html" for name in names)
        pages.setdefault(given.shown, next(page for page in candidates if page not in pages.values()))
    return pages
