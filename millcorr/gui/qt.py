# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt as FreeCAD hands it out, whichever version lies beneath.

FreeCAD's PySide offers every widget in its QtGui; a QtWidgets of its own came later.
"""

from PySide import QtCore, QtGui

QtWidgets = QtGui

__all__ = ["QtCore", "QtGui", "QtWidgets"]
