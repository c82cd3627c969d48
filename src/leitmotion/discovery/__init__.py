"""What is in this recording: patterns that recur."""

from leitmotion.discovery.pattern import Pattern, PatternPair, Patterns
from leitmotion.discovery.patterns import METHODS, find_patterns
from leitmotion.discovery.recurrence import find_recurrences
from leitmotion.discovery.tang2008 import find_patterns_tang2008

__all__ = [
    "METHODS",
    "Pattern",
    "PatternPair",
    "Patterns",
    "find_patterns",
    "find_patterns_tang2008",
    "find_recurrences",
]
