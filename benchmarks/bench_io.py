"""Reading and writing: AMC, BVH, C3D, glTF and the archive, beside the public readers that are installed.

Recordings come from the folder that ``LEITMOTION_DATA`` names: CMU trial 01_01 as AMC and as BVH, and a trial of pyCGM
as C3D. Without them there is nothing to measure. The long C3D is a random walk, which Leitmotion writes itself.
"""

from __future__ import annotations

import importlib
import importlib.util
import os
import subprocess
import sys
import tempfile
import time
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np

from leitmotion import io
from leitmotion.motion import Motion, Trajectories, forward_kinematics

Row = tuple[str, str, str]
RUNS = 7
PEAK = """
import re, sys
from pathlib import Path
import numpy as np
from leitmotion import io
from leitmotion.motion import Trajectories
small = Path(sys.argv[1]).with_name("small.c3d")
io.read(io.write(Trajectories(("A", "B"), np.random.default_rng(0).normal(size=(9, 2, 3)), 120), small))
def kilobytes(what):  # not by resource, whose peak a new process takes over from its parent
    return int(re.search(what + r":\\s*(\\d+)", Path("/proc/self/status").read_text())[1])
before = kilobytes("VmRSS")
kept = io.read(sys.argv[1])
print((kilobytes("VmHWM") - before) * 1024)
"""
AMC, BVH, C3D = "cmu_amc/01_01.amc", "cmu_bvh/01_01.bvh", "pycgm/Movement_trial.c3d"


def main() -> None:
    """Print the table."""
    for what, figure, protocol in rows():
        print(f"{what}: {figure} ({protocol})")


def rows() -> list[Row]:
    """Measure; (what, figure, protocol) for every line."""
    named = os.environ.get("LEITMOTION_DATA", "")
    paths = [Path(named) / name for name in (AMC, BVH, C3D)]
    if not named or not all(path.is_file() for path in paths):
        why = f"needs {AMC}, {BVH} and {C3D} in the folder of recordings that LEITMOTION_DATA names"
        return [("Reading", "not measured", why)]
    amc, bvh, c3d = paths
    frames = len(io.read(amc))
    protocol = f"CPU time, best of {RUNS}, file in the system's cache, kernels compiled before"
    to_positions = best(lambda: forward_kinematics(io.read(amc)))
    table = [
        ("AMC to a motion", speed(amc, best(lambda: io.read(amc))), f"{AMC}, {frames:,} frames; {protocol}"),
        (
            "AMC from file to global positions",
            f"{frames / to_positions:,.0f} frames/s",
            f"{AMC}, {frames:,} frames, 31 joints; {protocol}",
        ),
        ("BVH to a motion", speed(bvh, best(lambda: io.read(bvh))), f"{BVH}; {protocol}"),
        (
            "C3D to trajectories",
            speed(c3d, best(lambda: io.read(c3d))),
            f"{C3D}, 239 points, 69 analog; {protocol}",
        ),
    ]
    motion = io.read(amc)
    with tempfile.TemporaryDirectory() as folder:
        archive = io.save(motion, Path(folder) / "motion.npz")
        seconds = best(lambda: io.load(archive))
        table.append(("Archive to a motion", speed(archive, seconds), f"{AMC} saved; {protocol}"))
        table += [
            writer(motion, "BVH", Path(folder) / "motion.bvh", f"{AMC} written with all digits; {protocol}")
        ]
        for name, ending in (("C3D", "c3d"), ("binary glTF", "glb"), ("glTF as text", "gltf")):
            table.append(writer(motion, name, Path(folder) / f"motion.{ending}", f"{AMC}; {protocol}"))
        table += long_c3d(Path(folder) / "long.c3d")
    return table + peers(bvh, c3d, protocol)


def writer(motion: Motion, name: str, path: Path, how: str) -> Row:
    """Measure how fast a motion is written."""
    seconds = best(lambda: io.write(motion, path))
    return (f"A motion to {name}", f"{len(motion) / seconds:,.0f} frames/s, {speed(path, seconds)}", how)


def long_c3d(path: Path) -> list[Row]:
    """Measure a C3D of half an hour: how fast it is read, and how much memory that takes at most."""
    rng = np.random.default_rng(0)
    steps = rng.normal(0, 0.002, (216_000, 40, 3)).cumsum(axis=0)
    steps[rng.random(steps.shape[:2]) < 0.02] = np.nan
    io.write(Trajectories(tuple(f"M{k}" for k in range(40)), steps, 120), path)
    del steps
    how = "216,000 frames of 40 points, 2 % of them unseen, floats"
    seconds = best(lambda: io.read(path), runs=3)
    peak = subprocess.run(
        [sys.executable, "-c", PEAK, str(path)], check=True, capture_output=True, text=True
    ).stdout
    return [
        (
            "A long C3D to trajectories",
            speed(path, seconds),
            f"{how}; CPU time, best of 3, file in the cache",
        ),
        (
            "Memory to read it",
            f"{int(peak) / path.stat().st_size:.1f} x the file",
            f"{how}; peak resident above a process that has read a small one, the file and the result included",
        ),
    ]


def peers(bvh: Path, c3d: Path, protocol: str) -> list[Row]:
    """Measure the public readers that are installed, in the same run."""

    def bvhtools() -> object:
        return importlib.import_module("bvhTools.bvhIO").readBvh(str(bvh))

    def ezc3d() -> object:
        return importlib.import_module("ezc3d").c3d(str(c3d))

    def c3d_reader() -> object:
        with c3d.open("rb") as file, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return list(importlib.import_module("c3d").Reader(file).read_frames())

    table = []
    for name, package, path, read in (
        ("BVH by bvhtools, rows of numbers only", "bvhTools", bvh, bvhtools),
        ("C3D by ezc3d, points and analog", "ezc3d", c3d, ezc3d),
        ("C3D by c3d, points and analog", "c3d", c3d, c3d_reader),
    ):
        if importlib.util.find_spec(package) is None:
            table.append((name, "not installed", "python -m pip install 'leitmotion[bench]'"))
        else:
            runs = 3
            seconds = best(read, runs=runs)
            how = protocol.replace(f"best of {RUNS}", f"best of {runs}")
            table.append((name, speed(path, seconds), f"{path.parent.name}/{path.name}; {how}"))
    return table


def best(call: Callable[[], object], runs: int = RUNS) -> float:
    """CPU seconds of the fastest of several runs, after one that is not counted."""
    call()
    seconds = []
    for _ in range(runs):
        start = time.process_time()
        call()
        seconds.append(time.process_time() - start)
    return min(seconds)


def speed(path: Path, seconds: float) -> str:
    """Megabytes of the file a second."""
    return f"{path.stat().st_size / 1e6 / seconds:,.0f} MB/s"


if __name__ == "__main__":
    main()
