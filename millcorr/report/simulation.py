# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report of a simulated program: a table of every signal, plots, and a page in which it is cut."""

from __future__ import annotations

import datetime
import json
from collections.abc import Iterable, Sequence
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from millcorr import pipeline
from millcorr.engagement import Engagement, engagement
from millcorr.errors import RefusedError, UsageError
from millcorr.kinematics import read_trace
from millcorr.prediction import Simulation
from millcorr.prediction.corner_feed import CornerFeeds
from millcorr.prediction.logged_machine import LoggedMachine, logged_machine
from millcorr.prediction.signals import Signals, csv_lines
from millcorr.remedy_programs import TiltedProgram, shifted_program, slowed, tilted_program
from millcorr.simulation import simulated
from millcorr.whole_file import replaced_whole, write_together

from . import simulation_view
from . import wall as report_wall
from .plots import MICRO, UM, standalone
from .remedies import Asked, Done
from .simulation_page import page

Floats = NDArray[np.float64]

FILES = (
    "simulation.html",
    "simulation.json",
    "signals.csv",
    "predicted.csv",
    "wall.csv",
    "load.svg",
    "axes.svg",
    "contour.svg",
    "wall.svg",
)
"""What a report may consist of."""

NOTHING = Asked()


def write(
    request: pipeline.Request,
    directory: Path,
    *,
    date: datetime.date | None = None,
    heights: Sequence[float] = (),
    asked: Asked = NOTHING,
) -> str:
    """Simulate a program and its correction, and write what happens.

    Parameters
    ----------
    request : Request
        With a setup and method ``predicted``.
    directory : Path
        Made if it is not there. Gets simulation.html, signals.csv, predicted.csv, simulation.json and the plots as
        SVG; with heights also wall.csv: see `FILES`. All are replaced together.
    date : datetime.date, optional
        Date on the page; today by default.
    heights : sequence of float
        mm above the tool's tip at which the wall is wanted; none leaves it out.
    asked : Asked, optional
        Remedies to write as programs, and a log of the machine.

    Returns
    -------
    str
        What was found, in a few lines.

    Raises
    ------
    MillcorrError
        If program or setup cannot be used, or a remedy is refused; nothing is written then. A correction that is
        refused is only not shown.
    """
    wanted = report_wall.heights_of(heights)
    if asked.tilted is not None and len(wanted) < 2:
        raise UsageError("--tilted needs --heights MM at two heights at least: the tool leans by the wall's slope")
    if asked.shifted is not None and not len(wanted):
        raise UsageError("--shifted needs --heights MM: the contour is moved by the wall's mean error over them")
    request, machine = _as_logged(request, asked)
    before, after, refused = simulated(request)
    notes = [f"No corrected path is shown: {refused}"] if refused else []
    signals = Signals.of(before, request.program)
    plots = {
        "load": simulation_view.load_plot(signals),
        "axes": simulation_view.axis_plot(signals),
        "contour": simulation_view.contour_plot(before, after),
    }
    rigid = engagement(before.feed.toolpath, before.setup, before.stock)
    figures = summary(before, after, signals, rigid)
    wall = report_wall.wall_of(request.program, before, wanted) if len(wanted) else None
    figures["wall"] = None if wall is None else report_wall.summary(wall)
    done = Done(
        asked,
        _slowed(request, before, asked),
        None if wall is None or asked.shifted is None else shifted_program(request, before, wall.before),
        None if wall is None or asked.tilted is None else _tilted(request, before, wall),
        machine,
    )
    figures |= done.summary()
    sections: list[str] = []
    if wall is not None:
        plots["wall"] = report_wall.curves(wall)
        sections.append(report_wall.section(wall, plots["wall"]))
    sections += done.sections()
    texts: dict[str, Iterable[str]] = {
        "signals.csv": csv_lines(signals),
        "predicted.csv": _predicted_lines(before, after),
        "simulation.json": [json.dumps(figures, indent=1, ensure_ascii=False, allow_nan=False) + "\n"],
        **({} if wall is None else {"wall.csv": report_wall.csv_lines(wall)}),
        **{f"{name}.svg": [standalone(plot)] for name, plot in plots.items()},
        "simulation.html": [
            page(request, before, after, signals, plots, figures, notes, date or datetime.date.today(), sections)
        ],
    }
    with ExitStack() as stack:
        for place, data in done.outputs().items():
            stack.enter_context(replaced_whole(place, data))
        write_together(directory, texts)
    return "\n".join(
        [
            f"steps       {len(signals)} on {figures['path_length_mm']:.1f} mm of path, {figures['time_s']:.1f} s",
            f"arc         {figures['arc_deg']['median']:.2f} degrees typically, "
            f"{figures['arc_deg']['max']:.2f} at most",
            f"force       {figures['force_n']['median']:.0f} N typically, {figures['force_n']['max']:.0f} N at most",
            f"unbent      arc {figures['rigid']['arc_deg']['median']:.2f} degrees typically, "
            f"{figures['rigid']['arc_deg']['max']:.2f} at most; load at most {figures['rigid']['load_ratio_max']:.2f} "
            "times the typical one",
            f"error       {UM * figures['predicted_error_mm']['min']:+.1f} to "
            f"{UM * figures['predicted_error_mm']['max']:+.1f} {MICRO} predicted"
            + ("" if after is None else f"; corrected at most {UM * after.largest:.1f} {MICRO}"),
            *_axes_in_words(before),
            *(() if wall is None else report_wall.in_words(wall)),
            *done.in_words(),
            *(f"warning     {text}" for text in (*before.cautions, *notes)),
            f"report      {directory / 'simulation.html'}",
        ]
    )


