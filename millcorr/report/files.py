# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a correction as files: a page to read, numbers for programs, every point, the profile."""

from __future__ import annotations

import datetime
import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from millcorr import contour_check, step
from millcorr.pipeline import Result
from millcorr.separation import Filter
from millcorr.whole_file import write_together

from .page import page

COLUMNS = ("s", "x", "y", "z", "nx", "ny", "deviation", "filtered", "used")
"""Columns of deviations.csv that other programs rely on; later versions only append."""

MORE_COLUMNS = ("contour", "level", "predicted", "commanded", "line", "reason", "x_contact", "y_contact", "slope_deg")
"""Columns that follow, and `ms` behind them where a transfer function corrects: see docs/report.md."""

FILES = (
    "report.html",
    "report.json",
    "deviations.csv",
    "contour.csv",
    "points.csv",
    "profile.json",
    "profile.step",
    "nominal.json",
)
"""What a report consists of."""

_CHUNK = 65536


def write(
    result: Result,
    directory: str | Path,
    *,
    outputs: Mapping[str, str] | None = None,
    notes: Sequence[str] = (),
    date: datetime.date | None = None,
) -> list[Path]:
    """Write report.html, report.json, deviations.csv, contour.csv, points.csv, profile.json and profile.step.

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

    Returns
    -------
    list of Path
        The files.

    Raises
    ------
    UsageError
        If `directory` is a file.
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
            "points.csv": contour_check.point_lines(contour_check.touched_points(result)),
            "profile.json": [_json(result.compensated.as_dict() | moved)],
            "profile.step": [step.text(result.compensated, name, date=midnight)],
            "nominal.json": [_json(result.nominal.as_dict())],
        },
    )


def summary(result: Result, *, outputs: Mapping[str, str] | None = None, notes: Sequence[str] = ()) -> dict[str, Any]:
    """Contents of report.json: `Result.summary` with outputs and notes, None where a number does not exist."""
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


def deviation_lines(result: Result) -> Iterator[str]:
    """Lines of deviations.csv: all measured points in the order of the file, millimetres.

    x, y, z are as measured (ball centres where the file gives those). A rejected point has used 0, its
    reason, and empty cells for what it does not have.

    Yields
    ------
    str
        The header first; blocks of whole lines after it.
    """
    elastic = result.elastic
    yield ",".join(COLUMNS + MORE_COLUMNS + (("ms",) if elastic is not None else ())) + "\n"
    measurement, d = result.request.measurement, result.deviation
    if measurement is None:
        return
    points, levels = measurement.points, measurement.levels()
    reasons = {r.index: _quoted(r.reason) for r in d.rejected}
    used = np.full(len(points), -1, dtype=np.int64)
    used[d.index] = np.arange(len(d))
    numbers = np.column_stack([d.s, d.normal, d.value, result.filtered, result.predicted, result.commanded])
    contact = d.foot + d.value[:, None] * d.normal
    more = [contact, contour_check.slope_angle(d.normal)] + ([elastic.transfer.ms] if elastic is not None else [])
    last = np.column_stack(more)
    empty = "," * last.shape[1]
    outlier = result.outlier.tolist()
    left_out = Filter.parse(result.request.settings.filter).leaves_out
    for start in range(0, len(points), _CHUNK):
        end = min(start + _CHUNK, len(points))
        xyz, level, line = points[start:end].tolist(), levels[start:end].tolist(), measurement.lines[start:end].tolist()
        out = []
        row_of = used[start:end]
        found = numbers[row_of].tolist() if len(numbers) else []
        contour = d.contour[row_of].tolist() if len(d) else []
        appended = last[row_of].tolist() if len(d) else []
        for i, row in enumerate(row_of.tolist()):
            x, y, z = xyz[i]
            if row < 0:
                reason = reasons.get(start + i, "")
                out.append(f",{x:.12g},{y:.12g},{z:.12g},,,,,0,,{level[i]},,,{line[i]},{reason}{empty}\n")
                continue
            s, nx, ny, value, filtered, predicted, commanded = found[i]
            wrong = outlier[row]
            out.append(
                f"{s:.12g},{x:.12g},{y:.12g},{z:.12g},{nx:.12g},{ny:.12g},{value:.12g},{filtered:.12g},"
                f"{0 if wrong and left_out else 1},{contour[i]},{level[i]},{predicted:.12g},{commanded:.12g},{line[i]},"
                f"{'outlier' if wrong else ''}"
                + "".join(f",{value:.12g}" for value in appended[i])
                + "\n"
            )
        yield "".join(out)


def _quoted(text: str) -> str:
    return '"' + text.replace('"', '""') + '"'
