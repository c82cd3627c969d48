"""Where an answer is written: by its ending, whole or not at all, and never over something precious.

One rule for every verb that writes. An input is never written over. A file that is there is replaced without a
question where it says itself that Leitmotion wrote it (:mod:`leitmotion.cli.ours`), or where it is empty; a recording,
which says nothing, where it holds what would be written. Anything else is replaced only by ``--force``. That, and
whether the place takes a file, is looked at before any work. A folder that is missing is made. Every file that was
written is told on a line of its own.
"""

from __future__ import annotations

import contextlib
import csv
import io as streams
import json
import os
import re
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from leitmotion.cli.documents import Document
from leitmotion.cli.inputs import Input
from leitmotion.cli.ours import CREATOR, is_ours

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from leitmotion.cli.options import Options
    from leitmotion.motion.noun import Noun

TABLES = (".json", ".csv")
"""Endings that hold the answers about all inputs."""
PICTURES = (".png", ".svg", ".pdf")
Rows = Callable[[Document], Iterable[Mapping[str, object]]]


def check_output(
    path: Path, inputs: Sequence[Input], *, endings: Sequence[str], force: bool, recording: bool = False
) -> None:
    """Refuse, before any work, an output that could not or should not be written.

    Parameters
    ----------
    path : Path
        The file to be written.
    inputs : sequence of Input
        What is read; none of it is ever written over.
    endings : sequence of str
        The endings that the verb writes.
    force : bool
        Whether a file that Leitmotion did not write may be replaced.
    recording : bool
        Whether a recording is written, which is compared with what is there when it is known.

    Raises
    ------
    click.UsageError
        When the ending is none of these, the file is an input or somebody else's, or the place takes no file.
    """
    if path.suffix.lower() not in endings:
        raise click.UsageError(
            f"Cannot tell what to write from {path.name!r}: end it in {', '.join(endings)}."
        )
    check_place(path)
    if not path.exists():
        return
    if not path.is_file():
        what = "a folder" if path.is_dir() else "a device or a pipe"
        raise click.UsageError(f"{path} is {what}, not a file to write.")
    if any(given.path.exists() and path.samefile(given.path) for given in inputs):
        raise click.UsageError(f"{path} is an input, and inputs are never written over.")
    if not recording and not force and not is_ours(path):
        raise click.UsageError(
            f"{path} is there, and does not say that Leitmotion wrote it. Replace it with --force."
        )


def check_place(path: Path) -> None:
    """Refuse a place where no file can be made, by making one in the folder that is there, and taking it away."""
    try:
        path.exists()  # raises for a name that is too long
        folder = next(folder for folder in path.parents if folder.exists())
        if not folder.is_dir():
            raise click.UsageError(f"{path} cannot be written: {folder} is a file, not a folder.")
        with tempfile.NamedTemporaryFile(prefix=f".{path.name[:50]}.", suffix=".part", dir=folder):
            pass
    except OSError as error:
        raise click.UsageError(
            f"{path} cannot be written: {path.parent} takes no such file ({error.strerror})."
        ) from None


def will_be_written(path: Path) -> str:
    """Say what to tell once a file is written; asked before, when its folder may be missing.

    Parameters
    ----------
    path : Path
        Where.

    Returns
    -------
    str
        For example ``"Wrote found/dance.csv, in a new folder."``
    """
    return f"Wrote {path}{'' if path.parent.exists() else ', in a new folder'}."


def tell_written(sentence: str, options: Options) -> None:
    """Print what was written, where no document stands: on standard error beside documents, unless quiet."""
    if sentence and not (options.as_json and options.quiet):
        with reader_may_leave(options):
            click.echo(sentence, err=options.as_json)


@contextlib.contextmanager
def reader_may_leave(options: Options) -> Iterator[None]:
    """Print to a reader who may leave the pipe, which is no reason not to write a file that was asked for as well."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        if options.output is None:
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def keep_table(documents: list[Document], options: Options, columns: Sequence[str], rows: Rows) -> None:
    """Write the answers about all inputs, where ``-o`` names a document or a table, and tell so."""
    if options.output is not None and options.output.suffix.lower() in TABLES:
        tell_written(write_documents(options.output, documents, columns, rows), options)


def write_documents(path: Path, documents: list[Document], columns: Sequence[str], rows: Rows) -> str:
    """Write what was found: as JSON (one document, or the list of them), or as one table.

    Parameters
    ----------
    path : Path
        Ends in .json or .csv.
    documents : list of dict
        The documents of the contract, in order.
    columns : sequence of str
        The columns of the table.
    rows : callable
        Gives the rows of the table that one document stands for, be it an answer or a failure.

    Returns
    -------
    str
        What to tell; empty where every input failed and a table would be empty, which is not written.
    """
    from leitmotion.io import write_whole

    if path.suffix.lower() == ".json":
        held = documents[0] if len(documents) == 1 else documents
        text = json.dumps(held, indent=1, allow_nan=False) + "\n"
    else:
        lines = [row for document in documents for row in rows(document)]
        if not lines and all("error" in document for document in documents):
            return ""
        text = _table(columns, lines)
    told = will_be_written(path)
    write_whole(path, text)
    return told


def write_figure(path: Path, figure: Figure) -> str:
    """Write a figure as a picture, in the format that the ending says; say what to tell."""
    from matplotlib import rc_context

    from leitmotion.io import write_whole

    form = path.suffix.lower().removeprefix(".")
    made_by = {
        "png": {"Software": CREATOR},
        "svg": {"Creator": CREATOR, "Date": None},
        "pdf": {"Creator": CREATOR, "CreationDate": None},
    }
    picture = streams.BytesIO()
    with rc_context({"svg.hashsalt": CREATOR}):  # whose ids are random otherwise
        figure.savefig(picture, format=form, dpi=200, metadata=made_by[form])
    told = will_be_written(path)
    write_whole(path, _rounded(picture.getvalue()) if form == "svg" else picture.getvalue())
    return told


def _rounded(drawing: bytes) -> bytes:
    """Write the places of an SVG's outlines to a hundredth of a point; finer than that nothing is seen."""

    def shorter(found: re.Match[bytes]) -> bytes:
        return f"{float(found[0]):.2f}".rstrip("0").rstrip(".").encode()

    return re.sub(rb' d="[^"]*"', lambda outline: re.sub(rb"-?\d+\.\d{3,}", shorter, outline[0]), drawing)


def save_value(path: Path, value: Noun) -> str:
    """Write a value of the library, to be loaded again; say what to tell."""
    from leitmotion.api import save

    told = will_be_written(path)
    save(value, path)
    return told


def _table(columns: Sequence[str], rows: Iterable[Mapping[str, Any]]) -> str:
    out = streams.StringIO()
    writer = csv.DictWriter(out, fieldnames=columns, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return out.getvalue()
