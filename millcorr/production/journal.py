# SPDX-License-Identifier: LGPL-2.1-or-later
"""The journal of a series: one SQLite file in which every part has its entry, whatever happens meanwhile.

An entry is written as pending, with the digest of the program that is about to be written, before that program
takes its place, and is made done after. Who opens a journal next settles what a crash left pending by looking at
the file: it has the digest, the entry is done; it has not, nothing was written and the entry goes. The lock on
the file is held from the first look to the last write, and the operating system takes it from a dead process, so
that a pending entry of a living one is never touched.

A rollback journal and not a write-ahead log: at rest the journal is one file that can be copied, nothing is gained
by readers beside a writer that writes a few kilobytes a part, and a crash leaves nothing but what the next one to
open it rolls back. ``synchronous=EXTRA`` makes each transaction outlast a power failure. The locks need a local disk.
"""

from __future__ import annotations

import datetime
import hashlib
import json
import os
import sqlite3
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from millcorr.arrays import Floats
from millcorr.errors import FormatError, InputError, RefusedError, UsageError
from millcorr.messages import option, phrase

from .places import Places
from .points import Points

APPLICATION = 0x6D636F72
"""SQLite's application id of a journal: 'mcor'."""

VERSION = 2
"""Of the schema, SQLite's user_version. 2 keeps the points of every part; in a journal of version 1 that goes on,
entries from before have none."""

PATIENCE = 60.0
"""Seconds to wait for another run to let go of the journal, to read it."""

TURN = 600.0
"""The same to write it: many jobs of a batch may hold one journal after the other, FreeCAD's for many seconds each."""

_POINTS = f"""
CREATE TABLE points (
    entry INTEGER PRIMARY KEY REFERENCES entry (id) ON DELETE CASCADE,
    data BLOB NOT NULL
);
PRAGMA user_version = {VERSION};
"""

_SCHEMA = f"""
CREATE TABLE chain (
    id INTEGER PRIMARY KEY,
    first TEXT NOT NULL UNIQUE,
    name TEXT NOT NULL,
    carried TEXT NOT NULL,
    places TEXT NOT NULL
);
CREATE TABLE entry (
    id INTEGER PRIMARY KEY,
    chain INTEGER NOT NULL REFERENCES chain (id),
    part INTEGER NOT NULL,
    time TEXT NOT NULL,
    status TEXT NOT NULL CHECK (status IN ('pending', 'done')),
    before_name TEXT NOT NULL,
    before_digest TEXT NOT NULL,
    after_name TEXT NOT NULL,
    after_digest TEXT NOT NULL,
    decision TEXT NOT NULL,
    reason TEXT NOT NULL,
    settings TEXT NOT NULL,
    statistics TEXT NOT NULL,
    deviation BLOB NOT NULL,
    commanded BLOB NOT NULL,
    correction BLOB NOT NULL,
    state BLOB NOT NULL,
    UNIQUE (chain, part)
);
CREATE TABLE measurement (
    chain INTEGER NOT NULL REFERENCES chain (id),
    entry INTEGER NOT NULL REFERENCES entry (id) ON DELETE CASCADE,
    fingerprint TEXT NOT NULL,
    name TEXT NOT NULL,
    PRIMARY KEY (chain, fingerprint)
);
PRAGMA application_id = {APPLICATION};
{_POINTS}"""


