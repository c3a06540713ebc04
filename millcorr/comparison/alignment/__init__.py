# SPDX-License-Identifier: LGPL-2.1-or-later
"""Alignment: the rigid motion that lays a measurement on its profile, and what that motion hides."""

from millcorr.readers.transform import Transform

from .fit import Alignment, Freedom, align, given

__all__ = ["Alignment", "Freedom", "Transform", "align", "given"]
