"""What is in this recording: patterns that recur, and what may have been missed."""

from leitmotion.discovery.pattern import Pattern, PatternPair, Patterns
from leitmotion.discovery.patterns import METHODS, find_patterns
from leitmotion.discovery.recurrence import find_recurrences
from leitmotion.discovery.residual import Candidate, Residual, search_residual
from leitmotion.discovery.tang2008 import find_patterns_tang2008

__all__ = [
    "METHODS",
    "Candidate",
    "Pattern",
    "PatternPair",
    "Patterns",
    "Residual",
    "find_patterns",
    "find_patterns_tang2008",
    "find_recurrences",
    "search_residual",
]
