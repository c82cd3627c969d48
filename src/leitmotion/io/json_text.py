"""JSON: a text to values, or a word why not."""

from __future__ import annotations

import json
from typing import Any

from leitmotion.io.reading import Source, glimpse

LARGEST = 512 << 20
"""Bytes of a JSON file at most; its values take some ten times as much memory."""


def parse(source: Source) -> Any:
    """Parse a JSON file.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    value
        What it holds.

    Raises
    ------
    FormatError
        When it is no JSON, nests too deeply or is larger than :data:`LARGEST`.
    """
    if len(source.content) > LARGEST:
        raise source.error(
            f"its JSON text of {len(source.content) / 1e6:.0f} MB is larger than the {LARGEST / 1e6:.0f} MB "
            "that are read.",
            remedy="Part it into shorter recordings.",
        )
    try:
        return json.loads(source.content.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        raise source.fault(error.start, "UTF-8 text", "other bytes", remedy="Save it as UTF-8.") from None
    except json.JSONDecodeError as error:
        position = len(error.doc[: error.pos].encode("utf-8"))
        found = glimpse(source.content[position:]) if position < len(source.content) else "the end"
        raise source.fault(
            position, "JSON", found, remedy="Was it copied or downloaded completely?"
        ) from None
    except RecursionError:
        raise source.error(
            "expected JSON that nests less than a thousand deep, found it nests too deeply."
        ) from None
    except ValueError:
        raise source.error("expected numbers, found one of thousands of digits.") from None
