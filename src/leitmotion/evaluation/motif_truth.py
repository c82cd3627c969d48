"""What a movement truly is, step by step, and which motifs a stretch of it therefore carries.

Conventions
-----------
A movement is a row of steps: ways gone between two states, there (not reversed) or back, as they are or mirrored.
*Place* x of a frame counts steps: it grows by 1 from the start of a step to its end, slowly from and to a halt, and
stays where the body stays.
The same holds for two steps when they are one way gone alike; a *reversal* is the same way gone back, a *reflection*
its mirror image; symmetric ways are their own mirror image.

References
----------
Paper S, sections 3.2 to 3.5, which define the motifs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

CARRIED = 0.75  # share of a stretch that must carry the motif which is told of it
ALIGNED = 0.35  # steps by which two stretches that are told to correspond may be out of step
NEAR_STATE = 0.35  # share of a step that may pass for the state at its end
ROUNDS = 1.75  # a run repeats itself that lasts so many times its period
ALL = 0.9  # share of a stretch that counts as all of it
SAMPLES = 200  # places at which a stretch is looked at
Stretch = tuple[int, int]


class GoneStep(NamedTuple):
    """One way gone, frames ``[start, stop)``."""

    path: str
    start: int
    stop: int
    reversed: bool
    mirrored: bool
    symmetric: bool
    source: str
    """The state in which it begins, in time, with a star behind the mirror image of another; empty where none is."""
    target: str
    halts: tuple[bool, bool] = (True, True)
    """Whether the body comes to a halt at its beginning, at its end."""


class MotifSpan(NamedTuple):
    """A motif of a stretch ``[start, stop)`` of frames, as told or as asked for."""

    motif: str
    start: int
    stop: int
    cyclic: bool = False
    partner: Stretch | None = None
    widest: Stretch | None = None
    """Of one asked for: how far it may be told to reach; by default no farther than the stretch."""
    confidence: float = 1.0


class Course(NamedTuple):
    """Steps with the places of their frames."""

    steps: Sequence[GoneStep]
    knots: np.ndarray
    """(2 K,) frames at which steps start and stop."""

    @classmethod
    def of(cls, steps: Sequence[GoneStep]) -> Course:
        """Take steps in the order of time."""
        return cls(
            steps, np.array([frame for step in steps for frame in (step.start, step.stop)], dtype=float)
        )

    def place(self, frames: np.ndarray) -> np.ndarray:
        """Tell the places of frames (T,)."""
        count = np.arange(len(self.steps))
        even = np.interp(frames, self.knots, np.stack((count, count + 1), axis=1).ravel().astype(float))
        which = np.minimum(even.astype(int), len(self.steps) - 1)
        first, last = np.array([step.halts for step in self.steps])[which].T
        share = even - which
        quarter = 0.5 * np.pi * share
        to_halt = np.where(first, np.sin(quarter) ** 2, np.sin(quarter))
        eased = np.where(last, to_halt, np.where(first, 1.0 - np.cos(quarter), share))
        return np.asarray(which + eased)

    def moving(self, stretch: Stretch) -> np.ndarray:
        """Tell places of a stretch evenly, however fast the body comes from one to the next."""
        first, last = self.place(np.array(stretch, dtype=float))
        return first + (last - first) * (np.arange(SAMPLES) + 0.5) / SAMPLES

    def soft(self, stretch: Stretch) -> Stretch:
        """Take a stretch with the halts at its ends."""
        before = [step.stop for step in self.steps if step.stop <= stretch[0]]
        after = [step.start for step in self.steps if step.start >= stretch[1]]
        end = max(stretch[1], self.steps[-1].stop)
        return max(before, default=0), min(after, default=end)

    def state(self, border: int) -> str:
        """Name the state between two steps."""
        return self.steps[border].source if border < len(self.steps) else self.steps[-1].target

    def alike(self, j: int, k: int, *, mirror: bool, back: bool) -> bool:
        """Whether step k is step j again: as its mirror image, gone back, or neither."""
        if not (0 <= j < len(self.steps) and 0 <= k < len(self.steps)):
            return False
        a, b = self.steps[j], self.steps[k]
        reflected = a.symmetric or (a.mirrored != b.mirrored) == mirror
        return a.path == b.path and reflected and (a.reversed != b.reversed) == back


def carries(course: Course, span: MotifSpan) -> bool:
    """Whether a stretch truly carries the motif that is told of it.

    Parameters
    ----------
    course : Course
        The steps of the movement.
    span : MotifSpan
        What is told.

    Returns
    -------
    bool
        Whether three quarters of it do by the definitions of paper S, whatever else fits it better.
    """
    rule = _RULES[span.motif]
    if span.partner is None:
        return rule(course, (span.start, span.stop), (span.start, span.stop))
    return rule(course, (span.start, span.stop), span.partner)


def _still(course: Course, stretch: Stretch, _: Stretch) -> bool:
    """Around a halt, and not far into the steps beside it."""
    start, stop = stretch
    for border in range(len(course.steps) + 1):
        before = course.steps[border - 1] if border else None
        after = course.steps[border] if border < len(course.steps) else None
        first = (before.stop if before.halts[1] else np.inf) if before else 0
        last = (after.start if after.halts[0] else -np.inf) if after else np.inf
        if before and np.isfinite(first):
            first -= NEAR_STATE * (before.stop - before.start)
        if after and np.isfinite(last):
            last += NEAR_STATE * (after.stop - after.start)
        if min(stop, last) - max(start, first) >= CARRIED * (stop - start):
            return True
    return False


def _symmetric(course: Course, stretch: Stretch, _: Stretch) -> bool:
    """In symmetric steps, or close to where a symmetric state is passed; over no asymmetric step."""
    places = course.place(np.arange(*stretch) + 0.5)
    return _over_none(course, stretch) and bool(np.mean([_level(course, x) for x in places]) >= ALL)


def _over_none(course: Course, stretch: Stretch) -> bool:
    """Whether no asymmetric step lies within a stretch by more than half."""
    return all(
        step.symmetric
        or min(step.stop, stretch[1]) - max(step.start, stretch[0]) <= 0.5 * (step.stop - step.start)
        for step in course.steps
    )


def _level(course: Course, x: float) -> bool:
    step = course.steps[min(int(x), len(course.steps) - 1)]
    border = round(x)
    symmetric_state = not _sided(course, border)
    return step.symmetric or (symmetric_state and abs(x - border) <= NEAR_STATE)


def _sided(course: Course, border: int) -> bool:
    """Whether the state between two steps is asymmetric: the steps beside it are, and are no reflected reversals."""
    beside = course.steps[max(border - 1, 0) : border + 1]
    if any(step.symmetric for step in beside):
        return False
    return not (len(beside) == 2 and course.alike(border - 1, border, mirror=True, back=True))


def _share_symmetric(course: Course, stretch: Stretch) -> float:
    return float(np.mean([course.steps[int(x)].symmetric for x in course.moving(stretch) - 1e-9]))


def _follows(course: Course, a: Stretch, b: Stretch, *, mirror: bool, back: bool) -> bool:
    """Whether the steps of one stretch are those of the other, at the lag, or about the middle, that they tell."""
    places, others = course.moving(a), course.moving(b)
    ends = zip(places[[0, -1]], others[[-1, 0]] if back else others[[0, -1]], strict=True)
    for about in [p + q if back else q - p for p, q in ends]:
        link = round(about)
        if abs(about - link) > ALIGNED or (not back and not mirror and link == 0):
            continue
        if all(
            np.mean([course.alike(j, k, mirror=mirror, back=back) for j, k in links]) >= CARRIED
            for links in (_linked(places, link, back), _linked(others, link if back else -link, back))
        ):
            return True
    return False


def _linked(places: np.ndarray, link: int, back: bool) -> list[tuple[int, int]]:
    """Each place's step with the one that corresponds to it at a lag, or about a middle."""
    steps = np.floor(places).astype(int)
    return list(zip(steps.tolist(), (link - 1 - steps if back else steps + link).tolist(), strict=True))


