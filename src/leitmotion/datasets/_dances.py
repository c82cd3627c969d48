"""The six motions of paper S, section 3.5, and the sun salutation of section 3.6.1, as ways between states."""

from __future__ import annotations

import numpy as np

from leitmotion.datasets._angles import ANGLES, SIDE, posture
from leitmotion.datasets._ways import Curve, Dance, Motif, Step, Way, across, around, part, through


def butterfly() -> Dance:
    """Swim five strokes: both arms pull beneath the body and come back over the water, two kicks to a stroke."""
    prone = {"pelvis_pitch": 1.42, "ankle": 0.6, "turn": -0.05}
    stroke = around(
        [
            posture(**prone, flexion=2.75, abduction=0.20, elbow=0.10, hip=0.10, knee=0.15, head_pitch=0.15),
            posture(**prone, flexion=2.30, abduction=0.50, elbow=0.45, hip=0.25, knee=0.85, trunk_pitch=-0.15),
            posture(**prone, flexion=1.35, abduction=0.40, elbow=1.35, hip=-0.15, knee=0.15, head_pitch=-0.20),
            posture(**prone, flexion=0.25, abduction=0.12, elbow=0.45, hip=0.20, knee=0.70,
                    head_pitch=-0.75, trunk_pitch=-0.35),
            posture(**prone, flexion=0.75, abduction=1.40, elbow=0.20, hip=-0.05, knee=0.20,
                    head_pitch=-0.45, trunk_pitch=-0.10, shrug=0.15),
            posture(**prone, flexion=2.20, abduction=0.95, elbow=0.10, hip=0.00, knee=0.10,
                    head_pitch=0.25, trunk_pitch=0.15, shrug=0.25),
        ]
    )  # fmt: skip
    way = Way("X", "X", stroke, 1.5, (False, False), symmetric=True)
    motifs = (Motif("symmetric_path", (0, 5)), Motif("symmetric_cycle", (0, 5), cyclic=True))
    middle = posture(**prone, flexion=1.4, abduction=0.7, hip=0.05, knee=0.3)
    return Dance({"xx": way}, (Step("xx"),) * 5, motifs, afloat=1.4, middle=middle)


def jumping_jacks() -> Dance:
    """Jump apart and together six times, the arms up and down."""
    together = posture(abduction=0.10, hip=0.22, knee=0.42, spread=0.0)
    middle = posture(abduction=1.45, outward=0.6, spread=0.24, hip=0.05, knee=0.12, ankle=0.35, lift=0.05)
    apart = posture(abduction=2.75, outward=1.2, elbow=0.35, shrug=0.30, spread=0.46, hip=0.20, knee=0.36)
    way = Way("X", "Y", through([together, middle, apart]), 0.62, symmetric=True)
    motifs = (Motif("symmetric_path", (0, 12)), Motif("symmetric_palindrome", (0, 12), cyclic=True))
    return Dance({"xy": way}, (Step("xy"), Step("xy", reversed=True)) * 6, motifs)


def jogging_in_place() -> Dance:
    """Lift one knee and the other, six times, the arms against them."""
    high = posture(
        left_hip=1.30, left_knee=1.75, left_ankle=0.10, right_hip=0.02, right_knee=0.06, pelvis_pitch=0.05,
        pelvis_yaw=-0.12, trunk_yaw=0.25, left_flexion=-0.65, right_flexion=0.95, elbow=1.55, abduction=0.20,
    )  # fmt: skip
    level = posture(hip=0.50, knee=0.85, pelvis_pitch=0.16, flexion=0.10, elbow=1.45, abduction=0.22)
    middle = 0.55 * high + 0.45 * level
    way = Way("A", "X", across([high, middle, level]), 0.28, (True, False))
    half = (Step("ax"), Step("ax", reversed=True, mirrored=True))
    other = (Step("ax", mirrored=True), Step("ax", reversed=True))
    return Dance({"ax": way}, (*half, *other) * 6, (Motif("anti_palindrome", (0, 24), cyclic=True),))


