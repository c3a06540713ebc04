# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two commands at size, as whole processes with their time and peak memory.

A million measured points checked with a report, and a program of a million lines of which one contour was measured
and is corrected; beside each what a user would have to do in any case: read the points and write them down again with
numpy or pandas, read the program with a regular expression a line.

Run from the repository root: `python benchmarks/large.py [size]`. Rivals that are not installed are left out.
"""

from __future__ import annotations

import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).parents[1]
HALF, CORNER, RADIUS = (60.0, 35.0), 5.0, 5.0
"""Half the sides of a rounded rectangle and its corners' radius, and the cutter's radius, in mm."""

CONTOUR = """\
G0 X-75 Y0 Z5
G1 Z-5 F300
G1 X-65 F800
G1 Y30
G2 X-55 Y40 I10 J0
G1 X55
G2 X65 Y30 I0 J-10
G1 Y-30
G2 X55 Y-40 I-10 J0
G1 X-55
G2 X-65 Y-30 I0 J10
G1 Y0
G1 X-75
G0 Z5
M30
"""


def measured(path: Path, count: int) -> None:
    """Points of the rounded rectangle at random places, with a form error of 20 um and a scatter of 2 um."""
    random = np.random.default_rng(1)
    straight = np.array([2 * (HALF[0] - CORNER), 2 * (HALF[1] - CORNER)] * 2)
    corner = CORNER * np.pi / 2
    begin = np.concatenate([[0.0], np.cumsum(straight + corner)])
    s = np.sort(random.uniform(0, begin[-1], count))
    side = np.searchsorted(begin, s, side="right") - 1
    along = s - begin[side]
    # Anticlockwise from the lower left; each side's corner follows it.
    turn = side * np.pi / 2
    bend = np.maximum(along - straight[side], 0.0) / CORNER
    starts = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * (np.array(HALF) - CORNER)
    tangent = np.column_stack([np.cos(turn), np.sin(turn)])
    normal = np.column_stack([np.sin(turn + bend), -np.cos(turn + bend)])
    deviation = 0.01 + 0.008 * np.sin(6 * np.pi * s / begin[-1]) + 0.004 * np.cos(14 * np.pi * s / begin[-1])
    deviation += random.normal(0, 0.002, count)
    points = starts[side] + np.minimum(along, straight[side])[:, None] * tangent
    points += (CORNER + deviation)[:, None] * normal
    table = np.column_stack([points, np.full(count, -3.0)])
    np.savetxt(path, table, "%.4f", delimiter=",", header="x,y,z", comments="")


def program(path: Path, lines: int) -> None:
    """A wavy surface beside the part in lines of 0.1 mm; the contour comes last."""
    rest = max(lines - 20, 0)
    x = np.arange(1300) / 10 + 100
    rows = []
    for row in range(-(-rest // len(x))):
        # Forth and back.
        along = x if row % 2 == 0 else x[::-1]
        across = -45 + 90 * row * len(x) / max(rest, 1)
        height = 0.5 + 0.3 * np.sin(along / 7) * np.cos(across / 9)
        rows += [f"G1 X{a:.3f} Y{across:.3f} Z{h:.4f}\n" for a, h in zip(along, height, strict=True)]
    path.write_text("G21 G90 G17\nT1 M6\nS8000 M3\nG0 X100 Y-45 Z5\nG1 Z1 F800\n" + "".join(rows[:rest]) + CONTOUR)


def with_numpy(points: Path, out: Path) -> None:
    values = np.loadtxt(points, delimiter=",", skiprows=1)
    np.savetxt(out, values[:, [0, 1, 2, 0, 1, 2, 0, 1, 2, 0]], "%.12g", delimiter=",")


def with_pandas(points: Path, out: Path) -> None:
    import pandas  # type: ignore[import-not-found,import-untyped,unused-ignore]

    pandas.read_csv(points).iloc[:, [0, 1, 2, 0, 1, 2, 0, 1, 2, 0]].to_csv(out, index=False, float_format="%.12g")


def line_by_line(nc: Path, out: Path) -> None:
    word = re.compile(r"([A-Z])([-+]?[0-9.]+)")
    moves = [{letter: float(number) for letter, number in word.findall(line)} for line in nc.read_text().splitlines()]
    out.write_text("\n".join(" ".join(f"{k}{v:.4f}" for k, v in move.items()) for move in moves))


RIVALS = {
    "numpy, ten columns read and written": (with_numpy, "numpy", "points"),
    "pandas, the same": (with_pandas, "pandas", "points"),
    "a regular expression a line, read and written": (line_by_line, "re", "program"),
}


def whole_process(what: str, arguments: list[str]) -> None:
    """Time a process, and print its seconds and the largest memory that it held."""
    begun = time.perf_counter()
    child = subprocess.Popen(
        [sys.executable, *arguments],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        cwd=ROOT,
    )
    assert child.stdout is not None
    said = child.stdout.read()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.perf_counter() - begun
    processor = usage.ru_utime + usage.ru_stime
    print(
        f"  {what:<46}{seconds:7.2f} s {processor:7.2f} s of a processor {usage.ru_maxrss / 1024:6.0f} MB", flush=True
    )
    if child.returncode:
        print(f"    failed: {said.decode(errors='replace').strip()[-300:]}")


def main(size: int) -> None:
    print(f"Python {sys.version.split()[0]}, numpy {np.__version__}, {os.cpu_count()} cores; times of whole processes")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        places = {key: folder / key for key in ("points", "few", "program", "contour")}
        measured(places["points"], size)
        measured(places["few"], 1000)
        program(places["program"], size)
        program(places["contour"], 0)
        reading = ["--points", "contact", "--format", "text", "--tool-diameter", f"{2 * RADIUS:g}"]
        for what, arguments in (
            ("inspect of 1000 points, little but imports", ["inspect", "few", "--points", "contact"]),
            (
                f"check, {size} points, with report",
                ["check", "--program", "contour", "--measured", "points", "--report", "report", *reading],
            ),
            (
                f"correct, {size} lines, 1000 points",
                ["correct", "--program", "program", "--measured", "few", "--output", "out.nc", *reading],
            ),
        ):
            named = [str(folder / a) if a in places or a in ("report", "out.nc") else a for a in arguments]
            whole_process(what, ["-m", "millcorr", *named])
        for what, (_, package, key) in RIVALS.items():
            if importlib.util.find_spec(package) is None:
                print(f"  {what:<46} not installed")
            else:
                whole_process(what, [__file__, "--rival", what, str(places[key]), str(folder / "rival")])


if __name__ == "__main__":
    if sys.argv[1:2] == ["--rival"]:
        RIVALS[sys.argv[2]][0](Path(sys.argv[3]), Path(sys.argv[4]))
    else:
        main(int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000)
