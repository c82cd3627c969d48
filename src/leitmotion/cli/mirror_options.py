"""The options of the verbs that compare a person with their mirror image."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import click

from leitmotion.cli.options import Positive


@dataclass(frozen=True)
class MirrorOptions:
    """How a recording is compared with its mirror image."""

    metric: str = "inner"
    bias: str = "none"
    beta: float | None = None


def mirror_options(*, of: str = "") -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Give a command ``--metric``, ``--bias`` and ``--beta``.

    Parameters
    ----------
    of : str
        The option that they belong to, where they need one; stands in their help.
    """
    lead = f"Of {of}: " if of else ""

    def said(text: str) -> str:
        return lead + text if lead else text[0].upper() + text[1:]

    made = (
        click.option(
            "--metric",
            type=click.Choice(["inner", "geodesic"]),
            default="inner",
            show_default=True,
            help=said("the cost of paper S, or the angle."),
        ),
        click.option(
            "--bias",
            type=click.Choice(["none", "auto", "mean", "standing"]),
            default="none",
            show_default=True,
            help=said(
                "the posture by which the bias of the sides is measured, and taken out; auto: the mean one, where "
                "both sides do the same."
            ),
        ),
        click.option(
            "--beta",
            type=Positive(),
            metavar="B",
            help=said("how fast likeness falls with distance; by default as the recording tells."),
        ),
    )

    def decorate(command: Callable[..., Any]) -> Callable[..., Any]:
        for option in reversed(made):
            command = option(command)
        return command

    return decorate


weights = click.option(
    "--weights",
    type=click.Choice(["equal", "active"]),
    default="equal",
    show_default=True,
    help="Whether each link of the body counts alike, or the more the more it moves.",
)
"""Give a command the weights alone of the options that say what is compared."""
