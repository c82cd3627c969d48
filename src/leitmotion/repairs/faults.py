"""Checks of the data: gaps, repetitions, leaps, what stands still or changes places or length.

Each check takes what is :class:`~leitmotion.repairs.problem.Examined` and returns one problem, or None.
"""

from __future__ import annotations

import numpy as np

from leitmotion.motion import Trajectories
from leitmotion.repairs.duplicates import LONGEST_S, repeated_frames
from leitmotion.repairs.frozen import find_frozen
from leitmotion.repairs.gaps import SPLINE_S
from leitmotion.repairs.problem import Examined, Problem
from leitmotion.repairs.repaired import listed, runs
from leitmotion.repairs.rigid import companions
from leitmotion.repairs.sides import mirror_partners
from leitmotion.repairs.spikes import find_spikes
from leitmotion.repairs.swaps import find_exchanges

FASTEST_POINT_MPS = 40.0  # no hand or foot is faster; a pitcher's hand comes near
FASTEST_BODY_MPS = 13.0  # nor is a whole body: the fastest sprint ever measured is 12.4
DRIFTING = 0.15  # of a bone's length: markers on the skin move it by less
PARTS = 3  # of a recording whose bone lengths are compared: a fault of a moment moves the median of none
FEWEST_FRAMES = 25  # of each part
BONES = (("hip", "knee"), ("knee", "ankle"), ("shoulder", "elbow"), ("elbow", "wrist"))
SURE = 0.8  # roles less sure than this have no bone to speak of


def jumps(seen: Examined) -> Problem | None:
    """Check that nothing moves faster than people do."""
    positions = _positions(seen)
    if seen.body.unit != "m" or len(positions) < 2:
        return None
    rate = seen.recording.rate
    speeds = np.linalg.norm(np.diff(positions, axis=0), axis=2) * rate
    known = np.isfinite(speeds)
    whole = np.where(known, speeds, 0.0).sum(axis=1) / np.maximum(known.sum(axis=1), 1)
    wild = (whole > FASTEST_BODY_MPS) | (np.where(known, speeds, 0.0) > FASTEST_POINT_MPS).any(axis=1)
    if not wild.any():
        return None
    first, count = int(np.argmax(wild)), int(wild.sum())
    if count == 1 and first == 0:
        return Problem(
            "jumps",
            "The first frame is nowhere near the second, as in files that begin with a rest pose.",
            "Take a window that leaves it out: [1:].",
            "info",
            window="[1:]",
        )
    times = f"{count} times, first" if count > 1 else "once,"
    where = f"after frame {first} ({first / rate:.2f} s)"
    return Problem("jumps", f"Points move faster than a person can {times} {where}.")


def spikes(seen: Examined) -> Problem | None:
    """Check that nothing leaps away for a moment and comes back."""
    found = find_spikes(seen.recording)
    if not found:
        return None
    first = min(found, key=lambda spike: spike.start)
    joints = list(dict.fromkeys(spike.joint for spike in found))
    where = f"frame {first.start} ({first.start / seen.recording.rate:.2f} s)"
    return Problem(
        "spikes",
        f"{_times(len(found), 'spike')}: {listed(joints)} {'leaps' if len(joints) == 1 else 'leap'} away and back, "
        f"{'at' if len(found) == 1 else 'first at'} {where}.",
        "Take them out.",
        "repair",
        ("--spikes",),
    )


def unseen(seen: Examined) -> Problem | None:
    """Check that every point is seen all the time."""
    recording = seen.recording
    if not isinstance(recording, Trajectories):
        return None
    gone = np.isnan(recording.positions).any(axis=2)
    if not gone.any():
        return None
    lost = gone.all(axis=0)
    never = [name for name, all_gone in zip(recording.names, lost, strict=True) if all_gone]
    gaps = gone[:, ~lost]
    parts = [f"{listed(never)} {'is' if len(never) == 1 else 'are'} never seen"] if never else []
    if gaps.any():
        stretches = [runs(gaps[:, point]) for point in range(gaps.shape[1])]
        lengths = [max((stop - start for start, stop in held), default=0) for held in stretches]
        worst = np.flatnonzero(~lost)[int(np.argmax(lengths))]
        parts.append(
            f"{np.count_nonzero(lengths)} of {gone.shape[1]} points have gaps, the longest {max(lengths)} frames "
            f"({max(lengths) / recording.rate:.2f} s, {recording.names[worst]})"
        )
        if any(start > 0 and stop < len(gone) for held in stretches for start, stop in held):
            long = max(lengths) > SPLINE_S * recording.rate
            how = "rigid" if long and companions(recording.positions, int(worst)).size >= 3 else "spline"
            return Problem("gaps", "; ".join(parts) + ".", "Fill them.", "repair", ("--fill", how))
    return Problem("gaps", "; ".join(parts) + ".")


