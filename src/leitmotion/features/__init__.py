"""What numbers describe a frame, and what are they invariant to."""

from leitmotion.features.posture import posture
from leitmotion.features.sequence import FeatureSequence

__all__ = ["FeatureSequence", "posture"]
