"""Parquet: the columns of a table, compressed, with what they mean in the file's metadata.

What is written here has the columns of :mod:`leitmotion.io.table_writing`. What others wrote is read as a table is: by
the names of its columns, a row a frame or a row a point. The library pyarrow reads and writes; it is imported on the
first use.
"""

from __future__ import annotations

import io
from typing import Any

import numpy as np

from leitmotion.io.columns import find_columns, read_columns
from leitmotion.io.long_table import find_long
from leitmotion.io.reading import Draft, Source
from leitmotion.io.table_writing import as_sheet
from leitmotion.motion import DataError, Motion, Trajectories

_KEYS = ("unit", "up", "rate", "kind", "name")
_MOST = 2**31  # numbers that a file may hold; a small one may promise any number of rows
_ROWS = 2**27


def read(source: Source) -> Draft:
    """Read a Parquet file of points.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person a name before a colon, else one.

    Raises
    ------
    FormatError
        When it is damaged, its columns name no points or nothing tells the rate.
    DataError
        When pyarrow is not installed.
    """
    arrow, parquet = _arrow()
    try:
        file = parquet.ParquetFile(io.BytesIO(source.content))
        header = file.schema_arrow.names
        metadata = {key.decode(): word.decode() for key, word in (file.schema_arrow.metadata or {}).items()
                    if key.decode("utf-8", "replace") in _KEYS}  # fmt: skip
        if file.metadata.num_rows > _ROWS or file.metadata.num_rows * len(header) > _MOST:
            raise source.error(
                f"expected a recording, found {file.metadata.num_rows:,} rows of {len(header)} columns."
            )
        table = file.read()
    except (arrow.ArrowException, OSError, UnicodeDecodeError) as error:
        why = " ".join(str(error).split())[:120]
        raise source.error(f"cannot be read as Parquet: {why}.", remedy="Was it copied completely?") from None
    if table.num_rows == 0:
        raise source.error("expected a row a frame, found none.")
    long = find_long(header)
    if long is not None and "kind" not in metadata:
        wide = long.widen(source, [column.to_pylist() for column in table.columns])
        header, values = wide.header, wide.values
        columns = find_columns(header, exact=True)
    else:
        columns = find_columns(header, exact="kind" in metadata)
        if not columns.points:
            raise source.error(
                f"expected columns such as NAME_x, NAME_y, NAME_z, found {', '.join(header[:6])}.",
                remedy="Name the columns of the table so.",
            )
        needed = {*columns.wanted, *([] if columns.frame is None else [columns.frame])}
        values = np.full((table.num_rows, len(header)), np.nan)
        for k in needed:
            values[:, k] = _numbers(source, header[k], table.column(k), arrow)
    return read_columns(source, header, columns, values, metadata)


def write(recording: Motion | Trajectories, *, unit: str | float | None = None) -> bytes:
    """Make the bytes of a Parquet file; parameters as in :func:`leitmotion.io.table_writing.as_sheet`.

    Returns
    -------
    bytes
        One column of doubles each, NaN where a point is unseen.
    """
    arrow, parquet = _arrow()
    sheet = as_sheet(recording, unit)
    columns = [arrow.array(np.ascontiguousarray(column)) for column in sheet.values.T]
    schema = arrow.schema([(name, arrow.float64()) for name in sheet.header], metadata=sheet.stated)
    out = io.BytesIO()
    parquet.write_table(arrow.table(columns, schema=schema), out, compression="zstd")
    return out.getvalue()


def _numbers(source: Source, name: str, column: Any, arrow: Any) -> np.ndarray:
    if arrow.types.is_timestamp(column.type):
        column = column.cast(arrow.timestamp("us")).cast(arrow.int64())
        return np.asarray(column.to_numpy(), dtype=np.float64) / 1e6
    try:
        return np.asarray(column.cast(arrow.float64()).to_numpy(), dtype=np.float64)
    except arrow.ArrowException:
        raise source.error(f"expected numbers in the column {name!r}, found {column.type}.") from None


def _arrow() -> tuple[Any, Any]:
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        raise DataError(
            "Parquet needs the library pyarrow, which is not installed.",
            remedy='Install it: pip install "leitmotion[archive]".',
        ) from None
    return pyarrow, pyarrow.parquet
