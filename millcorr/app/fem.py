# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stiffness along a contour from results of FreeCAD's FEM: a result for each place and axis where the wall was loaded.

Example
-------
>>> from millcorr.app import fem, measuring
>>> profile, *_ = measuring.contour_of(doc.Profile)
>>> fem.stiffness_along(doc.findObjects("Fem::FemResultObject"), profile, kx=8000.0, ky=5000.0)
((0.0, 8000.0, 5000.0), (40.0, 8000.0, 870.4), (80.0, 8000.0, 5000.0))
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from millcorr.arrays import Floats
from millcorr.errors import InputError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.messages import mm, phrase, xy

from . import compat

FARTHEST = 1.0
"""A load whose middle lies farther from the contour, in mm, is none on the wall: it would be put at a wrong place."""
SAME_PLACE = 0.01
"""Loads along X and along Y this near along the contour, in mm, are of one row: meshes of one model differ by less."""
_ALONG = np.cos(np.radians(1.0))
"""Of a load's direction: kx and ky say nothing of a load between the axes, but 0.02 % is lost by a degree."""


def stiffness_along(
    results: Iterable[Any], profile: Profile, kx: float, ky: float
) -> tuple[tuple[float, float, float], ...]:
    """Rows of a setup's ``[machine] stiffness_along``, from what loads at places of the wall move there.

    The wall's compliance is added to the machine's. Along an axis in which no result loads a place, the wall is taken
    as rigid there.

    Parameters
    ----------
    results : iterable of document objects
        FEM results, each in an analysis of its own with one force along X or Y on one face, edge or vertex. That one's
        nodes tell, by their mean, where the load is and how far the wall gives way.
    profile : Profile
        The nominal, of one contour, in the coordinates of the model.
    kx, ky : float
        Stiffness of machine and tool in N/mm.

    Returns
    -------
    tuple of (s, kx, ky)
        Arc length in mm, ascending, and stiffnesses of the whole in N/mm.

    Raises
    ------
    InputError
        If an analysis has other loads, a load is not on the contour or between the axes, two are at one place along
        one axis, or the wall moves against its load; names the result.
    """
    if len(profile.contours) != 1:
        raise InputError(
            phrase("a table of stiffness goes along one contour, the nominal has {}", len(profile.contours))
        )
    rows: list[tuple[float, list[float]]] = []
    total = float(profile.total[0])
    for result in results:
        place, axis, compliance = _load_case(result)
        feet = FootPointSearch(profile, margin=FARTHEST).find(place[None, :])
        if not abs(feet.distance[0]) <= FARTHEST:
            raise InputError(phrase("{}: its load at {} is not on the contour", result.Label, xy(place[0], place[1])))
        s = float(profile.arc_length(feet.span, feet.t)[0])
        # Where a closed contour ends it begins.
        s = 0.0 if profile.contours[0].closed and total - s <= SAME_PLACE else s
        row = next((own for at, own in rows if abs(at - s) <= SAME_PLACE), None)
        if row is None:
            row = [0.0, 0.0]
            rows.append((s, row))
        if row[axis]:
            raise InputError(
                phrase("{}: another result loads the place at {} along {}", result.Label, mm(s, ".3f"), "XY"[axis])
            )
        row[axis] = compliance
    return tuple((s, 1.0 / (1.0 / kx + cx), 1.0 / (1.0 / ky + cy)) for s, (cx, cy) in sorted(rows))


def _load_case(result: Any) -> tuple[Floats, int, float]:
    """Where the wall is loaded (2,), along which axis, and its compliance there in mm/N."""
    analysis = result.getParentGroup()
    loads = [] if analysis is None else [m for m in analysis.Group if compat.is_fem_load(m)]
    if len(loads) != 1 or loads[0].TypeId != compat.FEM_FORCE:
        raise InputError(
            phrase("{}: its analysis has {} loads, one force on one place is needed", result.Label, len(loads))
        )
    force = loads[0]
    parts = [(part, name) for part, names in force.References for name in names]
    if len(parts) != 1:
        raise InputError(phrase("{}: {} acts on {} places, not on one", result.Label, force.Label, len(parts)))
    direction = np.array(force.DirectionVector)[:2]
    axis = int(np.argmax(np.abs(direction)))
    if not abs(direction[axis]) >= _ALONG:
        raise InputError(phrase("{}: {} acts neither along X nor along Y", result.Label, force.Label))
    part, name = parts[0]
    shape, mesh = part.getSubObject(name), result.Mesh.FemMesh
    of_kind = {"Vertex": mesh.getNodesByVertex, "Edge": mesh.getNodesByEdge, "Face": mesh.getNodesByFace}
    nodes = list(of_kind[shape.ShapeType](shape))
    # A calculation that failed leaves nodes without displacements.
    moved = dict(zip(result.NodeNumbers, result.DisplacementVectors, strict=False))
    if not nodes or not moved.keys() >= set(nodes):
        raise InputError(
            phrase("{}: no displacements of the nodes at {}.{}, calculate it again", result.Label, part.Label, name)
        )
    place: Floats = np.mean([tuple(mesh.Nodes[n])[:2] for n in nodes], axis=0)
    compliance = float(np.mean([tuple(moved[n])[axis] for n in nodes]) / (compat.newtons(force) * direction[axis]))
    if not 0 < compliance < np.inf:
        raise InputError(phrase("{}: the wall moves against its load or not at all", result.Label))
    return place, axis, compliance
