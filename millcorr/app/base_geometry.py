# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contour that a Profile or Pocket operation follows, taken from the geometry it was given, not from its path.

Only properties and shapes are read: the operation's proxy may be dead in a document of an older FreeCAD.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
import Part
from scipy.spatial import cKDTree

from millcorr.errors import InputError
from millcorr.geometry.profile import Contour, Profile
from millcorr.messages import mm, phrase
from millcorr.nc.toolpath import Compensation, Kind, Toolpath

from . import compat, convert


def is_profile_operation(obj: Any) -> bool:
    """Whether an operation is FreeCAD's Profile, by its properties."""
    return all(hasattr(obj, name) for name in ("Base", "Side", "UseComp", "OffsetExtra", "processPerimeter"))


def is_pocket_operation(obj: Any) -> bool:
    """Whether an operation is FreeCAD's Pocket Shape, by its properties."""
    return all(hasattr(obj, name) for name in ("Base", "StepOver", "ExtraOffset", "UseOutline"))


def gives_contour(operation: Any) -> bool:
    """Whether the contour that an operation follows can be taken from its geometry.

    A pocket that runs out over an open side does not follow its face's boundary there; its path tells more.
    """
    return is_profile_operation(operation) or (
        is_pocket_operation(operation) and not getattr(operation, "ExtensionFeature", None)
    )


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
        The tool's radius and the operation's OffsetExtra or ExtraOffset.

    Raises
    ------
    InputError
        If the offset turns the path to the other side of the contour, or is there while the control holds the
        radius.
    """
    if not gives_contour(operation):
        return tool_radius
    name = "OffsetExtra" if is_profile_operation(operation) else "ExtraOffset"
    offset = float(getattr(operation, name).Value)
    if leaves_radius_to_control(operation):
        if offset:
            raise InputError(
                phrase("{}: set {} to 0, the control holds the radius (UseComp off)", operation.Label, name)
            )
        return tool_radius
    radius = tool_radius + offset
    if radius <= 0:
        raise InputError(
            phrase("{}: {} {} puts the path on the other side of the contour", operation.Label, name, mm(offset, "g"))
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
        distance, nearest = cKDTree(on).query(middle)
        along += float((tangent[nearest] * step).sum(axis=1)[distance < 0.5].sum())
    return Compensation.RIGHT if along >= 0 else Compensation.LEFT


def nominal_of(operation: Any, toolpath: Toolpath, chosen: Any = None) -> Profile | None:
    """Nominal profile of an operation, in the job's frame, material on the left.

    Parameters
    ----------
    operation : document object
        The operation at the bottom of its dressups.
    toolpath : Toolpath
        Its path; tells on which side of an open contour the tool runs.
    chosen : document object, optional
        What has the contour in place of the operation's own geometry: a sketch, an edge, a flat face, a solid.

    Returns
    -------
    Profile or None
        None where neither is there: the path itself tells.

    Raises
    ------
    InputError
        If the geometry is missing, not level, or not prismatic.
    """
    if chosen is not None:
        inside = is_pocket_operation(operation) or getattr(operation, "Side", "Outside") == "Inside"
        return convert.profile_of_shape(_shape_in_job(chosen, operation), "outside" if inside else "inside")
    return profile_of_operation(operation, toolpath) if gives_contour(operation) else None


def _shape_in_job(obj: Any, operation: Any) -> Any:
    """Shape of an object in the frame of an operation's job.

    The job machines a copy of its model, which the user may have moved to the machine's origin; what the model was
    made of, such as its sketch, moves with it. Everything else is where it stands in the document.
    """
    job = compat.parent_job(operation)
    models = [] if job is None else list(job.Model.Group)
    shape = compat.shape_in_document(obj)
    carried = []
    for model in models:
        for original in getattr(model, "Objects", None) or []:
            if obj == original or obj in original.OutListRecursive or original in obj.OutListRecursive:
                to_job = model.Placement.multiply(compat.global_placement(original).inverse())
                carried.append(compat.moved(shape, to_job))
    if obj in models or not carried:
        return shape
    return carried[0] if len(carried) == 1 else Part.makeCompound(carried)


def profile_of_operation(operation: Any, toolpath: Toolpath) -> Profile:
    """Contour of a Profile or Pocket Shape operation, in the job's frame, material on the left.

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
    walls = _profile_walls(operation) if is_profile_operation(operation) else _pocket_walls(operation)
    contours: list[Contour] = []
    for edges, material_inside in walls:
        joined = convert.chain([convert.curve_of_edge(e) for e in edges])
        contours += [_turned(c, material_inside, toolpath) for c in joined]
    if not contours:
        raise InputError(
            phrase(
                "{}: the operation's base geometry gives no profile; select faces or edges of it in the "
                "operation, with processPerimeter or processHoles on",
                operation.Label,
            )
        )
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
    near, nearest = cKDTree(on).query(points)
    height = ((points - on[nearest]) * outward[nearest]).sum(axis=1)
    inner = (nearest > 0) & (nearest < len(on) - 1)
    return -float((height / np.maximum(near, 1e-9) ** 2)[inner].sum())


Wall = tuple[list[Any], bool]
"""Edges that bound one selection, and whether the material is inside a closed contour of them."""


