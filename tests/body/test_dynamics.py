"""Dynamics: rigid bodies that textbooks solve, laws of symmetry, particles as a twin, and people who jump."""

import numpy as np
import pytest

from leitmotion.body import SEGMENTS, dynamics, embody
from leitmotion.body.flight import GRAVITY
from leitmotion.body.inertia import TOP_TO_HIPS, inertia_table
from leitmotion.motion import DataError, ParameterError, Trajectories, joint_points, rotations
from oracles.dynamics import inertia_about_centre, particles, totals

POSE = {
    "Neck": (0, 1.5, 0), "Head": (0, 1.65, 0.03),
    "LeftShoulder": (0.18, 1.42, 0), "LeftElbow": (0.45, 1.38, 0.05), "LeftWrist": (0.6, 1.55, 0.2),
    "RightShoulder": (-0.18, 1.42, 0), "RightElbow": (-0.25, 1.15, 0.02), "RightWrist": (-0.22, 1.0, 0.2),
    "LeftHip": (0.1, 0.92, 0), "LeftKnee": (0.16, 0.55, 0.2), "LeftAnkle": (0.16, 0.15, 0.1),
    "LeftToe": (0.17, 0.05, 0.22),
    "RightHip": (-0.1, 0.92, 0), "RightKnee": (-0.12, 0.5, 0.02), "RightAnkle": (-0.12, 0.09, -0.05),
    "RightToe": (-0.13, 0.02, 0.1),
}  # fmt: skip
NAMES = tuple(POSE)
STATUE = np.array(list(POSE.values()), dtype=float)
LEGS = [k for k, name in enumerate(NAMES) if name.endswith(("Knee", "Ankle", "Toe"))]
RATE = 240.0


def recorded(positions, rate=RATE):
    return Trajectories(NAMES, positions, rate, unit="m", kind="joint")


def moved(turns, places):
    """The statue, rigid: turned by quaternions (T, 4) about the height of its hips, and carried."""
    hips = np.array([0, 0.92, 0])
    return rotations.rotate(turns[:, None], STATUE - hips) + hips + np.asarray(places)[:, None]


def still(frames=3, rate=RATE):
    return dynamics(recorded(np.broadcast_to(STATUE, (max(frames, 5), *STATUE.shape)), rate), cutoff_hz=None)


def as_particles(found):
    return particles(found.masses, found.inertias, found.centres, rotations.as_matrix(found.global_rotations))


def tumbling(spin, seconds=0.7, rate=RATE):
    """A thrown rigid statue: Euler's equations, integrated; places and turns that no law of ours went into."""
    from scipy.integrate import solve_ivp

    weights, places = as_particles(still())
    tensor, centre = inertia_about_centre(weights, places[0])

    def change(_, state):
        q, w = state[:4], state[4:]
        return np.concatenate(
            (
                rotations.multiply(q, np.array([0.0, *w])) / 2,
                np.linalg.solve(tensor, -np.cross(w, tensor @ w)),
            )
        )

    times = np.arange(round(seconds * rate)) / rate
    solved = solve_ivp(change, (0, times[-1]), [1.0, 0, 0, 0, *spin], t_eval=times, rtol=1e-10, atol=1e-12)
    turns = rotations.normalize(solved.y[:4].T)
    fallen = np.outer(times, [1.0, 2.5, -0.5]) - np.outer(times**2, [0, GRAVITY / 2, 0])
    positions = (
        rotations.rotate(turns[:, None], STATUE - centre) + (centre + np.array([0, 1, 0]) + fallen)[:, None]
    )
    return recorded(positions, rate), tensor @ np.asarray(spin)


@pytest.mark.parametrize("sex", ["mean", "female", "male"])
def test_the_parts_of_the_table_make_a_whole(sex):
    table = inertia_table(sex)
    weight = {name: table.parts[name].mass * (1 if "_" not in name and name not in
              ("forearm", "hand", "thigh", "shank", "foot") else 2) for name in table.parts}  # fmt: skip
    assert sum(weight.values()) == pytest.approx(1.0, abs=1e-12)
    trunk = [table.parts[name] for name in ("thorax", "abdomen", "pelvis")]
    assert sum(part.length for part in trunk) == pytest.approx(table.top_to_hips, abs=1e-3)


