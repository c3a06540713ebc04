# SPDX-License-Identifier: LGPL-2.1-or-later
"""These tests run inside FreeCADCmd (see run.py); elsewhere there is nothing to collect."""

from __future__ import annotations

import importlib.util

import numpy as np
import pytest

if importlib.util.find_spec("FreeCAD") is None:
    collect_ignore_glob = ["test_*.py"]
else:
    import FreeCAD

    @pytest.fixture
    def document():
        """An empty document."""
        return FreeCAD.newDocument("Test")

    @pytest.fixture(autouse=True)
    def close_documents():
        """No test leaves a document open for the next."""
        yield
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    @pytest.fixture(scope="session")
    def part_files(tmp_path_factory):
        """The demonstration document and its program."""
        from millcorr.app import demonstration

        directory = tmp_path_factory.mktemp("demonstration")
        return demonstration.make(directory / "demo.FCStd", directory / "demo.nc")

    @pytest.fixture(scope="session")
    def measured_file(part_files):
        """Points of a part cut by the demonstration's program with a known error, and that error."""
        from millcorr.app import batch, compat, demonstration, documents, motion

        with documents.opened(part_files[0]) as doc:
            operation = batch.find_operation(doc)
            program = motion.program_of_path(compat.path_of(operation), "demo")
        path = part_files[0].with_name("cmm.csv")
        error = write_measurement(path, program, demonstration.TOOL_DIAMETER / 2)
        return path, error

    @pytest.fixture
    def write():
        """What writes the points of a part cut by a program: `write_measurement`."""
        return write_measurement

    def write_measurement(path, program, radius, count=200, random=0.0, shift=0.0):
        """Write the points at which a cutter touches the part along a program, moved by a smooth error."""
        toolpath = program.toolpath
        arcs = toolpath.take(toolpath.kind == 2)
        t = np.linspace(0.0, 1.0, 400)
        points = arcs.position(t)[:, :, :2]
        radial = points - arcs.centre[:, None, :2]
        outward = radial / np.hypot(radial[..., 0], radial[..., 1])[..., None]
        # Climb milling outside runs clockwise: the part lies to the right, towards the centre of a G2.
        side = np.where(arcs.sweep < 0, -1.0, 1.0)[:, None, None]
        points, inward = points.reshape(-1, 2), (outward * side).reshape(-1, 2)
        length = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
        at = np.searchsorted(length, np.linspace(0.0, length[-1], count, endpoint=False))
        phase = 2 * np.pi * length[at] / length[-1]
        error = 0.006 + shift + 0.004 * np.cos(2 * phase)
        error = error + np.random.default_rng(5).normal(0.0, random, count) if random else error
        touched = points[at] + inward[at] * (radius - error)[:, None]
        lines = ["x,y,z", *(f"{x:.7f},{y:.7f},6.0" for x, y in touched)]
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return error
