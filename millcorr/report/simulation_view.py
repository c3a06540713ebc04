# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of a simulated program: both oscilloscopes and the contour (petrakov-2023, figs. 5, 6, 8), and its stock."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely

from millcorr.arrays import Bools, Floats, Ints
from millcorr.comparison.deviation import REACH
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.process.engagement.stock_region import StockRegion
from millcorr.process.prediction import Simulation
from millcorr.process.prediction.signals import Signals

from . import reader
from .magnification import bound_of
from .plots import WIDTH, Plot
from .svg import Axis, Canvas, number, polyline, round_down

STRIP = 118.0
"""Height of one signal's strip, in pixels."""

MOST = 4000
"""Steps beyond which a drawing is thinned to every second, third, ... one."""

SHARE = 0.08
"""The largest deflection or correction is drawn as long as this share of the picture, at most."""

SHORT = 0.02
"""Sides of what stands for curves in pictures, mm."""


@dataclass(frozen=True, slots=True)
class Trace:
    """One line of an oscilloscope: name, unit, style class, values."""

    name: str
    unit: str
    css: str
    values: Floats


def thinned(count: int) -> Ints:
    """Rows to draw of so many."""
    step = max(1, -(-count // MOST))
    rows = np.arange(0, count, step)
    return np.append(rows, count - 1) if count and rows[-1] != count - 1 else rows


def load_strips(signals: Signals) -> list[list[Trace]]:
    """Force, engaged arc and feed (fig. 5)."""
    feed = [Trace("feed", reader.feed(), "filtered", reader.feed_in_unit(signals.feed))]
    if np.abs(signals.programmed - signals.feed).max(initial=0.0) > 1e-9:
        feed.append(Trace("feed as programmed", reader.feed(), "predicted", reader.feed_in_unit(signals.programmed)))
    return [
        [Trace("mean force", "N", "filtered", signals.resultant)],
        [Trace("engaged arc", "\N{DEGREE SIGN}", "filtered", np.degrees(signals.arc))],
        feed,
    ]


def axis_strips(signals: Signals) -> list[list[Trace]]:
    """Force and deflection along both axes (fig. 6)."""
    return [
        [Trace(f"F{n}", "N", css, signals.force[:, k]) for k, (n, css) in enumerate(_AXES)],
        [
            Trace(f"d{n}", reader.fine(), css, reader.fine_per_mm() * signals.deflection[:, k])
            for k, (n, css) in enumerate(_AXES)
        ],
    ]


_AXES = (("x", "excess"), ("y", "undercut"))


def oscilloscope(signals: Signals, strips: list[list[Trace]], title: str, caption: str) -> Plot:
    """Strips of signals over the path length, one above the other."""
    canvas = Canvas(WIDTH, 22 + len(strips) * (STRIP + 22) + 30, title)
    rows = thinned(len(signals))
    s = signals.s[rows] / reader.unit().mm
    x = Axis(float(s[0]), float(max(s[-1], s[0] + 1e-6)), 62, WIDTH - 14)
    for i, traces in enumerate(strips):
        top = 22 + i * (STRIP + 22)
        shown = np.concatenate([trace.values[rows] for trace in traces])
        low, high = min(0.0, float(np.nanmin(shown))), max(0.0, float(np.nanmax(shown)))
        room = max(high - low, 1e-6)
        y = Axis(low - 0.06 * room, high + 0.06 * room, top + STRIP, top)
        for value in y.ticks(4):
            canvas.line(x.start, y.at(value), x.end, y.at(value), "zero" if value == 0 else "grid")
            canvas.text(x.start - 6, y.at(value) + 4, number(value), anchor="end")
        for value in x.ticks(10):
            canvas.line(x.at(value), y.start, x.at(value), y.start + 4, "axis")
            if i == len(strips) - 1:
                canvas.text(x.at(value), y.start + 16, number(value), anchor="middle")
        canvas.line(x.start, y.start, x.end, y.start, "axis")
        for trace in traces:
            canvas.path(polyline(x(s), y(trace.values[rows])), trace.css)
        words = [(f"{t.name} / {t.unit}", [(t.css, "m-9 0h18")]) for t in traces]
        canvas.legend(x.start, top - 6, words)
    canvas.text((x.start + x.end) / 2, canvas.height - 6, f"path length / {reader.coarse()}", anchor="middle")
    return Plot(str(canvas), caption)


def load_plot(signals: Signals) -> Plot:
    """First oscilloscope."""
    words = "Mean cutting force over a turn, engaged arc, and the feed that the machine runs, over the path length."
    return oscilloscope(signals, load_strips(signals), "Force, engaged arc and feed", words)


def axis_plot(signals: Signals) -> Plot:
    """Second oscilloscope."""
    words = "Forces on the tool along the axes, and how far tool and machine give way."
    return oscilloscope(signals, axis_strips(signals), "Forces and deflections of the axes", words)


def outlines(profile: Profile) -> list[Floats]:
    """Points along every contour, for drawing; (n, 2) each, in mm."""
    out = []
    for k, total in enumerate(profile.total):
        count = int(np.clip(float(total) / 0.25, 64, 4000))
        point, _ = profile.at(np.full(count + 1, k), np.linspace(0.0, float(total), count + 1))
        out.append(point)
    return out


def exaggerated(points: Floats, nominal: Profile, base: float, times: float, reach: float) -> Floats:
    """Points with their distance from the profile's parallel at `base` mm drawn larger; NaN beyond `reach` mm of it."""
    feet = FootPointSearch(nominal, margin=base + 2.0 + reach).find(points)
    off = feet.distance - base
    moved = feet.foot + (base + times * off)[:, None] * feet.normal
    out: Floats = np.where((np.abs(off) < reach)[:, None], moved, np.nan)
    return out


def surface_of(simulation: Simulation, times: float) -> list[Floats]:
    """Machined contour, deviations drawn larger; one array a stretch without a gap, (n, 2) in mm."""
    d = simulation.deviation
    order = np.lexsort((d.s, d.contour))
    moved = d.foot + times * d.value[:, None] * d.normal
    step = np.hypot(*np.diff(d.foot[order], axis=0).T)
    usual = float(np.median(step)) if len(step) else 1.0
    cuts = np.flatnonzero((np.diff(d.contour[order]) != 0) | (step > 4 * usual)) + 1
    return [moved[rows] for rows in np.split(order, cuts)]


def magnification(simulation: Simulation, after: Simulation | None) -> float:
    """How much larger errors, deflections and corrections are drawn."""
    low_x, low_y, high_x, high_y = simulation.nominal.bounding_box()
    size = float(np.hypot(high_x - low_x, high_y - low_y))
    largest = max(simulation.largest, 0.0 if after is None else after.largest, 1e-6)
    surfaces = [one.deviation for one in (simulation, after) if one is not None]
    bound = bound_of(simulation.nominal, [(d.contour, d.value) for d in surfaces])
    return max(1.0, round_down(min(SHARE * size / largest, bound)))


def contour_plot(simulation: Simulation, after: Simulation | None) -> Plot:
    """Theoretical and machined contour, commanded, actual and corrected path (fig. 8)."""
    times = magnification(simulation, after)
    nominal, radius = simulation.nominal, simulation.elastic.engagement.radius
    commanded = simulation.commanded
    reach = REACH + float(np.hypot(*(simulation.centre - commanded).T).max())
    lines: list[tuple[str, str, list[Floats]]] = [
        ("theoretical contour", "nominal", outlines(nominal)),
        ("machined contour", "undercut", surface_of(simulation, times)),
        ("commanded path", "course", _parts(commanded, nominal, radius, times, REACH)),
        ("actual path", "excess", _parts(simulation.centre, nominal, radius, times, reach)),
    ]
    if after is not None:
        lines.append(("corrected path", "way", _parts(after.commanded, nominal, radius, times, reach)))
    size = reader.unit().mm
    lines = [(name, css, [part / size for part in parts]) for name, css, parts in lines]
    shown = np.concatenate([part for _, _, parts in lines for part in parts])
    low, high = np.nanmin(shown, axis=0), np.nanmax(shown, axis=0)
    room = 0.04 * float((high - low).max()) + 1.0 / size
    low, high = low - room, high + room
    height = float(np.clip((WIDTH - 70) * (high - low)[1] / (high - low)[0], 180, 620))
    scale = min((WIDTH - 70) / (high - low)[0], height / (high - low)[1])
    canvas = Canvas(WIDTH, height + 64, "Contours and paths")
    canvas.legend(8, 14, [(name, [(css, "m-9 0h18")]) for name, css, _ in lines])
    x = Axis(low[0], low[0] + (WIDTH - 70) / scale, 56, WIDTH - 14)
    y = Axis(low[1], low[1] + height / scale, 26 + height, 26)
    for value in x.ticks(9):
        canvas.line(x.at(value), y.start, x.at(value), y.end, "grid")
        canvas.text(x.at(value), y.start + 16, number(value), anchor="middle")
    for value in y.ticks(7):
        canvas.line(x.start, y.at(value), x.end, y.at(value), "grid")
        canvas.text(x.start - 6, y.at(value) + 4, number(value), anchor="end")
    for _, css, parts in lines:
        for part in parts:
            canvas.path(polyline(x(part[:, 0]), y(part[:, 1])), css)
    canvas.text((x.start + x.end) / 2, y.start + 32, f"X / {reader.coarse()}", anchor="middle")
    canvas.text(13, (y.start + y.end) / 2, f"Y / {reader.coarse()}", anchor="middle", turn=-90)
    return Plot(
        str(canvas),
        f"Deviations, deflections and corrections are drawn {times:g} times larger than the part.",
    )


def _parts(points: Floats, nominal: Profile, radius: float, times: float, reach: float) -> list[Floats]:
    """Path beside the contour, in parts without a gap."""
    rows = thinned(len(points))
    moved = exaggerated(points[rows], nominal, radius, times, reach)
    known: Bools = np.isfinite(moved[:, 0]) & np.isfinite(moved[:, 1])
    step = np.hypot(*np.diff(points[rows], axis=0).T)
    usual = float(np.median(step)) if len(step) else 1.0
    cuts = np.flatnonzero((known[1:] != known[:-1]) | (step > max(4 * usual, 2.0))) + 1
    return [moved[part] for part in np.split(np.arange(len(rows)), cuts) if known[part[0]] and len(part) > 1]


def stock_rings(stock: StockRegion, box: tuple[float, float, float, float], radius: float) -> list[Floats]:
    """Outlines of the stock for a picture, to be filled by the even-odd rule; (n, 2) each, in mm.

    Parameters
    ----------
    stock : StockRegion
    box : (x0, y0, x1, y1)
        What is shown, mm.
    radius : float
        Cutter's, mm: open contours are shown with so much material behind them.
    """
    frame = shapely.box(*box)
    body = frame if stock.profile is None else _material(stock.profile, stock.allowance, frame, 1.5 * radius)
    for swept in stock.swept:
        pieces = swept.pieces
        u = np.linspace(0.0, 1.0, 33)
        rows = np.repeat(np.arange(len(pieces)), len(u))
        points = pieces.point(rows, np.tile(u, len(pieces))).reshape(len(pieces), len(u), 2)
        body = body.difference(shapely.union_all(shapely.linestrings(points)).buffer(swept.radius))
    polygons = [part for part in shapely.get_parts(body) if part.geom_type == "Polygon"]
    rings = [ring for polygon in polygons for ring in (polygon.exterior, *polygon.interiors)]
    return [shapely.get_coordinates(ring.simplify(SHORT)) for ring in rings]


def _lengthened(line: Floats, frame: shapely.Polygon) -> shapely.LineString:
    """A line that goes on straight at both ends, out of the frame."""
    far = frame.length
    first, last = (d / np.hypot(*d) * far for d in (line[0] - line[1], line[-1] - line[-2]))
    return shapely.LineString(np.vstack([line[0] + first, line, line[-1] + last]))


def _material(profile: Profile, allowance: float, frame: shapely.Polygon, depth: float) -> shapely.Geometry:
    """Material left of contours, with an allowance on it."""
    solid: list[shapely.Geometry] = []
    holes: list[shapely.Geometry] = []
    bands: list[shapely.Geometry] = []
    areas = profile.signed_areas()
    for contour, line, area in zip(profile.contours, outlines(profile), areas, strict=True):
        if contour.closed:
            (solid if area > 0 else holes).append(shapely.Polygon(line).buffer(0))
        else:
            # As the model has it: the part goes on beyond an open end, the allowance ends with a round.
            bands.append(_lengthened(line, frame).buffer(max(depth, allowance), single_sided=True))
            if allowance > 0:
                bands.append(shapely.LineString(line).buffer(allowance))
    closed = shapely.union_all(solid) if solid or not holes else frame
    closed = closed.difference(shapely.union_all(holes)).buffer(allowance, join_style="mitre")
    return closed.union(shapely.union_all(bands)).intersection(frame)
