"""The nouns of the ground floor: checked once, frozen, equal by value, cut along time."""

import numpy as np
import pytest

from leitmotion.motion import (
    DataError,
    FormatError,
    LeitmotionError,
    Motion,
    ParameterError,
    Segmentation,
    Skeleton,
    Trajectories,
)

STILL = np.tile([1.0, 0, 0, 0], (12, 2, 1))


def skeleton(**changes):
    return Skeleton(**{"names": ("a", "b"), "parents": [-1, 0], "offsets": np.eye(3)[:2], **changes})


def motion(**changes):
    places = np.arange(72.0).reshape(12, 2, 3)
    fields = {
        "skeleton": skeleton(),
        "local_positions": places,
        "local_rotations": STILL,
        "rate": 120,
        "name": "m",
    }
    return Motion(**{**fields, **changes})


def markers(**changes):
    places = np.arange(72.0).reshape(12, 2, 3)
    places[3, 1] = np.nan
    return Trajectories(**{"names": ("a", "b"), "positions": places, "rate": 60, **changes})


def spans(**changes):
    return Segmentation(
        **{"starts": [0, 5, 3], "stops": [5, 9, 8], "labels": ("x", "", "x"), "rate": 30, **changes}
    )


NOUNS = [skeleton, motion, markers, spans]


@pytest.mark.parametrize("make", NOUNS)
def test_nouns_are_equal_by_value_and_not_hashed(make):
    assert make() == make()
    assert make() != "another"
    with pytest.raises(TypeError, match="unhashable"):
        hash(make())


@pytest.mark.parametrize(
    ("make", "change"),
    [
        (skeleton, {"names": ("a", "c")}), (skeleton, {"offsets": np.zeros((2, 3))}),
        (skeleton, {"end_parents": [1], "end_offsets": [[0, 1, 0]]}),
        (motion, {"rate": 60}), (motion, {"name": "n"}), (motion, {"local_positions": np.zeros((12, 2, 3))}),
        (markers, {"kind": "joint"}), (markers, {"confidence": np.ones((12, 2))}),
        (markers, {"positions": np.zeros((12, 2, 3))}),
        (spans, {"labels": ("x", "x", "x")}), (spans, {"scores": [1, 2, np.nan]}), (spans, {"rate": 60}),
    ],
)  # fmt: skip
def test_a_changed_field_makes_another_noun(make, change):
    changed = make().replace(**change)
    assert changed != make()
    assert changed == make(**change)


@pytest.mark.parametrize(
    ("make", "field"),
    [
        (skeleton, "offsets"),
        (motion, "local_positions"),
        (motion, "local_rotations"),
        (markers, "positions"),
        (spans, "starts"),
    ],
)
def test_fields_and_arrays_are_frozen(make, field):
    noun = make()
    with pytest.raises(AttributeError):
        setattr(noun, field, None)
    with pytest.raises(ValueError, match="read-only"):
        getattr(noun, field)[0] = 0


def test_the_callers_array_is_neither_frozen_nor_shared():
    places = np.zeros((12, 2, 3))
    noun = motion(local_positions=places)
    places[0] = 1
    assert not noun.local_positions.any()
    view = np.zeros((24, 2, 3))
    noun = motion(local_positions=view[::2])
    view[0] = 1
    assert not noun.local_positions.any()


def test_a_read_only_view_of_what_can_be_written_is_copied():
    base = np.zeros((24, 2, 3))
    seen = base[::2]
    seen.flags.writeable = False
    noun = motion(local_positions=seen)
    spread = motion(local_positions=np.broadcast_to(base[0], (12, 2, 3)))
    base[:] = 1
    assert not noun.local_positions.any()
    assert not spread.local_positions.any()
    assert spread.local_positions.strides[0] == 0  # one frame of memory for all of them
    words = bytearray(8 * 72)
    noun = motion(local_positions=np.frombuffer(memoryview(words).toreadonly()).reshape(12, 2, 3))
    words[:] = b"?" * len(words)
    assert not noun.local_positions.any()


