"""What can I try it on: a practice session composed with its truth."""

from leitmotion.datasets.compose import ACTIONS, STILL, Action, Session, compose, compose_session
from leitmotion.datasets.skeleton import human_skeleton

__all__ = ["ACTIONS", "STILL", "Action", "Session", "compose", "compose_session", "human_skeleton"]
