"""Files are written whole, with the mode that any new file gets, and nothing of the process is changed for it."""

import os
import stat

import pytest

from leitmotion import io


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
