"""What new motion can be made: pieces blended into each other, summaries of what recurs."""

from leitmotion.synthesis.blending import Joined, Placement, join, placement
from leitmotion.synthesis.summary import Summary, summarize

__all__ = ["Joined", "Placement", "Summary", "join", "placement", "summarize"]
