# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read damaged measurement files of every format: points or a named error, never anything else.

    python3 tests/fuzz/readers.py [COUNT] [FORMAT ...]

COUNT files a format, 10,000 by default, three quarters with the format's own reader, the rest by content; then
what memory a large file of the format takes, as a multiple of its size.
"""

from __future__ import annotations

import sys
import time
import tracemalloc
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.core import readers_fuzz  # noqa: E402

SEED = 20240229


def main() -> int:
    """Run over the formats; an AssertionError shows the file that ended otherwise than it may."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    for format in sys.argv[2:] or readers_fuzz.installed():
        start = time.perf_counter()
        outcomes = readers_fuzz.run(format, count * 3 // 4, SEED)
        outcomes += readers_fuzz.run(format, count - count * 3 // 4, SEED + 1, by_content=True)
        took = time.perf_counter() - start
        count_of = ", ".join(f"{outcomes[kind]} {kind}" for kind in ("points", "format", "usage"))
        print(f"{format:>12}: {count_of} in {took:.0f} s; memory {memory(format):.1f} times the file", flush=True)
    return 0


def memory(format: str) -> float:
    """Peak of the memory to read large files of a format, beyond the file's own bytes, over its size; the worst."""
    worst = 0.0
    for subject in readers_fuzz.large(format):
        tracemalloc.start()
        assert readers_fuzz.outcome(format, subject.data, subject.options) == "points"
        worst = max(worst, tracemalloc.get_traced_memory()[1] / len(subject.data))
        tracemalloc.stop()
    return worst


if __name__ == "__main__":
    sys.exit(main())
