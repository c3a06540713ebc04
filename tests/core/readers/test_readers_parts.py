# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several measured parts in one file: never mixed, chosen by number, and not seen where there is only one."""

import re
from dataclasses import replace

import numpy as np
import pytest

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from millcorr.readers.parts import SAME_PLACE, parts_by_place, parts_by_repetition, point_keys
from tests.core import measurement_files as files

PARTS = [files.ellipse(12, seed=seed) for seed in (1, 2, 3)]


def qif_of_several(parts):
    """QIF document with one MeasurementResults a part, all of the same items and nominals."""
    texts = [files.qif(part, sets=True, stated=False) for part in parts]
    results = []
    for k, text in enumerate(texts):
        own = re.search(r"<MeasurementResults .*</MeasurementResults>", text, re.DOTALL)[0]
        # Ids of measured features and sets are a part's own; those of items and nominals are shared.
        own = re.sub(r'\bid="(\d+)"', rf'id="{k + 1}\1"', own)
        results.append(re.sub(r"<WholePointSetId>", f"<WholePointSetId>{k + 1}", own))
    return re.sub(r"<MeasurementResults .*</MeasurementResults>", "\n".join(results), texts[0], flags=re.DOTALL)


SEVERAL = {
    "dprnt": ("".join(map(files.dprnt, PARTS)), {"points": "contact"}),
    "dprnt unnumbered": ("".join(files.dprnt(p, number=False) for p in PARTS), {"points": "contact"}),
    "dprnt without heads": ("".join(files.dprnt(p, heads=False) for p in PARTS), {"points": "contact"}),
    "msr": ("".join(files.msr(p) for p in PARTS), {}),
    "grbl": ("".join(files.grbl(p, offset=(9, 9, 9), wco=True) for p in PARTS), {"probe_radius": 1.5}),
    "linuxcnc": ("".join(map(files.linuxcnc, PARTS)), {"probe_radius": 1.5}),
    "linuxcnc in inches": (
        "".join(files.linuxcnc(p, inch=True) for p in PARTS), {"probe_radius": 1.5, "units": "inch"},
    ),
    "renishaw": (
        "".join(files.renishaw(p).replace("NO 12", f"NO {n}") for n, p in enumerate(PARTS, 12)), {"points": "contact"},
    ),
    "qif": (qif_of_several(PARTS), {}),
}  # fmt: skip


@pytest.mark.parametrize("name", SEVERAL)
def test_parts_are_not_mixed_but_chosen(tmp_path, name):
    content, options = SEVERAL[name]
    path = tmp_path / "parts.txt"
    path.write_text(content, newline="")
    with pytest.raises(UsageError, match=r"holds 3 measured parts \(1: .*lines? \d+.*; 2: .*\): say which with --part"):
        readers.read(path, **options)
    for number, part in enumerate(PARTS, 1):
        m = readers.read(path, part=number, **options)
        np.testing.assert_allclose(m.points, part.centres if m.ball_radius else part.contact, atol=6e-5)
        assert m.notes[0] == f"measured part {number}"
    for number in (0, 4):
        with pytest.raises(UsageError, match="3 measured parts, counted from 1"):
            readers.read(path, part=number, **options)


def test_part_of_a_file_with_one_part(tmp_path):
    path = tmp_path / "one.msr"
    path.write_text(files.msr(PARTS[0]))
    assert len(readers.read(path, part=1)) == 12
    with pytest.raises(UsageError, match="--part 2: .* holds one measured part"):
        readers.read(path, part=2)


def test_blocks_of_different_points_are_one_part(tmp_path):
    whole = PARTS[0]
    first, second = (
        replace(whole, centres=whole.centres[rows], nominal=whole.nominal[rows], normals=whole.normals[rows])
        for rows in (slice(0, 5), slice(5, 12))
    )
    path = tmp_path / "blocks"
    # Both blocks number their points from 1: they are other points all the same.
    path.write_text(files.msr(first) + files.msr(second))
    np.testing.assert_allclose(readers.read(path).points, whole.centres, atol=1e-9)
    path.write_text(files.dprnt(first) + files.dprnt(second), newline="")
    np.testing.assert_allclose(readers.read(path, points="contact").points, whole.contact, atol=6e-5)


def test_a_nominal_under_another_number_is_measured_again(tmp_path):
    line = "G800 N{0} X1 Y0 Z0 I1 J0 K0\nG801 N{0} X{1} Y0 Z0 R1\n"
    path = tmp_path / "again.msr"
    path.write_text("START\n" + line.format(1, 2.01) + line.format(2, 2.02) + "END\n")
    assert readers.read(path).points[:, 0].tolist() == [2.01, 2.02]
    path.write_text("START\n" + line.format(1, 2.01) + line.format(1, 2.02) + "END\n")
    with pytest.raises(FormatError, match="N1 with the same nominal is there twice, first in line 3") as caught:
        readers.read(path)
    assert caught.value.line == 5


def test_a_printed_point_twice_in_one_part(tmp_path):
    path = tmp_path / "print.txt"
    path.write_text("N1X1.0Y2.0\nN2X5.0Y2.0\nN2X5.1Y2.0\nN3X9.0Y2.0\n")
    with pytest.raises(FormatError, match="N2 is there twice, first in line 2: keep one") as caught:
        readers.read(path, points="contact")
    assert caught.value.line == 3


def test_touches_that_overlap_or_stand_still_are_one_part():
    circle = np.column_stack([np.cos(np.arange(50) / 8), np.sin(np.arange(50) / 8), np.zeros(50)]) * 40
    closed = np.vstack([circle, circle[:20]])
    assert not parts_by_place(closed).any()
    assert not parts_by_place(np.repeat(circle, 2, axis=0)).any()
    assert not parts_by_place(np.zeros((40, 3))).any()
    assert not parts_by_place(np.vstack([circle, circle + [0, 0, 2 * SAME_PLACE]])).any()
    # A second part that was not finished is one too, from half of the touches on.
    part_of = parts_by_place(np.vstack([circle, circle[:25] + 0.1]))
    assert part_of.tolist() == [0] * 50 + [1] * 25


def test_keys_and_blocks():
    places = np.array([[0, 0, 0], [9, 0, 0], [0, 0, 0.9], [0, 0, 0.0], [9, 0, 1.1]])
    keys = point_keys(np.array([1, 2, 1, 3, 2]), places, 1.0)
    assert keys[0] == keys[2] and len(set(keys.tolist())) == 4
    assert parts_by_repetition(keys, np.array([0, 0, 1, 1, 1]))[0].tolist() == [0, 0, 1, 1, 1]
    assert parts_by_repetition(keys, np.zeros(5, dtype=int))[1] == (0, 2)


def test_touches_in_one_line(tmp_path):
    path = tmp_path / "joined.log"
    path.write_text("[PRB:1.0,2.0,3.0:1]ok[PRB:4.0,5.0,6.0:1]\n[PRB:7.0,8.0,9.0:1]\n")
    m = readers.read(path, probe_radius=1, work_offset=(0, 0, 0))
    assert m.points[:, 0].tolist() == [1, 4, 7] and m.lines.tolist() == [1, 1, 2]
    path.write_text("[PRB:1.0,2.0,3.0:1][PRB:4.0,5.0\n")
    with pytest.raises(FormatError, match="is damaged"):
        readers.read(path, probe_radius=1, work_offset=(0, 0, 0))
