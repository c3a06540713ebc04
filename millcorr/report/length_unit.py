# SPDX-License-Identifier: LGPL-2.1-or-later
"""The unit in which lengths are shown; everything is computed and stored in millimetres."""

from __future__ import annotations

from dataclasses import dataclass

from millcorr.messages import Coordinates, Length


@dataclass(frozen=True, slots=True)
class LengthUnit:
    """A unit of length for what is read by a person.

    Parameters
    ----------
    name, fine : str
        Of the unit, and of the small one for deviations.
    mm, fine_mm : float
        Their sizes, mm.
    digits, fine_digits : int
        Decimals that show a tenth of a micrometre or less.
    step : float
        By which a length is changed, in the unit.
    """

    name: str
    fine: str
    mm: float
    fine_mm: float
    digits: int
    fine_digits: int
    step: float

    def number(self, value: float, sign: str = "") -> str:
        """A length given in mm, as a number in the unit; `sign` is that of Python's format. A rounded zero has none."""
        return f"{value / self.mm:{sign}z.{self.digits}f}"

    def fine_number(self, value: float, sign: str = "+") -> str:
        """The same in the small unit."""
        return f"{value / self.fine_mm:{sign}z.{self.fine_digits}f}"

    def said(self, length: Length) -> str:
        """A length of a message, to as many digits as it is given in mm."""
        number = length.mm / (self.fine_mm if length.fine else self.mm)
        form = length.form
        if form.endswith("f"):
            sign, _, digits = form[:-1].rpartition(".")
            coarser = (self.fine_digits - MM.fine_digits) if length.fine else (self.digits - MM.digits)
            form = f"{sign}.{int(digits) + coarser}f"
        elif self.mm != MM.mm:
            form = ".4g"
        return f"{number:{form}} {self.fine if length.fine else self.name}"

    def coordinates(self, place: Coordinates) -> str:
        """A place of a message; its numbers are in this unit."""
        digits = self.digits - 1
        return " ".join(f"{axis}{v / self.mm:.{digits}f}" for axis, v in zip(place.axes, place.values, strict=True))


MM = LengthUnit("mm", "\N{MICRO SIGN}m", 1.0, 1e-3, 4, 1, 1e-3)
INCH = LengthUnit("in", "thou", 25.4, 0.0254, 6, 3, 1e-4)
"""A thou is a thousandth of an inch; 0.1 um are 0.004 of it."""
