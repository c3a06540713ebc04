# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mark of a corrected program survives every style of comment, and forbids what would be wrong."""

from __future__ import annotations

import hashlib

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr.correction.provenance import MODULUS, PLACES, Mark, header, marks, recognised, refuse_second_use
from millcorr.errors import InputError, RefusedError
from millcorr.nc import parse
from millcorr.nc.writer import write
from tests.core.sweeps import examples

PROGRAMS = {
    "plain": b"G21 G90\nG1 X0 Y0 Z0 F100\nX10\n",
    "upper case": b"%\nO0001 (PART 1)\nG21 G90\nG1 X0 Y0 Z0 F100\nX10\nM30\n%\n",
    "mixed case": b"(Outline of the part)\nG21 G90\nG1 X0 Y0 Z0 F100\nX10\n",
    "semicolons": b"; made by a post\n; second line\nG21 G90\nG1 X0 Y0 Z0 F100\nX10\n",
    "numbered, CR LF": b"N10 G21 G90\r\nN20 G1 X0 Y0 Z0 F100\r\nN30 X10 (TO THE RIGHT)\r\n",
    "lower case": b"g21 g90\ng1 x0 y0 z0 f100\nx10\n",
}


def digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def marked(program: bytes, measured: list[tuple[str, str]], source: tuple[str, str] = ("part.nc", digest("source"))):
    p = parse(program, "t.nc")
    words = "method mirror filter auto gain 1 dead band 0 limit 0.5 tolerance 0.001 moves keep"
    return write(p, p.toolpath, header=header(measured, source, words))


@pytest.mark.parametrize("style", PROGRAMS)
@pytest.mark.parametrize("count", [1, 2, 3, 30])
def test_mark_comes_back(style, count):
    measured = [(f"part ({k}) ø10 µm.csv", digest(str(k))) for k in range(count)]
    out = marked(PROGRAMS[style], measured)
    again = parse(out, "t.nc")
    (mark,) = marks(again.comments())
    assert mark.measured == tuple(d[:16] for _, d in measured)
    assert mark.source == digest("source")[:16]
    assert len(mark.date) == 10
    assert b"orrected" in out.splitlines()[mark.line - 1] or b"ORRECTED" in out.splitlines()[mark.line - 1]
    # The comments do not move the machine, and no control has to show more than a line.
    assert len(again.toolpath) == len(parse(PROGRAMS[style], "t.nc").toolpath)
    assert max(len(line) for line in out.splitlines()) < 128


def test_names_of_files_are_told():
    out = marked(PROGRAMS["plain"], [("/home/me/first (2).csv", digest("a")), ("b.csv", digest("b"))]).decode()
    assert "part.nc" in out and "first [2].csv" in out and "b.csv" in out
    assert "/home" not in out


@settings(max_examples=examples(60), deadline=None, derandomize=True)
@given(
    names=st.lists(st.text(min_size=1, max_size=40), min_size=1, max_size=4),
    style=st.sampled_from(sorted(PROGRAMS)),
)
def test_no_name_of_a_file_hides_the_mark(names, style):
    measured = [(name, digest(name + str(i))) for i, name in enumerate(names)]
    (mark,) = marks(parse(marked(PROGRAMS[style], measured), "t.nc").comments())
    assert mark.measured == tuple(d[:16] for _, d in measured)


def test_every_correction_leaves_its_mark():
    once = marked(PROGRAMS["upper case"], [("first.csv", digest("1"))])
    twice = marked(once, [("second.csv", digest("2"))], ("once.nc", digest("once")))
    found = marks(parse(twice, "t.nc").comments())
    assert {m.measured for m in found} == {(digest("1")[:16],), (digest("2")[:16],)}
    assert {m.source for m in found} == {digest("source")[:16], digest("once")[:16]}


def test_marks_of_the_first_versions():
    """Several digests used to be joined by plus signs."""
    a, b, c = digest("a")[:16], digest("b")[:16], digest("c")[:16]
    (mark,) = marks([(3, f"millcorr 0.1.0 corrected 2026-01-31 measurement {a}+{b} source {c}")])
    assert (mark.line, mark.date, mark.measured, mark.source) == (4, "2026-01-31", (a, b), c)


def test_other_comments_are_no_marks():
    assert marks([]) == ()
    texts = ["PART 1", "corrected by hand", "millcorr 0.1.0 path laid on the exact nominal, no correction", "MILLCORR"]
    assert marks(enumerate(texts)) == ()


def test_damaged_mark_is_not_passed_over():
    with pytest.raises(InputError, match="line 5: .*damaged"):
        marks([(4, "MILLCORR 0.1.0 CORRECTED 2026-01-31 MEASUREMENT 12AB SOURCE")])


def test_same_measurement_twice_is_refused():
    first, second = digest("first"), digest("second")
    carried = marks(parse(marked(PROGRAMS["upper case"], [("a.csv", first), ("b.csv", second)]), "t.nc").comments())
    for used in ([first], [digest("new"), second], [second.upper()]):
        with pytest.raises(RefusedError, match=r"part\.nc:3: this measurement was applied on \d{4}-\d\d-\d\d already"):
            refuse_second_use(carried, used, "part.nc", has_nominal=True)
    refuse_second_use(carried, [digest("new")], "part.nc", has_nominal=True)
    refuse_second_use((), [first], "part.nc", has_nominal=False)


def test_corrected_program_does_not_show_the_nominal():
    carried = marks(parse(marked(PROGRAMS["plain"], [("a.csv", digest("a"))]), "t.nc").comments())
    with pytest.raises(InputError, match=r"part\.nc:1: .*--nominal"):
        refuse_second_use(carried, [digest("new")], "part.nc", has_nominal=False)


def test_coarse_digits_do_not_make_the_next_part_the_one_before():
    """10 µm taken off, the next part within 2 µm: in steps of 0.01 mm nobody can say that these are the same points."""
    first = np.full(PLACES, 100) + np.arange(PLACES)
    second = np.resize([20, -20], PLACES)
    mark = Mark(3, "2026-01-01", ("0" * 16,), "1" * 16, first[None, :] % MODULUS)
    assert recognised([mark], first % MODULUS, 0.001) is mark
    assert recognised([mark], second % MODULUS, 0.001) is None
    assert recognised([mark], second % MODULUS, 0.01) is None
    large = Mark(3, "2026-01-01", ("0" * 16,), "1" * 16, 4 * first[None, :] % MODULUS)
    assert recognised([large], (4 * first + 60) % MODULUS, 0.01) is large
    assert recognised([large], second % MODULUS, 0.01) is None
