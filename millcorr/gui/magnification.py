# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two fields of a form that say how much larger deviations are drawn: by themselves, or as the user says."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from millcorr.app.text import translate
from millcorr.report.magnification import GREATEST


class MagnificationFields:
    """Two fields of a form, one that switches and one for the number.

    Parameters
    ----------
    fields : mapping of str to Field
        Of the form; among them ``AutomaticMagnification`` and ``Magnification``.
    """

    def __init__(self, fields: Mapping[str, Any]) -> None:
        self._automatic, self._number = fields["AutomaticMagnification"], fields["Magnification"]
        box = self._number.widget
        before = box.blockSignals(True)
        box.setDecimals(0)
        box.setRange(1.0, GREATEST)
        box.setSuffix(":1")
        box.setSingleStep(10.0)
        box.blockSignals(before)

    @property
    def wanted(self) -> float | None:
        """What the user wants; None where it is chosen by itself."""
        return None if self._automatic.value else float(self._number.value)

    def chosen(self) -> None:
        """The switch was turned: the number can be written, or not."""
        self._number.widget.setEnabled(not self._automatic.value)

    def show(self, magnification: float) -> None:
        """Show by how much is drawn; and where that is less than the user wants, why."""
        self.chosen()
        if self._automatic.value:
            self._number.show_value(magnification)
        elif self._number.value > magnification:
            text = translate("Millcorr", "Drawn at {:.4g}:1: more would turn the contour inside out.")
            self._number.complain(text.format(magnification))
