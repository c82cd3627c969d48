"""The motion graph of one recording or several: features, bias and graph in one call."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.body import mirror_role
from leitmotion.comparing import BIASES
from leitmotion.describing import Recording, Roles, known_weights, only
from leitmotion.discovery import MotionGraph, build_graph, racemized
from leitmotion.features import active_weights, extract, side_bias, without_bias
from leitmotion.motion import DataError, ParameterError


def motion_graph(
    recordings: Recording | Sequence[Recording],
    *,
    names: Sequence[str] | None = None,
    weights: str = "equal",
    bias: str = "none",
    racemize: bool = False,
    body_map: Roles | Sequence[Roles | None] | None = None,
) -> MotionGraph:
    """Draw the motion graph of one recording or several: states, and the paths between them (paper S, 3.5 and 3.6).

    Parameters
    ----------
    recordings : Motion, Trajectories or Body, or a sequence of them
        One person each, in three dimensions. What several have in common is one state or one path.
    names : sequence of str, optional
        What to call them; by default their own names.
    weights : {"equal", "active"}
        Whether each link counts alike, or the more the more it moves; both sides count alike.
    bias : {"none", "auto", "mean", "standing"}
        By which posture the bias of the sides is measured and taken out, of each recording
        (:func:`leitmotion.features.side_bias`). "auto" and "none" leave it to the drawing of the graph, which takes out
        by what constant turns moments differ from the mirror images of others.
    racemize : bool
        Whether to add the mirror images (:func:`leitmotion.discovery.racemized`).
    body_map : BodyMap or mapping of str, or one for each recording, optional
        Which joints or markers stand for which role, when the names do not tell.

    Returns
    -------
    MotionGraph
        Visits in frames of each recording. :func:`leitmotion.discovery.notation` writes it in a line. 30 moments a
        second are compared, fewer of more than two minutes; ``parameters["moments_per_s"]`` tells how many.

    Raises
    ------
    ParameterError
        When an option is unknown, or there is no recording.
    DataError
        When a recording is planar, its trunk or a side is unknown, nobody stands still, or the recordings have no links
        of the body in common.

    Examples
    --------
    >>> import leitmotion as lm
    >>> from leitmotion.discovery import notation
    >>> graph = lm.motion_graph(lm.read("walk.bvh"))                         # doctest: +SKIP
    >>> notation(graph)                                                      # doctest: +SKIP
    'A, A*; aa* →, (aa*)* →'
    """
    if bias not in BIASES:
        raise ParameterError(f"bias must be one of {', '.join(BIASES)}, got {bias!r}.")
    known_weights(weights)
    several = list(recordings) if isinstance(recordings, Sequence) else [recordings]
    if names is not None and len(names) != len(several):
        raise ParameterError(f"Each of the {len(several)} recordings has one name, got {len(names)} names.")
    maps = list(body_map) if isinstance(body_map, Sequence) else [body_map] * len(several)
    if len(maps) != len(several):
        raise ParameterError(f"Each of the {len(several)} recordings has one map, got {len(maps)} maps.")
    chains = [extract("kinematic_chain", one, each) for one, each in zip(several, maps, strict=True)]
    common = (
        tuple(name for name in chains[0].names if all(name in chain.names for chain in chains))
        if chains
        else ()
    )
    if chains and not common:
        raise DataError("The recordings have no links of the body in common.")
    chains = [only(chain, common) for chain in chains]
    if bias not in ("auto", "none"):
        chains = [without_bias(chain, side_bias(chain, pose=bias)) for chain in chains]
    shares = None
    if weights == "active" and chains:
        own = np.mean([active_weights(chain) for chain in chains], axis=0)
        shares = (own + own[[common.index(mirror_role(name)) for name in common]]) / 2
    called = [one.name if hasattr(one, "name") else "" for one in several] if names is None else names
    called = [name or f"recording {k + 1}" for k, name in enumerate(called)]
    found = build_graph(chains, names=called, weights=shares)
    found = found.replace(parameters=found.parameters | {"weights": weights, "bias": bias})
    return racemized(found) if racemize else found
