# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operations of documents in the model of a setup: simulated, and corrected from touches or before the first cut."""

from __future__ import annotations

import json

import numpy as np
import pytest

from millcorr import freecad_process, nc
from millcorr.app import batch, demonstration, documents, process, simulating
from millcorr.cli import verbs
from millcorr.correction.settings import Settings
from millcorr.errors import UsageError
from millcorr.process import setup_file
from millcorr.process.prediction import simulate

SETUP = f"""\
[tool]
diameter_mm = {demonstration.TOOL_DIAMETER:g}
flutes = 4
spindle_rpm = 3000.0

[material]
ktc_n_per_mm2 = 900.0
krc_n_per_mm2 = 300.0

[machine]
kx_n_per_mm = 6000.0
ky_n_per_mm = 4000.0

[stock]
allowance_mm = 1.0
axial_depth_mm = 6.0
"""


@pytest.fixture
def setup(tmp_path):
    path = tmp_path / "setup.toml"
    path.write_text(SETUP, encoding="utf-8")
    return path


@pytest.fixture
def here(monkeypatch):
    """What the command line asks of another FreeCAD is answered by this one."""
    monkeypatch.setattr(freecad_process, "call", lambda name, arguments: process.FUNCTIONS[name](**arguments))


@pytest.fixture
def as_cut(part_files, setup):
    """The demonstration's operation simulated."""
    with documents.opened(part_files[0]) as doc:
        request = simulating.request_of(batch.find_operation(doc), setup)
    return simulate(request.program, request.setup, request.nominal)


def test_an_operation_is_simulated_from_the_command_line(part_files, setup, here, as_cut, tmp_path):
    report = tmp_path / "simulated"
    wanted = Settings(method="predicted")
    common = {"setup": setup, "report": report, "settings": wanted}
    said = verbs.simulate_program(document=part_files[0], operation="Profile", **common)
    figures = json.loads((report / "simulation.json").read_text(encoding="utf-8"))
    assert figures["predicted_error_mm"]["max"] == pytest.approx(as_cut.deviation.value.max(), rel=1e-9)
    assert figures["predicted_error_after_mm"] < 0.5 * as_cut.largest
    assert "warning     cutting coefficients" in said
    with pytest.raises(UsageError, match="--slowed belongs to --program"):
        verbs.simulate_program(document=part_files[0], asked=verbs.Asked(slowed=tmp_path / "slow.nc"), **common)
    with pytest.raises(UsageError, match="operations called Nothing"):
        verbs.simulate_program(document=part_files[0], operation="Nothing", **common)


def test_combined_control_of_a_document(part_files, setup, as_cut, tmp_path):
    """Four touches of the simulated part give the machine back, and the posted program leaves far less."""
    d = as_cut.deviation
    rows = [int(np.argmax(d.normal @ [np.cos(a), np.sin(a)])) for a in np.arange(4) * np.pi / 2]
    xy = d.foot[rows] + d.value[rows, None] * d.normal[rows]
    lines = ["x,y,z", *(f"{x:.6f},{y:.6f},{z:.3f}" for (x, y), z in zip(xy, d.z[rows] + 3.0, strict=True))]
    touches, report, out = tmp_path / "touches.csv", tmp_path / "report", tmp_path / "out.nc"
    touches.write_text("\n".join(lines) + "\n", encoding="utf-8")
    result = batch.correct_document(
        part_files[0], measured=touches, points="contact", method="combined", setup=str(setup),
        output=tmp_path / "out.FCStd", gcode=out, report=report,
    )  # fmt: skip
    assert result.prediction is not None and result.prediction.axes is not None and result.prediction.axes.separate
    machine = result.prediction.machine
    assert machine is not None
    assert (machine.kx, machine.ky) == pytest.approx((6000.0, 4000.0), rel=0.05)
    summary = json.loads((report / "report.json").read_text(encoding="utf-8"))["foreseen"]
    assert summary["predicted_after"][-1] < 0.5 * summary["predicted_before"]
    again = simulate(nc.read(out), setup_file.load(setup), result.nominal)
    assert again.largest < 0.5 * as_cut.largest


def test_correction_of_a_document_before_the_first_cut(part_files, setup, as_cut, tmp_path):
    out = tmp_path / "first.nc"
    batch.correct_document(part_files[0], method="predicted", setup=str(setup), gcode=out)
    with documents.opened(part_files[0]) as doc:
        request = simulating.request_of(batch.find_operation(doc), setup)
    again = simulate(nc.read(out), request.setup, request.nominal)
    assert again.largest < 0.5 * as_cut.largest
