# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are there whole or not at all, and outputs that take no input's place."""

from __future__ import annotations

import os
import stat

import pytest

from millcorr.errors import UsageError
from millcorr.whole_file import refuse_places, replaced_whole, write_together, write_whole


def mode(path):
    return stat.S_IMODE(path.stat().st_mode)


def test_the_old_file_stays_until_all_that_is_done_meanwhile_succeeded(tmp_path):
    place = tmp_path / "out.nc"
    place.write_text("old")
    with pytest.raises(RuntimeError), replaced_whole(place, b"new"):
        assert place.read_text() == "old"
        raise RuntimeError
    assert place.read_text() == "old" and list(tmp_path.iterdir()) == [place]
    with replaced_whole(place, b"new"):
        pass
    assert place.read_text() == "new" and list(tmp_path.iterdir()) == [place]


def test_a_link_stays_a_link_and_a_file_keeps_its_mode(tmp_path):
    place, link = tmp_path / "out.nc", tmp_path / "link.nc"
    place.write_text("old")
    place.chmod(0o640)
    link.symlink_to(place)
    assert write_whole(link, "µ\n") == link
    assert link.is_symlink() and place.read_bytes() == "µ\n".encode() and mode(place) == 0o640


def test_new_files_and_directories_are_as_readable_as_any(tmp_path):
    plain = tmp_path / "plain"
    plain.mkdir()
    (plain / "file").touch()
    assert mode(write_whole(tmp_path / "new.txt", "")) == mode(plain / "file")
    (file,) = write_together(tmp_path / "deep" / "new", {"file": ["µ\n", b"b\n"]})
    assert file.read_bytes() == "µ\nb\n".encode()
    assert (mode(file.parent), mode(file)) == (mode(plain), mode(plain / "file"))


def test_no_place_to_write_to_is_said_in_one_line(tmp_path):
    with pytest.raises(UsageError, match="there is no directory .*none: make it first"):
        write_whole(tmp_path / "none" / "file", "")
    if os.geteuid():
        tmp_path.chmod(0o500)
        with pytest.raises(UsageError, match="cannot be written: Permission denied"):
            write_whole(tmp_path / "file", "")


@pytest.mark.parametrize("there", [True, False])
def test_files_of_a_directory_appear_together_or_not_at_all(tmp_path, there):
    place = tmp_path / "report"
    if there:
        place.mkdir()
        (place / "a").write_text("old")

    def failing():
        yield "half"
        raise OSError("disk full")

    with pytest.raises(OSError, match="disk full"):
        write_together(place, {"a": ["new"], "b": failing()})
    assert {p.name: p.read_text() for p in place.rglob("*")} == ({"a": "old"} if there else {})
    assert len(list(tmp_path.iterdir())) == there


def test_outputs_take_no_place_that_is_taken(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    source, report = tmp_path / "part.nc", tmp_path / "rep"
    source.touch()
    report.mkdir()
    (tmp_path / "link.nc").symlink_to(source)
    inputs = {"program": source, "setup": None}
    free = tmp_path / "out.nc"
    refuse_places({"output": free, "gcode": None}, inputs, report, ["report.html"])
    for outputs, where, why in (
        ({"output": tmp_path / "link.nc"}, None, "is the program itself"),
        ({"output": free, "gcode": tmp_path / "rep" / ".." / "out.nc"}, None, "is the file of --output itself"),
        ({"output": report}, None, "is a directory"),
        ({"output": tmp_path / "no" / "out.nc"}, None, "there is no directory"),
        ({}, source, "is a file; name a directory"),
        ({"output": report / "report.html"}, report, "would replace the file of --output"),
    ):
        with pytest.raises(UsageError, match=why):
            refuse_places(outputs, inputs, where, ["report.html"])
