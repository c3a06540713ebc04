# SPDX-License-Identifier: LGPL-2.1-or-later
"""The end mill as a cantilever: how far it bends at any height under a force at any other.

Heights count from the tip towards the holder, in which the shank is clamped (dat-2025, eqs. 2 to 4, fig. 7). Length mm,
force N, Young's modulus GPa at the surface and N/mm^2 inside.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from millcorr.arrays import Floats
from millcorr.errors import UsageError
from millcorr.messages import phrase
from millcorr.process.setup_file import EFFECTIVE_DIAMETER, Setup, Tool

MPA_PER_GPA = 1000.0


def second_moment(diameter: float, factor: float = EFFECTIVE_DIAMETER) -> float:
    """Second moment of area of a fluted shank.

    Parameters
    ----------
    diameter : float
        mm.
    factor : float
        The shank bends like a solid one of so many diameters; 1 for a solid one.

    Returns
    -------
    float
        mm^4 (dat-2025, eq. 4).
    """
    return math.pi * (factor * diameter) ** 4 / 64.0


def deflection(z: ArrayLike, force: ArrayLike, at: ArrayLike, overhang: ArrayLike, rigidity: ArrayLike) -> Floats:
    """Deflection of a cantilever, in the direction of the force.

    Parameters
    ----------
    z : (...)
        Height looked at, mm from the tip, 0 to `overhang`.
    force : (...)
        N.
    at : (...)
        Height of the force, mm from the tip, 0 to `overhang`.
    overhang : (...)
        Length h from the holder to the tip, mm.
    rigidity : (...)
        E I in N mm^2.

    Returns
    -------
    float64 of the common shape
        mm. Below the force the shank is straight (dat-2025, eq. 2), above it is a cubic (eq. 3); both agree in value
        and slope at the force.
    """
    # Distances from the holder: eqs. 2 and 3 multiplied out, so that a force at the holder needs no division.
    q = np.subtract(overhang, at, dtype=float)
    w = np.subtract(overhang, z, dtype=float)
    near, far = np.minimum(w, q), np.maximum(w, q)
    load, rigid = np.asarray(force, dtype=float), np.asarray(rigidity, dtype=float)
    out: Floats = load * near**2 * (3.0 * far - near) / (6.0 * rigid)
    return out


def slope(z: ArrayLike, force: ArrayLike, at: ArrayLike, overhang: ArrayLike, rigidity: ArrayLike) -> Floats:
    """Slope of the bent axis, -d delta / dz.

    Parameters
    ----------
    z, force, at, overhang, rigidity : (...)
        As `deflection`.

    Returns
    -------
    float64 of the common shape
        rad, positive where the tip leads; constant below the force.
    """
    q = np.subtract(overhang, at, dtype=float)
    w = np.minimum(np.subtract(overhang, z, dtype=float), q)
    out: Floats = np.asarray(force, dtype=float) * w * (2.0 * q - w) / (2.0 * np.asarray(rigidity, dtype=float))
    return out


@dataclass(frozen=True, slots=True)
class Cantilever:
    """A tool that bends between holder and tip, on a machine that gives way.

    Parameters
    ----------
    overhang : float
        mm from the holder to the tip.
    rigidity : float
        E I in N mm^2.
    machine : (float, float)
        What holder, spindle and machine give way, along X and Y, in mm/N, the same at every height; 0 for rigid ones.
    """

    overhang: float
    rigidity: float
    machine: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        for name, value in (("overhang", self.overhang), ("rigidity", self.rigidity)):
            if not (math.isfinite(value) and value > 0):
                raise UsageError(f"cantilever: {name} {value!r} is not positive")
        if not all(math.isfinite(c) and c >= 0 for c in self.machine):
            raise UsageError(f"cantilever: machine compliance {self.machine!r} is not 0 or more")

    @property
    def tip_stiffness(self) -> float:
        """Stiffness of the tool alone at its tip in N/mm: ``3 E I / h^3``."""
        return 3.0 * self.rigidity / self.overhang**3

    def compliance(self, z: ArrayLike, at: ArrayLike) -> Floats:
        """Deflection at height `z` per force at height `at`, of the tool alone, mm/N (Maxwell: symmetric)."""
        return deflection(z, 1.0, at, self.overhang, self.rigidity)

    def stiffness(self, z: ArrayLike) -> Floats:
        """Stiffness of the tool alone against a force at the height looked at, N/mm; infinite at the holder."""
        with np.errstate(divide="ignore"):
            out: Floats = 1.0 / self.compliance(z, z)
        return out

    @staticmethod
    def of_tool(tool: Tool) -> Cantilever:
        """Cantilever of a tool on a rigid machine.

        A measured `stiffness_n_per_mm` takes the place of the one that follows from shank and modulus; the shape of
        the bent axis stays that of a cantilever.

        Raises
        ------
        UsageError
            If the tool has no overhang.
        """
        if tool.overhang_mm is None:
            raise UsageError(
                phrase("setup: [tool] overhang_mm is missing: how the tool bends along its height needs it")
            )
        if tool.stiffness_n_per_mm is not None:
            return Cantilever(tool.overhang_mm, tool.stiffness_n_per_mm * tool.overhang_mm**3 / 3.0)
        moment = second_moment(tool.diameter_mm, tool.effective_diameter_factor)
        return Cantilever(tool.overhang_mm, tool.youngs_modulus_gpa * MPA_PER_GPA * moment)

    @staticmethod
    def of(setup: Setup) -> Cantilever:
        """Cantilever of a setup; where the machine's stiffness is given, what the tool leaves of it is the machine's.

        Raises
        ------
        UsageError
            If the tool has no overhang, or the whole loop (`kx_n_per_mm`, `ky_n_per_mm`: tool included) is said to be
            stiffer than the tool alone.
        """
        tool = Cantilever.of_tool(setup.tool)
        alone = tool.tip_stiffness
        rest = []
        for key in ("kx_n_per_mm", "ky_n_per_mm"):
            whole = getattr(setup.machine, key)
            if whole is not None and whole > alone * (1 + 1e-9):
                raise UsageError(
                    phrase(
                        "setup: [machine] {} {:g} N/mm is of the whole loop, tool included, but the tool alone "
                        "has {:.0f} N/mm at its tip: correct [tool] overhang_mm, youngs_modulus_gpa or "
                        "stiffness_n_per_mm, or leave the key out for a rigid machine",
                        key,
                        whole,
                        alone,
                    )
                )
            rest.append(0.0 if whole is None else max(1.0 / whole - 1.0 / alone, 0.0))
        return Cantilever(tool.overhang, tool.rigidity, (rest[0], rest[1]))

    def rest(self, whole: Floats, source: str = "") -> Floats:
        """Compliance of holder, spindle, machine and part where the whole loop has one at the tip, mm/N; of its shape.

        Raises
        ------
        UsageError
            If the whole is stiffer than the tool alone.
        """
        out: Floats = whole - 1.0 / self.tip_stiffness
        if (out < -1e-9 * whole).any():
            raise UsageError(
                phrase(
                    "{}: [machine] stiffness_along has {:g} N/mm, of the whole loop, tool included, but the "
                    "tool alone has {:.0f} N/mm at its tip: correct [tool] overhang_mm, youngs_modulus_gpa "
                    "or stiffness_n_per_mm",
                    source or "setup",
                    1.0 / whole.min(),
                    self.tip_stiffness,
                )
            )
        return np.maximum(out, 0.0)
