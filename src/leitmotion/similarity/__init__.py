"""How alike are two moments or two stretches."""

from leitmotion.similarity.alignment import Alignment
from leitmotion.similarity.distance import cross_distance, self_distance
from leitmotion.similarity.matrix import SimilarityMatrix

__all__ = ["Alignment", "SimilarityMatrix", "cross_distance", "self_distance"]
