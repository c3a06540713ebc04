# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nominal profiles from other objects and files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import Part

from millcorr.errors import FormatError, UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import phrase

from . import compat, convert, documents


def profile_of_file(path: str | Path) -> Profile:
    """Profile of a STEP, IGES or BREP file.

    Parameters
    ----------
    path : str or Path
        A curve, a flat face, or a prismatic part standing on the XY plane.

    Returns
    -------
    Profile
        Material inside.

    Raises
    ------
    FormatError
        If the file cannot be read.
    InputError
        If its shape gives no profile.
    """
    return convert.profile_of_shape(shape_of_file(Path(path)))


def shape_of_file(path: Path) -> Any:
    """Shape of a STEP, IGES, BREP or DXF file, or of a profile.json; FormatError if it is none."""
    if not path.is_file():
        raise FormatError(phrase("no such file"), path)
    if path.suffix.lower() == ".dxf":
        return _shape_of_dxf(path)
    if path.suffix.lower() == ".json":
        return convert.shape_of_profile(Profile.read_json(path))
    shape = Part.Shape()
    try:
        shape.read(str(path))
    except (Part.OCCError, OSError, RuntimeError) as error:
        raise FormatError(phrase("not a STEP, IGES or BREP file that FreeCAD can read"), path) from error
    if shape.isNull():
        raise FormatError(phrase("the file holds no shape"), path)
    return shape


def _shape_of_dxf(path: Path) -> Any:
    """All edges of a DXF file as one shape."""
    import Import

    active = FreeCAD.ActiveDocument
    document = FreeCAD.newDocument("DrawingExchange", hidden=True)
    try:
        Import.readDXF(str(path), document.Name)
        edges = [edge for obj in document.Objects if hasattr(obj, "Shape") for edge in obj.Shape.Edges]
        shape = Part.makeCompound([edge.copy() for edge in edges])
    except (Part.OCCError, OSError, RuntimeError, SystemError) as error:
        # FreeCAD 1.0 fails on every DXF file when it runs without a window.
        raise FormatError(phrase("this FreeCAD cannot read the DXF file; save the contour as STEP"), path) from error
    finally:
        FreeCAD.closeDocument(document.Name)
        if active is not None:
            FreeCAD.setActiveDocument(active.Name)
    if not edges:
        raise FormatError(phrase("the file holds no line or curve"), path)
    return shape


def nominal_object(document: Any, source: Any) -> Any:
    """Object that holds a nominal profile, made in the document where it comes from a file.

    Parameters
    ----------
    document : FreeCAD document
    source : document object, str or Path
        An object; its label or name, with or without ``#`` before it; a .json, STEP, IGES, BREP or DXF file; or
        an object of another document as ``FILE.FCStd#Label``.

    Returns
    -------
    document object

    Raises
    ------
    UsageError
        If there is no such object, or the file cannot serve as nominal of a document.
    FormatError
        If the file cannot be read.
    """
    if not isinstance(source, str | Path):
        return source
    name, _, label = str(source).partition("#")
    if not name or not Path(name).is_file():
        return documents.find_object(document, label or name)
    path = Path(name)
    suffix = path.suffix.lower()
    if suffix == ".fcstd":
        with documents.opened(path) as other:
            shape = compat.shape_in_document(documents.find_object(other, label))
    elif suffix in (".json", ".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".dxf"):
        shape = shape_of_file(path)
    else:
        raise UsageError(
            phrase("{}: the nominal of a document comes from an object, a CAD file or a profile.json", path)
        )
    FreeCAD.setActiveDocument(document.Name)
    obj = document.addObject("Part::Feature", "Nominal")
    obj.Label = path.name
    obj.Shape = shape
    return obj


def profile_of_object(document: str | Path, label: str) -> Profile:
    """Profile of an object in a document.

    Parameters
    ----------
    document : str or Path
    label : str
        Label or name of an object with a shape.

    Returns
    -------
    Profile
        Material inside.

    Raises
    ------
    FormatError
        If the document cannot be read or the object has no shape.
    UsageError
        If there is no such object.
    """
    with documents.opened(document) as here:
        FreeCAD.setActiveDocument(here.Name)
        obj = documents.find_object(here, label)
        return convert.profile_of_shape(compat.shape_in_document(obj))
