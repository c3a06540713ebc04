# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys of a setup's machine, identified from a logged trace of a program."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from millcorr.errors import UsageError
from millcorr.messages import Place, option, phrase
from millcorr.nc import Program
from millcorr.process.kinematics import AxisDynamics, Constant, Control, Trace, identify
from millcorr.process.setup_file import Setup

from .real_feed import control_of
from .simulated import halts_and_notes

KEYS = {
    "acceleration_time_x_ms": ("x.time", 1000.0),
    "acceleration_time_y_ms": ("y.time", 1000.0),
    "position_gain_per_s": ("kv", 1.0),
    "contour_speed_change_mm_min": ("contour.speed_change", 60.0),
}
"""Keys of [machine] that a trace can tell: name in `millcorr.process.kinematics.identification`, and units of the key
in it."""


@dataclass(frozen=True, eq=False, slots=True)
class LoggedMachine:
    """What a trace says of a setup's machine.

    Parameters
    ----------
    setup : Setup
        With the identified keys.
    keys : dict of str to Constant
        In the keys' units, with standard uncertainties; see `millcorr.process.kinematics.Identification`.
    residual : float
        Robust standard deviation of trace minus model, in mm (positions) or mm/s (feed).
    positions : bool
        Whether positions were logged, else the feed.
    source : str
        File of the trace.
    """

    setup: Setup
    keys: dict[str, Constant]
    residual: float
    positions: bool
    source: str

    def lines(self) -> list[str]:
        """The keys as they go into a setup file, with their uncertainties."""
        return [f"{key} = {found.value:.5g}  # +- {found.uncertainty:.2g}" for key, found in self.keys.items()]

    def summary(self) -> dict[str, Any]:
        """What simulation.json says of it; standard uncertainties."""
        return {
            "trace": self.source,
            "residual": self.residual,
            "residual_unit": "mm" if self.positions else "mm/s",
            "machine": {k: {"value": c.value, "uncertainty": c.uncertainty} for k, c in self.keys.items()},
        }


def logged_machine(setup: Setup, program: Program, trace: Trace, keys: Sequence[str] = ()) -> LoggedMachine:
    """Identify keys of [machine] from a trace of a program.

    What the setup states of the other keys is taken as known.

    Parameters
    ----------
    setup : Setup
        Shape of acc/dec, contour control and what is known; values of the wanted keys are first guesses.
    program : Program
        What the machine ran while it was logged.
    trace : Trace
    keys : sequence of str
        From `KEYS`; by default times and gain that the setup does not state.

    Returns
    -------
    LoggedMachine

    Raises
    ------
    UsageError
        If nothing is left to identify, or no trace can tell what is asked.
    FitError
        If the trace does not determine a key, or is not one of this program.
    """
    machine = setup.machine
    wanted = tuple(dict.fromkeys(keys)) or tuple(key for key in list(KEYS)[:3] if not getattr(machine, key))
    if not wanted:
        raise UsageError(
            phrase(
                "{}: [machine] states all that a trace can tell: name with {} what is to be identified anew",
                Place(setup.source or "setup"),
                option("identify"),
            ),
        )
    known = control_of(setup) or Control.alike(AxisDynamics(shape=machine.acceleration_shape))
    names = [KEYS[key][0] for key in wanted]
    called = dict(zip(names, wanted, strict=True))
    found = identify(trace, program.toolpath, known, names, halts=halts_and_notes(program)[0], called=called)
    constants = {
        key: Constant(KEYS[key][1] * c.value, KEYS[key][1] * c.uncertainty)
        for key, c in zip(wanted, (found.constants[name] for name in names), strict=True)
    }
    values: dict[str, Any] = {key: constant.value for key, constant in constants.items()}
    positions = bool((trace.position[:, :2] == trace.position[:, :2]).all())
    changed = replace(setup, machine=replace(machine, **values))
    return LoggedMachine(changed, constants, found.residual, positions, trace.source)