@pytest.mark.parametrize(("sex", "whole"), [("female", 0.4151), ("male", 0.4486)])
def test_the_parts_of_the_trunk_lie_as_the_whole_does(sex, whole):
    """The table tells the whole trunk apart from its parts: two measurements of one thing."""
    table, top, moment, mass = inertia_table(sex), 0.0, 0.0, 0.0
    for name in ("thorax", "abdomen", "pelvis"):
        part = table.parts[name]
        moment, mass, top = (
            moment + part.mass * (top + part.centre * part.length),
            mass + part.mass,
            top + part.length,
        )
    assert moment / mass / TOP_TO_HIPS[sex] == pytest.approx(whole, abs=0.01)


def test_what_stands_still_has_height_and_nothing_else():
    found = still()
    assert np.abs(found.angular_momentum).max() < 1e-9
    assert found.kinetic_energy.max() < 1e-12
    assert found.potential_energy[0] == pytest.approx(70 * GRAVITY * found.centre_of_mass[0, 1])
    assert 0.5 < found.centre_of_mass[0, 1] / 1.75 < 0.6  # of a person's stature
    assert found.flights == ()


def test_a_spinning_body_turns_as_its_tensor_says():
    spin = np.array([0, 3.0, 0])
    times = np.arange(240) / RATE
    found = dynamics(
        recorded(moved(rotations.from_axis_angle("y", 3.0 * times), np.zeros((240, 3)))), mass=61
    )
    weights, places = as_particles(found)
    tensor, _ = inertia_about_centre(weights, places[120])
    assert found.mass == pytest.approx(61)
    assert np.allclose(found.angular_velocities[40:200], spin, atol=2e-3)
    assert np.allclose(found.angular_momentum[120], tensor @ spin, rtol=2e-3)
    about = np.cross(spin, found.centre_of_mass[120] - [0, 0, 0])
    energy = spin @ tensor @ spin / 2 + 61 * about @ about / 2
    assert found.kinetic_energy[120] == pytest.approx(energy, rel=4e-3)


@pytest.mark.parametrize("spin", [(0.1, 4.0, 0.1), (5.0, 0.2, 0.0), (0.3, 0.1, 6.0)])
def test_a_thrown_body_keeps_its_angular_momentum_and_energy_and_falls_with_g(spin):
    thrown, momentum = tumbling(np.array(spin))
    found = dynamics(thrown, cutoff_hz=None)
    assert np.allclose(found.angular_momentum[5:-5], momentum, atol=2e-3 * np.linalg.norm(momentum))
    energy = found.kinetic_energy + found.potential_energy
    assert np.ptp(energy[5:-5]) < 1e-3 * found.kinetic_energy.mean()
    (flight,) = found.flights
    assert flight.gravity == pytest.approx(GRAVITY, rel=1e-4)
    assert flight.gravity_error == pytest.approx(0, abs=1e-4)
    assert flight.drift_share < 1e-3
    assert flight.residual < 1e-5


def test_the_filter_costs_a_thrown_body_little():
    thrown, _ = tumbling(np.array([0.3, 0.1, 6.0]))
    (flight,) = dynamics(thrown).flights
    assert flight.drift_share < 0.03
    assert abs(flight.gravity_error) < 1e-3


