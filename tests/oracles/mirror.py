"""The double metric, link by link and pair by pair, in double precision."""

import numpy as np


def double_metric(chain, weights, angle: bool):
    """D and D* of a chain without gaps."""
    q = chain.values.reshape(len(chain), -1, 4)
    names = chain.names
    partner = [names.index(swapped(name)) for name in names]
    image = q[:, partner] * [1, 1, -1, -1]
    own, mirror = np.zeros((2, len(q), len(q)))
    for i in range(len(q)):
        for j in range(len(q)):
            for k, weight in enumerate(weights):
                own[i, j] += weight * apart(q[i, k], q[j, k], angle)
                mirror[i, j] += weight * apart(q[i, k], image[j, k], angle)
    return own / sum(weights), mirror / sum(weights)


def apart(q, r, angle: bool) -> float:
    cosine = min(1.0, abs(float(np.dot(q, r))))
    return 2 * np.arccos(cosine) if angle else 1 - cosine


def swapped(name: str) -> str:
    for one, other in (("left_", "right_"), ("right_", "left_")):
        if name.startswith(one):
            return other + name[len(one) :]
    return name
