"""Spoil small files of every format for as long as one likes, and keep what breaks a reader.

    python tests/fuzz.py --minutes 60 [--seed 1] [--only C3D] [--keep fuzz-found]

Each case that is found stands in a folder of its own, with the files and the traceback; a case is told once for each
place in the code where it breaks.
"""

import argparse
import os
import sys
import time
import traceback
from pathlib import Path
from random import Random

from fuzzing.law import check, check_labels
from fuzzing.seeds import LABELS, SEEDS, SPOILED, cuts
from fuzzing.spoil import spoil


def main() -> int:
    """Run until the time is over; 1 where anything was found."""
    parser = argparse.ArgumentParser(
        description="Spoil small files of every format and keep what breaks a reader."
    )
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--seed", type=int, default=None, help="for the same cases again")
    parser.add_argument("--only", default="", help="seeds whose name holds this")
    parser.add_argument("--keep", type=Path, default=Path("fuzz-found"))
    given = parser.parse_args()
    seed = given.seed if given.seed is not None else time.time_ns() % 1_000_000_007
    seeds = {name: make() for name, make in (SEEDS | LABELS).items()}
    data = os.environ.get("LEITMOTION_DATA")
    if data:
        seeds |= cuts(Path(data))
    seeds = {name: files for name, files in seeds.items() if given.only.lower() in name.lower()}
    print(f"seed {seed}: {', '.join(seeds)}", flush=True)
    rng = Random(seed)
    known: set[tuple[str, ...]] = set()
    tried, until = 0, time.monotonic() + 60 * given.minutes
    while time.monotonic() < until:
        name = rng.choice(list(seeds))
        target = SPOILED.get(name, next(iter(seeds[name])))
        files = seeds[name] | {target: spoil(seeds[name][target], rng)}
        tried += 1
        try:
            (check_labels if name in LABELS else check)(files)
        except KeyboardInterrupt:
            break
        except BaseException as error:
            place = _place(error)
            if place not in known:
                known.add(place)
                folder = _keep(given.keep / f"{len(known):03}-{type(error).__name__}", files)
                print(f"{name}: {type(error).__name__}: {error!s:.200} at {place[-1]}: {folder}", flush=True)
    print(f"{tried} cases, {len(known)} places where a reader breaks.")
    return int(bool(known))


def _place(error: BaseException) -> tuple[str, ...]:
    frames = [f"{Path(one.filename).name}:{one.lineno}" for one in traceback.extract_tb(error.__traceback__)]
    return (type(error).__name__, *frames[-2:])


def _keep(folder: Path, files: dict[str, bytes]) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in files.items():
        (folder / name).write_bytes(content)
    (folder / "traceback.txt").write_text(traceback.format_exc(), encoding="utf-8")
    return folder


if __name__ == "__main__":
    sys.exit(main())
