# SPDX-License-Identifier: LGPL-2.1-or-later
"""Align points that are 1 degree and 2 mm off, beside what a user would pick: ICP with a k-d tree.

Run from the repository root: PYTHONPATH=. python3 benchmarks/alignment.py

Printed are the time, and how far the motion leaves the points from where the least squares optimum puts them. The
optimum is scipy's least_squares, started at the truth, without the outliers, on the closed form of the contour: a
rounded rectangle and an open L. The rival is the usual recipe, points to the nearest of 20,000 samples, best rigid
motion (Kabsch), repeated 50 times; its samples are 8 to 12 um apart and outliers count.
"""

import math
import time

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial import cKDTree

from millcorr.comparison.alignment import Freedom, Transform, align
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.readers.measurement import Measurement

OFF = Transform.about(math.radians(1.0), (12.0, 34.0), (1.6, -1.2))
RADIUS = 8.0


def rounded_rectangle():
    """Curves of an 80 x 50 rectangle; per curve also (start, end, centre or None)."""
    r = RADIUS
    v = np.array([[0, 0], [80, 0], [80, 50], [0, 50]], dtype=float)
    out = []
    for i in range(4):
        a, b, c = v[i], v[(i + 1) % 4], v[(i + 2) % 4]
        along, up = (b - a) / np.hypot(*(b - a)), (c - b) / np.hypot(*(c - b))
        out.append((a + r * along, b - r * along, None))
        out.append((b - r * along, b + r * up, b - r * along + r * up))
    return out


def open_l():
    return [
        (np.array([0.0, 0.0]), np.array([100.0, 0.0]), None),
        (np.array([100.0, 0.0]), np.array([120.0, 60.0]), None),
    ]


def profile_of(rows, closed):
    curves = [
        NurbsCurve.line(a, b) if centre is None else NurbsCurve.arc(a, b, centre, math.pi / 2) for a, b, centre in rows
    ]
    return Profile.from_contours([Contour(tuple(curves), closed)])


def deviation(rows, owner, xy):
    out = np.empty(len(xy))
    for k, (a, b, centre) in enumerate(rows):
        at = owner == k
        if centre is None:
            u = (b - a) / np.hypot(*(b - a))
            out[at] = (xy[at] - a) @ [u[1], -u[0]]
        else:
            out[at] = np.hypot(*(xy[at] - centre).T) - RADIUS
    return out


def points_on(rows, n, rng):
    owner = rng.integers(0, len(rows), n)
    f = rng.uniform(0.05, 0.95, n)
    d = rng.normal(0, 0.002, n)
    bad = rng.random(n) < 0.02
    d[bad] += rng.choice([-1, 1], n)[bad] * rng.uniform(0.05, 1.5, n)[bad]
    xy = np.empty((n, 2))
    for k, (a, b, centre) in enumerate(rows):
        at = owner == k
        if centre is None:
            u = (b - a) / np.hypot(*(b - a))
            xy[at] = a + f[at, None] * (b - a) + d[at, None] * np.array([u[1], -u[0]])
        else:
            start = math.atan2(*(a - centre)[::-1])
            angle = start + f[at] * math.pi / 2
            xy[at] = centre + (RADIUS + d[at])[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return owner, xy, bad


def icp(xy, samples):
    tree = cKDTree(samples)
    here, turn, shift = xy.copy(), np.eye(2), np.zeros(2)
    for _ in range(50):
        target = samples[tree.query(here)[1]]
        a, b = here.mean(axis=0), target.mean(axis=0)
        u, _, v = np.linalg.svd((here - a).T @ (target - b))
        r = v.T @ np.diag([1, np.sign(np.linalg.det(v.T @ u.T))]) @ u.T
        here = (here - a) @ r.T + b
        turn, shift = r @ turn, r @ (shift - a) + b
    return Transform((shift[0], shift[1]), math.atan2(turn[1, 0], turn[0, 0]))


def main():
    print(f"{'contour':>18} {'points':>7} {'fit':>10} {'s':>7} {'off optimum um':>15} {'arc sec':>9}")
    contours = {"rounded rectangle": (rounded_rectangle(), True), "open L": (open_l(), False)}
    for name, (rows, closed) in contours.items():
        profile = profile_of(rows, closed)
        length = float(profile.total[0])
        samples = profile.at(0, np.linspace(0, length, 20_000))[0]
        for n in (200, 10_000, 100_000):
            owner, xy, bad = points_on(rows, n, np.random.default_rng(n))
            away = OFF.inverse().points(xy)
            measurement = Measurement(
                np.column_stack([away, np.zeros(n)]), None, 0.0, np.arange(1, n + 1), "points", ""
            )
            best = least_squares(
                lambda q, o=owner[~bad], p=away[~bad], r=rows: deviation(r, o, Transform((q[0], q[1]), q[2]).points(p)),
                [*OFF.shift, OFF.rotation],
                x_scale=[1, 1, 0.02],
                xtol=1e-15,
                ftol=1e-15,
                gtol=1e-15,
                jac="3-point",
            ).x
            optimum = Transform((best[0], best[1]), best[2])
            fits = {
                "millcorr": lambda m=measurement, p=profile: align(m, p)[1].transform,
                "zone": lambda m=measurement, p=profile: align(m, p, Freedom.parse("rigid:zone"))[1].transform,
                "ICP": lambda a=away, s=samples: icp(a, s),
            }
            for kind, fit in fits.items():
                start = time.perf_counter()
                found = fit()
                seconds = time.perf_counter() - start
                apart = np.hypot(*(found.points(away) - optimum.points(away)).T).max() * 1e3
                turn = math.degrees(abs(found.rotation - optimum.rotation)) * 3600
                print(f"{name:>18} {n:7d} {kind:>10} {seconds:7.3f} {apart:15.6f} {turn:9.5f}")


if __name__ == "__main__":
    main()
