"""The seven motions of paper S, 3.5 and 3.6.1, as curves of the links of the chain, with their graphs."""

import numpy as np
from scipy.interpolate import CubicSpline

from leitmotion.body import CHAIN_LINKS
from leitmotion.features.rotations import sequence_of
from leitmotion.motion import rotations
from oracles.mirror import swapped

INDEX = {name: k for k, name in enumerate(CHAIN_LINKS)}
PARTNER = [INDEX[swapped(name)] for name in CHAIN_LINKS]
LIMBS = ("femur", "tibia", "humerus", "radius")

GRAPHS = {
    "butterfly": "X̄; x̄x →",
    "jumping jacks": "X̄, Ȳ; x̄y ↔",
    "jogging": "A, X̄, A*; ax ↔, (ax)* ↔",
    "walking": "A, A*; aa* →, (aa*)* →",
    "limping": "A; aa →",
    "side kicks": "A, X̄, A*; aa →, ax ↔, (ax)* ↔, (aa)* →",
    "sun salutation": "X̄, Ȳ, Z̄, W̄, V̄; x̄y ↔, x̄x ↔, ȳz ↔, z̄w ↔, wv →, v̄v →, v̄w →",
}
"""Named in the order of first visits."""


def posture(**degrees):
    """Rotation vectors of the links (15, 3); a limb's is that of the left, the right one is its image."""
    links = np.zeros((len(CHAIN_LINKS), 3))
    for name, vector in degrees.items():
        if name in LIMBS:
            links[INDEX[f"left_{name}"]] = vector
            links[INDEX[f"right_{name}"]] = np.multiply(vector, (1, -1, -1))
        else:
            links[INDEX[name]] = vector
    return np.radians(links)


def image(links):
    """The posture in the mirror."""
    return links[..., PARTNER, :] * [1, -1, -1]


def changed(links, **degrees):
    """The posture with some links turned further."""
    links = links.copy()
    for name, vector in degrees.items():
        links[INDEX[name]] += np.radians(vector)
    return links


def eased(u):
    return u**3 * (10 - 15 * u + 6 * u**2)


class Take:
    """A performance that grows, piece by piece, with its own tempo, size and dwelling."""

    def __init__(self, rng, rate, varied):
        self.rng, self.rate, self.varied = rng, rate, varied
        self.tempo = rng.uniform(0.7, 1.4) if varied else 1.0
        self.size = rng.uniform(0.8, 1.2) if varied else 1.0
        self.dwells = varied and rng.random() < 0.7
        self.pieces = []

    def curve(self, seconds, at):
        """Go along postures at(u), u from 0 to 1, with a tempo that wavers."""
        varied = self.rng.uniform(0.85, 1.15) if self.varied else 1.0
        u = np.linspace(0, 1, max(4, round(seconds * self.rate / (self.tempo * varied))), endpoint=False)
        if self.varied:
            u = u + self.rng.uniform(-0.06, 0.06) * np.sin(2 * np.pi * u)
        self.pieces.append(at(u))

    def hold(self, links):
        """Keep still for up to a second."""
        count = round(self.rng.uniform(0, 1) * self.rate) if self.dwells else 0
        self.pieces.append(np.repeat(links[None], count, axis=0))

    def go(self, seconds, *through):
        """Go from halt to halt, through postures."""
        way = CubicSpline(np.linspace(0, 1, len(through)), np.array(through), bc_type="clamped")
        self.curve(seconds, lambda u: way(eased(u) if len(through) == 2 else u))

    def chain(self, noise, offset):
        """What a suit sees: every frame with noise, one side turned by a constant."""
        q = rotations.from_rotation_vector(np.concatenate(self.pieces) * self.size)
        if offset:
            side = self.rng.choice(["left", "right"])
            for name in LIMBS:
                axis = self.rng.normal(size=3)
                turn = np.radians(self.rng.uniform(5, 10)) * axis / np.linalg.norm(axis)
                link = INDEX[f"{side}_{name}"]
                q[:, link] = rotations.multiply(q[:, link], rotations.from_rotation_vector(turn[None]))
        shaken = rotations.from_rotation_vector(self.rng.normal(size=(*q.shape[:2], 3)) * np.radians(noise))
        return sequence_of(rotations.multiply(q, shaken), CHAIN_LINKS, self.rate)


