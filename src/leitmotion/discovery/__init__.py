"""What is in this recording: patterns that recur."""

from leitmotion.discovery.pattern import Pattern, PatternPair, Patterns

__all__ = ["Pattern", "PatternPair", "Patterns"]
