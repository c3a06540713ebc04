# SPDX-License-Identifier: LGPL-2.1-or-later
"""X3P files of contour and topography instruments (ISO 25178-72), where x3pio is installed."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr import readers
from millcorr.errors import FormatError, UsageError

x3pio = pytest.importorskip("x3pio")


def test_a_profile_lies_in_the_plane_of_the_contour(tmp_path):
    path = tmp_path / "profile.x3p"
    x = np.arange(40) * 5e-6
    height = 1e-3 + 2e-4 * np.sin(x / 1e-5)
    height[7] = np.nan
    x3pio.write(path, height, x_scale=5e-6)
    m = readers.read(path, points="contact")
    kept = np.arange(40) != 7
    np.testing.assert_allclose(m.points[:, 0], 1000 * x[kept], atol=1e-12)
    np.testing.assert_allclose(m.points[:, 1], 1000 * height[kept], atol=1e-12)
    assert not m.points[:, 2].any() and m.format == "x3p" and m.bases["unit"].how == "stated"
    assert any("X and Z" in note for note in m.notes) and any("1 points without" in note for note in m.notes)


def test_a_point_cloud_stays_as_it_is(tmp_path):
    path = tmp_path / "cloud.x3p"
    points = np.random.default_rng(3).uniform(-0.02, 0.02, (50, 3))
    x3pio.write_points(path, points)
    m = readers.read(path, points="centre", probe_radius=1.0)
    np.testing.assert_allclose(m.points, 1000 * points, atol=1e-9)


def test_damage_and_other_containers(tmp_path):
    path = tmp_path / "profile.x3p"
    x3pio.write(path, np.linspace(0, 1e-4, 30), x_scale=1e-6)
    data = path.read_bytes()
    middle = 200
    spoilt = data[:middle] + bytes(b ^ 0xFF for b in data[middle : middle + 20]) + data[middle + 20 :]
    for damaged in (data[: len(data) // 2], spoilt):
        path.write_bytes(damaged)
        with pytest.raises(FormatError):
            readers.read(path, points="contact")
    path.write_bytes(data)
    with pytest.raises(UsageError, match="--points"):
        readers.read(path)