@dataclass(frozen=True, eq=False, slots=True)
class Entry:
    """One part.

    Parameters
    ----------
    time : str
        UTC, ISO 8601.
    before, after : (name, digest)
        Program that the part was cut with, and program for the next one: file name and SHA-256. Equal digests:
        the program was not corrected. In the journal `after` is named from the journal's directory.
    measurements : tuple of (name, fingerprint)
        Measured files.
    decision, reason : str
        What was done, and one line why.
    settings : mapping
        How it was corrected.
    statistics : mapping
        Numbers of the part, mm.
    deviation, commanded : (n,) float64
        At the places: determined deviation of the part from the nominal, and what its program commanded, mm.
    correction : (n,) float64
        Sum of all corrections in force for the next part, mm.
    state : (n,) float64
        Smoothed deviation to go on with, mm.
    points : Points or None
        What the machine added at the measured points; None where they are not known: in entries of an older
        millcorr, and of methods that carry touches along.
    part : int
        Number in its chain, from 1; 0 before it is in the journal.
    pending : bool
        True where a crash left open whether the program was written.
    """

    time: str
    before: tuple[str, str]
    after: tuple[str, str]
    measurements: tuple[tuple[str, str], ...]
    decision: str
    reason: str
    settings: Mapping[str, Any]
    statistics: Mapping[str, Any]
    deviation: Floats
    commanded: Floats
    correction: Floats
    state: Floats
    points: Points | None = None
    part: int = 0
    pending: bool = False

    @property
    def corrected(self) -> bool:
        """True where the program was changed."""
        return self.before[1] != self.after[1]


@dataclass(frozen=True, eq=False, slots=True)
class Chain:
    """All parts that go back to one first program.

    Parameters
    ----------
    first : str
        First 16 digits of the first program's SHA-256.
    name : str
        Of the program that the journal began with.
    carried : tuple of str
        Measurements (16 digits each) that this program carried already.
    places : Places
    entries : tuple of Entry
        In the order of their parts.
    """

    first: str
    name: str
    carried: tuple[str, ...]
    places: Places
    entries: tuple[Entry, ...] = ()

    @property
    def applied(self) -> tuple[str, ...]:
        """Measurements (16 digits each) that the program for the next part carries."""
        own = [fingerprint[:16] for entry in self.entries if entry.corrected for _, fingerprint in entry.measurements]
        return (*self.carried, *own)

    @property
    def since_correction(self) -> tuple[Entry, ...]:
        """Parts that were cut with the program for the next one, those behind the last correction."""
        due = [k for k, entry in enumerate(self.entries) if entry.corrected or entry.decision in ("smoothed", "direct")]
        return self.entries[due[-1] + 1 if due else 0 :]


class RepeatedError(RefusedError):
    """A measurement has its entry already.

    Parameters
    ----------
    message : str
    before : str
        SHA-256 of the program that the part was cut with, as the entry has it.
    output : Path
        Program that the entry's run wrote.
    after : str
        Its SHA-256.
    """

    def __init__(self, message: str, before: str, output: Path, after: str) -> None:
        super().__init__(message)
        self.before, self.output, self.after = before, output, after

    def is_same_run(self, program: str, output: Path) -> bool:
        """Whether the entry is that of the very run: from a program of this SHA-256, to this output, still there."""
        output = output.resolve()
        return program == self.before and output == self.output and _digest(output) == self.after


