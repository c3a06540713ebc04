# SPDX-License-Identifier: LGPL-2.1-or-later
"""A correction is one dressup with a list of measured parts, newest last, each of which can be switched off and on."""

from __future__ import annotations

import json

import FreeCAD
import numpy as np
import pytest

from millcorr.app import batch, compat, correction, demonstration, dressup, measurement_object, motion, rounds
from millcorr.errors import RefusedError, UsageError


def program_of(obj):
    return motion.program_of_path(compat.path_of(obj), obj.Label)


@pytest.fixture
def measured(write, tmp_path):
    """A part that was cut with a path, wrong by a constant and by the waves of `write_measurement`."""

    def measure(obj, name, shift):
        write(tmp_path / name, program_of(obj), demonstration.TOOL_DIAMETER / 2, shift=shift)
        return measurement_object.create(obj.Document, tmp_path / name, "contact")

    return measure


def moves(obj):
    """The path without comments, as numbers."""
    program = program_of(obj)
    return np.nan_to_num(program.toolpath.end)


def valid(obj):
    return "Invalid" not in obj.State


@pytest.fixture
def first(part_files, measured):
    doc = FreeCAD.openDocument(str(part_files[0]))
    base = batch.find_operation(doc)
    obj = dressup.create(base, measured(base, "one.csv", 0.02), Filter="mean:5", Gain=0.8)
    doc.recompute()
    return doc, base, obj


@pytest.fixture
def twice(first, measured):
    doc, _, obj = first
    once = moves(obj)
    dressup.add(obj, measured(obj, "two.csv", -0.005), Filter="none", Gain=1.0)
    doc.recompute()
    return doc, obj, once


def stacked(part_files, measured):
    """The same two rounds as two dressups, one over the other, as earlier versions made them."""
    doc = FreeCAD.openDocument(str(part_files[0]))
    base = batch.find_operation(doc)
    lower = dressup.create(base, measured(base, "one.csv", 0.02), Filter="mean:5", Gain=0.8)
    doc.recompute()
    part = measured(lower, "two.csv", -0.005)
    upper = dressup.create(lower, part, Filter="none", Gain=1.0)
    doc.recompute()
    return doc, lower, upper


def test_a_second_part_is_added_and_the_first_correction_stays(twice, part_files, measured):
    doc, obj, once = twice
    job = compat.jobs(doc)[0]
    assert [o.Label for o in compat.operations(job)] == ["Profile corrected, 2 parts"]
    assert valid(obj) and obj.Base.Label == "Profile" and not list(obj.Warnings) and not dressup.doubts_of(obj)
    assert [part.Label for part in rounds.parts_of(obj)] == ["one.csv", "two.csv"]
    path = moves(obj)
    FreeCAD.closeDocument(doc.Name)
    _, lower, upper = stacked(part_files, measured)
    # What two dressups do, one over the other.
    assert np.abs(moves(lower) - once).max() < 1e-9
    assert np.abs(moves(upper) - path).max() < 1e-9
    assert np.abs(path - once).max() > 0.003


def test_parts_are_switched_off_and_on(twice):
    doc, obj, once = twice
    both = moves(obj)
    one, two = rounds.parts_of(obj)
    dressup.switch(obj, two, False)
    doc.recompute()
    assert obj.Label == "Profile corrected, 1 of 2 parts" and obj.Source == "one.csv"
    assert np.abs(moves(obj) - once).max() < 1e-9 and not list(obj.Warnings)
    dressup.switch(obj, two, True)
    doc.recompute()
    assert obj.Label == "Profile corrected, 2 parts" and obj.Source == "two.csv"
    assert np.abs(moves(obj) - both).max() < 1e-9 and not list(obj.Warnings)
    # Without the first the second was cut with another path, and that is said.
    dressup.switch(obj, one, False)
    doc.recompute()
    assert valid(obj) and any("not the one the measured part was cut with" in text for text in obj.Warnings)
    dressup.switch(obj, two, False)
    doc.recompute()
    assert valid(obj) and obj.Label == "Profile corrected, 0 of 2 parts" and obj.LargestCorrection.Value == 0
    for part in (one, two):
        dressup.switch(obj, part, True)
    doc.recompute()
    assert np.abs(moves(obj) - both).max() < 1e-9 and not list(obj.Warnings)


def test_saved_and_opened_it_is_the_same(twice, tmp_path):
    doc, obj, _ = twice
    both = moves(obj)
    doc.saveAs(str(tmp_path / "twice.FCStd"))
    FreeCAD.closeDocument(doc.Name)
    doc = FreeCAD.openDocument(str(tmp_path / "twice.FCStd"))
    obj = doc.getObject("DressupMillcorr")
    obj.touch()
    doc.recompute()
    assert valid(obj) and not list(obj.Warnings) and np.abs(moves(obj) - both).max() < 1e-6


