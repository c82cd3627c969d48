"""What is wrong with a recording, and what mends it.

A remedy takes a recording and gives back a :class:`Repaired`: the recording, every change that was made, and what was
left as it was. Nothing is ever changed that no change names. :func:`repair` takes several remedies in the right order;
:func:`find_problems` only looks.
"""

from leitmotion.repairs.checks import find_problems
from leitmotion.repairs.duplicates import replace_duplicates
from leitmotion.repairs.filtering import choose_cutoff, low_pass
from leitmotion.repairs.floor import Floor, find_floor, level_floor
from leitmotion.repairs.frozen import Frozen, find_frozen, release_frozen
from leitmotion.repairs.gaps import fill_gaps
from leitmotion.repairs.problem import Examined, Problem
from leitmotion.repairs.remedies import repair
from leitmotion.repairs.repaired import Change, Repaired
from leitmotion.repairs.sides import mirror_partners, swap_left_right
from leitmotion.repairs.spikes import Spike, find_spikes, remove_spikes
from leitmotion.repairs.swaps import Exchange, find_exchanges, undo_exchanges

__all__ = [
    "Change",
    "Examined",
    "Exchange",
    "Floor",
    "Frozen",
    "Problem",
    "Repaired",
    "Spike",
    "choose_cutoff",
    "fill_gaps",
    "find_exchanges",
    "find_floor",
    "find_frozen",
    "find_problems",
    "find_spikes",
    "level_floor",
    "low_pass",
    "mirror_partners",
    "release_frozen",
    "remove_spikes",
    "repair",
    "replace_duplicates",
    "swap_left_right",
    "undo_exchanges",
]
