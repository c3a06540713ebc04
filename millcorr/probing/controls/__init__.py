# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measuring programs: a plan of touches written for a control, so that its log is read back by `millcorr.readers`.

One module a dialect. All log ball centres in mm in the work frame (GRBL: in the machine frame), so that the ball is
compensated along the contour's normal and not along the axis of travel.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from millcorr.errors import UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import at_z, option, phrase, xy
from millcorr.nc.toolpath import Toolpath
from millcorr.probing import Placement, TouchProbe, plan
from millcorr.probing.heights import Cleared, Room, room_of
from millcorr.probing.planning import ProbingPlan, Wanted, wanted
from millcorr.probing.room import outside_cleared
from millcorr.probing.standing import Meets, Standing, meets
from millcorr.probing.workpiece import Workpiece

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
    workpiece: Workpiece | None = None,
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
    workpiece : Workpiece, optional
        The finished part: touches where it has no wall at that height are left out, and ways keep clear of it.

    Returns
    -------
    MeasuringProgram

    Raises
    ------
    UsageError
        If an option has no such value, or a height is below what `cleared` and `workpiece` vouch for.
    RefusedError
        If no point can be touched.
    """
    if dialect not in DIALECTS:
        raise UsageError(phrase("{} is one of {}, not {!r}", option("dialect"), ", ".join(DIALECTS), dialect))
    if isinstance(cleared, tuple):
        cleared = Cleared(*cleared)
    room = _NOWHERE if cleared is None else room_of(cleared, profile, placement.contour)
    room.refuse(z, safe_z, probe, np.nan if workpiece is None else workpiece.top)
    at = wanted(profile, placement, probe)
    standing = _standing(workpiece, room, at)
    cutter_radius = 0.0 if cleared is None else cleared.radius
    if standing is None:
        touches = plan(profile, at, probe, cutter_radius)
        met = meets(np.array([room.floor]), np.array([np.nan]), z, probe)
    else:
        met = standing.meets(at.contact, at.normal, z, probe)
        obstacles = standing.obstacles(z, probe, met)
        touches = plan(profile, at, probe, cutter_radius, standing=met.tip | met.centre, obstacles=obstacles)
        met = standing.meets(touches.contact, touches.normal, z, probe)
    made = written(Job(touches, z, safe_z, feed, positioning, name, log, tool, source), dialect, DIALECTS[dialect])
    warnings = _length_matters(met)
    if workpiece is not None and standing is None:
        warnings.append(phrase("the model has no wall on this contour: heights are judged by the passes only"))
    if standing is None and z > room.shown(probe):
        warnings.append(
            phrase(
                "nothing shows that the wall stands as high as {}: the highest pass beside it runs at {}",
                at_z(z),
                at_z(room.level),
            )
        )
    if cleared is not None:
        warnings += _uncleared(touches, cleared, z if not met.centre.all() else z - probe.ball_radius)
    return replace(made, warnings=tuple(warnings))


_NOWHERE = Room(np.nan, np.nan, np.nan, np.nan, np.nan)
"""What is known of heights without a program."""


def _standing(workpiece: Workpiece | None, room: Room, at: Wanted) -> Standing | None:
    """What stands beside the contour; None where no model is at hand, or it has no wall on the contour."""
    if workpiece is None or not len(workpiece.walls(at.contact, at.normal).place):
        return None
    return Standing(workpiece, room.floor)


def _length_matters(met: Meets) -> list[str]:
    """Where touches are right only with the probe's length set to one end of the ball's radius."""
    out: list[str] = []
    if (met.tip & ~met.centre).any():
        out.append(
            phrase(
                "this height is right only for a probe whose length was set to the tip of the ball, not to its centre"
            )
        )
    if (met.centre & ~met.tip).any():
        out.append(
            phrase(
                "this height is right only for a probe whose length was set to the centre of the ball, not to its tip"
            )
        )
    return out


def _uncleared(touches: ProbingPlan, cleared: Cleared, lowest: float) -> list[str]:
    """A warning where the ball, its lowest point at a height in mm, leaves the space that a program clears."""
    outside = outside_cleared(touches, cleared, lowest)
    if not len(outside):
        return []
    x, y = outside[0]
    return [
        phrase(
            "the ball leaves the space that the program clears, first near {}: make sure that nothing stands there, "
            "or say how far it is free with {} and lower {}",
            xy(x, y),
            option("free_width"),
            option("clearance"),
        )
    ]


def heights(
    profile: Profile,
    placement: Placement,
    probe: TouchProbe,
    cleared: Cleared | None = None,
    workpiece: Workpiece | None = None,
) -> tuple[float | None, float | None]:
    """Height to measure at and safe height that the model and a milling program suggest, mm; None: they show none.

    The first is in the middle between bottom and top of the wall, where most places have one: that of the model as
    deep as it is cut, else what the passes show. It is right whether the probe's length was set to the tip of the
    ball or to its centre. The second is the highest rapid, and above the model.

    Parameters
    ----------
    profile : Profile
        Contour to measure.
    placement : Placement
    probe : TouchProbe
    cleared : Cleared, optional
    workpiece : Workpiece, optional

    Raises
    ------
    UsageError, RefusedError
        If there is no such contour or stretch, or every stretch is too short.
    """
    room = _NOWHERE if cleared is None else room_of(cleared, profile, placement.contour)
    at = wanted(profile, placement, probe)
    standing = _standing(workpiece, room, at)
    z = room.height(probe) if standing is None else standing.height(at.contact, at.normal, probe)
    return z, room.safe(probe, np.nan if workpiece is None else workpiece.top)
