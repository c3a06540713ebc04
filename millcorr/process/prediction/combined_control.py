# SPDX-License-Identifier: LGPL-2.1-or-later
"""Combined control (petrakov-2023): a simulation says how the load varies along the contour, touches say its size.

At a touched place the transfer function is ``MSx = delta_x / (h_x - delta_x)`` (eq. 9), taken with the *components*
of the depth h along the normal. The paper writes coordinates there and in eqs. (8) and (12); with those the result
would depend on where the origin is. Along the contour ``MSx_c[i] = MSx k[i]``, ``k[i] = sq[i] / sq*`` (eqs. 10, 11),
and the path moves by ``-(MSx_c h_x, MSy_c h_y)`` (eq. 12 without the nominal coordinate). Of that shift the component
along the normal n makes the surface:

    ``e[i] = -h[i] k[i] (MSx nx^2 + MSy ny^2)``.

Where the depth differs from the touched place, sq differs with it and is counted once: per depth, ``k h / h*`` is
``sq / sq*``. So with ``C = MS h* / sq*`` along each axis ``e[i] = -sq[i] (Cx nx^2 + Cy ny^2)``, and a measured
deviation d at depth h gives ``d h / (h - d) = sq (Cx nx^2 + Cy ny^2)``: two unknowns, linear, for as many touches as
there are. The area sq is that of the cut that removes just what it should, for that is the cut to be made.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from millcorr.arrays import Floats, ReadOnlyArrays
from millcorr.correction.transfer_function import LEAST_REMOVED
from millcorr.errors import InputError, RefusedError
from millcorr.messages import mm, option, phrase, remedy, xy
from millcorr.process.setup_file import Setup

APART = 0.1
"""Both axes are told apart where the touches' normals differ: smallest over largest singular value at least this."""

CLOSE = 1e-4
"""The machine is identified when model and touches agree within this, in mm, or within a thousandth."""

ROUNDS = 12

RIGID = 1e7
"""Stiffness in N/mm from which on nothing gives way that could be measured."""


@dataclass(frozen=True, eq=False, slots=True)
class AxisTransfer(ReadOnlyArrays):
    """Transfer functions of both axes at a reference load.

    Parameters
    ----------
    ms : (2,) float64
        MSx and MSy at the reference place, pure numbers.
    covariance : (2, 2) float64
        Of both; NaN where the touches leave no freedom to tell.
    area, depth : float
        Undeformed area sq* in mm^2 and depth h* in mm at the reference place: the first touch.
    scatter : float
        Standard deviation in mm of what the touches deviate from the fit; NaN without freedom.
    separate : bool
        Whether the touches told the axes apart; else both are taken as equal.
    """

    ms: Floats
    covariance: Floats
    area: float
    depth: float
    scatter: float
    separate: bool

    @property
    def ms_std(self) -> Floats:
        """Standard uncertainties of MSx and MSy; (2,)."""
        out: Floats = np.sqrt(np.diag(self.covariance))
        return out

    def load(self, area: Floats) -> Floats:
        """Load over the load at the reference place, ``k[i] = sq[i] / sq*`` (eq. 11); (n,)."""
        out: Floats = area / self.area
        return out

    def along(self, area: Floats, normal: Floats) -> Floats:
        """``MSx_c nx^2 + MSy_c ny^2`` at the reference depth; (n,) (eq. 10).

        Parameters
        ----------
        area : (n,) float64
            sq[i] in mm^2.
        normal : (n, 2) float64
        """
        out: Floats = self.load(area) * (normal**2 @ self.ms)
        return out

    def correction(self, area: Floats, normal: Floats) -> Floats:
        """Displacement along the normal in mm, negative: deeper; (n,) (eq. 12, component of the depth)."""
        return -self.depth * self.along(area, normal)

    def correction_std(self, area: Floats, normal: Floats) -> Floats:
        """Standard uncertainty of `correction` in mm from that of MSx and MSy; (n,)."""
        g = normal**2
        out: Floats = self.depth * self.load(area) * np.sqrt(np.einsum("ni,ij,nj->n", g, self.covariance, g))
        return out


def identify(
    value: Floats, depth: Floats, removed: Floats, area: Floats, normal: Floats, place: Floats
) -> AxisTransfer:
    """Transfer functions of both axes from touches, by least squares.

    Parameters
    ----------
    value : (n,) float64
        What the machine left at the touched places, mm along the normal.
    depth : (n,) float64
        Stock over the surface wanted, h in mm along the normal.
    removed : (n,) float64
        What the program commanded to remove, mm: the depth less the program's own offset.
    area : (n,) float64
        Undeformed area sq at the touched places in mm^2.
    normal, place : (n, 2) float64
        Directional cosines, and points in mm for messages.

    Returns
    -------
    AxisTransfer
        One touch, or touches whose normals tell the axes not apart, give ``MSx = MSy``, as the paper's single touch
        on an inclined section does (eq. 7).

    Raises
    ------
    InputError
        If the cutter takes nothing at a touched place.
    RefusedError
        If next to nothing of the depth was removed.
    """
    if (bad := np.flatnonzero(~(area > 0))).size:
        x, y = place[bad[0]]
        raise InputError(
            phrase(
                "at {} a point was touched where the program takes nothing off the stock of the setup: "
                "check [stock] and {}",
                xy(x, y),
                option("program"),
            ),
        )
    if (bad := np.flatnonzero(~((removed > 0) & (removed - value >= LEAST_REMOVED * removed)))).size:
        x, y = place[bad[0]]
        raise RefusedError(
            phrase(
                "at {} {} of a depth of {} stayed: MS = delta/(h - delta) has no meaning there; check {} or [stock]",
                xy(x, y),
                mm(value[bad[0]], ".4f"),
                mm(removed[bad[0]], ".4f"),
                option("depth"),
            ),
        )
    whole = value * depth / (removed - value)
    rows = area[:, None] * normal**2
    unit = rows / np.abs(rows).max()
    singular = np.linalg.svd(unit, compute_uv=False)
    separate = len(value) > 1 and singular[1] >= APART * singular[0]
    design = rows if separate else rows.sum(axis=1, keepdims=True)
    solution = np.linalg.lstsq(design, whole, rcond=None)[0]
    residual = whole - design @ solution
    freedom = len(value) - design.shape[1]
    variance = float(residual @ residual) / freedom if freedom > 0 else math.nan
    covariance = variance * np.linalg.inv(design.T @ design)
    reference, h = float(area[0]), float(depth[0])
    scale = reference / h
    spread = np.eye(2) if separate else np.ones((2, 1))
    return AxisTransfer(
        scale * (spread @ solution),
        scale**2 * (spread @ covariance @ spread.T),
        reference,
        h,
        math.sqrt(variance),
        bool(separate),
    )


