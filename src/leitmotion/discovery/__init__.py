"""What is in this recording: patterns that recur."""

from leitmotion.discovery.pattern import Pattern, PatternPair, Patterns
from leitmotion.discovery.patterns import METHODS, find_patterns
from leitmotion.discovery.recurrence import find_recurrences

__all__ = ["METHODS", "Pattern", "PatternPair", "Patterns", "find_patterns", "find_recurrences"]
