"""Where the recordings of the benchmarks are: by one name each, whether they lie loose or in an archive.

A name is a path below the folder that ``LEITMOTION_DATA`` names, with forward slashes. What lies in an archive goes on
behind the archive's name: ``hdm05/hdm05_bd_bk_dg.tar.xz/squat1Reps/HDM_bk_squat1Reps_001_120.amc``. An archive is
unpacked once, into the folder that ``LEITMOTION_CACHE`` names, else the user's cache folder.
"""

from __future__ import annotations

import os
import shutil
import tarfile
import tempfile
import zipfile
from functools import cache
from pathlib import Path

ARCHIVES = (".tar.xz", ".zip")


def folder() -> Path:
    """Folder of the recordings."""
    named = os.environ.get("LEITMOTION_DATA")
    if not named:
        raise FileNotFoundError("LEITMOTION_DATA names the folder of the recordings; it is not set.")
    return Path(named)


def locate(name: str) -> Path:
    """Path of a recording by its name."""
    parts = name.split("/")
    for k, part in enumerate(parts):
        if part.endswith(ARCHIVES):
            return unpacked("/".join(parts[: k + 1])).joinpath(*parts[k + 1 :])
    return folder() / name


@cache
def unpacked(archive: str) -> Path:
    """Folder in which the files of an archive lie; it appears whole or not at all."""
    packed = folder() / archive
    home = os.environ.get("LEITMOTION_CACHE") or Path.home() / ".cache" / "leitmotion"
    place = Path(home) / f"{packed.name}-{packed.stat().st_size}"
    if place.is_dir():
        return place
    place.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=place.parent) as room:
        whole = Path(room) / "whole"
        if packed.name.endswith(".zip"):
            with zipfile.ZipFile(packed) as files:
                files.extractall(whole)
        else:
            with tarfile.open(packed) as members:
                members.extractall(whole, filter="data")
        try:
            whole.rename(place)
        except OSError:  # another process was faster
            if not place.is_dir():
                shutil.move(whole, place)
    return place
