"""EAF: the annotations of ELAN, tiers of labels on slots of time.

Time slots are whole milliseconds. A slot without a time lies evenly between its neighbours on the tier, as ELAN shows
it; an annotation that refers to another has its span, and several that refer to one share it evenly.

References
----------
.. [1] EAF 3.0, the ELAN annotation format: schema EAFv3.0.xsd. Max Planck Institute for Psycholinguistics, Nijmegen.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from leitmotion.io.markup import Element, parse
from leitmotion.motion import FormatError, ParameterError

_UNITS = {"milliseconds": 1e-3, "ntsc-frames": 1001 / 30000, "pal-frames": 1 / 25}
_ALL = "*"


@dataclass
class _Annotation:
    """One annotation of a tier."""

    own: str
    label: str
    begin: str = ""
    end: str = ""
    parent: str = ""
    previous: str = ""


@dataclass
class _Tier:
    """A tier, its annotations in the file's order."""

    name: str
    annotations: list[_Annotation] = field(default_factory=list)


def read_eaf(content: bytes, path: Path, tier: str | None = None) -> list[tuple[float, float, str]]:
    """Read the annotations of a tier.

    Parameters
    ----------
    content : bytes
        The file.
    path : Path
        What it is called, for errors.
    tier : str, optional
        Which tier, or "*" for all; not needed where one holds annotations only, or where they are one that was written
        here.

    Returns
    -------
    list of tuple
        Start and stop in seconds and the label of each, in the order of time.

    Raises
    ------
    FormatError
        When it is no EAF.
    ParameterError
        When there are several tiers and `tier` is none of them.
    """
    root = parse(content, path)
    if root.tag != "ANNOTATION_DOCUMENT":
        raise FormatError(f"{path.name}: expected an EAF of ELAN, found XML of {root.tag!r:.60}.")
    tiers = [_tier(element, path) for element in root.all("TIER")]
    chosen = _choose([one for one in tiers if one.annotations], [one.name for one in tiers], tier, path)
    slots, order = _slots(root, path)
    spans: dict[str, tuple[float, float]] = {}
    for one in tiers:
        _align(one, slots, order, spans, path)
    _refer(tiers, spans, path)
    found = [(*spans[a.own], a.label) for one in chosen for a in one.annotations]
    return sorted(found, key=lambda stretch: stretch[:2])


def _tier(element: Element, path: Path) -> _Tier:
    tier = _Tier(element.attributes.get("TIER_ID", ""))
    for holder in element.all("ANNOTATION"):
        for one in holder.children:
            value = "".join(child.text for child in one.all("ANNOTATION_VALUE"))
            get = one.attributes.get
            tier.annotations.append(
                _Annotation(get("ANNOTATION_ID", ""), value, get("TIME_SLOT_REF1", ""), get("TIME_SLOT_REF2", ""),
                            get("ANNOTATION_REF", ""), get("PREVIOUS_ANNOTATION", ""))
            )  # fmt: skip
            if not tier.annotations[-1].own:
                raise FormatError(f"{path.name}: expected an ANNOTATION_ID of each annotation, found none.")
    return tier


def _choose(tiers: list[_Tier], names: list[str], wanted: str | None, path: Path) -> list[_Tier]:
    if wanted == _ALL:
        return tiers
    if wanted is not None:
        if wanted not in names:
            raise ParameterError(
                f"{path.name} has no tier {wanted!r}; it has {', '.join(map(repr, names)) or 'none'}."
            )
        return [tier for tier in tiers if tier.name == wanted]
    held = [tier.name for tier in tiers]
    if len(held) > 1 and held != [held[0], *(f"{held[0]} {k}" for k in range(2, len(held) + 1))]:
        raise ParameterError(
            f"{path.name} holds several tiers, {', '.join(map(repr, held))}: "
            "choose one with tier= (--tier NAME), or all with '*'."
        )
    return tiers


