"""Vocabulary: which words stand for which role, in the order in which they are believed.

Each role lists alternatives. An alternative is one word or several: then the role is the mean of all of them
and counts only when all are there; ``asi*`` means the word on both sides. ``+word`` must be there, too, and
``-word`` must not, but neither is a member. Words of a limb are meant on the limb's own side. The first
alternative that is there wins, and a word that has served one role serves no other alone: that is what tells
the ``LeftShoulder`` beside a ``LeftArm`` (a clavicle) from the one beside a ``LeftElbow`` (the joint itself),
and the ``foot`` that is an ankle from the ``foot`` below an ``ankle``.

A number behind an alternative is its confidence: 1 for the joint itself, 0.9 for markers on the skin over it,
less for a stand-in. ``fep``, the proximal end of the femur, is what Plug-in-Gait computes for the hip joint.

Words that name a bone (``thigh``, ``forearm``, ``foot``) mean the joint at its proximal end in a skeleton, but a
marker somewhere on that segment in a marker set, where they say nothing (:data:`BONES`). A table of points does not
tell which it is; one that names joints or bony landmarks (:data:`LANDMARKS`) is read as a marker set.

References
----------
[1] Plug-in-Gait marker names: Davis, Ounpuu, Tyburski, Gage, *A gait analysis data collection and reduction
    technique*, Human Movement Science 10 (1991).
[2] CAST and Rizzoli landmarks: Cappozzo, Catani, Della Croce, Leardini, *Position and orientation in space of bones
    during movement*, Clinical Biomechanics 10 (1995); Leardini and others, *A new anatomically based protocol for gait
    analysis in children*, Gait and Posture 26 (2007).
[3] Landmarks such as ``FLE`` and ``CV7``: Van Sint Jan, *Color Atlas of Skeletal Landmark Definitions* (2007).
"""

from __future__ import annotations

Alternative = tuple[str, float]

ON_SKIN = 0.9
STAND_IN = 0.5

LIMB_WORDS: dict[str, tuple[Alternative, ...]] = {
    "hip": (
        *((word, 1.0) for word in ("upleg", "upperleg", "upperleg1", "thigh", "thighbend", "femur", "hip")),
        *((word, 1.0) for word in ("hipjc", "hjc")),
        ("fep", ON_SKIN),
        *((word, 0.8) for word in ("gtr", "gt", "ftc")),
        *((pair, STAND_IN) for pair in ("asi psi", "asis psis", "fwt bwt", "hipfront hipback")),
        *((pair, STAND_IN) for pair in ("ias ips", "waistfront waistback")),
        *((one, 0.4) for one in ("asi", "asis", "fwt", "ias", "waistfront")),
    ),
    "knee": (
        ("kjc", 1.0),
        *((pair, ON_SKIN) for pair in ("kne kneemed", "kne mkne", "knee kneemedial", "knee mknee", "lk mk")),
        *((pair, ON_SKIN) for pair in ("kneelat kneemed", "kneeout kneein", "lfc mfc", "fle fme", "le me +lm")),
        *((word, 1.0) for word in ("knee", "shin", "calf", "tibia", "lowerleg", "lowerleg1", "lowleg", "leg")),
        *((word, ON_SKIN) for word in ("kne", "kneelat", "kneeout", "lfc", "fle", "le +lm")),
    ),
    "ankle": (
        ("ajc", 1.0),
        *((pair, ON_SKIN) for pair in ("ank ankmed", "ank mank", "ankle anklemedial", "ankle mankle", "la ma")),
        *((pair, ON_SKIN) for pair in ("anklelat anklemed", "ankleout anklein", "lmal mmal", "fal tam", "lm mm")),
        *((word, 1.0) for word in ("ankle", "foot")),
        *((word, ON_SKIN) for word in ("ank", "anklelat", "ankleout", "lmal", "fal", "lm +le")),
    ),
    "toe": (
        *((word, 1.0) for word in ("toebase", "toes", "toe", "toe0", "ball", "ballfoot", "footindex", "bigtoe")),
        ("foot", 1.0),
        *((word, ON_SKIN) for word in ("toetip", "mt2", "fm2", "sm +lm", "mt1 mt5", "fm1 fm5", "fm vm")),
        *((word, ON_SKIN) for word in ("forefootin forefootout", "toein toeout", "toeout", "toemed toelat")),
    ),
    "shoulder": (
        *((word, 1.0) for word in ("arm", "upperarm", "upperarm1", "uparm", "uarm", "humerus", "shldr")),
        *((word, 1.0) for word in ("shldrbend", "sjc", "shoulder")),
        *((word, ON_SKIN) for word in ("sho", "acromion", "acromium", "ac", "acr", "sae", "shouldertop")),
    ),
    "clavicle": tuple(
        (word, 1.0) for word in ("clavicle", "collar", "collarbone", "shoulder", "t4shoulder", "c7shoulder")
    ),
    "wrist": (
        ("wjc", 1.0),
        *((pair, ON_SKIN) for pair in ("wra wrb", "wristmed wristlat", "wristout wristin", "lwrist mwrist")),
        *((pair, ON_SKIN) for pair in ("radius ulna", "faradius faulna", "rsp usp")),
        *((word, 1.0) for word in ("wrist", "hand")),
        ("wri", ON_SKIN),
        ("w +h", 1.0),
    ),
    "elbow": (
        ("ejc", 1.0),
        *((pair, ON_SKIN) for pair in ("elb elbmed", "elb melb", "elbow elbowmedial", "lelbow melbow")),
        *((pair, ON_SKIN) for pair in ("elbowout elbowin", "lel mel", "hle hme", "le me -lm")),
        *((word, 1.0) for word in ("elbow", "forearm", "forearmbend", "lowerarm", "lowerarm1", "lowarm", "farm")),
        *((word, ON_SKIN) for word in ("elb", "elbowout", "lel", "hle")),
        ("radius", 1.0),
    ),
    "hand": (
        *((word, 1.0) for word in ("hand", "fingerbase", "handmiddle1", "middle1", "mid1", "knuckles")),
        *((word, 1.0) for word in ("middleproximal", "handmiddleproximal", "fmiddle1")),
        *((word, ON_SKIN) for word in ("fin", "index pinky", "finger", "finger2 +finger0", "handindex1")),
        *((word, ON_SKIN) for word in ("handend", "handout handin", "handout", "hm2", "h +w")),
    ),
}  # fmt: skip
"""Roles with a side, in the order in which they choose."""