def performed(name, seed=0, *, rate=60.0, noise=3.0, varied=True):
    """A chain of one of the motions; with variations, or plain."""
    rng = np.random.default_rng([seed, list(GRAPHS).index(name)])
    take = Take(rng, rate, varied)
    MOTIONS[name](take)
    return take.chain(noise, varied)


def waves(base, *terms):
    """A closed loop: base plus, for each (link, axis, degrees, phase, harmonic), a wave."""

    def at(u):
        links = np.tile(base, (len(u), 1, 1))
        for link, axis, degrees, phase, harmonic in terms:
            links[:, INDEX[link], axis] += np.radians(degrees) * np.cos(2 * np.pi * harmonic * u + phase)
        return links

    return at


def butterfly(take):
    both = [
        (f"{side}_{name}", axis, degrees * (sign if axis else 1), phase, 1)
        for side, sign in (("left", 1), ("right", -1))
        for name, axis, degrees, phase in (
            ("humerus", 0, 60, 0.0), ("humerus", 2, 60, 1.6), ("radius", 1, 30, 1.0),
            ("femur", 0, 20, 2.0), ("tibia", 0, 25, 2.6),
        )
    ]  # fmt: skip
    loop = waves(posture(), *both, *((name, 0, 8, -0.3 * k, 1) for k, name in enumerate(CHAIN_LINKS[:7])))
    for _ in range(4):
        take.curve(1.3, loop)
        take.hold(loop(np.zeros(1))[0])


def jumping_jacks(take):
    down, up = posture(humerus=(0, 0, -60)), posture(humerus=(0, 0, 75), femur=(0, 0, 25), radius=(0, -10, 0))
    take.hold(down)
    for _ in range(3):
        for a, b in ((down, up), (up, down)):
            take.go(0.6, a, b)
            take.hold(b)


def jogging(take):
    base = posture(humerus=(0, 0, -65), radius=(0, -70, 0), femur=(-20, 0, 0), tibia=(35, 0, 0))
    once = [
        (f"{side}_{name}", axis, degrees * sign, 0, 1)
        for side, sign in (("left", 1), ("right", -1))
        for name, axis, degrees in (("femur", 0, -28), ("tibia", 0, 30), ("humerus", 1, 20 * sign))
    ]
    twice = [(f"{side}_tibia", 0, 8, 0, 2) for side in ("left", "right")]
    loop = waves(base, *once, *twice, ("pelvis", 0, 4, 0, 2))
    for _ in range(3):
        for half in (0.0, 0.5):
            take.hold(loop(np.array([half]))[0])
            take.curve(0.45, lambda u, half=half: loop(half + (eased(u) if take.dwells else u) / 2))
    take.hold(loop(np.zeros(1))[0])


def gait(right):
    terms = [("pelvis", 2, 4 if right == 1 else 9, -1.6, 1)]
    for side, phase, share in (("left", 0.0, 1.0), ("right", np.pi, right)):
        terms += [
            (f"{side}_femur", 0, -25 * share, phase, 1),
            (f"{side}_femur", 0, 8 * share, 2 * phase + 0.5, 2),
            (f"{side}_tibia", 0, 28 * share, phase + 1.7, 1),
            (f"{side}_tibia", 0, 8 * share, 2 * phase + 2, 2),
            (f"{side}_humerus", 1, 22 * share, 0.0, 1),
        ]
    return waves(posture(humerus=(0, 0, -70), radius=(0, -20, 0), tibia=(20, 0, 0)), *terms)


def walking(take):
    for _ in range(4):
        take.curve(1.1, gait(1.0))


