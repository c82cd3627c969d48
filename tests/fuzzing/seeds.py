"""Small valid files to spoil: one function a format, and cuts of real recordings.

A seed is the files that make one recording, by name, the recording itself first: ``{"s_01.amc": …, "s.asf": …}``. A
format that is written needs no function of its own: its seed is what its writer makes.
"""

import bz2
import gzip
import io as streams
import json
import lzma
import tarfile
import tempfile
import zipfile
from collections.abc import Callable, Iterator
from functools import cache, partial
from pathlib import Path

import numpy as np

from leitmotion.io import bvh, write_annotations
from leitmotion.io.formats import FORMATS, Format
from leitmotion.motion import Motion, Segmentation, Skeleton, Trajectories, rotations
from oracles.c3d import DEC, INTEL, c3d_bytes

Files = dict[str, bytes]

LARGEST = 40_000  # bytes of a cut of a real recording


@cache
def motion() -> Motion:
    """Twelve frames of a body of nine joints."""
    parents = [-1, 0, 1, 2, 1, 0, 5, 0, 7]
    names = ("Hips", "Spine", "Neck", "Head", "LeftArm", "LeftUpLeg", "LeftFoot", "RightUpLeg", "RightFoot")
    offsets = np.array(
        [[0, 0.9, 0], [0, 0.2, 0], [0, 0.3, 0], [0, 0.2, 0], [0.2, 0.2, 0], [0.1, 0, 0], [0, -0.8, 0],
         [-0.1, 0, 0], [0, -0.8, 0]]
    )  # fmt: skip
    skeleton = Skeleton(names, parents, offsets, [3, 6, 8], [[0, 0.1, 0], [0, -0.1, 0.1], [0, -0.1, 0.1]])
    angles = np.random.default_rng(1).normal(0, 20, (12, 9, 3))
    turns = rotations.from_euler("zxy", np.deg2rad(angles))
    return Motion(skeleton, np.tile(offsets, (12, 1, 1)), rotations.continuous(turns), 30.0, "seed")


@cache
def markers() -> Trajectories:
    """Twelve frames of four markers, one of them unseen for a while."""
    places = np.round(np.random.default_rng(2).uniform(-0.3, 0.3, (12, 4, 3)), 4)
    places[:, :, 1] += [1.7, 0.1, 0.1, 0.9]
    places[3:5, 3] = np.nan
    return Trajectories(("HEAD", "LANK", "RANK", "LASI"), places, 50.0, name="seed")


def amc() -> Files:
    """A root and two bones."""
    skeleton = (
        ":version 1.10\n:units\n  mass 1.0\n  length 1.0\n  angle deg\n:root\n  order TX TY TZ RX RY RZ\n  axis XYZ\n"
        "  position 0 0 0\n  orientation 0 0 0\n:bonedata\n  begin\n    id 1\n    name back\n    direction 0 1 0\n"
        "    length 2\n    axis 0 0 20 XYZ\n    dof rx ry\n    limits (-160.0 20.0)\n           (-70.0 70.0)\n  end\n"
        "  begin\n    id 2\n    name head\n    direction 0 1 0\n    length 1\n    axis 0 0 0 XYZ\n    dof rz\n  end\n"
        ":hierarchy\n  begin\n    root back\n    back head\n  end\n"
    )
    rows = [f"{k}\nroot {k} 2 3 0 {k}.5 0\nback 1e1 -{k}\nhead {10 * k}\n" for k in range(1, 9)]
    frames = ":FULLY-SPECIFIED\n:DEGREES\n" + "".join(rows)
    return {"s_01.amc": frames.encode(), "s.asf": skeleton.encode()}


def asf() -> Files:
    """The same, spoiled in the skeleton."""
    return {"s_01.amc": amc()["s_01.amc"], "s.asf": amc()["s.asf"]}


def c3d() -> Files:
    """Four markers as floats."""
    places = np.nan_to_num(markers().positions) * 1000
    return {"clip.c3d": c3d_bytes(places, list(markers().names), processor=INTEL)}


def c3d_whole() -> Files:
    """Four markers as whole numbers of a VAX, and analog channels."""
    places = np.nan_to_num(markers().positions) * 1000
    return {"clip.c3d": c3d_bytes(places, list(markers().names), processor=DEC, scale=0.1, analog=2)}


