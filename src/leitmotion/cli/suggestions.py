"""What to type next, with the names and the options that were typed now."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options

if TYPE_CHECKING:
    from leitmotion.repairs import Problem

MENDING = ("--swap-sides", "--duplicates", "--swaps", "--frozen", "--spikes", "--fill", "--level")
"""Remedies that problems suggest, in the order in which they are taken."""


def command_for(
    problem: Problem, given: Input, options: Options, *, people: Sequence[str] = (), points: bool = False
) -> str:
    """Say what to type to mend a problem; empty where nothing does.

    Parameters
    ----------
    problem : Problem
        What is wrong.
    given : Input
        The recording.
    options : Options
        How it was read: what was said then is said again.
    people : sequence of str
        Everyone in the file; of several the first is meant where none was chosen.
    points : bool
        Whether it was read as points, which not every format holds.

    Returns
    -------
    str
        A line for the shell.
    """
    said = {name: str(value) for name, value in options.reading.items()}
    if len(people) > 1 and "person" not in said:
        said["person"] = people[0]
    if options.body_map is not None:
        said["map"] = str(options.body_map)
    words: list[str] = []
    for name, value in said.items():
        if f"--{name}" not in problem.options:
            words += [f"--{name}"] if value == "True" else [f"--{name}", value]
    return problem.command(given.shown, mended_name(given, points=points), said=words)


def one_command(problems: Iterable[Problem], given: Input, options: Options, *, points: bool = False) -> str:
    """Put what mends several problems into one command; empty where no remedy would help.

    Parameters
    ----------
    problems : iterable of Problem
        What is wrong.
    given : Input
        The recording.
    options : Options
        How it was read.
    points : bool
        Whether it was read as points.

    Returns
    -------
    str
        A line for the shell.
    """
    from leitmotion.repairs import Problem

    wanted: dict[str, tuple[str, ...]] = {}
    for problem in problems:
        if problem.verb == "repair":
            for place, word in enumerate(problem.options):
                if word in MENDING:
                    wanted[word] = problem.options[place : place + (2 if word == "--fill" else 1)]
    if not wanted:
        return ""
    words = tuple(word for option in MENDING for word in wanted.get(option, ()))
    return command_for(Problem("", "", verb="repair", options=words), given, options, points=points)


def mended_name(given: Input, *, points: bool = False) -> str:
    """Suggest what a mended copy of an input is called, in the current folder."""
    return f"{given.name}-repaired{ending_of(given, points=points)}"


def ending_of(given: Input, *, points: bool = False) -> str:
    """Say what a mended copy of an input ends in: as the input does where such is written, else ``.npz``."""
    from leitmotion.io.formats import writable

    forms = writable()
    endings = (suffix.lower() for suffix in reversed(given.path.suffixes))
    fitting = (one for one in endings if one in forms and not (points and forms[one].of_skeletons))
    return next(fitting, ".npz")
