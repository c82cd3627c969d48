"""Where an answer is written: by its ending, whole or not at all, and never over something precious."""

from __future__ import annotations

import csv
import io as streams
import json
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from leitmotion.cli.documents import Document
from leitmotion.cli.inputs import Input
from leitmotion.cli.pages import is_ours

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Rows = Callable[[Document], Iterable[Mapping[str, object]]]


def check_output(path: Path, inputs: Sequence[Input], *, endings: Sequence[str], force: bool) -> None:
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
        Whether a page that Leitmotion did not write may be replaced.

    Raises
    ------
    click.UsageError
        When the ending is none of these, the file is an input or somebody else's page, or the place takes no file.
    """
    if path.suffix.lower() not in endings:
        raise click.UsageError(
            f"Cannot tell what to write from {path.name!r}: end it in {', '.join(endings)}."
        )
    check_place(path)
    if not path.exists():
        return
    if path.is_dir():
        raise click.UsageError(f"{path} is a folder, not a file to write.")
    if any(given.path.exists() and path.samefile(given.path) for given in inputs):
        raise click.UsageError(f"{path} is an input, and inputs are never written over.")
    if path.suffix.lower() == ".html" and not force and not is_ours(path):
        raise click.UsageError(f"{path} exists, and Leitmotion did not write it. Replace it with --force.")


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


def write_documents(path: Path, documents: list[Document], columns: Sequence[str], rows: Rows) -> None:
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
    """
    from leitmotion.io import write_whole

    if path.suffix.lower() == ".json":
        held = documents[0] if len(documents) == 1 else documents
        write_whole(path, json.dumps(held, indent=1, allow_nan=False) + "\n")
    else:
        write_whole(path, _table(columns, [row for document in documents for row in rows(document)]))


def write_figure(path: Path, figure: Figure) -> None:
    """Write a figure as a picture, in the format that the ending says."""
    from leitmotion.io import write_whole

    picture = streams.BytesIO()
    figure.savefig(picture, format=path.suffix.lower().removeprefix("."), dpi=200)
    write_whole(path, picture.getvalue())


def _table(columns: Sequence[str], rows: Iterable[Mapping[str, Any]]) -> str:
    out = streams.StringIO()
    writer = csv.DictWriter(out, fieldnames=columns, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return out.getvalue()
