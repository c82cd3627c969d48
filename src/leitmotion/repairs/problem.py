"""A problem: one thing that is wrong with a recording, and what to type to mend it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from leitmotion.body import Body, BodyMap, SideCheck
from leitmotion.repairs.repaired import Recording

_PLAIN = re.compile(r"[\w@%+=:,./-]+", re.ASCII)


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong with a recording, or that should be known about it.

    Parameters
    ----------
    what : str
        Its kind, in one word.
    message : str
        What it is, with its numbers.
    remedy : str
        What the person can do; empty where there is nothing.
    verb : str
        The verb of the command line that does it; empty where none does.
    options : tuple of str
        What is to be said to the verb.
    window : str
        The frames to take, as they stand behind a file's name, such as ``"[1:]"``.

    Examples
    --------
    >>> gap = Problem("gaps", "LKNE has a gap.", "Fill it.", "repair", ("--fill", "rigid"))
    >>> gap.command("walk 1.c3d", "walk 1-repaired.npz")
    "leitmotion repair 'walk 1.c3d' --fill rigid -o 'walk 1-repaired.npz'"
    """

    what: str
    message: str
    remedy: str = ""
    verb: str = ""
    options: tuple[str, ...] = ()
    window: str = ""

    def command(self, file: str = "FILE", output: str = "OUT", *, said: Sequence[str] = ()) -> str:
        """Say what to type.

        Parameters
        ----------
        file : str
            The recording, as typed.
        output : str
            Where a verb that writes is to write.
        said : sequence of str
            What else is to be said, such as how the file is read.

        Returns
        -------
        str
            The command; empty where there is none.
        """
        if not self.verb:
            return ""
        words = ["leitmotion", self.verb, quoted(file + self.window), *map(quoted, said), *self.options]
        return " ".join([*words, "-o", quoted(output)] if self.verb == "repair" else words)


@dataclass(frozen=True)
class Examined:
    """What the checks look at.

    Parameters
    ----------
    recording : Motion or Trajectories
        The recording.
    body : Body
        Its body.
    roles : BodyMap
        Which of its joints or points stand for which role.
    metres : float or None
        The length of the unit that the file was taken to be in; None where that is no length.
    up : str
        The axis of the file that was taken for the vertical.
    sides : SideCheck, optional
        What the body says about its sides; None to have it told.
    """

    recording: Recording
    body: Body
    roles: BodyMap
    metres: float | None = 1.0
    up: str = "y"
    sides: SideCheck | None = None


def quoted(word: str) -> str:
    """Quote what a shell would take apart.

    Parameters
    ----------
    word : str
        A path, with or without a window.

    Returns
    -------
    str
        The same where it is plain, else between single quotes.
    """
    return word if _PLAIN.fullmatch(word) else "'" + word.replace("'", "'\"'\"'") + "'"