def _profile_walls(operation: Any) -> list[Wall]:
    outside = operation.Side != "Inside"
    if not operation.Base:
        return [(_model_outline(operation), outside)]
    walls: list[Wall] = []
    for base, names in operation.Base:
        edges, level, upright = _selected(operation, base, names)
        if edges:
            walls.append((edges, outside))
        if operation.processPerimeter:
            feet = [edge for face in upright for edge in convert.foot_edges(face)]
            if operation.HandleMultipleFeatures == "Collectively":
                outer = [edge for face in _together(level, True) for edge in face.OuterWire.Edges]
                around = convert.without_doubles([*outer, *feet])
                walls += [(around, outside)] if around else []
            else:
                walls += [(face.OuterWire.Edges, outside) for face in level]
                walls += [(feet, outside)] if feet else []
        for face in level:
            holes = _holes(face, bool(operation.processHoles), bool(operation.processCircles))
            walls += [(wire.Edges, not outside) for wire in holes]
    return walls


def _pocket_walls(operation: Any) -> list[Wall]:
    pattern = next((getattr(operation, name) for name in compat.PATTERN if hasattr(operation, name)), "Offset")
    if pattern != "Offset":
        raise InputError(
            phrase(
                "{}: lines of the pattern {} end on the pocket's walls, and would cut into them once they "
                "are corrected; choose the pattern Offset",
                operation.Label,
                pattern,
            )
        )
    if not operation.Base:
        return [(_model_outline(operation), True)]
    walls: list[Wall] = []
    for base, names in operation.Base:
        edges, level, upright = _selected(operation, base, names)
        if edges:
            raise InputError(
                phrase("{}: a pocket follows faces, and an edge of {} is selected", operation.Label, base.Label)
            )
        floors = _together(level, bool(operation.UseOutline))
        feet = [edge for face in upright for edge in convert.foot_edges(face)]
        around = convert.without_doubles([*(edge for floor in floors for edge in floor.OuterWire.Edges), *feet])
        walls += [(around, False)] if around else []
        walls += [(wire.Edges, True) for floor in floors for wire in _holes(floor, True, True)]
    return walls


def _selected(operation: Any, base: Any, names: tuple[str, ...]) -> tuple[list[Any], list[Any], list[Any]]:
    """Edges, level faces and upright faces that are selected on an object."""
    edges: list[Any] = []
    level: list[Any] = []
    upright: list[Any] = []
    for name in names:
        sub = base.Shape.getElement(name) if name else base.Shape
        if isinstance(sub, Part.Edge):
            edges.append(sub)
        elif not isinstance(sub, Part.Face):
            raise InputError(phrase("{}: {}.{} is neither face nor edge", operation.Label, base.Label, name))
        elif convert.is_horizontal(sub):
            level.append(sub)
        elif convert.is_vertical(sub):
            upright.append(sub)
        else:
            raise InputError(
                phrase(
                    "{}: {}.{} is neither level nor vertical; choose a sketch of the contour as Nominal",
                    operation.Label,
                    base.Label,
                    name,
                )
            )
    return edges, level, upright


def _together(faces: list[Any], filled: bool) -> list[Any]:
    """Level faces, seen along Z, with those that meet or overlap made one, whatever their heights.

    Parameters
    ----------
    faces : list of Part.Face
    filled : bool
        Without their holes.
    """
    flat = []
    for face in faces:
        one = Part.Face(face.OuterWire) if filled else face.copy()
        # By a vertex: the bounding box of a spline lies outside it by up to its tolerance.
        one.translate(FreeCAD.Vector(0, 0, -one.Vertexes[0].Z))
        if one.normalAt(0, 0).z < 0:
            # Faces that look in opposite directions are not made one.
            one.reverse()
        flat.append(one)
    return flat if len(flat) < 2 else list(flat[0].multiFuse(flat[1:]).removeSplitter().Faces)


def _holes(face: Any, others: bool, circles: bool) -> list[Any]:
    """Inner wires of a face: round ones, others, or both."""
    out = []
    for wire in face.Wires:
        if not wire.isSame(face.OuterWire):
            drilled = all(isinstance(e.Curve, Part.Circle) for e in wire.Edges)
            if circles if drilled else others:
                out.append(wire)
    return out


def _model_outline(operation: Any) -> list[Any]:
    job = compat.parent_job(operation)
    if job is None:
        raise InputError(phrase("{}: the operation belongs to no job and has no base geometry", operation.Label))
    models = list(job.Model.Group)
    if not models:
        raise InputError(phrase("{}: the job has no model", job.Label))
    return [e for model in models for e in _outline(model.Shape)]


_outlines: list[tuple[Any, list[Any]]] = []
"""Shapes whose outline was cut last, and their edges: OCCT takes long, and a panel asks after every keystroke."""


def _outline(shape: Any) -> list[Any]:
    for known, edges in _outlines:
        if known.isEqual(shape):
            return edges
    if not shape.Faces:
        edges = shape.Edges
    elif shape.Solids or not all(convert.is_horizontal(face) for face in shape.Faces):
        edges = convert.outline_edges(shape)
    else:
        edges = [edge for face in _together(shape.Faces, True) for edge in face.OuterWire.Edges]
    _outlines[3:] = []
    _outlines.insert(0, (shape, edges))
    return edges
