# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a corrected program may differ in from its original, and that nothing else passes."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from millcorr import nc
from millcorr.errors import LimitError, MillcorrError
from millcorr.nc.toolpath import Kind, Toolpath
from millcorr.path.second_reader import prove
from tests.core import loop_programs
from tests.core.nc.test_gcode_write import halved
from tests.core.nc_programs import Made, displaced, programs
from tests.core.sweeps import examples, slow
from tests.core.text_mutants import mutants

DATA = Path(__file__).parents[2] / "data" / "nc"
HEADER = ("millcorr 0.1.0 corrected 2026-01-01 measurement 0123456789abcdef source 0123456789abcdef", "gain 1 3 \xb5m")
PROGRAMS = {
    name: text.encode() for name, text in vars(loop_programs).items() if name.isupper() and isinstance(text, str)
}
PROGRAMS |= {path.stem: path.read_bytes() for path in sorted(DATA.glob("*.nc"))}
PROGRAMS["feeds"] = b"""%
O100
N10 G21 G90 G17 G54
N20 T1 M6 (D10)
N30 S3000 M3 M8
N40 G0 X0 Y0
N50 G43 H1 Z5.
N60 G1 Z-2.5 F100.
N70 X10.25 F300.
N80 G3 X20.25 Y10. I0. J10. F250.
N90 G1 Y40. F300.
N100 X0. F310. M9
N110 G4 P0.5
N120 Y0.
/N130 G1 X2. Y-2. F320.
N140 G0 Z5.
N150 G0 X30. Y-10.
N160 G1 Z-2.5 F100.
N170 X40.
N180 G2 X45. Y-5. R5.
N190 G0 Z50. M5
N200 M30
%
"""
MOVED = 0.05
"""A correction, mm."""


@cache
def pair(name: str) -> tuple[bytes, bytes, tuple[int, ...]]:
    """Original, written text, and the lines that were to change: plain cutting moves displaced, some divided."""
    program = nc.parse(PROGRAMS[name], f"{name}.nc")
    path = program.toolpath
    random = np.random.default_rng(len(name))
    level = ~(np.abs(path.start[:, 2] - path.end[:, 2]) > 1e-9) | (path.kind == Kind.ARC)
    moved = (path.kind != Kind.RAPID) & (path.kind != Kind.CUBIC) & (path.plane == 17) & ~program.opaque_moves() & level
    # What is opaque starts where it did, and so does what relies on it.
    near = np.flatnonzero(program.opaque_moves())
    moved[near[near > 0] - 1] = False
    shift = np.zeros((len(path), 3))
    shift[moved, :2] = random.uniform(-MOVED, MOVED, (int(moved.sum()), 2))
    wanted = displaced(path, shift)
    divided = halved(wanted, moved & (random.random(len(path)) < 0.4))
    for planned in (divided, wanted):
        try:
            written = nc.write(program, planned, header=HEADER)
        except nc.FormatError:  # an M code that sets something belongs to one move
            continue
        return program.data, written, tuple(changed(path, planned))
    raise AssertionError(name)


def changed(old: Toolpath, new: Toolpath) -> list[int]:
    """Lines whose moves are not what they were, their starts included."""
    count = np.bincount(new.source, minlength=int(old.source.max()) + 1)
    lines = set(np.flatnonzero(count > 1).tolist())
    first = np.searchsorted(new.source, old.source)
    for what in ("kind", "start", "end", "centre", "sweep", "control"):
        a, b = (np.reshape(getattr(t, what)[rows], (len(old), -1)) for t, rows in ((old, slice(None)), (new, first)))
        lines |= set(old.source[~np.isclose(a, b, rtol=0, atol=1e-9, equal_nan=True).all(axis=1)].tolist())
    return sorted(lines)


@pytest.mark.parametrize("name", PROGRAMS)
def test_what_the_writer_writes_is_proven(name: str) -> None:
    original, written, may_change = pair(name)
    proof = prove(original, written, np.array(may_change), header=HEADER, reach=2 * MOVED)
    # HEIDENHAIN's numbers count on over what is inserted.
    old, new = (
        [re.sub(rb"^N\d+ ", b"", line) if name == "heidenhain-iso" else line for line in text.splitlines()]
        for text in (original, written)
    )
    kept = np.flatnonzero(proof.untouched)
    assert [new[w] for w in kept] == [old[i] for i in proof.source[kept]]
    assert set(range(len(old))) - set(may_change) <= set(proof.source.tolist())
    assert proof.header == sum(b"millcorr" in line or b"gain" in line.lower() for line in written.lower().splitlines())
    assert 0 <= proof.largest_shift <= 2 * MOVED
    assert len(proof.moves) == len(nc.parse(written).toolpath)


@pytest.mark.parametrize("name", PROGRAMS)
def test_nothing_changed_is_proven(name: str) -> None:
    assert prove(PROGRAMS[name], PROGRAMS[name], np.zeros(0, dtype=np.int64)).untouched.all()


def survivors(name: str, seed: int, count: int) -> list[str]:
    """Mutants that are not caught although more than places on lines that were to change has changed."""
    original, written, may_change = pair(name)
    proof = prove(original, written, np.array(may_change), header=HEADER, reach=2 * MOVED)
    out = []
    for text, what, kind, lines in mutants(written, seed, count):
        if kind == "place" and not proof.untouched[list(lines)].any():
            continue
        if kind == "place" and "doubled" in what and not proof.untouched[lines[0] - 1 : lines[0] + 2].all():
            # Beside lines that were to change it is one more of them.
            continue
        try:
            prove(original, text, np.array(may_change), header=HEADER, reach=2 * MOVED)
        except LimitError:
            continue
        out.append(f"{name} {what}")
    return out


@pytest.mark.parametrize(("seed", "count"), [(0, 25), slow(1, 600)])
@pytest.mark.parametrize("name", PROGRAMS)
def test_mutants_are_caught(name: str, seed: int, count: int) -> None:
    assert not survivors(name, seed, count)


@settings(max_examples=examples(100), deadline=None)
@given(programs(max_moves=20), st.integers(0, 2**32 - 1))
def test_random_programs_are_proven(made: Made, seed: int) -> None:
    program = nc.parse(made.text)
    path = program.toolpath
    # Corrections are in the XY plane; arcs in others start where they did.
    assume(not ((path.plane != 17) & (path.kind == Kind.ARC)).any())
    random = np.random.default_rng(seed)
    moved = random.random(len(path)) < 0.7
    moved[0] = False
    shift = np.zeros((len(path), 3))
    shift[moved, :2] = random.uniform(-MOVED, MOVED, (int(moved.sum()), 2))
    wanted = displaced(path, shift)
    wanted = halved(wanted, moved & (wanted.kind != Kind.RAPID) & (random.random(len(path)) < 0.3))
    try:
        written = nc.write(program, wanted, header=HEADER)
    except MillcorrError:  # an arc that is no arc any more
        assume(False)
    prove(program.data, written, changed(path, wanted), header=HEADER, reach=4 * MOVED)
