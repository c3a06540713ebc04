# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutting area of an edge: closed form, the map, and a Z-map swept step by step as the paper has it."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import trapezoid

from millcorr import nc
from millcorr.errors import InputError, UsageError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.process.deflection.real_path import real_path
from millcorr.process.deflection.tooth_map import cutting_area, tooth_map
from millcorr.process.engagement.path_pieces import pieces_of_toolpath
from millcorr.process.engagement.stock_region import StockRegion, Swept
from millcorr.process.setup_file import Tool

TOOL = Tool(10.0, 2, 2000.0, 30.0)
CHIP = 5.0 / TOOL.tooth_frequency
ENTRY = np.pi - np.arccos(1 - 2.0 / 5.0)
WALL = Profile.from_contours([Contour((NurbsCurve.line((500, -5), (-500, -5)),), False)])
STOCK = StockRegion(WALL, 2.0)


def path(text):
    return real_path(nc.parse("G90 G17 G21 F300\n" + text).toolpath)


STRAIGHT = path("G0 X0 Y0\nG1 X1.2")


def test_closed_form():
    """Without helix f_t b sin(phi); with one the area over a pitch is the volume of a tooth's chip over R."""
    straight = Tool(10.0, 2, 2000.0)
    turn = np.array([ENTRY - 0.01, 2.5, 3.0, np.pi + 0.01])
    wanted = [0.0, CHIP * 2.5 * np.sin(2.5), CHIP * 2.5 * np.sin(3.0), 0.0]
    assert cutting_area(turn, ENTRY, np.pi, 0.0, 2.5, CHIP, straight) == pytest.approx(wanted, abs=1e-15)
    fine = np.linspace(2.0, 4.0, 20_001)
    area = cutting_area(fine, ENTRY, np.pi, 0.0, 2.5, CHIP, TOOL)
    assert trapezoid(area, fine) * 5.0 == pytest.approx(CHIP * 2.0 * 2.5, rel=1e-6)


def swept(tool, grid, slices, depth, length, bins, step):
    """Columns removed in every step of rotation, swept one by one: the paper's Z-map, a map for each slice."""
    top = np.pi + np.tan(np.radians(tool.helix_deg)) / tool.radius * depth
    x, y = np.meshgrid(np.arange(-1.0, 7.0, grid) + grid / 2, np.arange(-5.0, -3.0, grid) + grid / 2)
    x, y = x.ravel(), y.ravel()
    there = np.hypot(x, y) > tool.radius
    x, y = x[there], y[there]
    pitch = 2 * np.pi / tool.flutes
    out: dict[int, np.ndarray] = {}
    omega = tool.spindle_rpm / 60 * 2 * np.pi
    for k in range(slices):
        lag = np.tan(np.radians(tool.helix_deg)) / tool.radius * (k + 0.5) * depth / slices
        left = np.arange(len(x))
        turned = 0.0
        while turned < omega * length / 5.0:
            centre = (turned + step / 2) / omega * 5.0
            dx, dy = x[left] - centre, y[left]
            # Immersion angle of a column, clockwise from the left of +X, and of the edges of this step.
            phi = np.pi / 2 - np.arctan2(dy, dx)
            number = (turned + np.pi / 2 - lag - phi) / pitch
            after = (turned + step + np.pi / 2 - lag - phi) / pitch
            hit = (np.floor(after) > np.floor(number)) & (np.hypot(dx, dy) <= tool.radius)
            for edge in np.unique(np.floor(after[hit])):
                mine = hit & (np.floor(after) == edge)
                slot = np.clip(((phi[mine] + lag) * bins / top).astype(int), 0, bins - 1)
                row = out.setdefault(int(edge), np.zeros(bins))
                row += np.bincount(slot, minlength=bins)
            left = left[~hit]
            turned += step
    cell = grid * grid * depth / slices * bins / top / tool.radius
    return {edge: row * cell for edge, row in out.items()}


