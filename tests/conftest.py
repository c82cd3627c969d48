"""Fixtures that every test may take, and the rule that nothing is skipped where everything must be there."""

import os
from collections.abc import Iterator
from pathlib import Path

import hypothesis
import numpy as np
import pytest

BESIDE = Path(__file__).resolve().parents[1].parent / "shared" / "data"
NO_SKIPS = bool(os.environ.get("LEITMOTION_NO_SKIPS"))
NEVER_SKIPPED = ("data", "browser")

hypothesis.settings.register_profile("house", deadline=None)  # speed is measured in benchmarks, not in tests
hypothesis.settings.load_profile("house")


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


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Iterator[pytest.TestReport | pytest.CollectReport]:
    """Under LEITMOTION_NO_SKIPS, fail a test of the recordings or the page that would be skipped."""
    report = yield
    if any(item.get_closest_marker(name) for name in NEVER_SKIPPED):
        _refuse_skip(report)
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(collector: pytest.Collector) -> Iterator[pytest.CollectReport]:
    """Under LEITMOTION_NO_SKIPS, fail a whole file that would be skipped."""
    report = yield
    _refuse_skip(report)
    return report


def _refuse_skip(report: pytest.TestReport | pytest.CollectReport) -> None:
    if NO_SKIPS and report.skipped and not hasattr(report, "wasxfail"):
        reason = report.longrepr[2] if isinstance(report.longrepr, tuple) else report.longrepr
        report.outcome = "failed"
        report.longrepr = f"{report.nodeid} may not be skipped under LEITMOTION_NO_SKIPS. {reason}"
