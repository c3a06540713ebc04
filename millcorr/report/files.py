# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a correction as files: a page to read, numbers for programs, every point, the profile."""

from __future__ import annotations

import datetime
import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from millcorr import progress
from millcorr.arrays import Floats
from millcorr.correction.settings import Exports
from millcorr.decimal_text import lines
from millcorr.geometry import step
from millcorr.pipeline import Result
from millcorr.production import contour_check
from millcorr.whole_file import write_together

from .exports import texts_of
from .page import page

COLUMNS = ("s", "x", "y", "z", "nx", "ny", "deviation", "filtered", "used")
"""Columns of deviations.csv that other programs rely on; later versions only append."""

MORE_COLUMNS = (
    *("contour", "level", "predicted", "commanded", "line", "reason"),
    *("x_contact", "y_contact", "x_nominal", "y_nominal", "slope_deg"),
)
"""Columns that follow, and `ms` behind them where a transfer function corrects: see docs/report.md."""

FILES = (
    "report.html",
    "report.json",
    "deviations.csv",
    "contour.csv",
    "profile.json",
    "profile.step",
    "nominal.json",
)
"""What a report consists of, besides exports."""

NO_EXPORTS = Exports()


def write(
    result: Result,
    directory: str | Path,
    *,
    outputs: Mapping[str, str] | None = None,
    notes: Sequence[str] = (),
    date: datetime.date | None = None,
    exports: Exports = NO_EXPORTS,
) -> list[Path]:
    """Write report.html, report.json, deviations.csv, contour.csv, profile.json and profile.step.

    Everything is written beside its place first, so a failure leaves no half report; files of the same
    names are replaced, others in the directory stay.

    Parameters
    ----------
    result : Result
    directory : path
        Made where it does not exist.
    outputs : mapping of str to str, optional
        What else was written: kind (program, document, ...) to path.
    notes : sequence of str
        Statements for the top of the page, such as that no program was written.
    date : datetime.date, optional
        Date on the page; today by default. Same result, same date: same bytes.
    exports : Exports
        What quality departments want beside them.

    Returns
    -------
    list of Path
        The files.

    Raises
    ------
    UsageError
        If `directory` is a file, or an export is wanted of what was not measured.
    OSError
        If it cannot be written to.
    """
    outputs, notes, day = dict(outputs or {}), tuple(notes), date or datetime.date.today()
    moved = {"compensated": True} if result.correction.largest else {}
    midnight = datetime.datetime.combine(day, datetime.time())
    name = Path(result.request.program.name).stem + " compensated"
    return write_together(
        Path(directory),
        {
            "report.html": [page(result, outputs=outputs, notes=notes, date=day)],
            "report.json": [_json(summary(result, outputs=outputs, notes=notes))],
            "deviations.csv": deviation_lines(result),
            "contour.csv": contour_check.path_lines(contour_check.path_stations(result)),
            "profile.json": [_json(result.compensated.as_dict() | moved)],
            "profile.step": [step.text(result.compensated, name, date=midnight)],
            "nominal.json": [_json(result.nominal.as_dict())],
            **texts_of(exports, result, deviation_lines(result), day),
        },
    )


def summary(result: Result, *, outputs: Mapping[str, str] | None = None, notes: Sequence[str] = ()) -> dict[str, Any]:
    """Contents of report.json: `Result.summary` with outputs and notes, None where a number does not exist."""
    progress.step()
    plain: dict[str, Any] = _plain(result.summary() | {"outputs": dict(outputs or {}), "notes": list(notes)})
    return plain


def _json(data: Any) -> str:
    return json.dumps(_plain(data), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def _plain(data: Any) -> Any:
    """Python's own types only; None in place of what JSON has no number for."""
    if isinstance(data, Mapping):
        return {str(key): _plain(value) for key, value in data.items()}
    if isinstance(data, np.ndarray):
        return _plain(data.tolist())
    if isinstance(data, (list, tuple)):
        return [_plain(value) for value in data]
    if isinstance(data, np.generic):
        return _plain(data.item())
    if isinstance(data, float) and not np.isfinite(data):
        return None
    return data


def deviation_lines(result: Result) -> Iterator[bytes]:
    """Lines of deviations.csv: all measured points in the order of the file, millimetres.

    x, y, z are as measured (ball centres where the file gives those). A rejected point has used 0, its
    reason, and empty cells for what it does not have.

    Yields
    ------
    bytes
        The header first; blocks of whole lines after it.
    """
    progress.step()
    elastic = result.elastic
    yield ",".join(COLUMNS + MORE_COLUMNS + (("ms",) if elastic is not None else ())).encode() + b"\n"
    measurement, d = result.request.measurement, result.deviation
    if measurement is None:
        return
    rows = len(measurement)

    def placed(found: NDArray[Any]) -> Floats:
        out = np.full(rows, np.nan)
        out[d.index] = found
        return out

    used = np.zeros(rows, dtype=np.int64)
    used[d.index] = 1
    used[[point.index for point in result.left_out]] = 0
    contact = d.foot + d.value[:, None] * d.normal
    yield from lines(
        (
            placed(d.s),
            *measurement.points.T,
            *map(placed, (*d.normal.T, d.value, result.filtered)),
            used,
            placed(d.contour),
            measurement.levels(),
            *map(placed, (result.predicted, result.commanded)),
            measurement.lines,
            _reasons(result, rows),
            *map(placed, (*contact.T, *d.foot.T, contour_check.slope_angle(d.normal))),
            *([placed(elastic.transfer.ms)] if elastic is not None else []),
        )
    )


def _reasons(result: Result, rows: int) -> NDArray[np.bytes_]:
    """Why points were rejected, in quotes, or are outliers; empty for the others, (rows,)."""
    deviation = result.deviation
    texts = [_quoted(r.reason).encode() for r in deviation.rejected]
    out = np.zeros(rows, dtype=f"S{max(map(len, (*texts, b'outlier')))}")
    out[[r.index for r in deviation.rejected]] = texts
    out[deviation.index[result.outlier]] = b"outlier"
    return out


def _quoted(text: str) -> str:
    return '"' + text.replace('"', '""') + '"'
