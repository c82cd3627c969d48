"""How heavy the parts of a body are and how their mass lies, from a published table.

Conventions
-----------
Of each segment the table [1] tells the mass as a share of the body's, where along its length the centre of mass is, and
three radii of gyration as shares of its length: about the *sagittal* axis (from back to front), the *transverse* one
(from right to left) and the *longitudinal* one. In a segment's own axes (x to the person's left, y up, z to the front
at rest) these are z, x and y; of a foot, which lies, y and z change place.

References
----------
[1] P. de Leva, "Adjustments to Zatsiorsky-Seluyanov's segment inertia parameters", Journal of Biomechanics 29 (1996)
    1223-1230, table 4. Zatsiorsky and Seluyanov measured 115 living adults by gamma rays.
[2] Winter, *Biomechanics and Motor Control of Human Movement*: the centre of the foot, half-way from the ankle to the
    ball.
"""

from __future__ import annotations

from typing import NamedTuple

from leitmotion.motion import ParameterError

SEXES = ("mean", "female", "male")
"""Whose table is used; the mean is that of the two."""


class Part(NamedTuple):
    """What the table tells of one segment."""

    length: float
    """Metres, of the mean person measured."""

    mass: float
    """Share of the body's mass, of one side."""

    centre: float
    """Where the centre of mass is: share of the length, from the end that is named first."""

    radii: tuple[float, float, float]
    """Radii of gyration about the axes x, y, z through the centre, shares of the length."""


STATURE = {"female": 1.735, "male": 1.741}
"""Metres, of the mean person measured."""
MASS = {"female": 61.9, "male": 73.0}
"""Kilograms, of the mean person measured."""
SHOULDERS_TO_HIPS = {"female": 0.4979, "male": 0.5155}
"""Metres from the middle of the shoulders to that of the hips."""
TOP_TO_HIPS = {"female": 0.5293, "male": 0.5319}
"""Metres from the notch above the breastbone, where the upper trunk begins, to the middle of the hips."""

# head: crown to the seventh cervical vertebra; thorax, abdomen and pelvis: notch above the breastbone, its lower end,
# navel, middle of the hips; limbs: joint to joint; hand: wrist to third knuckle; foot: heel to tip of the toes [1]
_TABLE = {
    "female": {
        "head": Part(0.2437, 0.0668, 0.4841, (0.295, 0.261, 0.271)),
        "thorax": Part(0.1425, 0.1545, 0.2077, (0.502, 0.718, 0.746)),
        "abdomen": Part(0.2053, 0.1465, 0.4512, (0.354, 0.415, 0.433)),
        "pelvis": Part(0.1815, 0.1247, 0.4920, (0.402, 0.444, 0.433)),
        "upper_arm": Part(0.2751, 0.0255, 0.5754, (0.260, 0.148, 0.278)),
        "forearm": Part(0.2643, 0.0138, 0.4559, (0.257, 0.094, 0.261)),
        "hand": Part(0.0780, 0.0056, 0.7474, (0.454, 0.335, 0.531)),
        "thigh": Part(0.3685, 0.1478, 0.3612, (0.364, 0.162, 0.369)),
        "shank": Part(0.4323, 0.0481, 0.4416, (0.267, 0.093, 0.271)),
        "foot": Part(0.2283, 0.0129, 0.5, (0.279, 0.299, 0.139)),
    },
    "male": {
        "head": Part(0.2429, 0.0694, 0.5002, (0.315, 0.261, 0.303)),
        "thorax": Part(0.1707, 0.1596, 0.2999, (0.454, 0.659, 0.716)),
        "abdomen": Part(0.2155, 0.1633, 0.4502, (0.383, 0.468, 0.482)),
        "pelvis": Part(0.1457, 0.1117, 0.6115, (0.551, 0.587, 0.615)),
        "upper_arm": Part(0.2817, 0.0271, 0.5772, (0.269, 0.158, 0.285)),
        "forearm": Part(0.2689, 0.0162, 0.4574, (0.265, 0.121, 0.276)),
        "hand": Part(0.0862, 0.0061, 0.7900, (0.513, 0.401, 0.628)),
        "thigh": Part(0.4222, 0.1416, 0.4095, (0.329, 0.149, 0.329)),
        "shank": Part(0.4340, 0.0433, 0.4459, (0.249, 0.103, 0.255)),
        "foot": Part(0.2581, 0.0137, 0.5, (0.245, 0.257, 0.124)),
    },
}  # fmt: skip


class Table(NamedTuple):
    """The table of one sex, or the mean of both, for a body of unit mass."""

    parts: dict[str, Part]
    stature: float
    shoulders_to_hips: float
    top_to_hips: float


def inertia_table(sex: str = "mean") -> Table:
    """Take the table of a sex.

    Parameters
    ----------
    sex : {"mean", "female", "male"}
        Whose.

    Returns
    -------
    Table
        The parts by name; those of the limbs are of one side. Masses are divided by their sum, which rounding leaves
        within 0.02 % of 1, so that a body weighs what it is said to weigh.

    Raises
    ------
    ParameterError
        When there is no such table.

    Examples
    --------
    >>> inertia_table("male").parts["thigh"].centre
    0.4095
    """
    if sex not in SEXES:
        raise ParameterError(f"sex must be one of {', '.join(SEXES)}, got {sex!r}.")
    of = ("female", "male") if sex == "mean" else (sex,)

    def mean(values: list[float]) -> float:
        return sum(values) / len(values)

    parts = {}
    for name in _TABLE["male"]:
        rows = [_TABLE[one][name] for one in of]
        radii = tuple(mean([row.radii[axis] for row in rows]) for axis in range(3))
        parts[name] = Part(
            mean([row.length for row in rows]),
            mean([row.mass for row in rows]),
            mean([row.centre for row in rows]),
            (radii[0], radii[1], radii[2]),
        )
    total = sum(part.mass * (1 if name in AXIAL else 2) for name, part in parts.items())
    return Table(
        {name: part._replace(mass=part.mass / total) for name, part in parts.items()},
        mean([STATURE[one] for one in of]),
        mean([SHOULDERS_TO_HIPS[one] for one in of]),
        mean([TOP_TO_HIPS[one] for one in of]),
    )


AXIAL = ("pelvis", "abdomen", "thorax", "head")
"""Segments of the middle of the body."""
LIMBS = ("upper_arm", "forearm", "hand", "thigh", "shank", "foot")
"""Segments of each side."""
