# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD shapes to `Profile` and back, curve by curve, without approximation.

Lines, arcs and B-splines keep their exact form; every other curve is taken in OCCT's own B-spline form.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Literal

import FreeCAD
import numpy as np
import Part
import shapely

from millcorr.arrays import Floats, Ints
from millcorr.errors import InputError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.messages import at_z, mm, phrase, xy

Material = Literal["inside", "outside", "left", "right"]

FLAT = 1e-6
"""Largest difference in height, in mm, along a contour."""

JOINED = 1e-4
"""Largest distance in mm between the ends of two edges that count as joined; OCCT's own tolerances in models
from other systems go that far."""

_LEVEL = phrase(
    "a profile lies parallel to the XY plane: choose level edges, upright faces, or a sketch of it as Nominal"
)

DEFLECTION = JOINED / 5
"""Largest distance in mm of a polygon from the curve in whose place it is asked what lies above what; no profile is
made of polygons."""


def curve_of_edge(edge: Any) -> NurbsCurve:
    """NURBS curve of a flat edge, run in the direction of the edge.

    Parameters
    ----------
    edge : Part.Edge
        In a plane parallel to XY, trimmed or whole, forward or reversed.

    Returns
    -------
    NurbsCurve
        The same points, x and y in mm. Periodic where the edge is a whole periodic B-spline.

    Raises
    ------
    InputError
        If the edge has no curve or is not level.
    """
    if getattr(edge, "Degenerated", False) or edge.Length < 1e-9:
        raise InputError(phrase("an edge of the profile has no length"))
    box = edge.BoundBox
    curve = edge.Curve
    first, last = edge.ParameterRange
    heights = [edge.valueAt(first + (last - first) * k / 8).z for k in range(9)]
    if max(heights) - min(heights) > FLAT:
        raise InputError(
            phrase(
                "an edge near {} is not level: it runs from Z{:.6f} to Z{:.6f}; {}",
                xy(box.Center.x, box.Center.y),
                min(heights),
                max(heights),
                _LEVEL,
            )
        )
    if isinstance(curve, Part.Line | Part.LineSegment):
        start, end = edge.valueAt(first), edge.valueAt(last)
        nurbs = NurbsCurve.line((start.x, start.y), (end.x, end.y))
    elif isinstance(curve, Part.Circle):
        start, end = edge.valueAt(first), edge.valueAt(last)
        sweep = (last - first) * (1.0 if curve.Axis.z > 0 else -1.0)
        nurbs = NurbsCurve.arc((start.x, start.y), (end.x, end.y), (curve.Center.x, curve.Center.y), sweep)
    elif isinstance(curve, Part.Ellipse):
        nurbs = _arc_of_ellipse(curve, first, last)
    else:
        nurbs = _curve_of_spline(_as_spline(curve, first, last), box)
    return nurbs.reversed() if edge.Orientation == "Reversed" else nurbs


def _arc_of_ellipse(ellipse: Any, first: float, last: float) -> NurbsCurve:
    """Exact arc of an ellipse, as the affine image of a circle's; OCCT's own conversion is off by 1e-8 mm."""
    unit = NurbsCurve.arc((np.cos(first), np.sin(first)), (np.cos(last), np.sin(last)), (0.0, 0.0), last - first)
    major, axis = ellipse.XAxis, ellipse.Axis
    minor = axis.cross(major)
    frame = np.array([[major.x, major.y], [minor.x, minor.y]]) * [
        [ellipse.MajorRadius],
        [ellipse.MinorRadius],
    ]
    poles = unit.poles @ frame + (ellipse.Center.x, ellipse.Center.y)
    return NurbsCurve(unit.degree, poles, unit.weights, unit.knots, unit.multiplicities)


def _as_spline(curve: Any, first: float, last: float) -> Any:
    """B-spline of a curve between two parameters; whole periodic B-splines stay periodic."""
    if not isinstance(curve, Part.BSplineCurve):
        return curve.toBSpline(first, last)
    whole = curve.LastParameter - curve.FirstParameter
    if curve.isPeriodic() and abs((last - first) - whole) <= 1e-9 * whole:
        return curve
    if not curve.isPeriodic() and first <= curve.FirstParameter and last >= curve.LastParameter:
        return curve
    spline = curve.copy()
    spline.segment(first, last)
    return spline


