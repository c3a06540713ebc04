# SPDX-License-Identifier: LGPL-2.1-or-later
"""Correct milling toolpaths from measured parts.

Lengths are millimetres, angles radians, feeds millimetres a second inside the package; a positive
deviation is excess material.
"""

__version__ = "0.1.0"
