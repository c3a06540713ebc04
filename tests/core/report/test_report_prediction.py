# SPDX-License-Identifier: LGPL-2.1-or-later
"""What page and console say where a correction was predicted, or combined with touches."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from millcorr import pipeline
from millcorr.__main__ import main
from millcorr.report.page import page
from tests.core.paper_2023 import LEFT, PROGRAM, RADIUS, SETUP, as_cut, program, setup, touched
from tests.core.report.test_report import Page


def corrected(measurement=None, **chosen):
    settings = replace(LEFT, **chosen)
    return pipeline.correct(pipeline.Request(program(), RADIUS, measurement, None, settings, setup=setup()))


@pytest.fixture(scope="module")
def predicted():
    return corrected(method="predicted", iterate=0.02)


@pytest.fixture(scope="module")
def combined():
    return corrected(touched(as_cut(), (0.0, -10.0)), method="combined")


def um(value):
    return f"{1000 * value:.2f}"


def test_a_predicted_surface_is_not_called_measured(predicted):
    text = Page(page(predicted)).text
    assert "Nothing was measured: the model of petrakov-2023.toml leaves" in text
    count = len(predicted.deviation)
    assert f"{count} points of the simulated surface" in text and "Every simulated point is in" in text
    for wrong in ("measured point", "points read", "What repeats", "random part", "Depth of the measured part"):
        assert wrong not in text
    assert "simulated surfacepredicted from petrakov-2023.toml" in text


def test_rounds_and_expected_errors_are_tabled(predicted):
    """Two rounds of the paper's part: 0.300 mm, then 0.048 (docs/combined-control.md), then less than was asked for."""
    text = Page(page(predicted)).text
    prediction = predicted.prediction
    first, second = (one.largest for one in prediction.after)
    assert first == pytest.approx(0.048, abs=5e-4) and second <= 0.02
    assert f"before{um(prediction.before.largest)}" in text
    for k, one in enumerate(prediction.after, 1):
        assert f"after round {k}{um(one.largest)}" in text
    assert "Corrected and simulated2 times, until at most 20.00 µm are expected" in text
    assert "stiffness X 1200 N/mm, Y 1200 N/mm" in text
    # The allowance of the setup is the depth that its transfer function was taken at.
    assert "Depth of the simulated part3 mm" in text and predicted.summary()["transfer"]["depth"] == [3.0]


def test_touches_stay_measured_points_and_the_model_has_its_section(combined):
    """0.0901 mm are left of 3: MS = 0.0901 / 2.9099 = 0.0310 on both axes."""
    text = Page(page(combined)).text
    assert "1 measured point (touches.csv) shows deviations of" in text and "Nothing was measured" not in text
    assert "Predicted by the model" in text and "MSx 0.0310, MSy 0.0310 at the first touch" in text
    assert "do not tell the axes apart" in text and "Depth of the touched part3.000 mm" in text
    prediction = combined.prediction
    assert f"expects at most {um(prediction.before.largest)} µm along the whole contour before" in text
    assert f"after{um(prediction.after[-1].largest)}" in text and "Corrected and simulated1 time" in text
    assert "Taken asMSx and MSy of the touches" in text
    assert combined.summary()["transfer"]["taken"] == "by axis"


def test_the_console_names_the_depth(tmp_path, capsys):
    (tmp_path / "part.nc").write_text(PROGRAM)
    arguments = ["--program", str(tmp_path / "part.nc"), "--setup", str(SETUP), "--side", "left"]
    assert main(["check", *arguments, "--method", "predicted", "--report", str(tmp_path / "report")]) == 0
    told = capsys.readouterr().out
    assert "depth 3 mm, next 3 mm" in told and "of the simulated surface; nothing was measured" in told
    assert json.loads((tmp_path / "report" / "report.json").read_text())["transfer"]["depth"] == [3.0]
