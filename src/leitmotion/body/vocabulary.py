"""Vocabulary: which words stand for which role, in the order in which they are believed.

Each role lists alternatives. An alternative is one word or several: then the role is the mean of all of them
and counts only when all are there; ``asi*`` means the word on both sides. Words of a limb are meant on the
limb's own side. The first alternative that is there wins, and a word that has served one role serves no
other alone: that is what tells the ``LeftShoulder`` beside a ``LeftArm`` (a clavicle) from the one beside a
``LeftElbow`` (the joint itself), and the ``foot`` that is an ankle from the ``foot`` below an ``ankle``.

A number behind an alternative is its confidence: 1 for the joint itself, 0.9 for markers on the skin over it,
less for a stand-in. ``fep``, the proximal end of the femur, is what Plug-in-Gait computes for the hip joint.

Words that name a bone (``thigh``, ``forearm``, ``foot``) mean the joint at its proximal end in a skeleton, but a
marker somewhere on that segment in a marker set, where they say nothing (:data:`BONES`). A table of points does not
tell which it is; one that names joints or bony landmarks (:data:`LANDMARKS`) is read as a marker set.

References
----------
[1] Plug-in-Gait marker names: Davis, Ounpuu, Tyburski, Gage, *A gait analysis data collection and reduction
    technique*, Human Movement Science 10 (1991).
"""

from __future__ import annotations

Alternative = tuple[str, float]

ON_SKIN = 0.9
STAND_IN = 0.5

LIMB_WORDS: dict[str, tuple[Alternative, ...]] = {
    "hip": (
        *((word, 1.0) for word in ("upleg", "upperleg", "thigh", "femur", "hip", "hipjc")),
        ("fep", ON_SKIN),
        ("gtr", 0.8),
        *((pair, STAND_IN) for pair in ("asi psi", "asis psis", "fwt bwt", "hipfront hipback")),
        *((one, 0.4) for one in ("asi", "asis", "fwt")),
    ),
    "knee": (
        *((pair, ON_SKIN) for pair in ("kne kneemed", "kne mkne", "knee kneemedial", "lk mk")),
        *((word, 1.0) for word in ("knee", "shin", "calf", "tibia", "lowerleg", "lowleg", "leg")),
        ("kne", ON_SKIN),
    ),
    "ankle": (
        *((pair, ON_SKIN) for pair in ("ank ankmed", "ank mank", "ankle anklemedial", "la ma")),
        *((word, 1.0) for word in ("ankle", "foot")),
        ("ank", ON_SKIN),
    ),
    "toe": (
        *((word, 1.0) for word in ("toebase", "toes", "toe", "toe0", "ball", "footindex", "bigtoe", "foot")),
        *((word, ON_SKIN) for word in ("toetip", "mt2", "mt1 mt5", "toemed toelat")),
    ),
    "shoulder": (
        *((word, 1.0) for word in ("arm", "upperarm", "uparm", "uarm", "humerus", "shldr", "shoulder")),
        *((word, ON_SKIN) for word in ("sho", "acromion", "acromium", "ac")),
    ),
    "clavicle": tuple((word, 1.0) for word in ("clavicle", "collar", "collarbone", "shoulder")),
    "wrist": (
        *((pair, ON_SKIN) for pair in ("wra wrb", "wristmed wristlat", "radius ulna")),
        *((word, 1.0) for word in ("wrist", "hand")),
        ("wri", ON_SKIN),
    ),
    "elbow": (
        *((pair, ON_SKIN) for pair in ("elb elbmed", "elbow elbowmedial", "le me")),
        *((word, 1.0) for word in ("elbow", "forearm", "lowerarm", "lowarm", "farm")),
        ("elb", ON_SKIN),
        ("radius", 1.0),
    ),
    "hand": (
        *((word, 1.0) for word in ("hand", "fingerbase", "handmiddle1", "middle1", "mid1", "knuckles")),
        *((word, ON_SKIN) for word in ("fin", "index pinky", "finger", "handindex1", "handend")),
    ),
}  # fmt: skip
"""Roles with a side, in the order in which they choose."""

AXIAL_WORDS: dict[str, tuple[Alternative, ...]] = {
    "pelvis": (
        *((word, 1.0) for word in ("pelvis", "hips", "hip", "spinebase", "hipcenter", "midhip", "waist")),
        ("root", 1.0),
        *((four, ON_SKIN) for four in ("asi* psi*", "asis* psis*", "fwt* bwt*", "hipfront* hipback*")),
        *((three, 0.8) for three in ("asi* sacr", "asi* vsac", "asis* vsacral", "asis* s2")),
        ("asi*", STAND_IN), ("asis*", STAND_IN),
    ),
    "neck": (
        *((word, 1.0) for word in ("lowerneck", "neck", "neck1", "spineshoulder", "shouldercenter")),
        *((pair, ON_SKIN) for pair in ("c7 clav", "c7 ij")),
        *((word, 0.8) for word in ("c7", "t1")),
    ),
    "head": (
        *((word, 1.0) for word in ("head", "skull")),
        *((all_, ON_SKIN) for all_ in ("fhd* bhd*", "headfront* headback*", "headfront* headback")),
        *((all_, 0.8) for all_ in ("temple* tophead", "fhd*", "bhd*", "ear*")),
        ("nose", STAND_IN),
    ),
    "chest": (
        *((word, 1.0) for word in ("thorax", "chest", "upperchest", "spinechest", "spine3", "spine2")),
        *((pair, ON_SKIN) for pair in ("t10 strn", "spine sternum", "breastbone back", "t10 clav")),
        *((word, STAND_IN) for word in ("t10", "strn", "sternum")),
    ),
    "spine": (
        *((word, 1.0) for word in ("spine1", "spine", "spinemid", "spinenaval", "spinenavel")),
        *((word, 0.8) for word in ("abdomen", "upperback", "midtorso", "torso", "ab")),
    ),
}  # fmt: skip
"""Roles in the body's middle, in the order in which they choose."""

BONES = frozenset((
    "upleg", "upperleg", "thigh", "femur", "shin", "calf", "tibia", "lowerleg", "lowleg", "leg", "foot",
    "arm", "upperarm", "uparm", "uarm", "humerus", "forearm", "lowerarm", "lowarm", "farm", "radius",
))  # fmt: skip
"""Words that name a bone rather than a joint."""

LANDMARKS = frozenset(("knee", "kne", "ankle", "ank", "elbow", "elb", "asi", "asis"))
"""Words that a marker set has and a list of bones has not."""

WORDS = frozenset(
    word.rstrip("*")
    for table in (LIMB_WORDS, AXIAL_WORDS)
    for alternatives in table.values()
    for alternative, _ in alternatives
    for word in alternative.split()
)
"""Every word that says something."""
