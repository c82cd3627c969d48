"""``leitmotion similarity``: how alike the moments of a recording are, to one another or to their mirror images."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import click
from click.core import ParameterSource

from leitmotion.cli import mirrored, postures
from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.documents import Document
from leitmotion.cli.inputs import Input
from leitmotion.cli.mirror_options import MirrorOptions, mirror_options
from leitmotion.cli.mirrored import compare_mirrored
from leitmotion.cli.options import Options, as_json, common, examples, force, output, takes_inputs
from leitmotion.cli.outputs import PICTURES, TABLES, check_output, keep_table
from leitmotion.cli.postures import compare_postures
from leitmotion.cli.progress import Progress

OF_ONE = (".npz", *PICTURES)
"""Endings that hold one matrix."""
OF_MIRROR = ("form", "metric", "bias", "beta")
"""Options of --symmetry."""
NOT_OF_MIRROR = ("features", "joints", "exclude", "against")
"""Options that do not go with it."""
OF_FILES = ("joint_rotations", "marker_posture")
"""Features that need the joints or markers of the file itself, which differ from one to the next."""


@click.command(
    epilog=examples(
        "leitmotion similarity dance.bvh -o dance.png",
        "leitmotion similarity dance.bvh --against other.bvh -o both.npz",
        "leitmotion similarity dance.bvh --symmetry --form triangle -o mirror.svg",
        "leitmotion similarity recordings/ --symmetry -o mirror.csv",
    )
)
@takes_inputs
@click.option(
    "--against", metavar="INPUT", help="Compare with every moment of this recording, instead of with itself."
)
@click.option("--symmetry", is_flag=True, help="Compare with the mirror images as well: Z and Z* of paper S.")
@click.option(
    "--form",
    type=click.Choice(["square", "triangle"]),
    default="square",
    show_default=True,
    help="Of the picture of --symmetry.",
)
@mirror_options(of="--symmetry")
@output(
    "Also write it, by the ending: .json (what is printed), .csv (a row per moment); of one input .npz (the matrix) "
    "or its picture as .png, .svg or .pdf."
)
@force
@as_json
@common(searching=False, describing=True)
def similarity(
    inputs: tuple[str, ...], against: str | None, symmetry: bool, form: str, options: Options, **mirror: Any
) -> None:
    """Compare every moment of a recording with every other.

    About 30 moments a second are compared, fewer of a recording that is long.
    """
    _check_options(symmetry, against, options)
    ending = options.output.suffix.lower() if options.output is not None else ""
    other = None if against is None else _named(against)
    rows: dict[str, list[Document]] = {}

    def look(given: Input, progress: Progress) -> Answer:
        if symmetry:
            answer, rows[given.shown] = compare_mirrored(
                given, form, MirrorOptions(**mirror), options, progress
            )
        else:
            answer, rows[given.shown] = compare_postures(given, other, options, progress)
        return answer

    def check(given: Sequence[Input]) -> None:
        if options.output is None:
            return
        read = [*given, *([other] if other is not None else [])]
        check_output(options.output, read, endings=(*TABLES, *OF_ONE), force=options.force)
        if len(given) > 1 and ending in OF_ONE:
            raise click.UsageError(
                f"{options.output.name} holds one matrix, but there are {len(given)} recordings. Write a .csv or .json "
                "of them all."
            )

    def rows_of(document: Document) -> Iterable[Mapping[str, object]]:
        return rows.get(document["source"][0]["path"], ())

    outcome = answer_each("similarity", inputs, options, look, check=check)
    keep_table(outcome.documents, options, (mirrored if symmetry else postures).COLUMNS, rows_of)
    finish(outcome)


def _check_options(symmetry: bool, against: str | None, options: Options) -> None:
    context = click.get_current_context()

    def given(name: str) -> bool:
        return context.get_parameter_source(name) is not ParameterSource.DEFAULT

    if not symmetry and (alien := next(filter(given, OF_MIRROR), None)):
        raise click.UsageError(f"--{alien} belongs to --symmetry.")
    if symmetry and (alien := next(filter(given, NOT_OF_MIRROR), None)):
        raise click.UsageError(f"--{alien} does not go with --symmetry, which compares the whole chain.")
    if against is not None and options.features in OF_FILES:
        raise click.UsageError(f"--against does not go with --features {options.features}.")
    if against is not None and options.weights != "equal":
        raise click.UsageError(f"--against does not go with --weights {options.weights}.")


def _named(argument: str) -> Input:
    """The one recording that is compared with."""
    from leitmotion.io.sources import split_window

    path, ends = split_window(argument)
    return Input(argument, path, "" if ends is None else f"[{ends[0]}:{ends[1]}]")
