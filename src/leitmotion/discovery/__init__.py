"""What is in this recording: patterns that recur and what may have been missed, motifs of symmetry, the graph."""

from leitmotion.discovery.across import find_shared_patterns
from leitmotion.discovery.graphing import build_graph
from leitmotion.discovery.lesson import Difference, Lesson, Step, Variation, make_lesson
from leitmotion.discovery.motion_graph import MotionGraph, Path, State, Visit
from leitmotion.discovery.nearest import nearest_across
from leitmotion.discovery.notation import notation, path_label, performed, plain_notation, state_label
from leitmotion.discovery.pattern import Pattern, PatternPair, Patterns
from leitmotion.discovery.patterns import METHODS, find_patterns
from leitmotion.discovery.racemizing import racemized
from leitmotion.discovery.recurrence import find_recurrences
from leitmotion.discovery.residual import Candidate, Residual, search_residual
from leitmotion.discovery.shared import Places, SharedPair, SharedPattern, SharedPatterns
from leitmotion.discovery.symmetry import find_symmetry
from leitmotion.discovery.symmetry_span import MOTIFS, Symmetry, SymmetrySpan
from leitmotion.discovery.tang2008 import find_patterns_tang2008
from leitmotion.discovery.typical import align_occurrences, typical_occurrence

__all__ = [
    "METHODS",
    "MOTIFS",
    "Candidate",
    "Difference",
    "Lesson",
    "MotionGraph",
    "Path",
    "Pattern",
    "PatternPair",
    "Patterns",
    "Places",
    "Residual",
    "SharedPair",
    "SharedPattern",
    "SharedPatterns",
    "State",
    "Step",
    "Symmetry",
    "SymmetrySpan",
    "Variation",
    "Visit",
    "align_occurrences",
    "build_graph",
    "find_patterns",
    "find_patterns_tang2008",
    "find_recurrences",
    "find_shared_patterns",
    "find_symmetry",
    "make_lesson",
    "nearest_across",
    "notation",
    "path_label",
    "performed",
    "plain_notation",
    "racemized",
    "search_residual",
    "state_label",
    "typical_occurrence",
]
