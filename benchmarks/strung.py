"""Longer recordings with exact truth: joined recordings of one actor, one after another."""

from __future__ import annotations

from itertools import count
from typing import NamedTuple

import numpy as np

from joined import COUNTS, joined, moves, strung_together, truth_of
from joining import blended, placed
from leitmotion import body, features
from leitmotion.evaluation import PatternTruth
from leitmotion.features import FeatureSequence
from leitmotion.motion import Motion, Segmentation

RATE = 30.0
COUNT = {actor: many for counts in COUNTS.values() for actor, many in counts.items()}


class Strung(NamedTuple):
    """Postures at 30 Hz, and what is performed in them."""

    name: str
    postures: FeatureSequence
    truth: PatternTruth


def strung(actor: str, first: int, frames: int) -> Strung:
    """String joined recordings of an actor together, from one on, up to the last repetition before so many frames.

    A recording in which a move would meet another of its kin is left out; the blends are those within a joined one.
    """
    rng = np.random.default_rng([first, frames])
    kin = {move.label: move.kin or move.label for move in moves(actor)}
    met: dict[str, str] = {}
    pieces: list[Motion] = []
    spans, labels = [], []
    length = 0
    for k in count(first):
        if k - first == COUNT[actor]:
            raise ValueError(f"The recordings of {actor} do not make {frames} frames at {RATE:g} Hz.")
        made = joined(f"{actor}/{k % COUNT[actor]:02d}")
        told = made.truth.repetitions
        assert told is not None
        if any(met.get(kin[label], label) != label for label in told.labels):
            continue
        met.update({kin[label]: label for label in told.labels})
        motion = made.motion
        if pieces:
            blend = round(rng.uniform(0.2, 0.4) * motion.rate)
            motion = placed(motion, pieces[-1], blend)
            pieces.append(blended(pieces[-1], motion, blend))
            length += blend
        spans.append(np.stack((told.starts, told.stops), axis=1) + length)
        labels += told.labels
        pieces.append(motion)
        length += len(motion)
        if length * RATE >= frames * motion.rate:
            break
    name = f"{actor}/{first:02d}+"
    whole = strung_together(pieces, name)
    postures = features.resample(features.posture(body.embody(whole)), RATE)
    places = np.round(np.concatenate(spans) * RATE / whole.rate).astype(np.int64)
    last = int((places[:, 1] <= min(frames, len(postures))).sum())
    by_label = {move.label: move for move in moves(actor)}
    truth = truth_of([by_label[label] for label in labels[:last]], places[:last], RATE)
    return Strung(name, postures[: int(places[last - 1, 1])], truth)


def told_lengths(truth: PatternTruth) -> tuple[int, int]:
    """Frames of the shortest and of the longest repetition of what recurs."""
    known = truth.repetitions
    assert isinstance(known, Segmentation)
    lengths = [stop - start for start, stop, label, _ in known if label in truth.recurring]
    return min(lengths), max(lengths)