def walking() -> Dance:
    """Walk six strides, half of each the mirror image of the other."""
    gait = _gait(left=_STRIDE, right=_STRIDE, offset=0.5, body=_SWINGS)
    way = Way("A", "A*", part(gait, 0.0, 0.5), 0.56, (False, False))
    return Dance(
        {"aa*": way},
        (Step("aa*"), Step("aa*", mirrored=True)) * 6,
        (Motif("anti_phase", (0, 12), cyclic=True),),
    )


def limping() -> Dance:
    """Drag a stiff left leg along for six strides, the hand on the thigh."""
    stiff = {
        "hip": [0.16, 0.12, 0.02, -0.08, -0.04, 0.10, 0.17], "knee": [0.12, 0.16, 0.14, 0.10, 0.14, 0.18, 0.12],
        "spread": [0.05, 0.0, 0.0, 0.02, 0.22, 0.26, 0.12], "ankle": [0.0, 0.02, -0.05, -0.06, 0.05, 0.0, 0.0],
        "flexion": [0.30, 0.24, 0.26, 0.34, 0.42, 0.40, 0.34], "elbow": [0.80, 0.74, 0.72, 0.78, 0.86, 0.88, 0.84],
    }  # fmt: skip
    leans = {
        "pelvis_roll": (0.16, 0.10), "trunk_roll": (-0.32, 0.10), "trunk_pitch": (0.10, 0.35),
        "pelvis_yaw": (0.08, 0.0), "trunk_yaw": (-0.10, 0.05), "head_roll": (0.10, 0.10),
    }  # fmt: skip
    gait = _gait(left=stiff, right=_STRIDE, offset=0.40, body=leans)
    crooked = {"trunk_roll": 0.14, "trunk_pitch": 0.16, "pelvis_pitch": 0.08, "right_abduction": 0.12}
    bent = np.array([crooked.get(name, 0.0) for name in ANGLES])
    way = Way("A", "A", lambda u: gait(u) + bent, 1.35, (False, False))
    return Dance({"aa": way}, (Step("aa"),) * 6, (Motif("asymmetric_cycle", (0, 6), cyclic=True),))


def side_kicks() -> Dance:
    """Kick four times to the left, switch the stance, and kick four times to the right."""
    guard = {
        "left_flexion": 0.95, "left_elbow": 1.35, "right_flexion": 0.45, "right_elbow": 2.10, "outward": -0.30,
        "abduction": 0.25,
    }  # fmt: skip
    stance = posture(
        **guard, pelvis_yaw=-0.75, head_yaw=0.70, left_hip=0.62, left_knee=0.60, right_hip=-0.12, right_knee=0.50,
        spread=0.12, right_turn=0.45,
    )  # fmt: skip
    square = posture(
        flexion=0.70, elbow=1.75, outward=-0.30, abduction=0.25, hip=0.42, knee=0.72, spread=0.24
    )
    leg = {"right_hip": 0.05, "right_knee": 0.22, "right_spread": 0.06, "right_turn": 0.50}
    drawn = posture(
        **guard, **leg, pelvis_yaw=-0.85, pelvis_roll=0.22, trunk_roll=0.05, head_yaw=0.75,
        left_hip=1.65, left_knee=2.05, left_spread=0.30, left_ankle=0.0,
    )  # fmt: skip
    out = posture(
        **{**guard, "left_flexion": 0.20, "left_elbow": 0.50, "left_abduction": 0.75}, **leg, pelvis_yaw=-1.15,
        pelvis_roll=0.75, trunk_roll=0.22, head_roll=-0.65, head_yaw=0.85,
        left_hip=0.45, left_knee=0.08, left_spread=1.05, left_ankle=-0.15,
    )  # fmt: skip
    down = posture(
        **{**guard, "left_flexion": 0.35, "left_elbow": 0.85, "left_abduction": 0.55}, **leg, pelvis_yaw=-0.85,
        pelvis_roll=0.25, trunk_roll=0.10, head_roll=-0.20, head_yaw=0.75,
        left_hip=0.15, left_knee=0.15, left_spread=0.62, left_ankle=0.0,
    )  # fmt: skip
    kick = through([stance, drawn, out, down, stance], (0.0, 0.30, 0.54, 0.76, 1.0))
    ways = {
        "aa": Way("A", "A", kick, 1.5),
        "ax": Way("A", "X", across([stance, 0.5 * (stance + square), square]), 0.50, (True, False)),
    }
    switch = (Step("ax"), Step("ax", reversed=True, mirrored=True))
    motifs = (
        Motif("asymmetric_cycle", (0, 4), cyclic=True),
        Motif("reflected_path_repetition", (0, 4), partner=(6, 10)),
        Motif("anti_palindrome", (4, 6)),
        Motif("asymmetric_cycle", (6, 10), cyclic=True),
    )
    return Dance(ways, (Step("aa"),) * 4 + switch + (Step("aa", mirrored=True),) * 4, motifs, dwell_s=0.2)


