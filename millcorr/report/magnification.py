# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much larger than they are deviations are drawn: so that they are seen, and no contour is turned inside out."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from shapely.ops import polylabel

from millcorr.arrays import Floats, Ints
from millcorr.errors import UsageError
from millcorr.geometry.profile import Profile
from millcorr.messages import phrase

from .svg import round_down

USUAL = 500.0
"""Where it suits the part: pictures of one kind of part can be compared."""

LEAST_SHARE, MOST_SHARE = 0.03, 0.12
"""The longest whisker as a share of the part's size: shorter ones are not seen, longer ones hide the part."""

GREATEST = 1e6
"""Nothing is magnified more: 0.1 nm would be 0.1 mm."""

KEPT = 0.9
"""A contour moves inwards by this share of its largest inscribed circle's radius at most.

Each point, and each place on its straight way there, then stays outside a tenth of that circle about its centre: the
contour goes round that centre as often as before, so it is not turned inside out.
"""

_CORNERS = 1000
"""The inscribed circle is that of a polygon of about so many corners."""


def checked(magnification: float) -> float:
    """The number itself.

    Raises
    ------
    UsageError
        If it is not from 1 to 1000000.
    """
    if not 1 <= magnification <= GREATEST:
        raise UsageError(phrase("magnification {:g}: must be from 1 to {:.0f}", magnification, GREATEST))
    return magnification


def magnification_for(profile: Profile, largest: float, bound: float = math.inf) -> float:
    """Magnification 1, 2 or 5 times a power of ten at which the largest deviation is seen and fits.

    500 where its whisker is between 3 and 12 % of the part's size, else the largest that keeps to 12 %; never more
    than a bound.

    Parameters
    ----------
    profile : Profile
    largest : float
        mm.
    bound : float
        As `bound_of` gives it.
    """
    size = _size(profile)
    if not largest > 0:
        return USUAL
    most, least = MOST_SHARE * size / largest, LEAST_SHARE * size / largest
    usual = least <= USUAL <= most and bound >= USUAL
    return USUAL if usual else max(1.0, round_down(min(most, bound, GREATEST)))


def bound_of(profile: Profile, displaced: Sequence[tuple[Ints, Floats]]) -> float:
    """Largest magnification at which no closed contour is turned inside out, and nothing leaves the part by its size.

    Parameters
    ----------
    profile : Profile
    displaced : sequence of ((n,) int64, (n,) float64)
        Contours, and how far along the profile's normal something is drawn off them, mm.

    Returns
    -------
    float
        At least 1: what is drawn as large as it is, is what it is. `GREATEST` where nothing is off.
    """
    area = profile.signed_areas()
    size = _size(profile)
    bound = GREATEST
    for k, contour in enumerate(profile.contours):
        values = np.concatenate([np.zeros(1), *(value[owner == k] for owner, value in displaced)])
        values = values[np.isfinite(values)]
        bound = min(bound, _quotient(size, float(np.abs(values).max())))
        if contour.closed:
            # The normal points out of the material, which the contour has on its left.
            inwards = -values if area[k] > 0 else values
            bound = min(bound, _quotient(KEPT * _inner_radius(profile, k), float(inwards.max())))
    return max(bound, 1.0)


def _quotient(room: float, largest: float) -> float:
    return room / largest if largest * GREATEST > room else GREATEST


def _size(profile: Profile) -> float:
    """Larger side of the profile's box, mm."""
    left, bottom, right, top = profile.bounding_box()
    return max(right - left, top - bottom)


def _inner_radius(profile: Profile, contour: int) -> float:
    """Radius of the largest circle in a closed contour, mm; to a thousandth of the contour's length, and no larger."""
    length = float(profile.total[contour])
    part = profile.part(np.array([contour]))
    point, _, _ = part.evaluate(*part.samples(length / _CORNERS))
    whole = shapely.make_valid(shapely.Polygon(point))
    pieces = [piece for piece in shapely.get_parts(whole) if piece.geom_type == "Polygon" and piece.area > 0]
    fine = length / _CORNERS
    centres = [(piece, polylabel(piece, fine)) for piece in pieces]
    return max((float(shapely.distance(piece.boundary, centre)) for piece, centre in centres), default=0.0)