def limping(take):
    loop = gait(0.3)
    for _ in range(4):
        take.curve(1.2, loop)
        take.hold(loop(np.zeros(1))[0])


def side_kicks(take):
    stance = changed(
        posture(humerus=(0, 0, -30), radius=(0, -90, 0), femur=(-10, 0, 8), tibia=(20, 0, 0)),
        pelvis=(0, 0, 6), head=(0, 15, 0), upper_neck=(0, 15, 0), left_femur=(-5, 25, 4),
        right_femur=(15, 3, -2), right_tibia=(10, 0, 0), left_humerus=(0, 0, 25),
    )  # fmt: skip
    drawn = changed(stance, left_femur=(-75, 0, 10), left_tibia=(80, 0, 0), pelvis=(0, 0, -8))
    out = changed(stance, left_femur=(-55, 0, 40), left_tibia=(-15, 0, 0), pelvis=(0, 0, -25))
    low = changed(stance, left_femur=(-10, 0, 35), left_tibia=(-5, 0, 0), pelvis=(0, 0, -12))
    even, odd = (stance + image(stance)) / 2, (stance - image(stance)) / 2
    middle = posture(humerus=(0, 0, -50), radius=(0, -60, 0), femur=(-12, 0, 12), tibia=(25, 0, 0)) - even

    def switched(u):
        turn = np.pi * eased(u)[:, None, None]
        return even + odd * np.cos(turn) + middle * np.sin(turn) ** 2

    kick = (stance, drawn, out, low, stance)
    take.hold(stance)
    for side in (lambda links: links, image):
        for _ in range(3):
            take.go(1.3, *map(side, kick))
            take.hold(side(stance))
        if side is not image:
            take.curve(1.2, switched)
            take.hold(image(stance))


def sun_salutation(take):
    y, x = posture(humerus=(0, 0, -70)), posture(humerus=(0, 0, 80), upper_back=(-4, 0, 0))
    forward = posture(humerus=(0, -60, -40), radius=(0, -25, 0))
    t = posture(pelvis=(70, 0, 0), femur=(-70, 0, 0), humerus=(0, -10, -40), lower_back=(4, 0, 0))
    w = posture(pelvis=(120, 0, 0), femur=(-110, 0, 0), humerus=(0, -60, 40), lower_back=(12, 0, 0),
                upper_back=(12, 0, 0), thorax=(10, 0, 0), head=(15, 0, 0))  # fmt: skip
    v = posture(pelvis=(75, 0, 0), humerus=(0, -80, 0), head=(-10, 0, 0))
    low = posture(pelvis=(85, 0, 0), humerus=(0, 20, -50), radius=(0, -95, 0), head=(-10, 0, 0))
    arch = posture(pelvis=(45, 0, 0), femur=(8, 0, 0), lower_back=(-15, 0, 0), upper_back=(-15, 0, 0),
                   thorax=(-10, 0, 0), humerus=(0, -20, -60), head=(-20, 0, 0))  # fmt: skip
    kicked = (w + v) / 2
    kicked[INDEX["left_femur"]] = np.radians([5, 0, 0])
    kicked[INDEX["right_femur"]] = np.radians([-110, 0, 0])
    kicked[INDEX["right_tibia"]] = np.radians([80, 0, 0])
    ways = [
        (1.3, y, x), (1.3, x, y), (0.7, y, forward), (0.7, forward, y), (1.3, y, x), (1.3, x, t), (1.3, t, w),
        (1.6, w, kicked, v), (2.6, v, low, arch, v), (1.0, v, w), (1.3, w, t), (1.3, t, x), (1.3, x, y),
    ]  # fmt: skip
    take.hold(y)
    for seconds, *through in ways * 2:
        take.go(seconds, *through)
        if through[-1] is not forward:
            take.hold(through[-1])


MOTIONS = {
    "butterfly": butterfly,
    "jumping jacks": jumping_jacks,
    "jogging": jogging,
    "walking": walking,
    "limping": limping,
    "side kicks": side_kicks,
    "sun salutation": sun_salutation,
}
