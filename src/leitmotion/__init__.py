"""Leitmotion finds what recurs in human motion."""
