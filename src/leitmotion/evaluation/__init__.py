"""How good is an answer: one module per task, on arrays and segmentations only."""

from leitmotion.evaluation.pattern_scores import MEASURES, PatternScores, RunCount, interval, pool
from leitmotion.evaluation.pattern_truth import FoundPatterns, PatternTruth
from leitmotion.evaluation.patterns import evaluate_patterns, linked, owners

__all__ = [
    "MEASURES",
    "FoundPatterns",
    "PatternScores",
    "PatternTruth",
    "RunCount",
    "evaluate_patterns",
    "interval",
    "linked",
    "owners",
    "pool",
]
