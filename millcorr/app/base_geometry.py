# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contour that a Profile operation follows, taken from the geometry it was given, not from its path.

Only properties and shapes are read: the operation's proxy may be dead in a document of an older FreeCAD.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import Part

from millcorr.errors import InputError
from millcorr.profile import Contour, Profile
from millcorr.toolpath import Compensation, Kind, Toolpath

from . import compat, convert


def is_profile_operation(obj: Any) -> bool:
    """Whether an operation is FreeCAD's Profile, by its properties."""
    return all(hasattr(obj, name) for name in ("Base", "Side", "UseComp", "OffsetExtra", "processPerimeter"))


def path_radius(operation: Any, tool_radius: float) -> float:
    """Distance in mm from the contour to the centre of the tool while it cuts.

    Parameters
    ----------
    operation : document object
        Operation at the bottom of its dressups.
    tool_radius : float
        mm.

    Returns
    -------
    float
        The tool's radius and the operation's OffsetExtra.

    Raises
    ------
    InputError
        If OffsetExtra turns the path to the other side of the contour, or is there while the control holds
        the radius.
    """
    if not is_profile_operation(operation):
        return tool_radius
    if leaves_radius_to_control(operation):
        if operation.OffsetExtra.Value:
            raise InputError(f"{operation.Label}: set OffsetExtra to 0, the control holds the radius (UseComp off)")
        return tool_radius
    radius = tool_radius + float(operation.OffsetExtra.Value)
    if radius <= 0:
        raise InputError(
            f"{operation.Label}: OffsetExtra {operation.OffsetExtra.Value:g} mm puts the path on "
            "the other side of the contour"
        )
    return radius


def leaves_radius_to_control(operation: Any) -> bool:
    """Whether an operation's path is the contour itself (UseComp off)."""
    return is_profile_operation(operation) and not operation.UseComp


def side_of_path(profile: Profile, toolpath: Toolpath) -> Compensation:
    """Side of a path on which the cutter must be, where the path runs on the profile itself.

    Parameters
    ----------
    profile : Profile
        Material on the left.
    toolpath : Toolpath

    Returns
    -------
    Compensation
        LEFT or RIGHT of the path's own direction.
    """
    cutting = toolpath.take((toolpath.kind != Kind.RAPID) & np.isfinite(toolpath.start[:, :2]).all(axis=1))
    along = 0.0
    for k in range(len(profile.contours)):
        on, outward = profile.at(k, np.linspace(0.0, profile.total[k], 401))
        tangent = np.stack([-outward[:, 1], outward[:, 0]], axis=1)
        points = cutting.position(np.linspace(0.0, 1.0, 9))[:, :, :2]
        step = np.diff(points, axis=1).reshape(-1, 2)
        middle = ((points[:, 1:] + points[:, :-1]) / 2).reshape(-1, 2)
        for p, d in zip(middle, step, strict=True):
            distance = np.hypot(*(on - p).T)
            nearest = int(distance.argmin())
            if distance[nearest] < 0.5:
                along += float(tangent[nearest] @ d)
    return Compensation.RIGHT if along >= 0 else Compensation.LEFT


def profile_of_operation(operation: Any, toolpath: Toolpath) -> Profile:
    """Contour of a Profile operation, in the job's frame, material on the left.

    Parameters
    ----------
    operation : document object
        The operation at the bottom of its dressups.
    toolpath : Toolpath
        Its path; tells on which side of an open contour the tool runs.

    Returns
    -------
    Profile

    Raises
    ------
    InputError
        If the geometry is missing, not level, or not prismatic.
    """
    outer, holes = _edges(operation)
    outside = operation.Side != "Inside"
    contours: list[Contour] = []
    for edges, material in ((outer, outside), (holes, not outside)):
        if edges:
            joined = convert.chain([convert.curve_of_edge(e) for e in edges])
            contours += [_turned(c, material, toolpath) for c in joined]
    if not contours:
        raise InputError(f"{operation.Label}: the operation's base geometry gives no profile")
    return Profile.from_contours(contours)