def _curve_of_spline(spline: Any, box: Any) -> NurbsCurve:
    poles = np.array([(p.x, p.y, p.z) for p in spline.getPoles()])
    if np.ptp(poles[:, 2]) > FLAT:
        raise InputError(
            phrase(
                "an edge near {} is not level: its poles differ by {} in Z; {}",
                xy(box.Center.x, box.Center.y),
                mm(np.ptp(poles[:, 2]), ".6f"),
                _LEVEL,
            )
        )
    return NurbsCurve(
        spline.Degree,
        poles[:, :2],
        np.array(spline.getWeights(), dtype=float),
        np.array(spline.getKnots(), dtype=float),
        np.array(spline.getMultiplicities(), dtype=np.int64),
        bool(spline.isPeriodic()),
    )


def chain(curves: Sequence[NurbsCurve]) -> list[Contour]:
    """Join curves end to end, in whatever order and direction they come.

    Parameters
    ----------
    curves : sequence of NurbsCurve

    Returns
    -------
    list of Contour
        Closed where the ends meet within `JOINED`; the direction is that of the first curve of each.

    Raises
    ------
    InputError
        If more than two curves meet in one point.
    """
    ends = np.array([[c.evaluate([c.knots[0]])[0], c.evaluate([c.knots[-1]])[0]] for c in curves]).reshape(-1, 2, 2)
    node = _nodes(ends.reshape(-1, 2)).reshape(-1, 2)
    meeting: dict[int, list[int]] = {}
    contours = []
    for k, (a, b) in enumerate(node):
        if a == b:
            contours.append(Contour((curves[k],), True))
        else:
            meeting.setdefault(int(a), []).append(k)
            meeting.setdefault(int(b), []).append(k)
    for point, members in meeting.items():
        if len(members) > 2:
            x, y = ends.reshape(-1, 2)[np.flatnonzero(node.ravel() == point)[0]]
            raise InputError(
                phrase("{} edges of the profile meet at {}; leave one way through", len(members), xy(x, y))
            )
    left = {k for members in meeting.values() for k in members}
    while left:
        loose = [k for k in sorted(left) if any(len(meeting[int(p)]) == 1 for p in node[k])]
        k = loose[0] if loose else min(left)
        forward = not loose or len(meeting[int(node[k][0])]) == 1
        start = int(node[k][0 if forward else 1])
        row = []
        while True:
            left.discard(k)
            row.append(curves[k] if forward else curves[k].reversed())
            end = int(node[k][1 if forward else 0])
            after = [j for j in meeting[end] if j in left]
            if not after or end == start:
                break
            k = after[0]
            forward = int(node[k][0]) == end
        contours.append(Contour(tuple(row), end == start))
    return contours


def _nodes(points: Floats) -> Ints:
    """Number the distinct places among points, taking those within `JOINED` as one."""
    node = np.full(len(points), -1, dtype=np.int64)
    for k, point in enumerate(points):
        if node[k] < 0:
            near = (node < 0) & (np.hypot(*(points - point).T) <= JOINED)
            node[near] = k
    return node


def oriented(contours: Iterable[Contour], material: Material = "inside") -> Profile:
    """Profile of contours with the material on the left.

    Parameters
    ----------
    contours : iterable of Contour
    material : {"inside", "outside", "left", "right"}
        Where the material lies. "inside": within the outermost closed contours and, where contours nest,
        alternating inwards; "outside": the reverse. "left" and "right" are seen along each contour as it
        runs, and are what an open contour needs: with "inside" or "outside" it keeps its direction.

    Returns
    -------
    Profile
    """
    profile = Profile.from_contours(contours)
    if material in ("left", "right"):
        return profile if material == "left" else profile.reversed()
    area = profile.signed_areas()
    depth = _nesting(profile)
    out = []
    for k, contour in enumerate(profile.contours):
        anticlockwise = (depth[k] % 2 == 0) == (material == "inside")
        out.append(contour.reversed() if contour.closed and (area[k] > 0) != anticlockwise else contour)
    return Profile.from_contours(out)


def _nesting(profile: Profile) -> Ints:
    """How many other closed contours enclose each contour, by crossings of a ray with sampled outlines."""
    depth = np.zeros(len(profile.contours), dtype=np.int64)
    if len(depth) == 1:
        return depth
    outlines = []
    for k, contour in enumerate(profile.contours):
        if contour.closed:
            points, _ = profile.at(k, np.linspace(0.0, profile.total[k], 721)[:-1])
            outlines.append((k, points))
    for k in range(len(depth)):
        x, y = profile.at(k, [0.0])[0][0]
        for j, outline in outlines:
            if j != k:
                a, b = outline, np.roll(outline, -1, axis=0)
                spans = (a[:, 1] > y) != (b[:, 1] > y)
                with np.errstate(divide="ignore", invalid="ignore"):
                    crossing = a[:, 0] + (y - a[:, 1]) * (b[:, 0] - a[:, 0]) / (b[:, 1] - a[:, 1])
                depth[k] += int((spans & (crossing > x)).sum() % 2)
    return depth