def trc() -> Files:
    """Two markers."""
    header = (
        "PathFileType\t4\t(X/Y/Z)\tclip.trc\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n"
        "60\t60\t6\t2\tmm\nFrame#\tTime\tHEAD\t\t\tLANK\t\t\n\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n"
    )
    rows = [f"{k + 1}\t{k / 60:.4f}\t{k}\t1700\t5.5\t1e2\t{80 - k}\t-3\n" for k in range(6)]
    return {"clip.trc": (header + "".join(rows)).encode()}


def table() -> Files:
    """Two points, one of them with a confidence."""
    header = "# rate: 30\ntime,HEAD_x,HEAD_y,HEAD_z,LANK_x,LANK_y,LANK_z,LANK_confidence\n"
    rows = [f"{k / 30:.4f},0.1,1.7,{k},0.2,{0.1 * k:.2f},,0.{k}\n" for k in range(9)]
    return {"clip.csv": (header + "".join(rows)).encode()}


def plane() -> Files:
    """Two points in a plane, quoted, parted by semicolons."""
    rows = [f'"{k}";"1,5";{k},25;3;4\n' for k in range(9)]
    return {"clip.csv": ("time;A_x;A_y;B_x;B_y\n" + "".join(rows)).encode()}


def long_table() -> Files:
    """A row a point."""
    rows = [f"{k},{who},{k}.5,1.{k},,0.{k}\n" for k in range(6) for who in ("HEAD", "LANK")]
    return {"clip.csv": ("frame,name,x,y,z,confidence\n" + "".join(rows)).encode()}


def opensim_points() -> Files:
    """Two bodies' places."""
    rows = [f"{k / 50}\t1\t2\t3\t4\t5\t{k}\n" for k in range(6)]
    head = "Positions\nversion=1\nendheader\ntime\ta_X\ta_Y\ta_Z\tb_X\tb_Y\tb_Z\n"
    return {"clip.sto": (head + "".join(rows)).encode()}


def opensim() -> Files:
    """Four coordinates of a body."""
    head = "Coordinates\nversion=1\nnRows=6\nnColumns=5\ninDegrees=yes\nendheader\n"
    rows = [f"{k / 50:.4f}\t{k}\t{2 * k}\t0.9\t-{k}.5\n" for k in range(6)]
    names = "time\tpelvis_tilt\thip_flexion_r\tpelvis_ty\tknee_angle_r\n"
    return {"clip.mot": (head + names + "".join(rows)).encode()}


def qualisys() -> Files:
    """Two markers, one of them unseen in a frame."""
    header = (
        "NO_OF_FRAMES\t3\nNO_OF_CAMERAS\t8\nNO_OF_MARKERS\t2\nFREQUENCY\t50\nDESCRIPTION\t--\n"
        "TIME_STAMP\t2018-04-29, 17:31:02\t20552.5\nDATA_INCLUDED\t3D\nMARKER_NAMES\tHead\tAnkle-L\n"
    )
    return {
        "clip.tsv": (header + "1\t2\t1700\t4\t5\t80\n1.5\t2.5\t1700\t\t\t\n2\t3\t1700\t5\t6\t80\n").encode()
    }


def motive() -> Files:
    """A rigid body and a marker."""
    text = (
        "Format Version,1.23,Take Name,Take 5,Capture Frame Rate,50.000000,Export Frame Rate,50.000000,Rotation Type,"
        "Quaternion,Length Units,Centimeters,Coordinate Space,Global\n\n"
        ",Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Marker,Marker,Marker\n"
        ",Name,Hat,Hat,Hat,Hat,Hat,Hat,Hat,M 1,M 1,M 1\n,ID,1,1,1,1,1,1,1,2,2,2\n"
        ",,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Position,Position,Position\n"
        "Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,X,Y,Z\n"
        "0,0.000000,0,0,0,1,1,2,3,4,5,6\n1,0.020000,0,0,0,1,1.5,2.5,3.5,,,\n2,0.040000,0,0,0,1,2,3,4,5,6,7\n"
    )
    return {"clip.csv": text.encode()}


def nexus() -> Files:
    """Two people of a marker each."""
    text = (
        "Trajectories\n50\n,,Ann:A,,,Bob:B,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n"
        "7,0,1,2,3,4,5,6\n8,0,1.5,2.5,3.5,,,\n9,0,2,3,4,5,6,7\n"
    )
    return {"clip.csv": text.encode()}


def deeplabcut() -> Files:
    """Two points of a picture."""
    text = (
        "scorer,net,net,net,net,net,net\nbodyparts,nose,nose,nose,tail,tail,tail\n"
        "coords,x,y,likelihood,x,y,likelihood\n0,100,200,0.9,300,400,0.8\n1,101,201,0.9,301,401,0.2\n"
    )
    return {"clip.csv": text.encode()}


