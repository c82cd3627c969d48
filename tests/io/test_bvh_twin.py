"""Every BVH of the recordings as bvhio reads it: joint by joint, in the file's unit and axes, in single precision."""

from pathlib import Path

import bvhio
import numpy as np
import pytest

from leitmotion import io
from leitmotion.motion import forward_kinematics

FRAMES = 12


def cut(path: Path, folder: Path) -> Path:
    """Frames spread over the whole recording, as a file of its own: the twin takes seconds for a long one."""
    lines = path.read_bytes().splitlines()
    first = next(k for k, line in enumerate(lines) if line.lower().startswith(b"frame time")) + 1
    rows = [line for line in lines[first:] if line.strip()]
    kept = [rows[k] for k in np.linspace(0, len(rows) - 1, FRAMES).astype(int)]
    lines[first - 2] = b"Frames: %d" % FRAMES
    short = folder / path.name
    short.write_bytes(b"\n".join([*lines[:first], *kept, b""]))
    return short


@pytest.mark.data
def test_every_recording_is_placed_as_its_twin_places_it(data, tmp_path):
    paths = sorted(data.rglob("*.bvh"))
    assert len(paths) > 50
    for path in paths:
        short = cut(path, tmp_path)
        ours = io.read(short, unit="m", up="y")
        positions = forward_kinematics(ours).positions
        twin = bvhio.readAsHierarchy(str(short))
        for frame in range(FRAMES):
            twin.loadPose(frame)
            places = np.array([[*joint.PositionWorld] for joint, _, _ in twin.layout()])
            names = [joint.Name for joint, _, _ in twin.layout()]
            order = [names.index(name) for name in ours.skeleton.names]
            far = np.abs(positions[frame]).max()
            np.testing.assert_allclose(places[order], positions[frame], atol=1e-5 * far, err_msg=path.name)
