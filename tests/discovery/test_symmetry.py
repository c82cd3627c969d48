"""The taxonomy: each motif is told where it is, whatever the side, the direction of time, place, rate and joints."""

import numpy as np
import pytest

import leitmotion as lm
from leitmotion.discovery.symmetry_span import PAIRED
from leitmotion.io import archive
from leitmotion.motion import resample, rotations
from oracles import body as oracle
from oracles import motifs as made

RUNS = [name for name in made.MOVEMENTS if name != "symmetric_path"]


def told(motion, **options):
    return lm.find_symmetry(motion, **options)


def leading(found, *, among=lambda span: span.motif not in (*PAIRED, "stillness")):
    spans = [span for span in found.spans if among(span)]
    return max(spans, key=lambda span: span.confidence)


def outline(found):
    """What and where, to a third of a second."""
    return sorted((span.motif, span.start, span.stop, span.cyclic) for span in found.spans)


def agree(one, other, within):
    assert [(name, cyclic) for name, _, _, cyclic in one] == [(name, cyclic) for name, _, _, cyclic in other]
    for (_, a, b, _), (_, c, d, _) in zip(one, other, strict=True):
        assert abs(a - c) <= within
        assert abs(b - d) <= within


@pytest.mark.parametrize("motif", made.MOVEMENTS)
def test_each_motif_is_told_where_it_is(motif):
    motion = made.movement(motif)
    best = leading(told(motion))
    assert best.motif == motif
    assert best.confidence > 0.7
    assert best.cyclic == (motif != "symmetric_path")
    assert abs(best.start - 20) <= 12
    assert abs(best.stop - (len(motion) - 20)) <= 12


@pytest.mark.parametrize("motif", RUNS)
def test_a_mirror_leaves_all_motifs(motif):
    motion = made.movement(motif)
    agree(outline(told(motion)), outline(told(oracle.mirrored(motion))), within=2)


@pytest.mark.parametrize("motif", RUNS)
def test_time_reversal_keeps_forms_and_their_extents(motif):
    motion = made.movement(motif)
    back = motion.replace(
        local_positions=motion.local_positions[::-1], local_rotations=motion.local_rotations[::-1]
    )
    reversed_ = [
        (name, len(motion) - stop, len(motion) - start, cyclic)
        for name, start, stop, cyclic in outline(told(back))
        if name in RUNS
    ]
    agree([each for each in outline(told(motion)) if each[0] in RUNS], sorted(reversed_), within=8)


@pytest.mark.parametrize("motif", ["symmetric_palindrome", "anti_phase"])
def test_neither_place_nor_rate_nor_joints_change_what_is_told(motif):
    motion = made.movement(motif)
    plain = outline(told(motion))
    agree(plain, outline(told(oracle.moved(motion, yaw=1.0, by=(3.0, 0.2, -1.0)))), within=2)
    agree(plain, outline(told(oracle.without(motion, "LeftShoulder"))), within=4)
    half = [
        (name, 2 * start, 2 * stop, cyclic)
        for name, start, stop, cyclic in outline(told(resample(motion, made.RATE / 2)))
    ]
    agree(plain, half, within=6)


def test_stillness_is_no_signal():
    found = told(made.human_doing(made.rest(200)))
    assert [(span.motif, span.start, span.stop) for span in found.spans] == [("stillness", 0, 200)]


def test_a_path_that_comes_back_after_others_is_repeated_or_reversed():
    up, other = made.one_way(60), np.linspace(0, 1.5, 60)[:, None] * [0.0, 1.0]
    rest = np.zeros((60, 2))
    for again, motif in ((up, "path_repetition"), (up[::-1], "path_reversal")):
        left = np.concatenate((up, up[-1] + other, up[-1] + other[-1] - [2.2, 0.66] * made.ease(60)[:, None]))
        left = np.concatenate((left, left[-1] + rest, left[-1] - other, again))
        right = np.concatenate((rest, rest, rest, other, other[::-1] * 0.8, rest))
        found = told(made.human_doing(left, right))
        pair = leading(found, among=lambda span: span.motif in PAIRED and span.partner[1] > 320)
        assert pair.motif == motif
        assert abs(pair.start - 0) <= 12
        assert abs(pair.stop - 60) <= 20
        assert abs(pair.partner[0] - 300) <= 20