def labels_csv() -> Files:
    """Frames and seconds."""
    return {
        "labels.csv": b'start,stop,start_s,stop_s,label,score\n0,120,0,1,walk,0.9\n120,300,1,2.5,"a, b",\n'
    }


def labels_json() -> Files:
    """What a search for patterns answers."""
    stretch = {"start": 0, "stop": 120, "start_s": 0.0, "stop_s": 1.0, "label": "A", "score": None}
    return {
        "labels.json": json.dumps({"result": {"patterns": [{"id": "A", "occurrences": [stretch]}]}}).encode()
    }


def labels_aca() -> Files:
    """Two trials of the annotation of CMU subject 86."""
    return {"mocap.txt": b"86 01\nwalk 100 110 120\njump 300 310 320\n\n86 02\nwalk 90 95 99\n"}


def labels_blocks() -> Files:
    """One number a block, and the names beside."""
    return {"13_29.txt": b"1\n1\n2\n2\n1\n", "action_names.csv": b"1,walk\n2,jump\n"}


def labels_eaf() -> Files:
    """What is written for ELAN."""
    spans = Segmentation([0, 120], [120, 300], ("walk", "punch"), rate=120)
    with tempfile.TemporaryDirectory() as folder:
        return {"labels.eaf": write_annotations(spans, Path(folder) / "labels.eaf").read_bytes()}


LABELS: dict[str, Callable[[], Files]] = {
    "labels in CSV": labels_csv,
    "labels in JSON": labels_json,
    "labels of ACA": labels_aca,
    "labels in blocks": labels_blocks,
    "labels of ELAN": labels_eaf,
}
"""Labels instead of recordings."""


def _table_of(columns: int, rows: int, delimiter: str) -> bytes:
    values = np.round(np.random.default_rng(3).normal(0, 1, (rows, columns)), 3)
    return "".join(delimiter.join(map(str, row)) + "\n" for row in values.tolist()).encode()


def kinect() -> Files:
    """Twenty-five joints without names."""
    return {"clip.txt": _table_of(75, 5, " ")}


def uiprmd() -> Files:
    """The two files of a recording of the Kinect."""
    return {"m01_positions.txt": _table_of(66, 5, ","), "m01_angles.txt": _table_of(66, 5, ",")}


def ntu() -> Files:
    """Two frames of a body."""
    joint = "0.1 0.2 3.0 250 200 900 500 0.1 0.2 0.3 0.9 2\n"
    frame = "1\n72057594037931101 0 1 1 1 1 0 0.02 -0.1 2\n25\n" + joint * 25
    return {"clip.skeleton": ("2\n" + frame * 2).encode()}


def _pose(count: int, k: int) -> list[float]:
    return [round(100 + 10 * j + k * 0.5, 2) if c < 2 else 0.9 for j in range(count) for c in range(3)]


def openpose() -> Files:
    """A clip of three frames, a file each, two people."""
    files = {}
    for k in range(3):
        people = [
            {"person_id": [-1], "pose_keypoints_2d": _pose(25, k)},
            {"pose_keypoints_2d": _pose(25, k + 300)},
        ]
        files[f"clip_{k:012}_keypoints.json"] = json.dumps({"version": 1.3, "people": people}).encode()
    return files


def alphapose() -> Files:
    """Three frames in one file."""
    poses = [
        {"image_id": f"{k}.jpg", "category_id": 1, "keypoints": _pose(17, k), "score": 2.5, "idx": 1}
        for k in range(3)
    ]
    return {"clip.json": json.dumps(poses).encode()}


def mediapipe() -> Files:
    """Three frames of thirty-three landmarks."""
    frames = [
        {"frame": k, "landmarks": [{"x": 0.5, "y": j / 40, "z": 0.1, "visibility": 0.9} for j in range(33)]}
        for k in range(3)
    ]
    return {"clip.json": json.dumps({"fps": 30, "frames": frames}).encode()}


def amass() -> Files:
    """Four frames of the rotations of SMPL-H."""
    file = streams.BytesIO()
    rng = np.random.default_rng(4)
    np.savez(
        file, trans=rng.normal(0, 1, (4, 3)), gender=np.array("male"), mocap_framerate=np.array(120.0),
        betas=np.zeros(16), poses=rng.normal(0, 0.3, (4, 156)),
    )  # fmt: skip
    return {"clip.npz": file.getvalue()}


