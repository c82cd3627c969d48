"""Dynamics: momentum and energy of a body as a chain of rigid segments (paper S, sections 2.4 to 2.6).

Conventions
-----------
Everything is in the world's axes, but twists *in the body frame*, which are in the axes of their segment. A twist is
``(v, w)``, linear before angular. In the body frame ``v = Q* dp/dt`` is the speed of the segment's origin ``p``; in the
global frame ``v = dp/dt - w x p`` is that of the point of the segment, imagined to reach so far, that passes the origin
of the world. Momenta and kinetic energies are those of the centres of mass.

References
----------
Schultz, *Performance Physics* (2012), chapter 2 (paper S); Murray, Li, Sastry, *A Mathematical Introduction to Robotic
Manipulation* (1994).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import Any

import numpy as np

from leitmotion.body.body import Body, BodyMap
from leitmotion.body.flight import Flight
from leitmotion.body.inertia import AXIAL, inertia_table
from leitmotion.body.joints import OPTIONAL, joints_by_role, seen_runs
from leitmotion.body.momenta import USUAL_CUTOFF, Chain, move_chain, unknown
from leitmotion.body.segments import SEGMENTS, check_roles, lengths_of, stiff_turns
from leitmotion.motion import Motion, ParameterError, Trajectories
from leitmotion.motion.noun import Noun, check_rate, noun, set_array, set_names
from leitmotion.motion.smoothing import HIGHEST

USUAL_MASS = 70.0
"""Kilograms of a body whose mass nobody said."""
OF_RATE = 0.4  # what the usual cutoff is at most, of the rate


@noun
class Dynamics(Noun):
    """What a body's movement weighs: momentum and energy of each segment and of the whole, along time.

    Parameters
    ----------
    segments : tuple of str, S
        The rigid parts, :data:`leitmotion.body.SEGMENTS`.
    masses : (S,) float
        Kilograms.
    inertias : (S, 3) float
        Moments of inertia about the segment's own axes x, y, z through its centre of mass, kg m².
    origins, centres : (T, S, 3) float
        Where each is: the end that it turns about, and its centre of mass, m. NaN, as all that follows, in frames in
        which a joint is unseen.
    global_rotations : (T, S, 4) float
        How each is turned.
    velocities, angular_velocities : (T, S, 3) float
        Of the centre of mass, m/s, and of the turning, rad/s.
    body_twists, global_twists : (T, S, 6) float
        Linear and angular velocity in the body frame and in the global frame (paper S, section 2.4), m/s and rad/s.
    linear_momenta : (T, S, 3) float
        Kilogram metres per second.
    angular_momenta : (T, S, 3) float
        About the segment's own centre of mass, kg m²/s.
    linear_energies, angular_energies, potential_energies : (T, S) float
        Kinetic energy of going and of turning, and m g h over the height zero of the recording, J.
    centre_of_mass : (T, 3) float
        Of the whole body, m.
    linear_momentum, angular_momentum : (T, 3) float
        Of the whole body, kg m/s; the angular one about its centre of mass, kg m²/s.
    flights : tuple of Flight
        Stretches between take-off and landing, and how well the recording obeys physics there.
    rate : float
        Frames per second.
    name : str
        What the recording is called.
    parameters : dict
        "mass_kg" and "mass_given", "sex", "cutoff_hz" and "filter", "turned_by_file", the segments whose turn about
        their own axis the file told, "lumped", those that had no joint of their own and stand still on their neighbour,
        and "unseen_frames".

    Raises
    ------
    ParameterError
        When shapes disagree.
    """

    segments: tuple[str, ...]
    masses: np.ndarray
    inertias: np.ndarray
    origins: np.ndarray
    centres: np.ndarray
    global_rotations: np.ndarray
    velocities: np.ndarray
    angular_velocities: np.ndarray
    body_twists: np.ndarray
    global_twists: np.ndarray
    linear_momenta: np.ndarray
    angular_momenta: np.ndarray
    linear_energies: np.ndarray
    angular_energies: np.ndarray
    potential_energies: np.ndarray
    centre_of_mass: np.ndarray
    linear_momentum: np.ndarray
    angular_momentum: np.ndarray
    flights: tuple[Flight, ...]
    rate: float
    name: str = ""
    parameters: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        count = len(set_names(self, "segments"))
        set_array(self, "masses", dtype=np.float64, shape=(count,))
        set_array(self, "inertias", dtype=np.float64, shape=(count, 3))
        frames = set_array(self, "centres", dtype=np.float64, shape=(None, count, 3), finite=False).shape[0]
        for kind, width in (("global_rotations", 4), ("body_twists", 6), ("global_twists", 6)):
            set_array(self, kind, dtype=np.float64, shape=(frames, count, width), finite=False)
        for kind in ("origins", "velocities", "angular_velocities", "linear_momenta", "angular_momenta"):
            set_array(self, kind, dtype=np.float64, shape=(frames, count, 3), finite=False)
        for kind in ("linear_energies", "angular_energies", "potential_energies"):
            set_array(self, kind, dtype=np.float64, shape=(frames, count), finite=False)
        for kind in ("centre_of_mass", "linear_momentum", "angular_momentum"):
            set_array(self, kind, dtype=np.float64, shape=(frames, 3), finite=False)
        object.__setattr__(self, "flights", tuple(self.flights))
        check_rate(self)

    def __len__(self) -> int:
        return self.centres.shape[0]

    @property
    def mass(self) -> float:
        """Of the whole body, kg."""
        return float(self.masses.sum())

    @property
    def times(self) -> np.ndarray:
        """Time of each frame in seconds, shape (T,)."""
        return np.arange(len(self)) / self.rate

    @property
    def kinetic_energy(self) -> np.ndarray:
        """Of the whole body, going and turning, J, shape (T,)."""
        energy: np.ndarray = (self.linear_energies + self.angular_energies).sum(axis=1)
        return energy

    @property
    def potential_energy(self) -> np.ndarray:
        """Of the whole body, J, shape (T,)."""
        energy: np.ndarray = self.potential_energies.sum(axis=1)
        return energy


def dynamics(
    recording: Motion | Trajectories | Body,
    *,
    mass: float | None = None,
    sex: str = "mean",
    cutoff_hz: float | str | None = "usual",
    body_map: BodyMap | Mapping[str, str | Sequence[str]] | None = None,
) -> Dynamics:
    """Compute momentum and energy of a body in motion, and judge them by its flights.

    The body is 16 rigid segments, whose masses and radii of gyration are de Leva's (1996), scaled to this body's
    lengths and mass. Joints are filtered by a zero-lag Butterworth low-pass of order four, then differentiated by a
    cubic spline.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person, T frames, in metres.
    mass : float, optional
        Of the body, kg. Nobody's is 70 kg by default: then momenta and energies are right but for a factor, and only
        their ratios are facts.
    sex : {"mean", "female", "male"}
        Whose table is used.
    cutoff_hz : float, "usual" or None
        Of the filter, hertz: where half of the power is left. Usual are 10 Hz, at most 0.4 of the rate; None does not
        filter.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role, when the names do not tell. Not of a Body, whose roles are
        settled.

    Returns
    -------
    Dynamics
        Arrays along time, and the flights.

    Raises
    ------
    ParameterError
        When the mass is no positive number, or sex or cutoff are none that there are.
    DataError
        When the recording is not in metres and three dimensions, a joint of the body is missing, or all joints are
        never seen together for five frames.

    Examples
    --------
    >>> from leitmotion.datasets import compose_session
    >>> found = dynamics(compose_session(seed=0, rate=30.0).motion[:300], mass=60.0)
    >>> found.segments[:4], round(found.mass, 6)
    (('pelvis', 'abdomen', 'thorax', 'head'), 60.0)
    >>> found.centres.shape, found.kinetic_energy.shape
    ((300, 16, 3), (300,))
    """
    weight = _checked_mass(mass)
    table = inertia_table(sex)
    points, turns, rate = joints_by_role(recording, body_map)
    check_roles(points, recording.name)
    cutoff = _checked_cutoff(cutoff_hz, rate)
    runs = seen_runs(points, recording.name)
    lengths = lengths_of(points, table)
    carried = stiff_turns(points, turns)
    parts = [table.parts[name if name in AXIAL else name.partition("_")[2]] for name in SEGMENTS]
    masses = weight * np.array([part.mass for part in parts])
    inertias = masses[:, None] * (lengths[:, None] * np.array([part.radii for part in parts])) ** 2
    body = Chain(table, lengths, masses, inertias, rate, cutoff)
    frames = len(recording)
    arrays, flights = unknown(frames), []
    for start, stop in runs:
        window = slice(start, stop)
        moved, found = move_chain(
            body, {role: place[window] for role, place in points.items()},
            {segment: turn[window] for segment, turn in carried.items()},
        )  # fmt: skip
        for kind, values in moved.items():
            arrays[kind][window] = values
        flights += [one.replace(start=one.start + start, stop=one.stop + start) for one in found]
    return Dynamics(
        segments=SEGMENTS,
        masses=masses,
        inertias=inertias,
        **arrays,
        flights=tuple(flights),
        rate=rate,
        name=recording.name,
        parameters={
            "mass_kg": weight,
            "mass_given": mass is not None,
            "sex": sex,
            "table": "de Leva 1996, table 4",
            "filter": "none" if cutoff is None else "zero-lag Butterworth low-pass of order 4",
            "cutoff_hz": cutoff,
            "differentiated_by": "cubic spline",
            "turned_by_file": sorted(carried),
            "lumped": sorted(role.replace("toe", "foot") for role in OPTIONAL if role not in points),
            "unseen_frames": frames - sum(stop - start for start, stop in runs),
        },
    )


def _checked_mass(mass: float | None) -> float:
    if mass is None:
        return USUAL_MASS
    if isinstance(mass, bool) or not np.isfinite(mass) or mass <= 0:
        raise ParameterError(f"mass must be a positive number of kilograms, got {mass!r}.")
    return float(mass)


def _checked_cutoff(cutoff_hz: float | str | None, rate: float) -> float | None:
    if cutoff_hz is None:
        return None
    if cutoff_hz == "usual":
        return min(USUAL_CUTOFF, OF_RATE * rate)
    if isinstance(cutoff_hz, bool | str) or not 0 < cutoff_hz < HIGHEST * rate:
        raise ParameterError(
            f"The cutoff must lie above 0 and below {HIGHEST * rate:g} Hz, 0.45 of the rate, got {cutoff_hz!r}."
        )
    return float(cutoff_hz)
