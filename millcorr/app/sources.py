# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nominal profiles from files that only FreeCAD can read."""

from __future__ import annotations

from pathlib import Path

import FreeCAD
import Part

from millcorr.errors import FormatError
from millcorr.profile import Profile

from . import batch, convert


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
    path = Path(path)
    if not path.is_file():
        raise FormatError("no such file", path)
    shape = Part.Shape()
    try:
        shape.read(str(path))
    except (Part.OCCError, OSError, RuntimeError) as error:
        raise FormatError("not a STEP, IGES or BREP file that FreeCAD can read", path) from error
    if shape.isNull():
        raise FormatError("the file holds no shape", path)
    return convert.profile_of_shape(shape)


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
    with batch.opened(document) as here:
        FreeCAD.setActiveDocument(here.Name)
        obj = batch.find_object(here, label)
        if not hasattr(obj, "Shape"):
            raise FormatError(f"{label} has no shape", document)
        return convert.profile_of_shape(obj.Shape)
