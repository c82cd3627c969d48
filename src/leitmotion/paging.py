"""What the page shows beside the patterns: symmetry, dynamics and motion graph, or why they cannot be told."""

from __future__ import annotations

from leitmotion.body import Body, Dynamics, dynamics
from leitmotion.comparing import Mirrored, compare_with_mirror
from leitmotion.describing import Recording, Roles
from leitmotion.discovery import MotionGraph, Symmetry, racemized
from leitmotion.graphing import motion_graph
from leitmotion.motion import DataError
from leitmotion.symmetry import motifs_in
from leitmotion.view import Mirroring
from leitmotion.view.graph_words import no_graph
from leitmotion.view.symmetry_answer import no_symmetry


def mirroring_of(
    recording: Recording,
    body: Body,
    body_map: Roles | None = None,
    mirrored: Mirrored | None = None,
    found: Symmetry | None = None,
) -> Mirroring | str:
    """Compare a recording with its mirror image, and find its motifs.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person.
    body : Body
        The person.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role.
    mirrored : Mirrored, optional
        What :func:`leitmotion.compare_with_mirror` made of it; by default what it makes by its own defaults.
    found : Symmetry, optional
        The motifs in it, likewise.

    Returns
    -------
    Mirroring or str
        What the page shows, or a sentence that says why there is no symmetry to show.
    """
    try:
        made = mirrored or compare_with_mirror(recording, body_map=body_map)
        return Mirroring(found or motifs_in(made, recording), made.distances)
    except DataError as error:
        return no_symmetry(body, error.message)


def dynamics_of(recording: Recording, body_map: Roles | None = None) -> Dynamics | None:
    """Compute the dynamics of a recording, where they can be told.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role.

    Returns
    -------
    Dynamics or None
        None of a recording without metres, or without the joints of a body.
    """
    try:
        return dynamics(recording, body_map=body_map)
    except DataError:
        return None


def graph_of(
    recording: Recording, body: Body, body_map: Roles | None = None, graph: MotionGraph | None = None
) -> MotionGraph | str:
    """Draw the motion graph of a recording with its mirror images.

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person.
    body : Body
        The person.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role.
    graph : MotionGraph, optional
        What :func:`leitmotion.motion_graph` made of it; by default what it makes by its own defaults.

    Returns
    -------
    MotionGraph or str
        What the page shows, or a sentence that says why there is no graph.
    """
    try:
        return racemized(graph or motion_graph(recording, body_map=body_map))
    except DataError as error:
        return no_graph(body, error.message)
