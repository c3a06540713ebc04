# SPDX-License-Identifier: LGPL-2.1-or-later
"""The journal: what goes in comes out, whatever happens between; what is no journal is named in one line."""

from __future__ import annotations

import dataclasses
import hashlib
import os
import shutil
import sqlite3
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

import millcorr
from millcorr.errors import FormatError, InputError, MillcorrError, RefusedError, UsageError
from millcorr.geometry.profile import Stretch
from millcorr.production import journal
from millcorr.production.journal import Chain, Entry
from millcorr.production.places import Places
from millcorr.production.points import Points
from tests.core import journal_crash

PLACES = Places((Stretch(0, 0.0, 30.0, True), Stretch(1, 2.5, 4.0, False)), (60, 8))
FIRST = b"G1 X0\n"


def sha(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


CHAIN = Chain(sha(FIRST)[:16], "P0.nc", ("ab" * 8,), PLACES)


def entry(output: Path, after: bytes, *, number: int = 1, before: bytes = FIRST) -> Entry:
    noise = np.random.default_rng(number)
    fields = [noise.normal(0, 1e-3, len(PLACES)) for _ in range(4)]
    fields[0][3] = np.nan
    return Entry(
        f"2024-05-0{number}T06:30:00Z",
        ("P0.nc", sha(before)),
        (str(output), sha(after)),
        ((f"part-{number}.csv", sha(b"%d" % number)), (f"again-{number}.csv", sha(b"again %d" % number))),
        "smoothed",
        "beyond",
        {"correction": "gain 1", "control": {"limit": 0.004}},
        {"mean": 0.001, "random_std": float("nan")},
        *fields,
        points=Points(*np.zeros((2, 9), dtype=np.int64), *noise.normal(0, 1e-3, (6, 9))),
    )


def enter(path: Path, chain: Chain, item: Entry, data: bytes) -> int:
    with journal.held(path) as book, book.entered(chain, item) as part:
        Path(item.after[0]).write_bytes(data)
    return part


@pytest.fixture
def series(tmp_path: Path) -> Iterator[Path]:
    """A journal with two parts."""
    path = tmp_path / "series.journal"
    one, two = b"G1 X1\n", b"G1 X2\n"
    assert enter(path, CHAIN, entry(tmp_path / "P1.nc", one), one) == 1
    assert enter(path, CHAIN, entry(tmp_path / "P2.nc", two, number=2, before=one), two) == 2
    yield path


def test_what_goes_in_comes_out(series: Path, tmp_path: Path) -> None:
    (chain,) = journal.read(series)
    assert (chain.first, chain.name, chain.carried) == (CHAIN.first, "P0.nc", CHAIN.carried)
    assert chain.places.same(PLACES)
    for number, found in enumerate(chain.entries, 1):
        put = entry(tmp_path / f"P{number}.nc", b"G1 X%d\n" % number, number=number, before=FIRST)
        for field in ("time", "measurements", "decision", "reason", "settings"):
            assert getattr(found, field) == getattr(put, field)
        assert found.statistics["mean"] == 0.001 and np.isnan(found.statistics["random_std"])
        for field in ("deviation", "commanded", "correction", "state"):
            assert np.array_equal(getattr(found, field), getattr(put, field), equal_nan=True)
            assert not getattr(found, field).flags.writeable
        assert (found.part, found.pending, found.corrected) == (number, False, True)
        # Named from the journal's directory, so that both move together.
        assert found.after == (f"P{number}.nc", sha(b"G1 X%d\n" % number))
        for column in Points.__slots__:
            assert np.array_equal(getattr(found.points, column), getattr(put.points, column), equal_nan=True)
    assert chain.since_correction == ()
    assert chain.applied == (*CHAIN.carried, *(f[:16] for e in chain.entries for _, f in e.measurements))


def test_at_rest_the_journal_is_one_file(series: Path) -> None:
    assert sorted(p.name for p in series.parent.iterdir()) == ["P1.nc", "P2.nc", "series.journal"]


def test_the_same_measurement_twice_is_refused_with_the_earlier_entry(series: Path, tmp_path: Path) -> None:
    again = entry(tmp_path / "P3.nc", b"G1 X3\n", number=1, before=b"G1 X2\n")
    # Under another name, among others: the fingerprint decides.
    again = dataclasses.replace(again, measurements=(("new.csv", sha(b"new")), ("copy.csv", sha(b"1"))))
    with pytest.raises(RefusedError, match=r"copy\.csv: .* part 1 .* \(as part-1\.csv on 2024-05-01T06:30:00Z"):
        enter(series, CHAIN, again, b"G1 X3\n")
    assert len(journal.read(series)[0].entries) == 2 and not (tmp_path / "P3.nc").exists()


def test_another_chain_in_the_same_journal_counts_for_itself(series: Path, tmp_path: Path) -> None:
    other = dataclasses.replace(CHAIN, first="cd" * 8, name="Q0.nc")
    assert enter(series, other, entry(tmp_path / "Q1.nc", b"Q"), b"Q") == 1
    assert [(c.first, len(c.entries)) for c in journal.read(series)] == [(CHAIN.first, 2), (other.first, 1)]


def test_a_failing_body_leaves_no_entry(series: Path, tmp_path: Path) -> None:
    with pytest.raises(OSError, match="disk full"):
        with journal.held(series) as book, book.entered(CHAIN, entry(tmp_path / "P3.nc", b"X", number=3)):
            raise OSError("disk full")
    assert len(journal.read(series)[0].entries) == 2
    assert enter(series, CHAIN, entry(tmp_path / "P3.nc", b"X", number=3), b"X") == 3


def test_a_body_that_fails_after_writing_keeps_its_entry(series: Path, tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt):
        with journal.held(series) as book, book.entered(CHAIN, entry(tmp_path / "P3.nc", b"X", number=3)):
            (tmp_path / "P3.nc").write_bytes(b"X")
            raise KeyboardInterrupt
    assert [e.pending for e in journal.read(series)[0].entries] == [False] * 3


def test_a_failing_body_with_the_program_in_its_place_before_leaves_no_entry(series: Path, tmp_path: Path) -> None:
    (tmp_path / "same.nc").write_bytes(FIRST)
    with pytest.raises(OSError, match="report"):
        with journal.held(series) as book, book.entered(CHAIN, entry(tmp_path / "same.nc", FIRST, number=3)):
            raise OSError("report")
    assert len(journal.read(series)[0].entries) == 2


def test_another_program_than_announced_is_refused(series: Path, tmp_path: Path) -> None:
    with pytest.raises(RefusedError, match="not what the journal .* announced; part 3 was not recorded"):
        enter(series, CHAIN, entry(tmp_path / "P3.nc", b"X", number=3), b"Y")
    assert len(journal.read(series)[0].entries) == 2


@pytest.mark.parametrize("written", [False, True])
def test_a_pending_entry_is_settled_by_the_file(series: Path, tmp_path: Path, written: bool) -> None:
    """What a crash between announcing and confirming leaves, before and after the program took its place."""
    with pytest.raises(RefusedError):
        enter(series, CHAIN, entry(tmp_path / "P3.nc", b"X", number=3), b"Y")
    with closing(sqlite3.connect(series)) as connection, connection:
        connection.execute("UPDATE entry SET status = 'pending' WHERE part = 2")
    assert journal.read(series)[0].entries[1].pending
    if not written:
        (tmp_path / "P2.nc").write_bytes(b"what was there before\n")
    with journal.held(series) as book:
        chain = book.chain(CHAIN.first)
    assert [e.part for e in chain.entries] == ([1, 2] if written else [1])
    assert not any(e.pending for e in chain.entries)
    if not written:
        assert enter(series, CHAIN, entry(tmp_path / "P2.nc", b"G1 X2\n", number=2), b"G1 X2\n") == 2


def test_a_pending_entry_moves_with_its_program(series: Path, tmp_path: Path) -> None:
    with closing(sqlite3.connect(series)) as connection, connection:
        connection.execute("UPDATE entry SET status = 'pending' WHERE part = 2")
    moved = tmp_path / "elsewhere"
    moved.mkdir()
    for name in ("series.journal", "P1.nc", "P2.nc"):
        shutil.move(tmp_path / name, moved / name)
    with journal.held(moved / "series.journal") as book:
        assert [e.pending for e in book.chain(CHAIN.first).entries] == [False, False]


def test_kill_minus_nine_with_two_writers(tmp_path: Path) -> None:
    """30 of the runs of tests/fuzz/journal.py."""
    met = journal_crash.run(tmp_path, 30, seed=7)
    assert met["runs"] == 30 and met["parts"] >= 30
    # Kills that met nothing half done would prove nothing.
    assert met["pending"] >= 1


def test_another_run_that_holds_the_journal_is_named(series: Path) -> None:
    with journal.held(series):
        with pytest.raises(InputError, match="another run has held the journal for too long"):
            with journal.held(series, patience=0.05):
                raise AssertionError("both hold it")


NOT_A_JOURNAL = {
    "text": b"part 1: 3 um, all well\n" * 100,
    "zeros": bytes(8192),
    "a header without anything": b"SQLite format 3\0",
}


@pytest.mark.parametrize("what", NOT_A_JOURNAL)
def test_what_is_no_journal_is_named_and_left_alone(tmp_path: Path, what: str) -> None:
    path = tmp_path / "P0.nc.journal"
    path.write_bytes(NOT_A_JOURNAL[what])
    for use in (journal.read, lambda p: enter(p, CHAIN, entry(tmp_path / "P1.nc", b"X"), b"X")):
        with pytest.raises(FormatError, match=r"P0\.nc\.journal: not a journal of millcorr, or damaged"):
            use(path)
    assert path.read_bytes() == NOT_A_JOURNAL[what]


def test_another_programs_database_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "other.journal"
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("CREATE TABLE entry (x)")
    data = path.read_bytes()
    for use in (journal.read, lambda p: enter(p, CHAIN, entry(tmp_path / "P1.nc", b"X"), b"X")):
        with pytest.raises(FormatError, match="an SQLite file of another program"):
            use(path)
    assert path.read_bytes() == data


def test_a_newer_journal_is_refused(series: Path) -> None:
    with closing(sqlite3.connect(series)) as connection, connection:
        connection.execute(f"PRAGMA user_version = {journal.VERSION + 1}")
    for use in (journal.read, lambda p: journal.held(p).__enter__()):
        with pytest.raises(
            FormatError, match=r"newer millcorr \(journal version 3, this one knows 2\): update millcorr"
        ):
            use(series)


def test_a_journal_without_points_opens_and_goes_on(series: Path, tmp_path: Path) -> None:
    """As version 1 was: no table of points. It is read as it is, and gets the table when it is written."""
    with closing(sqlite3.connect(series)) as connection, connection:
        connection.execute("DROP TABLE points")
        connection.execute("PRAGMA user_version = 1")
    assert [e.points for e in journal.read(series)[0].entries] == [None, None]
    three = b"G1 X3\n"
    assert enter(series, CHAIN, entry(tmp_path / "P3.nc", three, number=3, before=b"G1 X2\n"), three) == 3
    points = [e.points for e in journal.read(series)[0].entries]
    assert points[:2] == [None, None] and points[2] is not None


def test_an_empty_file_becomes_a_journal(tmp_path: Path) -> None:
    """A crash while the file was made leaves it empty."""
    path = tmp_path / "new.journal"
    path.touch()
    assert journal.read(path) == ()
    assert enter(path, CHAIN, entry(tmp_path / "P1.nc", b"X"), b"X") == 1


@pytest.mark.parametrize("column", ["deviation", "settings", "statistics"])
def test_damaged_contents_are_named(series: Path, column: str) -> None:
    with closing(sqlite3.connect(series)) as connection, connection:
        connection.execute(f"UPDATE entry SET {column} = ?", (b"\x00damaged",))
    with pytest.raises(FormatError, match=r"series\.journal: the journal is damaged \(.*restore it from a copy"):
        journal.read(series)


def test_damaged_pages_end_in_one_line_or_in_nothing_worse(series: Path) -> None:
    """Every page in turn overwritten with noise, and the file cut anywhere: one line, never another exception."""
    data, noise = series.read_bytes(), np.random.default_rng(11)
    copies = []
    for page in range(len(data) // 4096):
        broken = bytearray(data)
        at = page * 4096 + int(noise.integers(0, 4096 - 600))
        broken[at : at + 600] = noise.bytes(600)
        copies.append(bytes(broken))
    copies += [data[: int(noise.integers(1, len(data)))] for _ in range(20)]
    refused = 0
    for copy in copies:
        series.write_bytes(copy)
        try:
            journal.read(series)
        except MillcorrError as error:
            refused += 1
            assert "\n" not in str(error) and "series.journal" in str(error)
    assert refused >= len(copies) // 2


def test_places_where_no_journal_can_be(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="is a directory; name a file"):
        journal.held(tmp_path).__enter__()
    with pytest.raises(UsageError, match="there is no directory"):
        journal.held(tmp_path / "no" / "x.journal").__enter__()
    with pytest.raises(InputError, match="there is no such journal"):
        journal.read(tmp_path / "x.journal")


WRITE_AS_ANOTHER_USER = """
import os, sys
from pathlib import Path
from millcorr.production import journal
from millcorr.errors import MillcorrError
if os.geteuid() == 0:
    os.setgid(65534)
    os.setuid(65534)
print(len(journal.read(sys.argv[1])[0].entries))
for path in sys.argv[1:]:
    try:
        with journal.held(path):
            print("held")
    except MillcorrError as error:
        print(type(error).__name__, error)
"""


def test_a_directory_that_may_not_be_written_to(series: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    import tempfile

    # Under a directory that every user may enter.
    with tempfile.TemporaryDirectory() as name:
        place = Path(name)
        shutil.copy(series, place / "series.journal")
        (place / "series.journal").chmod(0o444)
        place.chmod(0o555)
        try:
            done = subprocess.run(
                [
                    sys.executable,
                    "-c",
                    WRITE_AS_ANOTHER_USER,
                    str(place / "series.journal"),
                    str(place / "new.journal"),
                ],
                capture_output=True,
                text=True,
                cwd=Path(millcorr.__file__).parents[1],
                env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
            )
        finally:
            place.chmod(0o755)
    assert done.returncode == 0, done.stderr
    count, *said = done.stdout.splitlines()
    assert count == "2"
    assert len(said) == 2 and all(
        line.startswith("InputError ") and "the journal cannot be written: no permission" in line for line in said
    )
