# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a simulation: figures, plots, and cutter, stock and signals running together.

It needs nothing but itself: plain script in the page, no font, no network.
"""

from __future__ import annotations

import datetime
import json
from collections.abc import Mapping, Sequence
from html import escape
from pathlib import PurePath
from typing import Any

import numpy as np

from millcorr.arrays import Floats
from millcorr.messages import phrase
from millcorr.pipeline import Request
from millcorr.process.prediction import Simulation
from millcorr.process.prediction.signals import Signals

from . import reader
from .html import figure, heading, html_facts, html_notes, html_page, html_tiles, with_unit
from .plots import Plot
from .simulation_script import LOOKS, SCRIPT
from .simulation_view import magnification, outlines, stock_rings, surface_of, thinned


def page(
    request: Request,
    before: Simulation,
    after: Simulation | None,
    signals: Signals,
    plots: Mapping[str, Plot],
    figures: Mapping[str, Any],
    notes: Sequence[str],
    date: datetime.date,
    sections: Sequence[str] = (),
) -> str:
    """The page as HTML.

    Parameters
    ----------
    request : Request
    before : Simulation
    after : Simulation or None
        Of the corrected program.
    signals : Signals
        Of the program as it came.
    plots : mapping of str to Plot
        Its ``load``, ``axes`` and ``contour``.
    figures : mapping
        As in simulation.json.
    notes : sequence of str
        Statements for the top.
    date : datetime.date
    sections : sequence of str
        Further parts of the page as HTML.
    """
    setup = PurePath(before.setup.source).name or "setup"
    cautions = "".join(f"<li>{escape(reader.worded(text))}</li>" for text in before.cautions)
    tiles = [
        (f"{figures['force_n']['max']:.0f} N", f"largest mean force; typically {figures['force_n']['median']:.0f} N"),
        (
            f"{figures['arc_deg']['max']:.1f}\N{DEGREE SIGN}",
            f"largest engaged arc; typically {figures['arc_deg']['median']:.1f}\N{DEGREE SIGN}",
        ),
        (
            f"{figures['rigid']['load_ratio_max']:.2f}",
            "largest load over the typical one, by the shape of the cut alone",
        ),
        (with_unit(before.largest), "largest predicted error" + _corrected(after)),
    ]
    parts = [
        html_notes(notes),
        html_tiles(tiles),
        f"<section class=warnings><b>How far to trust it</b><ul>{cautions}</ul></section>" if cautions else "",
        _STAGE,
        heading(phrase("Force, engaged arc and feed")) + figure(plots["load"]),
        heading(phrase("Forces and deflections of the axes")) + figure(plots["axes"]),
        heading(phrase("Contours and paths")) + figure(plots["contour"]),
        *sections,
        heading(phrase("Setup")) + html_facts(_facts(before, setup)),
    ]
    data = json.dumps(animation(before, after, signals), separators=(",", ":"), allow_nan=False)
    return html_page(
        "Simulated, not measured",
        PurePath(request.program.name).name,
        parts,
        about="simulated",
        files="Every signal at every step is in <b>signals.csv</b>, the predicted surface in <b>predicted.csv</b>, "
        "figures in <b>simulation.json</b>.",
        date=date,
        style=LOOKS,
        scripts=f"<script type=application/json id=data>{data}</script><script>{SCRIPT}</script>",
    )


_STAGE = """<section class=stage id=stage tabindex=0 aria-label="Animation of the cut">
<canvas id=scene></canvas>
<div class=controls><button id=play type=button>Play</button>
<input id=scrub type=range min=0 max=1000 value=0 step=any aria-label="Place along the path">
<label>speed <select id=speed><option value=0.25>1/4<option value=1 selected>real time<option value=4>4 times
<option value=16>16 times</select></label></div>
<p class=readout id=readout></p>
<canvas id=scope></canvas>
<p class=small>Space plays and pauses, arrow keys step, a click on a signal goes there.</p></section>"""


def _corrected(after: Simulation | None) -> str:
    return "" if after is None else f"; {with_unit(after.largest)} after the correction shown"


def _along(rows: tuple[tuple[float, float, float], ...]) -> str:
    return "".join(f"; at s = {reader.length(s)} {kx:.0f}, {ky:.0f}" for s, kx, ky in rows)


def _facts(before: Simulation, setup: str) -> list[tuple[str, str]]:
    s = before.setup
    kx, ky = s.machine.stiffness()
    m = s.material
    return [
        ("File", setup),
        ("Tool", f"diameter {reader.length(s.tool.diameter_mm)}, {s.tool.flutes} teeth, {s.tool.spindle_rpm:g} rpm"),
        ("Material", m.name or "not named"),
        ("Cutting coefficients", f"Ktc {m.ktc_n_per_mm2:g}, Krc {m.krc_n_per_mm2:g} N/mm\N{SUPERSCRIPT TWO}"),
        ("Stiffness", f"X {kx:g} N/mm, Y {ky:g} N/mm{_along(s.machine.stiffness_along)}"),
        ("Feed", "of the actual motion" if before.motion is not None else "as programmed: the setup names no inertia"),
        ("Elastic loop", f"closed within {with_unit(before.elastic.accuracy)}"),
    ]


def animation(before: Simulation, after: Simulation | None, signals: Signals) -> dict[str, Any]:
    """What the script draws: numbers rounded to what a screen can show, mm and s; strips in the reader's units."""
    rows = thinned(len(signals))
    radius = before.elastic.engagement.radius
    actual, commanded = signals.actual[rows], signals.commanded[rows, :2]
    low, high = actual.min(axis=0) - 1.7 * radius, actual.max(axis=0) + 1.7 * radius
    box = (float(low[0]), float(low[1]), float(high[0]), float(high[1]))
    usual = float(np.median(np.hypot(*np.diff(commanded, axis=0).T))) if len(rows) > 1 else 1.0
    begins = np.concatenate([[True], np.hypot(*np.diff(commanded, axis=0).T) > max(4 * usual, 2.0)])
    times = magnification(before, after)
    e = before.elastic.engagement
    turn = -1.0 if e.clockwise else 1.0

    def angle(immersion: Floats) -> Floats:
        # From immersion to an angle in the plane: pi/2 is straight ahead.
        out: Floats = e.direction[rows] + turn * (immersion[rows] - np.pi / 2)
        return np.nan_to_num(out, nan=0.0)

    def line(points: Floats) -> Any:
        return _listed(points, 3)

    strips = [
        ("mean force", "N", [signals.resultant], [""]),
        ("engaged arc", "\N{DEGREE SIGN}", [np.degrees(signals.arc)], [""]),
        ("feed", reader.feed(), [reader.feed_in_unit(signals.feed)], [""]),
        ("force", "N", list(signals.force.T), ["Fx", "Fy"]),
        ("deflection", reader.fine(), list(reader.fine_per_mm() * signals.deflection.T), ["dx", "dy"]),
    ]
    return {
        "unit": {"name": reader.coarse(), "mm": reader.unit().mm},
        "box": _listed(np.array(box), 3),
        "radius": radius,
        "clockwise": bool(e.clockwise),
        "stock": [line(ring) for ring in stock_rings(before.stock, box, radius)],
        "nominal": [line(points) for points in outlines(before.nominal)],
        "machined": [line(part) for part in surface_of(before, times)],
        "corrected": [] if after is None else [line(part) for part in surface_of(after, times)],
        "times": times,
        "actual": line(actual),
        "begins": np.flatnonzero(begins).tolist(),
        "from": _listed(angle(e.entry), 3),
        "to": _listed(angle(e.exit), 3),
        "cuts": (e.phi[rows] > 0).astype(int).tolist(),
        "t": _listed(signals.t[rows] - signals.t[0], 4),
        "s": _listed(signals.s[rows], 3),
        "line": signals.line[rows].tolist(),
        "force": line(signals.force[rows]),
        "strips": [
            {"name": name, "unit": unit, "labels": labels, "values": [_listed(v[rows], 2) for v in values]}
            for name, unit, values, labels in strips
        ],
    }


def _listed(values: Floats, digits: int) -> Any:
    return np.round(values, digits).tolist()
