"""The motions of paper S: motifs and motion graphs of 200 variations of each.

Composed with joint noise, amplitude, tempo, an offset on one side and dwells, all at once; seeds 1000 to 1199, which no
detector was fitted on. A recording is right when every motif asked for is told and none that is not there, or when its
graph is the thesis's but for the letters.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from typing import NamedTuple

import intervals
import leitmotion as lm
from leitmotion.evaluation import GraphPath, GraphShape, GraphState, MotifSpan, evaluate_motifs, same_graph
from motif_cases import FITTING, MOTIONS, REPORTING, case, graph_told, motifs_told

Row = tuple[str, str, str]
HOW = "seeds 1000 to 1199, 120 Hz, all variations at once; Wilson's interval, 95 %"
CHEAP_MOTIF = "asymmetric_cycle"


class Outcome(NamedTuple):
    """What was right about one recording."""

    name: str
    motifs: bool
    graph: bool
    cheap_motifs: bool
    cheap_graph: bool
    wrong: tuple[str, ...]
    """Motifs that were missed (-) or false (+)."""


def main() -> None:
    """Print the table of some seeds: by default those for fitting."""
    asked = argparse.ArgumentParser(description=main.__doc__)
    asked.add_argument("--seeds", type=int, nargs=2, default=(FITTING.start, FITTING.stop))
    asked.add_argument("--motions", nargs="*", default=MOTIONS)
    given = asked.parse_args()
    for name in given.motions:
        found = judge([name], range(*given.seeds))
        wrong = Counter(each for outcome in found for each in outcome.wrong)
        print(f"{name}: {shares(found)}; {', '.join(f'{w} {n}' for w, n in wrong.most_common())}")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    found = judge(MOTIONS, REPORTING)
    table = []
    for name in MOTIONS:
        mine = [outcome for outcome in found if outcome.name == name]
        table.append((f"{name}: motifs right", told([o.motifs for o in mine]), HOW))
        table.append((f"{name}: graph right", told([o.graph for o in mine]), HOW))
    table.append(("all: motifs right", told([o.motifs for o in found]), HOW))
    table.append(("all: graph right", told([o.graph for o in found]), HOW))
    table.append(("all: motifs and graph right", told([o.motifs and o.graph for o in found]), HOW))
    cheap = f"the whole recording is told as {CHEAP_MOTIF}, cyclic"
    table.append(("a cheap answer: motifs right", told([o.cheap_motifs for o in found]), cheap))
    table.append(("a cheap answer: graph right", told([o.cheap_graph for o in found]), "A; aa →"))
    return table


def judge(names: Sequence[str], seeds: Iterable[int]) -> list[Outcome]:
    """Judge each variation of each motion."""
    with ProcessPoolExecutor(2) as pool:
        return list(pool.map(outcome, *zip(*((name, seed) for name in names for seed in seeds), strict=True)))


def outcome(name: str, seed: int) -> Outcome:
    """Judge one recording."""
    true = case(name, seed)
    scores = evaluate_motifs(motifs_told(lm.find_symmetry(true.motion)), true.asked, true.steps)
    graph = graph_told(lm.motion_graph(true.motion))
    whole = MotifSpan(CHEAP_MOTIF, 0, len(true.motion), cyclic=True)
    loop = GraphShape([GraphState("A", False)], [GraphPath("A", "A", False, False)])
    return Outcome(
        name,
        scores.right,
        same_graph(graph, true.graph),
        evaluate_motifs([whole], true.asked, true.steps).right,
        same_graph(loop, true.graph),
        wrong(scores.missed, "-") + wrong(scores.false, "+"),
    )


def wrong(spans: Iterable[MotifSpan], sign: str) -> tuple[str, ...]:
    """Name the motifs that were wrong, each once a recording."""
    return tuple(sorted({f"{sign}{span.motif}" for span in spans}))


def shares(found: Sequence[Outcome]) -> str:
    """Say what share of recordings is right."""
    return f"motifs {told([o.motifs for o in found])}, graph {told([o.graph for o in found])}"


def told(right: Sequence[bool]) -> str:
    """Say a share with its interval."""
    low, high = intervals.of_share(sum(right), len(right))
    return f"{sum(right)} of {len(right)} ({100 * low:.1f} to {100 * high:.1f} %)"


if __name__ == "__main__":
    main()
