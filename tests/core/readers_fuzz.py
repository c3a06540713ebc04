# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damaged measurement files by the thousand: each must end in points or in an error that says what to do."""

from __future__ import annotations

import random
import time
import warnings
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from hashlib import sha256

import numpy as np

from millcorr import readers
from millcorr.errors import FormatError, UsageError
from tests.core import measurement_files as files

NAME = "damaged"
SLOW = 2.0
"""Seconds that no small file may take, however loaded the machine."""


@dataclass(frozen=True)
class Subject:
    """A format, an undamaged file, and what a caller says about it."""

    format: str
    data: bytes
    options: dict[str, object]


def subjects(n: int = 6) -> list[Subject]:
    """Undamaged files of every format with n points, several dresses each."""
    return [Subject(format, *dress) for format, dresses in DRESSES.items() for dress in dresses(n)]


def large(format: str, n: int = 10_000) -> list[Subject]:
    """Undamaged files of a format with n points, several dresses."""
    return [Subject(format, *dress) for dress in DRESSES[format](n)]


def run(format: str, count: int, seed: int = 1, *, by_content: bool = False) -> Counter[str]:
    """Damage files of a format and read them; AssertionError where one ends otherwise than it may.

    With `by_content` the reader is the one that the damaged content leads to, else the format's own.
    """
    generator = random.Random(f"{format} {seed}")
    candidates = [s for s in subjects() if s.format == format]
    outcomes: Counter[str] = Counter()
    for _ in range(count):
        subject = generator.choice(candidates)
        data = files.damaged(subject.data, generator)
        chosen = readers.recognised(data) if by_content else format
        start = time.perf_counter()
        outcomes[outcome(chosen, data, subject.options)] += 1
        assert time.perf_counter() - start < SLOW, data
    return outcomes


def outcome(format: str, data: bytes, options: dict[str, object]) -> str:
    """How reading ends: "points", "format", or "usage" where the damage contradicts what the caller says."""
    source = readers.Source(data, NAME, sha256(data).hexdigest(), **options)  # type: ignore[arg-type]
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            m = readers.FORMATS[format].read(source)
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
    dresses = ({"scan": True}, {}, {"version": 2, "compensated": True, "inch": True}, {"scan": True, "binary": "<f8"})
    return [(files.qif(part, **dress).encode(), {}) for dress in dresses]  # type: ignore[arg-type]


def _xyzijk(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = ({}, {"inch": True, "separator": " "}, {"normals": False}, {"names": True, "separator": "\t"})
    return [(files.xyzijk(part, **dress).encode(), {"points": "contact"}) for dress in dresses]  # type: ignore[arg-type]


def _pcdmis(n: int) -> list[Dress]:
    part = files.ellipse(n)
    dresses = ({}, {"inch": True, "bonus": True}, {"pages": True, "vectors": False}, {"comma": True})
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


DRESSES: dict[str, Callable[[int], list[Dress]]] = {
    "msr": _msr,
    "qif": _qif,
    "xyzijk": _xyzijk,
    "pcdmis": _pcdmis,
    "dmis": _dmis,
    "linuxcnc": _linuxcnc,
    "grbl": _grbl,
    "dprnt": _dprnt,
    "renishaw": _renishaw,
    "qdas": _qdas,
    "text": _text,
}
