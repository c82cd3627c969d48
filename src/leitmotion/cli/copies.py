"""A recording made of each input, mended or shortened: where it is written, and that it is written whole."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from leitmotion.cli.inputs import Input
from leitmotion.cli.outputs import check_output, will_be_written
from leitmotion.cli.suggestions import ending_of
from leitmotion.cli.targets import plan

if TYPE_CHECKING:
    from leitmotion.api import Motion, Trajectories


def copy_targets(given: Sequence[Input], output: Path, *, force: bool) -> dict[str, Path]:
    """Say which file is made of each input: in a folder as it stands under the folder that was named.

    Parameters
    ----------
    given : sequence of Input
        What is read.
    output : Path
        What ``-o`` names: a file of one input, or a folder.
    force : bool
        Whether a file that holds something else may be replaced.

    Returns
    -------
    dict of str to Path
        The file by the input as it was typed.

    Raises
    ------
    click.UsageError
        When one file is named for several inputs, or a file could not or should not be written.
    """
    from leitmotion.io.formats import writable

    if output.suffix and not output.is_dir():
        if len(given) > 1:
            raise click.UsageError(
                f"{output} names one file, but there are {len(given)} recordings. "
                f"Name a folder: -o {output.with_suffix('')}."
            )
        check_output(output, given, endings=tuple(writable()), force=force, recording=True)
        return {given[0].shown: output}
    targets = {}
    for one, place in zip(given, plan(given, output, "").paths, strict=True):
        ending = ending_of(one)
        named = place.name.lower().endswith(ending)  # where two inputs differ by nothing else
        targets[one.shown] = place if named else place.with_name(place.name + ending)
    for target in targets.values():
        check_output(target, given, endings=tuple(writable()), force=force, recording=True)
    return targets


def write_copy(recording: Motion | Trajectories, path: Path, *, force: bool) -> tuple[str, tuple[str, ...]]:
    """Write a recording, and say so, and what its format does not keep of it.

    Parameters
    ----------
    recording : Motion or Trajectories
        What is written.
    path : Path
        The file; its ending names the format.
    force : bool
        Whether a file that holds something else may be replaced.

    Returns
    -------
    str
        What to tell of the file.
    tuple of str
        A sentence for each thing that is not kept.

    Raises
    ------
    DataError
        When the file holds something else, and it is not to be replaced.
    ParameterError
        When the format does not hold such a recording.
    """
    from leitmotion.conversion import put, refuse_other, written_as

    content, lost = written_as(recording, path.suffix.lower())
    refuse_other(path, content, force=force, by="--force")
    told = will_be_written(path)
    put(path, content, force=force)
    return told, tuple(f"{path.name}: {each.detail}" for each in lost)
