"""The archive: loading what was saved is the identity for every noun of the house."""

import contextlib
import dataclasses
import importlib
import io as bytes_io
import json
import pkgutil

import numpy as np
import pytest

import leitmotion
from leitmotion import io
from leitmotion.body import Body, BodyMap, Dynamics, Flight
from leitmotion.datasets import Session
from leitmotion.discovery.lesson import Difference, Lesson, Step, Variation
from leitmotion.discovery.motion_graph import MotionGraph, Path, State, Visit
from leitmotion.discovery.pattern import Pattern, PatternPair, Patterns
from leitmotion.discovery.residual import Candidate, Residual
from leitmotion.discovery.shared import Places, SharedPair, SharedPattern, SharedPatterns
from leitmotion.discovery.symmetry_span import Symmetry, SymmetrySpan
from leitmotion.evaluation import (
    FoundPatterns,
    PatternScores,
    PatternTruth,
    RunCount,
    equal_error_rate,
    errors_at,
)
from leitmotion.evaluation.symmetry import SymmetryLabel, SymmetryScores, SymmetryVerdict
from leitmotion.features.bias import SideBias
from leitmotion.features.sequence import FeatureSequence
from leitmotion.io import archive
from leitmotion.motion import (
    FormatError,
    Motion,
    ParameterError,
    Segmentation,
    Skeleton,
    Trajectories,
    rotations,
)
from leitmotion.motion.noun import Noun
from leitmotion.similarity import Alignment, SimilarityMatrix
from leitmotion.similarity.mirror import DoubleMetric
from leitmotion.synthesis import Summary


