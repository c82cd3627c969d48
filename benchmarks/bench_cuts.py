"""Where cycles are cut: three ways, by the error of their borders.

Composed sessions, whose cycles are known exactly. Which moment of a cycle it is cut at is a matter of taste: of each
run the middle difference between found and true borders is taken off first.
"""

from __future__ import annotations

import numpy as np

from leitmotion import body, datasets, discovery, features
from leitmotion.discovery.cuts import CUTS

Row = tuple[str, str, str]
SEEDS = range(51, 61)
SLACK = 60  # frames that a run may reach beyond the stretch of its action


def main() -> None:
    """Print the table."""
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    sessions = [datasets.compose_session(seed=seed) for seed in SEEDS]
    postures = [features.posture(body.embody(session.motion)) for session in sessions]
    table = []
    for cuts in CUTS:
        errors: list[float] = []
        counts: list[int] = []
        for session, given in zip(sessions, postures, strict=True):
            found = discovery.find_patterns(given, cuts=cuts).patterns
            for borders, true in runs(found, session):
                counts.append(len(borders) == len(true))
                if counts[-1]:
                    off = (borders - true) / given.rate
                    errors += list(np.abs(off - np.median(off)))
        table.append(
            (
                f'Borders cut by "{cuts}"',
                f"{np.mean(errors):.4f} s mean, {np.median(errors):.4f} s median; "
                f"count right in {sum(counts)} of {len(counts)} runs",
                f"{len(errors)} borders of composed sessions, seeds {SEEDS[0]} to {SEEDS[-1]}, in runs of right count",
            )
        )
    return table


def runs(
    found: tuple[discovery.Pattern, ...], session: datasets.Session
) -> list[tuple[np.ndarray, np.ndarray]]:
    """Found and true borders of each stretch of an action; none found where nothing lies in it."""
    given = np.array([(a, b) for p in found if p.cycles for a, b, _, _ in p.occurrences]).reshape(-1, 2)
    given = given[np.argsort(given[:, 0])]
    both = []
    for start, stop, label, _ in session.stretches:
        true = np.array([(a, b) for a, b, name, _ in session.cycles if name == label and start <= a < stop])
        here = given[(given[:, 0] >= start - SLACK) & (given[:, 1] <= stop + SLACK)]
        if len(true):
            both.append(tuple(np.append(spans[:, 0], spans[-1:, 1]) for spans in (here, true)))
    return both


if __name__ == "__main__":
    main()