def _same_posture(course: Course, a: Stretch, b: Stretch, *, mirror: bool) -> bool:
    """Whether some way leads both through one posture, or both are at one state."""
    x, y = (float(course.place(np.array([0.5 * sum(each)]))[0]) for each in (a, b))
    borders = round(x), round(y)
    if max(abs(x - borders[0]), abs(y - borders[1])) <= NEAR_STATE:
        names = [course.state(border) for border in borders]
        image = names[0] if not _sided(course, borders[0]) else _starred(names[0])
        if (image if mirror else names[0]) == names[1]:
            return True
    j, k = (min(int(each), len(course.steps) - 1) for each in (x, y))
    for back in (False, True):
        apart = abs((x - j) - (1.0 - (y - k) if back else y - k))
        if apart <= ALIGNED and course.alike(j, k, mirror=mirror, back=back):
            return True
    return False


def _starred(name: str) -> str:
    return name[:-1] if name.endswith("*") else name + "*"


def _returns(course: Course, stretch: Stretch) -> bool:
    """Whether a stretch is a loop, or goes round for more than one."""
    places = course.moving(stretch)
    first, last = float(places[0]), float(places[-1])
    length = last - first
    for lag in range(1, int(length + ALIGNED) + 1):
        steps = np.floor(places[places < last - lag]).astype(int)
        if length >= ROUNDS * lag and np.mean(
            [course.alike(j, j + lag, mirror=False, back=False) for j in steps]
        ) >= CARRIED:  # fmt: skip
            return True
        if abs(length - lag) <= ALIGNED and _same_posture(
            course, (stretch[0], stretch[0] + 1), (stretch[1] - 1, stretch[1]), mirror=False
        ):
            return True
    return False


