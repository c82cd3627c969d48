"""How is it stored: one file per format, one table of extensions; the only room that opens files."""

from leitmotion.io.annotations import as_stretches, read_annotations, write_annotations
from leitmotion.io.archive import load, save
from leitmotion.io.files import write_whole
from leitmotion.io.formats import EXTENSIONS, Format
from leitmotion.io.reading import Finding, Reading
from leitmotion.io.sinks import write
from leitmotion.io.sources import open_recording, read, read_all
from leitmotion.io.unlabelled import read_unlabelled

__all__ = [
    "EXTENSIONS",
    "Finding",
    "Format",
    "Reading",
    "as_stretches",
    "load",
    "open_recording",
    "read",
    "read_all",
    "read_annotations",
    "read_unlabelled",
    "save",
    "write",
    "write_annotations",
    "write_whole",
]