def _as_logged(request: pipeline.Request, asked: Asked) -> tuple[pipeline.Request, LoggedMachine | None]:
    """The request with the machine that a log shows."""
    if asked.trace is None or request.setup is None:
        if asked.identify:
            raise UsageError("--identify belongs to --trace TRACE.csv, the log that tells")
        return request, None
    machine = logged_machine(request.setup, request.program, read_trace(asked.trace), asked.identify)
    return replace(request, setup=machine.setup), machine


def _slowed(request: pipeline.Request, before: Simulation, asked: Asked) -> CornerFeeds | None:
    if asked.slowed is None:
        if asked.corner_error is not None:
            raise UsageError("--corner-error belongs to --slowed OUT.nc, the program that keeps it")
        return None
    return slowed(request.program, before.setup, asked.corner_error, request.settings.tolerance)


def _tilted(request: pipeline.Request, before: Simulation, wall: report_wall.Wall) -> TiltedProgram:
    if wall.remedy is None:
        raise RefusedError(f"tilt: {wall.note}")
    return tilted_program(request, before, wall.before, wall.remedy)


def _axes_in_words(before: Simulation) -> list[str]:
    """What the axes leave, and where it is most."""
    if before.motion is None:
        return []
    k, d = before.kinematic, before.deviation
    x, y = d.foot[int(np.argmax(np.abs(k)))]
    return [
        f"axes        leave {UM * k.min():+.1f} to {UM * k.max():+.1f} {MICRO} of it, most at X{x:.3f} Y{y:.3f}; a "
        "moved path takes out what arcs lose, at corners slower feeds do (--slowed)"
    ]


def summary(before: Simulation, after: Simulation | None, signals: Signals, rigid: Engagement) -> dict[str, Any]:
    """Contents of simulation.json; `rigid` is the engagement of a machine that does not give way."""
    cutting = signals.area > 0
    loaded = rigid.area[rigid.area > 0]

    def spread(values: Floats, where: NDArray[np.bool_] = cutting) -> dict[str, float]:
        chosen = values[where] if where.any() else values
        return {"min": float(chosen.min()), "median": float(np.median(chosen)), "max": float(chosen.max())}

    value = before.deviation.value
    return {
        "setup": before.setup.source,
        "path_length_mm": float(signals.s[-1]),
        "time_s": float(signals.t[-1] - signals.t[0]),
        "feed_mm_min": spread(60 * signals.feed),
        "feed_per_tooth_mm": spread(signals.feed_per_tooth),
        "arc_deg": spread(np.degrees(signals.arc)),
        "force_n": spread(signals.resultant),
        "rigid": {
            "arc_deg": spread(np.degrees(rigid.phi), rigid.area > 0),
            "load_ratio_max": float(loaded.max() / np.median(loaded)) if len(loaded) else 0.0,
        },
        "predicted_error_mm": {"min": float(value.min()), "mean": float(value.mean()), "max": float(value.max())},
        "kinematic_error_mm": None
        if before.motion is None
        else {"min": float(before.kinematic.min()), "max": float(before.kinematic.max())},
        "predicted_error_after_mm": None if after is None else after.largest,
        "loop_accuracy_mm": before.elastic.accuracy,
        "stiffness_n_per_mm": list(before.setup.machine.stiffness()),
        "cautions": list(before.cautions),
    }


def _predicted_lines(before: Simulation, after: Simulation | None) -> list[str]:
    """Lines of predicted.csv: the surface that is left, in mm; the header first."""
    d = before.deviation
    corrected = np.full(len(d), np.nan) if after is None else after.error_at(d.contour, d.s)
    lines = ["contour,s,x,y,nx,ny,deviation,deviation_corrected,kinematic\n"]
    table = np.column_stack([d.s, d.foot, d.normal, d.value, corrected, before.kinematic])
    for contour, row in zip(d.contour.tolist(), table.tolist(), strict=True):
        lines.append(f"{contour}," + ",".join("" if v != v else f"{v:.9g}" for v in row) + "\n")
    return lines