def profile_of_edges(edges: Iterable[Any], material: Material = "inside") -> Profile:
    """Profile of flat edges, joined to contours.

    Parameters
    ----------
    edges : iterable of Part.Edge
        In any order.
    material : {"inside", "outside", "left", "right"}
        See `oriented`.

    Returns
    -------
    Profile

    Raises
    ------
    InputError
        If there is no edge, an edge is not level, edges lie at different heights within a contour, or branch.
    """
    edges = list(edges)
    if not edges:
        raise InputError(phrase("the profile has no edge"))
    curves = [curve_of_edge(edge) for edge in edges]
    return oriented(chain(curves), material)


def profile_of_shape(shape: Any, material: Material = "inside") -> Profile:
    """Profile of any shape: edge, wire, sketch, flat face, or prismatic solid.

    Parameters
    ----------
    shape : Part.Shape
        A solid gives its outline, faces their boundaries, everything else its edges.
    material : {"inside", "outside", "left", "right"}
        See `oriented`.

    Returns
    -------
    Profile

    Raises
    ------
    InputError
        If the shape is empty, not level, or a solid whose outline changes with the height.
    """
    if shape.isNull():
        raise InputError(phrase("the shape of the profile is empty"))
    if shape.Solids:
        return profile_of_edges(outline_edges(shape), material)
    if shape.Faces:
        if not all(is_horizontal(face) for face in shape.Faces):
            return profile_of_edges(outline_edges(_sewn(shape)), material)
        return profile_of_edges([e for face in shape.Faces for wire in face.Wires for e in wire.Edges], material)
    return profile_of_edges(shape.Edges, material)


def _sewn(shape: Any) -> Any:
    """Solid of loose faces all round it, as IGES files have them."""
    shell = Part.makeCompound(shape.Faces)
    shell.sewShape()
    if not (shell.Shells and all(s.isClosed() for s in shell.Shells)):
        raise InputError(
            phrase(
                "a face of the profile is not parallel to the XY plane, and the faces close round no solid: "
                "choose a sketch or level edges of the contour as Nominal, or save the model as STEP"
            )
        )
    return Part.makeCompound([Part.makeSolid(s) for s in shell.Shells])


def is_horizontal(face: Any) -> bool:
    """Whether a face is flat and parallel to XY, whatever kind of surface it lies on (on a grid of 5 x 5 places)."""
    if isinstance(face.Surface, Part.Plane):
        return bool(abs(abs(face.Surface.Axis.z) - 1) < 1e-12)
    return all(1 - abs(face.normalAt(u, v).z) < 1e-12 for u, v in _grid(face))


def is_vertical(face: Any) -> bool:
    """Whether the normal of a face is parallel to XY everywhere (on a grid of 5 x 5 places)."""
    return all(abs(face.normalAt(u, v).z) < 1e-6 for u, v in _grid(face))


def _grid(face: Any) -> list[tuple[float, float]]:
    u0, u1, v0, v1 = face.ParameterRange
    return [(u0 + (u1 - u0) * i / 4, v0 + (v1 - v0) * j / 4) for i in range(5) for j in range(5)]


def foot_edges(face: Any) -> list[Any]:
    """Level edges on which a vertical face stands, or from which it hangs, one along every place of it.

    Every edge of the face lies above those it stands on: the edge round a gap in them lies above the gap. Where a
    slot is cut into the face from below, its level ceiling takes the place of what is cut away.

    Raises
    ------
    InputError
        If neither the lower nor the upper end of the face is made of level edges alone.
    """
    edges = [e for e in face.Edges if e.Length > 1e-9]
    level = [e for e in edges if np.ptp([p.z for p in _places(e)]) <= 1e-5]
    ends = []
    for highest_first in (False, True):
        feet: list[Any] = []
        lines: list[Any] = []
        for edge in sorted(level, key=lambda e: _on(e, 0.5).z, reverse=highest_first):
            line = _seen_from_above(edge)
            # Neighbours share no more than their ends.
            shared = line.intersection(shapely.MultiLineString(lines).buffer(JOINED, quad_segs=2)).length
            if shared <= 10 * JOINED:
                feet.append(edge)
                lines.append(line)
        if feet and all(_lies_above(edge, lines) for edge in edges):
            ends.append(feet)
    if ends:
        # A whole edge of the model is more exact than pieces that a slot has left of it.
        return min(ends, key=len)
    c = face.BoundBox.Center
    raise InputError(
        phrase(
            "a side face near {} ends neither below nor above in level edges alone: choose a sketch or "
            "level edges of the contour as Nominal",
            xy(c.x, c.y),
        )
    )


