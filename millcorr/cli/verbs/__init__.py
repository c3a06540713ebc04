# SPDX-License-Identifier: LGPL-2.1-or-later
"""From file names to files, a function a verb: read, do, prove, and only then write everything as a whole."""

from millcorr.production.simulation import Asked

from .correcting import CorrectionAsked, correct_document, correct_program
from .first_cut import split_program
from .inputs import program_request, read_nominal, require_measured
from .journals import history
from .measured_files import convert, inspect
from .simulating import simulate_program

__all__ = [
    "Asked",
    "CorrectionAsked",
    "convert",
    "correct_document",
    "correct_program",
    "history",
    "inspect",
    "program_request",
    "read_nominal",
    "require_measured",
    "simulate_program",
    "split_program",
]
