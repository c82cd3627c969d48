"""How good is an answer: one module per task, on arrays and segmentations only."""

from leitmotion.evaluation.calibration import Calibration, ErrorRates, equal_error_rate, errors_at
from leitmotion.evaluation.motif_truth import MOTIF_KINDS, GoneStep, MotifSpan
from leitmotion.evaluation.motifs import MotifScores, evaluate_motifs
from leitmotion.evaluation.motion_graphs import GraphPath, GraphShape, GraphState, same_graph
from leitmotion.evaluation.pattern_scores import MEASURES, PatternScores, RunCount, interval, pool
from leitmotion.evaluation.pattern_truth import FoundPatterns, PatternTruth
from leitmotion.evaluation.patterns import evaluate_patterns, linked, owners
from leitmotion.evaluation.symmetry import (
    SymmetryLabel,
    SymmetryScores,
    SymmetryVerdict,
    evaluate_symmetry,
)
from leitmotion.evaluation.tang2008 import PaperErrorRates, paper_error_rates

__all__ = [
    "MEASURES",
    "MOTIF_KINDS",
    "Calibration",
    "ErrorRates",
    "FoundPatterns",
    "GoneStep",
    "GraphPath",
    "GraphShape",
    "GraphState",
    "MotifScores",
    "MotifSpan",
    "PaperErrorRates",
    "PatternScores",
    "PatternTruth",
    "RunCount",
    "SymmetryLabel",
    "SymmetryScores",
    "SymmetryVerdict",
    "equal_error_rate",
    "errors_at",
    "evaluate_motifs",
    "evaluate_patterns",
    "evaluate_symmetry",
    "interval",
    "linked",
    "owners",
    "paper_error_rates",
    "pool",
    "same_graph",
]
