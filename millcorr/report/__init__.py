# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a correction, of a series and of a simulation, as files that need nothing but themselves."""

from millcorr.correction.settings import Exports

from .exports import files_of
from .files import FILES, NO_EXPORTS, summary, write

__all__ = ["FILES", "NO_EXPORTS", "Exports", "files_of", "summary", "write"]
