# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program cut in the model of a setup, as it is and with its predicted error corrected."""

from __future__ import annotations

from .errors import RefusedError
from .pipeline import Request, correct, nominal_from_program
from .prediction import Simulation, simulate
from .prediction.foreseen import require_setup


def simulated(request: Request) -> tuple[Simulation, Simulation | None, str]:
    """Simulate a program and its correction.

    Parameters
    ----------
    request : Request
        With a setup and method ``predicted``.

    Returns
    -------
    before : Simulation
        Of the program as it is.
    after : Simulation or None
        Of the corrected program; None where the correction is refused.
    refused : str
        Why there is no `after`.

    Raises
    ------
    MillcorrError
        If program or setup cannot be used.
    """
    try:
        foreseen = correct(request).foreseen
    except RefusedError as error:
        setup, nominal = require_setup(request.setup, request.settings, request.radius), request.nominal
        if nominal is None:
            nominal = nominal_from_program(request.program, request.radius, request.settings, None)
        return simulate(request.program, setup, nominal), None, str(error)
    assert foreseen is not None
    return foreseen.before, foreseen.after[-1], ""