def samples():
    rng = np.random.default_rng(0)
    skeleton = Skeleton(("a", "b b", "ü"), [-1, 0, 1], rng.normal(size=(3, 3)), [2], [[0, 0.1, 0]])
    quaternions = rotations.normalize(rng.normal(size=(5, 3, 4)))
    motion = Motion(skeleton, rng.normal(size=(5, 3, 3)), quaternions, 120000 / 1001, "clip:Ann")
    positions = rng.normal(size=(4, 2, 3))
    positions[1, 0] = np.nan
    markers = Trajectories(("L", "R"), positions, 50, confidence=rng.uniform(size=(4, 2)), name="x")
    flat = Trajectories(("L",), rng.normal(size=(4, 1, 2)), 30, "px", "joint", name="y")
    spans = Segmentation([0, 3], [3, 9], ("walk", ""), [0.5, np.nan], 120)
    empty = Segmentation([], [], rate=30)
    pattern = Pattern("A", "cyclic", spans, Segmentation([0], [9], rate=120), 0.03, 0.1, 0.9, "because")
    pair = PatternPair("A", [[0, 3], [1, 4]], 0.1)
    yield from (skeleton, motion, markers, flat, spans, empty, pattern, pair)
    parameters = {"method": "recurrence", "roles": ("pelvis", "head"), "bounds": [1, 2.5, None], "d": {"a": True},
                  "nan": float("nan"), "weights": np.arange(3.0), "inf": float("-inf"), "n": np.int64(3)}  # fmt: skip
    yield Patterns((pattern,), (pair,), 120, parameters, "near")
    yield Patterns((), (), 30, {}, "")
    yield BodyMap(("pelvis", "head"), (("a",), ("b b", "ü")), [1.0, 0.5])
    yield Body(("pelvis", "head"), positions, np.zeros(4), 50, 1.6, name="x")
    yield FeatureSequence(rng.normal(size=(4, 6)), ("pelvis", "head"), 50, ("place",), width=3, scale=1.6)
    values = rng.uniform(size=(4, 4)).astype(np.float32)
    yield SimilarityMatrix(values, "mean_norm", 50.0, 50.0)
    yield Session(motion, spans, empty)
    yield Alignment([[0, 0], [1, 1]], 0.5, 2)
    labelled = [0.1, 0.4, 0.3, 0.5], [True, True, False, False]
    yield errors_at(0.35, *labelled, draws=0)
    yield equal_error_rate(*labelled).replace(check=errors_at(0.35, *labelled))
    yield PatternTruth(spans, [[2, 4]], [[2, 1, 3], [np.nan] * 3], spans)
    yield FoundPatterns(spans, [[0, 3, 3, 9]])
    count = RunCount("walk", 0, 3, 2, 2, 1, 3)
    yield count
    yield PatternScores(3, 1, recurring=("walk",), start_errors_s=(0.1, -0.2), counts=(count,))
    difference = Difference("head", 0.1, 0.4, [0.0, 0.1, 0.0])
    variation = Variation(1, 3, 9, 0.05, 1.2, -0.1, 0.5, (difference,), [[0, 3], [2, 8]])
    step = Step("A", "cyclic", 2, 0.075, 0, 0, 3, (variation,))
    yield from (difference, variation, step, Lesson((step,), 120, 1.6, "px", turned=False))
    yield Summary(motion, spans, spans)
    candidate = Candidate((0, 3), (4, 9), 0.75)
    yield from (candidate, Residual((candidate,), spans, 120, {"window_s": 0.5}))
    places = Places([0, 1], [3, 0], [9, 8], [0.5, np.nan])
    pattern = SharedPattern("A", "acyclic", places, places, 0.2, 0.03, 0.8, "near")
    pair = SharedPair("A", (0, 1), [[3, 0], [8, 7]], 0.02)
    yield from (places, pattern, pair)
    yield SharedPatterns((pattern,), (pair,), ("a", "b"), [30, 60], [12, 10], {"gap_s": 2.0})
    yield SideBias(("left", "right"), rotations.normalize(rng.normal(size=(2, 4))), [0.1, 0.2], "mean", 7)
    yield DoubleMetric(values, values.T, "inner", 30.0, ("left", "right"), [0.5, 0.5], 20.0)
    again = SymmetrySpan(
        "path_repetition", 0, 3, 0.7, partner=(4, 9), reason="near", left_share=0.2, links=("right_tibia",)
    )
    walk = SymmetrySpan("anti_phase", 0, 9, 0.8, cyclic=True, marks=[0, 3, 6, 8])
    yield from (again, Symmetry((again, walk), 30, 9, {"beta": 20.0}, [4]))
    visit = Visit(0, 3, 9, reversed=True)
    state, path = State("A", False, (visit,), "A*"), Path("aa", "A", "A", False, True, (visit,))
    yield from (visit, state, path, MotionGraph((state,), (path,), ("a",), (30.0,), 0.9, {"n": 1}))
    label = SymmetryLabel(0, 9, "alternate", "cycle", ("anti_phase",))
    verdict = SymmetryVerdict(label, "anti_phase", 0.8, 0.9, ("anti_phase",))
    yield from (label, verdict, SymmetryScores((verdict,), 2, 1, 9.0, 3.0, 0.5))
    flight = Flight(1, 3, 9.7, 0.002, [0.1, 0.2, 0.3], 0.05, 0.1)
    yield flight
    yield weighed(rng, flight)


def weighed(rng, flight):
    """Two segments for four frames."""
    wide = {
        "inertias": (2, 3),
        "global_rotations": (4, 2, 4),
        "body_twists": (4, 2, 6),
        "global_twists": (4, 2, 6),
    }
    energies = ("linear_energies", "angular_energies", "potential_energies")
    whole = ("centre_of_mass", "linear_momentum", "angular_momentum")
    shapes = {"masses": (2,), **wide, **dict.fromkeys(energies, (4, 2)), **dict.fromkeys(whole, (4, 3))}
    arrays = {
        field.name: rng.uniform(size=shapes.get(field.name, (4, 2, 3)))
        for field in dataclasses.fields(Dynamics)
        if field.name not in ("segments", "flights", "rate", "name", "parameters")
    }
    return Dynamics(
        segments=("trunk", "head"), flights=(flight,), rate=120, name="x", parameters={"mass": 70.0}, **arrays
    )


SAMPLES = {f"{type(noun).__name__}-{k}": noun for k, noun in enumerate(samples())}