def _on(edge: Any, t: float) -> Any:
    first, last = edge.ParameterRange
    return edge.valueAt(first + (last - first) * t)


def _places(edge: Any) -> list[Any]:
    return [_on(edge, k / 4) for k in range(5)]


def _seen_from_above(edge: Any) -> shapely.LineString:
    return shapely.LineString([(p.x, p.y) for p in edge.discretize(Deflection=DEFLECTION)])


def _lies_above(edge: Any, lines: Sequence[shapely.LineString]) -> bool:
    """Whether an edge lies above or below lines, seen along Z."""
    places = shapely.points([(p.x, p.y) for p in _places(edge)])
    return bool((shapely.distance(places, shapely.MultiLineString(lines)) <= JOINED).all())


def outline_edges(shape: Any) -> list[Any]:
    """Edges of a solid's outline seen along Z.

    Parameters
    ----------
    shape : Part.Shape
        A solid, or several.

    Returns
    -------
    list of Part.Edge
        Exact edges of the model, at their own heights.

    Raises
    ------
    InputError
        If the outline is not made of vertical faces alone, that is if the part is not prismatic there.
    """
    bottom, top = max(_slabs(shape.Vertexes), key=lambda slab: slab[1] - slab[0])
    # Pockets and holes within a section change nothing of the outline, and a section takes long.
    sides = _reaching_out(shape.Faces, _section(shape, (bottom + top) / 2))
    slabs = _slabs([vertex for face in sides for vertex in face.Vertexes])
    sections = [_section(shape, (a + b) / 2) for a, b in slabs]
    outline = max(sections, key=lambda section: section.area)
    around = outline.buffer(JOINED)
    for (a, b), section in zip(slabs, sections, strict=True):
        if not around.covers(section):
            raise InputError(
                phrase(
                    "the model is not prismatic: between {} and {} it stands out of its outline; {}",
                    at_z(a),
                    at_z(b),
                    _CHOOSE,
                )
            )
    faces = [face for face in sides if not is_horizontal(face) and _on_outline(face, outline)]
    for face in faces:
        if not is_vertical(face):
            c = face.BoundBox.Center
            raise InputError(
                phrase("the model is not prismatic: the side face near {} is not vertical; {}", xy(c.x, c.y), _CHOOSE)
            )
    edges = without_doubles([edge for face in faces for edge in foot_edges(face)])
    # A wall that is missing, such as a chamfer's, leaves the way round open or shorter.
    length = outline.boundary.length
    closed = bool(edges) and all(contour.closed for contour in chain([curve_of_edge(edge) for edge in edges]))
    if not closed or abs(sum(e.Length for e in edges) - length) > 1e-4 * length:
        raise InputError(
            phrase("the model is not prismatic: vertical faces do not go all the way round its outline; {}", _CHOOSE)
        )
    return edges


_CHOOSE = phrase("select the faces or edges of the profile in the operation, or choose a sketch of it as Nominal")


def _slabs(vertexes: Iterable[Any]) -> list[tuple[float, float]]:
    """Ranges of height between vertices; in each a model has one section, as far as it is prismatic.

    Raises
    ------
    InputError
        If all lie at one height.
    """
    heights = sorted({round(v.Z, 6) for v in vertexes})
    slabs = [(a, b) for a, b in zip(heights[:-1], heights[1:], strict=True) if b - a > 1e-3]
    if not slabs:
        raise InputError(phrase("the model has no height"))
    return slabs


def _reaching_out(faces: Sequence[Any], section: Any) -> list[Any]:
    """Faces that are not wholly within a section, seen along Z; those that bound it among them."""
    boxes = [face.BoundBox for face in faces]
    plan = shapely.box(*np.array([(b.XMin, b.YMin, b.XMax, b.YMax) for b in boxes]).T)
    return [face for face, inside in zip(faces, shapely.contains_properly(section, plan), strict=True) if not inside]


