# SPDX-License-Identifier: LGPL-2.1-or-later
"""What to correct."""

from __future__ import annotations

from dataclasses import dataclass, field

from millcorr import nc
from millcorr.correction.settings import Settings
from millcorr.geometry.correction import Correction
from millcorr.geometry.profile import Profile
from millcorr.process.setup_file import Setup
from millcorr.readers.measurement import Measurement


@dataclass(frozen=True, eq=False, slots=True)
class Request:
    """What to correct.

    Parameters
    ----------
    program : Program
        The NC program, or the text of a CAM operation's path.
    radius : float
        Cutter radius in mm.
    measurement : Measurement or None
        None lays the path on the exact nominal and corrects nothing.
    nominal : Profile, optional
        The profile the part should have; by default what the program cuts.
    settings : Settings
    further : tuple of Measurement
        Further parts cut with the same program; the first one's deviations become the mean of all. Where they were
        cut at other depths, they tell the transfer function from a constant offset.
    smoothed : Correction, optional
        What to take out, mm over arc length, in place of what this part shows: smoothed over the parts of a series. Of
        a program that was corrected before the deviation from the nominal, of another one what the machine adds.
    setup : Setup, optional
        Tool, material, machine and stock, for the methods that simulate.
    nominal_is_first_program : bool
        True where the nominal is what the first, uncorrected program cuts: the path keeps that program's form.
    shift : Correction, optional
        Displacement of the nominal that is known beforehand, in place of one from a measurement.
    """

    program: nc.Program
    radius: float
    measurement: Measurement | None
    nominal: Profile | None = None
    settings: Settings = field(default_factory=Settings)
    further: tuple[Measurement, ...] = ()
    smoothed: Correction | None = None
    setup: Setup | None = None
    shift: Correction | None = None
    in_series: bool = False
    nominal_is_first_program: bool = False

    @property
    def measurements(self) -> tuple[Measurement, ...]:
        """All measured parts; none where nothing was measured."""
        return () if self.measurement is None else (self.measurement, *self.further)