def test_what_nobody_can_write_to_is_taken_over():
    places = np.zeros((12, 2, 3))
    places.flags.writeable = False
    offsets = np.broadcast_to(skeleton().offsets, (12, 2, 3))
    assert motion(local_positions=places).local_positions is places
    assert motion(local_positions=places[::-1]).local_positions.base is places
    assert motion(local_positions=offsets).local_positions is offsets
    whole = motion()
    assert np.shares_memory(whole[3:7].local_positions, whole.local_positions)


def test_a_foreign_array_is_copied():
    class Foreign:
        held = np.zeros((12, 2, 3))

        def __array__(self, dtype=None, copy=None):
            return self.held

    noun = motion(local_positions=Foreign())
    Foreign.held[:] = 1
    assert not noun.local_positions.any()


def test_whole_numbers_may_be_floats_and_quaternions_rounded():
    assert spans(starts=[0.0, 5.0, 3.0]) == spans()
    assert spans(starts=[0.0, 5.0, 3.0]).starts.dtype == np.int64
    turned = np.tile(np.float32([0.1, 0.7, 0.7, 0.1]) / np.float32(1.0), (12, 2, 1))
    turned /= np.linalg.norm(turned, axis=-1, keepdims=True)
    assert motion(local_rotations=turned).local_rotations.dtype == np.float64
    assert len(motion(local_positions=np.zeros((0, 2, 3)), local_rotations=STILL[:0])) == 0
    assert markers(confidence=np.linspace(0, 1, 24).reshape(12, 2)).confidence.max() == 1.0


@pytest.mark.parametrize(
    ("make", "change", "match"),
    [
        (skeleton, {"names": ("a", "a")}, r"differ from one another, got \['a'\] twice"),
        (skeleton, {"names": (), "parents": [], "offsets": np.zeros((0, 3))}, "at least one joint"),
        (skeleton, {"parents": [-1]}, r"parents must have shape \(2\), got \(1,\)"),
        (skeleton, {"parents": [1, -1]}, "stands before its child, joint 'a' does not"),
        (skeleton, {"parents": [-1, 1]}, "joint 'b' does not"),
        (skeleton, {"parents": [-1, -2]}, "stands before its child"),
        (skeleton, {"offsets": [[0, 0, 0], [0, np.nan, 0]]}, r"offsets must be finite, got nan at \(1, 1\)"),
        (skeleton, {"end_parents": [2], "end_offsets": [[0, 0, 0]]}, r"end_parents must lie in \[0, 2\)"),
        (skeleton, {"end_parents": [1], "end_offsets": np.zeros((2, 3))}, "end_offsets must have shape"),
        (motion, {"local_positions": np.zeros((12, 3, 3))}, r"local_positions must have shape \(any, 2, 3\)"),
        (
            motion,
            {"local_rotations": STILL[:5]},
            r"local_rotations must have shape \(12, 2, 4\), got \(5, 2, 4\)",
        ),
        (motion, {"local_rotations": STILL * np.nan}, "finite.*belong in Trajectories"),
        (
            motion,
            {"local_rotations": STILL * 0},
            "unit quaternions, got one of length 0 of joint 'a' in frame 0",
        ),
        (
            motion,
            {"local_rotations": np.where(np.arange(12)[:, None, None] == 7, STILL * 1.00001, STILL)},
            "frame 7",
        ),
        (motion, {"skeleton": "ab"}, "skeleton must be a Skeleton, got 'ab'"),
        (motion, {"local_positions": "here"}, "local_positions must be numbers, got 'here'"),
        (motion, {"rate": "fast"}, "positive number of hertz, got 'fast'"),
        (motion, {"rate": None}, "positive number of hertz, got None"),
        (skeleton, {"names": ("a", "")}, "names must not be empty, got '' at 1"),
        (skeleton, {"names": "ab"}, "names must be a sequence of texts, got 'ab'"),
        (skeleton, {"names": 2}, "names must be a sequence of texts, got 2"),
        (skeleton, {"parents": [-1, 0.5]}, r"parents must be whole numbers, got 0.5 at \(1,\)"),
        (skeleton, {"end_parents": [0.5], "end_offsets": [[0, 0, 0]]}, "end_parents must be whole numbers"),
        (markers, {"names": ("a", " ")}, "names must not be empty, got ' ' at 1"),
        (markers, {"confidence": np.full((12, 2), 1.1)}, r"confidence must lie in \[0, 1\], got 1.1 to 1.1"),
        (markers, {"confidence": np.full((12, 2), -0.1)}, r"confidence must lie in \[0, 1\]"),
        (markers, {"confidence": np.full((12, 2), np.nan)}, "confidence must be finite"),
        (spans, {"starts": [0.7, 5, 3]}, r"starts must be whole numbers, got 0.7 at \(0,\)"),
        (spans, {"stops": [3.9, 9, 8]}, "stops must be whole numbers"),
        (spans, {"stops": [np.nan, 9, 8]}, "stops must be whole numbers"),
        (spans, {"stops": [1e30, 9, 8]}, "stops must be whole numbers"),
        (spans, {"labels": "xyz"}, "labels must be a sequence of texts"),
        (motion, {"rate": 0}, "positive number of hertz, got 0"),
        (motion, {"rate": float("inf")}, "positive number of hertz"),
        (markers, {"positions": np.zeros((12, 2, 4))}, "2 or 3 coordinates, got 4"),
        (markers, {"positions": np.full((12, 2, 3), np.inf)}, "finite or NaN"),
        (markers, {"names": ("a",)}, "positions must have shape"),
        (markers, {"unit": "cm"}, "unit must be one of m, px, relative, got 'cm'"),
        (markers, {"kind": "bone"}, "kind must be one of marker, joint, got 'bone'"),
        (markers, {"confidence": np.ones((11, 2))}, "confidence must have shape"),
        (spans, {"stops": [5, 9]}, "stops must have shape"),
        (spans, {"stops": [5, 5, 8]}, r"stop after its start, got \[5, 5\)"),
        (spans, {"starts": [-1, 5, 3]}, r"frame 0 or later.*got \[-1, 5\)"),
        (spans, {"labels": ("x",)}, "labels must be 3, one a stretch, got 1"),
        (spans, {"scores": [1.0]}, "scores must have shape"),
        (spans, {"rate": -1}, "positive number of hertz"),
    ],
)
def test_what_cannot_be_is_refused_in_one_sentence(make, change, match):
    with pytest.raises(ParameterError, match=match):
        make(**change)


