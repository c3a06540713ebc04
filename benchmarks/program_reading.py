# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time to read an NC program of a million lines, beside what else a user could take.

Run from the repository root: `python benchmarks/program_reading.py [lines]`. Readers that are not installed
are left out. FreeCAD's own reader runs through `freecadcmd` (or FREECADCMD) if it is on PATH.
"""

from __future__ import annotations

import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np

from millcorr.nc import parse, write


def numbered(n: int, random: np.random.Generator) -> bytes:
    """Contours as most posts write them: N words, codes and both axes on every line."""
    lines = [b"G21 G90 G17", b"G0 X0.000 Y0.000 Z5.000", b"G1 Z-1.000 F300"]
    xy = random.uniform(-100, 100, (n, 2))
    lines += [b"N%d G1 X%.3f Y%.3f" % (10 * i, x, y) for i, (x, y) in enumerate(xy.tolist())]
    return b"\n".join(lines) + b"\n"


def mixed(n: int, random: np.random.Generator) -> bytes:
    """Modal lines, arcs, comments, axes left out."""
    lines = [b"G21 G90 G17", b"G0 X0.000 Y0.000 Z5.000", b"G1 Z-1.000 F300"]
    xy = random.uniform(-100, 100, (n // 4 + 1, 2))
    for x, y in xy.tolist():
        lines += [b"G1 X%.3f Y%.3f" % (x, y), b"G3 X%.3f Y%.3f I5. J0" % (x + 10, y), b"X%.3f" % x, b"Y%.3f (T)" % y]
        lines[-2] = b"G1 X%.3f" % x
    return b"\n".join(lines[: n + 3]) + b"\n"


def line_by_line(data: bytes) -> int:
    """Read words with one regular expression a line, as most small readers do."""
    word = re.compile(r"([A-Z])([-+]?[0-9.]+)")
    rows = []
    for line in data.decode().splitlines():
        rows.append({letter: float(number) for letter, number in word.findall(line.split("(")[0].upper())})
    return len(rows)


def with_gcodeparser(data: bytes) -> int:
    from gcodeparser import GcodeParser  # type: ignore[import-not-found]

    return len(GcodeParser(data.decode()).lines)


def with_pygcode(data: bytes) -> int:
    import pygcode  # type: ignore[import-not-found]

    return sum(1 for line in data.decode().splitlines() if pygcode.Line(line))


def with_freecad(data: bytes) -> float:
    command = os.environ.get("FREECADCMD") or shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    if command is None:
        raise ImportError("freecadcmd is not on PATH")
    with tempfile.TemporaryDirectory() as directory:
        folder = Path(directory)
        (folder / "p.nc").write_bytes(data)
        (folder / "read_with_freecad.py").write_text(
            "import time, Path\n"
            f"text = open({str(folder / 'p.nc')!r}).read()\n"
            "start = time.perf_counter()\n"
            "path = Path.Path()\n"
            "path.setFromGCode(text)\n"
            f"open({str(folder / 'out')!r}, 'w').write('%f %d' % (time.perf_counter() - start, path.Size))\n"
            "import os; os._exit(0)\n"
        )
        subprocess.run([command, str(folder / "read_with_freecad.py")], capture_output=True, timeout=600)
        seconds, size = (folder / "out").read_text().split()
    print(f"    (FreeCAD made {size} commands)")
    return float(seconds)


def timed(what: str, run: Callable[[], object]) -> None:
    start = time.perf_counter()
    try:
        result = run()
    except ImportError as error:
        print(f"  {what:34} not measured: {error}")
        return
    seconds = result if isinstance(result, float) else time.perf_counter() - start
    print(f"  {what:34} {seconds:7.2f} s")


def main() -> None:
    n = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    random = np.random.default_rng(1)
    for name, data in (("numbered lines", numbered(n, random)), ("modal lines, arcs, comments", mixed(n, random))):
        print(f"{name}: {n} lines, {len(data) / 1e6:.0f} MB")
        timed("millcorr", lambda data=data: parse(data))
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        print(f"    (peak memory of this process {peak:.0f} MB)")
        program = parse(data)
        timed("millcorr, written back unchanged", lambda p=program: write(p, p.toolpath.take(slice(None))))
        timed("one regular expression a line", lambda data=data: line_by_line(data))
        timed("gcodeparser", lambda data=data: with_gcodeparser(data))
        timed("pygcode, a tenth of the lines x 10", lambda data=data: tenth(with_pygcode, data))
        timed("FreeCAD Path.setFromGCode", lambda data=data: with_freecad(data))


def tenth(read: Callable[[bytes], int], data: bytes) -> float:
    cut = data.rfind(b"\n", 0, len(data) // 10)
    start = time.perf_counter()
    read(data[:cut])
    return 10 * (time.perf_counter() - start)


if __name__ == "__main__":
    main()
