"""The motion graph: the states that movements pass through, and the paths between them (paper S, 3.2 to 3.6).

Conventions
-----------
A *state* is a posture at which the body turns back, keeps still, or ways of moving part or meet. A *path* is one way
from a state to a state. The mirror image of state A is A*, of path ab (ab)*. A bar stands over what is symmetric, ↔
for a path that was gone both ways, a subscript tells different paths between the same two states apart.

References
----------
Paper S, sections 3.5 (notation), 3.6.2 (racemization, several paths) and figures 64 to 71.
"""

from __future__ import annotations

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, noun


@noun
class Visit(Noun):
    """One time that a state was held or passed, or a path was gone.

    Parameters
    ----------
    recording : int
        Which of the recordings.
    start, stop : int
        Frames ``[start, stop)``.
    reversed : bool
        Of a path: it was gone from its target to its source.
    """

    recording: int
    start: int
    stop: int
    reversed: bool = False


@noun
class State(Noun):
    """A node of the graph.

    Parameters
    ----------
    name : str
        A capital letter, with a star behind the mirror image of an asymmetric state: "A", "A*"; symmetric ones are
        named from the end of the alphabet, "X", "Y", "T".
    symmetric : bool
        Whether it is its own mirror image.
    visits : tuple of Visit
        In order; none of a state that only reflection made.
    mirror : str
        Name of its mirror image; its own when symmetric; empty when the graph does not hold it.
    """

    name: str
    symmetric: bool
    visits: tuple[Visit, ...]
    mirror: str = ""


@noun
class Path(Noun):
    """An edge of the graph.

    Parameters
    ----------
    name : str
        Its ends in small letters and its subscript, with a star outside brackets for a mirror image: "ab", "(aa*)*",
        "xy2".
    source, target : str
        Names of the states that it joins.
    symmetric : bool
        Whether all its postures are their own mirror image.
    reversible : bool
        Whether it was gone both ways.
    visits : tuple of Visit
        In order; none of a path that only reflection made.
    mirror : str
        Name of its mirror image; its own when symmetric; empty when the graph does not hold it.
    """

    name: str
    source: str
    target: str
    symmetric: bool
    reversible: bool
    visits: tuple[Visit, ...]
    mirror: str = ""

    @property
    def reflected(self) -> bool:
        """Whether nobody went it: it was made by reflection, and is drawn dotted."""
        return not self.visits


@noun
class MotionGraph(Noun):
    """States and paths of one recording or several.

    Parameters
    ----------
    states : tuple of State
        In the order of their first visits.
    paths : tuple of Path
        In the order of their first visits, those made by reflection last.
    recordings : tuple of str
        Names.
    rates : tuple of float
        Frames per second of each.
    confidence : float
        0 to 1: how clearly its states are parted.
    parameters : dict
        How it was made.

    Raises
    ------
    ParameterError
        When a path joins a state that the graph does not hold, or two have one name.
    """

    states: tuple[State, ...]
    paths: tuple[Path, ...]
    recordings: tuple[str, ...]
    rates: tuple[float, ...]
    confidence: float
    parameters: dict[str, object]

    def __post_init__(self) -> None:
        for what in ("states", "paths"):
            names = [item.name for item in getattr(self, what)]
            if len(set(names)) != len(names):
                raise ParameterError(f"MotionGraph.{what} must have different names, got {', '.join(names)}.")
        known = {state.name for state in self.states}
        for path in self.paths:
            missing = {path.source, path.target} - known
            if missing:
                raise ParameterError(
                    f"Path {path.name!r} joins {missing.pop()!r}, which is no state of the graph."
                )
