"""Forward kinematics as the textbook has it: 4 x 4 matrices, one frame and one joint at a time."""

import numpy as np
from scipy.spatial.transform import Rotation


def global_pose(parents, local_positions, local_rotations):
    """Global positions (T, J, 3) and rotation matrices (T, J, 3, 3)."""
    frames, joints = local_positions.shape[:2]
    world = np.zeros((frames, joints, 4, 4))
    for t in range(frames):
        for j in range(joints):
            w, x, y, z = local_rotations[t, j]
            local = np.eye(4)
            local[:3, :3] = Rotation.from_quat([x, y, z, w]).as_matrix()
            local[:3, 3] = local_positions[t, j]
            world[t, j] = local if parents[j] < 0 else world[t, parents[j]] @ local
    return world[..., :3, 3], world[..., :3, :3]
