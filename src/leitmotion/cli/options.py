"""The options that every verb takes, gathered into one value each."""

from __future__ import annotations

import functools
import json
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click

from leitmotion.cli.failures import show_traceback


@dataclass(frozen=True)
class Options:
    """What was asked for beside the verb and its inputs.

    Parameters
    ----------
    skeleton, unit, up, rate, person : str, float or None
        How to read: what the file does not say, or says wrongly.
    trust : bool
        Whether files that hold pickled Python objects are read.
    body_map : Path or None
        A JSON file that names the joint or markers of each role.
    swap_sides : bool
        Whether what is called left is the person's right.
    joints, exclude : tuple of str
        Which roles to compare, and which to leave out.
    features, weights : str
        What of a frame is compared, and whether each joint counts alike.
    method : str
        How to search.
    max_distance, threshold : float or None
        What counts as alike, for the method recurrence and for the method tang2008.
    min_duration : float or None
        The shortest stretch that counts, seconds.
    stillness : bool
        Whether a posture held again counts.
    as_json, quiet, traceback, force : bool
        How to answer.
    output : Path or None
        Where to write.
    """

    skeleton: str | None = None
    unit: str | None = None
    up: str | None = None
    rate: float | None = None
    person: str | None = None
    trust: bool = False
    body_map: Path | None = None
    swap_sides: bool = False
    joints: tuple[str, ...] = ()
    exclude: tuple[str, ...] = ()
    features: str = "posture"
    weights: str = "equal"
    method: str = "recurrence"
    max_distance: float | None = None
    threshold: float | None = None
    min_duration: float | None = None
    stillness: bool = False
    as_json: bool = False
    quiet: bool = False
    traceback: bool = False
    force: bool = False
    output: Path | None = None

    @property
    def reading(self) -> dict[str, Any]:
        """The keyword arguments that every reader takes, those that were given."""
        names = ("skeleton", "unit", "up", "rate", "person", "trust")
        return {name: value for name in names if (value := getattr(self, name)) not in (None, False)}

    @property
    def searching(self) -> dict[str, Any]:
        """The keyword arguments of the search, those that were given."""
        owners = {"stillness": "recurrence", "max_distance": "recurrence", "threshold": "tang2008"}
        for name, owner in owners.items():
            if getattr(self, name) and self.method != owner:
                raise click.UsageError(f"--{name.replace('_', '-')} belongs to --method {owner}.")
        given = {**self.describing, "method": self.method, "min_duration_s": self.min_duration}
        given |= {name: getattr(self, name) for name in owners if getattr(self, name)}
        return {name: value for name, value in given.items() if name != "min_duration_s" or value is not None}

    @property
    def describing(self) -> dict[str, Any]:
        """The keyword arguments that say what is compared."""
        return {
            "features": self.features,
            "weights": self.weights,
            "joints": self.joints or None,
            "exclude": self.exclude,
        }

    def map_entries(self) -> Mapping[str, Any] | None:
        """Read the map file, None when none was given."""
        if self.body_map is None:
            return None
        try:
            entries = json.loads(self.body_map.read_text(encoding="utf-8"))
        except (ValueError, OSError) as error:
            raise click.BadParameter(f"cannot read {self.body_map}: {error}", param_hint="--map") from error
        if not isinstance(entries, dict):
            raise click.BadParameter(
                f'{self.body_map} must hold an object such as {{"left_knee": "LKnee"}}.', param_hint="--map"
            )
        return entries


def _names(ctx: click.Context, param: click.Parameter, value: tuple[str, ...]) -> tuple[str, ...]:
    """Split what was given at commas: ``--joints head,neck --joints pelvis`` is three names."""
    named = [[name.strip() for name in given.split(",") if name.strip()] for given in value]
    if not all(named):
        raise click.BadParameter(f"{value[named.index([])]!r} names no role.", ctx, param)
    return tuple(name for names in named for name in names)


def known_unit(ctx: click.Context, param: click.Parameter, value: str | None) -> str | None:
    """Refuse what names no unit; whether pixels fit is for the recording to say."""
    if value is None:
        return None
    from leitmotion.io.conform import IMAGE_UNITS
    from leitmotion.io.units import unit_in_metres
    from leitmotion.motion.errors import ParameterError

    try:
        if value not in IMAGE_UNITS:
            unit_in_metres(value)
    except ParameterError as error:
        raise click.BadParameter(error.message, ctx, param) from None
    return value


def some(ctx: click.Context, param: click.Parameter, value: Any) -> Any:
    """Refuse an empty name, which would be taken for the current folder."""
    if "" in ((value,) if isinstance(value, str) else value or ()):
        raise click.UsageError("No input named: one is empty, as when a shell variable is not set.", ctx)
    return value


