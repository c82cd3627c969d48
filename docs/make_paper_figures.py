"""Make the figures of the papers' pages anew, from real recordings: ``python docs/make_paper_figures.py [NAME...]``.

Needs the folder of recordings (``LEITMOTION_DATA``). Each module of ``PAPERS`` offers ``FIGURES``: by name, a function
without arguments that returns a matplotlib figure. The pictures lie in ``papers/figures/``; the same recordings and
versions give the same pictures, to the byte.
"""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Callable, Sequence
from io import BytesIO
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
PICTURES = HERE / "papers" / "figures"
PAPERS = ("paper_p", "paper_s")
DENSITY = 150  # dots an inch


def main(names: Sequence[str]) -> int:
    """Make the figures named, or all."""
    if not Path(os.environ.get("LEITMOTION_DATA") or "nowhere").is_dir():
        print("LEITMOTION_DATA must name the folder of recordings.", file=sys.stderr)
        return 1
    sys.path.append(str(HERE.parent / "benchmarks"))
    known = figures()
    unknown = sorted(set(names) - set(known))
    if unknown:
        print(f"There is no figure {', '.join(unknown)}; there are {', '.join(known)}.", file=sys.stderr)
        return 2
    PICTURES.mkdir(parents=True, exist_ok=True)
    for name in names or known:
        path = PICTURES / f"{name}.webp"
        path.write_bytes(as_webp(known[name]()))
        print(f"{path.name} {path.stat().st_size / 1000:.0f} kB")
    return 0


def figures() -> dict[str, Callable[[], Any]]:
    """Every figure of every paper, by name."""
    found: dict[str, Callable[[], Any]] = {}
    for paper in PAPERS:
        found |= importlib.import_module(paper).FIGURES
    return found


def as_webp(figure: Any) -> bytes:
    """Draw a figure and compress it."""
    from PIL import Image

    drawn, packed = BytesIO(), BytesIO()
    figure.savefig(drawn, format="png", dpi=DENSITY, metadata={"Software": None})
    with Image.open(drawn) as picture:
        picture.convert("RGB").save(packed, "WEBP", quality=88, method=6)
    return packed.getvalue()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
