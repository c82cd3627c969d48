"""``leitmotion info``: what a recording holds, and what is wrong with it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import click

from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.documents import Document, info_result, reading_parameters, source_entry
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options, as_json, common, examples, force, output, takes_inputs
from leitmotion.cli.outputs import TABLES, check_output, keep_table
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import unused_skeleton
from leitmotion.cli.suggestions import command_for

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Info

COLUMNS = (
    "path", "sha256", "frames", "rate", "seconds", "kind", "count", "people", "roles",
    "unit", "up", "handedness", "facing", "size", "problems", "error",
)  # fmt: skip
"""Columns of the table, one row per input; one that failed has its path and the error."""


@click.command(
    epilog=examples(
        "leitmotion info dance.bvh",
        "leitmotion info recordings/ -o recordings.csv",
    )
)
@takes_inputs
@output("Also write it, by the ending: .json, or .csv with one row per input.")
@force
@as_json
@common(searching=False)
def info(inputs: tuple[str, ...], options: Options) -> None:
    """Tell what a recording holds, and what is wrong with it.

    Says of each fact whether the file tells it or it was guessed, and why.
    """

    def look(given: Input, progress: Progress) -> Answer:
        from leitmotion.api import info as tell

        progress.say(f"Reading {given.path.name}")
        told = tell(
            given.source,
            **options.reading,
            body_map=options.map_entries(),
            swap_sides=options.swap_sides,
        )
        points = told.kind == "points"
        commands = [
            command_for(problem, given, options, people=told.people, points=points)
            for problem in told.problems
        ]
        return Answer(
            source=[source_entry(given, frames=told.frames, rate=told.rate)],
            parameters=reading_parameters(options.reading, told.window, swap_sides=options.swap_sides),
            result=info_result(told, commands),
            show=lambda console: _show(console, told, commands),
            warnings=[*told.warnings, *unused_skeleton(options, told.findings)],
        )

    def check(given: Sequence[Input]) -> None:
        if options.output is not None:
            check_output(options.output, given, endings=TABLES, force=options.force)

    outcome = answer_each("info", inputs, options, look, check=check)
    keep_table(outcome.documents, options, COLUMNS, _rows)
    finish(outcome)


def _show(console: Console, told: Info, commands: Sequence[str]) -> None:
    from leitmotion.view.counting import plural

    held = plural(len(told.names), "joint" if told.kind == "skeleton" else "point")
    held = f"A skeleton of {held}" if told.kind == "skeleton" else f"{held} in {told.dimensions} dimensions"
    length = f"{told.duration:.2f} s, {told.frames:,} frames at {told.rate:g} Hz"
    console.print(f"{held}; {length}.", style="bold")
    if len(told.people) > 1:
        console.print(f"It holds {len(told.people)} people: {', '.join(told.people)}. This is the first.")
    if not told.problems:
        console.print("No problem found.")
    for problem, command in zip(told.problems, commands, strict=True):
        console.print(f"Problem: {problem.message} {problem.remedy}".rstrip())
        if command:
            console.print(f"  {command}", style="dim")
    console.print()
    facts = [
        (what, _value(what, finding.value, told), finding.how, finding.reason)
        for what, finding in told.findings.items()
    ]
    if told.unseen:
        facts.append(("unseen", f"{told.unseen:.1%}", "read", "share of positions that are missing"))
    print_table(console, ("", "", "", ""), facts)
    _show_roles(console, told)


def _show_roles(console: Console, told: Info) -> None:
    known = {name for members in told.roles.members for name in members}
    rest = [name for name in told.names if name not in known]
    if told.roles.roles:
        console.print()
        rows = zip(told.roles.roles, told.roles.confidence, told.roles.members, strict=True)
        print_table(
            console,
            ("role", ">confidence", "joint or markers"),
            [(role, f"{sure:.2f}", ", ".join(members)) for role, sure, members in rows],
        )
    if rest:
        console.print()
        console.print(f"Without a role: {', '.join(rest)}.")


def _value(what: str, value: object, told: Info) -> str:
    if value is None:
        return "unknown"
    if not isinstance(value, float):
        return str(value)
    if what == "facing":
        return f"{round(math.degrees(value))}°"
    if what == "size":
        return f"{value:.2f} m" if told.findings["unit"].value not in ("px", "relative") else f"{value:.4g}"
    return f"{value:g} Hz" if what == "rate" else f"{value:g}"


def _rows(document: Document) -> Iterator[dict[str, object]]:
    """One row per input."""
    source = document["source"][0]
    if "error" in document:
        yield source | {"error": f"{document['error']['message']} {document['error']['remedy']}".strip()}
        return
    result = document["result"]
    kind = result["kind"]
    told = ("unit", "up", "handedness", "facing", "size")
    facts = {what: result.get(what, {}).get("value") for what in told}
    yield source | {
        "kind": kind,
        "count": result[kind]["count"],
        "people": len(result["people"]),
        "roles": len(result["roles"]),
        **facts,
        "problems": " ".join(problem["message"] for problem in result["problems"]),
    }
