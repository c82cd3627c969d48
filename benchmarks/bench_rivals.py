"""Patterns beside other engines.

The same postures at 30 Hz for all, the same protocol, each search in a process of its own. An engine that has not
answered after ten minutes is stopped.

``python benchmarks/bench_rivals.py FRAMES [ENGINE...]`` prints the rows of one length, and of some engines.

``python benchmarks/bench_rivals.py fit [ENGINE...]`` tries the settings of the other engines on the actors that a
method may be fitted on, and prints the best last.
"""

from __future__ import annotations

import itertools
import json
import math
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, NamedTuple

import engines
from engines import ENGINES, Hints
from leitmotion import io
from leitmotion.evaluation import PatternScores, evaluate_patterns, interval, pool
from strung import RATE, Strung, strung, told_lengths

Row = tuple[str, str, str]
LIMIT_S = 600
MATERIAL = {
    1000: (
        ("hdm05-bk", 0),
        ("hdm05-bk", 10),
        ("hdm05-dg", 0),
        ("hdm05-dg", 10),
        ("bandai-2", 7),
        ("cmu-16", 0),
    ),
    3000: (("hdm05-bk", 0), ("hdm05-dg", 0), ("bandai-2", 7)),
    6000: (("hdm05-bk", 0), ("hdm05-bk", 10), ("hdm05-dg", 0), ("hdm05-dg", 10), ("bandai-2", 0)),
}
"""Frames, and the recordings of so many: the actor, and the joined recording with which they begin."""
FIT = {
    1000: (
        ("hdm05-bd", 0),
        ("hdm05-bd", 8),
        ("hdm05-bd", 16),
        ("bandai-1", 0),
        ("bandai-1", 3),
        ("cmu-02", 0),
    ),
    3000: (("hdm05-bd", 12), ("bandai-1", 0)),
    6000: (("hdm05-bd", 0), ("bandai-1", 0)),
}
"""The same of the actors on which settings may be chosen."""
LONGEST_FIT = {"dtai-locomotif": 6000, "stumpy": 3000}
"""Up to how many frames settings are tried; the longest would take a matrix profile half an hour."""
RHOS = (0.6, 0.7, 0.8, 0.9, 0.93, 0.94, 0.95, 0.96, 0.98)
TOLD = {
    "leitmotion": "default, nothing told",
    "tang2008": 'method="tang2008" with the parameters of the paper, nothing told',
    "dtai-locomotif": "told shortest and longest repetition and the number of actions; mean taken away and divided by "
    "the deviation of {scaled}, rho {rho}, overlap {overlap}, time warping",
    "dtai-locomotif, not told": "as before, but repetitions of {shortest} to {longest} frames, as the actors to fit on "
    "have them, and all motif sets",
    "stumpy": "mstump and mmotifs on 45 columns, told the number of actions; window: the {window} repetition; "
    "normalize={normalize}, k={k}, no cutoff, matches up to {spread} deviations below the mean distance, starts "
    "at least 1/{apart} of a window apart",
}
"""What each engine was told, and how it is set."""


class Answer(NamedTuple):
    """How good an answer was, and what it cost."""

    scores: PatternScores
    seconds: float


def main() -> None:
    """Print the table, or what the settings lead to."""
    if sys.argv[1:2] == ["fit"]:
        fit(sys.argv[2:] or ["dtai-locomotif", "stumpy"])
        return
    lengths = [int(frames) for frames in sys.argv[1:2]] or list(MATERIAL)
    for frames in lengths:
        for what, figure, protocol in rows_of(frames, sys.argv[2:] or list(ENGINES)):
            print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    return [row for frames in MATERIAL for row in rows_of(frames, list(ENGINES))]


def rows_of(frames: int, which: list[str]) -> list[Row]:
    """Measure some engines on the recordings of one length; ours, in whose time the others are told, always."""
    held = [strung(actor, first, frames) for actor, first in MATERIAL[frames]]
    answers = {
        engine: [asked(engine, one) for one in held] for engine in dict.fromkeys(("leitmotion", *which))
    }
    on = ", ".join(f"{one.name} ({len(one.postures)} frames, {hints(one).sets} recur)" for one in held)
    return [
        row
        for engine, given in answers.items()
        for row in told(engine, frames, given, answers["leitmotion"], on)
    ]


