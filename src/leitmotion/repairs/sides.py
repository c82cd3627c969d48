"""Left and right: the names of the two sides exchanged, of a whole recording or of some frames.

A recording whose sides are named wrongly is mended by exchanging names; nothing is mirrored, every point stays where
it is. Of the two, a skeleton exchanges the names of its joints, points exchange their places under the names.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from leitmotion.body import BodyMap, map_of, mirror_role
from leitmotion.body.names import PointName, parse_names
from leitmotion.motion import Motion, ParameterError
from leitmotion.repairs.repaired import Change, Recording, Repaired, listed, need_recording

OTHER = {"left": "right", "right": "left"}


def mirror_partners(
    recording: Recording, body_map: BodyMap | Mapping[str, str | Sequence[str]] | None = None
) -> dict[str, str]:
    """Tell which joint or point is the same on the other side of the body.

    Parameters
    ----------
    recording : Motion or Trajectories
        Whose names to read.
    body_map : BodyMap or mapping of str, optional
        Which joints or points stand for which role; by default what the names say.

    Returns
    -------
    dict of str to str
        Both ways, of those that have a partner: by their roles where one point makes each of the two, else by their
        names, which must be alike but for the side.

    Examples
    --------
    >>> from leitmotion.motion import Trajectories
    >>> four = [[[0.1, 0.5, 0], [-0.1, 0.5, 0], [0, 1.4, 0], [-0.1, 1.3, 0]]]
    >>> mirror_partners(Trajectories(("LKNE", "RKNE", "C7", "RBAK"), four, rate=100))
    {'LKNE': 'RKNE', 'RKNE': 'LKNE'}
    """
    body_map = map_of(recording, body_map)
    names = recording.skeleton.names if isinstance(recording, Motion) else recording.names
    alone = {
        role: members[0]
        for role, members in zip(body_map.roles, body_map.members, strict=True)
        if len(members) == 1
    }
    partners: dict[str, str] = {}
    for role, name in alone.items():
        other = alone.get(mirror_role(role), name)
        if other != name and name not in partners and other not in partners:
            partners |= {name: other, other: name}
    parsed = parse_names(names)
    bearer = {said: name for said, name in zip(parsed, names, strict=True)}
    for said, name in zip(parsed, names, strict=True):
        across = bearer.get(PointName(OTHER[said.side], said.word)) if said.side else None
        if across is not None and name not in partners and across not in partners:
            partners |= {name: across, across: name}
    return {name: partners[name] for name in names if name in partners}


def swap_left_right(
    recording: Recording,
    *,
    frames: tuple[int, int] | None = None,
    body_map: BodyMap | Mapping[str, str | Sequence[str]] | None = None,
) -> Repaired:
    """Exchange the left and the right side.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames.
    frames : tuple of int, optional
        Where, half-open; everywhere by default. Of points only: the sides of a skeleton are those of its tree.
    body_map : BodyMap or mapping of str, optional
        Which joints or points stand for which role; by default what the names say.

    Returns
    -------
    Repaired
        The recording, with one change "sides"; a remark names points of one side that have no partner, which keep
        their names. Done twice, it is the recording that was.

    Raises
    ------
    ParameterError
        When no point has a partner, the frames are not in the recording, or are of a skeleton.

    Examples
    --------
    >>> from leitmotion.motion import Trajectories
    >>> two = Trajectories(("LANK", "RANK"), [[[0.1, 0, 0], [-0.1, 0, 0]]], rate=100)
    >>> swap_left_right(two).recording.positions[0, 0].tolist()
    [-0.1, 0.0, 0.0]
    """
    recording = need_recording(recording, "Swapping sides")
    partners = mirror_partners(recording, body_map)
    if not partners:
        raise ParameterError(
            f"No joint or point of {recording.name or 'the recording'} has a partner on the other side.",
            remedy="Name the sides in a map file: --map roles.json (body_map= in Python).",
        )
    names = recording.skeleton.names if isinstance(recording, Motion) else recording.names
    lonely = [
        name
        for name, said in zip(names, parse_names(names), strict=True)
        if said.side and name not in partners
    ]
    remarks = (f"Without a partner on the other side, left as it is: {listed(lonely)}.",) if lonely else ()
    start, stop = (0, len(recording)) if frames is None else frames
    if not 0 <= start < stop <= len(recording):
        raise ParameterError(
            f"The frames {start}:{stop} do not lie in the recording, which has {len(recording)} frames."
        )
    pairs = len(partners) // 2
    change = Change("sides", "", start, stop, f"left and right exchanged, {pairs} pairs")
    if isinstance(recording, Motion):
        if frames is not None and (start, stop) != (0, len(recording)):
            raise ParameterError(
                "The sides of a skeleton are those of its tree: they are swapped in all frames or none.",
                remedy="Leave the frames out.",
            )
        crossed = tuple(partners.get(name, name) for name in names)
        swapped = recording.replace(skeleton=recording.skeleton.replace(names=crossed))
        return Repaired(swapped, (change,), remarks)
    order = [names.index(partners.get(name, name)) for name in names]
    positions = recording.positions.copy()
    positions[start:stop] = positions[start:stop, order]
    sure = recording.confidence
    if sure is not None:
        sure = sure.copy()
        sure[start:stop] = sure[start:stop, order]
    return Repaired(recording.replace(positions=positions, confidence=sure), (change,), remarks)
