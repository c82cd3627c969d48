"""Checks of the person: whether what was understood of a recording makes a human body.

Each check takes what is :class:`~leitmotion.repairs.problem.Examined` and returns one problem, or None.
"""

from __future__ import annotations

import numpy as np

from leitmotion.body import ANALYSIS_ROLES, check_sides
from leitmotion.motion import DataError
from leitmotion.repairs.floor import find_floor
from leitmotion.repairs.problem import Examined, Problem
from leitmotion.repairs.repaired import listed

BODY_SIZES_M = (0.5, 2.5)  # a child of one year to the tallest adult, along the chain that Body.size measures
USUAL_SIZE_M = 1.4  # of an adult, along the same chain
UNITS_M = {"m": 1.0, "cm": 0.01, "mm": 0.001, "inch": 0.0254, "ft": 0.3048}
SHORT_S = 1.0  # less holds no movement and its return
UNSURE = 0.6  # roles less sure than this are named
STEEP_DEGREES = 3.0
HIGH_M = 0.15  # of the standing feet over or under level 0: an ankle alone is at 0.1
STAND = 0.5  # of the slow moments of the feet must lie on the floor for it to be believed


def sized(seen: Examined) -> Problem | None:
    """Check that the body is as large as people are."""
    smallest, largest = BODY_SIZES_M
    body = seen.body
    known = set(ANALYSIS_ROLES) <= set(seen.roles.roles)
    if body.unit != "m" or not known or smallest <= body.size <= largest:
        return None
    message = (
        f"The body measures {body.size:.3g} m from ankles to head; people measure {smallest} to {largest} m."
    )
    if seen.metres is None:
        return Problem("size", message, "Say what unit the file is in: --unit cm, mm, inch.")
    sizes = {unit: body.size / seen.metres * metres for unit, metres in UNITS_M.items()}
    unit = min(sizes, key=lambda unit: abs(np.log(sizes[unit] / USUAL_SIZE_M)))
    if not smallest <= sizes[unit] <= largest:
        return Problem(
            "size", message, "No usual unit makes it a person: say how many metres one is, as in --unit 0.1."
        )
    remedy = (
        f"Say what unit the file is in: --unit {unit} comes nearest to an adult, with {sizes[unit]:.2f} m."
    )
    return Problem("size", message, remedy, "info", ("--unit", unit))


def upright(seen: Examined) -> Problem | None:
    """Check that the head is above the feet."""
    body = seen.body
    if not {"head", "left_ankle", "right_ankle"} <= set(body.roles) or body.positions.shape[2] != 3:
        return None
    head, left, right = (
        body.positions[:, body.roles.index(role)] for role in ("head", "left_ankle", "right_ankle")
    )
    tall = head - (left + right) / 2
    tall = tall[np.isfinite(tall).all(axis=1)]
    low = float(np.mean(tall[:, 1] < 0.2 * body.size)) if len(tall) else 0.0
    if low < 0.5:
        return None
    axis = "y"
    if seen.up == "y":
        middle = np.median(tall, axis=0)
        k = int(np.abs(middle).argmax())
        axis = ("" if middle[k] > 0 else "-") + "xyz"[k]
    return Problem(
        "up",
        f"The head is not above the feet in {low:.0%} of the frames: the person lies down, or another axis is up.",
        f"If the person stands, say which axis is up: --up {axis}.",
        "info",
        ("--up", axis),
    )


def sided(seen: Examined) -> Problem | None:
    """Check that what is called left is on the left of where the person looks."""
    sides = seen.sides or check_sides(seen.recording, seen.roles)
    if sides.crossed:
        remedy = "Name the joints in a map file: --map roles.json."
        return Problem(
            "sides", f"Some sides are swapped: {sides.reason}.", remedy, "info", ("--map", "roles.json")
        )
    if sides.verdict != "swapped":
        return None
    return Problem(
        "sides",
        f"Left and right look swapped, or the axes are left-handed: with the sides as called {sides.reason}.",
        "If they are, have them exchanged: --swap-sides, here or for good.",
        "repair",
        ("--swap-sides",),
    )


def named(seen: Examined) -> Problem | None:
    """Check that every role that analyses compare was found."""
    known = seen.roles.roles
    missing = [role for role in ANALYSIS_ROLES if role not in known]
    if not missing:
        return None
    what = "No role could be told" if not known else f"No joint or marker was found for {listed(missing)}"
    remedy = "Name them in a map file: --map roles.json."
    return Problem("roles", f"{what}.", remedy, "info", ("--map", "roles.json"))


def sure(seen: Examined) -> Problem | None:
    """Check that no role is in doubt."""
    roles = seen.roles
    unsure = [role for role, sure in zip(roles.roles, roles.confidence, strict=True) if sure < UNSURE]
    if not unsure:
        return None
    return Problem(
        "unsure",
        f"Uncertain which joint or marker is {listed(unsure)}.",
        "Check the roles; --map settles them.",
        "info",
        ("--map", "roles.json"),
    )


def long_enough(seen: Examined) -> Problem | None:
    """Check that something could come back in it."""
    if seen.recording.duration >= SHORT_S:
        return None
    return Problem(
        "short", f"It lasts {seen.recording.duration:.2f} s, too short for anything to come back in it."
    )


def floored(seen: Examined) -> Problem | None:
    """Check that the feet stand on a level floor at height 0."""
    body = seen.body
    if body.unit != "m" or body.positions.shape[2] != 3 or not len(seen.roles.roles):
        return None
    if sized(seen) is not None or upright(seen) is not None:  # the floor of a misread file means nothing
        return None
    try:
        floor = find_floor(seen.recording, seen.roles)
    except DataError:
        return None
    if floor.share < STAND:
        return None
    tilt = float(np.degrees(floor.tilt))
    wrong = []
    if tilt > STEEP_DEGREES:
        wrong.append(f"is tilted by {tilt:.1f} degrees")
    if abs(floor.height) > HIGH_M:
        wrong.append(f"is {abs(floor.height):.2f} m {'above' if floor.height > 0 else 'below'} level 0")
    if not wrong:
        return None
    message = f"The floor that the feet stand on {' and '.join(wrong)}."
    return Problem("floor", message, "Level it if heights matter.", "repair", ("--level",))
