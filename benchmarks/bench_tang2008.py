"""Paper P to the letter, on recordings.

What the method of 2008 answers where the truth is known; docs/papers/P.md tells why.
"""

from __future__ import annotations

import os
import time
from pathlib import Path

from leitmotion import body, datasets, features, io
from leitmotion.discovery import Patterns, find_patterns_tang2008

Row = tuple[str, str, str]
RECORDINGS = (
    ("bandai_namco/dataset-1_walk_normal_001.bvh", "a walk of 6 full cycles"),
    ("cmu_bvh/jumping_jacks.bvh", "3 jumping jacks"),
    ("hdm05/lieDownFloor/HDM_bd_lieDownFloor_001_120.amc", "lying down once: nothing recurs"),
    ("cmu86/86_01.amc[21s:26.5s]", "a walk of 3 full cycles, cut from 86_01"),
    ("cmu86/86_01.amc", "walk, jump, walk, punch, walk, kick, punch: 4 movements recur"),
)


def main() -> None:
    """Print the table."""
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    session = datasets.compose_session(seed=0)
    truth = f"the practice session, {len(set(session.cycles.labels))} movements recur"
    table = [row(truth, features.posture(body.embody(session.motion)))]
    folder = os.environ.get("LEITMOTION_DATA", "")
    for name, truth in RECORDINGS:
        what = f"{Path(name).name}: {truth}"
        if not folder or not (Path(folder) / name.partition("[")[0]).is_file():
            table.append((what, "not measured", f"needs {name} in the folder that LEITMOTION_DATA names"))
            continue
        table.append(row(what, features.posture(body.embody(io.read(f"{folder}/{name}")))))
    return table


def row(what: str, sequence: features.FeatureSequence) -> Row:
    """Search one recording."""
    find_patterns_tang2008(sequence[:60])
    began = time.process_time()
    found = find_patterns_tang2008(sequence)
    seconds = time.process_time() - began
    return (
        what,
        in_words(found),
        f"defaults; T = 0.26 of the largest distance is {found.parameters['max_distance_own_unit'] * 100:.0f} cm here; "
        f"{found.parameters['traces']} traces; {seconds:.1f} CPU s",
    )  # fmt: skip


def in_words(found: Patterns) -> str:
    """Say how many patterns there are, and the first."""
    if not found.patterns:
        return "no pattern"
    first = found.patterns[0]
    kinds = [pattern.kind for pattern in found.patterns]
    count = f"{kinds.count('cyclic')} cyclic and {kinds.count('acyclic')} acyclic patterns"
    return f"{count}; first: {first.kind}, {len(first.occurrences)} occurrences of {first.period_s:.2f} s"


if __name__ == "__main__":
    main()
