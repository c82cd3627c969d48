"""Run every benchmark and rewrite the tables of docs/benchmarks.md: ``python benchmarks/run.py [NAME...]``.

Each ``benchmarks/bench_NAME.py`` offers ``rows()``, which measures and returns ``(what, figure, protocol)`` for every
line of its table; the first line of its docstring is the table's heading. A table stands between the markers
``<!-- bench NAME -->`` and ``<!-- end NAME -->``; a new one is added at the end.
"""

from __future__ import annotations

import datetime
import importlib
import importlib.metadata
import os
import platform
import re
import sys
import time
from collections.abc import Sequence
from pathlib import Path

HERE = Path(__file__).resolve().parent
PAGE = HERE.parent / "docs" / "benchmarks.md"
VERSIONS = ("leitmotion", "numpy", "scipy", "numba")
Row = tuple[str, str, str]

INTRODUCTION = """# Benchmarks

Every number on this page was printed by `make bench`. Timings are CPU time of one process, the best of several runs;
the protocol of each stands beside it. Measurements on real recordings need the folder that `LEITMOTION_DATA` names.
"""


def main(names: Sequence[str]) -> int:
    """Measure what was named, or everything, and rewrite those tables."""
    sys.path.insert(0, str(HERE))
    known = sorted(path.stem.removeprefix("bench_") for path in HERE.glob("bench_*.py"))
    unknown = sorted(set(names) - set(known))
    if unknown:
        print(f"There is no benchmark {', '.join(unknown)}; there are {', '.join(known)}.", file=sys.stderr)
        return 2
    text = PAGE.read_text(encoding="utf-8") if PAGE.exists() else INTRODUCTION
    for name in names or known:
        began = time.perf_counter()
        module = importlib.import_module(f"bench_{name}")
        heading = (module.__doc__ or name).splitlines()[0].rstrip(".")
        rows = module.rows()
        print(f"{heading} ({time.perf_counter() - began:.0f} s)")
        for what, figure, _ in rows:
            print(f"  {what}: {figure}")
        text = put(text, name, table(heading, rows))
    PAGE.write_text(text, encoding="utf-8")
    return 0


def table(heading: str, rows: Sequence[Row]) -> str:
    """Format one table, with when, where and with what it was measured."""
    lines = [f"## {heading}", "", f"Measured {datetime.date.today()} on {machine()}.", ""]
    lines += ["| what | figure | how |", "|---|---|---|"]
    lines += ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    return "\n".join(lines)


def put(text: str, name: str, made: str) -> str:
    """Put a table between its markers, or add it with them at the end."""
    block = f"<!-- bench {name} -->\n{made}\n<!-- end {name} -->"
    marked = re.compile(rf"<!-- bench {re.escape(name)} -->.*?<!-- end {re.escape(name)} -->", re.DOTALL)
    if marked.search(text):
        return marked.sub(lambda _: block, text)
    return f"{text.rstrip()}\n\n{block}\n"


def machine() -> str:
    """Describe the machine and the versions, without its name."""
    versions = ", ".join(f"{name} {importlib.metadata.version(name)}" for name in VERSIONS)
    python = f"Python {platform.python_version()}"
    return f"{_processor()}, {os.cpu_count()} cores, {platform.system()}; {python}, {versions}"


def _processor() -> str:
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        found = re.search(r"^model name\s*:\s*(.+)$", cpuinfo.read_text(encoding="utf-8"), re.MULTILINE)
        if found:
            return re.sub(r"\s+", " ", found[1])
    return platform.processor() or platform.machine()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
