# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time and memory to read a million measured points from text, beside what else a user could take; other formats.

Run from the repository root: `python benchmarks/reading.py [lines]`, or `… --formats POINTS [NAME …]` for the formats
that are not plain columns, beside what pandas or lxml take to cut the same file into words. Readers that are not
installed are left out.
The readers take turns, so that other work on the machine hits all alike, and the best round counts. Memory is what
the process's peak grows by while it reads, in a process of its own. Every reader must give the same doubles.
"""

from __future__ import annotations

import base64
import importlib.util
import io
import os
import platform
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np

ROUNDS = 5
ROUNDS_OF_FORMATS = 3


def rows(kind: str, n: int) -> np.ndarray:
    """Points on the order of a part's size, and normals."""
    random = np.random.default_rng(1)
    points = np.round(random.uniform(-300, 300, (n, 3)), 4)
    if kind != "with normals":
        return points
    t = random.uniform(0, 2 * np.pi, n)
    return np.hstack([points, np.round(np.column_stack([np.cos(t), np.sin(t), np.zeros(n)]), 9)])


def file(kind: str, n: int, folder: Path) -> tuple[Path, np.ndarray]:
    """Text file of a kind, and the numbers in it."""
    values = rows(kind, n)
    number = {"as measured": "%.4f", "with normals": "%.9f", "every digit": "%r"}[kind]
    if kind == "every digit":
        values = values / 3.0
    width = values.shape[1]
    line = ",".join([number] * width)
    path = folder / f"{kind.replace(' ', '-')}.csv"
    path.write_text("\n".join([",".join("xyzijk"[:width]), *(line % tuple(row) for row in values.tolist()), ""]))
    return path, values


def with_millcorr(path: Path) -> np.ndarray:
    from millcorr.readers import read

    m = read(path, points="contact")
    return m.points if m.normals is None else np.hstack([m.points, m.normals])


def with_loadtxt(path: Path) -> np.ndarray:
    return np.loadtxt(path, delimiter=",", skiprows=1)


def with_pandas(path: Path) -> np.ndarray:
    import pandas  # type: ignore[import-not-found,import-untyped,unused-ignore]

    return pandas.read_csv(path).to_numpy()


def with_pyarrow(path: Path) -> np.ndarray:
    from pyarrow import csv  # type: ignore[import-not-found,import-untyped,unused-ignore]

    return np.column_stack([column.to_numpy() for column in csv.read_csv(path).columns])


def python_float(path: Path) -> np.ndarray:
    with open(path) as stream:
        next(stream)
        return np.array([[float(field) for field in line.split(",")] for line in stream])


READERS: dict[str, tuple[Callable[[Path], np.ndarray], str]] = {
    "millcorr": (with_millcorr, "numpy"),
    "pyarrow.csv": (with_pyarrow, "pyarrow"),
    "pandas.read_csv": (with_pandas, "pandas"),
    "numpy.loadtxt": (with_loadtxt, "numpy"),
    "float() of each field": (python_float, "numpy"),
}


def peak() -> float:
    """Largest resident memory of this process so far, in MB; NaN where the system does not tell."""
    status = Path("/proc/self/status")
    # getrusage would give the peak of the process that started this one.
    found = re.search(r"VmHWM:\s*(\d+) kB", status.read_text()) if status.exists() else None
    return int(found[1]) / 1024 if found else float("nan")


def memory(name: str, path: Path, small: Path) -> float:
    """MB by which the peak of a process grows while it reads."""
    command = [sys.executable, __file__, "--memory", name, str(path), str(small)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, stdin=subprocess.DEVNULL)
    return float(done.stdout)


def measured_memory(name: str, path: Path, small: Path) -> None:
    reader = READERS[name][0]
    # What a reader imports and keeps is no cost of the file.
    reader(small)
    before = peak()
    reader(path)
    print(peak() - before)


PLAIN = {
    "msr": r"\s+",
    "xyzijk": ",",
    "pcdmis": r"\s+",
    "dmis": ",",
    "linuxcnc": r"\s+",
    "grbl": ",",
    "dprnt": r"\s+",
    "renishaw": r"\s+",
    "qdas": " ",
    "calypso": "\t",
    "text": ",",
    "mapped": ";",
    "height-map": r"\s+",
    "ptx": r"\s+",
}
"""Separator by which pandas takes each text format apart, into words or numbers, knowing nothing of their meaning."""
LONG = 1000
"""Characters of an element in which numbers are parsed, and not only found."""
FIELDS = 40
"""No line of these files has more."""


