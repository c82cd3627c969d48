"""All remedies in one call, each in its turn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from leitmotion.body import BodyMap
from leitmotion.motion import DataError, Motion, ParameterError, Trajectories
from leitmotion.repairs.duplicates import replace_duplicates
from leitmotion.repairs.filtering import low_pass
from leitmotion.repairs.floor import level_floor
from leitmotion.repairs.frozen import release_frozen
from leitmotion.repairs.gaps import fill_gaps
from leitmotion.repairs.repaired import Change, Recording, Repaired, need_recording
from leitmotion.repairs.sides import swap_left_right
from leitmotion.repairs.spikes import remove_spikes
from leitmotion.repairs.swaps import undo_exchanges


def repair(
    recording: Recording,
    *,
    swap_sides: bool = False,
    frames: tuple[int, int] | None = None,
    duplicates: bool = False,
    swaps: bool = False,
    frozen: bool = False,
    spikes: bool = False,
    fill: str | None = None,
    max_gap_s: float | None = None,
    filter: float | str | None = None,
    level: bool = False,
    body_map: BodyMap | Mapping[str, str | Sequence[str]] | None = None,
) -> Repaired:
    """Mend a recording by the remedies that are named, and by no other.

    They are taken in the order in which they stand here, whatever the order of the call, because each needs what
    those before it have mended: points that changed places look like spikes, spikes must be gone before a gap is
    filled beside them, a filter must not smear either, and the floor is told by feet that are all this.

    Parameters
    ----------
    recording : Motion or Trajectories
        One person.
    swap_sides : bool
        Exchange left and right (:func:`~leitmotion.repairs.swap_left_right`).
    frames : tuple of int, optional
        Where they are exchanged, half-open; of points only.
    duplicates : bool
        Replace frames that repeat the one before by what lies between
        (:func:`~leitmotion.repairs.replace_duplicates`).
    swaps : bool
        Give points that changed places their names back (:func:`~leitmotion.repairs.undo_exchanges`).
    frozen : bool
        Take points that stand still while the others move for unseen (:func:`~leitmotion.repairs.release_frozen`).
    spikes : bool
        Take spikes out (:func:`~leitmotion.repairs.remove_spikes`): as gaps of points where `fill` is given, else
        replaced by a line.
    fill : {"linear", "spline", "rigid"}, optional
        Fill gaps (:func:`~leitmotion.repairs.fill_gaps`).
    max_gap_s : float, optional
        The longest gap to fill, seconds.
    filter : float or "auto", optional
        Cutoff of a low-pass, hertz (:func:`~leitmotion.repairs.low_pass`).
    level : bool
        Turn the floor level and put it at height 0 (:func:`~leitmotion.repairs.level_floor`).
    body_map : BodyMap or mapping of str, optional
        Which joints or points stand for which role, when the names do not tell; a skeleton's is one of its names
        before its sides are swapped.

    Returns
    -------
    Repaired
        The recording, every change, and what was left. Nothing differs but what the changes name.

    Raises
    ------
    ParameterError
        When an option does not fit: a remedy of points for a skeleton, `frames` without `swap_sides`, `max_gap_s`
        without `fill`.
    DataError
        When a cutoff cannot be told, or the floor cannot and nothing else is asked for; beside other remedies that is
        a remark.

    Examples
    --------
    >>> import numpy as np
    >>> from leitmotion.motion import Trajectories
    >>> from leitmotion.repairs import repair
    >>> path = np.zeros((90, 1, 3))
    >>> path[20], path[40:44] = 0.5, np.nan
    >>> mended = repair(Trajectories(("LFIN",), path, rate=100), spikes=True, fill="linear")
    >>> [change[:4] for change in mended.changes], float(np.abs(mended.recording.positions).max())
    ([('spike', 'LFIN', 20, 21), ('fill', 'LFIN', 20, 21), ('fill', 'LFIN', 40, 44)], 0.0)
    """
    recording = need_recording(recording, "Repairing")
    if frames is not None and not swap_sides:
        raise ParameterError("frames= says where the sides are swapped, but swap_sides is not asked for.")
    if max_gap_s is not None and fill is None:
        raise ParameterError("max_gap_s= says which gaps are filled, but fill= names no method.")
    if isinstance(recording, Motion):
        _refuse_gaps(recording, {"swaps": swaps, "frozen": frozen, "fill": fill})
    changes: list[Change] = []
    remarks: list[str] = []

    def take(mended: Repaired) -> Recording:
        changes.extend(mended.changes)
        remarks.extend(mended.remarks)
        return mended.recording

    if swap_sides:
        recording = take(swap_left_right(recording, frames=frames, body_map=body_map))
    if duplicates:
        recording = take(replace_duplicates(recording))
    if swaps and isinstance(recording, Trajectories):
        recording = take(undo_exchanges(recording))
    if frozen and isinstance(recording, Trajectories):
        recording = take(release_frozen(recording))
    if spikes:
        filled = fill is not None and isinstance(recording, Trajectories)
        recording = take(remove_spikes(recording, leave="gap" if filled else "line"))
    if fill is not None and isinstance(recording, Trajectories):
        recording = take(fill_gaps(recording, method=fill, max_gap_s=max_gap_s))
    if filter is not None:
        recording = take(low_pass(recording, filter))
    if level:
        others = (
            swap_sides or duplicates or swaps or frozen or spikes or fill is not None or filter is not None
        )
        try:
            recording = take(level_floor(recording, body_map=body_map))
        except DataError as error:
            if not others:
                raise
            remarks.append(f"{error.message} What else was asked for was done.")
    return Repaired(recording, tuple(changes), tuple(remarks))


def _refuse_gaps(motion: Motion, asked: Mapping[str, object]) -> None:
    for remedy, wanted in asked.items():
        if wanted:
            raise ParameterError(
                f"{motion.name or 'The recording'} is a skeleton, and {remedy} mends points alone.",
                remedy="A skeleton's joints are always there, and each is its own.",
            )
