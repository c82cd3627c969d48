"""``leitmotion patterns --lesson``: what to learn first, and how each time differs from the typical one."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import click

from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.documents import COST_DIGITS, SCORE_DIGITS, Document, patterns_result, stretch
from leitmotion.cli.finding import search, show_patterns, warnings_of
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options
from leitmotion.cli.outputs import TABLES, check_output, keep_table, will_be_written
from leitmotion.cli.pages import write_page
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import open_one

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Lesson, Segmentation

OF_ONE = (".html", ".eaf")
COLUMNS = (
    "path", "rank", "pattern", "kind", "role", "occurrence", "start", "stop", "start_s", "stop_s",
    "distance", "apart_cm", "tempo", "lag_s", "lag_at", "shift_s", "joint", "joint_apart_cm", "joint_at", "words",
)  # fmt: skip
"""Columns of the table, one row per occurrence, the typical one of each pattern first."""


def lesson_option(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the option ``--lesson``."""
    return click.option(
        "--lesson",
        is_flag=True,
        help="Tell what to learn first, and how each time differs from the typical one: .csv, .json; of one "
        "input .html or .eaf.",
    )(command)


def teach(inputs: tuple[str, ...], options: Options) -> None:
    """Answer each input with its lesson.

    Parameters
    ----------
    inputs : tuple of str
        As typed.
    options : Options
        How to read, search and answer.
    """

    def check(given: Sequence[Input]) -> None:
        if options.output is None:
            return
        check_output(options.output, given, endings=TABLES + OF_ONE, force=options.force)
        if len(given) > 1 and options.output.suffix.lower() in OF_ONE:
            raise click.UsageError(
                f"{options.output.name} shows one recording, but there are {len(given)}. Write a .csv or .json of "
                "them all."
            )

    def look(given: Input, progress: Progress) -> Answer:
        from leitmotion.api import make_lesson

        opened = open_one(given, options, progress)
        found = search(opened, options, progress)
        progress.say(f"Comparing what recurs in {opened.body.name}")
        lesson = make_lesson(opened.body, found, joints=options.joints or None, exclude=options.exclude)
        out = options.output
        kept = []
        if out is not None and out.suffix.lower() == ".html":
            kept.append(write_page(out, opened, found, options, progress, opens_with="lesson"))
        if out is not None and out.suffix.lower() == ".eaf":
            from leitmotion.io import write_annotations

            kept.append(will_be_written(out))
            write_annotations(_as_labels(lesson, opened.first_frame), out, tier="lesson")

        def show(console: Console) -> None:
            if lesson.steps:
                _show(console, lesson)
            else:
                show_patterns(console, found, seconds=opened.source[0]["seconds"], body=opened.body)

        return Answer(
            source=opened.source,
            result=patterns_result(found) | {"lesson": _steps(lesson)},
            show=show,
            parameters={**found.parameters, **opened.parameters},
            warnings=warnings_of(opened, found),
            written=kept,
        )

    outcome = answer_each("patterns", inputs, options, look, check=check)
    keep_table(outcome.documents, options, COLUMNS, _rows)
    finish(outcome)


def _steps(lesson: Lesson) -> list[Document]:
    from leitmotion.view.lesson import variation_words

    def lengths(distance: float) -> Document:
        metres = round(distance * lesson.scale, COST_DIGITS) if lesson.unit == "m" else None
        return {"distance": round(distance, COST_DIGITS), "apart_m": metres}

    return [
        {
            "rank": rank,
            "pattern": step.pattern,
            "kind": step.kind,
            "count": step.count,
            "seconds": round(step.seconds, SCORE_DIGITS),
            "typical": stretch(step.start, step.stop, rate=lesson.rate, label=step.pattern)
            | {"occurrence": step.typical + 1},
            "variations": [
                stretch(each.start, each.stop, rate=lesson.rate, label=step.pattern)
                | {"occurrence": each.occurrence + 1}
                | lengths(each.distance)
                | {
                    "tempo": round(each.tempo, SCORE_DIGITS),
                    "lag_s": round(each.lag_s, SCORE_DIGITS),
                    "lag_at": round(each.lag_phase, SCORE_DIGITS),
                    "shift_s": round(each.shift_s, SCORE_DIGITS),
                    "differences": [
                        {"joint": one.joint}
                        | lengths(one.distance)
                        | {
                            "at": round(one.phase, SCORE_DIGITS),
                            "offset": [round(float(part), COST_DIGITS) for part in one.offset],
                        }
                        for one in each.differences
                    ],
                    "words": variation_words(each, lesson),
                }
                for each in step.variations
            ],
        }
        for rank, step in enumerate(lesson.steps, start=1)
    ]


def _show(console: Console, lesson: Lesson) -> None:
    from leitmotion.view.counting import clock, plural
    from leitmotion.view.lesson import length_words, step_words, variation_words

    console.print(f"{plural(len(lesson), 'movement')} to learn, most frequent first.", style="bold")
    for rank, step in enumerate(lesson.steps, start=1):
        typical = f"{clock(step.start / lesson.rate)}–{clock(step.stop / lesson.rate)}"
        console.print()
        console.print(f"{rank}. {step.pattern}, {step_words(step)}. Typical: {typical}.")
        print_table(
            console,
            ("from and to", ">apart", "against the typical one"),
            [
                (
                    f"{clock(each.start / lesson.rate)}–{clock(each.stop / lesson.rate)}",
                    length_words(each.distance, lesson),
                    ", ".join(variation_words(each, lesson)),
                )
                for each in step.variations
            ],
        )


def _as_labels(lesson: Lesson, first: int) -> Segmentation:
    """Each time with its words, in frames of the whole file, as ELAN plays it."""
    import numpy as np

    from leitmotion.api import Segmentation
    from leitmotion.view.lesson import variation_words

    spans = [
        span
        for step in lesson.steps
        for span in [
            (step.start, step.stop, f"{step.pattern}: typical"),
            *(
                (each.start, each.stop, f"{step.pattern}: {', '.join(variation_words(each, lesson))}")
                for each in step.variations
            ),
        ]
    ]
    return Segmentation(
        np.array([start + first for start, _, _ in spans], dtype=np.int64),
        np.array([stop + first for _, stop, _ in spans], dtype=np.int64),
        tuple(words for _, _, words in spans),
        rate=lesson.rate,
    )


def _rows(document: Document) -> Iterator[dict[str, object]]:
    """One row per occurrence, the typical one of each pattern before the others; a failure has none."""
    if "error" in document:
        return
    path = document["source"][0]["path"]
    for step in document["result"]["lesson"]:
        typical = step | step["typical"] | {"path": path, "role": "typical"}
        yield {column: typical.get(column, "") for column in COLUMNS}
        for each in step["variations"]:
            row = step | each | {"path": path, "role": "variation"}
            row |= {"apart_cm": _centimetres(each["apart_m"]), "words": "; ".join(each["words"])}
            if each["differences"]:
                most = each["differences"][0]
                row |= {
                    "joint": most["joint"],
                    "joint_apart_cm": _centimetres(most["apart_m"]),
                    "joint_at": most["at"],
                }
            yield {column: row.get(column, "") for column in COLUMNS}


def _centimetres(metres: float | None) -> float | str:
    return "" if metres is None else round(100 * metres, 2)