@dataclass(slots=True)
class Journal:
    """A journal that is held for writing; see `held`."""

    path: Path
    _connection: sqlite3.Connection = field(repr=False)

    def chain(self, first: str) -> Chain | None:
        """The chain of a first program (16 digits), None where it has no entry yet."""
        return next(_chains(self._connection, self.path, first), None)

    def refuse_second_use(self, first: str, measurements: Sequence[tuple[str, str]]) -> None:
        """Refuse a measurement that has its entry already.

        Raises
        ------
        RepeatedError
            Names the earlier entry and its time.
        """
        for name, fingerprint in measurements:
            row = self._connection.execute(
                "SELECT e.part, e.time, m.name, e.after_name, e.before_digest, e.after_digest "
                "FROM measurement m JOIN entry e ON e.id = m.entry JOIN chain c ON c.id = m.chain "
                "WHERE c.first = ? AND m.fingerprint = ?",
                (first, fingerprint),
            ).fetchone()
            if row:
                part, time, earlier, output, before, after = row
                raise RepeatedError(
                    phrase(
                        "{}: this measurement is part {} of {} already (as {} on {}, for {}); measure a new part",
                        name,
                        part,
                        self.path,
                        earlier,
                        time,
                        output,
                    ),
                    before,
                    (self.path.resolve().parent / output).resolve(),
                    after,
                )

    @contextmanager
    def entered(self, chain: Chain, entry: Entry) -> Iterator[int]:
        """Have an entry appear together with the program that the body writes at ``entry.after``.

        Parameters
        ----------
        chain : Chain
            Made where it is new.
        entry : Entry
            ``after`` names the path and digest of the program to be written.

        Yields
        ------
        int
            Number of the part.

        Raises
        ------
        RefusedError
            If a measurement has its entry already; if the body ends without that program being written.
        """
        self.refuse_second_use(chain.first, entry.measurements)
        output = Path(entry.after[0]).resolve()
        there_before = _digest(output) == entry.after[1]
        number, part = self._insert(chain, entry, _from(self.path, output))
        try:
            yield part
        except BaseException:
            if there_before:
                self._delete(number)
            else:
                self._settle(number, output, entry.after[1])
            raise
        if not self._settle(number, output, entry.after[1]):
            raise RefusedError(
                phrase("{}: not what the journal {} announced; part {} was not recorded", output, self.path, part)
            )

    def _insert(self, chain: Chain, entry: Entry, after: str) -> tuple[int, int]:
        with _transaction(self._connection):
            self._connection.execute(
                "INSERT INTO chain (first, name, carried, places) VALUES (?, ?, ?, ?) ON CONFLICT (first) DO NOTHING",
                (chain.first, chain.name, " ".join(chain.carried), chain.places.text()),
            )
            (key,) = self._connection.execute("SELECT id FROM chain WHERE first = ?", (chain.first,)).fetchone()
            (part,) = self._connection.execute(
                "SELECT coalesce(max(part), 0) + 1 FROM entry WHERE chain = ?", (key,)
            ).fetchone()
            row = (key, part, entry.time, "pending", *entry.before, after, entry.after[1], entry.decision, entry.reason)
            texts = (_json(entry.settings), _json(entry.statistics))
            blobs = tuple(_packed(v) for v in (entry.deviation, entry.commanded, entry.correction, entry.state))
            number = self._connection.execute(
                "INSERT INTO entry (chain, part, time, status, before_name, before_digest, after_name, after_digest, "
                "decision, reason, settings, statistics, deviation, commanded, correction, state) "
                f"VALUES ({', '.join('?' * 16)})",
                (*row, *texts, *blobs),
            ).lastrowid
            assert number is not None
            if entry.points is not None:
                self._connection.execute(
                    "INSERT INTO points (entry, data) VALUES (?, ?)", (number, entry.points.packed())
                )
            self._connection.executemany(
                "INSERT INTO measurement (chain, entry, fingerprint, name) VALUES (?, ?, ?, ?)",
                [(key, number, fingerprint, name) for name, fingerprint in entry.measurements],
            )
        return number, part

    def _settle(self, number: int, output: Path, digest: str) -> bool:
        """Make a pending entry done where its program is in its place, else take it out; True where done."""
        if _digest(output) != digest:
            self._delete(number)
            return False
        with _transaction(self._connection):
            self._connection.execute("UPDATE entry SET status = 'done' WHERE id = ?", (number,))
        return True

    def _delete(self, number: int) -> None:
        with _transaction(self._connection):
            self._connection.execute("DELETE FROM entry WHERE id = ?", (number,))
            self._connection.execute("DELETE FROM chain WHERE id NOT IN (SELECT chain FROM entry)")

    def _settle_all(self) -> None:
        left = self._connection.execute("SELECT id, after_name, after_digest FROM entry WHERE status = 'pending'")
        for number, name, digest in left.fetchall():
            self._settle(number, self.path.resolve().parent / name, digest)


