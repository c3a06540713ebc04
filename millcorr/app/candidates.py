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
    """Objects whose shape can be a nominal profile: not what is endless, nor stock, tools, operations, or our own."""
    aside = {obj.Name for job in compat.jobs(document) for obj in compat.no_models(job)}
    return [obj for obj in document.Objects if obj.Name not in aside and _can_be_nominal(obj)]


def _can_be_nominal(obj: Any) -> bool:
    if compat.is_datum(obj) or compat.is_operation(obj) or is_profile(obj) or getattr(obj, "Shape", None) is None:
        return False
    return bool(obj.Shape.Edges)


def is_profile(obj: Any) -> bool:
    """Whether an object is a compensated profile of ours, its proxy alive or not."""
    return hasattr(obj, "Correction") and hasattr(obj, "Shown") and hasattr(obj, "Poles")


def can_be_corrected(obj: Any) -> bool:
    """Whether an object is an operation that stands in a job, with no dressup over it."""
    if not compat.is_operation(obj):
        return False
    job = compat.parent_job(obj)
    return job is not None and obj.Name in [o.Name for o in compat.operations(job)]


def is_correction(obj: Any) -> bool:
    """Whether an object is a dressup of ours, its proxy alive or not."""
    return obj.Name.startswith("DressupMillcorr") and hasattr(obj, "Measurement") and hasattr(obj, "Base")
