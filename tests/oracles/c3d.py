"""A plain C3D writer for tests: any of the three processors, whole or float storage, and every fault one asks for."""

import struct

import numpy as np

INTEL, DEC, SGI = 84, 85, 86


def c3d_bytes(
    positions, labels, *, processor=INTEL, scale=-1.0, rate=50.0, residuals=None, analog=0, parameters=None,
    header=None, header_frames=None, locked=False, order=None, tail=b"", repeat=1,
):  # fmt: skip
    """Make a C3D of positions (T, P, 3); a positive scale stores 16-bit integers.

    `parameters` are by name, ``NAME`` of the group POINT or ``GROUP:NAME``: texts, a float, a tuple of 16-bit integers,
    or None for one that is left out. `header` overrules words of the first block by number (from 0). `order` sorts the
    entries, groups and parameters alike, by their names. `tail` stands after the last entry. The data stand `repeat`
    times one after the other.
    """
    frames, points = positions.shape[:2]
    end = ">" if processor == SGI else "<"
    residuals = np.zeros((frames, points)) if residuals is None else residuals

    def i2(*numbers):
        return b"".join(struct.pack(f"{end}H", int(number) & 0xFFFF) for number in numbers)

    def f4(number):
        if processor != DEC:
            return struct.pack(f"{end}f", number)
        raw = struct.pack("<f", np.float32(number) * 4)
        return raw[2:] + raw[:2]

    def entry(number, name, body):
        name = name.encode()
        length = -len(name) if locked else len(name)
        return bytes([length & 0xFF, number & 0xFF]) + name + i2(len(body) + 2) + body

    def parameter(value):
        if isinstance(value, list):
            words = [word.encode() for word in value]
            width = max(map(len, words), default=1)
            kind, dims, data = -1, (width, len(words)), b"".join(word.ljust(width) for word in words)
        elif isinstance(value, float):
            kind, dims, data = 4, (), f4(value)
        else:
            kind, dims, data = 2, (len(value),), i2(*value)
        return bytes([kind & 0xFF, len(dims), *dims]) + data + b"\0"

    given = {
        "USED": (points,), "SCALE": scale, "RATE": rate, "LABELS": labels, "UNITS": ["mm"], "X_SCREEN": ["+X"],
        "Y_SCREEN": ["+Z"], "ANALOG:USED": (analog,), **(parameters or {}),
    }  # fmt: skip
    given = {name if ":" in name else f"POINT:{name}": value for name, value in given.items()}
    groups = {group: k for k, group in enumerate(dict.fromkeys(name.partition(":")[0] for name in given), 1)}
    entries = {group: entry(-number, group, b"\0") for group, number in groups.items()}
    for name, value in given.items():
        group, _, own = name.partition(":")
        if value is not None:
            entries[name] = entry(groups[group], own, parameter(value))
    section = b"".join(entries[name] for name in (sorted(entries, key=order) if order else entries))
    section += tail + b"\0\0"
    blocks = -(-(4 + len(section)) // 512)
    section = (bytes([1, 0x50, blocks, processor]) + section).ljust(512 * blocks, b"\0")
    last = min(header_frames or frames * repeat, 65535)
    words = {0: None, 1: points, 2: analog, 3: 1, 4: last, 5: 0, 8: 2 + blocks, 9: 1, **(header or {})}
    head = bytes([2, 0x50]) + i2(*(words[k] for k in range(1, 6)))
    head += f4(words.get(6, scale)) + i2(words[8], words[9]) + f4(words.get(10, rate))
    data = []
    for frame in range(frames):
        for point in range(points):
            xyz, residual = positions[frame, point], residuals[frame, point]
            if scale > 0:
                data.append(i2(*np.round(np.nan_to_num(xyz) / scale), residual))
            else:
                data.append(b"".join(f4(number) for number in (*xyz, residual)))
        data.append((i2(7) if scale > 0 else f4(7.0)) * analog)
    return head.ljust(512, b"\0") + section + b"".join(data) * repeat
