# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's door without a window; millcorr's modules are imported when a document or a script needs them."""
