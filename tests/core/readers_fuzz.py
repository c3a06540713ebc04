# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damaged measurement files by the thousand: each must end in points or in an error that says what to do."""

from __future__ import annotations

import importlib.util
import io
import random
import resource
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from hashlib import sha256
from math import isqrt
from pathlib import Path

import numpy as np

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from millcorr.readers import mapped
from millcorr.readers.mapping import TextMapping
from millcorr.readers.measurement import Measurement
from tests.core import measurement_files as files

NAME = "damaged"
SLOW = 2.0
"""Seconds that no small file may take, however loaded the machine."""
GREEDY = 32 << 10
"""Kilobytes by which no small file may make the process grow."""


@dataclass(frozen=True)
class Subject:
    """A format, an undamaged file, and what a caller says about it."""

    format: str
    data: bytes
    options: dict[str, object]


def subjects(n: int = 6) -> list[Subject]:
    """Undamaged files of every format with n points, several dresses each."""
    return [Subject(format, *dress) for format in installed() for dress in DRESSES[format](n)]


def installed() -> list[str]:
    """Formats that can be read here: those of point clouds need their libraries."""
    return [format for format in DRESSES if importlib.util.find_spec(LIBRARIES.get(format, "numpy"))]


def large(format: str, n: int = 10_000) -> list[Subject]:
    """Undamaged files of a format with n points, several dresses."""
    return [Subject(format, *dress) for dress in DRESSES[format](n)]