@contextmanager
def held(path: str | Path, *, patience: float = TURN) -> Iterator[Journal]:
    """Hold a journal for writing, alone; it is made where it does not exist.

    Parameters
    ----------
    path : path
    patience : float
        Seconds to wait for another run that holds it.

    Raises
    ------
    UsageError
        If the path is a directory, or there is no directory for it.
    FormatError
        If the file is no journal, damaged, or of a newer millcorr.
    InputError
        If it cannot be written, or another run does not let go of it.
    """
    path = Path(path)
    if path.is_dir():
        raise UsageError(phrase("{} is a directory; name a file", option("journal", path)))
    if not path.resolve().parent.is_dir():
        raise UsageError(
            phrase("{}: there is no directory {}: make it first", option("journal", path), path.resolve().parent)
        )
    # SQLite would open it for reading only, and lock nothing.
    if not os.access(path if path.exists() else path.resolve().parent, os.W_OK):
        raise InputError(phrase("{}: the journal cannot be written: no permission", path))
    with _named_errors(path), closing(_connected(path, "rwc", patience)) as connection:
        with _transaction(connection, "EXCLUSIVE"):
            # Keeps the lock from here to the end. Set before, two that wait would each keep a lock for reading that
            # the other one waits for.
            connection.execute("PRAGMA locking_mode = EXCLUSIVE")
            missing = _SCHEMA if _is_new(connection, path) else "" if _keeps_points(connection) else _POINTS
            for statement in missing.split(";\n"):
                connection.execute(statement)
        journal = Journal(path, connection)
        journal._settle_all()
        yield journal


def read(path: str | Path) -> tuple[Chain, ...]:
    """All chains of a journal, without holding it.

    Raises
    ------
    InputError, FormatError
        If there is no such file; see `held`.
    """
    path = Path(path)
    if not path.is_file():
        raise InputError(phrase("{}: there is no such journal", path))
    with _named_errors(path), closing(_connected(path, "rw", PATIENCE)) as connection:
        with _transaction(connection, "DEFERRED"):
            return () if _is_new(connection, path) else tuple(_chains(connection, path))


def now() -> str:
    """Time for an entry: UTC, to the second."""
    return datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%dT%H:%M:%SZ")


def _connected(path: Path, mode: str, patience: float) -> sqlite3.Connection:
    place = path.resolve().as_uri() + f"?mode={mode}"
    connection = sqlite3.connect(place, uri=True, timeout=patience, isolation_level=None)
    try:
        connection.execute("PRAGMA foreign_keys = ON")
        connection.execute("PRAGMA synchronous = EXTRA")
    except BaseException:
        connection.close()
        raise
    return connection


@contextmanager
def _transaction(connection: sqlite3.Connection, kind: str = "IMMEDIATE") -> Iterator[None]:
    connection.execute(f"BEGIN {kind}")
    try:
        yield
        connection.execute("COMMIT")
    except BaseException:
        if connection.in_transaction:
            connection.execute("ROLLBACK")
        raise


def _is_new(connection: sqlite3.Connection, path: Path) -> bool:
    """True for an empty file; refuses what is no journal, damaged or of a newer millcorr."""
    (application,) = connection.execute("PRAGMA application_id").fetchone()
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    (tables,) = connection.execute("SELECT count(*) FROM sqlite_master").fetchone()
    if not (application or version or tables):
        return True
    if application != APPLICATION:
        raise FormatError(phrase("an SQLite file of another program, not a journal of millcorr"), path)
    if version > VERSION:
        raise FormatError(
            phrase(
                "written by a newer millcorr (journal version {}, this one knows {}): update millcorr", version, VERSION
            ),
            path,
        )
    (sound,) = connection.execute("PRAGMA quick_check(1)").fetchone()
    if sound != "ok":
        raise FormatError(phrase("the journal is damaged ({}): restore it from a copy", " ".join(sound.split())), path)
    return False


def _keeps_points(connection: sqlite3.Connection) -> bool:
    """False for a journal of version 1."""
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    return int(version) > 1