def test_a_thrown_chain_of_two_links_keeps_its_angular_momentum():
    """Trunk and legs jack-knife in the air: the hinge is driven, the whole turns so that momentum is kept."""
    times = np.arange(240) / RATE
    flex = 0.6 * (1 - np.cos(2 * np.pi * times))
    hip = np.array([0, 0.92, 0])
    bent = np.broadcast_to(STATUE, (240, *STATUE.shape)).copy()
    turn = rotations.from_axis_angle("x", -flex)
    bent[:, LEGS] = rotations.rotate(turn[:, None], STATUE[LEGS] - hip) + hip
    bent[..., 0] = 0.5 * (bent[..., 0] - bent[:, [NAMES.index(_other(name)) for name in NAMES], 0])  # planar
    for axis in (1, 2):
        bent[..., axis] = 0.5 * (
            bent[..., axis] + bent[:, [NAMES.index(_other(name)) for name in NAMES], axis]
        )
    inner = dynamics(recorded(bent), cutoff_hz=None)
    weights, places = as_particles(inner)
    _, carried, _ = totals(weights, places, RATE)
    tensors = np.array([inertia_about_centre(weights, places[k])[0][0, 0] for k in range(1, 239)])
    rate_of_turn = (4.0 - carried[:, 0]) / tensors  # about x
    angle = np.concatenate(([0.0, 0.0], np.cumsum((rate_of_turn[1:] + rate_of_turn[:-1]) / 2 / RATE)))
    angle = np.append(angle[:239], angle[-1] + rate_of_turn[-1] / RATE)
    centre = inner.centre_of_mass[:, None]
    thrown = rotations.rotate(rotations.from_axis_angle("x", angle)[:, None], bent - centre) + centre
    found = dynamics(recorded(thrown), cutoff_hz=None)
    assert np.allclose(found.angular_momentum[5:-5], [4.0, 0, 0], atol=0.02)
    assert np.ptp(found.angular_momenta[5:-5, :, 0].sum(axis=1)) > 0.2  # the parts trade what the whole keeps


def test_a_pendulum_keeps_its_energy():
    """Hung by a hand and let go: the equation of a physical pendulum, its energy from the segments."""
    from scipy.integrate import solve_ivp

    weights, places = as_particles(still())
    tensor, centre = inertia_about_centre(weights, places[0])
    pivot = np.array([0.0, 2.2, centre[2]])
    arm = centre - pivot
    about = tensor[0, 0] + 70 * (arm @ arm - arm[0] ** 2)
    times = np.arange(480) / RATE

    def change(_, state):
        return [state[1], -70 * GRAVITY * np.linalg.norm(arm[1:]) * np.sin(state[0]) / about]

    swing = solve_ivp(change, (0, 2), [0.8, 0.0], t_eval=times, rtol=1e-10, atol=1e-12).y[0]
    turns = rotations.from_axis_angle("x", swing)
    found = dynamics(recorded(rotations.rotate(turns[:, None], STATUE - pivot) + pivot), cutoff_hz=None)
    energy = found.kinetic_energy + found.potential_energy
    assert np.ptp(energy) < 1e-3 * np.ptp(found.potential_energy)
    assert found.flights == ()


def test_particles_say_the_same(wandering):
    found = dynamics(wandering, cutoff_hz=None)
    momenta, angular, energies = totals(*as_particles(found), wandering.rate)
    inner = slice(1, -1)
    assert np.allclose(found.linear_momentum[inner], momenta, atol=2e-3 * np.abs(momenta).max())
    assert np.allclose(found.angular_momentum[inner], angular, atol=5e-3 * np.abs(angular).max())
    assert np.allclose(found.kinetic_energy[inner], energies, rtol=5e-3)


@pytest.fixture
def wandering(rng):
    """A body that bends in every joint, smoothly."""
    times = np.arange(300) / RATE
    phase, size = rng.uniform(0, 6, STATUE.shape), rng.uniform(0, 0.03, STATUE.shape)
    waves = np.sin(2 * np.pi * times[:, None, None] + phase) * size
    return recorded(STATUE + waves + np.outer(times, [0.4, 0, 1.0])[:, None])


def test_place_and_yaw_turn_the_vectors_and_nothing_else(wandering):
    here = dynamics(wandering)
    yaw = rotations.yaw_rotation(1.1)
    there = dynamics(
        wandering.replace(positions=rotations.rotate(yaw, wandering.positions) + np.array([5, 0, -3]))
    )
    assert np.allclose(there.angular_momentum, rotations.rotate(yaw, here.angular_momentum), atol=1e-8)
    assert np.allclose(there.velocities, rotations.rotate(yaw, here.velocities), atol=1e-8)
    assert np.allclose(there.body_twists, here.body_twists, atol=1e-7)
    assert np.allclose(there.potential_energies, here.potential_energies)


