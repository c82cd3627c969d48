"""What can I try it on: a practice session composed with its truth."""

from leitmotion.datasets.compose import ACTIONS, STILL, Action, Session, compose, compose_session
from leitmotion.datasets.compose_motifs import MOTIONS, ComposedMotif, Variation, compose_motif
from leitmotion.datasets.skeleton import human_skeleton

__all__ = [
    "ACTIONS",
    "MOTIONS",
    "STILL",
    "Action",
    "ComposedMotif",
    "Session",
    "Variation",
    "compose",
    "compose_motif",
    "compose_session",
    "human_skeleton",
]
