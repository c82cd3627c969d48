"""What the composer can make a person do: each action as curves through keyed moments of its cycle.

Conventions
-----------
An action starts and ends standing at ease. ``borders (n + 1,)`` are the seconds at which its cycles begin and end,
``amplitudes (n,)`` how large each is; before the first and after the last lie the seconds it takes to get going and
to come to rest. Lengths are body heights (see :mod:`leitmotion.datasets._posing`).

References
----------
[1] D. A. Winter, *The Biomechanics and Motor Control of Human Gait*, University of Waterloo Press, 1987: when heel and
    toe meet and leave the floor, how pelvis and trunk turn, how far the arms swing.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from leitmotion.datasets import skeleton as body
from leitmotion.datasets._curves import Key, keyed
from leitmotion.datasets._posing import (
    ABDUCTION,
    ELBOW,
    FLEXION,
    OUTWARD,
    SHRUG,
    SIDES,
    Posture,
)

GRAVITY = 9.81 / 1.75  # body heights of an average adult per second squared
YAW, PITCH, ROLL = range(3)


class Place(NamedTuple):
    """A stance on the floor: the middle between the feet and which way they face."""

    x: float = 0.0
    z: float = 0.0
    yaw: float = 0.0


@dataclasses.dataclass(frozen=True)
class Movement:
    """How one kind of action is done."""

    period_s: float
    """Seconds a cycle usually takes."""
    perform: Callable[[np.ndarray, np.ndarray, np.ndarray, float], Posture]
    """Postures at times (T,) of an action with these borders, amplitudes and turn."""
    lead_s: float = 0.0
    """Seconds from rest to the first cycle."""
    tail_s: float = 0.0
    """Seconds from the last cycle to rest."""
    arrive: Callable[[np.ndarray, float], Place] = lambda amplitudes, turn: Place()
    """The stance after the action, seen from the one before it."""


def _still(t: np.ndarray, borders: np.ndarray, amplitudes: np.ndarray, turn: float) -> Posture:
    return Posture.standing(len(t))


def _squat(t: np.ndarray, borders: np.ndarray, amplitudes: np.ndarray, turn: float) -> Posture:
    down = _each_cycle(
        t, borders, amplitudes, [(0.0, 0.0), (0.03, 0.0), (0.46, 1.0), (0.52, 1.0), (0.95, 0.0)]
    )
    reach = _each_cycle(t, borders, amplitudes, [(0.0, 0.0), (0.38, 1.0), (0.54, 1.0), (0.98, 0.0)])
    p = Posture.standing(len(t))
    p.hips += down[:, None] * [0.0, -0.205, -0.105]
    p.pelvis[:, PITCH] += 0.52 * down
    p.trunk[:, PITCH] += 0.22 * down
    p.head[:, PITCH] -= 0.50 * down
    p.knees += 0.10 * down[:, None]
    p.arms[..., FLEXION] += 2.12 * reach[:, None]
    p.arms[..., ABDUCTION] -= 0.05 * reach[:, None]
    p.arms[..., ELBOW] -= 0.08 * reach[:, None]
    return p


def _arm_raise(t: np.ndarray, borders: np.ndarray, amplitudes: np.ndarray, turn: float) -> Posture:
    up = _each_cycle(t, borders, amplitudes, [(0.0, 0.0), (0.03, 0.0), (0.45, 1.0), (0.53, 1.0), (0.96, 0.0)])
    p = Posture.standing(len(t))
    p.arms[..., FLEXION] += 2.72 * up[:, None]
    p.arms[..., ELBOW] -= 0.06 * up[:, None]
    p.arms[..., SHRUG] += 0.30 * up[:, None]
    p.pelvis[:, PITCH] += 0.02 * up
    p.trunk[:, PITCH] -= 0.09 * up
    p.head[:, PITCH] -= 0.05 * up
    return p


def _side_kick(t: np.ndarray, borders: np.ndarray, amplitudes: np.ndarray, turn: float) -> Posture:
    """Shift onto the right leg, draw the left knee up, thrust the foot out, draw it in and put it down."""

    def curve(*keys: Key) -> np.ndarray:
        return _each_cycle(t, borders, amplitudes, [(0.0, 0.0), *keys])

    shift = curve((0.20, 0.8), (0.46, 1.0), (0.54, 1.0), (0.82, 0.75), (0.98, 0.0))
    guard = curve((0.22, 1.0), (0.80, 1.0), (0.98, 0.0))
    chamber = curve((0.12, 0.0), (0.33, 1.0), (0.49, 0.0), (0.66, 1.0), (0.87, 0.0))
    thrust = curve((0.31, 0.0), (0.47, 1.0), (0.52, 1.0), (0.67, 0.0))
    aloft = np.minimum(curve((0.13, 0.0), (0.26, 1.2), (0.74, 1.2), (0.86, 0.0)), 1.0)
    p = Posture.standing(len(t))
    p.hips += shift[:, None] * [-0.047, -0.004, 0.0] + thrust[:, None] * [-0.020, 0.0, 0.0]
    p.pelvis[:, ROLL] += 0.10 * chamber + 0.42 * thrust
    p.trunk[:, ROLL] += 0.02 * chamber + 0.20 * thrust
    p.trunk[:, PITCH] += 0.06 * guard
    p.head[:, ROLL] -= 0.08 * chamber + 0.46 * thrust
    p.head[:, YAW] += 0.55 * guard
    p.feet[:, 0] += chamber[:, None] * [0.015, 0.235, 0.075] + thrust[:, None] * [0.372, 0.335, 0.030]
    p.free[:, 0] = aloft
    p.arms[..., FLEXION] += 0.45 * guard[:, None]
    p.arms[..., ELBOW] += 1.75 * guard[:, None]
    p.arms[..., OUTWARD] -= 0.25 * guard[:, None]
    p.arms[..., ABDUCTION] += 0.08 * guard[:, None]
    p.arms[:, 0, ABDUCTION] += 0.35 * thrust
    p.arms[:, 0, ELBOW] -= 0.75 * thrust
    return p


def _right_side_kick(t: np.ndarray, borders: np.ndarray, amplitudes: np.ndarray, turn: float) -> Posture:
    return _side_kick(t, borders, amplitudes, turn).mirror()


def _jumping_jack(t: np.ndarray, borders: np.ndarray, amplitudes: np.ndarray, turn: float) -> Posture:
    """Jump apart with the arms up, jump together with the arms down; between the jumps the knees give."""
    hips: list[Key] = [(0.0, 0.0)]
    apart: list[Key] = [(0.0, 0.0)]
    lift: list[Key] = [(0.0, 0.0)]
    heels: list[Key] = [(0.0, 0.0)]
    for start, period, amplitude in zip(borders[:-1], np.diff(borders), amplitudes, strict=True):
        for half, spread in enumerate((1.0, 0.0)):
            flight = min(np.sqrt(8.0 * 0.034 * amplitude / GRAVITY), 0.22 * period)
            centre = start + (0.25 + 0.5 * half) * period
            leave, land = centre - 0.5 * flight, centre + 0.5 * flight
            low, high = (0.010 - 0.012 * s * amplitude for s in (1.0 - spread, spread))
            climb = (high - low) / flight
            fall = 0.5 * GRAVITY * flight
            give = 0.25 * fall * (0.5 * period - flight)
            if half == 0 and start == borders[0]:
                hips.append((start, low - give))
            hips += [(leave, low, climb + fall), (land, high, climb - fall)]
            apart += [(leave, 0.108 * amplitude * (1.0 - spread)), (land, 0.108 * amplitude * spread)]
            lift += [(leave, 0.0), (centre, 0.9 * GRAVITY * flight**2 / 8.0), (land, 0.0)]
            heels += [(centre - 0.25 * period + 0.02, 0.03), (leave, 0.50), (centre, 0.62), (land, 0.38)]
    tail = borders[-1] + MOVEMENTS["jumping jack"].tail_s
    hips += [(borders[-1], 0.010 - give), (tail, 0.0)]
    heels += [(borders[-1], 0.0)]
    up = _each_cycle(t, borders, amplitudes, [(0.0, 0.0), (0.03, 0.0), (0.46, 1.0), (0.54, 1.0), (0.97, 0.0)])
    p = Posture.standing(len(t))
    height = keyed(t, hips)
    crouch = np.maximum(-height, 0.0) ** 2 / 0.04  # smooth where the knees begin to give
    p.hips[:, 1] += height
    p.hips[:, 2] -= 0.35 * crouch
    p.pelvis[:, PITCH] += 3.0 * crouch
    p.trunk[:, PITCH] += 2.0 * crouch
    p.head[:, PITCH] -= 3.0 * crouch
    p.feet[..., 0] += keyed(t, apart)[:, None]
    p.feet[..., 1] += keyed(t, lift)[:, None]
    p.foot_pitch += keyed(t, heels)[:, None]
    p.arms[..., ABDUCTION] += 2.90 * up[:, None]
    p.arms[..., OUTWARD] += 1.35 * up[:, None]
    p.arms[..., ELBOW] += 0.34 * up[:, None]
    p.arms[..., SHRUG] += 0.38 * up[:, None]
    return p


STEP = 0.37
SWING = 0.76  # of the time from one heel strike to the next
HALF_TRACK = 0.030  # half the breadth between the lines on which the feet walk


def _walk(t: np.ndarray, borders: np.ndarray, amplitudes: np.ndarray, turn: float) -> Posture:
    """Walk over ground, left foot first, along an arc that turns by `turn` radians; the feet do not slip.

    Each foot strikes with the heel, stands flat, rolls over the ball and swings [1]; the pelvis follows the feet.
    """
    from scipy.interpolate import CubicSpline

    middles = 0.5 * (borders[1:] + borders[:-1])
    strikes = np.sort(np.concatenate((borders, middles)))
    along = _footprints(amplitudes)
    steps = range(1, len(strikes))
    tau = np.diff(strikes, prepend=np.nan)
    swing = np.where(np.arange(len(strikes)) % 2, 1.0, -1.0)  # +1 where the left foot swings
    size = np.minimum(np.diff(along, prepend=0.0), STEP) / STEP
    size[-1] = 0.5
    bend = turn / along[-1]
    mid_swing = strikes - 0.5 * SWING * tau
    end = strikes[-1] + MOVEMENTS["walk"].tail_s

    def at_strikes(scale: np.ndarray) -> np.ndarray:
        return keyed(t, [(0.0, 0.0), *((strikes[k], scale[k]) for k in steps), (end, 0.0)])

    def at_swings(scale: np.ndarray) -> np.ndarray:
        return keyed(t, [(0.0, 0.0), *((mid_swing[k], scale[k]) for k in steps), (end, 0.0)])

    between = 0.5 * (along[1:] + along[:-1])
    spine = CubicSpline(
        np.concatenate(([0.1], strikes[1:-1] + 0.03 * tau[1:-1], [strikes[-1] + 0.4])),
        np.concatenate(([0.0], between[:-1], along[-1:])),
        bc_type="clamped",
    )
    progress = spine(np.clip(t, 0.1, strikes[-1] + 0.4))
    aside = 0.012 + 0.018 * (np.abs(size) < 0.9)
    bob: list[Key] = [(0.0, 0.0)]
    for k in steps:
        bob += [(mid_swing[k], -0.005), (strikes[k] + 0.04 * tau[k], -0.024 * size[k])]
    p = Posture.standing(len(t))
    going = keyed(t, [(0.0, 0.0), (strikes[1], 1.0), (strikes[-2], 1.0), (end, 0.0)])
    p.hips[:, [0, 2]] = _on_arc(progress, -at_swings(swing * aside), bend)
    p.hips[:, 1] += keyed(t, [*bob, (end, 0.0)])
    p.pelvis[:, YAW] = bend * progress - 0.075 * at_strikes(swing * size)
    p.pelvis[:, ROLL] = -0.050 * at_swings(swing * size)
    p.pelvis[:, PITCH] = 0.03 * going
    p.trunk[:, YAW] = 0.155 * at_strikes(swing * size)
    p.trunk[:, ROLL] = 0.045 * at_swings(swing * size)
    p.trunk[:, PITCH] = 0.03 * going
    p.head[:, YAW] = -0.080 * at_strikes(swing * size)
    for side, sign in enumerate(SIDES):
        forward = -sign * at_strikes(swing * size)
        p.arms[:, side, FLEXION] += 0.32 * forward - 0.03 * going
        p.arms[:, side, ELBOW] += 0.12 * forward + 0.14 * going
        p.arms[:, side, OUTWARD] -= 0.15 * going
        own = [k for k in steps if swing[k] == sign]
        s, out, lift, pitch, pivot = (
            keyed(t, keys) for keys in _foot(own, strikes, tau, along, len(strikes) - 1)
        )
        heading = bend * s
        place = _on_arc(s, sign * out, bend) + p.feet[:, side, 2:] * np.stack(
            (np.sin(heading), np.cos(heading)), -1
        )
        p.feet[:, side, 0], p.feet[:, side, 2] = sign * place[:, 0], place[:, 1]
        p.feet[:, side, 1] += lift
        p.foot_yaw[:, side] += sign * heading - 0.04 * going
        p.foot_pitch[:, side], p.pivot[:, side] = pitch, pivot
    return p


def _footprints(amplitudes: np.ndarray) -> np.ndarray:
    """Where along the path each step sets the foot: a half step, whole steps, and the feet together."""
    length = STEP * np.repeat(amplitudes, 2)
    length[0] *= 0.5
    length[-1] = 0.0
    return np.concatenate(([0.0], np.cumsum(length)))


def _foot(
    own: list[int], strikes: np.ndarray, tau: np.ndarray, along: np.ndarray, last: int
) -> tuple[list[Key], ...]:
    """Keys of one foot: place along and beside the path, lift, pitch and pivot."""
    here = 0.0
    s: list[Key] = [(0.0, 0.0)]
    out: list[Key] = [(0.0, body.HALF_HIPS)]
    lift: list[Key] = [(0.0, 0.0)]
    pitch: list[Key] = [(0.0, 0.0)]
    pivot: list[Key] = [(0.0, 0.0)]
    for k in own:
        strike, step = strikes[k], tau[k]
        leave, aloft = strike - SWING * step, SWING * step
        size = (along[k] - here) / (2.0 * STEP)
        breadth = body.HALF_HIPS if k >= last - 1 else HALF_TRACK
        gain = along[k] - here
        s += [
            (leave, here),
            (leave + 0.28 * aloft, here + 0.26 * gain, 1.6 * gain / aloft),
            (strike, along[k]),
        ]
        out += [(leave, out[-1][1]), (strike, breadth)]
        lift += [(leave, 0.0), (leave + 0.46 * aloft, 0.023 + 0.008 * size), (strike, 0.0)]
        roll, toes_up = 0.25 + 0.80 * size, -0.33 * size
        pitch += [
            (leave - 0.52 * step, 0.0),
            (leave - 0.02 * step, 0.90 * roll, 2.6 * roll / step),
            (leave + 0.12 * aloft, 1.12 * roll),
            (leave + 0.66 * aloft, 0.0, -2.2 * roll / step),
            (strike - 0.04 * step, toes_up),
            (strike + 0.17 * step, 0.0),
        ]
        pivot += [(leave + 0.1 * aloft, 0.0), (strike - 0.08 * step, 1.0)]
        pivot += [(strike + 0.19 * step, 1.0), (strike + 0.36 * step, 0.0)]
        here = along[k]
    return s, out, lift, pitch, pivot


def _on_arc(s: np.ndarray, left: np.ndarray, bend: float) -> np.ndarray:
    """(x, z) of points at length `s` along an arc from the origin, `left` of it."""
    half = 0.5 * bend * s
    chord = s * np.sinc(half / np.pi)
    heading = bend * s
    return np.stack(
        (chord * np.sin(half) + left * np.cos(heading), chord * np.cos(half) - left * np.sin(heading)),
        axis=-1,
    )


def _walked_to(amplitudes: np.ndarray, turn: float) -> Place:
    length = _footprints(amplitudes)[-1]
    x, z = _on_arc(np.array([length]), np.zeros(1), turn / length)[0]
    return Place(float(x), float(z), turn)


def _each_cycle(t: np.ndarray, borders: np.ndarray, amplitudes: np.ndarray, shape: list[Key]) -> np.ndarray:
    """Repeat a curve keyed by phase, 0 at either border, in each cycle at its own pace and size."""
    keys = [
        (start + phase * period, amplitude * value)
        for start, period, amplitude in zip(borders[:-1], np.diff(borders), amplitudes, strict=True)
        for phase, value in shape
    ]
    return keyed(t, [*keys, (borders[-1], 0.0)])


MOVEMENTS = {
    "still": Movement(2.0, _still),
    "walk": Movement(1.12, _walk, lead_s=0.50, tail_s=0.60, arrive=_walked_to),
    "jumping jack": Movement(1.14, _jumping_jack, lead_s=0.32, tail_s=0.38),
    "squat": Movement(2.20, _squat),
    "left side kick": Movement(1.65, _side_kick),
    "right side kick": Movement(1.65, _right_side_kick),
    "arm raise": Movement(2.30, _arm_raise),
}