def run(format: str, count: int, seed: int = 1, *, by_content: bool = False) -> Counter[str]:
    """Damage files of a format and read them; AssertionError where one ends otherwise than it may.

    With `by_content` the reader is the one that the damaged content leads to, else the format's own.
    """
    generator = random.Random(f"{format} {seed}")
    candidates = [Subject(format, *dress) for dress in DRESSES[format](6)]
    outcomes: Counter[str] = Counter()
    for subject in candidates:
        # What a library keeps once it is imported is no cost of a file.
        outcome(format, subject.data, subject.options)
    for _ in range(count):
        subject = generator.choice(candidates)
        data = files.damaged(subject.data, generator)
        chosen = readers.recognised(data) if by_content else format
        start, size = time.perf_counter(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        outcomes[outcome(chosen, data, subject.options)] += 1
        assert time.perf_counter() - start < SLOW, data
        assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - size < GREEDY, data
    return outcomes


def outcome(format: str, data: bytes, options: dict[str, object]) -> str:
    """How reading ends: "points", "format", or "usage" where the damage contradicts what the caller says."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            m = read(format, data, options)
    except FormatError as error:
        assert error.file == NAME and str(error).startswith(NAME), data
        assert "\n" not in str(error) and len(str(error)) < 400, data
        assert error.line is None or error.line >= 1, data
        return "format"
    except UsageError as error:
        assert "\n" not in str(error), data
        return "usage"
    except Exception as error:
        raise AssertionError(f"{format}: {error!r} from {data!r}") from error
    assert len(m) and np.isfinite(m.points).all(), data
    assert m.normals is None or np.allclose(np.linalg.norm(m.normals, axis=1), 1, atol=1e-3), data
    assert m.lines.min() >= 1 and m.ball_radius >= 0, data
    return "points"


def read(format: str, data: bytes, options: dict[str, object]) -> Measurement:
    """Points of a file's bytes, by a mapping where the format is "mapped"."""
    said = {key: value for key, value in options.items() if key != "mapping"}
    source = readers.Source(data, NAME, sha256(data).hexdigest(), **said)  # type: ignore[arg-type]
    if format == "mapped":
        mapping = options.get("mapping", TextMapping({"x": 1, "y": 2}))
        assert isinstance(mapping, TextMapping)
        return mapped.read(source, mapping)
    return readers.FORMATS[format].read(source)


BALL: dict[str, object] = {"probe_radius": 1.5}

Dress = tuple[bytes, dict[str, object]]
"""A file, and what a caller says about it."""


def _msr(n: int) -> list[Dress]:
    part = files.ellipse(n)
    turned = files.msr(
        part, rotations=(np.eye(3),) * 2, angles=((0.0, 0.0, 0.0),) * 2, shifts=((1.0, 2.0, 3.0),) * 2, digits=4
    )
    return [(files.msr(part, dense=dense, digits=4).encode(), {}) for dense in (True, False)] + [(turned.encode(), {})]


def _qif(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = (
        {"scan": True}, {}, {"version": 2, "compensated": True, "inch": True}, {"scan": True, "binary": "<f8"},
        {"version": 2, "listed": True}, {"version": 2, "listed": True, "scan": True},
    )  # fmt: skip
    return [(files.qif(part, **dress).encode(), {}) for dress in dresses]  # type: ignore[arg-type]


def _xyzijk(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = ({}, {"inch": True, "separator": " "}, {"normals": False}, {"names": True, "separator": "\t"})
    return [(files.xyzijk(part, **dress).encode(), {"points": "contact"}) for dress in dresses]  # type: ignore[arg-type]


def _pcdmis(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = (
        {}, {"inch": True, "bonus": True}, {"pages": True, "vectors": False}, {"comma": True},
        {"blanks": True, "between": True},
    )  # fmt: skip
    return [(files.pcdmis(part, **dress).encode("cp1252"), {"points": "contact"}) for dress in dresses]  # type: ignore[arg-type]


def _dmis(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = ({}, {"inch": True, "polar": "ANGDMS"}, {"continued": True}, {"curve": True, "vectors": False})
    return [(files.dmis(part, **dress).encode(), {}) for dress in dresses]  # type: ignore[arg-type]


def _linuxcnc(n: int) -> list[Dress]:
    part = files.ellipse(n)
    return [(files.linuxcnc(part).encode(), {"probe_radius": 1.5}), (files.linuxcnc(part, inch=True).encode(), BALL)]


def _grbl(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = ({"wco": True, "offset": (-100.0, -50.0, 5.0)}, {"stored": True}, {"wco": True, "inch": True, "axes": 4})
    return [(files.grbl(part, **dress).encode(), BALL) for dress in dresses]  # type: ignore[arg-type]


def _dprnt(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = ({}, {"normals": False, "ending": "\r\n"}, {"number": False, "heads": False})
    return [(files.dprnt(part, **dress).encode(), {"points": "contact"}) for dress in dresses]  # type: ignore[arg-type]


def _renishaw(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = ({"others": n < 100}, {"has_z": False, "tight": True, "others": n < 100})
    return [(files.renishaw(part, **dress).encode(), {"points": "contact"}) for dress in dresses]


def _text(n: int) -> list[Dress]:
    rows = np.hstack([files.ellipse(n).contact, files.ellipse(n).normals]).tolist()
    tables = [
        separator.join("xyzijk") + "\n" + "".join(separator.join(f"{v:.5f}" for v in row) + "\n" for row in rows)
        for separator in (",", " ", ";")
    ]
    return [(t.encode(), {"points": "contact"}) for t in tables]


def _qdas(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = ({}, {"lines": True}, {"names": "X_{}", "inch": True}, {"lines": True, "has_z": False})
    return [(files.qdas([part], **dress).encode(), {"points": "centre", "probe_radius": 1.5}) for dress in dresses]  # type: ignore[arg-type]


def _mapped(n: int) -> list[Dress]:
    part, every = files.ellipse(n), "id x y z i j k nominal_x nominal_y nominal_z deviation".split()
    out: list[Dress] = []
    for order, separator, comma, named in (
        (every, "semicolon", True, True), (every, "tab", False, False), (["x", "-", "y", "z"], "comma", False, False)
    ):  # fmt: skip
        content, keys = files.mapped(part, order, separator=separator, comma=comma, named=named, inch=False)
        out.append((content.encode(), {"mapping": TextMapping(**keys)}))  # type: ignore[arg-type]
    return out


def _calypso(n: int) -> list[Dress]:
    part = files.ellipse(n)
    tables = [*(files.calypso(part, has_z=has_z) for has_z in (True, False)), files.calypso_features(part)]
    return [(table.encode(), {"points": "contact"}) for table in tables]


def _height_map(n: int) -> list[Dress]:
    rows = max(2, isqrt(n) // 2)
    heights = np.random.default_rng(n).normal(0.0, 0.05, (rows, n // rows + 1))
    return [(files.bcnc(heights).encode(), {}), (files.open_cnc_pilot(heights).encode(), {})]


def _stl(n: int) -> list[Dress]:
    facets = files.cylinder_mesh(max(n, 3))
    return [(files.stl(facets, binary=binary), {"points": "contact"}) for binary in (False, True)]


def _ptx(n: int) -> list[Dress]:
    part = files.ellipse(n)
    texts = (files.ptx(part), files.pts(part), files.pts(part, colour=False))
    return [(text.encode(), {"points": "contact"}) for text in texts]


def _ply(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = ({"kind": "ascii"}, {"kind": "binary"}, {"kind": "big", "number": "float", "mesh": True})
    return [(files.ply(part, **dress), {"points": "contact"}) for dress in dresses]  # type: ignore[arg-type]


def _pcd(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = ({"kind": "ascii"}, {"kind": "binary"}, {"kind": "binary", "number": "float"})
    return [(files.pcd(part, **dress), {"points": "contact"}) for dress in dresses]


def _e57(n: int) -> list[Dress]:
    with tempfile.TemporaryDirectory() as folder:
        return [(files.e57(files.ellipse(n), Path(folder), scans), {"points": "contact"}) for scans in (1, 2)]


def _x3p(n: int) -> list[Dress]:
    import x3pio

    profile, cloud = io.BytesIO(), io.BytesIO()
    x3pio.write(profile, np.random.default_rng(n).normal(0.0, 1e-5, n), x_scale=1e-6)
    x3pio.write_points(cloud, files.ellipse(n).contact / 1000)
    return [(file.getvalue(), {"points": "contact"}) for file in (profile, cloud)]


DRESSES: dict[str, Callable[[int], list[Dress]]] = {
    "msr": _msr,
    "qif": _qif,
    "xyzijk": _xyzijk,
    "pcdmis": _pcdmis,
    "dmis": _dmis,
    "linuxcnc": _linuxcnc,
    "grbl": _grbl,
    "dprnt": _dprnt,
    "height-map": _height_map,
    "renishaw": _renishaw,
    "qdas": _qdas,
    "calypso": _calypso,
    "text": _text,
    "mapped": _mapped,
    "stl": _stl,
    "ptx": _ptx,
    "ply": _ply,
    "pcd": _pcd,
    "e57": _e57,
    "x3p": _x3p,
}
LIBRARIES = {"ply": "plyfile", "pcd": "pypcd4", "e57": "pye57", "x3p": "x3pio"}
"""What reads these, and writes one of them."""
