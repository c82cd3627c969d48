"""How the data of a C3D lie in the file: where they begin, how wide a frame is, how many there are.

A C3D says most of this twice, in its first block and in its parameters, and some programs write only one of them right.
Where the two differ, the length of the file tells which is true; where it tells nothing, the first block is believed.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np

from leitmotion.io.c3d_parameters import BLOCK, Header
from leitmotion.io.reading import Source

_FULL = 65535  # the largest frame number that the first block holds
_WRAP = _FULL + 1
_SAME = 1e-4  # how far, relatively, two numbers may differ that mean the same


@dataclass(frozen=True)
class Layout:
    """Where the numbers of a C3D stand."""

    points: int
    analog: int
    """Numbers of analog channels in a frame."""

    size: int
    """Bytes of a number: 2 where whole numbers are stored, 4 where floats are."""

    scale: float
    """What a whole number is multiplied by."""

    start: int
    """The byte at which the first frame begins."""

    frames: int

    @property
    def width(self) -> int:
        """Numbers in a frame: three coordinates and a residual a point, and the analog channels."""
        return 4 * self.points + self.analog


def find_layout(source: Source, header: Header, warnings: list[str]) -> Layout:
    """Tell how the data lie in the file.

    Parameters
    ----------
    source : Source
        The file.
    header : Header
        Its first block and parameters.
    warnings : list of str
        Gains a sentence for each thing that the file says twice and differently, and where it ends too early.

    Returns
    -------
    Layout
        With at least one point and one whole frame.

    Raises
    ------
    FormatError
        When it holds no points, or no whole frame of them.
    """
    points = _claims({"the first block": header.points, "POINT:USED": header.count("POINT", "USED")}, 1)
    if not points:
        raise source.error("expected points, found analog channels only.")
    analog = _claims({"the first block": header.analog, "ANALOG:USED": _analog_of_parameters(header)}, 0)
    blocks = _blocks(source, header)
    scales = {"the first block": header.scale, "POINT:SCALE": header.number("POINT", "SCALE")}
    stated = {where: scale for where, scale in scales.items() if scale and np.isfinite(scale)}
    sizes = {where: 2 if scale > 0 else 4 for where, scale in stated.items()} or {"none": 4, "neither": 2}
    counts = _counts(header)

    sure, best = 3, (0, 0, 0, 0, 0)
    ways = (dict.fromkeys(said.values()) for said in (sizes, blocks, points, analog))
    for size, block, wide, narrow in product(*ways):
        start, stride = (block - 1) * BLOCK, (4 * wide + narrow) * size
        doubt, frames = _frames_that_fit(source, counts, start, stride)
        if doubt < sure:
            sure, best = doubt, (size, block, wide, narrow, frames)
    size, block, wide, narrow, frames = best
    start, stride = (block - 1) * BLOCK, (4 * wide + narrow) * size
    fits = sure < 2
    if not fits:
        frames = _frames_by_header(source, header, counts, start, stride, warnings)
    _tell("number of points", points, wide, fits, warnings)
    _tell("first block of data", blocks, block, fits, warnings)
    _tell("way of storing numbers (bytes of one)", sizes if stated else {}, size, fits, warnings)
    if narrow != header.analog:
        _tell("analog numbers in a frame", analog, narrow, fits, warnings)
    _tell_counts(header, counts, frames, warnings)
    return Layout(wide, narrow, size, _scale(stated, size, warnings), start, frames)


def _claims(said: dict[str, int | None], least: int) -> dict[str, int]:
    return {where: number for where, number in said.items() if number is not None and number >= least}


def _analog_of_parameters(header: Header) -> int | None:
    """Analog numbers in a frame: the channels, each sampled as often as the rates or the first block say."""
    used = header.count("ANALOG", "USED")
    rates = header.number("ANALOG", "RATE"), header.number("POINT", "RATE")
    if used is None:
        return None
    often = round(rates[0] / rates[1]) if rates[0] and rates[1] else header.samples
    return used * max(often, 1)


def _blocks(source: Source, header: Header) -> dict[str, int]:
    """In which block the data begin; the end of the parameters counts only where no such block is in the file."""
    last = -(-len(source.content) // BLOCK)
    said = {"the first block": header.data_block, "POINT:DATA_START": header.count("POINT", "DATA_START")}
    blocks = {where: block for where, block in _claims(said, 2).items() if block <= last}
    if blocks:
        return blocks
    if 2 < header.parameters_end <= last:
        return {"the end of the parameters": header.parameters_end}
    raise source.error(
        f"expected its data after the parameters, found them said to be in block {header.data_block} of {last}."
    )


def _counts(header: Header) -> dict[str, int]:
    """How many frames there are, by each place that says so; the first block first."""
    counts: dict[str, int | None] = {"the first block": header.last - header.first + 1}
    counts["POINT:LONG_FRAMES"] = _wide(header, "POINT", "LONG_FRAMES")
    end = _wide(header, "TRIAL", "ACTUAL_END_FIELD")
    if end is not None:
        first = _wide(header, "TRIAL", "ACTUAL_START_FIELD")
        counts["TRIAL:ACTUAL_END_FIELD"] = end - (header.first if first is None else first) + 1
    counts["POINT:FRAMES"] = header.count("POINT", "FRAMES")
    return _claims(counts, 1)


def _wide(header: Header, group: str, name: str) -> int | None:
    """A number of frames in two 16-bit words, or in one number of another kind."""
    words = header.parameters.get((group, name))
    if not isinstance(words, np.ndarray) or words.size < 2 or words.dtype.kind != "i":
        return header.count(group, name)
    low, high = (int(word) & _FULL for word in words[:2])
    return low + (high << 16)


def _frames_that_fit(source: Source, counts: dict[str, int], start: int, stride: int) -> tuple[int, int]:
    """The count, as it is or wrapped at 16 bits, with which the data end in the last block of the file.

    Before it stands the doubt that is left: 0 where nothing but zeros follows the data, 1 where a part of a block does,
    2 where no count fits.
    """
    room = len(source.content) - start
    best = (2, 0)
    for count in counts.values():
        low = count % _WRAP
        for frames in (count, low + _WRAP * max(0, (room // stride - low) // _WRAP)):
            rest = room - frames * stride
            if frames > 0 and 0 <= rest < BLOCK:
                doubt = int(any(source.content[len(source.content) - rest :]))
                best = (doubt, frames) if doubt < best[0] else best
    return best


def _frames_by_header(
    source: Source, header: Header, counts: dict[str, int], start: int, stride: int, warnings: list[str]
) -> int:
    """The count of frames where no count ends with the file: it was cut short, or counts no further, or goes on."""
    room = len(source.content) - start
    fit = room // stride
    full = header.last >= _FULL or counts.get("POINT:FRAMES") == _FULL
    promised = max(counts.values(), default=0) if full else next(iter(counts.values()), 0)
    if fit < 1:
        raise source.error("expected at least one whole frame, found the end of the file: it was cut short.")
    if promised > fit or promised < 1:
        warnings.append(f"The header promises {promised} frames, the file holds {fit}; {fit} were read.")
        return fit
    if full and promised <= _FULL:
        # nothing in the file counts further, but its data go on; what pads the last block are no frames
        data = source.content[start + max(0, room - BLOCK - stride) :]
        return fit - min(fit - 1, (len(data) - len(data.rstrip(b"\0"))) // stride)
    rest = np.frombuffer(source.content, dtype=np.uint8)[start + promised * stride :]
    if promised < fit and rest.any():
        warnings.append(
            f"The header promises {promised} frames, the file would hold {fit}; {promised} were read."
        )
    return promised


def _scale(stated: dict[str, float], size: int, warnings: list[str]) -> float:
    """What whole numbers are multiplied by; the parameter says it with more care than the first block."""
    if size == 4:
        return 1.0
    scales = {where: scale for where, scale in stated.items() if scale > 0}
    if not scales:
        warnings.append("The file states no scale for its whole numbers; they were taken as they are.")
        return 1.0
    scale = float(scales.get("POINT:SCALE") or scales["the first block"])
    if any(abs(other / scale - 1.0) > _SAME for other in scales.values()):
        said = ", ".join(f"{other:.6g} in {where}" for where, other in scales.items())
        warnings.append(f"The scale of the whole numbers is {said}; {scale:.6g} was taken.")
    return scale


def _tell(what: str, claims: dict[str, int], taken: int, fits: bool, warnings: list[str]) -> None:
    if len(set(claims.values())) > 1:
        said = ", ".join(f"{number} in {where}" for where, number in claims.items())
        why = ", with which the data end where the file ends" if fits else ""
        warnings.append(f"The {what} is {said}; {taken} was taken{why}.")


def _tell_counts(header: Header, counts: dict[str, int], frames: int, warnings: list[str]) -> None:
    """Say where else other counts stand, but for those that 16 bits cannot hold and a warning that told already."""
    others = {where: count for where, count in counts.items() if count % _WRAP not in (frames % _WRAP, _FULL)}
    full = header.last >= _FULL and frames > _FULL - header.first
    if others and not full and frames in counts.values():
        said = ", ".join(f"{where} {count}" for where, count in others.items())
        warnings.append(f"The counts of frames disagree: {frames} were read, but {said} is stated as well.")
