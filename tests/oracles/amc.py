"""An independent reading of ASF/AMC: scipy Rotations chained bone by bone, one frame at a time."""

from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation


def joint_positions(asf: Path, amc: Path, frames: list[int]) -> dict[str, np.ndarray]:
    """Place the proximal end of each bone in the world, in the file's unit; (len(frames), 3) a bone."""
    bones, children = _skeleton(asf)
    rows = _frames(amc)
    out: dict[str, list[np.ndarray]] = {}
    for frame in frames:
        row = rows[frame]
        tx, ty, tz, rx, ry, rz = row["root"]
        turn = Rotation.from_euler("xyz", [rx, ry, rz], degrees=True)
        stack = [("root", np.array([tx, ty, tz]), turn)]
        while stack:
            name, place, above = stack.pop()
            out.setdefault(name, []).append(place)
            tip = place
            if name != "root":
                tip = place + above.apply(bones[name]["direction"] * bones[name]["length"])
            for child in children.get(name, []):
                bone = bones[child]
                frame_of_bone = Rotation.from_euler("xyz", bone["axis"], degrees=True)
                angles = dict(zip(bone["dof"], row.get(child, [])))
                moved = Rotation.from_euler(
                    "xyz", [angles.get("rx", 0.0), angles.get("ry", 0.0), angles.get("rz", 0.0)], degrees=True
                )
                stack.append((child, tip, above * frame_of_bone * moved * frame_of_bone.inv()))
    return {name: np.array(places) for name, places in out.items()}


def _skeleton(asf: Path) -> tuple[dict, dict]:
    bones: dict = {}
    children: dict = {}
    section = ""
    entry: dict = {}
    for line in asf.read_text(encoding="latin-1").splitlines():
        words = line.split()
        if not words:
            continue
        if words[0].startswith(":"):
            section = words[0]
        elif section == ":bonedata":
            if words[0] == "begin":
                entry = {"dof": []}
            elif words[0] == "name":
                bones[words[1]] = entry
            elif words[0] == "direction":
                entry["direction"] = np.array([float(w) for w in words[1:4]])
            elif words[0] == "length":
                entry["length"] = float(words[1])
            elif words[0] == "axis":
                assert words[4] == "XYZ"
                entry["axis"] = [float(w) for w in words[1:4]]
            elif words[0] == "dof":
                entry["dof"] = words[1:]
        elif section == ":hierarchy" and len(words) > 1:
            children[words[0]] = words[1:]
    return bones, children


def _frames(amc: Path) -> list[dict[str, list[float]]]:
    rows: list[dict[str, list[float]]] = []
    for line in amc.read_text(encoding="latin-1").splitlines():
        words = line.split()
        if not words or words[0][0] in "#:":
            continue
        if len(words) == 1 and words[0].isdigit():
            rows.append({})
        else:
            rows[-1][words[0]] = [float(w) for w in words[1:]]
    return rows