@pytest.mark.parametrize("make", [motion, markers])
@pytest.mark.parametrize(
    ("cut", "count"), [(slice(2, 7), 5), (slice(None), 12), (slice(1, None, 3), 4), (slice(20, 30), 0)]
)
def test_cutting_along_time(make, cut, count):
    noun, field = make(), "local_positions" if make is motion else "positions"
    part = noun[cut]
    assert len(part) == count
    np.testing.assert_array_equal(getattr(part, field), getattr(noun, field)[cut])
    assert part.rate == noun.rate / (cut.step or 1)
    assert part.duration == pytest.approx(count / part.rate)
    np.testing.assert_allclose(part.times, np.arange(count) / part.rate)


@pytest.mark.parametrize("make", [motion, markers])
@pytest.mark.parametrize("cut", [3, slice(None, None, -1), "x"])
def test_only_slices_forward_in_time_cut(make, cut):
    with pytest.raises(ParameterError, match="cut"):
        make()[cut]


def test_stretches_in_turn():
    assert [(a, b, label) for a, b, label, _ in spans()] == [(0, 5, "x"), (5, 9, ""), (3, 8, "x")]
    assert spans()[1:] == spans(starts=[5, 3], stops=[9, 8], labels=("", "x"))
    assert np.isnan(spans().scores).all()
    assert len(Segmentation([], [], rate=30)) == 0


def test_joints_by_name():
    assert skeleton().index("b") == 1
    with pytest.raises(ParameterError, match="no joint 'c'; it has a, b"):
        skeleton().index("c")


def test_errors_are_one_family_with_a_remedy():
    for kind in (ParameterError, FormatError, DataError):
        error = kind("It broke.", remedy="Mend it.")
        assert isinstance(error, LeitmotionError)
        assert (str(error), error.message, error.remedy) == ("It broke. Mend it.", "It broke.", "Mend it.")
    assert issubclass(ParameterError, ValueError)
    assert str(LeitmotionError("It broke.")) == "It broke."
