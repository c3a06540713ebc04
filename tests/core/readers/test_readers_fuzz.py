# SPDX-License-Identifier: LGPL-2.1-or-later
"""A few hundred of the damaged files that tests/fuzz/readers.py makes by the ten thousand."""

import time
import tracemalloc

import pytest

from millcorr import readers
from tests.core import readers_fuzz
from tests.core.sweeps import slow


def test_every_format_is_damaged():
    assert readers_fuzz.DRESSES.keys() == readers.FORMATS.keys() | {"mapped"}


@pytest.mark.parametrize("count", [100, slow(300)])
@pytest.mark.parametrize("format", readers_fuzz.DRESSES)
def test_damaged_files_end_in_points_or_an_error(format, count):
    if format in readers_fuzz.LIBRARIES:
        pytest.importorskip(readers_fuzz.LIBRARIES[format])
    outcomes = readers_fuzz.run(format, count, seed=7)
    # Checksums over all of an E57 file find most damage.
    assert outcomes["format"] > count / 10 and (outcomes["points"] > count / 30 or format in ("e57", "x3p"))
    readers_fuzz.run(format, count // 3, seed=8, by_content=True)


@pytest.mark.few(6)
@pytest.mark.parametrize("format", readers_fuzz.installed())
def test_memory_follows_the_file(format):
    for subject in readers_fuzz.large(format, 800):
        tracemalloc.start()
        assert readers_fuzz.outcome(format, subject.data, subject.options) == "points"
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        assert peak < 10 * len(subject.data) + 500_000


@pytest.mark.few(60)
@pytest.mark.parametrize("format", [f for f in readers_fuzz.installed() if f != "text"])
@pytest.mark.parametrize(
    "filling", [" ", "(", "[GC:", "DIM A= B OF ", "X", "9", "-", "<a>", "$", ",", "FA(", "&a;", "\t#"]
)
def test_monotonous_files_end_soon(format, filling):
    subject = next(s for s in readers_fuzz.subjects() if s.format == format)
    begun = time.perf_counter()
    for data in (subject.data + filling.encode() * 200_000, subject.data + (filling + "\n").encode() * 50_000):
        readers_fuzz.outcome(format, data, subject.options)
        readers.recognised(data)
    assert time.perf_counter() - begun < 10


@pytest.mark.parametrize("reader", readers.FORMATS)
def test_no_reader_trips_over_another_format(reader):
    for subject in readers_fuzz.subjects():
        readers_fuzz.outcome(reader, subject.data, {"points": None, "probe_radius": None})
        readers_fuzz.outcome(reader, subject.data, {"points": "contact"})


@pytest.mark.parametrize("subject", readers_fuzz.subjects(), ids=lambda s: s.format)
def test_undamaged_files_are_recognised_and_read(subject):
    assert readers.recognised(subject.data) == {"mapped": "text"}.get(subject.format, subject.format)
    assert readers_fuzz.outcome(subject.format, subject.data, subject.options) == "points"
    if subject.format in readers_fuzz.LIBRARIES or b"\x00" in subject.data:
        return
    # With a mark, as Windows programs save text.
    encoding = "utf-8" if subject.format == "mapped" else "cp1252"
    marked = b"\xef\xbb\xbf" + subject.data.decode(encoding).encode()
    assert readers.recognised(marked) == {"mapped": "text"}.get(subject.format, subject.format)
    assert readers_fuzz.outcome(subject.format, marked, subject.options) == "points"
