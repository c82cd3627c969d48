"""``leitmotion dynamics``: what it prints, its document, and the files that it writes."""

import csv
import json
import re
from pathlib import Path

import numpy as np
import pytest

import leitmotion as lm
from cli.conftest import Run
from cli.json_schema import faults
from leitmotion.body import SEGMENTS
from leitmotion.cli.dynamics import COLUMNS
from leitmotion.cli.dynamics import SEGMENTS as NAMED

DOCS = Path(__file__).resolve().parents[2] / "docs" / "json.md"


def test_a_person_reads_the_mass_the_filter_and_whether_there_are_flights(run: Run, made: Path) -> None:
    told = run("dynamics", made / "jacks.bvh", "--mass", "62")
    assert told.exit_code == 0, told.stderr
    assert told.stdout.startswith("62 kg in 16 segments; filtered by a zero-lag low-pass at 10 Hz.")
    assert "kinetic energy" in told.stdout
    assert re.search(r"\d flights?: |No flight was found", told.stdout)
    assert told.stderr == ""


def test_a_mass_that_nobody_gave_is_told(run: Run, made: Path) -> None:
    told = run("dynamics", made / "jacks.bvh")
    assert "Note: The mass was not given: 70 kg is assumed" in told.stderr
    assert "Note" not in run("dynamics", made / "jacks.bvh", "--quiet").stderr


def test_the_document_fits_its_schema_and_says_what_the_library_says(run: Run, made: Path) -> None:
    schema = json.loads(re.findall(r"```json\n(.*?)```", DOCS.read_text(encoding="utf-8"), re.DOTALL)[-1])
    told = run("dynamics", made / "jacks.bvh", made / "bad.bvh", "--json", "--sex", "female", "--cutoff", "0")
    assert told.exit_code == 1
    document, failed = (json.loads(line) for line in told.stdout.splitlines())
    assert faults(document, schema) == faults(failed, schema) == []
    found = lm.dynamics(lm.read(made / "jacks.bvh"), sex="female", cutoff_hz=None)
    result = document["result"]
    assert document["parameters"]["cutoff_hz"] is None
    assert document["parameters"]["sex"] == "female"
    assert result["body"]["kinetic_energy_j"]["most"] == pytest.approx(found.kinetic_energy.max(), rel=1e-6)
    assert [part["segment"] for part in result["segments"]] == list(SEGMENTS)
    assert sum(part["mass_kg"] for part in result["segments"]) == pytest.approx(70)
    assert [flight["start"] for flight in result["flights"]] == [flight.start for flight in found.flights]


def test_the_table_has_a_row_per_frame_of_each_input(run: Run, made: Path) -> None:
    told = run("dynamics", made / "jacks.bvh", made / "once.bvh", "-o", "frames.csv")
    assert told.exit_code == 0, told.stderr
    with open("frames.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert tuple(rows[0]) == COLUMNS
    found = [lm.dynamics(lm.read(made / name)) for name in ("jacks.bvh", "once.bvh")]
    assert len(rows) == sum(len(one) for one in found)
    row, (first, second) = rows[len(found[0]) + 7], found
    assert (row["path"], row["frame"]) == (str(made / "once.bvh"), "7")
    assert float(row["body_y"]) == pytest.approx(second.centre_of_mass[7, 1], rel=1e-8)
    shin = SEGMENTS.index("left_shank")
    assert float(rows[7]["left_shank_lx"]) == pytest.approx(first.angular_momenta[7, shin, 0], rel=1e-8)
    assert float(rows[7]["left_shank_potential"]) == pytest.approx(
        first.potential_energies[7, shin], rel=1e-8
    )
    assert run("dynamics", made / "jacks.bvh", "-o", "frames.csv").exit_code == 0  # it is ours


def test_the_value_is_saved_and_the_curves_are_drawn(run: Run, made: Path) -> None:
    assert run("dynamics", made / "jacks.bvh", "-o", "jacks.npz").exit_code == 0
    assert run("dynamics", made / "jacks.bvh", "-o", "jacks.npz").exit_code == 0
    assert lm.load("jacks.npz") == lm.dynamics(lm.read(made / "jacks.bvh"))
    assert run("dynamics", made / "jacks.bvh", "-o", "jacks.png").exit_code == 0
    assert Path("jacks.png").read_bytes().startswith(b"\x89PNG")


def test_one_file_holds_one_recording(run: Run, made: Path) -> None:
    told = run("dynamics", made / "jacks.bvh", made / "once.bvh", "-o", "both.png")
    assert told.exit_code == 2
    assert "both.png holds one recording, but there are 2" in told.stderr
    assert not Path("both.png").exists()


def test_points_without_a_unit_are_refused_in_a_sentence(run: Run, tmp_path: Path, made: Path) -> None:
    motion = lm.read(made / "jacks.bvh")
    flat = lm.Trajectories(
        motion.skeleton.names, np.zeros((9, len(motion.skeleton.names), 2)), 30.0, unit="px", kind="joint"
    )
    lm.save(flat, tmp_path / "flat.npz")
    told = run("dynamics", "flat.npz")
    assert told.exit_code == 1
    assert "Traceback" not in told.stderr


def test_the_columns_name_the_segments_of_the_body() -> None:
    assert NAMED == SEGMENTS
