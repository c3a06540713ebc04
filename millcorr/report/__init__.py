# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a correction, of a series and of a simulation, as files that need nothing but themselves."""

from .files import FILES, summary, write

__all__ = ["FILES", "summary", "write"]
