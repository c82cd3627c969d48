"""Fixtures that every test may take."""

import os
from pathlib import Path

import numpy as np
import pytest

BESIDE = Path(__file__).resolve().parents[1].parent / "shared" / "data"


@pytest.fixture(scope="session")
def data() -> Path:
    """The folder of real recordings; a test that takes it is skipped where there is none."""
    folder = Path(os.environ.get("LEITMOTION_DATA") or BESIDE)
    if not folder.is_dir():
        pytest.skip(f"no folder of recordings at {folder}: set LEITMOTION_DATA to it")
    return folder


@pytest.fixture
def rng() -> np.random.Generator:
    """The seeded generator."""
    return np.random.default_rng(2008)
