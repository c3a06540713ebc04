# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs of HEIDENHAIN controls, in plain language (Klartext, .H) and ISO code (DIN/ISO, .I): text to moves and back.

Blocks are taken apart (`blocks`), carried out one after another by a `machine` that knows what the control knows,
with the geometry of corners and approaches in `contour` and Q parameters in `parameters`; `program` makes a `Program`
of it, `writer` writes changed moves back. ISO code is the same blocks in other words: `din` says them in plain
language, `din_program` and `din_writer` go round that.
"""

from . import din_program, din_writer, program, writer
from .din_program import DinProgram
from .program import KlartextProgram

__all__ = ["DinProgram", "KlartextProgram", "din_program", "din_writer", "program", "writer"]