def _turned(contour: Contour, material_inside: bool, toolpath: Toolpath) -> Contour:
    """Contour with the material on its left."""
    profile = Profile.from_contours([contour])
    if contour.closed:
        right_way = (profile.signed_areas()[0] > 0) == material_inside
    else:
        right_way = _side_of_path(profile, toolpath) <= 0
    return contour if right_way else contour.reversed()


def _side_of_path(profile: Profile, toolpath: Toolpath) -> float:
    """Mean side on which the cutting moves run, weighted by nearness: positive left of the contour."""
    cutting = toolpath.take((toolpath.kind != Kind.RAPID) & np.isfinite(toolpath.start[:, :2]).all(axis=1))
    points = cutting.position(np.linspace(0.0, 1.0, 9)).reshape(-1, 3)[:, :2]
    if not len(points):
        return 0.0
    on, outward = profile.at(0, np.linspace(0.0, profile.total[0], 401))
    total = 0.0
    for block in np.array_split(points, max(1, len(points) // 2000)):
        delta = block[:, None, :] - on[None, :, :]
        distance = np.hypot(delta[..., 0], delta[..., 1])
        nearest = distance.argmin(axis=1)
        rows = np.arange(len(block))
        height = (delta[rows, nearest] * outward[nearest]).sum(axis=1)
        near = distance[rows, nearest]
        inner = (nearest > 0) & (nearest < len(on) - 1)
        total -= float((height / np.maximum(near, 1e-9) ** 2)[inner].sum())
    return total


def _edges(operation: Any) -> tuple[list[Any], list[Any]]:
    """Edges of the contours round the material, and of those round holes in it."""
    if not operation.Base:
        return _model_outline(operation), []
    outer: list[Any] = []
    holes: list[Any] = []
    for base, names in operation.Base:
        faces = []
        for name in names:
            sub = base.Shape.getElement(name) if name else base.Shape
            if isinstance(sub, Part.Face):
                faces.append(sub)
            elif isinstance(sub, Part.Edge):
                outer.append(sub)
            else:
                raise InputError(f"{operation.Label}: {base.Label}.{name} is neither face nor edge")
        flat = [f for f in faces if convert.is_horizontal(f)]
        if operation.processPerimeter:
            outer += _perimeter(flat, operation.HandleMultipleFeatures == "Collectively")
            for face in faces:
                if not convert.is_horizontal(face):
                    if not convert.is_vertical(face):
                        raise InputError(f"{operation.Label}: a face of {base.Label} is neither level nor vertical")
                    outer += convert.foot_edges(face)
        for face in flat:
            holes += _holes(face, bool(operation.processHoles), bool(operation.processCircles))
    return outer, holes


def _perimeter(faces: list[Any], together: bool) -> list[Any]:
    """Outer edges of level faces; edges between two faces are inside where the faces count as one."""
    edges = [e for f in faces for e in f.OuterWire.Edges]
    if not together:
        return edges
    return [e for i, e in enumerate(edges) if not any(e.isSame(o) for j, o in enumerate(edges) if j != i)]


def _holes(face: Any, others: bool, circles: bool) -> list[Any]:
    out = []
    for wire in face.Wires:
        if not wire.isSame(face.OuterWire):
            drilled = all(isinstance(e.Curve, Part.Circle) for e in wire.Edges)
            if circles if drilled else others:
                out += wire.Edges
    return out


def _model_outline(operation: Any) -> list[Any]:
    job = compat.parent_job(operation)
    if job is None:
        raise InputError(f"{operation.Label}: the operation belongs to no job and has no base geometry")
    models = list(job.Model.Group)
    if not models:
        raise InputError(f"{job.Label}: the job has no model")
    return [e for model in models for e in _outline(model.Shape)]


_outlines: list[tuple[Any, list[Any]]] = []
"""Shapes whose outline was cut last, and their edges: OCCT takes long, and a panel asks after every keystroke."""


def _outline(shape: Any) -> list[Any]:
    for known, edges in _outlines:
        if known.isEqual(shape):
            return edges
    edges = list(convert.outline_edges(shape))
    _outlines[3:] = []
    _outlines.insert(0, (shape, edges))
    return edges
