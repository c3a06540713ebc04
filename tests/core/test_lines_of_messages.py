# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where lines run several times, messages name the line of the file, not the block that runs it."""

from __future__ import annotations

import numpy as np
import pytest

from millcorr import nc
from millcorr.errors import FormatError
from millcorr.nc.toolpath import Toolpath
from millcorr.path.second_reader import prove
from millcorr.process.kinematics.moves import refuse

CALLS = b"O1\nG21 G90\nG0 X0 Y0\nM98 P2 L3\nG1 X50\nM30\nO2\nG91 G1 Y1 F100\nG90\nM99\n"
"""The contour's line runs three times; what follows the calls is block 14 and line 5."""
KLARTEXT = b"0 BEGIN PGM A MM\n1 L X0 Y0 FMAX\n2 LBL 1\n3 L IY1 F100\n4 CALL LBL 1 REP 2\n5 L X50\n6 END PGM A MM\n"


@pytest.mark.parametrize(("text", "last"), [(CALLS, 5), (KLARTEXT, 6)])
def test_moves_know_their_lines(text: bytes, last: int) -> None:
    path = nc.parse(text).toolpath
    assert path.source[-1] + 1 > last
    assert int(path.line(np.array([len(path) - 1]))[0]) == last
    rows = np.array([len(path) - 1])
    assert path.take(rows).line(np.array([0])).tolist() == [last]
    assert Toolpath.concatenate([path, path.take(rows)]).line(np.array([-1])).tolist() == [last]
    proof = prove(text, text, np.array([], np.int64))
    assert proof.moves.toolpath().with_lines(proof.line).line(np.array([-1])).tolist() == [last]


def test_a_refusal_behind_calls_names_the_line() -> None:
    path = nc.parse(CALLS).toolpath
    with pytest.raises(FormatError, match="a.nc:5: no feed"):
        refuse(path, np.arange(len(path)) == len(path) - 1, "no feed", "a.nc")
