# SPDX-License-Identifier: LGPL-2.1-or-later
"""How stiff the machine is at places along a contour: the same everywhere, or as the setup's table has it."""

from __future__ import annotations

import numpy as np

from millcorr.arrays import Floats
from millcorr.errors import UsageError
from millcorr.geometry.footpoint import FootPointSearch
from millcorr.geometry.profile import Profile
from millcorr.messages import mm, phrase
from millcorr.process.setup_file import Setup


def compliance_at(setup: Setup, nominal: Profile | None, place: Floats) -> Floats:
    """Compliance along X and Y at the places of a contour that are nearest to points.

    Parameters
    ----------
    setup : Setup
    nominal : Profile or None
        Needed where the setup has a table.
    place : (n, 2) float64
        mm.

    Returns
    -------
    (n, 2) float64
        mm/N.

    Raises
    ------
    UsageError
        If the setup has no stiffness, or a table and there is no one contour for it.
    """
    rows = setup.machine.stiffness_along
    if not rows:
        return np.tile(1.0 / np.array(setup.machine.stiffness(setup.source)), (len(place), 1))
    return weights_at(setup, nominal, place) @ (1.0 / np.array(rows)[:, 1:])


def weights_at(setup: Setup, nominal: Profile | None, place: Floats) -> Floats:
    """Share of every row of the setup's table in the compliance at places; (n, k), rows add up to 1; as above."""
    source = setup.source or "setup"
    if nominal is None or len(nominal.contours) != 1:
        raise UsageError(
            phrase("{}: [machine] stiffness_along needs a nominal of one contour, which it goes along", source)
        )
    knots = np.array(setup.machine.stiffness_along)[:, 0]
    total, closed = float(nominal.total[0]), nominal.contours[0].closed
    if knots[-1] > total + 1e-6:
        raise UsageError(
            phrase(
                "{}: [machine] stiffness_along goes to {}, the contour is {} long",
                source,
                mm(knots[-1], "g"),
                mm(total, ".3f"),
            )
        )
    feet = FootPointSearch(nominal, margin=setup.tool.radius + 2.0).find(place)
    s = nominal.arc_length(feet.span, feet.t)
    unit = np.eye(len(knots))
    period = total if closed else None
    return np.column_stack([np.interp(s, knots, column, period=period) for column in unit])
