"""An independent reading of BVH: scipy Rotations chained joint by joint, one frame at a time."""

from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation


def joint_positions(bvh: Path, frames: list[int]) -> dict[str, np.ndarray]:
    """Place each joint in the world, in the file's unit and axes; (len(frames), 3) a joint."""
    words = bvh.read_text().split()
    motion = words.index("MOTION")
    joints = _joints(words[:motion])
    first = words.index("Time:", motion) + 2
    width = sum(len(channels) for _, _, _, channels in joints)
    out: dict[str, list[np.ndarray]] = {}
    for frame in frames:
        row = iter([float(w) for w in words[first + frame * width : first + (frame + 1) * width]])
        placed: list[tuple[np.ndarray, Rotation]] = []
        for name, parent, offset, channels in joints:
            local, turn = np.array(offset), Rotation.identity()
            for channel in channels:
                value = next(row)
                if channel.endswith("position"):
                    local["XYZ".index(channel[0])] = value
                else:
                    turn = turn * Rotation.from_euler(channel[0].lower(), value, degrees=True)
            if parent >= 0:
                place, above = placed[parent]
                local, turn = place + above.apply(local), above * turn
            placed.append((local, turn))
            out.setdefault(name, []).append(local)
    return {name: np.array(places) for name, places in out.items()}


def _joints(words: list[str]) -> list[tuple[str, int, list[float], list[str]]]:
    joints: list = []
    stack: list[int] = []
    k = 0
    while k < len(words):
        if words[k] in ("ROOT", "JOINT"):
            joints.append([words[k + 1], stack[-1] if stack else -1, [], []])
            stack.append(len(joints) - 1)
            k += 3
        elif words[k] == "End":
            stack.append(-1)
            k += 3
        elif words[k] == "OFFSET":
            if stack[-1] >= 0:
                joints[stack[-1]][2] = [float(w) for w in words[k + 1 : k + 4]]
            k += 4
        elif words[k] == "CHANNELS":
            count = int(words[k + 1])
            joints[stack[-1]][3] = words[k + 2 : k + 2 + count]
            k += 2 + count
        else:
            if words[k] == "}":
                stack.pop()
            k += 1
    return [tuple(joint) for joint in joints]
