"""How good is an answer: one module per task, on arrays and segmentations only."""

from leitmotion.evaluation.calibration import Calibration, ErrorRates, equal_error_rate, errors_at
from leitmotion.evaluation.pattern_scores import MEASURES, PatternScores, RunCount, interval, pool
from leitmotion.evaluation.pattern_truth import FoundPatterns, PatternTruth
from leitmotion.evaluation.patterns import evaluate_patterns, linked, owners
from leitmotion.evaluation.tang2008 import PaperErrorRates, paper_error_rates

__all__ = [
    "MEASURES",
    "Calibration",
    "ErrorRates",
    "FoundPatterns",
    "PaperErrorRates",
    "PatternScores",
    "PatternTruth",
    "RunCount",
    "equal_error_rate",
    "errors_at",
    "evaluate_patterns",
    "interval",
    "linked",
    "owners",
    "paper_error_rates",
    "pool",
]
