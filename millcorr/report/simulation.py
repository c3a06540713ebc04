# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report of a simulated program: a table of every signal, plots, and a page in which it is cut."""

from __future__ import annotations

import datetime
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from millcorr.arrays import Bools, Floats
from millcorr.messages import message, option, xy
from millcorr.process.engagement import Engagement
from millcorr.process.prediction import Simulation
from millcorr.process.prediction.signals import Signals, csv_lines
from millcorr.production.simulation import Study
from millcorr.whole_file import write_together

from . import reader, remedies, simulation_view
from . import wall as report_wall
from .plots import standalone
from .simulation_page import page

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


def write(study: Study, directory: Path, *, date: datetime.date | None = None) -> str:
    """Write what happens in a study.

    Parameters
    ----------
    study : Study
    directory : Path
        Made if it is not there. Gets simulation.html, signals.csv, predicted.csv, simulation.json and the plots as
        SVG; with heights also wall.csv: see `FILES`. All are replaced together.
    date : datetime.date, optional
        Date on the page; today by default.

    Returns
    -------
    str
        What was found, in a few lines.

    Raises
    ------
    UsageError, OSError
        If the directory cannot be written to.
    """
    before, after, signals, wall = study.before, study.after, study.signals, study.wall
    notes = [message("No corrected path is shown: ", study.refused)] if study.refused else []
    plots = {
        "load": simulation_view.load_plot(signals),
        "axes": simulation_view.axis_plot(signals),
        "contour": simulation_view.contour_plot(before, after),
    }
    figures = summary(before, after, signals, study.rigid)
    figures["wall"] = None if wall is None else report_wall.summary(wall)
    figures |= remedies.summary(study)
    sections: list[str] = []
    if wall is not None:
        plots["wall"] = report_wall.curves(wall)
        sections.append(report_wall.section(wall, plots["wall"]))
    sections += remedies.sections(study)
    day = date or datetime.date.today()
    texts: dict[str, Iterable[str]] = {
        "signals.csv": csv_lines(signals),
        "predicted.csv": _predicted_lines(before, after),
        "simulation.json": [json.dumps(figures, indent=1, ensure_ascii=False, allow_nan=False) + "\n"],
        **({} if wall is None else {"wall.csv": report_wall.csv_lines(wall)}),
        **{f"{name}.svg": [standalone(plot)] for name, plot in plots.items()},
        "simulation.html": [page(study.request, before, after, signals, plots, figures, notes, day, sections)],
    }
    write_together(directory, texts)
    return "\n".join(
        [
            f"steps       {len(signals)} on {reader.length(figures['path_length_mm'], '.1f')} of path, "
            f"{figures['time_s']:.1f} s",
            f"arc         {figures['arc_deg']['median']:.2f} degrees typically, "
            f"{figures['arc_deg']['max']:.2f} at most",
            f"force       {figures['force_n']['median']:.0f} N typically, {figures['force_n']['max']:.0f} N at most",
            f"unbent      arc {figures['rigid']['arc_deg']['median']:.2f} degrees typically, "
            f"{figures['rigid']['arc_deg']['max']:.2f} at most; load at most {figures['rigid']['load_ratio_max']:.2f} "
            "times the typical one",
            f"error       {_span(figures['predicted_error_mm']['min'], figures['predicted_error_mm']['max'])} predicted"
            + ("" if after is None else f"; corrected at most {reader.small(after.largest, '.1f')}"),
            *_axes_in_words(before),
            *(() if wall is None else report_wall.in_words(wall)),
            *remedies.in_words(study),
            *(f"warning     {reader.worded(text)}" for text in (*before.cautions, *notes)),
            f"report      {directory / 'simulation.html'}",
        ]
    )


def _axes_in_words(before: Simulation) -> list[str]:
    """What the axes leave, and where it is most."""
    if before.motion is None:
        return []
    k, d = before.kinematic, before.deviation
    place = reader.unit().coordinates(xy(*d.foot[int(np.argmax(np.abs(k)))]))
    return [
        message(
            f"axes        leave {_span(k.min(), k.max())} of it, most at ",
            f"{place}; a moved path takes out what arcs lose, at corners slower feeds do (",
            option("slowed"),
            ")",
        )
    ]


def _span(least: float, most: float) -> str:
    """From one deviation to another, given in mm."""
    return f"{reader.small(least, '+.1f').split()[0]} to {reader.small(most, '+.1f')}"


def summary(before: Simulation, after: Simulation | None, signals: Signals, rigid: Engagement) -> dict[str, Any]:
    """Contents of simulation.json; `rigid` is the engagement of a machine that does not give way."""
    cutting = signals.area > 0
    loaded = rigid.area[rigid.area > 0]

    def spread(values: Floats, where: Bools = cutting) -> dict[str, float]:
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
