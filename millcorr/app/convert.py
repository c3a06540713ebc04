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
from numpy.typing import NDArray

from millcorr.errors import InputError
from millcorr.nurbs import NurbsCurve
from millcorr.profile import Contour, Profile

Floats = NDArray[np.float64]
Material = Literal["inside", "outside", "left", "right"]

FLAT = 1e-6
"""Largest difference in height, in mm, along a contour."""

JOINED = 1e-4
"""Largest distance in mm between the ends of two edges that count as joined; OCCT's own tolerances in models
from other systems go that far."""


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
        raise InputError("an edge of the profile has no length")
    box = edge.BoundBox
    curve = edge.Curve
    first, last = edge.ParameterRange
    heights = [edge.valueAt(first + (last - first) * k / 8).z for k in range(9)]
    if max(heights) - min(heights) > FLAT:
        raise InputError(
            f"an edge near X{box.Center.x:.3f} Y{box.Center.y:.3f} is not level: it runs from "
            f"Z{min(heights):.6f} to Z{max(heights):.6f}; a profile lies parallel to the XY plane"
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
            f"an edge near X{box.Center.x:.3f} Y{box.Center.y:.3f} is not level: its poles differ by "
            f"{np.ptp(poles[:, 2]):.6f} mm in Z; a profile lies parallel to the XY plane"
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
            raise InputError(f"{len(members)} edges of the profile meet at X{x:.3f} Y{y:.3f}; leave one way through")
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


def _nodes(points: Floats) -> NDArray[np.int64]:
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


def _nesting(profile: Profile) -> NDArray[np.int64]:
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
        raise InputError("the profile has no edge")
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
        raise InputError("the shape of the profile is empty")
    if shape.Solids:
        return profile_of_edges(outline_edges(shape), material)
    if shape.Faces:
        for face in shape.Faces:
            if not is_horizontal(face):
                raise InputError("a face of the profile is not parallel to the XY plane")
        return profile_of_edges([e for face in shape.Faces for wire in face.Wires for e in wire.Edges], material)
    return profile_of_edges(shape.Edges, material)


def is_horizontal(face: Any) -> bool:
    """Whether a face is a plane parallel to XY."""
    return isinstance(face.Surface, Part.Plane) and abs(abs(face.Surface.Axis.z) - 1) < 1e-12


def is_vertical(face: Any) -> bool:
    """Whether the normal of a face is parallel to XY everywhere (on a grid of 5 x 5 places)."""
    u0, u1, v0, v1 = face.ParameterRange
    grid = [(u0 + (u1 - u0) * i / 4, v0 + (v1 - v0) * j / 4) for i in range(5) for j in range(5)]
    return all(abs(face.normalAt(u, v).z) < 1e-6 for u, v in grid)


def foot_edges(face: Any) -> list[Any]:
    """Level edges along the bottom of a vertical face, or along its top where the bottom is not level.

    Raises
    ------
    InputError
        If neither the bottom nor the top of the face is level.
    """
    box = face.BoundBox
    for height in (box.ZMin, box.ZMax):
        edges = [
            e for e in face.Edges if e.Length > 1e-9 and all(abs(_on(e, k / 4).z - height) <= 1e-5 for k in range(5))
        ]
        # A face that is cut into by a slot from below has a shorter bottom than its surface is wide.
        if edges and sum(e.Length for e in edges) * (box.ZMax - box.ZMin) >= face.Area * (1 - 1e-6):
            return edges
    raise InputError(
        f"a side face near X{box.Center.x:.3f} Y{box.Center.y:.3f} has neither a whole bottom nor a whole "
        "top edge; select the edges of the profile instead"
    )


def _on(edge: Any, t: float) -> Any:
    first, last = edge.ParameterRange
    return edge.valueAt(first + (last - first) * t)


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
    heights = sorted({round(v.Z, 6) for v in shape.Vertexes})
    slabs = [(a, b) for a, b in zip(heights[:-1], heights[1:], strict=True) if b - a > 1e-3]
    if not slabs:
        raise InputError("the model has no height")
    sections = [_section(shape, (a + b) / 2) for a, b in slabs]
    widest = max(range(len(slabs)), key=lambda k: sections[k].Area)
    outline = sections[widest]
    for (a, b), section in zip(slabs, sections, strict=True):
        if section.Area and outline.common(section).Area < section.Area * (1 - 1e-6):
            raise InputError(
                f"the model is not prismatic: between Z{a:.3f} and Z{b:.3f} it stands out of its outline; "
                "select the faces or edges of the profile in the operation"
            )
    edges = []
    for face in shape.Faces:
        if is_horizontal(face) or not _on_outline(face, outline):
            continue
        if not is_vertical(face):
            c = face.BoundBox.Center
            raise InputError(
                f"the model is not prismatic: the side face near X{c.x:.3f} Y{c.y:.3f} is not vertical; "
                "select the faces or edges of the profile in the operation"
            )
        edges.extend(foot_edges(face))
    edges = _without_doubles(edges)
    around = sum(e.Length for e in _outer_edges(outline))
    if abs(sum(e.Length for e in edges) - around) > 1e-4 * around:
        raise InputError(
            "the model is not prismatic: vertical faces do not go all the way round its outline; "
            "select the faces or edges of the profile in the operation"
        )
    return edges


def _section(shape: Any, z: float) -> Any:
    """Filled outer boundaries of a horizontal section, as faces at Z 0."""
    faces = []
    for wire in shape.slice(FreeCAD.Vector(0, 0, 1), z):
        if wire.isClosed():
            wire.translate(FreeCAD.Vector(0, 0, -z))
            faces.append(Part.Face(wire))
    if not faces:
        return Part.Compound([])
    kept: list[Any] = []
    for face in sorted(faces, key=lambda f: -f.Area):
        # A boundary within another one is a hole or a pocket.
        if not any(other.common(face).Area > 0.5 * face.Area for other in kept):
            kept.append(face)
    return Part.Compound(kept)


def _on_outline(face: Any, outline: Any) -> bool:
    """Whether a side face lies on the boundary of the filled section, seen along Z."""
    boundary = Part.Compound(_outer_edges(outline))
    u0, u1, v0, v1 = face.ParameterRange
    point = face.valueAt(u0 + 0.37 * (u1 - u0), v0 + 0.5 * (v1 - v0))
    flat = Part.Vertex(FreeCAD.Vector(point.x, point.y, 0.0))
    return bool(boundary.distToShape(flat)[0] <= 1e-4)


def _outer_edges(outline: Any) -> list[Any]:
    """Edges that bound one face only."""
    count: dict[int, list[Any]] = {}
    for face in outline.Faces:
        for edge in face.OuterWire.Edges:
            count.setdefault(edge.hashCode(), []).append(edge)
    return [group[0] for group in count.values() if len(group) == 1]


def _without_doubles(edges: list[Any]) -> list[Any]:
    """Edges without those that lie above another one (the outline runs through several bodies or steps)."""
    out: list[Any] = []
    for edge in edges:
        mid, length = _on(edge, 0.5), edge.Length
        for other in out:
            m = _on(other, 0.5)
            if np.hypot(mid.x - m.x, mid.y - m.y) < JOINED and abs(length - other.Length) < JOINED:
                break
        else:
            out.append(edge)
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