@dataclass(frozen=True, eq=False, slots=True)
class Machine:
    """Stiffness found from touches.

    Parameters
    ----------
    kx, ky : float
        N/mm, with the force coefficients of the setup: only the quotient of both is known.
    misfit : float
        Largest difference of model and touches, mm.
    separate : bool
        Whether the touches told the axes, or the rows of the setup's table, apart.
    along : tuple of (s, kx, ky)
        Stiffness along the contour, mm and N/mm, where the setup has a table; kx and ky are then the means of its
        compliance.
    """

    kx: float
    ky: float
    misfit: float
    separate: bool
    along: tuple[tuple[float, float, float], ...] = ()

    @staticmethod
    def found(factor: Floats, table: tuple[tuple[float, float, float], ...], separate: bool) -> Machine:
        """Machine of the compliances of both axes, mm/N, or of the factors on those of a table."""
        if not table:
            kx, ky = np.minimum(1.0 / factor, RIGID)
            return Machine(float(kx), float(ky), math.inf, separate)
        rows = np.array(table)
        stiffness = np.minimum(rows[:, 1:] / factor[:, None], RIGID)
        along = tuple((float(s), float(x), float(y)) for s, (x, y) in zip(rows[:, 0], stiffness, strict=True))
        kx, ky = 1.0 / (1.0 / stiffness).mean(axis=0)
        return Machine(float(kx), float(ky), math.inf, separate, along)

    def of(self, setup: Setup) -> Setup:
        """The setup with this machine's stiffness, which no longer comes from where the setup says."""
        found = replace(setup.machine, kx_n_per_mm=self.kx, ky_n_per_mm=self.ky, origin="")
        return replace(setup, machine=replace(found, stiffness_along=self.along))


def identify_machine(
    value: Floats,
    normal: Floats,
    force: Callable[[Machine | None], tuple[Floats, Floats]],
    table: tuple[tuple[float, float, float], ...] = (),
    share: Floats | None = None,
) -> Machine:
    """Stiffness with which the model leaves what was touched.

    Parameters
    ----------
    value : (n,) float64
        What the machine left at the touched places, mm along the normal.
    normal : (n, 2) float64
    force : callable
        From a machine to what its model leaves at the places, (n,) in mm, and the force on the tool there, (n, 2) in
        N; from None to zeros and the forces of a rigid machine.
    table : tuple of (s, kx, ky)
        Stiffness along the contour, mm and N/mm, of which every row is to be off by a factor of its own; by default
        both axes have a stiffness each, the same everywhere.
    share : (n, k) float64, optional
        Share of every row of the table in the compliance at the places.

    Returns
    -------
    Machine
        One factor for all rows, one stiffness for both axes, where the touches do not tell them apart.

    Raises
    ------
    RefusedError
        If no stiffness explains the touches, or none is found.
    """
    left, forces = force(None)
    # What a unit of each unknown adds to the compliance along X and Y at the places.
    unit = np.tile(np.eye(2), (len(value), 1, 1))
    if share is not None:
        unit = share[:, :, None] / np.array(table)[None, :, 1:]
    compliance = np.zeros(unit.shape[1])
    misfit = math.inf
    separate = False
    for _ in range(ROUNDS):
        design = np.einsum("na,nka->nk", forces * normal, unit)
        size = np.abs(design).max()
        if not size > 0:
            raise RefusedError(phrase("combined control: the model has no force across the walls that were touched"))
        singular = np.linalg.svd(design / size, compute_uv=False)
        unknown = len(compliance)
        separate = len(value) >= unknown and bool(singular[-1] >= APART * singular[0])
        design = design if separate else design.sum(axis=1, keepdims=True)
        change = np.linalg.lstsq(design, value - left, rcond=None)[0]
        compliance = compliance + change
        if not (compliance > 0).all():
            raise RefusedError(
                phrase(
                    "combined control: the touches show the cutter moved against the force of the model (mean "
                    "deviation {}): check [tool] rotation, the cutter's side and {}; or take the deviations as "
                    "they are: {}",
                    mm(value.mean(), "+.4f"),
                    option("points"),
                    remedy("method", "mirror"),
                ),
            )
        machine = Machine.found(compliance, table, separate)
        left, forces = force(machine)
        best, misfit = misfit, float(np.abs(value - left).max())
        enough = max(CLOSE, 1e-3 * float(np.abs(value).max()))
        if misfit <= enough or (len(value) > 1 and abs(best - misfit) <= 0.1 * enough):
            return replace(machine, misfit=misfit)
    raise RefusedError(
        phrase(
            "combined control: no stiffness makes the model leave what was touched, {} are still "
            "missing: check {}, [stock] and [material]",
            mm(misfit, ".4f"),
            option("depth"),
        ),
    )