def sun_salutation() -> Dance:
    """Salute the sun twice."""
    y = posture(abduction=0.08)
    x = posture(abduction=2.80, elbow=0.12, shrug=0.35, trunk_pitch=-0.18, head_pitch=-0.25)
    swung = posture(flexion=1.45, abduction=0.05, elbow=0.10, hip=0.40, knee=0.66, pelvis_pitch=0.12)
    t = posture(
        pelvis_pitch=1.30,
        hip=1.32,
        knee=0.06,
        trunk_pitch=0.08,
        flexion=1.20,
        abduction=0.10,
        head_pitch=-0.35,
    )
    w = posture(
        pelvis_pitch=1.70, hip=1.85, knee=0.22, trunk_pitch=1.00, flexion=2.20, elbow=0.70, wrist=0.90,
        head_pitch=0.35,
    )  # fmt: skip
    tucked = {"ankle": 0.05, "toes": 1.25, "wrist": 1.45, "hands": 2.0}
    v = posture(**tucked, pelvis_pitch=1.25, hip=0.0, knee=0.02, flexion=1.28, elbow=0.05, head_pitch=-0.30)
    lunge = posture(
        **{**tucked, "right_ankle": -0.25, "right_toes": 0.0}, pelvis_pitch=1.20, trunk_pitch=0.30, flexion=1.55,
        left_hip=0.05, left_knee=0.10, right_hip=2.20, right_knee=1.80,
    )  # fmt: skip
    low = posture(
        **tucked, pelvis_pitch=1.48, hip=0.0, flexion=0.25, abduction=0.20, elbow=1.50, head_pitch=-0.30
    )
    arch = posture(
        pelvis_pitch=1.22, hip=-0.35, knee=0.02, ankle=0.95, trunk_pitch=-0.85, flexion=0.50, elbow=0.05, wrist=1.45,
        head_pitch=-0.55, hands=2.0,
    )  # fmt: skip
    tuck = posture(
        pelvis_pitch=1.55,
        trunk_pitch=0.55,
        hip=2.15,
        knee=1.75,
        ankle=0.5,
        flexion=1.90,
        wrist=1.3,
        hands=1.5,
    )
    ways = {
        "yx": Way("Y", "X", through([y, x]), 1.4, symmetric=True),
        "yy": Way("Y", "", through([y, swung]), 0.8, symmetric=True),
        "xt": Way("X", "T", through([x, t]), 1.5, symmetric=True),
        "tw": Way("T", "W", through([t, w]), 1.0, symmetric=True),
        "wv": Way("W", "V", through([w, lunge, v]), 2.0),
        "vv": Way("V", "V", through([v, low, arch, v], (0.0, 0.36, 0.70, 1.0)), 2.4, symmetric=True),
        "vw": Way("V", "W", through([v, tuck, w]), 1.2, symmetric=True),
    }
    order = ["yx", "xy", "yy", "yy'", "yx", "xt", "tw", "wv", "vv", "vw", "wt", "tx", "xy"]
    backwards = {"xy": "yx", "yy'": "yy", "wt": "tw", "tx": "xt"}
    once = tuple(Step(backwards.get(name, name), reversed=name in backwards) for name in order)
    rounds = tuple(
        Motif(name, (first + at, last + at), widest=widest and (widest[0] + at, widest[1] + at))
        for at in (0, 13)
        for name, first, last, widest in (
            ("symmetric_palindrome", 0, 2, (0, 5)),
            ("symmetric_palindrome", 2, 4, (0, 5)),
            ("symmetric_cycle", 8, 9, None),
        )
    )
    motifs = (
        *(Motif("symmetric_path", steps) for steps in ((0, 7), (8, 20), (21, 26))),
        *rounds,
        *(Motif("path_reversal", (4 + at, 7 + at), partner=(10 + at, 13 + at)) for at in (0, 13)),
        Motif("path_repetition", (0, 13), partner=(13, 26)),
    )
    return Dance(ways, once * 2, motifs, dwell_s=0.6)