def _slots(root: Element, path: Path) -> tuple[dict[str, float | None], dict[str, int]]:
    """Seconds of each time slot, None where it has none, and its place in the order of time."""
    header = next(iter(root.all("HEADER")), None)
    word = (header.attributes.get("TIME_UNITS", "milliseconds") if header else "milliseconds").lower()
    if word not in _UNITS:
        raise FormatError(f"{path.name}: expected times in milliseconds, found {word[:40]!r}.")
    slots: dict[str, float | None] = {}
    for holder in root.all("TIME_ORDER"):
        for slot in holder.all("TIME_SLOT"):
            value = slot.attributes.get("TIME_VALUE")
            if value is not None and not re.fullmatch(r"\d{1,15}", value.strip()):
                raise FormatError(
                    f"{path.name}: expected a whole number as TIME_VALUE, found {value[:40]!r}."
                )
            name = slot.attributes.get("TIME_SLOT_ID", "")
            slots[name] = None if value is None else int(value) * _UNITS[word]
    return slots, {name: k for k, name in enumerate(slots)}


def _align(
    tier: _Tier,
    slots: dict[str, float | None],
    order: dict[str, int],
    spans: dict[str, tuple[float, float]],
    path: Path,
) -> None:
    """Place the annotations that stand on time slots."""
    own = [annotation for annotation in tier.annotations if not annotation.parent]
    used = {slot for annotation in own for slot in (annotation.begin, annotation.end)}
    lost = next((slot for slot in used if slot not in order), None)
    if lost is not None:
        raise FormatError(
            f"{path.name}: expected the time slots of tier {tier.name!r} in TIME_ORDER, found no {lost[:40]!r}."
        )
    times = _interpolate(sorted(used, key=order.__getitem__), slots, order)
    for annotation in own:
        start, stop = times[annotation.begin], times[annotation.end]
        if stop < start:
            raise FormatError(
                f"{path.name}: expected annotations that stop after their start, found {annotation.own!r:.40} "
                f"from {start:g} to {stop:g} s."
            )
        spans[annotation.own] = (start, stop)


def _interpolate(used: list[str], slots: dict[str, float | None], order: dict[str, int]) -> dict[str, float]:
    """Seconds of a tier's slots; those without are spread evenly between the nearest on the tier that have.

    Before the first and after the last of the tier that has one, the nearest on any tier counts.
    """
    if not used:
        return {}
    names, values = list(order), [slots[name] for name in used]
    earlier, later = reversed(names[: order[used[0]]]), names[order[used[-1]] + 1 :]
    before = next((slots[name] for name in earlier if slots[name] is not None), 0.0)
    last = next((value for value in reversed(values) if value is not None), before)
    after = next((slots[name] for name in later if slots[name] is not None), last)
    padded = np.array([before, *values, after], dtype=np.float64)  # None is NaN
    places = np.flatnonzero(np.isfinite(padded))
    times = np.interp(np.arange(len(padded)), places, padded[places])
    return dict(zip(used, times[1:-1].tolist()))


def _refer(tiers: list[_Tier], spans: dict[str, tuple[float, float]], path: Path) -> None:
    """Place the annotations that refer to others, parents first."""
    children: dict[str, dict[int, list[_Annotation]]] = {}
    for k, tier in enumerate(tiers):
        for annotation in tier.annotations:
            if annotation.parent:
                children.setdefault(annotation.parent, {}).setdefault(k, []).append(annotation)
    queue = list(spans)
    for parent in queue:
        start, stop = spans[parent]
        for parts in children.pop(parent, {}).values():
            step = (stop - start) / len(parts)
            for n, annotation in enumerate(_in_turn(parts)):
                spans[annotation.own] = (start + n * step, start + (n + 1) * step)
                queue.append(annotation.own)
    if children:
        lost = next(iter(next(iter(children.values())).values()))[0]
        raise FormatError(
            f"{path.name}: expected the annotation that {lost.own!r:.40} refers to, found no {lost.parent!r:.40}."
        )


def _in_turn(parts: list[_Annotation]) -> list[_Annotation]:
    """Parts of one parent in their order: each names the one before it."""
    after = {part.previous: part for part in parts}
    turn: list[_Annotation] = []
    part = after.get("")
    while part is not None and len(turn) < len(parts):
        turn.append(part)
        part = after.get(part.own)
    return turn if len({part.own for part in turn}) == len(parts) else parts
