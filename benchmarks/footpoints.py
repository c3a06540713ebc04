# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time foot point, signed distance and normal beside what a user would pick instead, in one run.

Run from the repository root: PYTHONPATH=. python3 benchmarks/footpoints.py [largest number of points]

Contour: the reference part, a closed cubic B-spline of 15 control vertices, 224 mm long; points with known
deviations of 10 um, and once at random over the whole part. Every time includes building the search structure.
Rivals: scipy's KD-tree over 3000 samples with three Newton steps; shapely on a fine polygon (distance only);
Open3D on a triangle mesh where it is installed (float32, distance only); and, where freecadcmd is on PATH, OCCT's
curve.parameter and FreeCAD's Inspection, which are slow and get fewer points.
"""

import importlib.util
import json
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import scipy

from millcorr.comparison.deviation import deviations
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.readers.measurement import Measurement
from millcorr.virtual.simulated_machine import REFERENCE_POLES, reference_contour

INSIDE_FREECAD = """
import json, os, sys, time
import numpy, FreeCAD, Part
data = numpy.load(os.environ["FOOTPOINTS_IN"])
curve = Part.BSplineCurve()
poles = [FreeCAD.Vector(x, y, 0) for x, y in data["poles"]]
curve.buildFromPolesMultsKnots(poles, [1] * (len(poles) + 1), list(range(len(poles) + 1)), True, 3)
out = {"version": ".".join(FreeCAD.Version()[:3]), "occt": {}, "inspection": {}}
for name in ("occt", "inspection"):
    for key in [k for k in data.files if k.startswith(name)]:
        points, wanted = data[key][:, :2], data[key][:, 2]
        if name == "occt":
            start = time.perf_counter()
            found = []
            for x, y in points.tolist():
                p = FreeCAD.Vector(x, y, 0)
                u = curve.parameter(p)
                t = curve.tangent(u)[0]
                found.append((p - curve.value(u)).dot(FreeCAD.Vector(t.y, -t.x, 0)))
            took = time.perf_counter() - start
        else:
            import Points, Inspection
            doc = FreeCAD.newDocument()
            solid = doc.addObject("Part::Feature", "Nominal")
            face = Part.Face(Part.Wire([curve.toShape()]))
            solid.Shape = face.extrude(FreeCAD.Vector(0, 0, 12))
            cloud = doc.addObject("Points::Feature", "Actual")
            cloud.Points = Points.Points([FreeCAD.Vector(x, y, 6) for x, y in points.tolist()])
            doc.recompute()
            feature = doc.addObject("Inspection::Feature", "Inspection")
            feature.Actual = cloud
            feature.Nominals = [solid]
            feature.SearchRadius = 2.0
            start = time.perf_counter()
            doc.recompute()
            took = time.perf_counter() - start
            found = list(feature.Distances)
        error = float(numpy.abs(numpy.abs(found) - numpy.abs(wanted)).max())
        out[name][len(points)] = [took, error]