def test_the_mirror_image_has_mirrored_momenta(wandering):
    other = [NAMES.index(_other(name)) for name in NAMES]
    mirrored = wandering.replace(positions=(wandering.positions * [-1, 1, 1])[:, other])
    here, there = dynamics(wandering), dynamics(mirrored)
    assert np.allclose(there.linear_momentum, here.linear_momentum * [-1, 1, 1], atol=1e-9)
    assert np.allclose(there.angular_momentum, here.angular_momentum * [1, -1, -1], atol=1e-7)  # axial
    sides = [SEGMENTS.index(_other(name)) for name in SEGMENTS]
    assert np.allclose(there.angular_energies, here.angular_energies[:, sides], atol=1e-9)


def test_size_and_mass_scale_as_they_must(wandering):
    here = dynamics(wandering, mass=50)
    there = dynamics(wandering.replace(positions=2 * wandering.positions), mass=100)
    assert np.allclose(there.angular_momentum, 8 * here.angular_momentum, atol=1e-7)
    assert np.allclose(there.kinetic_energy, 8 * here.kinetic_energy)
    assert np.allclose(there.potential_energy, 4 * here.potential_energy)


def test_the_rate_hardly_matters():
    fast, slow = (tumbling(np.array([0.3, 4.0, 1.0]), rate=rate)[0] for rate in (480.0, 60.0))
    one, other = dynamics(fast), dynamics(slow)
    inner = slice(12, -12)
    assert np.allclose(one.angular_momentum[::8][inner], other.angular_momentum[inner], atol=0.05)
    assert np.allclose(one.kinetic_energy[::8][inner], other.kinetic_energy[inner], rtol=0.01)


def test_twists_carry_the_frames_on(wandering):
    """Moved by a small turn about its screw, each frame is the next frame (paper S, 2.4)."""
    found = dynamics(wandering, cutoff_hz=None)
    step, k = 1 / wandering.rate, 150
    v, w = found.global_twists[k, :, :3], found.global_twists[k, :, 3:]
    axes = rotations.as_matrix(found.global_rotations[k])
    carried = found.origins[k] + step * (v + np.cross(w, found.origins[k]))
    assert np.allclose(carried, found.origins[k + 1], atol=2e-5)
    turned = rotations.multiply(rotations.from_rotation_vector(step * w), found.global_rotations[k])
    assert rotations.geodesic_angle(turned, found.global_rotations[k + 1]).max() < 1e-3
    assert np.allclose(np.einsum("sij,sj->si", axes, found.body_twists[k, :, 3:]), w, atol=1e-9)
    speed = np.einsum("sij,sj->si", axes, found.body_twists[k, :, :3])
    assert np.allclose(speed - np.cross(w, found.origins[k]), v, atol=1e-9)


def test_axes_at_rest_are_the_body_s_own():
    pose = dict(POSE)
    for side, x in (("Left", 1), ("Right", -1)):
        pose[f"{side}Shoulder"], pose[f"{side}Hip"] = (0.2 * x, 1.42, 0), (0.1 * x, 0.92, 0)
        for name, y, z in (("Elbow", 1.14, 0), ("Wrist", 0.88, 0)):
            pose[side + name] = (0.2 * x, y, z)
        for name, y, z in (("Knee", 0.5, 0), ("Ankle", 0.08, 0), ("Toe", 0.08, 0.15)):
            pose[side + name] = (0.1 * x, y, z)
    pose["Head"] = (0, 1.65, 0)
    standing = np.broadcast_to(np.array(list(pose.values()), dtype=float), (6, len(NAMES), 3))
    found = dynamics(recorded(standing))
    assert rotations.geodesic_angle(found.global_rotations, rotations.IDENTITY).max() < 1e-9
    assert np.allclose(found.centre_of_mass[:, 0], 0, atol=1e-12)


