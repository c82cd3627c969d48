"""The colours of static figures: those of the page, light and dark.

Colour means one thing, which pattern; everything else is ink. The letter tells a pattern where the colours end.
"""

from __future__ import annotations

from typing import NamedTuple

from leitmotion.motion.errors import ParameterError


class Theme(NamedTuple):
    """The colours of a figure."""

    surface: str
    ink: str
    ink2: str
    line: str
    left: str
    chip: str
    ramp: tuple[str, ...]
    """Distance map, far to near."""
    patterns: tuple[str, ...]


THEMES = {
    "light": Theme(
        "#FFFFFF", "#1B2027", "#555D68", "#E2E0DA", "#2F6FB3", "#FFFFFF",
        ("#F9FAFC", "#B9C0CC", "#7E889A", "#4B5465", "#20252F"),
        ("#4720AB", "#B5590F", "#23798A", "#8A1A4F", "#1F4A05", "#8F54DC", "#73501F", "#1B5978"),
    ),
    "dark": Theme(
        "#15191F", "#ECEAE4", "#A9B0BA", "#272D35", "#74B4F0", "#0E1115",
        ("#101418", "#38434D", "#697886", "#A4B1BD", "#E6ECF2"),
        ("#5A90F5", "#DFA635", "#51EFCC", "#E0608F", "#ECEE55", "#BFB1FF", "#A97E2C", "#6BBBB6"),
    ),
}  # fmt: skip


def theme_named(name: str) -> Theme:
    """Look up a theme.

    Parameters
    ----------
    name : {"light", "dark"}
        Which.

    Returns
    -------
    Theme
        Its colours.

    Raises
    ------
    ParameterError
        When there is none of that name.
    """
    if name not in THEMES:
        raise ParameterError(f"theme must be one of {', '.join(THEMES)}, got {name!r}.")
    return THEMES[name]


def colour_of(name: str, colours: Theme) -> str:
    """Choose a pattern's colour by its letter.

    Parameters
    ----------
    name : str
        The pattern's letter.
    colours : Theme
        Of which theme.

    Returns
    -------
    str
        One of the eight pattern colours; ink past the eighth, where the letter alone tells the pattern.
    """
    place = ord(name[0]) - ord("A") if len(name) == 1 else len(colours.patterns)
    return colours.patterns[place] if 0 <= place < len(colours.patterns) else colours.ink2


def mixed(colour: str, share: float, surface: str) -> tuple[float, ...]:
    """Mix a colour into the surface.

    Parameters
    ----------
    colour, surface : str
        As hexadecimal codes.
    share : float
        Of the colour, 0 to 1.

    Returns
    -------
    tuple of float
        Red, green and blue, 0 to 1.
    """
    from matplotlib.colors import to_rgb

    return tuple(share * a + (1 - share) * b for a, b in zip(to_rgb(colour), to_rgb(surface), strict=True))