def test_the_path_that_a_part_was_cut_with_is_kept(twice):
    """Another millcorr may correct differently: what a later part was cut with is not computed again."""
    doc, obj, _ = twice
    both = moves(obj)
    said = json.loads(obj.EarlierRounds[0])
    assert said["parts"] == 1 and said["settings"]["Gain"] == 0.8 and said["settings"]["Filter"] == "mean:5"
    said["settings"]["Gain"] = 0.1
    obj.EarlierRounds = [json.dumps(said)]
    doc.recompute()
    assert np.abs(moves(obj) - both).max() < 1e-9
    # Only while the operation's own path is the same.
    said["begun"] = "another"
    obj.EarlierRounds = [json.dumps(said)]
    doc.recompute()
    assert np.abs(moves(obj) - both).max() > 0.003
    assert any("not the one the measured part was cut with" in text for text in obj.Warnings)


def test_a_changed_operation_moves_all_rounds_and_is_told(twice):
    doc, obj, _ = twice
    base = obj.Base
    base.setExpression("FinalDepth", None)
    base.FinalDepth = -2.0
    doc.recompute()
    assert valid(obj) and any("not the one the measured part was cut with" in text for text in obj.Warnings)
    # It came with a recompute, so the user does not know of it yet.
    assert dressup.doubts_of(obj) == [dressup.changed("Profile")]
    dressup.take_note(obj)
    assert not dressup.doubts_of(obj)
    assert np.nanmin(program_of(obj).toolpath.end[:, 2]) == pytest.approx(-2.0)


def test_the_same_part_is_not_added_twice(first, tmp_path):
    doc, _, obj = first
    with pytest.raises(UsageError, match="is a measured part of Profile corrected already"):
        dressup.add(obj, obj.Measurement)
    # Nor its points under another name: they are in the path.
    again = measurement_object.create(doc, tmp_path / "one.csv", "contact", name="again.csv")
    dressup.add(obj, again)
    doc.recompute()
    assert not valid(obj) and not obj.Path.Commands


def test_a_label_of_the_user_stays(first, measured):
    doc, _, obj = first
    obj.Label = "Outline"
    dressup.add(obj, measured(obj, "two.csv", -0.005))
    assert obj.Label == "Outline"


def test_a_batch_adds_to_the_correction_that_is_there(first, write, tmp_path):
    doc, _, obj = first
    write(tmp_path / "two.csv", program_of(obj), demonstration.TOOL_DIAMETER / 2, shift=-0.005)
    result = batch.correct_document(doc, measured=tmp_path / "two.csv", points="contact", gcode=tmp_path / "two.nc")
    assert result.summary()["points"]["used"] == 200
    assert [o.Label for o in doc.Objects if o.Name.startswith("DressupMillcorr")] == ["Profile corrected, 2 parts"]
    # The label stands in a comment of the program.
    assert "begin operation: Profile corrected, 2 parts" in (tmp_path / "two.nc").read_text(encoding="utf-8")
    # A refused part leaves everything as it was.
    before = moves(obj)
    with pytest.raises(RefusedError, match="this measurement was applied"):
        batch.correct_document(doc, measured=tmp_path / "one.csv", points="contact")
    assert np.abs(moves(obj) - before).max() == 0 and len(rounds.parts_of(obj)) == 2


def test_documents_with_a_dressup_over_another_work(part_files, measured, write, tmp_path):
    doc, lower, upper = stacked(part_files, measured)
    both = moves(upper)
    for obj in (lower, upper):
        for name in ("EarlierParts", "SwitchedOff", "EarlierRounds"):
            obj.removeProperty(name)
    doc.saveAs(str(tmp_path / "stacked.FCStd"))
    FreeCAD.closeDocument(doc.Name)
    doc = FreeCAD.openDocument(str(tmp_path / "stacked.FCStd"))
    upper = doc.getObject("DressupMillcorr001")
    upper.touch()
    doc.recompute()
    assert valid(upper) and np.abs(moves(upper) - both).max() < 1e-6
    # A third part goes to the upper one.
    write(tmp_path / "three.csv", program_of(upper), demonstration.TOOL_DIAMETER / 2, shift=0.004)
    batch.correct_document(doc, measured=tmp_path / "three.csv", points="contact")
    assert len(rounds.parts_of(upper)) == 2 and len(doc.findObjects("Path::FeaturePython")) >= 3


def test_a_correction_is_asked_in_a_thread_once(twice):
    """Panels prepare in the window's thread and compute in another one."""
    _, obj, _ = twice
    finish = correction.prepared(obj)
    found = finish()
    assert found.result is finish().result and len(found.cuts) == 2
