# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that end in the middle of a number: whatever is read of them is what the whole file holds."""

import importlib.util

import numpy as np
import pytest

from millcorr import readers
from millcorr.errors import FormatError, MillcorrError
from millcorr.readers.truncation import check_last_number
from tests.core import measurement_files as files

PART = files.ellipse(60)
ROWS = PART.contact.tolist()
CONTACT = {"points": "contact"}
DMIS = "UNITS/MM\nPRCOMP/ON\n" + "\n".join(
    f"FA(P{k})=FEAT/POINT,CART," + ",".join(f"{v:.4f}" for v in row) for k, row in enumerate(ROWS)
)
FILES = {
    "dprnt": ("\n".join(f"N{k}X{x:10.4f}Y{y:10.4f}" for k, (x, y, _) in enumerate(ROWS)), CONTACT),
    "xyzijk": ("XYZIJK    METRIC\n" + "\n".join(f"{x:.5f},{y:.5f},{z:.5f}" for x, y, z in ROWS), CONTACT),
    "dmis": (DMIS, {}),
    "text": ("x y\n" + "\n".join(f"{x:.4e} {y:.4e}" for x, y, _ in ROWS), CONTACT),
    "text comma": ("x;y\n" + "\n".join(f"{x:.4f};{y:.4f}" for x, y, _ in ROWS).replace(".", ","), CONTACT),
    "qdas": (
        f"K0100 {2 * len(ROWS)}\n"
        + "".join(f"K2001/{2 * k + a} P{k}.{'XY'[a - 1]}\n" for k in range(len(ROWS)) for a in (1, 2))
        + "\n".join(f"K0001/{2 * k + a} {row[a - 1]:.4f}" for k, row in enumerate(ROWS) for a in (1, 2)),
        CONTACT,
    ),
    "ply": (
        "ply\nformat ascii 1.0\nelement vertex 60\n"
        + "".join(f"property double {c}\n" for c in "xyz")
        + "end_header\n"
        + "\n".join(f"{x:.5f} {y:.5f} {z:.5f}" for x, y, z in ROWS),
        CONTACT,
    ),
    "pcd": (
        "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 60\nHEIGHT 1\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 60\nDATA ascii\n" + "\n".join(f"{x:.5f} {y:.5f} {z:.5f}" for x, y, z in ROWS),
        CONTACT,
    ),
}
NEEDS = {"ply": "plyfile", "pcd": "pypcd4"}


@pytest.mark.parametrize("name", FILES)
def test_no_cut_changes_a_point(tmp_path, name):
    if name in NEEDS and importlib.util.find_spec(NEEDS[name]) is None:
        pytest.skip(f"{NEEDS[name]} is not installed")
    content, options = FILES[name]
    path = tmp_path / "file"
    path.write_text(content)
    whole = readers.read(path, **options)
    refused = 0
    for cut in range(1, 70):
        path.write_text(content[:-cut])
        try:
            m = readers.read(path, **options)
        except MillcorrError:
            refused += 1
            continue
        np.testing.assert_array_equal(m.points[:, :2], whole.points[: len(m), :2])
    assert refused >= 3


def test_line_of_the_number_that_was_cut_off():
    content = "\n".join(["x1.250"] * 30)
    check_last_number(content.encode(), "file")
    for cut in ("x1.250\n" * 30 + "x1.2", "x1.250\r" * 30 + "x1.", "x1.250\r\n" * 30 + "x1"):
        with pytest.raises(FormatError, match="ends within a number") as caught:
            check_last_number(cut.encode(), "file")
        assert caught.value.line == 31
        check_last_number(cut.encode() + b"\n", "file")


@pytest.mark.parametrize(
    "last",
    ["x1.2500", "x1.2,", "y1.2", "x1.2 mm", "(end)"],
)
def test_a_last_line_that_may_be_whole(last):
    check_last_number(("x1.250\n" * 30 + last).encode(), "file")


def test_numbers_of_changing_length_prove_nothing():
    rows = [f"x{v:g}" for v in np.arange(30) * 0.37]
    check_last_number("\n".join([*rows, "x5"]).encode(), "file")
    check_last_number(b"1,12\n" * 20 + b"1,5", "file")
