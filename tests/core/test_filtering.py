# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest

from millcorr.errors import UsageError
from millcorr.filtering import Filter, separate


def test_moving_average_by_hand():
    # Werner 2018, eqs. (4)(5): mask 1,2,1 over 1, 5, 9, 3.
    d = [1.0, 5.0, 9.0, 3.0]
    closed = separate([0, 1, 2, 3], d, length=4.0, closed=True, filter=Filter.parse("mean:1,2,1"))
    np.testing.assert_allclose(closed.determined, [10 / 4, 20 / 4, 26 / 4, 16 / 4], rtol=1e-15)
    opened = separate([0, 1, 2, 3], d, length=3.0, closed=False, filter=Filter.parse("mean:1,2,1"))
    np.testing.assert_allclose(opened.determined, [7 / 3, 20 / 4, 26 / 4, 15 / 3], rtol=1e-15)


@pytest.mark.parametrize("text", ["", "mean", "mean:4", "mean:1,2", "mean:1,-2,1", "gauss:0", "gauss:x", "nan"])
def test_illegal_filters_are_usage_errors(text):
    with pytest.raises(UsageError, match="legal filters"):
        Filter.parse(text)
