"""Excursions: ways out and back once, told from how far they lead.

Conventions
-----------
Who kicks or reaches once comes back by a way that may differ from the way out by more than what is alike, and yet lies
much nearer to it than how far it led. So an excursion is judged by its own extent: how far its two ways are apart, over
how far it leads away from where it begins and ends. The two halves of a circle are half its extent apart, and are none.

References
----------
Paper S, sections 3.4.5 and 3.4.6.
"""

from __future__ import annotations

from collections.abc import Sequence

from leitmotion.discovery.forms import LEAST_EXTENT, Form, covered_by
from leitmotion.discovery.signals import Signal, find_signals
from leitmotion.discovery.waypoints import Waypoints

EASE = 1.5  # times what is alike, within which a way back is followed
ROUND = 0.5  # of the extent, that the two ways of a circle are apart
CLOSED = 0.55  # of the extent, up to which both ends are one place
TOLD = 0.4  # of an excursion, that forms which are clear may tell


def excursions(waypoints: Waypoints, clear: Sequence[Form]) -> list[Form]:
    """Tell ways out and back from reversed signals that are followed further than what is alike.

    Parameters
    ----------
    waypoints : Waypoints
        K waypoints.
    clear : sequence of Form
        Forms that tell of what lies within them.

    Returns
    -------
    list of Form
        One turn each, none mirrored, which neither clear forms nor better ones of these tell. The cost is how far the
        ways are apart over what those of a circle are.
    """
    eased = waypoints._replace(alike=EASE * waypoints.alike)
    far = waypoints.first_far
    found: list[Form] = []
    for signal in find_signals(eased, mirror=False, reverse=True):
        if signal.later[0] > far[signal.earlier[1]]:
            continue
        form = _excursion(signal, waypoints)
        told = sum(covered_by(form, other) for other in (*clear, *found))
        if form.extent >= LEAST_EXTENT and form.cost < 1 and told <= TOLD:
            found.append(form)
    return found


def _excursion(signal: Signal, waypoints: Waypoints) -> Form:
    """A form of one turn, of a cost of 1 where it does not come back."""
    first, last = signal.earlier[0], signal.later[1]
    turn = (signal.earlier[1] + signal.later[0]) // 2
    own = waypoints.own
    extent = min(float(own[end, first : last + 1].max()) for end in (first, last))
    apart = float(own[signal.path[:, 0], signal.path[:, 1]].mean())
    closed = own[first, last] <= CLOSED * extent
    at = waypoints.at
    return Form(
        (first, turn, last),
        (waypoints.left(first), int(at[signal.earlier[1]] + at[signal.later[0]]) // 2, int(at[last])),
        False,
        True,
        apart / (ROUND * extent) if closed else 1.0,
        1.0,
        extent / float(waypoints.alike[first : last + 1].mean()),
    )
