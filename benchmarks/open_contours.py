# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many random open contours are corrected, refused, or corrected wrongly; judged by discs of shapely.

A path of three to seven lines, short steps and sharp turns among them, with or without leads. What its discs leave on
the material's side is measured every 0.4 mm with a smooth error and no noise, corrected as it is, and swept again.
Wrong is what lies more than 2 um from where it should, away from corners and fillets. Some of the paths cut into the
wall that they make elsewhere, and no shop would ask for them: they are counted apart. What is refused is listed with
its reason.

Run from the repository root: `python benchmarks/open_contours.py [first:last]`.
"""

from __future__ import annotations

import math
import sys
from collections import Counter

import numpy as np
import shapely

from millcorr import nc, pipeline
from millcorr.errors import MillcorrError
from millcorr.readers.measurement import Measurement

RADIUS, WRONG = 4.0, 0.002
QUADRANT = 400
"""Chords of a quarter of a disc: they err by 8 nm."""


def path_of(rng: np.random.Generator) -> np.ndarray:
    """Places of a path that does not cross itself and leaves no island, (n, 2) mm."""
    while True:
        places, angle = [np.zeros(2)], rng.uniform(0, 2 * math.pi)
        for _ in range(rng.integers(3, 8)):
            size = rng.choice([rng.uniform(1, 4), rng.uniform(5, 12), rng.uniform(12, 45)], p=[0.2, 0.3, 0.5])
            places.append(np.round(places[-1] + size * np.array([math.cos(angle), math.sin(angle)]), 3))
            square = math.pi / 2 * rng.choice([-1, 1])
            angle += rng.choice([rng.uniform(-0.2, 0.2), rng.uniform(-1.5, 1.5), square], p=[0.2, 0.5, 0.3])
        line = shapely.LineString(places)
        if line.is_simple and not line.buffer(9).interiors:
            return np.array(places)


def with_leads(rng: np.random.Generator, places: np.ndarray, side: int) -> tuple[str, np.ndarray]:
    """A program of the path, and all that it cuts along; leads along the normal, on the tangent, or none."""
    first, last = (v / np.hypot(*v) for v in (places[1] - places[0], places[-1] - places[-2]))
    lead = rng.choice(["none", "normal", "tangent"])
    ways = {"none": [], "normal": [-15 * side * np.array([-v[1], v[0]]) for v in (first, last)]}
    ways["tangent"] = [-10 * first, 10 * last]
    whole = [places[0] + ways[lead][0], *places, places[-1] + ways[lead][1]] if ways[lead] else list(places)
    moves = [f"X{x:.3f} Y{y:.3f}" for x, y in whole]
    lines = ["G21 G90 G17", "T1 M6", "G0 Z20", f"G0 {moves[0]}", "G1 Z-3 F250", *(f"G1 {m}" for m in moves[1:])]
    return "\n".join([*lines, "G0 Z20", "M30", ""]), np.array(whole)


def walls_of(places: np.ndarray, whole: np.ndarray, side: int) -> list[shapely.LineString]:
    """What the cutter leaves on one side of the path."""
    swept = shapely.LineString(whole).buffer(RADIUS, quad_segs=QUADRANT)
    beside = shapely.offset_curve(shapely.LineString(places), side * RADIUS, quad_segs=QUADRANT)
    left = shapely.line_merge(shapely.intersection(beside, swept.boundary.buffer(2e-4)))
    return [one for one in shapely.get_parts(left) if one.geom_type == "LineString" and one.length > 0.8]


def cuts_itself(places: np.ndarray, walls: list[shapely.LineString]) -> bool:
    """Whether the wall is not one from the path's begin to its end: one leg has cut away what another made."""
    ends = shapely.points(shapely.get_coordinates(walls[0])[[0, -1]])
    apart = np.abs(shapely.distance(ends, shapely.points(places[[0, -1]])) - RADIUS)
    return len(walls) > 1 or bool(apart.max() > 0.02)


def sharp(walls: list[shapely.LineString]) -> np.ndarray:
    """Ends and corners of walls, (n, 2)."""
    out = []
    for wall in walls:
        at = shapely.get_coordinates(wall)
        way = np.diff(at, axis=0) @ np.array([1, 1j])
        out += [at[[0, -1]], at[1:-1][np.abs(np.angle(way[1:] / way[:-1])) > 0.05]]
    return np.concatenate(out)


def judged(seed: int) -> tuple[str, str]:
    """What became of a job, and what was said."""
    rng = np.random.default_rng(seed)
    places, side = path_of(rng), int(rng.choice([-1, 1]))
    text, whole = with_leads(rng, places, side)
    walls = walls_of(places, whole, side)
    if sum(wall.length for wall in walls) < 10:
        return "left out", "nothing to measure"
    points = np.concatenate(
        [shapely.get_coordinates(wall.interpolate(np.arange(0.2, wall.length - 0.2, 0.4))) for wall in walls]
    )
    line = shapely.LineString(whole)
    centre = shapely.get_coordinates(line.interpolate(line.project(shapely.points(points))))
    normal = (points - centre) / np.hypot(*(points - centre).T)[:, None]
    wave, direction = rng.choice([0.0, 0.01, 0.04]), rng.normal(size=2)
    along = points @ (direction / np.hypot(*direction))
    off = rng.uniform(-0.04, 0.04) + wave * np.sin(2 * math.pi * along / rng.uniform(20, 60) + rng.uniform(0, 6))
    seen = np.column_stack([points - off[:, None] * normal, np.full(len(points), -2.0)])
    part = Measurement(seen, None, 0.0, np.arange(len(seen)), "part.csv", "cd" * 32)
    whose = "cuts itself, " if cuts_itself(places, walls) else ""
    try:
        request = pipeline.Request(nc.parse(text), RADIUS, part, settings=pipeline.Settings(filter="none"))
        result = pipeline.correct(request)
    except MillcorrError as error:
        return whose + "refused", str(error)
    moves = nc.parse(result.text).toolpath
    rows = moves.take(moves.kind != nc.toolpath.Kind.RAPID).position(np.array([0.0, 1.0]))[:, :, :2]
    away = shapely.distance(shapely.points(points - RADIUS * normal), shapely.multipoints(places)) > 0.5
    away &= shapely.distance(shapely.points(points), shapely.multipoints(sharp(walls))) > 0.3
    wanted = shapely.points((points + off[:, None] * normal)[away])
    left = shapely.distance(wanted, shapely.union_all(shapely.linestrings(rows))) - RADIUS
    if len(left) and np.abs(left).max() > WRONG:
        return whose + "wrong", f"{1000 * left.min():+.1f} to {1000 * left.max():+.1f} um"
    return whose + "corrected", ""


def main() -> None:
    first, last = map(int, (sys.argv[1] if len(sys.argv) > 1 else "0:100").split(":"))
    found: Counter[str] = Counter()
    for seed in range(first, last):
        what, said = judged(seed)
        found[what] += 1
        if what in ("refused", "wrong"):
            print(f"{seed:6d} {what:8s} {said[:150]}")
    print(", ".join(f"{count} {what}" for what, count in found.most_common()))


if __name__ == "__main__":
    main()
