"""How is it stored: one file per format, one table of extensions; the only room that opens files."""

from leitmotion.io.annotation_doubt import read_cycles, read_unlabelled
from leitmotion.io.annotations import as_stretches, read_annotations, write_annotations
from leitmotion.io.answers import StoredPatterns, rate_of, read_answers
from leitmotion.io.archive import load, save
from leitmotion.io.files import write_whole
from leitmotion.io.formats import EXTENSIONS, Format
from leitmotion.io.pair_table import LabelledPair, read_pairs
from leitmotion.io.reading import Finding, Reading
from leitmotion.io.sinks import write
from leitmotion.io.sources import open_recording, read, read_all

__all__ = [
    "EXTENSIONS",
    "Finding",
    "Format",
    "LabelledPair",
    "Reading",
    "StoredPatterns",
    "as_stretches",
    "load",
    "open_recording",
    "rate_of",
    "read",
    "read_all",
    "read_annotations",
    "read_answers",
    "read_cycles",
    "read_pairs",
    "read_unlabelled",
    "save",
    "write",
    "write_annotations",
    "write_whole",
]
