# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kill two writers of one journal at random moments, 200 times: no entry may be lost or doubled.

    python3 tests/fuzz/journal.py [RUNS] [SEED]

An AssertionError shows what the journal and the program disagree about.
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.core import journal_crash  # noqa: E402


def main() -> int:
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as directory:
        met = journal_crash.run(Path(directory), runs, seed)
    print(f"{dict(met)} in {time.perf_counter() - start:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