def repeated(seen: Examined) -> Problem | None:
    """Check that no frame is the one before again."""
    positions = _positions(seen)
    same = repeated_frames(positions)
    if not same.any():
        return None
    rate = seen.recording.rate
    lengths = [stop - start for start, stop in runs(same)]
    message = (
        f"{int(same.sum())} of {len(positions)} frames repeat the one before exactly; "
        f"the longest such hold is {max(lengths)} frames ({max(lengths) / rate:.2f} s)."
    )
    if min(lengths) > LONGEST_S * rate:
        return Problem("duplicates", message)
    return Problem("duplicates", message, "Replace them by what lies between.", "repair", ("--duplicates",))


def frozen(seen: Examined) -> Problem | None:
    """Check that no point stands still while the others move."""
    if not isinstance(seen.recording, Trajectories):
        return None
    found = find_frozen(seen.recording)
    if not found:
        return None
    longest = max(found, key=lambda one: one.stop - one.start)
    rate = seen.recording.rate
    names = list(dict.fromkeys(one.joint for one in found))
    return Problem(
        "frozen",
        f"{listed(names)} {'stands' if len(names) == 1 else 'stand'} still to the bit while the others move, "
        f"{_times(len(found), 'time')}, at most {(longest.stop - longest.start) / rate:.2f} s "
        f"(from frame {longest.start}).",
        "Take it for a gap and fill it.",
        "repair",
        ("--frozen", "--fill", "rigid" if seen.recording.positions.shape[2] == 3 else "spline"),
    )


def exchanged(seen: Examined) -> Problem | None:
    """Check that no two points change places, be they left and right or any others."""
    if not isinstance(seen.recording, Trajectories):
        return None
    found = find_exchanges(seen.recording)
    if not found:
        return None
    partners = mirror_partners(seen.recording, seen.roles)
    sides = [one for one in found if partners.get(one.first) == one.second]
    pairs = list(dict.fromkeys(f"{one.first} with {one.second}" for one in found))
    first = found[0]
    where = f"frames {first.start} to {first.stop} ({first.start / seen.recording.rate:.2f} s)"
    kind = "left and right, " if len(sides) == len(found) else ""
    return Problem(
        "swapped",
        f"Points change places {_times(len(found), 'time')} ({kind}{listed(pairs)}), "
        f"{'in' if len(found) == 1 else 'first in'} {where}.",
        "Give them their names back.",
        "repair",
        ("--swaps",),
    )


def drifting(seen: Examined) -> Problem | None:
    """Check that the bones of the limbs keep their lengths over the recording."""
    body = seen.body
    if not isinstance(seen.recording, Trajectories) or len(body) < PARTS * FEWEST_FRAMES:
        return None
    if body.positions.shape[2] != 3:  # in a picture a bone that turns towards the camera is short
        return None
    certain = {
        role for role, sure in zip(seen.roles.roles, seen.roles.confidence, strict=True) if sure >= SURE
    }
    worst, told = DRIFTING, ""
    for side in ("left", "right"):
        for above, below in BONES:
            ends = f"{side}_{above}", f"{side}_{below}"
            if not set(ends) <= certain & set(body.roles):
                continue
            upper, lower = (body.positions[:, body.roles.index(end)] for end in ends)
            length = np.linalg.norm(upper - lower, axis=1)
            parts = [part[np.isfinite(part)] for part in np.array_split(length, PARTS)]
            medians = [float(np.median(part)) for part in parts if len(part) >= FEWEST_FRAMES]
            if len(medians) < 2:
                continue
            drift = np.ptp(medians) / np.median(medians)
            if drift > worst:
                worst, told = drift, f"from {ends[0]} to {ends[1]} changes its length by {drift:.0%}"
    if not told:
        return None
    return Problem(
        "drift",
        f"The bone {told} over the recording: a marker has moved on the skin, or the pose was estimated.",
    )


def _positions(seen: Examined) -> np.ndarray:
    """Positions to look for faults in: every point of a file of points, the roles of a skeleton."""
    recording = seen.recording
    return recording.positions if isinstance(recording, Trajectories) else seen.body.positions


def _times(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"
