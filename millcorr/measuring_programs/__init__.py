# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measuring programs: a plan of touches written for a control, so that its log is read back by `millcorr.readers`.

One module a dialect. All log ball centres in mm in the work frame (GRBL: in the machine frame), so that the ball is
compensated along the contour's normal and not along the axis of travel.
"""

from __future__ import annotations

from dataclasses import replace

from millcorr.errors import UsageError
from millcorr.probing import Placement, TouchProbe, plan
from millcorr.probing.heights import Cleared, room_of
from millcorr.probing.room import outside_cleared
from millcorr.profile import Profile
from millcorr.toolpath import Toolpath

from .grbl import Grbl
from .heidenhain import Heidenhain
from .linuxcnc import LinuxCnc
from .names import Names, names_of
from .okuma import Okuma
from .program import HEADLINE, Dialect, Job, MeasuringProgram, written
from .renishaw import InspectionPlus
from .siemens import Siemens

__all__ = [
    "DIALECTS",
    "HEADLINE",
    "Cleared",
    "Dialect",
    "Job",
    "MeasuringProgram",
    "Names",
    "heights",
    "measuring_program",
    "names_of",
    "written",
]

DIALECTS: dict[str, Dialect] = {
    "linuxcnc": LinuxCnc(protected=False),
    "linuxcnc-protected": LinuxCnc(protected=True),
    "grbl": Grbl(),
    "fanuc": InspectionPlus("Fanuc", first_result=135),
    "haas": InspectionPlus("Haas", first_result=185),
    "okuma": Okuma(),
    "heidenhain": Heidenhain(),
    "siemens": Siemens(),
}
"""What writes each dialect, by the name that ``--dialect`` takes."""


def measuring_program(
    profile: Profile,
    *,
    dialect: str,
    probe: TouchProbe,
    placement: Placement,
    z: float,
    safe_z: float,
    feed: float = 100.0,
    positioning: float = 1000.0,
    name: str = "PROBE",
    log: str | None = None,
    tool: int | None = None,
    source: str = "",
    cleared: Cleared | tuple[Toolpath, float] | None = None,
) -> MeasuringProgram:
    """Plan touches on a contour and write them for a control.

    Parameters
    ----------
    profile : Profile
        Nominal, material on the left.
    dialect : str
        Name from `DIALECTS`.
    probe : TouchProbe
    placement : Placement
    z, safe_z : float
        Height in mm at which is measured, and at which the probe passes over everything.
    feed, positioning : float
        Feed of the touch and of moves at measuring height, mm/min.
    name : str
        Name of the program; on Fanuc and Haas a number.
    log : str, optional
        Name of the file that the control writes.
    tool : int, optional
        Number of the probe in the magazine; without it the probe must be in the spindle, its length active.
    source : str
        What the contour comes from, for the program's head.
    cleared : Cleared or (Toolpath, float), optional
        Milling program and its cutter's radius in mm: the fillets that this leaves in inner corners are kept clear
        of. What lies outside the space that the program clears is unknown: a way that leads there makes a warning.
        Neither height may lie below what the program shows.

    Returns
    -------
    MeasuringProgram

    Raises
    ------
    UsageError
        If an option has no such value, or a height is below what `cleared` vouches for.
    RefusedError
        If no point can be touched.
    """
    if dialect not in DIALECTS:
        raise UsageError(f"--dialect is one of {', '.join(DIALECTS)}, not {dialect!r}")
    if isinstance(cleared, tuple):
        cleared = Cleared(*cleared)
    touches = plan(profile, placement, probe, 0.0 if cleared is None else cleared.radius)
    job = Job(touches, z, safe_z, feed, positioning, name, log, tool, source)
    if cleared is not None:
        room_of(cleared, profile, placement.contour).refuse(z, safe_z)
    made = written(job, dialect, DIALECTS[dialect])
    if cleared is None:
        return made
    outside = outside_cleared(touches, cleared, z)
    if not len(outside):
        return made
    x, y = outside[0]
    warning = (
        f"the ball leaves the space that the program clears, first near X{x:.3f} Y{y:.3f}: make sure that nothing "
        "stands there, or say how far it is free with --free-width and lower --clearance"
    )
    return replace(made, warnings=(warning,))


def heights(
    cleared: Cleared | Toolpath, profile: Profile | None = None, contour: int | None = None
) -> tuple[float, float] | None:
    """Height to measure at and safe height that a milling program suggests, mm; None where it shows none.

    Half of the depth beside the contour below Z0 (or 1 mm above that where it is not below), and the highest rapid.

    Parameters
    ----------
    cleared : Cleared or Toolpath
    profile : Profile, optional
        Contour to measure; without it every cut counts, wherever it is.
    contour : int, optional
        Only beside this one of the profile's contours, counted from 1.
    """
    known = cleared if isinstance(cleared, Cleared) else Cleared(cleared, 0.0)
    return room_of(known, profile, contour).suggested()
