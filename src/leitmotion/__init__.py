"""Leitmotion finds what recurs in human motion.

>>> import leitmotion as lm
>>> motion = lm.compose_session(seed=0).motion            # or lm.read("dance.bvh")
>>> patterns = lm.find_patterns(motion)                   # doctest: +SKIP
>>> lm.report(motion, "dance.html")                       # doctest: +SKIP

The functions a person types stand here; each question of the field has a room of its own behind them, reached as
``lm.io``, ``lm.body``, ``lm.evaluation``, ``lm.features``, ``lm.repairs``, ``lm.similarity``, ``lm.discovery``,
``lm.synthesis``, ``lm.view``. Importing this package loads nothing but itself: a name brings its room when it is first
used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from leitmotion.api import (
        Body,
        BodyMap,
        Calibration,
        Converted,
        DataError,
        Dynamics,
        Flight,
        FormatError,
        FoundPatterns,
        Info,
        LeitmotionError,
        Lesson,
        Mirrored,
        Motion,
        MotionGraph,
        ParameterError,
        Pattern,
        Patterns,
        PatternScores,
        PatternTruth,
        Repaired,
        Residual,
        Segmentation,
        SharedPattern,
        SharedPatterns,
        Skeleton,
        Summary,
        Symmetry,
        SymmetrySpan,
        Trajectories,
        calibrate,
        compare,
        compare_with_mirror,
        compose_session,
        convert,
        dynamics,
        embody,
        evaluate,
        find_patterns,
        find_roles,
        find_shared_patterns,
        find_symmetry,
        info,
        load,
        make_lesson,
        motion_graph,
        read,
        read_all,
        read_annotations,
        repair,
        report,
        report_shared,
        save,
        search_residual,
        summarize,
        write,
    )

__version__ = "0.1.0"

__all__ = [
    "Body",
    "BodyMap",
    "Calibration",
    "Converted",
    "DataError",
    "Dynamics",
    "Flight",
    "FormatError",
    "FoundPatterns",
    "Info",
    "LeitmotionError",
    "Lesson",
    "Mirrored",
    "Motion",
    "MotionGraph",
    "ParameterError",
    "Pattern",
    "PatternScores",
    "PatternTruth",
    "Patterns",
    "Repaired",
    "Residual",
    "Segmentation",
    "SharedPattern",
    "SharedPatterns",
    "Skeleton",
    "Summary",
    "Symmetry",
    "SymmetrySpan",
    "Trajectories",
    "calibrate",
    "compare",
    "compare_with_mirror",
    "compose_session",
    "convert",
    "dynamics",
    "embody",
    "evaluate",
    "find_patterns",
    "find_roles",
    "find_shared_patterns",
    "find_symmetry",
    "info",
    "load",
    "make_lesson",
    "motion_graph",
    "read",
    "read_all",
    "read_annotations",
    "repair",
    "report",
    "report_shared",
    "save",
    "search_residual",
    "summarize",
    "write",
]

_ROOMS = frozenset(
    {
        "body",
        "datasets",
        "discovery",
        "evaluation",
        "features",
        "io",
        "motion",
        "repairs",
        "similarity",
        "synthesis",
        "view",
    }
)


def __getattr__(name: str) -> object:
    if name in _ROOMS:
        return importlib.import_module(f"leitmotion.{name}")
    if name not in __all__:
        raise AttributeError(f"module 'leitmotion' has no attribute {name!r}")
    value = getattr(importlib.import_module("leitmotion.api"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*__all__, *_ROOMS, "__version__"})
