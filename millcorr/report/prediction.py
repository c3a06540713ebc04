# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report's section on what the model of a setup says: its machine, and the error before and after."""

from __future__ import annotations

import math
from html import escape
from pathlib import PurePath

from millcorr.messages import phrase
from millcorr.pipeline import Result
from millcorr.process.prediction.predicted_correction import Prediction

from . import reader
from .html import STATISTICS, capital, heading, html_facts, html_table, mm, plural, statistics_of, um, with_unit

_BESIDE = "\N{PLUS-MINUS SIGN}"


def nothing_measured(result: Result) -> bool:
    """True where the deviations are those of a predicted surface."""
    return result.prediction is not None and result.prediction.axes is None


def setup_name(prediction: Prediction) -> str:
    """Name of the setup's file."""
    return PurePath(prediction.before.setup.source).name or "the setup"


def prediction_section(result: Result) -> str:
    """The section as HTML; '' where nothing was simulated."""
    prediction = result.prediction
    if prediction is None:
        return ""
    if prediction.axes is None:
        words = (
            "Nothing was measured: the program was cut in the model of the setup, and the surface that this leaves "
            "taken as a measured one is. How large the correction is, is the model's alone: touch the first part."
        )
    else:
        words = (
            "The touches say how far tool and machine give way, the load along the path how that varies along the "
            "contour (Petrakov 2023, eqs. 9 to 12). The machine that leaves what was touched then cut the program "
            "and the corrected one in the model."
        )
    rounds = prediction.after
    names = ["after"] if len(rounds) == 1 else [f"after round {k}" for k in range(1, len(rounds) + 1)]
    rows = []
    for name, cut in zip(["before", *names], [prediction.before, *rounds], strict=True):
        rows.append((name, um(cut.largest), *statistics_of(cut.deviation.value)))
    table = html_table((phrase("error expected / {}", reader.fine()), phrase("largest"), *STATISTICS), rows)
    notes = [text for text in result.advice if text not in prediction.advice()]
    more = "".join(f"<p>{escape(capital(text))}.</p>" for text in notes)
    title = heading(phrase("Predicted by the model"))
    return f"{title}<p>{words}</p>{html_facts(_facts(result, prediction))}{table}{more}"


def _facts(result: Result, prediction: Prediction) -> list[tuple[str, str]]:
    axes, machine = prediction.axes, prediction.machine
    its = prediction.before.setup.machine
    kx, ky = its.stiffness()
    along = "".join(f"; at s = {reader.length(at)} {x:.0f}, {y:.0f}" for at, x, y in its.stiffness_along)
    facts = [("Setup", setup_name(prediction))]
    if axes is not None and machine is not None:
        (x, y), (ux, uy) = axes.ms, axes.ms_std
        told = "" if axes.separate else "; the touches do not tell the axes apart: both are taken alike"
        facts += [
            ("Transfer function of the axes", f"MSx {_with(x, ux)}, MSy {_with(y, uy)} at the first touch{told}"),
            ("Depth of the touched part", f"{mm(axes.depth)} {reader.coarse()}"),
            (
                "Machine that leaves what was touched",
                f"stiffness X {kx:.4g} N/mm, Y {ky:.4g} N/mm{along} with the setup's forces, within "
                f"{with_unit(machine.misfit)} of the touches",
            ),
        ]
    else:
        facts.append(("Machine of the setup", f"stiffness X {kx:.4g} N/mm, Y {ky:.4g} N/mm{along}"))
    bound = result.request.settings.iterate
    wanted = "" if bound is None else f", until at most {with_unit(bound)} are expected"
    return [*facts, ("Corrected and simulated", f"{plural(len(prediction.after), 'time')}{wanted}")]


def _with(value: float, std: float) -> str:
    """A value with its standard uncertainty, where that is known."""
    return f"{value:.4f}" + (f" {_BESIDE} {std:.4f}" if math.isfinite(std) else "")
