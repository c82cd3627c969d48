"""``leitmotion symmetry``: what a movement is like in space and in time, in the motifs of paper S."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from leitmotion.cli import shares as table_of_shares
from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.documents import SCORE_DIGITS, SECONDS_DIGITS, Document, decimals, stretch
from leitmotion.cli.finding import search
from leitmotion.cli.inputs import Input
from leitmotion.cli.mirror_options import MirrorOptions, mirror_options, weights
from leitmotion.cli.mirrored import bias_entry, bias_remarks, bias_sentence
from leitmotion.cli.options import Options, Positive, as_json, common, examples, force, output, takes_inputs
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
from leitmotion.cli.shares import shares_of, shares_rows, show_shares

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Mirrored, MotionGraph, Segmentation, Symmetry, SymmetrySpan

OF_ONE = (".html", ".eaf", ".npz", *PICTURES)
"""Endings of what shows a single recording."""
COLUMNS = (
    "path", "motif", "start", "stop", "start_s", "stop_s", "score", "cyclic",
    "partner_start", "partner_stop", "partner_start_s", "partner_stop_s", "side", "left_share", "links", "reason",
)  # fmt: skip
"""Columns of the table, one row per stretch."""
TOLD = 40
"""Stretches that a person is told at most."""
STRIKES = 12
"""Strikes that a person is told at most."""


@click.command(
    epilog=examples(
        "leitmotion symmetry dance.bvh",
        "leitmotion symmetry dance.bvh --bias standing -o dance.eaf",
        "leitmotion symmetry recordings/ --shares -o shares.csv",
    )
)
@takes_inputs
@mirror_options()
@weights
@click.option(
    "--min-still",
    type=Positive(),
    metavar="SECONDS",
    default=0.5,
    show_default=True,
    help="How long stillness lasts at least.",
)
@click.option(
    "--shares",
    is_flag=True,
    help="Write a row per recording: its symmetry index, and which share of its time each motif takes.",
)
@output(
    "Also write what was found, by the ending: .json or .csv; of one input .html, .eaf (ELAN), .png, .svg, "
    ".pdf or .npz."
)
@force
@as_json
@common(searching=False)
def symmetry(
    inputs: tuple[str, ...], min_still: float, shares: bool, options: Options, **mirror: Any
) -> None:
    """Tell how a movement treats the two sides, and how it returns.

    The motifs of paper S: which stretches alternate sides, move both together, go out and back, come again as they were
    or as their mirror image.
    """
    asked = MirrorOptions(**mirror)
    ending = options.output.suffix.lower() if options.output is not None else ""
    if shares and ending != ".csv":
        raise click.UsageError("--shares says what stands in a table: give -o with a name that ends in .csv.")

    def look(given: Input, progress: Progress) -> Answer:
        opened = open_one(given, options, progress)
        progress.say(f"Looking for symmetry in {opened.body.name}")
        with compiling_noted(progress):
            made, found, graph = _find(opened, asked, min_still, options)
        result = symmetry_result(found, made, graph)
        kept = []
        if options.output is not None and ending in OF_ONE:
            progress.say(f"Writing {options.output.name}")
            kept.append(_write_one(options.output, opened, found, made, graph, options, progress))
        return Answer(
            source=opened.source,
            result=result,
            show=lambda console: _show(console, found, result),
            parameters={**found.parameters, **opened.parameters},
            warnings=[*opened.warnings, *bias_remarks(made.bias)],
            written=kept,
        )

    def check(given: Sequence[Input]) -> None:
        if options.output is None:
            return
        check_output(options.output, given, endings=TABLES + OF_ONE, force=options.force)
        if len(given) > 1 and ending in OF_ONE:
            raise click.UsageError(
                f"{options.output.name} shows one recording, but there are {len(given)}. Write a .csv or .json of "
                "them all."
            )

    outcome = answer_each("symmetry", inputs, options, look, check=check)
    columns, rows = (table_of_shares.COLUMNS, shares_rows) if shares else (COLUMNS, _rows)
    if not options.as_json:
        show_shares(outcome.documents)
    keep_table(outcome.documents, options, columns, rows)
    finish(outcome)


def _find(
    opened: Opened, asked: MirrorOptions, min_still: float, options: Options
) -> tuple[Mirrored, Symmetry, MotionGraph]:
    """Compare with the mirror image, name the motifs, and draw the motion graph."""
    from leitmotion.api import compare_with_mirror, find_symmetry, motion_graph

    how: dict[str, Any] = {
        "metric": asked.metric,
        "weights": options.weights,
        "bias": asked.bias,
        "beta": asked.beta,
        "body_map": opened.roles,
    }
    made = compare_with_mirror(opened.recording, **how)
    found = find_symmetry(opened.recording, mirrored=made, min_still_s=min_still, **how)
    graph = motion_graph(opened.recording, weights=options.weights, bias=asked.bias, body_map=opened.roles)
    return made, found, graph


def symmetry_result(found: Symmetry, made: Mirrored, graph: MotionGraph) -> Document:
    """Make the result of the verb `symmetry`."""
    import numpy as np

    from leitmotion.discovery import notation
    from leitmotion.similarity import symmetry_index

    rate = found.rate
    return {
        "spans": [
            {
                **stretch(span.start, span.stop, rate=rate, label=span.motif, score=span.confidence),
                "motif": span.motif,
                "cyclic": span.cyclic,
                "partner": None
                if span.partner is None
                else stretch(*span.partner, rate=rate, label=span.motif, score=span.confidence),
                "marks": span.marks,
                "side": span.side or None,
                "left_share": None if span.left_share is None else decimals(span.left_share, SCORE_DIGITS),
                "links": list(span.links),
                "reason": span.reason,
            }
            for span in found.spans
        ],
        "notation": notation(graph),
        "strikes": [
            {"frame": int(frame), "time_s": round(float(frame) / rate, SECONDS_DIGITS)}
            for frame in found.strikes
        ],
        "shares": shares_of(found),
        "symmetry_index": decimals(symmetry_index(made.distances), SCORE_DIGITS),
        "beta": made.distances.beta,
        "half_alike_deg": float(np.degrees(made.distances.half_angle)),
        "bias": bias_entry(made.bias),
    }


def _show(console: Console, found: Symmetry, result: Document) -> None:
    from leitmotion.view.counting import clock
    from leitmotion.view.symmetry_answer import LOOKED_FOR, symmetry_lead, symmetry_title

    console.print(f"{symmetry_title(found)}.", style="bold")
    console.print(symmetry_lead(found))
    if found.spans:
        console.print()
        headings = ("from and to", "", "motif", ">confidence", "side", "again at")
        print_table(console, headings, [_told(span, found.rate) for span in _clearest(found.spans)])
    else:
        console.print(LOOKED_FOR, style="dim")
    if len(found.spans) > TOLD:
        console.print(f"{len(found.spans) - TOLD} more, which tell less, are in the JSON.")
    if len(found.strikes):
        console.print(_struck([clock(frame / found.rate) for frame in found.strikes]))
    if result["notation"]:
        console.print(f"States and paths: {result['notation']}")
    if (index := result["symmetry_index"]) is not None:
        console.print(f"Symmetry index {index:.2f}: its likeness to its mirror image, over that to itself.")
    if sentence := bias_sentence(result["bias"]):
        console.print(sentence)


def _clearest(spans: Sequence[SymmetrySpan]) -> list[SymmetrySpan]:
    """Those that a person is told, in order of time: first what tells how the sides move, the surest of it."""
    from leitmotion.view.symmetry_words import CHIEF

    best = sorted(spans, key=lambda span: (span.motif in CHIEF, span.confidence), reverse=True)[:TOLD]
    return [span for span in spans if span in best]


def _told(span: SymmetrySpan, rate: float) -> tuple[str, ...]:
    """Make a row of the table that a person reads: the plain name, and the thesis's term."""
    from leitmotion.view.symmetry_words import TOLD as WORDS
    from leitmotion.view.symmetry_words import limb_words, motif_name

    limbs = limb_words(span.links)
    return (
        _when(span.start, span.stop, rate),
        motif_name(span),
        WORDS[span.motif].term + (", cyclic" if span.cyclic and not span.motif.endswith("cycle") else ""),
        f"{span.confidence:.2f}",
        f"{span.side}: {limbs}" if limbs else span.side,
        _when(*span.partner, rate) if span.partner else "",
    )


