# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person sees of a measured file before saying what its columns are."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr import readers
from millcorr.errors import FormatError
from millcorr.readers.preview import HEAD, preview

NUMBERS = np.array([[1.5, 2.25, -3.0], [4.0, 5.125, -3.0], [7.75, 8.5, -3.0]])


@pytest.mark.parametrize("character", [",", ";", "\t", " "])
@pytest.mark.parametrize("decimal", [".", ","])
@pytest.mark.parametrize("head", [[], ["Part 17", "operator: nobody"]])
def test_columns_that_a_person_names_are_read(tmp_path, character, decimal, head):
    if decimal == character:
        pytest.skip("commas cannot be both")
    rows = [["P", f"{k}", *(f"{v:.4f}".replace(".", decimal) for v in row)] for k, row in enumerate(NUMBERS)]
    file = tmp_path / "odd.txt"
    file.write_text("\n".join([*head, *(character.join(row) for row in rows), ""]))
    seen = preview(file.read_bytes(), file.name)
    assert seen.format == "text" and seen.is_table and not seen.columns
    assert seen.cells[seen.first] == tuple(rows[0]) and seen.first == len(head)
    mapping = seen.mapped({"x": 3, "y": 4, "z": 5})
    measurement = readers.read(file, points="contact", mapping=mapping)
    np.testing.assert_allclose(measurement.points, NUMBERS)
    assert measurement.lines.tolist() == [len(head) + 1, len(head) + 2, len(head) + 3]


def test_a_file_that_tells_its_columns():
    seen = preview(b"# unit: mm\nz;x;y;i;j\n1;2;3;0;1\n1;2;4;0;1\n", "a.csv")
    assert seen.columns == {"z": 1, "x": 2, "y": 3, "i": 4, "j": 5}
    assert seen.separator == "semicolon" and seen.first == 2 and seen.lines[1] == "z;x;y;i;j"


def test_only_the_beginning_is_needed():
    whole = "x,y,z\n" + "".join(f"{k}.5,{k}.25,-3\n" for k in range(20000))
    seen = preview(whole.encode()[:HEAD], "long.csv", rows=5)
    assert len(seen.lines) == 5 and seen.columns == {"x": 1, "y": 2, "z": 3}


def test_other_formats_show_lines_but_no_table():
    seen = preview(b"ply\nformat ascii 1.0\nelement vertex 1\n", "a.ply")
    assert seen.format == "ply" and not seen.is_table
    assert preview(bytes(range(256)) * 8, "a.bin").lines == ()
    assert preview(b"", "empty").lines == ()


def test_senseless_columns_are_refused():
    seen = preview(b"1 2 3\n4 5 6\n", "a.txt")
    with pytest.raises(FormatError):
        seen.mapped({"y": 1, "z": 2})
