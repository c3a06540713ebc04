# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `millcorr.freecad_process` can ask of FreeCAD: requests and answers in what JSON can hold."""

from __future__ import annotations

import json
import os
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

from millcorr import errors
from millcorr.errors import MillcorrError, UsageError
from millcorr.messages import phrase
from millcorr.production.journal import RepeatedError

from . import batch, compat, demonstration, documents, measuring, sources


def correct(*, once: bool = False, **arguments: Any) -> dict[str, Any]:
    """Correct a document; arguments as `batch.correct_document`. Gives the numbers of the report.

    With `once`, the very run that the journal has already is no error: it gives "done_before", in words.
    """
    try:
        summary: dict[str, Any] = batch.correct_document(**arguments).summary()
    except RepeatedError as error:
        if not (once and error.is_same_run(batch.sha256(Path(arguments["document"])), Path(arguments["output"]))):
            raise
        return {"done_before": str(error)}
    return summary


def demonstrate(document: str, program: str) -> dict[str, Any]:
    """Make the demonstration document and its program."""
    written = demonstration.make(document, program)
    return {"document": str(written[0]), "program": str(written[1])}


def profile(document: str, label: str) -> dict[str, Any]:
    """Profile of an object in a document, as `Profile.as_dict`."""
    return sources.profile_of_object(document, label).as_dict()


def file_profile(path: str) -> dict[str, Any]:
    """Profile of a STEP, IGES or BREP file, as `Profile.as_dict`."""
    return sources.profile_of_file(path).as_dict()


def operation_contour(document: str, operation: str | None, model: bool) -> dict[str, Any]:
    """Profile of an operation as `Profile.as_dict`, its path as G-code, and the diameter of its tool in mm.

    With `model` also the facets of its job's model and their tolerance in mm; None where there is no solid.
    """
    compat.prepare_modules()
    with documents.opened(document) as here:
        top = batch.find_operation(here, operation)
        profile, program, _ = measuring.contour_of(top)
        part = measuring.workpiece_of(top) if model else None
        facets = part and {"facets": part.facets.tolist(), "tolerance": part.tolerance}
        diameter = compat.tool_diameter(top)
        return {"profile": profile.as_dict(), "path": program.text, "tool_diameter": diameter, "model": facets}


FUNCTIONS: dict[str, Callable[..., dict[str, Any]]] = {
    "correct": correct,
    "demonstrate": demonstrate,
    "profile": profile,
    "file_profile": file_profile,
    "operation_contour": operation_contour,
}


def answer(request: dict[str, Any], answer_file: str) -> None:
    """Run a request and write the answer.

    Parameters
    ----------
    request : dict
        "function": a name in `FUNCTIONS`; "arguments": its arguments.
    answer_file : str
        File to write: "value", or "error", "message" and "traceback".
    """
    try:
        function = FUNCTIONS.get(request["function"])
        if function is None:
            raise UsageError(phrase("FreeCAD is asked for {}, which it cannot do", request["function"]))
        out: dict[str, Any] = {"value": function(**request["arguments"])}
    except MillcorrError as error:
        out = {
            # Of a class of its own where that is one that the other side knows.
            "error": next(kind.__name__ for kind in type(error).__mro__ if kind.__module__ == errors.__name__),
            "message": str(error),
            "traceback": traceback.format_exc(),
            "file": getattr(error, "file", None),
            "line": getattr(error, "line", None),
        }
    # The process ends here: whatever went wrong must reach the one who asked.
    except Exception as error:  # noqa: BLE001
        out = {
            "error": "MillcorrError",
            "message": f"unexpected in FreeCAD: {type(error).__name__}: {error}",
            "traceback": traceback.format_exc(),
        }
    ready = Path(answer_file + ".part")
    ready.write_text(json.dumps(out), encoding="utf-8")
    os.replace(ready, answer_file)
