# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kill writers of a journal at any moment and look whether journal and program still tell the same story.

A writer measures parts without end, enters them, and writes the program of the next part. Two of them, processes of
their own, work on one journal and one chain, and try the same measurements. A program is a text with one line
for every measurement that was applied, so that a lost, doubled or reordered entry shows in it.
"""

from __future__ import annotations

import hashlib
import multiprocessing
import os
import random
import signal
import time
from collections import Counter
from multiprocessing.process import BaseProcess
from pathlib import Path

import numpy as np

from millcorr.errors import RefusedError
from millcorr.geometry.profile import Stretch
from millcorr.production import journal
from millcorr.production.places import Places

FIRST = b"(first program)\n"
PLACES = Places((Stretch(0, 0.0, 4.0, True),), (8,))
CHAIN = journal.Chain(hashlib.sha256(FIRST).hexdigest()[:16], "P0.nc", (), PLACES)


def fingerprint(number: int) -> str:
    return hashlib.sha256(b"measurement %d" % number).hexdigest()


def corrects(number: int) -> bool:
    """Every third part is within the limit: its program stays."""
    return number % 3 != 2


def write(directory: Path, seed: int) -> None:
    """Enter part after part until killed; what is acknowledged is noted in a file of one's own."""
    dice = random.Random(seed)
    book_path, program = directory / "series.journal", directory / "program.nc"
    acknowledged = os.open(directory / f"acknowledged-{seed}", os.O_WRONLY | os.O_CREAT | os.O_APPEND)
    while True:
        with journal.held(book_path) as book:
            # Where the writers look is behind: they try what the other one may just have entered.
            chain = book.chain(CHAIN.first) or CHAIN
            number = max(0, len(chain.entries) - dice.randint(0, 1))
            try:
                enter(book, chain, number, program, dice)
            except RefusedError:
                continue
        os.write(acknowledged, f"{number}\n".encode())


def enter(book: journal.Journal, chain: journal.Chain, number: int, program: Path, dice: random.Random) -> None:
    before = program.read_bytes()
    after = before + f"({fingerprint(number)})\n".encode() if corrects(number) else before
    zero = np.zeros(len(PLACES))
    entry = journal.Entry(
        journal.now(),
        (program.name, hashlib.sha256(before).hexdigest()),
        (str(program), hashlib.sha256(after).hexdigest()),
        ((f"part-{number}.csv", fingerprint(number)),),
        "correct",
        "",
        {},
        {},
        zero + number,
        zero,
        zero,
        zero,
    )
    with book.entered(chain, entry):
        time.sleep(dice.random() * 0.004)
        temporary = program.with_name(f".program.{os.getpid()}")
        temporary.write_bytes(after)
        os.replace(temporary, program)
        time.sleep(dice.random() * 0.004)


def check(directory: Path) -> int:
    """Assert that nothing is lost or doubled; the number of parts."""
    with journal.held(directory / "series.journal") as book:
        chain = book.chain(CHAIN.first)
    program = (directory / "program.nc").read_bytes()
    entries = chain.entries if chain else ()
    assert not any(entry.pending for entry in entries)
    assert [entry.part for entry in entries] == list(range(1, len(entries) + 1))
    # Numbers are given in the order of the parts, so that a lost or doubled one shows.
    assert [entry.measurements[0][1] for entry in entries] == [fingerprint(n) for n in range(len(entries))]
    assert [float(entry.deviation[0]) for entry in entries] == list(range(len(entries)))
    applied = "".join(f"({fingerprint(n)})\n" for n in range(len(entries)) if corrects(n))
    assert program == FIRST + applied.encode()
    last = hashlib.sha256(FIRST).hexdigest()
    for entry in entries:
        assert entry.before[1] == last
        last = entry.after[1]
    assert last == hashlib.sha256(program).hexdigest()
    acknowledged = [int(n) for file in directory.glob("acknowledged-*") for n in file.read_text().split("\n")[:-1]]
    assert len(set(acknowledged)) == len(acknowledged)
    assert set(acknowledged) <= set(range(len(entries)))
    return len(entries)


def run(directory: Path, runs: int, seed: int, *, fresh: int = 20) -> Counter[str]:
    """Start two writers, kill them at a random moment, check; `fresh` runs go on with one journal.

    Returns
    -------
    Counter
        Of what the kills met: how many runs, parts, entries left pending, and what became of those.
    """
    # Forked where that can be: a process is at work in milliseconds and dies like any other.
    method = "fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn"
    processes = multiprocessing.get_context(method)
    dice, met = random.Random(seed), Counter({"runs": 0})
    for number in range(runs):
        place = directory / f"journal-{number // fresh}"
        if number % fresh == 0:
            place.mkdir(parents=True)
            (place / "program.nc").write_bytes(FIRST)
            parts = 0
        seeds = [seed * 100_000 + 2 * number + k for k in range(2)]
        writers = [processes.Process(target=write, args=(place, own), daemon=True) for own in seeds]
        for writer in writers:
            writer.start()
        try:
            _wait_for_parts([place / f"acknowledged-{own}" for own in seeds], writers)
            time.sleep(dice.random() * 0.05)
            for writer in dice.sample(writers, 2):
                os.kill(writer.pid, signal.SIGKILL)
                # Sometimes the other one goes on and finds what the first has left.
                time.sleep(dice.choice([0.0, 0.03]))
        finally:
            for writer in writers:
                writer.kill()
                writer.join()
        left = [e for chain in journal.read(place / "series.journal") for e in chain.entries if e.pending]
        before, parts = parts, check(place)
        met["runs"] += 1
        met["parts"] += parts - before
        met["pending"] += len(left)
        met["settled as done"] += sum(entry.part <= parts for entry in left)
        met["settled as not written"] += sum(entry.part > parts for entry in left)
    return met


def _wait_for_parts(acknowledged: list[Path], writers: list[BaseProcess]) -> None:
    """Until both writers are at work and a part is acknowledged."""
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline:
        assert all(writer.is_alive() for writer in writers), "a writer has ended by itself"
        if all(file.exists() for file in acknowledged) and any(file.stat().st_size for file in acknowledged):
            return
        time.sleep(0.005)
    raise AssertionError("the writers enter nothing")
