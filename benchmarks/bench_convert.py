"""Converting a whole folder, with one process and with two.

The folder is the one that ``LEITMOTION_DATA`` names: every loose file of a format that is read, to the archive. What
another program does meanwhile lengthens the wall time, so the load of the machine before the run is told.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

Row = tuple[str, str, str]
RUNS = 3


class Run(NamedTuple):
    """How long a conversion took, and what it said in the end."""

    wall_s: float
    cpu_s: float
    said: str


def main() -> None:
    """Print the table."""
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    named = os.environ.get("LEITMOTION_DATA", "")
    if not named or not Path(named).is_dir():
        why = "needs the folder of recordings that LEITMOTION_DATA names"
        return [("Converting a folder", "not measured", why)]
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")
    with tempfile.TemporaryDirectory() as scratch:
        convert(named, Path(scratch) / "first", jobs=2)  # kernels compiled, files in the system's cache
        one = min((convert(named, Path(scratch) / f"one{k}", jobs=1) for k in range(RUNS)), key=_wall)
        two = min((convert(named, Path(scratch) / f"two{k}", jobs=2) for k in range(RUNS)), key=_wall)
        again = min((convert(named, Path(scratch) / "two0", jobs=2) for _ in range(RUNS)), key=_wall)
    protocol = (
        f"loose files to .npz, best of {RUNS} by wall time, kernels compiled before, load before {load:.1f}"
    )
    return [
        ("Files", two.said, protocol),
        ("One process", f"{one.wall_s:.1f} s, {one.cpu_s:.1f} s of CPU", protocol),
        ("Two processes", f"{two.wall_s:.1f} s, {two.cpu_s:.1f} s of CPU", protocol),
        ("Two against one", f"{one.wall_s / two.wall_s:.2f} times as fast", protocol),
        ("Cores in use by two", f"{two.cpu_s / two.wall_s:.2f}", f"CPU time by wall time; {protocol}"),
        (
            "A second run",
            f"{again.wall_s:.1f} s, {again.cpu_s:.1f} s of CPU",
            f"nothing left to do; {protocol}",
        ),
    ]


def convert(source: str, target: Path, *, jobs: int) -> Run:
    """Run the command line, and measure it with all its processes."""
    command = [sys.executable, "-m", "leitmotion", "convert", source, "-o", str(target), "--to", "npz"]
    before, began = os.times(), time.perf_counter()
    ran = subprocess.run([*command, "--quiet", "--jobs", str(jobs)], capture_output=True, text=True)
    wall, after = time.perf_counter() - began, os.times()
    spent = (after.children_user + after.children_system) - (before.children_user + before.children_system)
    said = re.findall(r"^Converted .*(?=\.$)", ran.stdout, re.MULTILINE)
    return Run(wall, spent, said[-1] if said else f"failed: {ran.stderr[-200:]}")


def _wall(run: Run) -> float:
    return run.wall_s


if __name__ == "__main__":
    main()
