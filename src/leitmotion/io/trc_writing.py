"""Writing TRC: points in space, divided by tabs, Y up as OpenSim has it."""

from __future__ import annotations

from leitmotion.io.units import METRES, unit_in_metres
from leitmotion.motion import Motion, ParameterError, Trajectories, joint_points

_KEYS = ("DataRate", "CameraRate", "NumFrames", "NumMarkers", "Units", "OrigDataRate", "OrigDataStartFrame",
         "OrigNumFrames")  # fmt: skip


def write(recording: Motion | Trajectories, *, unit: str = "mm") -> bytes:
    r"""Make the bytes of a TRC.

    Every number is the shortest that reads back as the same; a point unseen is three empty cells. A Motion is written
    as the points of its joints. A TRC has no place for a confidence, a kind and the name of the recording, and a marker
    that lies exactly in the origin is read as unseen.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames of points in space, in metres.
    unit : str
        Name of the unit of length to write, such as "mm" or "m".

    Returns
    -------
    bytes
        UTF-8 text.

    Raises
    ------
    ParameterError
        When the points lie in a plane or have no metres, there is none or no frame, a name holds what divides columns,
        or the unit has no name.

    Examples
    --------
    >>> from leitmotion.motion import Trajectories
    >>> hands = Trajectories(("LFIN", "RFIN"), [[[1, 2, 3], [float("nan")] * 3]], rate=50)
    >>> write(hands, unit="m").decode().splitlines()[-1].split("\t")
    ['1', '0.0', '1.0', '2.0', '3.0', '', '', '']
    """
    points = joint_points(recording) if isinstance(recording, Motion) else recording
    if points.positions.shape[2] != 3:
        raise ParameterError(
            "A TRC holds points in space; these lie in a plane.", remedy="Write them as CSV."
        )
    if points.unit != "m":
        raise ParameterError(
            f"A TRC holds lengths; these points are in {points.unit}.", remedy="Write them as CSV."
        )
    if not points.names or not len(points):
        raise ParameterError("A TRC holds at least one point and one frame, got none.")
    word, metres = unit_in_metres(unit)
    if word not in METRES:
        raise ParameterError(f"A TRC names its unit: expected one of {', '.join(METRES)}, got {unit!r}.")
    for name in points.names:
        if name != name.strip() or not name.isprintable():
            raise ParameterError(
                f"A TRC parts names by tabs and trims blanks: {name!r} would not stay as it is.",
                remedy="Give the point another name, or write CSV.",
            )
    rate, count = repr(float(points.rate)), len(points.names)
    facts = (rate, rate, str(len(points)), str(count), word, rate, "1", str(len(points)))
    head = [
        f"PathFileType\t4\t(X/Y/Z)\t{_plain(points.name) or 'points'}.trc",
        "\t".join(_KEYS),
        "\t".join(facts),
        "Frame#\tTime\t" + "".join(f"{name}\t\t\t" for name in points.names).rstrip("\t"),
        "\t\t" + "\t".join(f"{axis}{k}" for k in range(1, count + 1) for axis in "XYZ"),
        "",
    ]
    positions = (points.positions / metres).reshape(len(points), -1)
    lines = [
        "\t".join([str(k), repr(time), *("" if number != number else repr(number) for number in row)])
        for k, (time, row) in enumerate(zip(points.times.tolist(), positions.tolist()), 1)
    ]
    return ("\n".join(head + lines) + "\n").encode("utf-8")


def _plain(name: str) -> str:
    return "".join(mark if mark.isprintable() else " " for mark in name).strip()
