"""How alike are two moments or two stretches."""

from leitmotion.similarity.alignment import Alignment
from leitmotion.similarity.distance import cross_distance, self_distance
from leitmotion.similarity.dtw import align, warping_cost
from leitmotion.similarity.matrix import SimilarityMatrix
from leitmotion.similarity.on_demand import Distances
from leitmotion.similarity.pairs import pair_distances

__all__ = [
    "Alignment",
    "Distances",
    "SimilarityMatrix",
    "align",
    "cross_distance",
    "pair_distances",
    "self_distance",
    "warping_cost",
]
