# SPDX-License-Identifier: LGPL-2.1-or-later
"""Give `millcorr check` every file of a directory of real measurement files from elsewhere.

    python3 tests/conformance/run.py DIRECTORY

Formats that millcorr does not read yet, and files that are damaged, must end in exit status 3 with one line on
stderr that names the file, and must leave nothing written.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
PROGRAM = REPOSITORY / "tests" / "data" / "nc" / "freecad-linuxcnc.nc"
INPUT = 3
READINGS = (("--points", "contact"), ("--points", "centre", "--probe-radius", "3"))


def main() -> int:
    """Run over the directory; 0 if every file ended as it must."""
    directory = Path(sys.argv[1])
    files = sorted(p for p in directory.rglob("*") if p.is_file())
    if not files:
        print(f"{directory}: no files")
        return 1
    wrong = 0
    for file in files:
        for reading in READINGS:
            trouble, line = check(file, reading)
            wrong += bool(trouble)
            print(f"{'WRONG' if trouble else 'ok   '} {file.relative_to(directory)} {reading[1]}: {trouble or line}")
    print(f"{len(files)} files, {len(files) * len(READINGS)} readings, {wrong} wrong")
    return 1 if wrong else 0


def check(file: Path, reading: tuple[str, ...]) -> tuple[str, str]:
    """What is wrong with the outcome, else "", and the line said."""
    with tempfile.TemporaryDirectory() as directory:
        here = Path(directory)
        done = subprocess.run(
            [
                sys.executable, "-m", "millcorr", "check", "--program", str(PROGRAM), "--tool-diameter", "10",
                "--measured", str(file.resolve()), *reading, "--report", str(here / "report"),
            ],
            cwd=REPOSITORY, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120, check=False,
        )  # fmt: skip
        written = list(here.iterdir())
    lines = done.stderr.splitlines()
    trouble = [
        f"exit status {done.returncode}" if done.returncode != INPUT else "",
        f"{len(lines)} lines on stderr" if len(lines) != 1 else "",
        "does not name the file" if str(file.resolve()) not in done.stderr else "",
        "a traceback" if "Traceback" in done.stderr else "",
        "something on stdout" if done.stdout else "",
        "something was written" if written else "",
    ]
    return ", ".join(t for t in trouble if t), " ".join(lines)


if __name__ == "__main__":
    sys.exit(main())
