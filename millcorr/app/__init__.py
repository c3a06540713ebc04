# SPDX-License-Identifier: LGPL-2.1-or-later
"""The FreeCAD side of millcorr that needs no window: objects, conversions, batch."""
