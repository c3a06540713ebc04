# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects of a document that can be chosen for something, recognised by their properties."""

from __future__ import annotations

from typing import Any

from . import compat


def is_measurement(obj: Any) -> bool:
    """Whether an object is a measurement of ours, its proxy alive or not."""
    return hasattr(obj, "BallRadius") and hasattr(obj, "Digest") and hasattr(obj, "File")


def measurements(document: Any) -> list[Any]:
    """Measurements of a document, in the order in which they came."""
    return [obj for obj in document.Objects if is_measurement(obj)]


def shapes(document: Any) -> list[Any]:
    """Objects whose shape can be a nominal profile."""
    return [
        obj
        for obj in document.Objects
        if getattr(obj, "Shape", None) is not None and not compat.is_operation(obj) and not obj.Shape.isNull()
    ]


def can_be_corrected(obj: Any) -> bool:
    """Whether an object is an operation that stands in a job, with no dressup over it."""
    if not compat.is_operation(obj):
        return False
    job = compat.parent_job(obj)
    return job is not None and obj.Name in [o.Name for o in compat.operations(job)]


def is_correction(obj: Any) -> bool:
    """Whether an object is a dressup of ours, its proxy alive or not."""
    return obj.Name.startswith("DressupMillcorr") and hasattr(obj, "Measurement") and hasattr(obj, "Base")