class Positive(click.FloatRange):
    """A number above 0 that is finite: a range alone lets NaN and infinity pass."""

    def __init__(self) -> None:
        super().__init__(min=0, min_open=True)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Take a number, refuse any other."""
        number = super().convert(value, param, ctx)
        if not math.isfinite(number):
            self.fail(f"{value!r} is no finite number.", param, ctx)
        return number


class _Axis(click.Choice):
    """An axis with its sign."""

    def __init__(self) -> None:
        super().__init__(["x", "y", "z", "-x", "-y", "-z"], case_sensitive=False)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        return super().convert(value.removeprefix("+"), param, ctx)


takes_inputs = click.argument("inputs", nargs=-1, required=True, metavar="INPUT...", callback=some)
_FILE = click.Path(exists=True, dir_okay=False)
_READING = (
    click.option("--person", metavar="NAME", help="Which person of a file that holds several."),
    click.option(
        "--skeleton", type=_FILE, metavar="FILE", help="The ASF file of an AMC, when it is not beside it."
    ),
    click.option(
        "--unit",
        callback=known_unit,
        metavar="UNIT",
        help="Unit of length: m, cm, mm, inch, … when the file does not tell.",
    ),
    click.option(
        "--up",
        type=_Axis(),
        metavar="AXIS",
        help="The axis that points up: x, y, z, -x, -y or -z, when the file does not tell.",
    ),
    click.option(
        "--rate", type=Positive(), metavar="HZ", help="Frames per second, when the file does not tell."
    ),
    click.option(
        "--trust",
        is_flag=True,
        help="Read files that hold pickled Python objects, which can run code: only from people you trust.",
    ),
    click.option(
        "--map",
        "body_map",
        type=click.Path(exists=True, dir_okay=False, path_type=Path),
        help='JSON file that names the joint or markers of each role: {"left_knee": "LKnee", …}.',
    ),
)
_SIDES = (
    click.option(
        "--swap-sides", is_flag=True, help="Take what is called left for right, and right for left."
    ),
)
_DESCRIBING = (
    click.option(
        "--features",
        type=click.Choice(
            [
                "posture",
                "velocity",
                "joint_angles",
                "limb_directions",
                "joint_rotations",
                "kinematic_chain",
                "marker_posture",
            ]
        ),
        default="posture",
        show_default=True,
        help="What of a frame is compared.",
    ),
    click.option(
        "--weights",
        type=click.Choice(["equal", "active"]),
        default="equal",
        show_default=True,
        help="Whether each joint counts alike, or the more the more it moves.",
    ),
    click.option(
        "--joints",
        multiple=True,
        callback=_names,
        metavar="ROLES",
        help="Compare only these roles; with wildcards, as in 'left_*,head'. `info` lists them.",
    ),
    click.option("--exclude", multiple=True, callback=_names, metavar="ROLES", help="Leave these roles out."),
)
_SEARCHING = (
    click.option(
        "--method",
        type=click.Choice(["recurrence", "tang2008"]),
        default="recurrence",
        show_default=True,
        help="How to search: with nothing to set, or as Tang et al. (2008) describe it.",
    ),
    click.option(
        "--max-distance",
        type=Positive(),
        metavar="X",
        help="How far apart moments may be that are alike. By default 0.054 body sizes of posture, 0.23 body sizes a "
        "second of velocity, 0.222 radians of joint_angles, 0.25 radians of limb_directions, 0.126 double radians of "
        "joint_rotations; with --weights active 0.086, 0.319, 0.318, 0.288, 0.159; with --across 0.35 of "
        "limb_directions, 0.08 of posture; without a default of kinematic_chain, and of marker_posture, in metres. "
        "`calibrate` tells another.",
    ),
    click.option(
        "--threshold",
        type=Positive(),
        metavar="T",
        help="The same for --method tang2008, as a share of the largest distance; 0.26 by default.",
    ),
    click.option(
        "--min-duration",
        type=Positive(),
        metavar="SECONDS",
        help="The shortest stretch that counts; 0.5 by default.",
    ),
    click.option("--stillness", is_flag=True, help="Let a posture that is held again count as a pattern."),
)
_ANSWERING = (
    click.option("--quiet", "-q", is_flag=True, help="No progress and no remarks; the answer alone."),
    click.option(
        "--traceback",
        is_flag=True,
        envvar="LEITMOTION_TRACEBACK",
        help="Show where in the program an error arose.",
    ),
)
force = click.option("--force", is_flag=True, help="Replace a file that is there and not from Leitmotion.")
as_json = click.option(
    "--json", "as_json", is_flag=True, help="Print one JSON document per input, one per line."
)


def common(
    *, searching: bool = True, describing: bool = False, sides: bool = True
) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Give a command the options that every verb takes, passed on as one :class:`Options`.

    Parameters
    ----------
    searching : bool
        Whether the verb looks for what recurs, so that the search may be steered.
    describing : bool
        Whether it compares moments without a search, so that only what is compared may be chosen.
    sides : bool
        Whether the verb asks which side is left.

    Returns
    -------
    callable
        A decorator; the command it makes receives ``options`` instead of the single values.
    """
    compared = _DESCRIBING if searching or describing else ()
    wanted = compared + (_SEARCHING if searching else ()) + _READING + (_SIDES if sides else ()) + _ANSWERING
    return _gathering(wanted)


def _gathering(wanted: tuple[Callable[..., Any], ...]) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    def decorate(command: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(command)
        def gathered(**given: Any) -> Any:
            fields = {name: given.pop(name) for name in Options.__dataclass_fields__ if name in given}
            options = Options(**fields)
            try:
                return command(options=options, **given)
            except (click.ClickException, click.exceptions.Exit):
                raise
            except Exception as error:
                if options.traceback:
                    show_traceback(error)
                raise

        made: Callable[..., Any] = gathered
        for option in reversed(wanted):
            made = option(made)
        return made

    return decorate


answering = _gathering(_ANSWERING)
"""Give a command the options of how to answer alone, passed on as one :class:`Options`."""


def output(
    what: str, *, folder: bool = False, required: bool = False
) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Give a command the option ``-o``.

    Parameters
    ----------
    what : str
        What it says in the help.
    folder : bool
        Whether a folder will do.
    required : bool
        Whether it has to be given.
    """
    kind = click.Path(dir_okay=folder, path_type=Path)
    return click.option("-o", "--output", type=kind, metavar="OUT", required=required, help=what)


def examples(*lines: str) -> str:
    """Make the end of a command's help: what one may type, each on a line of its own."""
    return "\b\nFor example:\n" + "\n".join(f"  {line}" for line in lines)
