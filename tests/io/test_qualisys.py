"""Qualisys TSV: the ways in which one recording is exported, what is missing, and what is refused."""

import numpy as np
import pytest

from leitmotion import io
from leitmotion.motion import FormatError

HEADER = (
    "NO_OF_FRAMES\t3\nNO_OF_CAMERAS\t8\nNO_OF_MARKERS\t2\nFREQUENCY\t50\nDESCRIPTION\t--\n"
    "TIME_STAMP\t2018-04-29, 17:31:02\t20552.5\nDATA_INCLUDED\t3D\nMARKER_NAMES\tHead\tAnkle-L\n"
)
ROWS = ["1\t2\t1700\t4\t5\t80", "1.5\t2.5\t1700\t\t\t", "2\t3\t1700\t5\t6\t80"]
EXPECTED = np.array(
    [[[1, 2, 1700], [4, 5, 80]], [[1.5, 2.5, 1700], [np.nan] * 3], [[2, 3, 1700], [5, 6, 80]]]
)
AXES = "\t".join(f"{name} {axis}" for name in ("Head", "Ankle-L") for axis in "XYZ")


def export(header=HEADER, heading="", rows=ROWS):
    return header + heading + "\n".join(rows) + "\n"


def numbered(*, time):
    return [f"{k + 1}\t" + (f"{k / 50:.5f}\t" if time else "") + row for k, row in enumerate(ROWS)]


def read(tmp_path, text, name="take.tsv", **options):
    path = tmp_path / name
    path.write_bytes(text.encode())
    return io.open_recording(path, **{"up": "y", **options})


@pytest.mark.parametrize(
    "text",
    [
        export(),
        export().replace("\n", "\r\n"),
        "\ufeff" + export(),
        export(rows=[f"{row}\t" for row in ROWS]),
        export(rows=[ROWS[0], "1.5\t2.5\t1700", ROWS[2]]),
        export(heading=f"{AXES}\n"),
        export(heading=f"Frame\tTime\t{AXES}\n", rows=numbered(time=True)),
        export(heading=f"Frame\t{AXES}\n", rows=numbered(time=False)),
        export(rows=numbered(time=True)),
        export(rows=numbered(time=False)),
        export(HEADER.replace("\t50\n", "\tEXT\n"), f"Frame\tTime\t{AXES}\n", numbered(time=True)),
        export("FILE_VERSION\t2.0.0\n" + HEADER + "TRAJECTORY_TYPES\tMeasured\tMixed\n"),
        export(HEADER.replace("DESCRIPTION\t--", "DESCRIPTION -- ").replace("\t3D\n", "\t3D \n")),
        export(HEADER + "EVENT\tStart\t1\t0.0\nEVENT\tStop\t3\t0.04\n"),
    ],
    ids=["plain", "crlf", "bom", "tab-at-end", "short-row", "named", "frame-time", "frame", "bare-frame-time",
         "bare-frame", "external", "types", "blanks", "events"],
)  # fmt: skip
def test_spellings_of_one_export(tmp_path, text):
    reading = read(tmp_path, text)
    (markers,) = reading.recordings
    assert (markers.names, markers.rate, reading.warnings) == (("Head", "Ankle-L"), 50.0, ())
    np.testing.assert_allclose(markers.positions, EXPECTED / 1000)
    assert [reading.findings[topic].how for topic in ("unit", "rate")] == ["read", "read"]


def test_it_is_told_from_a_table_by_how_it_begins(tmp_path):
    assert read(tmp_path, export(), "take.csv2").recordings[0].names == ("Head", "Ankle-L")
    table = "time\tA_x\tA_y\tA_z\n0\t1\t2\t3\n0.1\t1\t2\t3\n"
    assert read(tmp_path, table, unit="m").recordings[0].names == ("A",)


def test_the_origin_is_a_marker_unseen_and_the_vertical_is_judged(tmp_path):
    rows = [ROWS[0], ROWS[1].replace("\t\t\t", "\t0.000\t0.000\t0.000"), ROWS[2]]
    reading = read(tmp_path, export(rows=rows), up=None)
    assert np.isnan(reading.recordings[0].positions[1, 1]).all()
    assert reading.warnings == (
        "1 places lie exactly in the origin or at infinity and were taken as unseen.",
    )
    assert (reading.findings["up"].value, reading.findings["up"].how) == ("z", "guessed")


def test_counts_that_differ_and_markers_never_seen_are_told(tmp_path):
    header = HEADER.replace("FRAMES\t3", "FRAMES\t9").replace("Ankle-L", "Ankle-L\tGhost")
    reading = read(tmp_path, export(header, rows=[f"{row}\t\t\t" for row in ROWS]))
    assert reading.recordings[0].names == ("Head", "Ankle-L")
    assert reading.warnings == (
        "The header promises 9 frames, the file has 3; those it has were read.",
        "The header promises 2 markers, the file has 3; those it has were read.",
        "1 markers that are never seen were left out.",
    )


@pytest.mark.parametrize(
    ("old", "new", "match"),
    [
        ("DATA_INCLUDED\t3D", "DATA_INCLUDED\t6D", r"found 6D data \(rigid bodies\)\. Export the 3D data"),
        ("DATA_INCLUDED\t3D", "DATA_INCLUDED\t2D", r"found 2D data \(what each camera saw\)"),
        ("MARKER_NAMES\tHead\tAnkle-L\n", "", "expected names of markers after MARKER_NAMES, found none"),
        (
            "FREQUENCY\t50",
            "FREQUENCY\tEXT",
            "expected a rate above 0 Hz after FREQUENCY, found 'EXT'.*--rate HZ",
        ),
        ("1700\t4", "x\t4", "line 9: expected a number, found 'x'"),
        ("5\t80\n", "5\t80\t1\t2\t3\n", "line 9: expected 6 numbers in the row, three a marker, found 9"),
        ("\n".join(ROWS), "", "expected a row a frame"),
    ],
)
def test_faults_are_one_sentence(tmp_path, old, new, match):
    with pytest.raises(FormatError, match=match):
        read(tmp_path, export().replace(old, new))


def test_odd_headers(tmp_path):
    assert read(tmp_path, export(HEADER.replace("FRAMES\t3", "FRAMES\t²"))).warnings == ()
    narrow = export(heading=f"Frame\tTime\t{AXES}\n")  # names more columns than the rows have
    with pytest.raises(FormatError, match="line 10: expected 8 cells in a row, found 6 at most"):
        read(tmp_path, narrow)


def test_a_rate_given_serves_where_none_is_stated(tmp_path):
    reading = read(tmp_path, export(HEADER.replace("\t50\n", "\tEXT\n")), rate=25)
    assert reading.findings["rate"].how == "given"


@pytest.mark.data
def test_real_export(data):
    path = data / "juigmend_tsv" / "man_heaven_six.tsv"
    reading = io.open_recording(path)
    (markers,) = reading.recordings
    assert (markers.positions.shape, markers.rate) == ((3150, 27, 3), 60.0)
    assert (reading.findings["up"].value, reading.findings["unit"].value) == ("z", "mm")
    rows = path.read_text().splitlines()[10:]  # read anew, by hand
    stated = np.array([[float(cell) for cell in row.split("\t")] for row in rows]).reshape(3150, 27, 3) / 1000
    x, y, z = np.moveaxis(stated, -1, 0)
    seen = np.isfinite(markers.positions)
    assert (~seen).sum() == 3 * 19
    np.testing.assert_allclose(markers.positions[seen], np.stack((x, z, -y), -1)[seen])
