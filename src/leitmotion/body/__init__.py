"""What is a human body: joint roles and name maps, sides, mirror partners, facing, size."""

from leitmotion.body.body import Body, BodyMap
from leitmotion.body.roles import ANALYSIS_ROLES, LINKS, ROLES, mirror_role

__all__ = ["ANALYSIS_ROLES", "LINKS", "ROLES", "Body", "BodyMap", "mirror_role"]