def plain_parse(format: str, data: bytes) -> None:
    """What a user's own script would begin with: lxml's tree of XML, else pandas' table of the words in all lines."""
    if format == "qif":
        from lxml import etree  # type: ignore[import-not-found,import-untyped,unused-ignore]

        root = etree.fromstring(data)
        # The numbers of a scan are text to an XML library.
        for points in root.iter("{*}Points", "{*}Normals"):
            if len(points.text) > LONG:
                np.array(points.text.split(), dtype=np.float64)
        for points in root.iter("{*}BinaryPoints", "{*}BinaryNormals"):
            np.frombuffer(base64.b64decode(points.text))
        return
    import pandas  # type: ignore[import-not-found,import-untyped,unused-ignore]

    pandas.read_csv(
        io.BytesIO(data), sep=PLAIN[format], header=None, names=range(FIELDS), index_col=False, quoting=3,
        encoding="latin-1", low_memory=False,
    )  # fmt: skip


def other_formats(n: int, only: Sequence[str] = ()) -> None:
    """Processor seconds and memory to read each format's files of n points, each dress, beside a plain parse."""
    from tests.core import readers_fuzz

    print(f"other formats, {n} points: MB of file, processor seconds, of a plain parse; growth of memory in files")
    for format in only or readers_fuzz.installed():
        for number, subject in enumerate(readers_fuzz.large(format, n)):
            package = "lxml" if format == "qif" else "pandas" if format in PLAIN else "no"
            library = np.inf if importlib.util.find_spec(package) else np.nan
            best = np.inf
            for _ in range(ROUNDS_OF_FORMATS):
                begun = time.process_time()
                assert len(readers_fuzz.read(format, subject.data, subject.options)) >= n
                best = min(best, time.process_time() - begun)
                if library == library:
                    begun = time.process_time()
                    plain_parse(format, subject.data)
                    library = min(library, time.process_time() - begun)
            size = len(subject.data) / 1e6
            grown = memory_of_format(format, number, n) * 2**20 / len(subject.data)
            print(
                f"  {format:<10} {number} {size:6.1f} MB {best:7.3f} s {best / library:6.2f} of {library:6.3f} s "
                f"{grown:5.1f} files",
                flush=True,
            )


def memory_of_format(format: str, number: int, n: int) -> float:
    """MB by which the peak of a process grows while it reads one dress of a format."""
    command = [sys.executable, __file__, "--memory-of", format, str(number), str(n)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, stdin=subprocess.DEVNULL)
    return float(done.stdout)


def measured_memory_of(format: str, number: int, n: int) -> None:
    from tests.core import readers_fuzz

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "points")
        # Another process writes the file: what writing takes is not given back and would hide what reading takes.
        if os.fork() == 0:
            path.write_bytes(readers_fuzz.large(format, n)[number].data)
            os._exit(0)
        os.wait()
        small = readers_fuzz.large(format, 100)[number]
        readers_fuzz.read(format, small.data, small.options)
        before = peak()
        readers_fuzz.read(format, path.read_bytes(), small.options)
        print(peak() - before)


def main(n: int) -> None:
    names = [name for name, (_, package) in READERS.items() if importlib.util.find_spec(package)]
    absent = sorted({package for _, package in READERS.values() if not importlib.util.find_spec(package)})
    versions = f"Python {platform.python_version()}, numpy {np.__version__}, {os.cpu_count()} cores"
    print(versions + (f"; not installed: {', '.join(absent)}" if absent else ""))
    with tempfile.TemporaryDirectory() as folder:
        few = Path(folder, "few")
        few.mkdir()
        for kind in ("as measured", "with normals", "every digit"):
            path, values = file(kind, n, Path(folder))
            small, _ = file(kind, 100, few)
            best = dict.fromkeys(names, np.inf)
            error: dict[str, float] = {}
            for _ in range(ROUNDS):
                for name in names:
                    begun = time.perf_counter()
                    found = READERS[name][0](path)
                    best[name] = min(best[name], time.perf_counter() - begun)
                    error[name] = float(np.abs(found[:, :3] - values[:, :3]).max())
            print(f"{kind}: {n} lines, {path.stat().st_size / 1e6:.0f} MB, array {values.nbytes / 1e6:.0f} MB")
            for name in names:
                grown = memory(name, path, small)
                ratio, arrays = best[name] / best["millcorr"], grown * 2**20 / values.nbytes
                print(
                    f"  {name:<22}{best[name]:7.3f} s {ratio:6.2f} of millcorr's {grown:5.0f} MB {arrays:5.1f} arrays"
                    f"   error {error[name]:.0e}"
                )
    other_formats(max(n // 50, 10))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--memory"]:
        measured_memory(sys.argv[2], Path(sys.argv[3]), Path(sys.argv[4]))
    elif sys.argv[1:2] == ["--memory-of"]:
        measured_memory_of(sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
    elif sys.argv[1:2] == ["--formats"]:
        other_formats(int(sys.argv[2]), sys.argv[3:])
    else:
        main(int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000)