json.dump(out, open(os.environ["FOOTPOINTS_OUT"], "w"))
"""


def timed(action, n):
    best, result = float("inf"), None
    for _ in range(7 if n <= 10_000 else 3):
        start = time.perf_counter()
        result = action()
        best = min(best, time.perf_counter() - start)
    return best, result


def points_near(profile, n, rng):
    s = rng.uniform(0, profile.total[0], n)
    d = rng.normal(0, 0.01, n)
    q = np.empty((n, 2))
    for a in range(0, n, 8192):
        point, normal = profile.at(0, s[a : a + 8192])
        q[a : a + 8192] = point + d[a : a + 8192, None] * normal
    return q, d


def ours(profile, q):
    return FootPointSearch(profile).find(q).distance


def with_deviation(profile, q):
    n = len(q)
    m = Measurement(np.column_stack([q, np.zeros(n)]), None, 0.0, np.arange(1, n + 1), "benchmark", "")
    return deviations(m, profile).value


def kdtree(profile, q):
    """What one writes in an hour: nearest of 3000 samples, then three Newton steps in the periodic parameter."""
    from scipy.interpolate import BSpline
    from scipy.spatial import cKDTree

    k = len(REFERENCE_POLES)
    poles = np.array(REFERENCE_POLES)
    curve = BSpline(np.arange(-3.0, k + 4), poles[np.arange(k + 3) % k], 3)
    first, second = curve.derivative(), curve.derivative(2)
    u0 = np.arange(3000) * (k / 3000)
    _, nearest = cKDTree(curve(u0)).query(q)
    u = u0[nearest]
    for _ in range(3):
        c, d1, d2 = curve(u), first(u), second(u)
        e = c - q
        u = np.mod(u - (e * d1).sum(axis=1) / ((d1**2).sum(axis=1) + (e * d2).sum(axis=1)), k)
    c, d1 = curve(u), first(u)
    n = np.stack([d1[:, 1], -d1[:, 0]], axis=1) / np.hypot(*d1.T)[:, None]
    return ((q - c) * n).sum(axis=1)


def shapely_polygon(profile, q):
    import shapely

    s = np.linspace(0, profile.total[0], 7001)[:-1]
    ring = profile.at(0, s)[0]
    segments = shapely.linestrings(np.stack([ring, np.roll(ring, -1, axis=0)], axis=1))
    _, distance = shapely.STRtree(segments).query_nearest(shapely.points(q), return_distance=True, all_matches=False)
    return distance


def open3d_mesh(profile, q):
    import open3d

    s = np.linspace(0, profile.total[0], 7001)[:-1]
    ring = profile.at(0, s)[0]
    n = len(ring)
    vertices = np.vstack([np.column_stack([ring, np.full(n, z)]) for z in (-5.0, 5.0)]).astype(np.float32)
    i = np.arange(n)
    j = np.roll(i, -1)
    triangles = np.vstack([np.stack([i, j, i + n], 1), np.stack([j, j + n, i + n], 1)]).astype(np.uint32)
    scene = open3d.t.geometry.RaycastingScene()
    scene.add_triangles(open3d.core.Tensor(vertices), open3d.core.Tensor(triangles))
    cloud = np.column_stack([q, np.zeros(len(q))]).astype(np.float32)
    return scene.compute_distance(open3d.core.Tensor(cloud)).numpy()


def in_freecad(sets):
    command = os.environ.get("FREECADCMD") or shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    if command is None:
        return None
    with tempfile.TemporaryDirectory() as folder:
        script, given, result = (Path(folder) / n for n in ("script.py", "in.npz", "out.json"))
        script.write_text(INSIDE_FREECAD)
        np.savez(given, poles=np.array(REFERENCE_POLES), **sets)
        environment = {**os.environ, "FOOTPOINTS_IN": str(given), "FOOTPOINTS_OUT": str(result)}
        subprocess.run(
            [command, str(script)], env=environment, capture_output=True, stdin=subprocess.DEVNULL, timeout=600
        )
        return json.loads(result.read_text()) if result.exists() else None


def show(name, sizes, took, error, base):
    cells = [f"{took[n]:10.4f}" if n in took else f"{'':10}" for n in sizes]
    common = max(n for n in took if n in base)
    print(f"{name:<34}{''.join(cells)}  {error:9.1e}  {took[common] / base[common]:8.1f}")


def main(largest):
    profile = reference_contour()
    rng = np.random.default_rng(1)
    sizes = [n for n in (200, 10_000, 1_000_000) if n <= largest]
    data = {n: points_near(profile, n, rng) for n in sizes}
    print(
        f"Python {platform.python_version()}, numpy {np.__version__}, scipy {scipy.__version__}, "
        f"{os.cpu_count()} cores; seconds, best of 3 to 7"
    )
    print(f"{'method':<34}{''.join(f'{n:>10}' for n in sizes)}  {'error/mm':>9}  {'ratio':>8}")
    methods = [("millcorr foot points", ours), ("millcorr deviations()", with_deviation)]
    methods += [("scipy cKDTree + 3 Newton steps", kdtree), ("shapely STRtree, 7000 chords", shapely_polygon)]
    if importlib.util.find_spec("open3d"):
        methods.append(("Open3D, 7000 chords", open3d_mesh))
    base = {}
    for name, method in methods:
        took, error = {}, 0.0
        for n in sizes:
            q, d = data[n]
            took[n], found = timed(lambda q=q, m=method: m(profile, q), n)
            error = max(error, float(np.abs(np.abs(found) - np.abs(d)).max()))
        base = base or took
        show(name, sizes, took, error, base)
    few = {n: np.column_stack(data[n]) for n in sizes if n <= 10_000}
    result = in_freecad({f"occt{n}": v for n, v in few.items()} | {"inspection200": few[200]})
    if result is None:
        print("FreeCAD: freecadcmd is not on PATH")
    else:
        labels = {"occt": "OCCT curve.parameter", "inspection": "Inspection"}
        for key, label in labels.items():
            rows = {int(n): v for n, v in result[key].items()}
            if rows:
                took = {n: v[0] for n, v in rows.items()}
                worst = max(v[1] for v in rows.values())
                show(f"FreeCAD {result['version']}: {label}", sizes, took, worst, base)
    n = min(largest, 100_000)
    left, bottom, right, top = profile.bounding_box()
    q = rng.uniform((left, bottom), (right, top), (n, 2))
    took, _ = timed(lambda: ours(profile, q), n)
    print(f"{n} points at random over the whole part: millcorr {took:.3f} s")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000)