def array() -> Files:
    """Four frames of twenty-two joints."""
    file = streams.BytesIO()
    np.save(file, np.random.default_rng(5).normal(0, 1, (4, 22, 3)))
    return {"clip.npy": file.getvalue()}


def _written(form: Format, recording: Callable[[], Motion | Trajectories]) -> Files:
    return {f"clip{form.extensions[0]}": form.write(recording())}


def _packed() -> Iterator[tuple[str, Callable[[], Files]]]:
    """The containers, each with a BVH, the zip also with an AMC and its skeleton."""
    clip = bvh.write(motion())
    for ending, pack in ((".gz", gzip.compress), (".bz2", bz2.compress), (".xz", lzma.compress)):
        yield f"BVH{ending}", lambda ending=ending, pack=pack: {f"clip.bvh{ending}": pack(clip)}
    yield "BVH.zip", lambda: {"pack.zip": zipped({"inner/clip.bvh": clip})}
    yield "AMC.zip", lambda: {"pack.zip": zipped({f"a/{name}": content for name, content in amc().items()})}
    yield "BVH.tar", lambda: {"pack.tar": taped({"inner/clip.bvh": clip})}
    yield "BVH.tar.gz", lambda: {"pack.tar.gz": gzip.compress(taped({"inner/clip.bvh": clip}))}


def zipped(members: Files, method: int = zipfile.ZIP_DEFLATED) -> bytes:
    """A zip archive of these members."""
    file = streams.BytesIO()
    with zipfile.ZipFile(file, "w", method) as box:
        for name, content in members.items():
            box.writestr(zipfile.ZipInfo(name), content, compress_type=method)
    return file.getvalue()


def taped(members: Files, form: int = tarfile.GNU_FORMAT) -> bytes:
    """A tar archive of these members."""
    file = streams.BytesIO()
    with tarfile.open(fileobj=file, mode="w", format=form) as box:
        for name, content in members.items():
            info = tarfile.TarInfo(name)
            info.size = len(content)
            box.addfile(info, streams.BytesIO(content))
    return file.getvalue()


SEEDS: dict[str, Callable[[], Files]] = {
    "AMC": amc,
    "ASF": asf,
    "C3D": c3d,
    "C3D of whole numbers": c3d_whole,
    "TRC": trc,
    "OpenSim MOT": opensim,
    "OpenSim MOT of points": opensim_points,
    "table of rows a point": long_table,
    "Qualisys TSV": qualisys,
    "UI-PRMD": uiprmd,
    "Kinect table": kinect,
    "Motive CSV": motive,
    "Nexus CSV": nexus,
    "DeepLabCut CSV": deeplabcut,
    "AMASS": amass,
    "NumPy array": array,
    "NTU RGB+D": ntu,
    "poses of OpenPose": openpose,
    "poses of AlphaPose": alphapose,
    "poses of MediaPipe": mediapipe,
    "table": table,
    "table in a plane": plane,
    **dict(_packed()),
}
"""By the name of the format; further ones of a format may have any name that begins with its name."""

for _form in FORMATS:
    for _kind, _recording in (("a skeleton", motion), ("points", markers)):
        if _form.writer and _form.module:
            SEEDS[f"{_form.name} of {_kind}"] = partial(_written, _form, _recording)
del SEEDS["BVH of points"]  # which it does not hold

SPOILED = {"ASF": "s.asf"}
"""Which file of a seed is spoiled, where it is not the first."""


def cuts(data: Path) -> dict[str, Files]:
    """The beginnings of real recordings, one of each ending in a folder, with the skeleton where one is needed."""
    found: dict[str, Files] = {}
    taken: dict[str, int] = {}
    readable = {extension for form in FORMATS if form.module for extension in form.extensions}
    for path in sorted(data.rglob("*")):
        ending = path.suffix.lower()
        kind = f"{path.parent.name}{ending}"
        if ending not in readable or kind in taken:
            continue
        taken[kind] = 1
        content = path.read_bytes()
        if ending not in (".npz", ".json", ".parquet", ".mat", ".h5"):
            content = content[:LARGEST]
        if len(content) > 4 * LARGEST:
            continue
        found[str(path.relative_to(data))] = {path.name.replace(path.stem, "clip"): content}
        if ending == ".amc":
            skeleton = next(
                iter(sorted(path.parent.glob("*.asf")) or sorted(path.parent.parent.glob("*.asf"))), None
            )
            if skeleton is None:
                del found[str(path.relative_to(data))]
            else:
                found[str(path.relative_to(data))]["clip.asf"] = skeleton.read_bytes()
    return found