def told(
    engine: str, frames: int, given: list[Answer | None], ours: list[Answer | None], which: str
) -> list[Row]:
    """Say how an engine did on the recordings of one length; recordings without an answer count for nobody's time."""
    name = f"{engine}, {frames:,} frames"
    how = f"{settings(engine)}; joined recordings strung together: {which}"
    done = [(answer, mine) for answer, mine in zip(given, ours, strict=True) if answer and mine]
    if len(done) < len(given):
        late = f"no answer within {LIMIT_S} s on {len(given) - len(done)} of {len(given)}"
        if not done:
            return [(f"{name}: F1 of pairs", late, how)]
        how = f"{late}, which are left out; {how}"
    scores = [answer.scores for answer, _ in done]
    whole = pool(scores)
    seconds = sum(answer.seconds for answer, _ in done)
    ratio = seconds / sum(mine.seconds for _, mine in done)
    beside = "" if engine == "leitmotion" else f", {ratio:,.1f} x ours"
    cost = "kernels compiled before, best of three where it takes seconds; a recording each"
    errors = f"type I {_share(whole.type_one)}, type II {_share(whole.type_two)}"
    return [
        (
            f"{name}: F1 of pairs",
            f"{whole.f1:.2f}{_between(scores)} (precision {whole.precision:.2f}, recall {whole.recall:.2f}), {errors}",
            how,
        ),
        (f"{name}: CPU time", f"{seconds / len(done):.2f} s{beside}", cost),
    ]


def settings(engine: str) -> str:
    """Say what an engine was told and how it is set."""
    chosen: Mapping[str, Any] = {"dtai-locomotif": engines.LOCOMOTIF, "stumpy": engines.STUMPY}.get(
        engine, {}
    )
    k = engines.columns(chosen.get("k", "mdl"), 45)
    told = TOLD[engine].format(**{**asdict(engines.GUESSED), **chosen, "k": k})
    return told.replace("the middle repetition", "geometric mean of shortest and longest repetition")


def hints(one: Strung) -> Hints:
    """What the truth tells the engines that must be told something."""
    return Hints(*told_lengths(one.truth), sets=len(one.truth.recurring))


def asked(engine: str, one: Strung) -> Answer | None:
    """Let an engine search in a process of its own; None where it takes too long."""
    with tempfile.TemporaryDirectory() as room:
        file = io.save(one.postures, Path(room) / "postures.npz")
        call = engines.command(engine, str(file), hints(one))
        try:
            out = subprocess.run(call, capture_output=True, text=True, check=True, timeout=LIMIT_S).stdout
        except subprocess.TimeoutExpired:
            return None
    told = json.loads(out.splitlines()[-1])
    return Answer(judged(one, told["sets"]), told["seconds"])


def judged(one: Strung, sets: engines.Sets) -> PatternScores:
    """Judge an answer; all pairs within a set are its pairs, of every engine."""
    return evaluate_patterns(one.truth, engines.found_patterns(sets, RATE))


def fit(which: list[str]) -> None:
    """Try settings on the actors that a method may be fitted on."""
    tries = {"dtai-locomotif": _tries_of_locomotif, "stumpy": _tries_of_stumpy}
    for engine in which:
        scores: dict[str, list[PatternScores]] = {}
        for one in _fitted_on(LONGEST_FIT[engine]):
            for chosen, sets in tries[engine](one):
                scores.setdefault(json.dumps(chosen), []).append(judged(one, sets))
        for chosen, given in sorted(scores.items(), key=lambda item: pool(item[1]).f1):
            whole = pool(given)
            print(
                f"{engine} F1 {whole.f1:.3f} (P {whole.precision:.3f}, R {whole.recall:.3f}) {chosen}",
                flush=True,
            )


def _fitted_on(longest: int) -> Iterator[Strung]:
    for frames, recordings in FIT.items():
        if frames <= longest:
            yield from (strung(actor, first, frames) for actor, first in recordings)


def _tries_of_locomotif(one: Strung) -> Iterator[tuple[dict[str, Any], engines.Sets]]:
    for scaled, rho, overlap in itertools.product(("whole", "columns"), RHOS, (0.0, 0.25)):
        chosen = {"scaled": scaled, "rho": rho, "overlap": overlap}
        yield chosen, engines.locomotif(one.postures, hints(one), chosen)


def _tries_of_stumpy(one: Strung) -> Iterator[tuple[dict[str, Any], engines.Sets]]:
    for normalize, length in itertools.product((True, False), ("shortest", "middle", "longest")):
        window = engines.window_of(hints(one), length)
        profile = engines.profile_of(one.postures, window, {"normalize": normalize})
        for k, spread, apart in itertools.product(("mdl", 0.5, 1.0), (1.0, 1.5, 2.0), (1, 4)):
            chosen = {"normalize": normalize, "window": length, "k": k, "spread": spread, "apart": apart}
            yield chosen, engines.stumpy_motifs(one.postures, profile, window, hints(one), chosen)


def _between(scores: list[PatternScores]) -> str:
    low, high = interval(scores, "f1")
    return "" if math.isnan(low) else f" [{low:.2f} to {high:.2f}]"


def _share(value: float) -> str:
    return "none" if math.isnan(value) else f"{value:.1%}"


if __name__ == "__main__":
    main()