def _struck(when: Sequence[str]) -> str:
    """Say at which moments a fast movement is stopped or thrown back at once: the first, and how many more."""
    more = f", and {len(when) - STRIKES} times more" if len(when) > STRIKES else ""
    return f"Stops or turns abruptly (strikes) at {', '.join(when[:STRIKES])}{more}."


def _when(start: int, stop: int, rate: float) -> str:
    """Write a stretch, or the one moment that it is to a tenth of a second."""
    from leitmotion.view.counting import clock

    first, last = clock(start / rate), clock(stop / rate)
    return first if first == last else f"{first}–{last}"


def _write_one(
    path: Path,
    opened: Opened,
    found: Symmetry,
    made: Mirrored,
    graph: MotionGraph,
    options: Options,
    progress: Progress,
) -> str:
    ending = path.suffix.lower()
    if ending == ".html":
        patterns = search(opened, replace(options, weights="equal"), progress)
        return write_page(
            path,
            opened,
            patterns,
            options,
            progress,
            opens_with="symmetry",
            mirrored=made,
            symmetry=found,
            graph=graph,
        )
    if ending == ".npz":
        return save_value(path, found)
    if ending == ".eaf":
        from leitmotion.io import write_annotations

        told = will_be_written(path)
        write_annotations(_as_labels(found, opened.first_frame), path, tier="motifs")
        return told
    from leitmotion.view import plot_motifs

    return write_figure(path, plot_motifs(found))


def _as_labels(found: Symmetry, first: int) -> Segmentation:
    """Give each stretch the name of its motif, both of a pair, in frames of the whole file, as ELAN plays it."""
    import numpy as np

    from leitmotion.api import Segmentation

    held = [
        (start, stop, span)
        for span in found.spans
        for start, stop in ((span.start, span.stop), *(() if span.partner is None else (span.partner,)))
    ]
    return Segmentation(
        starts=np.array([start + first for start, _, _ in held], dtype=np.int64),
        stops=np.array([stop + first for _, stop, _ in held], dtype=np.int64),
        labels=tuple(span.motif for _, _, span in held),
        scores=np.array([span.confidence for _, _, span in held]),
        rate=found.rate,
    )


def _rows(document: Document) -> Iterator[dict[str, object]]:
    """One row per stretch; a failure has none."""
    if "error" in document:
        return
    path = document["source"][0]["path"]
    for span in document["result"]["spans"]:
        partner = {f"partner_{name}": value for name, value in (span["partner"] or {}).items()}
        row = {"path": path} | span | partner | {"links": " ".join(span["links"])}
        yield {column: row.get(column) for column in COLUMNS}