AXIAL_WORDS: dict[str, tuple[Alternative, ...]] = {
    "pelvis": (
        *((word, 1.0) for word in ("pelvis", "hips", "hip", "spinebase", "hipcenter", "midhip", "waist")),
        ("root", 1.0),
        *((four, ON_SKIN) for four in ("asi* psi*", "asis* psis*", "fwt* bwt*", "hipfront* hipback*")),
        *((four, ON_SKIN) for four in ("ias* ips*", "waistfront* waistback*")),
        *((three, 0.8) for three in ("asi* sacr", "asi* vsac", "asis* vsacral", "asis* s2")),
        ("lowertorso", 0.8), ("spine +spine6 -head", 0.8),
        ("asi*", STAND_IN), ("asis*", STAND_IN),
    ),
    "neck": (
        *((word, 1.0) for word in ("lowerneck", "necklower", "neckbase", "neck", "neck1", "spineshoulder")),
        *((word, 1.0) for word in ("shouldercenter", "t1c7", "necktwist1")),
        *((pair, ON_SKIN) for pair in ("c7 clav", "c7 ij", "cv7 sjn")),
        *((word, 0.8) for word in ("c7", "cv7", "t1", "spinetop", "backtop", "spine4 +spine6 -head")),
    ),
    "head": (
        *((word, 1.0) for word in ("head", "skull", "c1head")),
        *((all_, ON_SKIN) for all_ in ("fhd* bhd*", "headfront* headback*", "headfront* headback", "head*")),
        *((all_, 0.8) for all_ in ("temple* tophead", "tophead fronthead rearhead", "headtop headfront", "fhd*")),
        *((all_, 0.8) for all_ in ("bhd*", "ear*", "spine6", "h +s")),
        ("nose", STAND_IN),
    ),
    "chest": (
        *((word, 1.0) for word in ("thorax", "upperchest", "chestupper", "chest4", "chest3", "chest2", "chest")),
        *((word, 1.0) for word in ("uppertorso", "spinechest", "t9t8", "t8 +l3", "spine3", "spine2")),
        *((pair, ON_SKIN) for pair in ("t10 strn", "spine sternum", "breastbone back", "t10 clav", "tv8 sxs")),
        *((word, STAND_IN) for word in ("t10", "strn", "sternum", "tv8")),
    ),
    "spine": (
        *((word, 1.0) for word in ("spine1", "spine", "spinemid", "spinenaval", "spinenavel")),
        *((word, 0.8) for word in ("abdomenupper", "abdomen", "upperback", "midtorso", "torso", "ab")),
        *((word, 0.8) for word in ("l1t12", "t12 +l3", "l3", "chest", "s +h")),
    ),
}  # fmt: skip
"""Roles in the body's middle, in the order in which they choose."""

BONES = frozenset((
    "upleg", "upperleg", "thigh", "femur", "shin", "calf", "tibia", "lowerleg", "lowleg", "leg", "foot",
    "arm", "upperarm", "uparm", "uarm", "humerus", "forearm", "lowerarm", "lowarm", "farm", "radius", "hand",
))  # fmt: skip
"""Words that name a bone rather than a joint."""

LANDMARKS = frozenset((
    "knee", "kne", "kneeout", "kneelat", "lfc", "fle", "ankle", "ank", "ankleout", "anklelat", "lmal", "fal",
    "elbow", "elb", "elbowout", "lel", "hle", "asi", "asis", "ias", "waistfront",
))  # fmt: skip
"""Words that a marker set has and a list of bones has not."""

WORDS = frozenset(
    word.strip("*+-")
    for table in (LIMB_WORDS, AXIAL_WORDS)
    for alternatives in table.values()
    for alternative, _ in alternatives
    for word in alternative.split()
)
"""Every word that says something."""