@contextmanager
def _named_errors(path: Path) -> Iterator[None]:
    """Errors of SQLite as one line that says what to do."""
    try:
        yield
    except sqlite3.OperationalError as error:
        if error.sqlite_errorcode in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED):
            raise InputError(
                phrase("{}: another run has held the journal for too long; try again when it is done", path)
            ) from (error)
        if error.sqlite_errorcode == sqlite3.SQLITE_CORRUPT:
            raise FormatError(phrase("the journal is damaged ({}): restore it from a copy", error), path) from error
        raise InputError(phrase("{}: the journal cannot be read or written ({})", path, error)) from error
    except sqlite3.DatabaseError as error:
        raise FormatError(
            phrase("not a journal of millcorr, or damaged ({}): give the journal, or restore it from a copy", error),
            path,
        ) from error


_COLUMNS = (
    "id, part, time, status, before_name, before_digest, after_name, after_digest, decision, reason, settings, "
    "statistics, deviation, commanded, correction, state"
)


def _chains(connection: sqlite3.Connection, path: Path, first: str | None = None) -> Iterator[Chain]:
    chains = connection.execute(
        "SELECT id, first, name, carried, places FROM chain WHERE ?1 IS NULL OR first = ?1 ORDER BY id", (first,)
    ).fetchall()
    for key, own, name, carried, places in chains:
        files: dict[int, list[tuple[str, str]]] = {}
        for number, file, fingerprint in connection.execute(
            "SELECT entry, name, fingerprint FROM measurement WHERE chain = ? ORDER BY rowid", (key,)
        ):
            files.setdefault(number, []).append((file, fingerprint))
        rows = connection.execute(f"SELECT {_COLUMNS} FROM entry WHERE chain = ? ORDER BY part", (key,)).fetchall()
        points: dict[int, bytes] = {}
        if _keeps_points(connection):
            points = dict(
                connection.execute(
                    "SELECT p.entry, p.data FROM points p JOIN entry e ON e.id = p.entry WHERE e.chain = ?", (key,)
                ).fetchall()
            )
        try:
            where = Places.from_text(places)
            entries = tuple(_entry(row, tuple(files.get(row[0], ())), len(where), points.get(row[0])) for row in rows)
        except (ValueError, TypeError, LookupError, zlib.error) as error:
            raise FormatError(phrase("the journal is damaged ({}): restore it from a copy", error), path) from error
        yield Chain(own, name, tuple(carried.split()), where, entries)


def _entry(row: Sequence[Any], files: tuple[tuple[str, str], ...], places: int, points: bytes | None) -> Entry:
    _, part, time, status, before, before_digest, after, after_digest, decision, reason, settings, statistics = row[:12]
    deviation, commanded, correction, state = (_unpacked(blob, places) for blob in row[12:])
    return Entry(
        time,
        (before, before_digest),
        (after, after_digest),
        files,
        decision,
        reason,
        dict(json.loads(settings)),
        dict(json.loads(statistics)),
        deviation,
        commanded,
        correction,
        state,
        None if points is None else Points.from_packed(points),
        int(part),
        status == "pending",
    )


def _packed(value: Floats) -> bytes:
    return zlib.compress(np.ascontiguousarray(value, dtype="<f8").tobytes())


def _unpacked(blob: bytes, count: int) -> Floats:
    out = np.frombuffer(zlib.decompress(blob), dtype="<f8").astype(np.float64)
    if len(out) != count:
        raise ValueError(f"{len(out)} values for {count} places")
    out.flags.writeable = False
    return out


def _json(data: Mapping[str, Any]) -> str:
    return json.dumps(data, allow_nan=True, sort_keys=True)


def _from(journal: Path, output: Path) -> str:
    """Path of the output from the journal's directory, so that both can be moved together."""
    try:
        return os.path.relpath(output, journal.resolve().parent)
    except ValueError:  # another drive
        return str(output)


def _digest(path: Path) -> str | None:
    """SHA-256 of a file, None where there is none; a file that cannot be read decides nothing and raises OSError."""
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except (FileNotFoundError, NotADirectoryError, IsADirectoryError):
        return None
