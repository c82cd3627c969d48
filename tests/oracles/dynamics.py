"""Dynamics written to be obviously right: a rigid part is six particles, and particles have no formulas."""

import numpy as np


def particles(masses, inertias, centres, axes):
    """Six particles a part that weigh and turn as it does: on each axis two, at equal distances from the centre.

    Masses (S,), inertias (S, 3), centres (T, S, 3), axes (T, S, 3, 3) with the axes in columns; gives the masses (N,)
    and places (T, N, 3) of N = 6 S particles.
    """
    weights, places = [], []
    for part, mass in enumerate(masses):
        for axis in range(3):
            others = inertias[part].sum() - inertias[part][axis]
            distance = np.sqrt(1.5 / mass * (others - inertias[part][axis]))
            for side in (1.0, -1.0):
                weights.append(mass / 6)
                places.append(centres[:, part] + side * distance * axes[:, part, :, axis])
    return np.array(weights), np.stack(places, axis=1)


def totals(weights, places, rate):
    """Linear momentum, angular momentum about the centre of mass and kinetic energy of particles, inner frames only."""
    momenta, angular, energies = [], [], []
    for frame in range(1, len(places) - 1):
        speeds = (places[frame + 1] - places[frame - 1]) * rate / 2
        centre = sum(m * p for m, p in zip(weights, places[frame], strict=True)) / sum(weights)
        going = sum(m * v for m, v in zip(weights, speeds, strict=True)) / sum(weights)
        momenta.append(going * sum(weights))
        angular.append(
            sum(
                m * np.cross(p - centre, v - going)
                for m, p, v in zip(weights, places[frame], speeds, strict=True)
            )
        )
        energies.append(sum(m * np.dot(v, v) / 2 for m, v in zip(weights, speeds, strict=True)))
    return np.array(momenta), np.array(angular), np.array(energies)


def inertia_about_centre(weights, places):
    """Inertia tensor (3, 3) of particles at one moment about their centre of mass, and that centre."""
    centre = sum(m * p for m, p in zip(weights, places, strict=True)) / sum(weights)
    tensor = np.zeros((3, 3))
    for mass, place in zip(weights, places - centre, strict=True):
        tensor += mass * (np.dot(place, place) * np.eye(3) - np.outer(place, place))
    return tensor, centre