def _cycle(course: Course, stretch: Stretch, *, symmetric: bool) -> bool:
    if not _returns(course, stretch):
        return False
    share = _share_symmetric(course, stretch)
    if symmetric:
        return share >= ALL and _over_none(course, stretch)
    within = {int(x) for x in course.moving(stretch) - 1e-9}
    turned = any(
        course.alike(j, j + 1, mirror=True, back=True)
        for j in within
        if not course.steps[j].symmetric and j + 1 in within
    )
    return share < 1.0 and not turned


def _turns(course: Course, stretch: Stretch, *, mirror: bool, symmetric: bool) -> bool:
    """Whether a stretch goes back the way it came, about a border near its middle."""
    places = course.moving(stretch)
    if (_share_symmetric(course, stretch) >= CARRIED and _over_none(course, stretch)) != symmetric:
        return False
    for border in range(1, len(course.steps)):
        inside = places[(2 * border - places >= places[0]) & (2 * border - places <= places[-1])]
        if len(inside) < 0.5 * len(places):
            continue
        steps = np.floor(inside).astype(int)
        if np.mean([course.alike(j, 2 * border - 1 - j, mirror=mirror, back=True) for j in steps]) >= CARRIED:
            return True
    return False


def _anti_phase(course: Course, stretch: Stretch) -> bool:
    places = course.moving(stretch)
    length = float(places[-1] - places[0])
    if _share_symmetric(course, stretch) > 1.0 - CARRIED:
        return False
    for lag in range(1, int(length) + 1):
        steps = np.floor(places[places < places[-1] - lag]).astype(int)
        if length >= ROUNDS * lag and np.mean(
            [course.alike(j, j + lag, mirror=True, back=False) for j in steps]
        ) >= CARRIED:  # fmt: skip
            return True
    return False


Rule = Callable[[Course, Stretch, Stretch], bool]
_RULES: dict[str, Rule] = {
    "stillness": _still,
    "state_repetition": lambda c, a, b: _same_posture(c, a, b, mirror=False),
    "path_repetition": lambda c, a, b: _follows(c, a, b, mirror=False, back=False),
    "path_reversal": lambda c, a, b: _follows(c, a, b, mirror=False, back=True),
    "symmetric_path": _symmetric,
    "reflected_state_repetition": lambda c, a, b: _same_posture(c, a, b, mirror=True),
    "reflected_path_repetition": lambda c, a, b: _follows(c, a, b, mirror=True, back=False),
    "symmetric_cycle": lambda c, a, _: _cycle(c, a, symmetric=True),
    "asymmetric_cycle": lambda c, a, _: _cycle(c, a, symmetric=False),
    "symmetric_palindrome": lambda c, a, _: _turns(c, a, mirror=False, symmetric=True),
    "asymmetric_palindrome": lambda c, a, _: _turns(c, a, mirror=False, symmetric=False),
    "anti_phase": lambda c, a, _: _anti_phase(c, a),
    "anti_palindrome": lambda c, a, _: _turns(c, a, mirror=True, symmetric=False),
}
MOTIF_KINDS = tuple(_RULES)
"""The motifs that can be judged."""
