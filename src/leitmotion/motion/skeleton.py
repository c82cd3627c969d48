"""A skeleton: named joints in a tree, with the rest offset of each."""

from __future__ import annotations

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, noun, set_array, set_names


@noun
class Skeleton(Noun):
    """A tree of joints at rest.

    A bone of an ASF file is the joint at its proximal end; its tip is an end site. With all local rotations at
    the identity the skeleton stands in its rest pose, and every joint's frame is parallel to the world's.

    Parameters
    ----------
    names : tuple of str, J
        One name per joint.
    parents : (J,) int
        Index of each joint's parent, -1 for a root; a parent stands before its children.
    offsets : (J, 3) float
        Rest position of each joint in its parent's frame, metres.
    end_parents : (K,) int
        The joint that each end site hangs on.
    end_offsets : (K, 3) float
        Position of each end site in its joint's frame, metres.

    Raises
    ------
    ParameterError
        When shapes disagree, a name is doubled or empty, or a parent stands after its child.

    Examples
    --------
    >>> from leitmotion.motion import Skeleton
    >>> arm = Skeleton(("shoulder", "elbow"), [-1, 0], [[0, 0, 0], [0.3, 0, 0]])
    >>> len(arm), arm.index("elbow")
    (2, 1)
    """

    names: tuple[str, ...]
    parents: np.ndarray
    offsets: np.ndarray
    end_parents: np.ndarray = ()  # type: ignore[assignment]
    end_offsets: np.ndarray = ()  # type: ignore[assignment]

    def __post_init__(self) -> None:
        names = set_names(self, "names")
        count = len(names)
        if count == 0:
            raise ParameterError("Skeleton.names must hold at least one joint, got none.")
        parents = set_array(self, "parents", dtype=np.int64, shape=(count,))
        set_array(self, "offsets", dtype=np.float64, shape=(count, 3))
        ends = np.atleast_1d(np.asarray(self.end_parents)).reshape(-1)
        object.__setattr__(self, "end_parents", ends)
        object.__setattr__(self, "end_offsets", np.asarray(self.end_offsets, dtype=np.float64).reshape(-1, 3))
        set_array(self, "end_parents", dtype=np.int64, shape=(ends.size,))
        set_array(self, "end_offsets", dtype=np.float64, shape=(ends.size, 3))
        late = np.flatnonzero(parents >= np.arange(count))
        if late.size or (parents < -1).any() or parents[0] != -1:
            joint = names[int(late[0])] if late.size else names[0]
            raise ParameterError(
                f"Skeleton.parents must name a joint that stands before its child, joint {joint!r} does not."
            )
        if ends.size and (ends.min() < 0 or ends.max() >= count):
            raise ParameterError(
                f"Skeleton.end_parents must lie in [0, {count}), got {ends.min()} to {ends.max()}."
            )

    def __len__(self) -> int:
        return len(self.names)

    def index(self, name: str) -> int:
        """Return the place of the joint of that name.

        Parameters
        ----------
        name : str
            Name of a joint.

        Returns
        -------
        int
            Its index.

        Raises
        ------
        ParameterError
            When no joint bears it.
        """
        if name not in self.names:
            raise ParameterError(f"The skeleton has no joint {name!r}; it has {', '.join(self.names)}.")
        return self.names.index(name)
