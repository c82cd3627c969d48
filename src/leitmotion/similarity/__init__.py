"""How alike are two moments or two stretches."""

from leitmotion.similarity.alignment import Alignment
from leitmotion.similarity.distance import cross_distance, self_distance
from leitmotion.similarity.dtw import align, warping_cost
from leitmotion.similarity.matrix import SimilarityMatrix
from leitmotion.similarity.mirror import (
    DoubleMetric,
    axis_speed,
    choose_beta,
    double_metric,
    identity_width,
    likeness,
    still_spans,
)
from leitmotion.similarity.on_demand import Distances
from leitmotion.similarity.pairs import pair_distances

__all__ = [
    "Alignment",
    "Distances",
    "DoubleMetric",
    "SimilarityMatrix",
    "align",
    "axis_speed",
    "choose_beta",
    "cross_distance",
    "double_metric",
    "identity_width",
    "likeness",
    "pair_distances",
    "self_distance",
    "still_spans",
    "warping_cost",
]
