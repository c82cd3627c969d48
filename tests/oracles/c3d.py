"""A plain C3D writer for tests: one parameter block, any of the three processors, whole or float storage."""

import struct

import numpy as np

INTEL, DEC, SGI = 84, 85, 86


def c3d_bytes(
    positions, labels, *, processor=INTEL, scale=-1.0, rate=50.0, residuals=None, analog=0, parameters=None,
    header_frames=None,
):  # fmt: skip
    """Make a C3D of positions (T, P, 3); a positive scale stores 16-bit integers."""
    frames, points = positions.shape[:2]
    order = ">" if processor == SGI else "<"
    residuals = np.zeros((frames, points)) if residuals is None else residuals

    def i2(*numbers):
        return b"".join(struct.pack(f"{order}H", int(number) & 0xFFFF) for number in numbers)

    def f4(number):
        if processor != DEC:
            return struct.pack(f"{order}f", number)
        raw = struct.pack("<f", np.float32(number) * 4)
        return raw[2:] + raw[:2]

    def parameter(group, name, kind, dims, data):
        body = bytes([kind & 0xFF, len(dims), *dims]) + data + b"\0"
        return bytes([len(name), group]) + name.encode() + i2(len(body) + 2) + body

    def text(group, name, words):
        width = max(map(len, words), default=1)
        data = b"".join(word.ljust(width).encode() for word in words)
        return parameter(group, name, -1, (width, len(words)), data)

    entries = bytes([5, 0xFF]) + b"POINT" + i2(3) + b"\0"
    entries += bytes([5, 0xFE]) + b"TRIAL" + i2(3) + b"\0"
    entries += parameter(1, "USED", 2, (), i2(points)) + parameter(1, "SCALE", 4, (), f4(scale))
    entries += parameter(1, "RATE", 4, (), f4(rate))
    given = {"LABELS": labels, "UNITS": ["mm"], "X_SCREEN": ["+X"], "Y_SCREEN": ["+Z"], **(parameters or {})}
    for name, value in given.items():
        group, name = (2, name[6:]) if name.startswith("TRIAL:") else (1, name)
        if value is None:
            continue
        if isinstance(value, list):
            entries += text(group, name, value)
        elif isinstance(value, float):
            entries += parameter(group, name, 4, (), f4(value))
        else:
            entries += parameter(group, name, 2, (len(value),), i2(*value))
    entries += b"\0\0"
    blocks = -(-(4 + len(entries)) // 512)
    section = (bytes([1, 0x50, blocks, processor]) + entries).ljust(512 * blocks, b"\0")
    last = min(header_frames or frames, 65535)
    head = bytes([2, 0x50]) + i2(points, analog, 1, last, 0) + f4(scale) + i2(2 + blocks, 1) + f4(rate)
    data = []
    for frame in range(frames):
        for point in range(points):
            xyz, residual = positions[frame, point], residuals[frame, point]
            if scale > 0:
                data.append(i2(*np.round(np.nan_to_num(xyz) / scale), residual))
            else:
                data.append(b"".join(f4(number) for number in (*np.nan_to_num(xyz), residual)))
        data.append((i2(7) if scale > 0 else f4(7.0)) * analog)
    return head.ljust(512, b"\0") + section + b"".join(data)
