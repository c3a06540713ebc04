# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read every file of a directory of real measurement files that nobody here wrote.

    python3 tests/conformance/run.py DIRECTORY

Each file must be read, or refused with exit status 3 and one line that names it; which of the two is known for
the files in `OUTCOME`. Against a program that has nothing to do with it, `check` must refuse every file: one line,
no traceback, nothing written.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

REPOSITORY = Path(__file__).resolve().parents[2]
PROGRAM = REPOSITORY / "tests" / "data" / "nc" / "freecad-linuxcnc.nc"
DONE, USAGE, INPUT, REFUSED = 0, 2, 3, 4

OUTCOME = {
    "Culture_Agnostic.msr": DONE,
    "G330_Detransformed.msr": DONE,
    "G330_Untransformed.msr": DONE,
    "TwoStartsOK.msr": DONE,
    "Missing_G801_Line.msr": INPUT,
    "Odd_Characters.msr": INPUT,
    "QIF_PTS_SAMPLE_v30.QIF": DONE,
    "QIF_Results_Sample_v30.QIF": DONE,
    "three_parts.dfq": INPUT,
    "INDEX.md": INPUT,
    "LICENSE.md": INPUT,
}
SAME = ("G330_Untransformed.msr", "G330_Detransformed.msr", 1e-4)
"""The same points before and after their G330, and how far their four decimals may be apart in mm."""
DEVIATIONS = {"G330_Untransformed.msr": (81, -0.3248, 0.3623)}
"""Number of points, lowest and highest deviation from the file's own nominals in mm, to four decimals."""
STATED = {"QIF_PTS_SAMPLE_v30.QIF": 4, "QIF_Results_Sample_v30.QIF": 2}
"""Number of profile values stored in the file, each to be met to 1e-9 mm."""


def main() -> int:
    """Run over the directory; 0 if every file ended as it must."""
    directory = Path(sys.argv[1])
    files = sorted(p for p in directory.rglob("*") if p.is_file())
    if not files:
        print(f"{directory}: no files")
        return 1
    wrong = 0
    for file in files:
        for verb, found in (("inspect", inspect(file)), ("check", check(file))):
            trouble, line = found
            wrong += bool(trouble)
            print(f"{'WRONG' if trouble else 'ok   '} {verb:<7} {file.relative_to(directory)}: {trouble or line}")
    named = {file.name: file for file in files}
    troubles = [t for t in (same_points(named), *figures(named)) if t]
    wrong += len(troubles)
    print(f"{len(files)} files, {2 * len(files)} readings, {wrong} wrong" + "".join(f"; {t}" for t in troubles))
    return 1 if wrong else 0


def inspect(file: Path) -> tuple[str, str]:
    """What is wrong with reading a file, else "", and what was said."""
    done = millcorr("inspect", file)
    if done.returncode == DONE:
        trouble = [_unless(not done.stderr, "says something on stderr"), _unless("points" in done.stdout, "no points")]
        said = " ".join(done.stdout.split())[:160]
    else:
        trouble, said = refusal(done, file, (INPUT,)), done.stderr.strip()
    expected = OUTCOME.get(file.name, done.returncode)
    trouble.append(_unless(done.returncode == expected, f"exit status {done.returncode} instead of {expected}"))
    return ", ".join(t for t in trouble if t), said


def check(file: Path) -> tuple[str, str]:
    """What is wrong with checking a foreign program against a file, else "", and what was said."""
    with tempfile.TemporaryDirectory() as directory:
        report = Path(directory) / "report"
        # Where the file says what its points are, saying it again would be wrong.
        known = [] if OUTCOME.get(file.name) == DONE else ["--points", "contact"]
        done = millcorr(
            "check", "--program", PROGRAM, "--tool-diameter", 10, "--measured", file, *known, "--report", report
        )
        written = list(Path(directory).iterdir())
    trouble = refusal(done, file, (USAGE, INPUT, REFUSED)) + [_unless(not written, "something was written")]
    return ", ".join(t for t in trouble if t), done.stderr.strip()


def refusal(done: subprocess.CompletedProcess[str], file: Path, status: tuple[int, ...]) -> list[str]:
    """What is wrong with a refusal."""
    lines = done.stderr.splitlines()
    return [
        _unless(done.returncode in status, f"exit status {done.returncode}"),
        _unless(len(lines) == 1, f"{len(lines)} lines on stderr"),
        _unless(done.returncode != INPUT or file.name in done.stderr or PROGRAM.name in done.stderr, "names no file"),
        _unless("Traceback" not in done.stderr and "internal fault" not in done.stderr, "a fault of millcorr"),
        _unless(not done.stdout, "something on stdout"),
    ]


def same_points(files: dict[str, Path]) -> str:
    """What is wrong with two files that hold the same points, else ""."""
    first, second, apart = SAME
    if first not in files or second not in files:
        return ""
    with tempfile.TemporaryDirectory() as directory:
        tables = []
        for name in (first, second):
            out = Path(directory) / f"{name}.csv"
            done = millcorr("convert", files[name], "--output", out)
            if done.returncode != DONE:
                return f"{name} is not converted: {done.stderr.strip()}"
            rows = [line for line in out.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
            tables.append(np.array([[float(v) for v in row.split(",")] for row in rows[1:]])[:, :3])
    if tables[0].shape != tables[1].shape:
        return f"{first} and {second} differ in their number of points"
    largest = float(np.abs(tables[0] - tables[1]).max())
    return _unless(largest <= apart, f"{first} and {second} are {largest:.5f} mm apart")


def figures(files: dict[str, Path]) -> list[str]:
    """What is wrong with deviations recomputed from the files' own nominals."""
    sys.path.insert(0, str(REPOSITORY))
    from millcorr import readers

    trouble = []
    for name in (DEVIATIONS.keys() | STATED.keys()) & files.keys():
        measurement = readers.read(files[name])
        found = measurement.from_nominal()
        if found is None:
            trouble.append(f"{name} gives no deviations")
        elif name in DEVIATIONS:
            got = (len(found), round(float(found.min()), 4), round(float(found.max()), 4))
            trouble.append(_unless(got == DEVIATIONS[name], f"{name} has {got}, not {DEVIATIONS[name]}"))
        else:
            stated = np.full(len(found), np.nan) if measurement.stated is None else measurement.stated
            there = ~np.isnan(stated)
            trouble.append(_unless(int(there.sum()) == STATED[name], f"{name} has {int(there.sum())} stored values"))
            apart = np.abs(found - stated)[there].max(initial=0.0)
            trouble.append(_unless(apart <= 1e-9, f"{name}: stored values are {apart:.2g} mm off"))
    return trouble


def millcorr(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Run the command line."""
    absolute = [str(a.resolve() if isinstance(a, Path) else a) for a in arguments]
    return subprocess.run(
        [sys.executable, "-m", "millcorr", *absolute],
        cwd=REPOSITORY, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip


def _unless(good: bool, trouble: str) -> str:
    return "" if good else trouble


if __name__ == "__main__":
    sys.exit(main())
