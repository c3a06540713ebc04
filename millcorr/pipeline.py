# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one use case: a program and a measurement in, a corrected toolpath with its proof out."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.geometry.correction import Correction

from . import __version__
from . import nc as gcode
from . import plausibility as distrust
from .comparison import alignment
from .comparison.deviation import Deviation, Rejected, statistics
from .correction.settings import Settings as Settings
from .correction.wanted_displacement import Elastic, WantedDisplacement
from .geometry.correction import largest_correction
from .geometry.profile import Profile
from .messages import message, message_of, phrase
from .path.moves import Regeneration
from .path.verification import Verification
from .process.prediction.predicted_correction import FirstCut, Prediction
from .separation import Filter, Separated
from .separation.steps import Systematic
from .stages.aimed import Aimed, aim
from .stages.compared import Compared, compare
from .stages.prepared import Prepared, prepare
from .stages.prepared import nominal_from_program as nominal_from_program
from .stages.request import Request as Request
from .stages.written import Written, header, write

OUTLIER = phrase("an outlier: more probably wrong than right, by its neighbours")
"""Why a point is left out by the filter."""


@dataclass(frozen=True, eq=False)
class Result:
    """A correction and its proof.

    Parameters
    ----------
    request : Request
    nominal, compensated : Profile
    correction : Correction
    alignment : Alignment or None
        What the best fit moved; None without one.
    deviation : Deviation
        Against the nominal; empty without a measurement.
    filtered : (n,) float64
        Determined part of each deviation, mm.
    uncertainty : (n,) float64
        Standard uncertainty (k = 1) of the determined part at each point, mm; NaN where it is not known.
    predicted : (n,) float64
        What the same machine is expected to leave at each point after the correction, mm.
    commanded : (n,) float64
        Offset of the program's own contour from the nominal at each point, mm.
    carried : Correction or None
        The same all along the contour, for a program that was corrected before; None for another one.
    systematic : Systematic or None
        What repeats, anywhere on the contours; None without a measurement of the whole contour.
    outlier : (n,) bool
        Points that are more probably wrong than right; the model and robust filters leave them out.
    random_std : float
        Standard deviation of the random part, mm; NaN where it is not known.
    elastic : Elastic or None
        Transfer function at the used points, and the depth it was carried to; None without one.
    prediction : Prediction or None
        What the model of a setup says before and after; None without one.
    regeneration : Regeneration
    path_radius : float
        Distance in mm between path and contour: the cutter radius, or 0 where the program gives the contour.
    fit_residual : float
        Largest distance between the exact compensated contour and its NURBS, mm.
    verification : Verification
    text : bytes
        The corrected program; the very bytes of the original where nothing changed.
    advice : tuple of str
        What to expect of the next part, and what the readers did or left out beyond copying numbers.
    warnings : tuple of str
        What may be wrong or was not possible.
    noted : tuple of (24,) int64
        Deviations of each part that the corrected program notes, to recognise the part by.
    """

    request: Request
    nominal: Profile
    compensated: Profile
    correction: Correction
    alignment: alignment.Alignment | None
    deviation: Deviation
    filtered: Floats
    uncertainty: Floats
    predicted: Floats
    commanded: Floats
    carried: Correction | None
    systematic: Systematic | None
    outlier: Bools
    random_std: float
    elastic: Elastic | None
    prediction: Prediction | None
    regeneration: Regeneration
    path_radius: float
    fit_residual: float
    verification: Verification
    text: bytes
    advice: tuple[str, ...]
    warnings: tuple[str, ...]
    noted: tuple[Ints, ...] = ()

    @property
    def correction_uncertainty(self) -> Floats:
        """Standard uncertainty of the correction at each point, mm; NaN where it is not known. (n,)."""
        elastic = self.elastic
        own = self.uncertainty if elastic is None else elastic.transfer.correction_std(elastic.next_depth)
        return self.request.settings.gain * own

    @property
    def separated(self) -> Separated | None:
        """What repeats where the form is kept; None without a measurement of the whole contour."""
        return None if self.systematic is None else self.systematic.separated

    def summary(self) -> dict[str, Any]:
        """The contents of report.json."""
        return dict(self._summary)

    @cached_property
    def _summary(self) -> dict[str, Any]:
        curves = [c.as_dict() for contour in self.compensated.contours for c in contour.curves]
        first = curves[0]
        keys = ("degree", "poles", "weights", "knots", "multiplicities", "periodic")
        d = self.deviation
        uncertainty = statistics(self.uncertainty[np.isfinite(self.uncertainty)])
        largest = largest_correction(self.correction, self.nominal)
        return {
            "millcorr": __version__,
            "unit": "mm",
            "points": {
                "parts": len(self.request.measurements),
                "read": len(d) + len(d.rejected),
                "used": len(d) + len(d.rejected) - len(self.left_out),
                "left_out": len(self.left_out),
                "rejected": [{"index": r.index, "reason": r.reason} for r in d.rejected],
            },
            "deviation": statistics(d.value),
            "filtered": statistics(self.filtered),
            "random_std": self.random_std,
            "path_error_of_program": self.regeneration.original_error,
            "predicted": statistics(self.predicted),
            "correction": {
                "max": self.correction.largest,
                "limited": 0,
                "largest": largest.value,
                "place": list(largest.point),
                "uncertainty_max": float(np.fmax.reduce(self.correction_uncertainty, initial=np.nan)),
            },
            "uncertainty": uncertainty,
            "band": None if self.separated is None else self.separated.band,
            "band_longest_memory": None if self.separated is None else self.separated.longest_memory,
            "outliers": self.outliers(),
            "unmeasured": 0.0 if self.separated is None else distrust.unmeasured(self.separated, self.nominal),
            "transfer": None if self.elastic is None else self.elastic.summary(self.request.settings),
            "foreseen": None if self.prediction is None else self.prediction.summary(),
            "alignment": self._alignment_summary(),
            "profile": {k: first[k] for k in keys} | {"curves": curves, "fit_residual": self.fit_residual},
            "verification": {
                "path_error_max": self.verification.path_error_max,
                "gouge_max": self.verification.gouge_max,
                "length": self.verification.length,
            },
            "moves": {"changed": self.regeneration.changed, "written": len(self.regeneration.toolpath)},
            "inputs": self.inputs(),
            "settings": {name: getattr(self.request.settings, name) for name in Settings.__slots__},
            "accepted": [
                {"finding": one.finding, "place": one.place and list(one.place)}
                for text in self.warnings
                for one in message_of(text).accepted
            ],
            "advice": list(self.advice),
            "warnings": list(self.warnings),
        }

    @property
    def left_out(self) -> tuple[Rejected, ...]:
        """Points without a say in the correction: those rejected, and outliers where the filter leaves them out."""
        d = self.deviation
        outliers = d.index[self.outlier] if Filter.parse(self.request.settings.filter).leaves_out else ()
        return (*d.rejected, *(Rejected(int(index), OUTLIER) for index in outliers))

    def outliers(self) -> list[dict[str, Any]]:
        """Points that are more probably wrong than right, by their row of the file; lengths in mm."""
        measurement, d = self.request.measurement, self.deviation
        if measurement is None:
            return []
        rows = np.flatnonzero(self.outlier)
        points = measurement.points[d.index[rows]].tolist()
        return [
            {
                "index": int(d.index[i]),
                **dict(zip("xyz", point, strict=True)),
                "value": float(d.value[i]),
                "expected": float(self.filtered[i]),
            }
            for i, point in zip(rows, points, strict=True)
        ]

    def _alignment_summary(self) -> dict[str, Any]:
        fit = self.alignment
        if fit is None:
            return {"shift": [0.0, 0.0], "rotation_deg": 0.0}
        return {
            "shift": list(fit.transform.shift),
            "rotation_deg": float(np.degrees(fit.transform.rotation)),
            "free": list(fit.free),
            "undetermined": list(fit.undetermined),
            "mean_before": fit.before.mean,
            "mean_after": fit.after.mean,
            "rms_before": fit.before.rms,
            "rms_after": fit.after.rms,
            "scale": fit.scale,
        }

    def inputs(self) -> dict[str, Any]:
        """Names and SHA-256 of what went in."""
        program = self.request.program
        out: dict[str, Any] = {"program": {"name": program.name, "sha256": program.digest}}
        for number, measurement in enumerate(self.request.measurements, 1):
            key = "measurement" if number == 1 else f"measurement {number}"
            out[key] = {"name": measurement.source, "sha256": measurement.digest}
        return out

    def header(self) -> tuple[str, ...]:
        """Comment lines that mark the corrected program."""
        return header(self.request, self.noted)


