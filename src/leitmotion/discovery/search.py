"""Search: one pass over a recording, from its stripes to themes and returns.

Conventions
-----------
Moments of the working rate, distances in body sizes.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.cuts import cutter
from leitmotion.discovery.ends import without_transitions
from leitmotion.discovery.families import Run, cyclic_runs, is_near, overlap
from leitmotion.discovery.kinds import part_themes
from leitmotion.discovery.lone import with_lone_occurrences
from leitmotion.discovery.pauses import from_rest_to_rest
from leitmotion.discovery.refine import Refiner
from leitmotion.discovery.returns import Return, returns_of
from leitmotion.discovery.stripes import AMPLITUDE_SHARE, Likeness, Stripe, likeness, measure
from leitmotion.discovery.themes import FREE, Theme, themes_of
from leitmotion.discovery.tracing import trace_stripes
from leitmotion.discovery.units import alternation, divide
from leitmotion.similarity import Distances

MIN_PERIOD_S = 0.25
ALTERNATES = 1.5  # times the distance of what is alike: so near is a movement to its mirror image
FEW = 2  # cycles in a row that may be two movements that come back in one order as well


class Criteria(NamedTuple):
    """What counts as a return."""

    max_distance: float
    """Body sizes: postures nearer than this are alike."""

    min_contrast: float
    """How much nearer than its surroundings a stripe is, 0 to 1."""

    min_amplitude: float
    """Body sizes: what moves less keeps still."""

    shortest: int
    """Moments that a stretch lasts at least."""

    cuts: str = "stripes"
    """What cuts a run into cycles."""

    share: float = AMPLITUDE_SHARE
    """Of what the body moves around a moment: nearer than this is alike."""

    def likeness(self, distances: Distances) -> Likeness:
        """Decide at each moment how near another posture must be."""
        return likeness(
            distances, max_distance=self.max_distance, min_amplitude=self.min_amplitude, share=self.share
        )


class SecondLook(NamedTuple):
    """What counts as a return in what is left over."""

    wider: float
    """Times the distance of what is alike: so near is enough."""

    min_contrast: float
    """Where this much nearer than its surroundings, or as much as in the first look where that is more."""

    amplitude_share: float
    """Of what the body moves around a moment: nearer than this is alike."""

    def of(self, first: Criteria) -> Criteria:
        """What counts as a return, after a first look by other criteria."""
        return first._replace(
            max_distance=self.wider * first.max_distance,
            min_contrast=max(self.min_contrast, first.min_contrast),
            share=self.amplitude_share,
        )


class Seen(NamedTuple):
    """What one pass sees."""

    themes: list[Theme]
    returns: list[Return]
    limits: dict[str, object]
    """What was not compared, where a recording is too long."""


def search(distances: Distances, criteria: Criteria, refine: Refiner) -> Seen:
    """Look for what recurs, once.

    Parameters
    ----------
    distances : Distances
        Posture distances of N moments; moments that are NaN are passed over.
    criteria : Criteria
        What counts as a return.
    refine : Refiner
        Moves borders at the recording's own rate.

    Returns
    -------
    Seen
        Themes first, then returns of what no theme explains.
    """
    rate = distances.features.rate
    alike = criteria.likeness(distances)
    traced = trace_stripes(
        distances, alike, max_distance=criteria.max_distance, min_duration_s=criteria.shortest / rate
    )
    alternates = alternation(distances, ALTERNATES * criteria.max_distance)
    stripes = divide(
        [s for s in traced.stripes if s.contrast >= criteria.min_contrast and s.lag >= MIN_PERIOD_S * rate],
        distances,
        alike,
        alternates,
        max_distance=criteria.max_distance,
        shortest=criteria.shortest,
    )
    stripes = [s for s in stripes if s.contrast >= criteria.min_contrast]
    runs = cyclic_runs(stripes, cutter(criteria.cuts, alike.speed, np.nan_to_num(distances.features.values)))
    themes, doubtful = _parted(part_themes(themes_of(runs, stripes), distances, criteria.max_distance))
    stripes += _first_cycles(doubtful, stripes, distances, alike)
    for theme in themes:
        theme.runs = _settled([refine.run(run) for run in theme.runs])
    returns = returns_of(
        themes,
        stripes,
        distances,
        alike,
        alternates,
        shortest=criteria.shortest,
        min_contrast=criteria.min_contrast,
    )
    for item in returns:
        item.spans = from_rest_to_rest(item.spans, alike.speed, rate, criteria.shortest)
    themes = without_transitions(themes, distances, alike.speed, criteria.max_distance)
    known = np.isnan(distances.features.values).all(axis=1)
    for theme in themes:
        known |= theme.holds(len(distances))
    returns = with_lone_occurrences(
        returns, known, distances, max_distance=criteria.max_distance, min_contrast=criteria.min_contrast
    )
    for item in returns:
        item.spans = refine.spans(item.spans)
    return Seen(themes, returns, traced.limits)


def _parted(themes: Sequence[Theme]) -> tuple[list[Theme], list[Theme]]:
    """Part what surely is cyclic from what has no run of more than two cycles."""
    sure = [theme for theme in themes if max(run.cycles for run in theme.runs) > FEW]
    return sure, [theme for theme in themes if max(run.cycles for run in theme.runs) <= FEW]


def _first_cycles(
    themes: Sequence[Theme], stripes: Sequence[Stripe], distances: Distances, alike: Likeness
) -> list[Stripe]:
    """Of stripes of a theme whose two stretches overlap the part up to where they meet: one time after another."""
    runs = [(run.start, run.stop) for theme in themes for run in theme.runs]
    meeting = [
        stripe.path[: int(np.searchsorted(stripe.path[:, 0], stripe.b[0]))]
        for stripe in stripes
        if is_near(stripe)
        and overlap(stripe.a, stripe.b) > 0
        and any(overlap(stripe.a, run) > 0.7 * (stripe.a[1] - stripe.a[0]) for run in runs)
    ]
    return [piece for piece in measure(meeting, distances, alike) if piece is not None]


def _settled(runs: Sequence[Run]) -> list[Run]:
    """Runs of one theme without overlap: a later run gives up the cycles that the earlier one reaches well into.

    A cycle into which it reaches by less than a single occurrence may overlap a run begins where the earlier one ends.
    """
    settled: list[Run] = []
    for run in sorted(runs, key=lambda run: run.start):
        if settled and run.start < settled[-1].stop:
            last = settled[-1]
            end = last.borders[-1]
            borders = [b for b in run.borders if b >= end]
            given_up = len(run.borders) - len(borders)
            if (
                borders
                and given_up
                and borders[0] - end > (1 - FREE) * (borders[0] - run.borders[given_up - 1])
            ):
                borders.insert(0, end)
            if len(borders) < 2:
                last.stop = max(last.stop, run.stop)
                continue
            last.stop = min(last.stop, borders[0])
            run = Run(max(run.start, last.stop), run.stop, run.period, run.stripes, run.support, borders)
        settled.append(run)
    return settled