_AT = (0.0, 0.12, 0.32, 0.50, 0.64, 0.76, 0.90, 1.0)
_STRIDE = {
    "hip": [0.46, 0.40, 0.10, -0.20, 0.02, 0.44, 0.54], "knee": [0.06, 0.32, 0.16, 0.24, 1.05, 1.00, 0.26],
    "ankle": [-0.02, 0.12, -0.14, -0.22, 0.34, 0.05, -0.05], "spread": [0.0, -0.03, -0.05, -0.03, 0.02, 0.04, 0.02],
    "flexion": [-0.42, -0.42, -0.10, 0.36, 0.44, 0.30, -0.12], "elbow": [0.25, 0.20, 0.30, 0.60, 0.66, 0.55, 0.34],
}  # fmt: skip
"""Angles of a side in each part of its stride, from the heel's strike to the next [Winter, 1987, as in _actions]."""
_SWINGS = {
    "pelvis_yaw": (-0.10, 0.0), "pelvis_roll": (0.0, 0.08), "trunk_yaw": (0.22, 0.06),
    "trunk_roll": (0.02, -0.09), "head_yaw": (-0.10, -0.03),
}  # fmt: skip
"""Cosine and sine of what the trunk does once a stride."""


def _gait(
    *,
    left: dict[str, list[float]],
    right: dict[str, list[float]],
    offset: float,
    body: dict[str, tuple[float, float]],
) -> Curve:
    """Walk: each side by its own curves, the right one `offset` of a stride later."""
    from scipy.interpolate import CubicSpline

    sides = {
        f"{side}_{name}": (CubicSpline(_AT, [*values, values[0]], bc_type="periodic"), late)
        for side, curves, late in (("left", left, 0.0), ("right", right, offset))
        for name, values in curves.items()
        if name in SIDE
    }

    def curve(u: np.ndarray) -> np.ndarray:
        made = np.tile(posture(pelvis_pitch=0.04, trunk_pitch=0.03), (len(u), 1))
        for name, (spline, late) in sides.items():
            made[:, ANGLES.index(name)] = spline((u + late) % 1.0)
        for name, (cosine, sine) in body.items():
            made[:, ANGLES.index(name)] += cosine * np.cos(2 * np.pi * u) + sine * np.sin(2 * np.pi * u)
        return made

    return curve


DANCES = {
    "butterfly": butterfly,
    "jumping jacks": jumping_jacks,
    "jogging in place": jogging_in_place,
    "walking": walking,
    "limping": limping,
    "side kicks": side_kicks,
    "sun salutation": sun_salutation,
}
