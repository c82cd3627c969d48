"""The one recording that an input holds, read as the options say."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from leitmotion.cli.documents import Document, reading_parameters, source_entry
from leitmotion.cli.inputs import Input
from leitmotion.cli.options import Options
from leitmotion.cli.progress import Progress

if TYPE_CHECKING:
    from leitmotion.api import Body, BodyMap, Motion, Trajectories
    from leitmotion.io import Reading


class Opened(NamedTuple):
    """One person's recording, and what the answer says about where it comes from."""

    recording: Motion | Trajectories
    body: Body
    source: list[Document]
    first_frame: int = 0
    parameters: Mapping[str, object] = MappingProxyType({})
    warnings: Sequence[str] = ()
    roles: BodyMap | None = None

    def compared_by(self, features: str) -> tuple[Motion | Trajectories | Body, BodyMap | None]:
        """What these features are computed from, and the roles that they need beside it."""
        from leitmotion.api import Body, Trajectories
        from leitmotion.features import FEATURES

        takes = FEATURES[features].takes
        if takes is Body:
            return self.body, None
        return self.recording, None if takes is Trajectories else self.roles


def open_one(given: Input, options: Options, progress: Progress) -> Opened:
    """Read the one person that a verb looks at.

    Parameters
    ----------
    given : Input
        What to read.
    options : Options
        How to read it, and which joints stand for which role.
    progress : Progress
        Told what is being done.

    Returns
    -------
    Opened
        The recording, its body, and its entry in the answer.

    Raises
    ------
    DataError
        When the file holds several people and none was chosen.
    """
    from leitmotion.api import embody, info

    reading = read_one(given, options, progress)
    recording = reading.recordings[0]
    told = info(recording, body_map=options.map_entries(), swap_sides=options.swap_sides)
    return Opened(
        recording=recording,
        body=embody(recording, told.roles),
        source=[source_entry(given, frames=len(recording), rate=recording.rate)],
        first_frame=0 if reading.window is None else reading.window[0],
        parameters=reading_parameters(options.reading, reading.window, swap_sides=options.swap_sides),
        warnings=[*reading.warnings, *told.misread, *unused_skeleton(options, reading.findings)],
        roles=told.roles,
    )


def read_one(given: Input, options: Options, progress: Progress) -> Reading:
    """Read a file of one person, parameters and errors as for :func:`open_one`; tell how it was understood."""
    from leitmotion.io import open_recording
    from leitmotion.motion import DataError

    progress.say(f"Reading {given.path.name}")
    reading = open_recording(given.source, **options.reading)
    if len(reading.recordings) != 1:
        raise DataError(
            f"{given.shown} holds {len(reading.recordings)} people: {', '.join(reading.people)}.",
            remedy="Choose one with --person NAME.",
        )
    return reading


def unused_skeleton(options: Options, findings: Mapping[str, object]) -> list[str]:
    """Say that ``--skeleton`` was given for a file that takes none from elsewhere."""
    if options.skeleton is None or "skeleton" in findings:
        return []
    return ["--skeleton was not used: only an AMC takes its skeleton from another file."]
