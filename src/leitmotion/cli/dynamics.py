"""``leitmotion dynamics``: momentum and energy of a body, and how well a recording of a jump obeys physics."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from leitmotion.cli.batch import Answer, answer_each, finish
from leitmotion.cli.documents import SECONDS_DIGITS, Document, curve, stretch
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options, Positive, as_json, common, examples, force, output, takes_inputs
from leitmotion.cli.outputs import (
    PICTURES,
    check_output,
    keep_table,
    save_value,
    tell_written,
    will_be_written,
    write_figure,
)
from leitmotion.cli.printing import print_table
from leitmotion.cli.progress import Progress
from leitmotion.cli.recordings import open_one

if TYPE_CHECKING:
    from rich.console import Console

    from leitmotion.api import Dynamics

OF_ONE = (".npz", *PICTURES)
"""Endings that hold one recording."""
SIDED = ("upper_arm", "forearm", "hand", "thigh", "shank", "foot")
SEGMENTS = (
    "pelvis",
    "abdomen",
    "thorax",
    "head",
    *(f"{side}_{limb}" for side in ("left", "right") for limb in SIDED),
)
WHOLE = (
    "x", "y", "z", "px", "py", "pz", "lx", "ly", "lz", "kinetic_linear", "kinetic_angular", "potential",
)  # fmt: skip
OWN = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "px", "py", "pz", "lx", "ly", "lz", *WHOLE[-3:])
COLUMNS = (
    "path", "frame", "time_s", *(f"body_{what}" for what in WHOLE),
    *(f"{segment}_{what}" for segment in SEGMENTS for what in OWN),
)  # fmt: skip
"""Columns of the table, one row per frame of each input."""
TOLD = 12
"""Flights that a person is told at most."""


@click.command(
    epilog=examples(
        "leitmotion dynamics jump.bvh --mass 62",
        "leitmotion dynamics jump.bvh --mass 62 --sex female -o jump.png",
        "leitmotion dynamics recordings/ -o momenta.csv",
    )
)
@takes_inputs
@click.option("--mass", type=Positive(), metavar="KG", help="Of the body; 70 by default, which says so.")
@click.option(
    "--sex",
    type=click.Choice(["mean", "female", "male"]),
    default="mean",
    show_default=True,
    help="Whose table of segment masses is used (de Leva 1996).",
)
@click.option(
    "--cutoff",
    type=click.FloatRange(min=0),
    metavar="HZ",
    help="Of the filter before differentiation; 10 by default, 0 for none.",
)
@output(
    "Also write it, by the ending: .json (what is printed), .csv (a row per frame); of one input .npz, or the curves "
    "as .png, .svg or .pdf."
)
@force
@as_json
@common(searching=False)
def dynamics(
    inputs: tuple[str, ...], mass: float | None, sex: str, cutoff: float | None, options: Options
) -> None:
    """Compute momentum and energy of a body in motion.

    The body is 16 rigid segments. Between take-off and landing of a jump the recording is judged by physics: the centre
    of mass falls with g, the angular momentum is constant.
    """
    ending = options.output.suffix.lower() if options.output is not None else ""
    lines: list[str] = []

    def look(given: Input, progress: Progress) -> Answer:
        from leitmotion.api import dynamics as compute

        opened = open_one(given, options, progress)
        progress.say(f"Weighing {given.path.name}")
        found = compute(
            opened.recording,
            mass=mass,
            sex=sex,
            cutoff_hz="usual" if cutoff is None else cutoff or None,
            body_map=opened.roles,
        )
        kept = []
        if options.output is not None and ending in OF_ONE:
            kept.append(_write_one(options.output, found))
        if ending == ".csv":
            lines.extend(_rows(given.shown, found))
        result = dynamics_result(found)
        return Answer(
            source=opened.source,
            result=result,
            show=lambda console: _show(console, found, result),
            parameters={**found.parameters, **opened.parameters},
            warnings=[*opened.warnings, *_remarks(found)],
            written=kept,
        )

    def check(given: Sequence[Input]) -> None:
        if options.output is None:
            return
        check_output(options.output, given, endings=(".json", ".csv", *OF_ONE), force=options.force)
        if len(given) > 1 and ending in OF_ONE:
            raise click.UsageError(
                f"{options.output.name} holds one recording, but there are {len(given)}. Write a .csv or .json of "
                "them all."
            )

    outcome = answer_each("dynamics", inputs, options, look, check=check)
    if options.output is not None and ending == ".csv" and lines:
        from leitmotion.io import write_whole

        told = will_be_written(options.output)
        write_whole(options.output, "\n".join([",".join(COLUMNS), *lines, ""]))
        tell_written(told, options)
    elif ending == ".json":
        keep_table(outcome.documents, options, (), lambda _: ())
    finish(outcome)


def dynamics_result(found: Dynamics) -> Document:
    """Make the result of the verb `dynamics`: summary figures, what each segment weighs, and the flights."""
    import numpy as np

    turning = found.angular_energies.sum(axis=1)
    curves = {
        "height_m": found.centre_of_mass[:, 1],
        "speed_m_s": np.linalg.norm(found.linear_momentum, axis=1) / found.mass,
        "linear_momentum_kg_m_s": np.linalg.norm(found.linear_momentum, axis=1),
        "angular_momentum_kg_m2_s": np.linalg.norm(found.angular_momentum, axis=1),
        "kinetic_energy_j": found.kinetic_energy,
        "turning_energy_j": turning,
        "potential_energy_j": found.potential_energy,
    }
    gravity = [flight.gravity for flight in found.flights]
    return {
        "mass_kg": found.mass,
        "mass_given": found.parameters["mass_given"],
        "body": {what: curve(values, found.rate) for what, values in curves.items()},
        "segments": [
            {
                "segment": segment,
                "mass_kg": found.masses[k],
                "inertia_kg_m2": found.inertias[k],
                "kinetic_energy_j": curve(
                    found.linear_energies[:, k] + found.angular_energies[:, k], found.rate
                ),
                "speed_m_s": curve(np.linalg.norm(found.velocities[:, k], axis=1), found.rate),
            }
            for k, segment in enumerate(found.segments)
        ],
        "flights": [
            {
                **stretch(flight.start, flight.stop, rate=found.rate, label="flight"),
                "gravity_m_s2": flight.gravity,
                "gravity_error": flight.gravity_error,
                "residual_m": flight.residual,
                "angular_momentum_kg_m2_s": flight.angular_momentum,
                "drift_kg_m2_s": flight.drift,
                "drift_share": flight.drift_share,
            }
            for flight in found.flights
        ],
        "gravity_m_s2": float(np.median(gravity)) if gravity else None,
        "drift_share": float(np.median([flight.drift_share for flight in found.flights]))
        if gravity
        else None,
    }


def _remarks(found: Dynamics) -> list[str]:
    """What a person should know about the answer."""
    told = []
    if not found.parameters["mass_given"]:
        told.append(
            f"The mass was not given: {found.mass:g} kg is assumed, so that of momenta and energies only ratios are "
            "facts. Give it with --mass KG."
        )
    unseen = found.parameters["unseen_frames"]
    if unseen:
        told.append(f"In {unseen} of {len(found)} frames a joint is unseen; nothing is computed there.")
    return told


def _show(console: Console, found: Dynamics, result: dict[str, Any]) -> None:
    from leitmotion.view.counting import plural

    body = result["body"]
    lumped = found.parameters["lumped"]
    console.print(f"{found.mass:g} kg in {len(found.segments)} segments; {_filter(found)}.", style="bold")
    rows = [
        (name, f"{body[key]['mean']:{form}}", f"{body[key]['least']:{form}}", f"{body[key]['most']:{form}}",
         f"{body[key]['most_at_s']:.2f} s", unit)
        for name, key, form, unit in (
            ("height of the centre of mass", "height_m", ".3f", "m"),
            ("its speed", "speed_m_s", ".2f", "m/s"),
            ("linear momentum", "linear_momentum_kg_m_s", ".1f", "kg m/s"),
            ("angular momentum", "angular_momentum_kg_m2_s", ".2f", "kg m²/s"),
            ("kinetic energy", "kinetic_energy_j", ".1f", "J"),
            ("of it, turning of segments", "turning_energy_j", ".1f", "J"),
            ("potential energy", "potential_energy_j", ".0f", "J"),
        )
    ]  # fmt: skip
    print_table(console, ("", ">mean", ">least", ">most", ">at", ""), rows)
    if lumped:
        console.print(f"Without joints of their own: {', '.join(name.replace('_', ' ') for name in lumped)}.")
    console.print()
    if not found.flights:
        console.print("No flight was found, by which physics would judge the recording.")
        return
    console.print(
        f"{plural(len(found.flights), 'flight')}: the centre of mass falls with {result['gravity_m_s2']:.2f} m/s² "
        f"({_percent(found.flights)}; it should be 9.81), and the angular momentum strays by "
        f"{result['drift_share']:.1%} of what the segments carry."
    )
    flights = [
        (f"{flight.start / found.rate:.2f}–{flight.stop / found.rate:.2f} s", f"{flight.gravity:.2f}",
         f"{flight.gravity_error:+.1%}", f"{1000 * flight.residual:.1f} mm",
         f"{math.hypot(*flight.angular_momentum):.2f}", f"{flight.drift:.2f}", f"{flight.drift_share:.1%}")
        for flight in found.flights[:TOLD]
    ]  # fmt: skip
    headings = ("flight", ">g, m/s²", ">error", ">off the parabola", ">angular momentum", ">strays", ">share")
    print_table(console, headings, flights)
    if len(found.flights) > TOLD:
        console.print(f"{len(found.flights) - TOLD} more are in the JSON.")


def _percent(flights: Sequence[Any]) -> str:
    errors = sorted(flight.gravity_error for flight in flights)
    return f"{errors[0]:+.1%}" if len(errors) == 1 else f"{errors[0]:+.1%} to {errors[-1]:+.1%}"


def _filter(found: Dynamics) -> str:
    cutoff = found.parameters["cutoff_hz"]
    return "not filtered" if cutoff is None else f"filtered by a zero-lag low-pass at {cutoff:g} Hz"


def _write_one(path: Path, found: Dynamics) -> str:
    if path.suffix.lower() in PICTURES:
        from leitmotion.view import plot_dynamics

        return write_figure(path, plot_dynamics(found))
    return save_value(path, found)


def _rows(path: str, found: Dynamics) -> list[str]:
    """One line per frame; an unseen number is an empty cell."""
    import csv
    import io

    import numpy as np

    whole = np.column_stack(
        (
            found.centre_of_mass,
            found.linear_momentum,
            found.angular_momentum,
            found.linear_energies.sum(axis=1),
            found.angular_energies.sum(axis=1),
            found.potential_energy,
        )
    )
    own = np.concatenate(
        (
            found.centres,
            found.velocities,
            found.angular_velocities,
            found.linear_momenta,
            found.angular_momenta,
            np.stack((found.linear_energies, found.angular_energies, found.potential_energies), axis=-1),
        ),
        axis=-1,
    )
    values = np.column_stack((whole, own.reshape(len(found), -1)))
    out = io.StringIO()
    csv.writer(out, lineterminator="").writerow([path])
    named = out.getvalue()
    form = ",".join(["%.9g"] * values.shape[1])
    return [
        f"{named},{frame},{frame / found.rate:.{SECONDS_DIGITS}f},{(form % tuple(row)).replace('nan', '')}"
        for frame, row in enumerate(values)
    ]
