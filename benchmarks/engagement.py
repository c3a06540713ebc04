# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time engagement with the stock carried forward beside polygon booleans, in one run.

Run from the repository root: PYTHONPATH=. python3 benchmarks/engagement.py [largest number of steps]

Path: zigzag, rows 200 mm long and 4 mm apart, joined by half circles; cutter of radius 5, a step every 0.25 mm. On
the rows the engaged arc is acos(1 - 4 / 5) from the second one on, which is the error's yardstick. Rival: shapely, the
stock less a disc of 64 sides at every step, and the disc's front edge in it; on the first rows only, for it is slow.
"""

import platform
import resource
import sys
import time

import numpy as np
import shapely

from millcorr import nc
from millcorr.process.engagement import engagement
from millcorr.process.engagement.stock_region import StockRegion
from millcorr.process.prediction.elastic_pass import elastic_pass
from millcorr.process.setup_file import Machine, Material, Setup, Stock, Tool
from millcorr.virtual.simulated_machine import reference_contour

RADIUS, ROW, APART, STEP = 5.0, 200.0, 4.0, 0.25
WANTED = np.arccos(1 - APART / RADIUS)
SETUP = Setup(
    Tool(2 * RADIUS, 4, 3000.0),
    Material("steel", 2000.0, 600.0),
    Machine(10_000.0, 10_000.0),
    Stock(solid=True, axial_depth_mm=5.0),
)


def zigzag(rows, dense=0.0):
    """Program of the path; with `dense`, every row and turn as lines of about that length in mm."""
    text = ["G90 G17 G21 F600", "G0 X0 Y0"]
    for k in range(rows):
        y, x = k * APART, ROW if k % 2 == 0 else 0.0
        turn = 3 if k % 2 == 0 else 2
        if dense:
            n = round(ROW / dense)
            ends = np.linspace(ROW - x, x, n + 1)[1:]
            text += [f"G1 X{e:.6f} Y{y:.6f}" for e in ends]
            m = max(8, round(np.pi * APART / 2 / dense))
            angle = np.linspace(-np.pi / 2, np.pi / 2, m + 1)[1:]
            sign = 1 if k % 2 == 0 else -1
            text += [
                f"G1 X{x + sign * APART / 2 * np.cos(a):.6f} Y{y + APART / 2 * (1 + np.sin(a)):.6f}" for a in angle
            ]
        else:
            text += [f"G1 X{x:.6f} Y{y:.6f}", f"G{turn} X{x:.6f} Y{y + APART:.6f} I0 J{APART / 2:.6f}"]
    return nc.parse("\n".join(text)).toolpath


def ours(toolpath):
    start = time.process_time()
    e = engagement(toolpath, SETUP, StockRegion(), step=STEP)
    took = time.process_time() - start
    x, y = e.position[:, 0], e.position[:, 1]
    on_row = (np.abs(y / APART - np.round(y / APART)) < 1e-9) & (y > 1) & (np.abs(x - ROW / 2) < ROW / 2 - 12)
    error = float(np.abs(e.phi[on_row] - WANTED).max()) if on_row.any() else float("nan")
    return len(e), took, error


def booleans(count):
    """Engaged arc at the first `count` steps by shapely; seconds a step and largest error on the second row."""
    rows = 2 + int(count * STEP / ROW)
    e = engagement(zigzag(rows), SETUP, StockRegion(), step=STEP)
    place, direction = e.position[:count, :2], e.direction[:count]
    stock = shapely.box(-50, -50, ROW + 50, rows * APART + 50).difference(shapely.Point(0, 0).buffer(RADIUS))
    angle = np.linspace(-np.pi / 2, np.pi / 2, 129)
    error = 0.0
    start = time.process_time()
    for k in range(count):
        x, y = place[k]
        a = direction[k] + angle
        front = shapely.LineString(np.stack([x + RADIUS * np.cos(a), y + RADIUS * np.sin(a)], axis=1))
        phi = stock.intersection(front).length / RADIUS
        stock = stock.difference(shapely.Point(x, y).buffer(RADIUS))
        if y > 1 and abs(y / APART - round(y / APART)) < 1e-9 and abs(x - ROW / 2) < ROW / 2 - 12:
            error = max(error, abs(phi - WANTED))
    return (time.process_time() - start) / count, error


def main():
    largest = int(float(sys.argv[1])) if len(sys.argv) > 1 else 1_000_000
    print(f"{platform.processor() or platform.machine()}, numpy {np.__version__}, shapely {shapely.__version__}")
    ours(zigzag(2))
    print("\nsteps      seconds   us/step   error, rad")
    mine = {}
    for steps in (10**3, 10**4, 10**5, 10**6):
        if steps > largest:
            break
        n, took, error = ours(zigzag(max(1, round(steps * STEP / (ROW + np.pi * APART / 2)))))
        mine[steps] = took / n
        print(f"{n:<10d} {took:<9.3f} {took / n * 1e6:<9.2f} {error:.1e}")
    for dense in (0.5, 0.1):
        rows = round(1e5 * STEP / ROW) if dense > STEP else round(1e5 * dense / ROW)
        if largest >= 10**5:
            n, took, error = ours(zigzag(rows, dense))
            print(f"{n:<10d} {took:<9.3f} {took / n * 1e6:<9.2f} {error:.1e}   in lines of {dense} mm")
    each, error = booleans(1500)
    ratio = each / max(mine.values())
    print(f"1500       {each * 1500:<9.3f} {each * 1e6:<9.2f} {error:.1e}   shapely: {ratio:.0f} times")
    nominal = reference_contour(4.0)
    s = np.linspace(0, float(nominal.total[0]), 3601)
    point, normal = nominal.at(0, s)
    centre = point + RADIUS * normal
    toolpath = nc.parse(
        "G90 G17 G21 F600\n" + "".join(f"G{int(k > 0)} X{x:.6f} Y{y:.6f}\n" for k, (x, y) in enumerate(centre))
    ).toolpath
    stock = StockRegion(nominal, 0.5)
    for step in (0.25, 0.009):
        start = time.process_time()
        n = len(engagement(toolpath, SETUP, stock, step=step))
        took = time.process_time() - start
        print(f"{n:<10d} {took:<9.3f} {took / n * 1e6:<9.2f} B-spline contour of 896 mm with an allowance, 3600 lines")
    start = time.process_time()
    found = elastic_pass(toolpath, SETUP, stock)
    took = time.process_time() - start
    n = len(found.deflection)
    print(f"{n:<10d} {took:<9.3f} the same with the elastic loop closed, residual {found.residual:.0e} mm")
    print(f"largest memory: {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB")


if __name__ == "__main__":
    main()
