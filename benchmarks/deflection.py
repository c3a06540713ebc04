# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time the error of a wall over its height on the corner of Dat and Phuc 2025, beside a Z-map swept step by step.

Run from the repository root: PYTHONPATH=. python3 benchmarks/deflection.py [longest leg in mm]

The corner: two legs, cutter of 10 mm, 2000 1/min, 300 mm/min, 2 mm by 2.5 mm, columns of 10 um, 16 slices. The rival
sweeps the same columns step by step, a turn in steps of 1 degree, one slice, in numpy; it runs 0.15 mm of the path and
its time is scaled up.
"""

import platform
import resource
import sys
import time
from pathlib import Path

import numpy as np

from millcorr import nc
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.process.deflection.height_error import WallModel
from millcorr.process.deflection.real_path import real_path
from millcorr.process.deflection.tilt import remedies
from millcorr.process.deflection.tooth_map import GRID, cutting_area, tooth_map
from millcorr.process.engagement import stock_of
from millcorr.process.engagement.stock_region import StockRegion
from millcorr.process.kinematics import AxisDynamics, Control
from millcorr.process.setup_file import load

SETUP = load(Path(__file__).resolve().parents[1] / "resources" / "setups" / "dat-2025.toml")
CONTROL = Control.alike(AxisDynamics(0.05, "linear", 40.0))
HEIGHTS = [0.5, 1.0, 1.5, 2.0]


def corner(leg):
    toolpath = nc.parse(f"G90 G17 G21 F300\nG0 X{-leg} Y0 Z5\nG1 Z0\nG1 X0\nG1 Y{leg}").toolpath
    far = leg + 60.0
    part = Contour((NurbsCurve.line((5, far), (5, -5)), NurbsCurve.line((5, -5), (-far, -5))), False)
    return toolpath, Profile.from_contours([part])


def timed(work):
    start = time.perf_counter()
    out = work()
    return out, time.perf_counter() - start


def swept(length):
    """Seconds for sweeping columns step by step over a length of path, one slice."""
    x, y = np.meshgrid(np.arange(-1.0, 6.0, GRID), np.arange(-5.0, -3.0, GRID))
    x, y = x.ravel(), y.ravel()
    there = np.hypot(x, y) > 5.0
    x, y = x[there], y[there]
    step, speed = np.radians(1.0), 5.0 / (SETUP.tool.spindle_rpm / 60 * 2 * np.pi)
    start = time.perf_counter()
    turned = 0.0
    while turned * speed < length:
        dx = x - turned * speed
        number = (turned - np.pi / 2 + np.arctan2(y, dx)) / np.pi
        hit = (np.floor(number + step / np.pi) > np.floor(number)) & (dx * dx + y * y <= 25.0)
        x, y = x[~hit], y[~hit]
        turned += step
    return time.perf_counter() - start


def main():
    longest = float(sys.argv[1]) if len(sys.argv) > 1 else 200.0
    print(f"{platform.processor() or platform.machine()}, numpy {np.__version__}")
    print("\nlegs, mm   path   map, s   columns    volume   wall, s   steps   remedies, s   25 um become")
    for leg in (25.0, 50.0, 100.0, 200.0):
        if leg > longest:
            break
        toolpath, part = corner(leg)
        stock = StockRegion(part, 2.0)
        path, first = timed(lambda toolpath=toolpath: real_path(toolpath, CONTROL))
        found, second = timed(lambda path=path, stock=stock: tooth_map(path, SETUP.tool, stock, 2.5))

        def wall(path=path, part=part):
            return WallModel.of(path, SETUP, stock_of(SETUP, part)).errors(HEIGHTS)

        error, third = timed(wall)
        remedy, fourth = timed(lambda error=error, part=part: remedies(error, part))
        print(
            f"{leg:<10g} {first:<6.2f} {second:<8.1f} {found.columns:<10d} {found.volume:<8.1f} {third:<9.2f} "
            f"{len(error.value):<7d} {fourth:<13.1f} {np.abs(remedy.after).max() * 1000:.1f} um"
        )
        if leg == 25.0:
            rows = np.flatnonzero((found.place[:, 0] > -18) & (found.place[:, 0] < -12))
            entry = np.pi - np.arccos(1 - 2.0 / 5.0)
            closed = cutting_area(found.turn, entry, np.pi, 0.0, 2.5, 0.075, SETUP.tool)
            off = np.abs(found.area[rows].mean(axis=0) - closed).max() / closed.max()
            print(f"           cutting area on the straight: {off * 100:.1f} % of its peak off the closed form")
    took = swept(0.15)
    print(f"\nswept step by step, 50 mm, one slice: {took / 0.15 * 50:.0f} s (scaled from 0.15 mm)")
    print(f"largest memory: {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB")


if __name__ == "__main__":
    main()
