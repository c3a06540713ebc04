# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs: read into a toolpath, and written back with every untouched character kept."""

from .program import Program, parse, read
from .writer import write

__all__ = ["Program", "parse", "read", "write"]
