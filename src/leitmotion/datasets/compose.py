"""A practice session with its truth: a person made by forward kinematics, who walks, jumps, squats and kicks.

Conventions
-----------
Everything is a curve in continuous time, read at the frames: the same session at 60 and at 120 frames a second is the
same movement. The feet keep to the floor, ``y = 0``, and stand where they stand.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np

from leitmotion.datasets._actions import MOVEMENTS, Movement, Place
from leitmotion.datasets._curves import wander
from leitmotion.datasets._posing import Posture, as_motion, pose
from leitmotion.datasets.skeleton import human_skeleton
from leitmotion.motion import Motion, ParameterError, Segmentation, rotations
from leitmotion.motion.noun import Noun, noun

STILL = "still"
ACTIONS = tuple(MOVEMENTS)
"""What :func:`compose` can make a person do."""

TEMPO_SPREAD, AMPLITUDE_SPREAD = 0.08, 0.06


@dataclasses.dataclass(frozen=True)
class Action:
    """What to do, how often, how fast and how large.

    Parameters
    ----------
    name : str
        One of :data:`ACTIONS`.
    cycles : int
        How many times; of a walk its strides, two steps each, the left foot first.
    period_s : float, optional
        Seconds a cycle takes; the usual length of that action when None.
    amplitude : float
        Size of the movement, 1 is usual.
    turn : float
        By how much a walk turns to the left on its way, radians.

    Raises
    ------
    ParameterError
        When the action is unknown or a number cannot be done.
    """

    name: str
    cycles: int = 1
    period_s: float | None = None
    amplitude: float = 1.0
    turn: float = 0.0

    def __post_init__(self) -> None:
        if self.name not in MOVEMENTS:
            raise ParameterError(f"Action.name must be one of {', '.join(ACTIONS)}, got {self.name!r}.")
        if self.cycles < 1:
            raise ParameterError(f"Action.cycles must be 1 or more, got {self.cycles}.")
        if self.period_s is not None and not 0.5 <= self.period_s < np.inf:
            raise ParameterError(f"Action.period_s must be 0.5 seconds or more, got {self.period_s}.")
        if not 0.2 <= self.amplitude <= 1.1:
            raise ParameterError(f"Action.amplitude must lie in [0.2, 1.1], got {self.amplitude}.")

    @property
    def movement(self) -> Movement:
        """How it is done."""
        return MOVEMENTS[self.name]


@noun
class Session(Noun):
    """A recording of which everything is known.

    Parameters
    ----------
    motion : Motion
        The person in motion, T frames.
    stretches : Segmentation
        What is done when: one stretch per action, without gap or overlap, from frame 0 to T.
    cycles : Segmentation
        One stretch per cycle, labelled with its action; stillness has none.
    """

    motion: Motion
    stretches: Segmentation
    cycles: Segmentation


SESSION = (
    Action(STILL), Action("walk", 4),
    Action(STILL), Action("jumping jack", 5),
    Action(STILL), Action("squat", 4),
    Action(STILL), Action("left side kick", 3),
    Action(STILL), Action("right side kick", 3),
    Action(STILL), Action("arm raise", 3),
    Action(STILL), Action("walk", 4, turn=0.9),
    Action(STILL),
)  # fmt: skip


def compose_session(*, seed: int = 0, rate: float = 120.0) -> Session:
    """Compose the practice session: about a minute of seven movements with stillness between.

    A walk, jumping jacks × 5, squats × 4, side kicks × 3 to the left and × 3 to the right, arm raises × 3, and the
    walk once more.

    Parameters
    ----------
    seed : int
        Same seed, same session, to the bit.
    rate : float
        Frames per second.

    Returns
    -------
    Session
        The motion and its truth.

    Examples
    --------
    >>> from leitmotion.datasets import compose_session
    >>> session = compose_session(seed=1, rate=30)
    >>> session.cycles.labels.count("jumping jack")
    5
    >>> session.stretches.labels[:4]
    ('still', 'walk', 'still', 'jumping jack')
    """
    return compose(SESSION, seed=seed, rate=rate, name="practice session")


def compose(
    actions: Sequence[Action],
    *,
    seed: int = 0,
    rate: float = 120.0,
    height: float = 1.75,
    variation: float = 1.0,
    mirrored: bool = False,
    name: str = "composed",
) -> Session:
    """Compose a session of actions, one after the other, each from and to standing at ease.

    Parameters
    ----------
    actions : sequence of Action
        What the person does.
    seed : int
        Same seed, same session, to the bit.
    rate : float
        Frames per second. It changes how often the movement is looked at, not the movement.
    height : float
        Body height, metres. Everything scales with it.
    variation : float
        How much the person varies, 1 is usual: tempo within ±8 % and size within ±6 % from cycle to cycle, sway
        of half a centimetre, and the noise of a capture, under a millimetre at the hips. 0 is a machine.
    mirrored : bool
        Whether left and right are exchanged, the labels staying what was asked for.
    name : str
        What the recording is called.

    Returns
    -------
    Session
        The motion and its truth.

    Raises
    ------
    ParameterError
        When there is no action or a number is out of its range.

    Examples
    --------
    >>> from leitmotion.datasets import Action, compose
    >>> session = compose([Action("squat", 2, period_s=2.0)], rate=100, variation=0)
    >>> [(label, start, stop) for start, stop, label, _ in session.cycles]
    [('squat', 0, 200), ('squat', 200, 400)]
    """
    if not actions:
        raise ParameterError("actions must hold at least one Action, got none.")
    if not 0.0 <= variation <= 1.5:
        raise ParameterError(f"variation must lie in [0, 1.5], got {variation}.")
    skeleton = human_skeleton(height)
    pace, sway, noise = (np.random.default_rng(child) for child in np.random.SeedSequence(seed).spawn(3))
    plans = [_plan(action, pace, variation) for action in actions]
    seconds = np.cumsum([0.0, *(plan.seconds for plan in plans)])
    frames = _first_frames(seconds, rate)
    t = np.arange(frames[-1]) / rate

    posture = Posture.standing(len(t))
    place = Place()
    for plan, start, first, stop in zip(plans, seconds[:-1], frames[:-1], frames[1:], strict=True):
        part = plan.perform(t[first:stop] - start)
        part.place(*place)
        for field in dataclasses.fields(posture):
            getattr(posture, field.name)[first:stop] = getattr(part, field.name)
        place = _after(place, plan.arrive)
    _sway(posture, variation * wander(sway, t, seconds[-1], 1.1, 16))
    if mirrored:
        posture = posture.mirror()
    hips, local_rotations = pose(skeleton, posture, height=height)
    jitter = variation * wander(noise, t, seconds[-1], 30.0, 3 + 3 * len(skeleton))
    hips = hips + 0.0002 * height * jitter[:, :3]
    local_rotations = rotations.multiply(local_rotations, _small_turns(0.0008 * jitter[:, 3:]))

    borders = [_first_frames(start + plan.borders, rate) for plan, start in zip(plans, seconds)]
    cyclic = [(b, action.name) for b, action in zip(borders, actions, strict=True) if action.name != STILL]
    return Session(
        as_motion(skeleton, hips, local_rotations, rate=rate, name=name),
        Segmentation(frames[:-1], frames[1:], tuple(action.name for action in actions), rate=rate),
        Segmentation(
            np.concatenate([b[:-1] for b, _ in cyclic]) if cyclic else np.zeros(0, np.int64),
            np.concatenate([b[1:] for b, _ in cyclic]) if cyclic else np.zeros(0, np.int64),
            tuple(label for b, label in cyclic for _ in b[1:]),
            rate=rate,
        ),
    )


@dataclasses.dataclass(frozen=True)
class _Plan:
    """One action with the tempo and size of each of its cycles drawn."""

    action: Action
    borders: np.ndarray
    amplitudes: np.ndarray

    @property
    def seconds(self) -> float:
        return float(self.borders[-1]) + self.action.movement.tail_s

    @property
    def arrive(self) -> Place:
        return self.action.movement.arrive(self.amplitudes, self.action.turn)

    def perform(self, t: np.ndarray) -> Posture:
        return self.action.movement.perform(t, self.borders, self.amplitudes, self.action.turn)


def _first_frames(seconds: np.ndarray, rate: float) -> np.ndarray:
    """Index of the first frame at or after each moment, forgiving rounding."""
    return np.ceil(seconds * rate - 1e-6).astype(np.int64)


def _plan(action: Action, rng: np.random.Generator, variation: float) -> _Plan:
    movement = action.movement
    varied = rng.uniform(-1.0, 1.0, (2, action.cycles)) * variation
    period = movement.period_s if action.period_s is None else action.period_s
    if action.name == STILL:
        varied[:] = 0.0
    periods = period / (1.0 + TEMPO_SPREAD * varied[0])
    amplitudes = action.amplitude * (1.0 + AMPLITUDE_SPREAD * varied[1])
    return _Plan(action, movement.lead_s + np.concatenate(([0.0], np.cumsum(periods))), amplitudes)


def _after(place: Place, move: Place) -> Place:
    """Stance after moving on from a stance."""
    sine, cosine = np.sin(place.yaw), np.cos(place.yaw)
    return Place(
        float(place.x + cosine * move.x + sine * move.z),
        float(place.z - sine * move.x + cosine * move.z),
        place.yaw + move.yaw,
    )


def _sway(posture: Posture, drift: np.ndarray) -> None:
    """Let the person breathe and balance; the feet stay."""
    posture.hips[:, [0, 2]] += 0.0028 * drift[:, :2]
    posture.trunk += 0.015 * drift[:, 2:5]
    posture.head += 0.030 * drift[:, 5:8]
    posture.arms[..., :4] += 0.035 * drift[:, 8:16].reshape(-1, 2, 4)


def _small_turns(angles: np.ndarray) -> np.ndarray:
    """Quaternions (T, J, 4) of small rotation vectors (T, 3 J)."""
    half = 0.5 * angles.reshape(len(angles), -1, 3)
    return rotations.normalize(np.concatenate((np.ones((*half.shape[:2], 1)), half), axis=-1))
