"""How alike are two moments or two stretches."""

from leitmotion.similarity.alignment import Alignment
from leitmotion.similarity.balance import along_the_way, balanced_bias
from leitmotion.similarity.counterparts import Counterparts, counterparts, shares_alike
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
    link_angle,
    still_spans,
    symmetry_index,
)
from leitmotion.similarity.on_demand import Distances
from leitmotion.similarity.pairs import pair_distances

__all__ = [
    "Alignment",
    "Counterparts",
    "Distances",
    "DoubleMetric",
    "SimilarityMatrix",
    "align",
    "along_the_way",
    "axis_speed",
    "balanced_bias",
    "choose_beta",
    "counterparts",
    "cross_distance",
    "double_metric",
    "identity_width",
    "likeness",
    "link_angle",
    "pair_distances",
    "self_distance",
    "shares_alike",
    "still_spans",
    "symmetry_index",
    "warping_cost",
]
