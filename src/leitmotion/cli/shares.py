"""The symmetry of several recordings side by side: an index, and the share of time that each motif takes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from leitmotion.cli.documents import SCORE_DIGITS, Document
from leitmotion.cli.printing import answer_console, print_table

if TYPE_CHECKING:
    from leitmotion.api import Symmetry

MOTIFS = (
    "anti_phase", "anti_palindrome", "symmetric_palindrome", "symmetric_cycle", "symmetric_path",
    "asymmetric_palindrome", "asymmetric_cycle", "reflected_path_repetition", "path_reversal", "path_repetition",
    "reflected_state_repetition", "state_repetition", "stillness",
)  # fmt: skip
"""In the order in which people are told them."""
COLUMNS = ("path", "seconds", "symmetry_index", *MOTIFS, "error")
"""Columns of the table, one row per recording; one that failed has its path and the error."""


def shares_of(found: Symmetry) -> dict[str, float]:
    """Tell which share of its time a recording has each motif; of a pair both stretches count."""
    import numpy as np

    shares = {}
    for motif in MOTIFS:
        taken = np.zeros(found.frames, dtype=bool)
        for span in found.spans:
            if span.motif == motif:
                for start, stop in ((span.start, span.stop), span.partner or (0, 0)):
                    taken[start:stop] = True
        shares[motif] = round(float(taken.mean()), SCORE_DIGITS)
    return shares


def shares_rows(document: Document) -> Iterator[Mapping[str, object]]:
    """One row per recording."""
    source = document["source"][0]
    row = dict.fromkeys(COLUMNS) | {"path": source["path"]}
    if "error" in document:
        error = document["error"]
        yield row | {"error": f"{error['message']} {error['remedy']}".strip()}
        return
    result = document["result"]
    yield (
        row | {"seconds": source["seconds"], "symmetry_index": result["symmetry_index"]} | result["shares"]
    )


def show_shares(documents: Sequence[Document]) -> None:
    """Print the recordings side by side, where there are several; motifs that none has are left out."""
    from leitmotion.view.symmetry_words import TOLD

    answered = [document for document in documents if "result" in document]
    if len(answered) < 2:
        return
    results = [document["result"] for document in answered]
    held = [motif for motif in MOTIFS if any(result["shares"][motif] for result in results)]
    console = answer_console()
    console.print()
    print_table(
        console,
        (">index", *(f">{TOLD[motif].term}" for motif in held), "share of time"),
        [
            (
                "" if result["symmetry_index"] is None else f"{result['symmetry_index']:.2f}",
                *(f"{result['shares'][motif]:.0%}" if result["shares"][motif] else "" for motif in held),
                document["source"][0]["path"],
            )
            for document, result in zip(answered, results, strict=True)
        ],
    )