def correct(request: Request, *, check: bool = False) -> Result:
    """Correct a toolpath from a measured part.

    Parameters
    ----------
    request : Request
    check : bool
        True where nothing will be written: a measurement that the program carries already is then looked at, with a
        warning, in place of being refused.

    Returns
    -------
    Result

    Raises
    ------
    UsageError, InputError, FormatError
        If the request or a file cannot be used.
    RefusedError, LimitError, FitError
        If the correction would be unsafe: nothing is changed.
    """
    prepared = prepare(request, check=check)
    compared = compare(prepared)
    first = _first_cut(prepared) if prepared.setup is not None else None
    aimed = aim(prepared, compared, first)
    return _result(prepared, compared, aimed, write(prepared, aimed, compared.noted))


def _result(prepared: Prepared, compared: Compared, aimed: Aimed, written: Written) -> Result:
    """What all stages found."""
    work, nominal, emission = aimed.work, prepared.passes.nominal, written.emission
    said = (*prepared.notes, *compared.notes, *aimed.notes)
    none = np.zeros(len(work.deviation))
    applied = written.correction.at(work.deviation.stretch, work.deviation.s, nominal) if len(none) else none
    prediction = written.prediction
    return Result(
        request=aimed.request,
        nominal=nominal,
        compensated=emission.compensated,
        correction=written.correction,
        alignment=compared.aligned,
        deviation=work.deviation,
        filtered=work.filtered,
        uncertainty=work.uncertainty,
        predicted=work.predicted(applied) if prediction is None else prediction.left_at(work),
        commanded=work.commanded,
        carried=aimed.carried,
        systematic=work.systematic,
        outlier=none > 0 if work.outlier is None else work.outlier,
        random_std=work.random_std,
        elastic=work.elastic,
        prediction=prediction,
        regeneration=emission.regeneration,
        path_radius=prepared.passes.radius,
        fit_residual=emission.fit_residual,
        verification=emission.verification,
        text=emission.text,
        advice=(
            *(_advice(work, aimed.request.settings) if prediction is None else prediction.advice()),
            *(message(f"{m.source}: ", note) for m in aimed.request.measurements for note in m.notes),
        ),
        warnings=(*said, *(note for note in written.notes if note not in said)),
        noted=compared.noted,
    )


def _first_cut(prepared: Prepared) -> FirstCut | None:
    """What cut the touched part of a single piece, as `millcorr split` writes it."""
    request, allowance = prepared.request, next(iter(prepared.allowances), 0.0)
    if not allowance:
        return None
    settings = Settings(
        side=request.settings.side,
        cutter_compensation=request.settings.cutter_compensation,
        tolerance=request.settings.tolerance,
        leave_stock=allowance,
    )
    done = correct(Request(request.program, request.radius, None, request.nominal, settings))
    program = gcode.parse(done.text, f"first cut of {request.program.name}")
    return FirstCut(program, done.compensated, allowance)


def _advice(work: WantedDisplacement, settings: Settings) -> tuple[str, ...]:
    """What to expect of the next part."""
    if not len(work.deviation):
        return ()
    if work.elastic is not None:
        return work.elastic.advice(settings)
    if settings.gain == 1.0:
        return ()
    left = 100 * (1 - settings.gain)
    return (phrase("gain {:g} leaves {:.0f} % of the determined deviation on purpose", settings.gain, left),)
