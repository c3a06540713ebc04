# SPDX-License-Identifier: LGPL-2.1-or-later
"""Single-piece production: the program of a first cut, which leaves a part of the allowance for the corrected one.

Petrakov 2025: cut the first half of the allowance, measure on the machine, and let the transfer function found there
correct the second half.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from millcorr import nc
from millcorr.correction import provenance
from millcorr.correction.settings import Settings
from millcorr.errors import InputError, UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import option, phrase
from millcorr.pipeline import Request, Result, correct


@dataclass(frozen=True, eq=False, slots=True)
class Split:
    """The first of two cuts.

    Parameters
    ----------
    left : float
        Allowance that the first cut leaves on the finished contour, mm.
    depth : float
        Depth of the first cut along the normal, mm.
    result : Result
        The first program, and its proof. Its nominal is what the finishing program cuts, with a sharp corner
        where the first cut has no room for a small fillet.
    """

    left: float
    depth: float
    result: Result


def split(
    program: nc.Program,
    radius: float,
    depth: float,
    at: float = 0.5,
    *,
    settings: Settings | None = None,
    nominal: Profile | None = None,
) -> Split:
    """The program of the first cut: the finishing path moved out by the allowance that is to remain.

    Parameters
    ----------
    program : Program
        The finishing program.
    radius : float
        Cutter radius, mm.
    depth : float
        Whole allowance H over the finished contour along the normal, mm.
    at : float
        Share of it that the first cut takes, above 0 and below 1.
    settings : Settings, optional
        Its side, cutter compensation, tolerance, output moves, and the axis along which open ends move.
    nominal : Profile, optional
        By default what the program cuts.

    Returns
    -------
    Split

    Raises
    ------
    UsageError
        If a number makes no sense, or the side is not known.
    InputError
        If the program was corrected before, or cuts no contour.
    LimitError
        If the contour moved out has no room for the cutter, or would cross itself.
    """
    if not 0 < depth < float("inf"):
        raise UsageError(phrase("{}: the allowance must be above 0", option("depth", depth)))
    if not 0 < at < 1:
        raise UsageError(phrase("{}: the first cut takes a share between 0 and 1", option("at", at)))
    carried = provenance.marks(program.comments())
    if carried:
        raise InputError(
            phrase(
                "{}:{}: the program was corrected before; split the first, uncorrected one",
                program.name,
                carried[-1].line,
            )
        )
    # Twelve digits: 0.4 of 2 leaves 1.2, not 1.2000000000000002.
    left = float(f"{depth * (1.0 - at):.12g}")
    chosen = replace(settings or Settings(), leave_stock=left)
    return Split(left, float(f"{depth - left:.12g}"), correct(Request(program, radius, None, nominal, chosen)))