def test_the_other_side_is_a_reflected_path():
    first, second = made.circles(90, 2), made.circles(90, 2)
    left = np.concatenate((first, made.rest(60), made.rest(len(second))))
    right = np.concatenate((made.rest(len(first)), made.rest(60), second))
    found = told(made.human_doing(left, right))
    names = [span.motif for span in found.spans if span.confidence > 0.5]
    assert names.count("asymmetric_cycle") == 2
    assert "reflected_path_repetition" in names
    assert "anti_phase" not in names


@pytest.mark.parametrize(("width", "course"), [(0.45, "palindrome"), (0.8, "cycle")])
@pytest.mark.parametrize("one", [False, True])
def test_once_out_and_back_is_judged_by_how_far_it_leads(width, course, one):
    turned = 2 * np.pi * np.arange(120) / 120
    oval = np.stack((1.1 * (1 - np.cos(turned)), 1.1 * width * np.sin(turned)), axis=1)
    left = np.concatenate((made.rest(30), oval, made.rest(30)))
    best = leading(told(made.human_doing(left, made.rest(len(left)) if one else left)))
    assert best.motif == f"{'a' if one else ''}symmetric_{course}"
    assert not best.cyclic
    assert best.confidence >= 0.5
    assert abs(best.start - 30) <= 12
    assert abs(best.stop - 150) <= 12


def test_an_offset_of_one_side_leaves_a_symmetric_movement_symmetric():
    left = made.there_and_back(60, 3)
    found = told(made.human_doing(left, left + np.radians([10.0, 0.0])))
    assert leading(found).motif == "symmetric_palindrome"


def test_it_is_saved_and_loaded():
    found = told(made.movement("anti_palindrome"))
    assert archive.from_bytes(archive.to_bytes(found), "x.npz") == found


@pytest.mark.data
@pytest.mark.parametrize(
    ("recording", "motif", "cyclic"),
    [
        ("cmu_bvh/jumping_jacks.bvh", "symmetric_palindrome", True),
        ("bandai_namco/dataset-1_walk_normal_001.bvh", "anti_phase", True),
        ("bandai_namco/dataset-1_bow_normal_001.bvh", "symmetric_palindrome", False),
        ("bandai_namco/dataset-1_respond_normal_001.bvh", "asymmetric_palindrome", False),
        ("bandai_namco/dataset-1_kick_normal_001.bvh", "asymmetric_cycle", True),
    ],
)
def test_recordings_are_what_a_person_sees(data, recording, motif, cyclic):
    best = leading(told(lm.read(data / recording)))
    assert (best.motif, best.cyclic) == (motif, cyclic)


def timed(found, least, *, back=False):
    """What is told with some confidence, in seconds; of a recording told backwards, in its own direction."""
    length = found.frames / found.rate
    spans = [
        (span.motif, span.start / found.rate, span.stop / found.rate)
        for span in found.spans
        if span.motif not in (*PAIRED, "stillness") and span.confidence >= least
    ]
    return [
        (name, length - stop, length - start) if back else (name, start, stop) for name, start, stop in spans
    ]


@pytest.mark.data
def test_in_a_session_neither_rate_nor_direction_of_time_change_what_is_told(data):
    motion = lm.read(data / "cmu86" / "86_01.amc")[1200::2]
    back = motion.replace(
        local_positions=motion.local_positions[::-1], local_rotations=motion.local_rotations[::-1]
    )
    plain, slow, turned = told(motion), told(motion[::2]), told(back)
    assert len(timed(plain, 0.5)) >= 5
    for sure, doubtful in (
        (timed(plain, 0.5), timed(slow, 0.35)),
        (timed(slow, 0.5), timed(plain, 0.35)),
        (timed(plain, 0.5), timed(turned, 0.35, back=True)),
        (timed(turned, 0.5, back=True), timed(plain, 0.35)),
    ):
        for name, start, stop in sure:
            shared = [min(stop, b) - max(start, a) for other, a, b in doubtful if name == other]
            assert max(shared, default=0.0) > 0.8 * (stop - start), (name, start, stop)


def test_a_shaken_recording_with_a_crooked_side_tells_the_same(rng):
    for motif in RUNS:
        motion = made.movement(motif)
        shape = (*motion.local_rotations.shape[:2], 3)
        shaken = rotations.from_rotation_vector(np.radians(3.0) * rng.normal(size=shape))
        askew = rotations.from_rotation_vector(np.radians([4.0, 0.0, 6.0]))
        local = rotations.multiply(motion.local_rotations, shaken)
        for joint in ("LeftArm", "LeftForeArm"):
            place = motion.skeleton.index(joint)
            local[:, place] = rotations.multiply(local[:, place], askew)
        assert leading(told(motion.replace(local_rotations=local))).motif == motif