def _section(shape: Any, z: float) -> Any:
    """Filled outer boundaries of a horizontal section, as polygons: whatever lies within a boundary is filled."""
    rings = []
    for wire in shape.slice(FreeCAD.Vector(0, 0, 1), z):
        if wire.isClosed():
            edges = wire.OrderedEdges
            rings.append(shapely.Polygon(_ring([shapely.get_coordinates(_seen_from_above(e)) for e in edges])))
    return shapely.union_all(rings)


def _ring(pieces: list[Floats]) -> Floats:
    """Points of pieces joined to a ring: in order, each in whatever direction."""
    place = pieces[0][0]
    if len(pieces) > 1 and _gaps(place, pieces[1]).min() < _gaps(pieces[0][-1], pieces[1]).min():
        place = pieces[0][-1]
    ring = []
    for piece in pieces:
        to_start, to_end = _gaps(place, piece)
        run = piece if to_start <= to_end else piece[::-1]
        place = run[-1]
        # Ends that meet are one point: two, 1e-13 apart, could cross the line.
        ring.append(run[:-1])
    return np.concatenate(ring)


def _gaps(place: Floats, piece: Floats) -> Floats:
    """Distances of a place from the start and the end of a piece."""
    distances: Floats = np.hypot(*(piece[[0, -1]] - place).T)
    return distances


def _on_outline(face: Any, outline: Any) -> bool:
    """Whether a side face lies on the boundary of the filled section, seen along Z."""
    u0, u1, v0, v1 = face.ParameterRange
    point = face.valueAt(u0 + 0.37 * (u1 - u0), v0 + 0.5 * (v1 - v0))
    return bool(outline.boundary.distance(shapely.Point(point.x, point.y)) <= JOINED)


def without_doubles(edges: Iterable[Any]) -> list[Any]:
    """Edges without those that lie above or below longer ones, seen along Z (several bodies, steps, faces)."""
    out: list[Any] = []
    lines: list[Any] = []
    for edge in sorted(edges, key=lambda e: -e.Length):
        if not lines or not _lies_above(edge, lines):
            out.append(edge)
            lines.append(_seen_from_above(edge))
    return out


# From profile to shape -------------------------------------------------------------------------------


def spline_of_curve(curve: NurbsCurve, z: float = 0.0) -> Any:
    """FreeCAD B-spline curve with the very poles, weights, knots and multiplicities.

    Parameters
    ----------
    curve : NurbsCurve
    z : float
        Height in mm.

    Returns
    -------
    Part.BSplineCurve
    """
    spline = Part.BSplineCurve()
    spline.buildFromPolesMultsKnots(
        [FreeCAD.Vector(x, y, z) for x, y in curve.poles.tolist()],
        curve.multiplicities.tolist(),
        curve.knots.tolist(),
        bool(curve.periodic),
        int(curve.degree),
        curve.weights.tolist(),
    )
    return spline


def shape_of_profile(profile: Profile, z: float = 0.0) -> Any:
    """FreeCAD shape of a profile: a wire a contour, a compound for several.

    Parameters
    ----------
    profile : Profile
    z : float
        Height in mm.

    Returns
    -------
    Part.Wire or Part.Compound
    """
    wires = []
    for contour in profile.contours:
        edges = [spline_of_curve(c, z).toShape() for c in contour.curves]
        try:
            wires.append(Part.Wire(edges))
        except Part.OCCError:
            # Ends further apart than OCCT's tolerance: still the exact curves, just not one wire.
            wires.append(Part.Compound(edges))
    return wires[0] if len(wires) == 1 else Part.Compound(wires)


def facets_of(solid: Any, deflection: float) -> Floats:
    """Facets of a solid but for its upright faces, (n, 3, 3) in mm, anticlockwise seen from outside.

    Their outlines lie off the solid's edges by no more than the deflection. Upright faces, which no vertical line
    crosses, are left out: OCCT's facets of a curved one lean, and lie off it by many times the deflection.
    """
    # All at once first: faces then share the corners along their edges.
    solid.tessellate(deflection)
    out = [np.zeros((0, 3, 3))]
    for face in solid.Faces:
        if not is_vertical(face):
            places, triangles = face.tessellate(deflection)
            corners = np.array([(place.x, place.y, place.z) for place in places])
            out.append(corners[np.array(triangles, dtype=np.int64)])
    return np.concatenate(out)