@pytest.mark.parametrize("helix", [0.0, 30.0])
def test_the_map_swept_step_by_step(helix):
    """Edges that cut from side to side: the same columns, but for those that a step of 1 degree puts to another bin."""
    tool = Tool(10.0, 2, 2000.0, helix)
    slices = 4 if helix else 1
    bins = 24
    found = tooth_map(STRAIGHT, tool, STOCK, 2.5, grid=0.02, slices=slices, bins=bins)
    other = swept(tool, 0.02, slices, 2.5, 1.0, bins, np.radians(1.0))
    volume = CHIP * 2.0 * 2.5
    width = (np.pi + np.tan(np.radians(helix)) / 5.0 * 2.5) / bins
    totals = {edge: row.sum() * width * 5.0 for edge, row in other.items()}
    whole = [edge for edge, total in totals.items() if total > 0.9 * volume]
    assert len(whole) >= 8
    mine = found.area.sum(axis=1) * width * 5.0
    rows = np.flatnonzero(mine > 0.9 * volume)
    # The chip is 0.075 mm to 20 um of a column: single edges find a column more or less at either end of the feed,
    # 4 or 3 of 3.75 along the feed where the surfaces lie along the grid.
    assert mine[rows] == pytest.approx(volume, rel=0.03)
    assert np.mean([totals[e] for e in whole]) == pytest.approx(mine[rows].mean(), rel=0.003)
    mean = np.mean([other[e] for e in whole], axis=0)
    again = found.area[rows].mean(axis=0)
    spread = helix and np.tan(np.radians(helix)) / 5.0 * 2.5 / slices / width
    tolerance = 0.06 if spread else 0.04
    assert np.abs(again - mean).max() < tolerance * mean.max()


@pytest.mark.parametrize("flutes", [2, 4])
def test_the_map_comes_to_the_closed_form(flutes):
    """10 um: the area over the turn of one edge, within what trochoids add (f_t / 2R in angle) and a bin's width."""
    tool = Tool(10.0, flutes, 2000.0, 30.0)
    chip = 5.0 / tool.tooth_frequency
    found = tooth_map(STRAIGHT, tool, STOCK, 2.5)
    rows = np.flatnonzero((found.place[:, 0] > 0.3) & (found.place[:, 0] < 0.9))
    area = found.area[rows].mean(axis=0)
    wanted = cutting_area(found.turn, ENTRY, np.pi, 0.0, 2.5, chip, tool)
    assert found.area[rows].sum(axis=1) == pytest.approx(wanted.sum(), rel=0.01)
    steepest = np.abs(np.gradient(wanted, found.turn)).max()
    angle = chip / 10.0 + found.turn[1] - found.turn[0]
    assert np.abs(area - wanted).max() < steepest * angle + 0.01 * wanted.max()
    assert found.peak[rows] == pytest.approx(wanted.max(), rel=0.03)


def test_volume_of_the_paper_corner():
    """What the path removes is the swept strip of stock, exactly known: two strips and the corner's quarter."""
    hollow = Profile.from_contours(
        [Contour((NurbsCurve.line((5, 60), (5, -5)), NurbsCurve.line((5, -5), (-60, -5))), False)]
    )
    found = tooth_map(path("G0 X-12 Y0\nG1 X0\nG1 Y12"), TOOL, StockRegion(hollow, 2.0), 2.5, grid=0.02, slices=2)
    # Stock below y = -3 or beyond x = 3, swept by discs of 5 along the path, less the first disc. In the strips 12 mm
    # by 2 mm each; at the corner the disc about (0, 0) beyond y < -3 or x > 3, to the left of it swept already.
    import shapely

    stock = shapely.union(shapely.box(-60, -5, 5, -3), shapely.box(3, -5, 5, 60))
    sweep = shapely.LineString([(-12, 0), (0, 0), (0, 12)]).buffer(5.0, quad_segs=512)
    first = shapely.Point(-12, 0).buffer(5.0, quad_segs=512)
    wanted = stock.intersection(sweep).difference(first).area * 2.5
    # The last teeth have not come round when the path ends: at most a tooth's chip at each end; 20 um columns.
    assert found.volume == pytest.approx(wanted, abs=2 * CHIP * 2.0 * 2.5 + 0.002 * wanted)
    # In the corner the arc is longer, and so is the largest area.
    assert found.peak.max() > 1.05 * np.median(found.peak[found.peak > 0.1])


def test_refusals():
    with pytest.raises(UsageError, match="above 0"):
        tooth_map(STRAIGHT, TOOL, STOCK, 2.5, grid=0.0)
    with pytest.raises(InputError, match="another program"):
        pieces = pieces_of_toolpath(STRAIGHT.toolpath, np.arange(3))
        tooth_map(STRAIGHT, TOOL, StockRegion(None, 0.0, (Swept(pieces, 5.0),)), 2.5)
    with pytest.raises(InputError, match="million columns"):
        tooth_map(STRAIGHT, TOOL, STOCK, 2.5, grid=2e-4)
    no_feed = real_path(nc.parse("G90 G17 G21\nG0 X0 Y0\nG1 X1").toolpath)
    with pytest.raises(UsageError, match="no feed"):
        tooth_map(no_feed, TOOL, STOCK, 2.5)
