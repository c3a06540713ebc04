# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs: read into a toolpath, and written back with every untouched character kept."""

from .families import parse, read, write
from .program import Program

__all__ = ["Program", "parse", "read", "write"]