@pytest.mark.parametrize("key", SAMPLES)
def test_loading_what_was_saved_is_the_identity(tmp_path, key):
    noun = SAMPLES[key]
    back = io.load(io.save(noun, tmp_path / "noun.npz"))
    if isinstance(noun, Patterns):  # a dict that holds NaN and arrays is not equal to itself by ==
        mine, theirs = dict(noun.parameters), dict(back.parameters)
        assert list(mine) == list(theirs)
        for name, value in mine.items():
            np.testing.assert_equal(theirs[name], value)
            assert isinstance(value, np.generic) or type(theirs[name]) is type(value)
        noun, back = noun.replace(parameters={}), back.replace(parameters={})
    assert type(back) is type(noun)
    assert back == noun
    for field in dataclasses.fields(noun):
        value = getattr(noun, field.name)
        if isinstance(value, np.ndarray):
            assert getattr(back, field.name).dtype == value.dtype


def nouns_of_the_house():
    """Every noun that any module of the package makes."""
    for info in pkgutil.walk_packages(leitmotion.__path__, "leitmotion."):
        if not info.name.rpartition(".")[2].startswith("_"):
            importlib.import_module(info.name)
    waiting, found = [Noun], set()
    while waiting:
        kinds = [kind for kind in waiting.pop().__subclasses__() if kind.__module__.startswith("leitmotion.")]
        found.update(kinds)
        waiting += kinds
    return found


def test_every_noun_of_the_house_has_a_sample():
    found = nouns_of_the_house()
    assert found >= {Motion, Patterns, Session, SimilarityMatrix}
    missing = sorted(kind.__name__ for kind in found - {type(noun) for noun in SAMPLES.values()})
    assert not missing, f"add a sample of {missing} to this file"


def test_a_recording_is_read_back_with_its_name(tmp_path):
    for noun in (SAMPLES["Motion-1"], SAMPLES["Trajectories-2"], SAMPLES["Trajectories-3"]):
        path = io.write(noun, tmp_path / "other.npz")
        assert io.read(path) == noun
        assert io.open_recording(path).findings["unit"].how == "read"


def test_the_same_noun_makes_the_same_bytes(tmp_path):
    noun = SAMPLES["Motion-1"]
    assert io.save(noun, tmp_path / "a.npz").read_bytes() == io.save(noun, tmp_path / "b.npz").read_bytes()


def test_another_noun_is_no_recording(tmp_path):
    path = io.save(SAMPLES["Segmentation-4"], tmp_path / "spans.npz")
    with pytest.raises(FormatError, match=r"expected a recording, found a Segmentation.*leitmotion\.load"):
        io.read(path)


@pytest.mark.parametrize("value", [{"a": 1}, np.zeros(3), "text", None, object()])
def test_only_nouns_are_saved(tmp_path, value):
    with pytest.raises(ParameterError, match="holds a noun"):
        io.save(value, tmp_path / "x.npz")
    with pytest.raises(ParameterError, match="An archive holds"):
        io.save(SAMPLES["Patterns-9"].replace(parameters={"x": object()}), tmp_path / "x.npz")
    assert not (tmp_path / "x.npz").exists()


def forged(tmp_path, **changes):
    file = bytes_io.BytesIO()
    np.savez(file, header=np.frombuffer(json.dumps(changes).encode(), dtype=np.uint8))
    path = tmp_path / "forged.npz"
    path.write_bytes(file.getvalue())
    return path


