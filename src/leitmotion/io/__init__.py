"""How is it stored: one file per format, one table of extensions; the only room that opens files."""

from leitmotion.io.formats import EXTENSIONS, Format
from leitmotion.io.reading import Finding, Reading
from leitmotion.io.sources import open_recording, read, read_all

__all__ = ["EXTENSIONS", "Finding", "Format", "Reading", "open_recording", "read", "read_all"]
