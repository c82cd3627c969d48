"""Writing EAF, the annotations of ELAN.

On one tier annotations do not overlap, so that stretches which do stand on further tiers: ``patterns``, ``patterns 2``.

References
----------
.. [1] EAF 3.0, the ELAN annotation format: schema EAFv3.0.xsd. Max Planck Institute for Psycholinguistics, Nijmegen.
"""

from __future__ import annotations

import mimetypes
import re
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

from leitmotion.motion import ParameterError, Segmentation

_NEVER = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # what XML cannot hold
REMARK = "<!-- Leitmotion wrote this; it is gone when another program has saved it. -->"
"""Stands near the start of every file: what ELAN saves has no remarks."""
_DATE = "2000-01-01T00:00:00Z"  # the format wants one; the same stretches make the same file whenever it is written


def eaf_of(segmentation: Segmentation, *, tier: str = "labels", media: str | Path | None = None) -> str:
    """Make the text of an EAF 3.0.

    Times are rounded to milliseconds, of which each stretch has at least one; scores have no place in it.

    Parameters
    ----------
    segmentation : Segmentation
        The stretches; those that overlap stand on further tiers.
    tier : str
        What the tier is called.
    media : str or path, optional
        The video or sound that ELAN opens with it.

    Returns
    -------
    str
        The text.

    Raises
    ------
    ParameterError
        When a label or name holds what XML cannot.

    Examples
    --------
    >>> text = eaf_of(Segmentation([0], [60], ("walk",), rate=120))
    >>> [line.strip() for line in text.splitlines() if "TIME_VALUE" in line]
    ['<TIME_SLOT TIME_SLOT_ID="ts1" TIME_VALUE="0"/>', '<TIME_SLOT TIME_SLOT_ID="ts2" TIME_VALUE="500"/>']
    """
    for word in (tier, *segmentation.labels, str(media or "")):
        if _NEVER.search(word):
            raise ParameterError(
                f"An EAF holds printable text, got {word!r:.60}.", remedy="Change this label."
            )
    order = sorted(range(len(segmentation)), key=lambda k: (segmentation.starts[k], segmentation.stops[k]))
    starts = [round(float(segmentation.starts[k]) * 1000 / segmentation.rate) for k in order]
    stops = [round(float(segmentation.stops[k]) * 1000 / segmentation.rate) for k in order]
    times = [(start, max(stop, start + 1)) for start, stop in zip(starts, stops)]
    slots = sorted((time, 2 * n + last) for n, pair in enumerate(times) for last, time in enumerate(pair))
    named = {which: f"ts{k}" for k, (_, which) in enumerate(slots, 1)}
    free: list[int] = []  # when each tier is free again
    lines: list[list[str]] = []
    for n, k in enumerate(order):
        row = next((row for row, until in enumerate(free) if until <= times[n][0]), len(free))
        if row == len(free):
            free.append(0)
            lines.append([])
        free[row] = times[n][1]
        lines[row].append(_annotation(n + 1, named[2 * n], named[2 * n + 1], segmentation.labels[k]))
    tiers = [tier, *(f"{tier} {k}" for k in range(2, len(lines) + 1))]
    return "\n".join([
        '<?xml version="1.0" encoding="UTF-8"?>',
        REMARK,
        f'<ANNOTATION_DOCUMENT AUTHOR="" DATE="{_DATE}" FORMAT="3.0" VERSION="3.0" '
        'xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" '
        'xsi:noNamespaceSchemaLocation="http://www.mpi.nl/tools/elan/EAFv3.0.xsd">',
        '  <HEADER MEDIA_FILE="" TIME_UNITS="milliseconds">',
        *_media(media),
        f'    <PROPERTY NAME="lastUsedAnnotationId">{len(segmentation)}</PROPERTY>',
        "  </HEADER>",
        "  <TIME_ORDER>",
        *(f'    <TIME_SLOT TIME_SLOT_ID="{named[which]}" TIME_VALUE="{time}"/>' for time, which in slots),
        "  </TIME_ORDER>",
        *(
            line
            for name, held in zip(tiers, lines or [[]])
            for line in (f'  <TIER LINGUISTIC_TYPE_REF="default-lt" TIER_ID={quoteattr(name)}>', *held, "  </TIER>")
        ),
        '  <LINGUISTIC_TYPE GRAPHIC_REFERENCES="false" LINGUISTIC_TYPE_ID="default-lt" TIME_ALIGNABLE="true"/>',
        "</ANNOTATION_DOCUMENT>",
        "",
    ])  # fmt: skip


def _annotation(number: int, begin: str, end: str, label: str) -> str:
    value = escape(label, {"\r": "&#13;"})  # XML makes a line feed of the bare one
    return (
        f'    <ANNOTATION><ALIGNABLE_ANNOTATION ANNOTATION_ID="a{number}" TIME_SLOT_REF1="{begin}" '
        f'TIME_SLOT_REF2="{end}"><ANNOTATION_VALUE>{value}</ANNOTATION_VALUE></ALIGNABLE_ANNOTATION></ANNOTATION>'
    )


def _media(media: str | Path | None) -> list[str]:
    if media is None:
        return []
    path = Path(media)
    kind = mimetypes.MimeTypes().guess_type(path.name)[0] or "unknown"  # without the tables of the machine
    address = path.resolve().as_uri()
    return [
        f"    <MEDIA_DESCRIPTOR MEDIA_URL={quoteattr(address)} MIME_TYPE={quoteattr(kind)} "
        f"RELATIVE_MEDIA_URL={quoteattr(f'./{path.name}')}/>"
    ]