@pytest.mark.parametrize(
    ("header", "match"),
    [
        (
            {"leitmotion": 2, "noun": "leitmotion.motion:Motion", "fields": {}},
            "newer Leitmotion: archive version 2",
        ),
        ({"noun": "leitmotion.motion:Motion", "fields": {}}, "version of a Leitmotion archive"),
        ({"leitmotion": 1, "noun": "leitmotion.motion:Nothing", "fields": {}}, "does not know"),
        ({"leitmotion": 1, "noun": "os:system", "fields": {}}, "does not know"),
        ({"leitmotion": 1, "noun": "leitmotion.motion:LeitmotionError", "fields": {}}, "does not know"),
        ({"leitmotion": 1, "noun": "leitmotion.no.such:Motion", "fields": {}}, "does not know"),
        ({"leitmotion": 1, "noun": "leitmotion.motion:Segmentation", "fields": {"start": 1}}, "damaged"),
        (
            {
                "leitmotion": 1,
                "noun": "leitmotion.motion:Segmentation",
                "fields": {"starts": {"array": "a0"}},
            },
            "damaged",
        ),
        ({"leitmotion": 1, "strange": 1}, "damaged: its header holds"),
        (
            {"leitmotion": 1, "noun": "leitmotion.motion:Motion", "fields": [1]},
            "damaged: expected the fields of a Motion",
        ),
        (
            {"leitmotion": 1, "noun": "leitmotion.motion:Motion", "fields": 1},
            "damaged: expected the fields of a Motion",
        ),
        ({"leitmotion": 1, "noun": "leitmotion.motion:Motion"}, "damaged"),
        (
            {
                "leitmotion": 1,
                "noun": "leitmotion.discovery:Pattern",
                "fields": dict.fromkeys(
                    ("id", "occurrences", "stretches", "period_s", "cost", "confidence"), 1
                )
                | {"kind": "cyclic"},
            },
            "damaged",
        ),
        (
            {"leitmotion": 1, "noun": "leitmotion.motion:Segmentation", "fields": {"starts": {"tuple": 1}}},
            "damaged",
        ),
        (
            {"leitmotion": 1, "noun": "leitmotion.motion:Segmentation", "fields": {"starts": {"float": []}}},
            "damaged",
        ),
    ],
)
def test_what_cannot_be_loaded_is_one_sentence(tmp_path, header, match):
    with pytest.raises(FormatError, match=match):
        io.load(forged(tmp_path, **header))


def test_a_header_imports_only_public_modules_of_the_house(tmp_path, monkeypatch):
    """To import ``leitmotion.__main__`` would run the program; a name may not lead out of the package either."""
    asked = []
    monkeypatch.setattr(archive, "import_module", lambda name: asked.append(name))
    for module in (
        "leitmotion.__main__",
        "leitmotion.io._kernels",
        "leitmotion..os",
        "leitmotion.",
        "leitmotionx.a",
        "os",
    ):
        with pytest.raises(FormatError, match="does not know"):
            io.load(forged(tmp_path, leitmotion=1, noun=f"{module}:Motion", fields={}))
    assert asked == []


def test_foreign_and_damaged_files_are_one_sentence(tmp_path, rng):
    content = io.save(SAMPLES["Motion-1"], tmp_path / "good.npz").read_bytes()
    path = tmp_path / "bad.npz"
    np.savez(path, poses=np.zeros((3, 4)))
    with pytest.raises(FormatError, match="without Leitmotion's header: it holds poses"):
        io.load(path)
    (tmp_path / "dance.bvh").write_text("HIERARCHY\n")
    with pytest.raises(
        FormatError, match=r"dance\.bvh is no archive of Leitmotion \(\.npz\).*leitmotion\.read"
    ):
        io.load(tmp_path / "dance.bvh")
    np.savez(path, header=np.array([{"pickle": 1}], dtype=object))
    with pytest.raises(FormatError, match="damaged"):
        io.load(path)
    for cut in rng.integers(1, len(content) - 1, 20):
        path.write_bytes(content[:cut])
        with pytest.raises(FormatError, match=r"bad\.npz"):
            io.load(path)
    for place in rng.integers(0, len(content), 60):
        path.write_bytes(content[:place] + bytes([content[place] ^ 0x5A]) + content[place + 1 :])
        with contextlib.suppress(FormatError):
            io.load(path)


def test_the_version_is_in_the_file(tmp_path):
    path = io.save(SAMPLES["Segmentation-4"], tmp_path / "spans.npz")
    with np.load(path) as box:
        header = json.loads(box["header"].tobytes())
    assert (header["leitmotion"], header["noun"]) == (1, "leitmotion.motion:Segmentation")
    assert leitmotion.__name__ == "leitmotion"


@pytest.mark.parametrize("name", ["q.txt", "q", "q.bvh", "q.npy"])
def test_an_archive_has_its_own_ending(tmp_path, name):
    with pytest.raises(ParameterError, match=rf"ends in \.npz, got '{name}'"):
        io.save(SAMPLES["Segmentation-4"], tmp_path / name)
    assert not (tmp_path / name).exists()
