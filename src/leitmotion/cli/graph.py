"""``leitmotion graph``: the states that movements pass through, and the paths between them."""

from __future__ import annotations

import pathlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from statistics import median
from typing import TYPE_CHECKING

import click

from leitmotion.cli.batch import Answer, finish
from leitmotion.cli.documents import Document
from leitmotion.cli.finding import search
from leitmotion.cli.inputs import Input
from leitmotion.cli.mirror_options import weights
from leitmotion.cli.options import Options, as_json, common, examples, force, output, takes_inputs
from leitmotion.cli.outputs import (
    PICTURES,
    TABLES,
    check_output,
    keep_table,
    save_value,
    will_be_written,
    write_figure,
)
from leitmotion.cli.pages import write_page
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress, compiling_noted
from leitmotion.cli.recordings import Opened, open_one
from leitmotion.cli.sharing import short_names
from leitmotion.cli.together import Gathered, answer_together

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import MotionGraph
    from leitmotion.discovery import Path, State, Visit

ENDINGS = (*TABLES, ".html", ".graphml", ".npz", *PICTURES)
COLUMNS = (
    "path", "kind", "name", "source", "target", "symmetric", "reversible", "reversed", "mirror",
    "start", "stop", "start_s", "stop_s",
)  # fmt: skip
"""Columns of the table, one row per visit of a state and per time that a path was gone."""


@click.command(
    epilog=examples(
        "leitmotion graph dance.bvh",
        "leitmotion graph dance.bvh --racemize -o dance.svg",
        "leitmotion graph recordings/ -o vocabulary.graphml",
    )
)
@takes_inputs
@click.option(
    "--racemize",
    is_flag=True,
    help="Add the mirror images of states and paths, where they join what is there.",
)
@click.option(
    "--bias",
    type=click.Choice(["none", "mean", "standing"]),
    default="none",
    show_default=True,
    help="The posture by which the bias of the sides is measured, and taken out.",
)
@weights
@output(
    "Also write it, by the ending: .json (what is printed), .csv (a row per visit), .graphml, .npz, its picture as "
    ".svg, .png or .pdf; of one input .html."
)
@force
@as_json
@common(searching=False)
def graph(inputs: tuple[str, ...], racemize: bool, bias: str, options: Options) -> None:
    """Draw the states that movements pass through, and the paths between them.

    Several inputs make one graph: what they have in common is one state or one path. In the notation of paper S: a bar
    over what is symmetric, a star behind a mirror image, an arrow that tells whether a path was gone both ways.
    """

    def read(given: Input, asked: Options, progress: Progress) -> Opened:
        from leitmotion.features import extract

        opened = open_one(given, asked, progress)
        extract("kinematic_chain", opened.recording, opened.roles)  # says in its place why there is none
        return opened

    def look(gathered: Gathered, progress: Progress) -> Answer:
        from leitmotion.api import motion_graph
        from leitmotion.view import graph_document

        progress.say("Drawing the motion graph")
        with compiling_noted(progress):
            found = motion_graph(
                [one.recording for _, one in gathered.opened],
                names=short_names(gathered.names),
                weights=options.weights,
                bias=bias,
                racemize=racemize,
                body_map=[one.roles for _, one in gathered.opened],
            )
        kept = []
        if options.output is not None and options.output.suffix.lower() not in TABLES:
            progress.say(f"Writing {options.output.name}")
            kept.append(_write(options.output, found, gathered, options, progress))
        return Answer(
            source=[one.source[0] for _, one in gathered.opened],
            result=graph_document(found),
            show=lambda console: _show(console, found),
            parameters={**found.parameters, **gathered.parameters},
            warnings=gathered.warnings,
            written=kept,
        )

    def check(given: Sequence[Input]) -> None:
        if options.output is None:
            return
        check_output(options.output, given, endings=ENDINGS, force=options.force)
        if len(given) > 1 and options.output.suffix.lower() == ".html":
            raise click.UsageError(
                f"{options.output.name} shows one recording, but there are {len(given)}. Write the picture of them "
                f"all: -o {options.output.with_suffix('.svg')}."
            )

    outcome = answer_together("graph", inputs, options, look, check=check, read=read)
    keep_table(outcome.documents, options, COLUMNS, _rows)
    finish(outcome)


def _show(console: Console, found: MotionGraph) -> None:
    from leitmotion.discovery import notation, path_label, performed, state_label
    from leitmotion.view.counting import plural

    console.print(f"{plural(len(found.states), 'state')}, {plural(len(found.paths), 'path')}.", style="bold")
    if not found.states:
        console.print("The body keeps in no posture and turns back at none.")
        return
    console.print(notation(found))
    for k, name in enumerate(found.recordings):
        if line := performed(found, k):
            console.print(f"{name}: {line}" if len(found.recordings) > 1 else line)
    console.print()

    labels = {one.name: state_label(one) for one in found.states}
    labels |= {one.name: path_label(one) for one in found.paths}
    states = [
        (labels[one.name], "state", "", *_visits(one.visits, found), _image(one, labels))
        for one in found.states
    ]
    paths = [
        (
            labels[one.name],
            "path",
            f"{labels[one.source]} {'↔' if one.reversible else '→'} {labels[one.target]}",
            *_visits(one.visits, found),
            _image(one, labels),
        )
        for one in found.paths
    ]
    print_table(console, ("", "", "from and to", ">times", ">each", "mirror image"), [*states, *paths])


def _visits(visits: Sequence[Visit], found: MotionGraph) -> tuple[str, str]:
    """How often, and how long each time."""
    if not visits:
        return "", "by reflection"
    seconds = [(visit.stop - visit.start) / found.rates[visit.recording] for visit in visits]
    low, high = f"{min(seconds):.2f}", f"{max(seconds):.2f}"
    each = f"{low} s" if low == high else f"{low}–{high} s, mostly {median(seconds):.2f}"
    return str(len(visits)), each


def _image(one: State | Path, labels: Mapping[str, str]) -> str:
    return "itself" if one.mirror == one.name else labels.get(one.mirror, "")


def _write(
    path: pathlib.Path, found: MotionGraph, gathered: Gathered, options: Options, progress: Progress
) -> str:
    ending = path.suffix.lower()
    if ending == ".html":
        opened = gathered.opened[0][1]
        patterns = search(opened, replace(options, weights="equal"), progress)
        return write_page(path, opened, patterns, options, progress, opens_with="graph", graph=found)
    if ending == ".npz":
        return save_value(path, found)
    if ending == ".graphml":
        from leitmotion.io import write_whole
        from leitmotion.view import graphml

        told = will_be_written(path)
        write_whole(path, graphml(found))
        return told
    from leitmotion.view import plot_graph
    from leitmotion.view.graph_visited import most_visited, shown_of

    shown = [one for _, one in gathered.opened]
    figure = plot_graph(found, [one.recording for one in shown], body_maps=[one.roles for one in shown])
    return " ".join(filter(None, [write_figure(path, figure), shown_of(most_visited(found), found)]))


def _rows(document: Document) -> Iterator[Mapping[str, object]]:
    """One row per visit; a failure has none."""
    if "error" in document:
        return
    for kind, name in (("state", "states"), ("path", "paths")):
        for each in document["result"][name]:
            for visit in each["occurrences"]:
                path = document["source"][visit["recording"]]["path"]
                row = each | visit | {"path": path, "kind": kind}
                yield {column: row.get(column) for column in COLUMNS}
