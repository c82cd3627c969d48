"""What is a human body: joint roles and name maps, sides, mirror partners, facing, size, masses and dynamics."""

from leitmotion.body.body import Body, BodyMap, swap_sides
from leitmotion.body.chain import BEARER, CHAIN_LINKS, chain_rotations
from leitmotion.body.dynamics import Dynamics, dynamics
from leitmotion.body.embody import embody
from leitmotion.body.flight import Flight
from leitmotion.body.mapfile import map_from, map_of, map_to_entries
from leitmotion.body.mapping import find_roles
from leitmotion.body.rest import Turned, turned_by_file
from leitmotion.body.roles import ANALYSIS_ROLES, LINKS, ROLES, links_between, mirror_role
from leitmotion.body.segments import SEGMENTS
from leitmotion.body.sides import SideCheck, check_sides

__all__ = [
    "ANALYSIS_ROLES",
    "BEARER",
    "CHAIN_LINKS",
    "LINKS",
    "ROLES",
    "SEGMENTS",
    "Body",
    "BodyMap",
    "Dynamics",
    "Flight",
    "SideCheck",
    "Turned",
    "chain_rotations",
    "check_sides",
    "dynamics",
    "embody",
    "find_roles",
    "links_between",
    "map_from",
    "map_of",
    "map_to_entries",
    "mirror_role",
    "swap_sides",
    "turned_by_file",
]
