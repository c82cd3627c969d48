"""The postures of a recording beside one another, or beside those of another: figures, a row per moment, the matrix."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from leitmotion.cli.batch import Answer
from leitmotion.cli.documents import COST_DIGITS, SCORE_DIGITS, SECONDS_DIGITS, Document, decimals
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options
from leitmotion.cli.outputs import PICTURES, save_value, write_figure
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress, compiling_noted
from leitmotion.cli.recordings import Opened, open_one

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.similarity import SimilarityMatrix

COLUMNS = (
    "path", "frame", "time_s", "share_alike", "nearest_frame", "nearest_time_s", "nearest_distance",
)  # fmt: skip
"""Columns of the table, one row per moment of each input."""
APART_S = 1.0
"""The nearest moment of the same recording is so many seconds away at least: neighbours are alike anyhow."""
LONGEST = 17
"""Letters of a recording's name that fit into a title with another."""


def compare_postures(
    given: Input, other: Input | None, options: Options, progress: Progress
) -> tuple[Answer, list[Document]]:
    """Answer how alike the moments of an input are, and make its rows of the table.

    Parameters
    ----------
    given : Input
        The recording.
    other : Input or None
        Another, whose moments it is compared with.
    options : Options
        What is compared.
    progress : Progress
        Told what is being done.
    """
    from leitmotion.api import compare

    opened = open_one(given, options, progress)
    beside = opened if other is None else open_one(other, options, progress)
    recording, roles = opened.compared_by(options.features)
    against, their_roles = beside.compared_by(options.features)
    progress.say(f"Comparing the moments of {given.path.name}")
    with compiling_noted(progress):
        matrix = compare(
            recording,
            None if other is None else against,
            body_map=roles,
            other_map=their_roles,
            **options.describing,
        )
    rows = _rows(given, opened, beside, matrix, options)
    result = _result(opened, beside, matrix, rows, options)
    kept = []
    if options.output is not None and options.output.suffix.lower() in (".npz", *PICTURES):
        progress.say(f"Writing {options.output.name}")
        kept.append(_write(options.output, matrix, None if other is None else (given.name, other.name)))
    warnings = [(given, told) for told in opened.warnings]
    if other is not None:
        warnings += [(other, told) for told in beside.warnings]
    answer = Answer(
        source=opened.source if other is None else [*opened.source, *beside.source],
        result=result,
        show=lambda console: _show(console, result),
        parameters={
            **{name: value for name, value in options.describing.items() if value},
            "metric": matrix.metric,
            **({"nearest_apart_s": APART_S} if other is None else {}),
            **opened.parameters,
        },
        warnings=[told if other is None else f"{one.shown}: {told}" for one, told in warnings],
        written=kept,
    )
    return answer, rows


def _rows(
    given: Input, opened: Opened, beside: Opened, matrix: SimilarityMatrix, options: Options
) -> list[Document]:
    """One row per moment; what is not known is an empty cell."""
    from leitmotion.similarity import counterparts, shares_alike

    alike = _alike(options)
    shares = None if alike is None else shares_alike(matrix, alike)
    nearest = counterparts(matrix, apart_s=APART_S if beside is opened else 0.0)
    every, theirs = _frames_a_moment(opened, beside, matrix)
    return [
        {
            "path": given.shown,
            "frame": k * every,
            "time_s": round(k * every / opened.recording.rate, SECONDS_DIGITS),
            "share_alike": None if shares is None else decimals(shares[k], SCORE_DIGITS),
            "nearest_frame": None if place < 0 else place * theirs,
            "nearest_time_s": None
            if place < 0
            else round(place * theirs / beside.recording.rate, SECONDS_DIGITS),
            "nearest_distance": decimals(distance, COST_DIGITS),
        }
        for k, (place, distance) in enumerate(
            zip(nearest.places.tolist(), nearest.distances.tolist(), strict=True)
        )
    ]


def _result(
    opened: Opened, beside: Opened, matrix: SimilarityMatrix, rows: list[Document], options: Options
) -> Document:
    """Make the result of the verb `similarity` about postures."""
    import numpy as np

    from leitmotion.features import FEATURES

    known = matrix.values[np.isfinite(matrix.values)]
    shares = [row["share_alike"] for row in rows if row["share_alike"] is not None]
    paired = [row for row in rows if row["nearest_distance"] is not None]
    nearest = min(paired, key=lambda row: float(row["nearest_distance"]), default=None)
    return {
        "moments": matrix.values.shape,
        "frames_a_moment": _frames_a_moment(opened, beside, matrix),
        "measured_in": FEATURES[options.features].measured_in,
        "scale": matrix.scale,
        "unit": matrix.unit,
        "median": float(np.median(known)) if known.size else None,
        "most": float(known.max()) if known.size else None,
        "alike": _alike(options),
        "share_alike": round(float(np.mean(shares)), SCORE_DIGITS) if shares else None,
        "nearest": nearest
        and {name: nearest[name] for name in COLUMNS if name not in ("path", "share_alike")},
    }


def _alike(options: Options) -> float | None:
    """From which distance on moments are alike; None where nobody has measured it."""
    from leitmotion.features import FEATURES

    return FEATURES[options.features].alike.get(options.weights)


def _frames_a_moment(opened: Opened, beside: Opened, matrix: SimilarityMatrix) -> tuple[int, int]:
    return (
        round(opened.recording.rate / matrix.row_rate),
        round(beside.recording.rate / matrix.column_rate),
    )


def _write(path: Path, matrix: SimilarityMatrix, names: tuple[str, str] | None) -> str:
    if path.suffix.lower() == ".npz":
        return save_value(path, matrix)
    from leitmotion.view import plot_matrix

    if names is None:
        return write_figure(path, plot_matrix(matrix))
    down, right = (name if len(name) <= LONGEST else f"{name[: LONGEST - 1]}…" for name in names)
    return write_figure(path, plot_matrix(matrix, title=f"{down} (down), {right} (right)"))


def _show(console: Console, result: Document) -> None:
    from leitmotion.view.counting import clock

    rows, columns = result["moments"]
    console.print(f"{rows} moments compared with {columns}.", style="bold")
    unit = result["measured_in"]
    told = []
    if result["share_alike"] is not None:
        told.append(
            ("share alike", f"{result['share_alike']:.1%}", f"at most {result['alike']:g} {unit} apart")
        )
    if result["median"] is not None:
        told.append(("usual distance", f"{result['median']:.3f}", f"{unit}, the median over all pairs"))
        told.append(("largest distance", f"{result['most']:.3f}", unit))
    if (nearest := result["nearest"]) is not None:
        when = f"{clock(nearest['time_s'])} and {clock(nearest['nearest_time_s'])}"
        told.append(("nearest two", f"{nearest['nearest_distance']:.3f}", f"{unit}, at {when}"))
    print_table(console, ("", ">", ""), told)