def test_what_is_unseen_stays_unknown_and_costs_the_rest_nothing():
    thrown, _ = tumbling(np.array([0.1, 4.0, 0.1]))
    positions = thrown.positions.copy()
    positions[100:120, NAMES.index("LeftElbow")] = np.nan
    found = dynamics(thrown.replace(positions=positions))
    assert np.isnan(found.centre_of_mass[100:120]).all()
    assert found.parameters["unseen_frames"] == 20
    for start, stop in ((0, 100), (120, len(thrown))):
        part = dynamics(thrown[start:stop])
        assert np.allclose(found.kinetic_energy[start:stop], part.kinetic_energy, rtol=1e-6)
    first, second = found.flights
    assert first.stop <= 100
    assert second.start >= 120


def test_hands_and_feet_may_be_missing(wandering):
    kept = [k for k, name in enumerate(NAMES) if not name.endswith("Toe")]
    short = Trajectories(
        tuple(NAMES[k] for k in kept), wandering.positions[:, kept], RATE, unit="m", kind="joint"
    )
    found, whole = dynamics(short), dynamics(wandering)
    assert found.parameters["lumped"] == ["left_foot", "left_hand", "right_foot", "right_hand"]
    assert np.linalg.norm(found.centre_of_mass - whole.centre_of_mass, axis=1).max() < 0.005
    assert found.mass == pytest.approx(whole.mass)


def _other(name):
    swaps = {"Left": "Right", "Right": "Left", "left_": "right_", "right_": "left_"}
    for one, other in swaps.items():
        if name.startswith(one):
            return other + name.removeprefix(one)
    return name


def test_refusals_say_what_is_wrong(wandering):
    for mass in (0, -3, np.nan, True):
        with pytest.raises(ParameterError, match="mass must be a positive number of kilograms"):
            dynamics(wandering, mass=mass)
    with pytest.raises(ParameterError, match="sex must be one of mean, female, male, got 'x'"):
        dynamics(wandering, sex="x")
    with pytest.raises(ParameterError, match="cutoff must lie above 0 and below 108 Hz"):
        dynamics(wandering, cutoff_hz=200)
    with pytest.raises(DataError, match="metres in three dimensions, the recording has 3 in relative"):
        dynamics(wandering.replace(unit="relative"))
    few = [k for k, name in enumerate(NAMES) if name != "LeftKnee"]
    with pytest.raises(DataError, match="has no left_knee"):
        dynamics(
            Trajectories(
                tuple(NAMES[k] for k in few), wandering.positions[:, few], RATE, unit="m", kind="joint"
            )
        )
    with pytest.raises(DataError, match=r"needs 5 frames in a row, .* has 4\."):
        dynamics(wandering[:4])
    together = wandering.positions.copy()
    together[:, NAMES.index("LeftWrist")] = together[:, NAMES.index("LeftElbow")]
    with pytest.raises(DataError, match="left_elbow and left_wrist stand in one place"):
        dynamics(wandering.replace(positions=together))


@pytest.mark.data
@pytest.mark.parametrize(
    ("name", "count", "error", "drift"),
    [("cmu86/86_01.amc", 2, 0.06, 0.1), ("cmu_bvh/jumping_jacks.bvh", 5, 0.07, 0.1)],
)
def test_people_who_jump_fall_with_g(data, name, count, error, drift):
    import leitmotion as lm

    found = dynamics(lm.read(data / name))
    assert len(found.flights) == count
    for flight in found.flights:
        assert abs(flight.gravity_error) < error
        assert flight.drift_share < drift
        assert flight.residual < 0.005


@pytest.mark.data
def test_points_say_nearly_what_a_skeleton_says(data):
    import leitmotion as lm

    motion = lm.read(data / "cmu86" / "86_01.amc")[550:1150]
    told, points = dynamics(motion), dynamics(joint_points(motion))
    assert told.parameters["turned_by_file"]
    assert points.parameters["turned_by_file"] == []
    assert np.abs(told.centre_of_mass - points.centre_of_mass).max() < 1e-6
    assert (
        np.abs(told.angular_momentum - points.angular_momentum).max()
        < 0.1 * np.abs(told.angular_momentum).max()
    )
    same = dynamics(embody(motion))
    assert np.allclose(same.angular_momentum, points.angular_momentum, atol=1e-9)
