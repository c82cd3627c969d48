"""Files are written whole, with the mode that any new file gets, and nothing of the process is changed for it."""

import os
import stat

import pytest

from leitmotion import io
from leitmotion.io import files
from leitmotion.motion import DataError


@pytest.mark.skipif(os.name != "posix", reason="modes are POSIX's")
@pytest.mark.parametrize("mask", [0o022, 0o077, 0o002])
def test_a_file_gets_the_mode_of_any_new_file(tmp_path, monkeypatch, mask):
    before = os.umask(mask)
    try:
        with monkeypatch.context() as patched:
            patched.setattr(os, "umask", lambda _: pytest.fail("the umask belongs to the whole process"))
            path = io.write_whole(tmp_path / "a.txt", "whole")
            again = io.write_whole(path, "again")
        assert (tmp_path / "b.txt").write_text("plain") == 5
    finally:
        os.umask(before)
    modes = {stat.S_IMODE(one.stat().st_mode) for one in (path, again, tmp_path / "b.txt")}
    assert modes == {0o666 & ~mask}
    assert sorted(one.name for one in tmp_path.iterdir()) == ["a.txt", "b.txt"]


def test_parts_are_taken_away_of_one_process_of_this_machine_only(tmp_path, monkeypatch):
    mine = tmp_path / f".a.npz.{files.owner(7)}-0.part"
    others = [tmp_path / f".a.npz.{files.owner(17)}-0.part"]
    with monkeypatch.context() as patched:
        patched.setattr(files.platform, "node", lambda: "another machine")
        others.append(tmp_path / f".a.npz.{files.owner(7)}-0.part")
    for path in (mine, *others):
        path.touch()
    files.discard_parts(tmp_path, 7)
    assert set(tmp_path.iterdir()) == set(others)


@pytest.mark.parametrize("links", [True, False])
def test_what_is_there_stays_unless_it_may_be_replaced(tmp_path, monkeypatch, links):
    def without_links(*_):
        raise PermissionError(1, "no links here")

    if not links:
        monkeypatch.setattr(os, "link", without_links)
    path = io.write_whole(tmp_path / "a.txt", "first", replace=False)
    with pytest.raises(DataError, match=r"a\.txt is there with other content"):
        io.write_whole(path, "second", replace=False)
    assert path.read_text() == "first"
    io.write_whole(path, "second")
    assert path.read_text() == "second"
    assert list(tmp_path.iterdir()) == [path]
