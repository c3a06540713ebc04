# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plain-language programs (Klartext, .H) of HEIDENHAIN controls: text to moves and back.

Blocks are taken apart (`blocks`), carried out one after another by a `machine` that knows what the control knows,
with the geometry of corners and approaches in `contour` and Q parameters in `parameters`; `program` makes a `Program`
of it, `writer` writes changed moves back.
"""

from .program import KlartextProgram, parse, recognises
from .writer import write

__all__ = ["KlartextProgram", "parse", "recognises", "write"]
