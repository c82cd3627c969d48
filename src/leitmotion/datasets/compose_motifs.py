"""The motions by which paper S explains its taxonomy, composed with their truth: motifs, states and paths.

Conventions
-----------
A motion is a row of steps, each of which goes one way between two states, there or back, as it is or mirrored. Frames
are half-open. States, paths and notation are written as :mod:`leitmotion.discovery.motion_graph` writes them.

References
----------
Paper S, section 3.5 (figures 64 to 69) and section 3.6.1 (figure 70).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.datasets._angles import ANGLES, embodied, on_hands, rotations_of
from leitmotion.datasets._curves import wander
from leitmotion.datasets._dances import DANCES
from leitmotion.datasets._motif_truth import (
    TrueMotif,
    TruePath,
    TrueState,
    TrueStep,
    true_motifs,
    true_paths,
    true_states,
    true_steps,
    written,
)
from leitmotion.datasets._ways import Dance, go
from leitmotion.datasets.skeleton import human_skeleton
from leitmotion.motion import Motion, ParameterError
from leitmotion.motion.rotations import from_rotation_vector, multiply

MOTIONS = tuple(DANCES)
"""What :func:`compose_motif` can compose."""
PER_REPETITION = 0.15  # of the range of amplitudes, that single repetitions differ by
FINE = 200.0  # hertz, at which time is warped


class Variation(NamedTuple):
    """How much a composed motion varies; each kind is drawn on its own."""

    noise_deg: float = 3.0
    """σ of the noise: each joint, in each frame, is turned by so much about each of its axes."""
    amplitude: float = 0.20
    """The whole motion is larger or smaller by up to this share; each step by up to 0.15 of it besides."""
    tempo: tuple[float, float] = (0.7, 1.4)
    """Range of how fast it is, at any time."""
    warp: float = 0.15
    """How much the tempo wanders smoothly within a motion: σ of its logarithm, as far as the range allows."""
    offset_deg: tuple[float, float] = (5.0, 10.0)
    """Range by which the joints of one arm, one leg or one whole side are turned askew, all along."""
    dwell_s: tuple[float, float] = (0.0, 1.0)
    """Range of how long the body stays where it comes to a halt at a state."""


USUAL = Variation()


class ComposedMotif(NamedTuple):
    """A motion of which everything is known."""

    motion: Motion
    """T frames."""
    spans: tuple[TrueMotif, ...]
    """The motifs that a detector should find, in order of their starts."""
    steps: tuple[TrueStep, ...]
    """The ways that were gone, one after the other."""
    states: tuple[TrueState, ...]
    """In order of their first visits."""
    paths: tuple[TruePath, ...]
    """In order of their first visits."""
    notation: str
    """The motion graph as paper S writes it: "A, X̄, A*; ax ↔, (ax)* ↔"."""


def compose_motif(
    name: str,
    *,
    seed: int = 0,
    rate: float = 120.0,
    height: float = 1.75,
    variation: Variation | None = USUAL,
) -> ComposedMotif:
    """Compose one of the motions of paper S, sections 3.5 and 3.6.1.

    Parameters
    ----------
    name : str
        One of :data:`MOTIONS`.
    seed : int
        Same seed, same motion, to the bit.
    rate : float
        Frames per second.
    height : float
        Body height, metres.
    variation : Variation or None
        How much it varies; None composes the exact motion, in which the seed plays no part.

    Returns
    -------
    ComposedMotif
        The motion and its truth, which follows every variation.

    Raises
    ------
    ParameterError
        When there is no such motion, or a number is out of its range.

    Examples
    --------
    >>> from leitmotion.datasets import compose_motif
    >>> jacks = compose_motif("jumping jacks", rate=30, variation=None)
    >>> jacks.notation
    'X̄, Ȳ; x̄y ↔'
    >>> [(span.motif, span.cyclic) for span in jacks.spans]
    [('symmetric_path', False), ('symmetric_palindrome', True)]
    """
    if name not in DANCES:
        raise ParameterError(
            f"There is no composed motion {name!r}.", remedy=f"There are {', '.join(MOTIONS)}."
        )
    if not (np.isfinite(rate) and rate > 0):
        raise ParameterError(f"rate must be a positive number of frames a second, got {rate}.")
    dance = DANCES[name]()
    size, pace, rest, askew, noise = (
        np.random.default_rng(child) for child in np.random.SeedSequence(seed).spawn(5)
    )
    starts, stops, warped, seconds = _times(dance, variation, pace, rest)
    frames = int(_frames(np.array(seconds), rate))
    t = np.arange(frames) / rate
    postures = _postures(dance, t, starts, stops, warped)
    if variation is not None:
        postures = _resized(dance, postures, t, 0.5 * (starts + stops), variation.amplitude, size)
    skeleton = human_skeleton(height)
    lift, hands = (postures[:, ANGLES.index(name)] for name in ("lift", "hands"))
    local_rotations = rotations_of(skeleton, postures)
    if hands.any():
        local_rotations = on_hands(skeleton, local_rotations, hands)
    motion = embodied(skeleton, local_rotations, height * lift, rate=rate, name=name, afloat=dance.afloat)
    if variation is not None:
        turned = multiply(local_rotations, _askew(skeleton.names, variation.offset_deg, askew))
        shaken = noise.standard_normal((frames, len(skeleton), 3)) * np.radians(variation.noise_deg)
        motion = motion.replace(local_rotations=multiply(turned, from_rotation_vector(shaken)))
    steps = true_steps(dance, _frames(starts, rate), _frames(stops, rate))
    states, paths = true_states(steps, frames), true_paths(steps)
    spans = true_motifs(dance, steps, frames, rate)
    return ComposedMotif(motion, spans, steps, states, paths, written(states, paths))


def _times(
    dance: Dance, variation: Variation | None, pace: np.random.Generator, rest: np.random.Generator
) -> tuple[np.ndarray, np.ndarray, list[tuple[np.ndarray, np.ndarray]], float]:
    """When each step starts and stops (K,), when within it its shares are done, and how long all takes; seconds."""
    usual = [dance.ways[step.way].seconds for step in dance.steps]
    seconds = float(np.sum(usual))
    tempo = np.ones(int(seconds * FINE) + 2)
    if variation is not None:
        wandering = wander(pace, np.arange(len(tempo)) / FINE, seconds + 1.0, 0.8, 1)[:, 0]
        middle = pace.uniform(*np.log(variation.tempo))
        tempo = np.exp(np.clip(middle + variation.warp * wandering, *np.log(variation.tempo)))
    now, before = 0.0, 0.0
    starts, stops, warped = [], [], []
    for step, length in zip(dance.steps, usual, strict=True):
        now += _dwell(dance, step.way, step.reversed, variation, rest)
        share = np.linspace(0.0, 1.0, int(np.ceil(length * FINE)) + 1)
        slow = 1.0 / np.interp((before + share * length) * FINE, np.arange(len(tempo)), tempo)
        passed = np.concatenate(([0.0], np.cumsum(0.5 * (slow[1:] + slow[:-1]) * np.diff(share) * length)))
        warped.append((now + passed, share))
        starts.append(now)
        now += float(passed[-1])
        stops.append(now)
        before += length
    last = dance.steps[-1]
    now += _dwell(dance, last.way, not last.reversed, variation, rest)
    return np.array(starts), np.array(stops), warped, now


def _dwell(
    dance: Dance, way: str, backwards: bool, variation: Variation | None, rest: np.random.Generator
) -> float:
    """Seconds that the body stays where a step begins: none where it runs on, or turns back at no state."""
    gone = dance.ways[way]
    state, halts = (gone.target, gone.halts[1]) if backwards else (gone.source, gone.halts[0])
    if not halts or not state:
        return 0.0
    return dance.dwell_s if variation is None else float(rest.uniform(*variation.dwell_s))


def _postures(
    dance: Dance,
    t: np.ndarray,
    starts: np.ndarray,
    stops: np.ndarray,
    warped: list[tuple[np.ndarray, np.ndarray]],
) -> np.ndarray:
    """Postures (T, 35) at times (T,); between two steps, that in which the next begins."""
    which = np.searchsorted(stops, t, side="right").clip(max=len(stops) - 1)
    made = np.empty((len(t), len(dance.middle)))
    for k, step in enumerate(dance.steps):
        mine = which == k
        share = np.interp(t[mine], *warped[k])
        made[mine] = go(dance.ways[step.way], step, share)
    return made


def _resized(
    dance: Dance,
    postures: np.ndarray,
    t: np.ndarray,
    at: np.ndarray,
    amplitude: float,
    size: np.random.Generator,
) -> np.ndarray:
    """Make the whole movement larger or smaller, and each repetition a little."""
    whole = 1.0 + amplitude * size.uniform(-1.0, 1.0)
    each = 1.0 + PER_REPETITION * amplitude * size.uniform(-1.0, 1.0, len(at))
    return dance.middle + whole * np.interp(t, at, each)[:, None] * (postures - dance.middle)


def _askew(names: tuple[str, ...], degrees: tuple[float, float], askew: np.random.Generator) -> np.ndarray:
    """Turns (J, 4) of the joints of one arm, one leg or one whole side, each about an axis of its own."""
    side = ("Left", "Right")[askew.integers(2)]
    limbs = (("Arm", "ForeArm"), ("UpLeg", "Leg"), ("Arm", "ForeArm", "UpLeg", "Leg"))[askew.integers(3)]
    axes = askew.standard_normal((len(names), 3))
    axes *= np.radians(askew.uniform(*degrees, (len(names), 1))) / np.linalg.norm(axes, axis=1, keepdims=True)
    chosen = np.array([name in {side + limb for limb in limbs} for name in names])
    return from_rotation_vector(axes * chosen[:, None])


def _frames(seconds: np.ndarray, rate: float) -> np.ndarray:
    """Index of the first frame at or after each moment, forgiving rounding."""
    return np.ceil(seconds * rate - 1e-6).astype(np.int64)
