# SPDX-License-Identifier: LGPL-2.1-or-later
"""QIF 2.x and 3.0 results (ISO 23952): measured point features and measured point sets, joined by id.

A point feature is joined with its item and its nominal; whether its location is a ball centre or a contact point
is what its point set says (``Compensated``, ``ProbeRadius``), or in documents of 2.x its MeasurePoint, else what the
profile values stored in the file show: they equal (P - N) . n - r. Features of other kinds only give their point sets,
and only where the file has no point, curve or surface features of its own.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from millcorr.arrays import Bools, Floats, Ints
from millcorr.errors import UsageError, unsaid
from millcorr.messages import message, mm, option, phrase, remedy
from millcorr.readers.measurement import Basis, Measurement

from .names import Names
from .parts import chosen_part
from .qif_document import NO_VECTOR, POINTS, Document, Feature, PointSet, Reference
from .source import MM_PER_INCH, Source, shown
from .xml_events import parse

STATED_TOLERANCE = 1e-6
"""A stored profile value this near, in mm, shows what a location is."""

_CURVES = {"PointDefinedCurve", "PointDefinedSurface", "OtherCurve", "OtherSurface"}

_NAMED = {
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), 1.0),
    **dict.fromkeys(("in", "inch", "inches"), MM_PER_INCH),
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), 1000.0),
    **dict.fromkeys(("cm", "centimeter", "centimeters", "centimetre", "centimetres"), 10.0),
    **dict.fromkeys(("um", "µm", "μm", "micron", "microns", "micrometer", "micrometre"), 1e-3),
}
"""Millimetres in units by the names that files give them."""
_FACTOR_TOLERANCE = 1e-9
"""Of a factor that is printed in full; 39.37 inches to a metre would be 3 um on 1.5 m."""

_CONTACT, _UNKNOWN = 0.0, -1.0
"""Radius of a compensated point, and of one that the file says nothing about; NaN: a centre of unknown radius."""


def recognises(data: bytes) -> bool:
    """Whether the root element of an XML file is QIFDocument."""
    return b"QIFDocument" in data[:16384].replace(b"\x00", b"")


def read(source: Source) -> Measurement:
    """Measured points of a QIF document.

    Parameters
    ----------
    source : Source

    Returns
    -------
    Measurement
        Nominals, normals and stored profile values where the file has them.

    Raises
    ------
    FormatError
        If the XML is not well formed or declares a document type, an id refers to nothing or is there twice, a
        number or a count is wrong, or the file has no points; names the line and the element's id.
    UsageError
        If the caller contradicts the file, or does not say what the file leaves open or which of several parts.
    """
    document = Document(source)
    try:
        parse(source, "QIFDocument", document.root)
        _keep_part(source, document)
        return _Joined(source, document).measurement()
    finally:
        document.forget()


def _keep_part(source: Source, document: Document) -> None:
    """Leave in the document what the part that the caller wants has measured. In place.

    Results follow each other on one part as long as none of their features is one that the part has. Features
    without an item or nominal, and points without a feature, do not show what they are: one result a part has them.
    """
    of_result: list[set[str]] = [set() for _ in document.results]
    counts = [0] * len(of_result)
    for m in document.measured.values():
        if m.result >= 0:
            of_result[m.result].add(m.reference)
            counts[m.result] += 1
    in_features = {of.id for m in document.measured.values() for of in m.sets}
    for s in document.sets.values():
        if s.result >= 0 and s.id not in in_features and not counts[s.result]:
            of_result[s.result].add("")
    parts: list[list[int]] = []
    known: set[str] = set()
    for result, own in enumerate(of_result):
        if not own:
            continue
        if not parts or own & known:
            parts.append([])
            known = set()
        parts[-1].append(result)
        known |= own
    if not parts:
        parts = [[]]
    titles = [
        ", ".join(
            phrase("result {} in line {}", shown(document.results[r][0]), document.results[r][1]) for r in part[:3]
        )
        for part in parts
    ]
    wanted = {-1, *parts[chosen_part(source, titles)]}
    document.measured = {label: m for label, m in document.measured.items() if m.result in wanted}
    document.sets = {label: s for label, s in document.sets.items() if s.result in wanted}


class _Rows(NamedTuple):
    """Points of all sets in mm and their normals, (n, 3), radii as above and lines."""

    points: Floats
    normals: Floats
    radii: Floats
    lines: Ints


class _Joined:
    """Rows of the measurement, joined from a document's records."""

    def __init__(self, source: Source, document: Document) -> None:
        self.source = source
        self.document = document
        self.notes: list[str] = []
        self.inferred = ""
        """What shows whether points are centres where the file does not say so itself."""
        self.factors: dict[str, float] = {}
        self.factor = 1.0

    def _units(self) -> tuple[dict[str, float], float]:
        """Factors to mm of every named unit and of the primary one."""
        for u in self.document.units:
            wanted = _NAMED.get(u.name.casefold())
            if wanted is not None and abs(u.factor * 1000 - wanted) > _FACTOR_TOLERANCE * wanted:
                raise self.source.error(
                    phrase(
                        "the unit named {} has the factor {:g} to metres, not {:g}: one of them is wrong, export the "
                        "file again",
                        shown(u.name),
                        u.factor,
                        wanted / 1000,
                    ),
                    u.line or None,
                )
        factors = {u.name: float(f"{u.factor * 1000:.12g}") for u in self.document.units}
        primary = [u for u in self.document.units if u.primary]
        if len(primary) > 1:
            raise self.source.error(phrase("more than one primary unit of length"))
        if primary:
            return factors, float(f"{primary[0].factor * 1000:.12g}")
        if self.source.units is None:
            raise unsaid(
                phrase("{} names no unit of length", self.source.name),
                remedy("units", "mm"),
                remedy("units", "inch"),
            )
        return factors, MM_PER_INCH if self.source.units == "inch" else 1.0

    def _factor(self, unit: str, line: int) -> float:
        if unit and unit not in self.factors:
            raise self.source.error(phrase("unit {} is not among the file's units", shown(unit)), line)
        return self.factors[unit] if unit else self.factor

    def measurement(self) -> Measurement:
        document, source = self.document, self.source
        features = [m for m in document.measured.values() if m.kind in POINTS]
        sets = self._own_sets(features)
        if not features and not sets:
            raise source.error(phrase("no measured points; {} measured features without any", len(document.measured)))
        self.factors, self.factor = self._units()
        self.rows = self._touches()
        parts: list[tuple[tuple[Floats, ...], Ints, Iterable[str]]] = []
        if features:
            parts.append(self._of_features(features))
        parts += [self._of_set(s, rows) for s, rows in sets]
        points, nominal, normals, radii, stated = (
            _stacked(column) for column in zip(*(p[0] for p in parts), strict=True)
        )
        lines = _stacked([p[1] for p in parts])
        names = Names(name for p in parts for name in p[2])
        without = int(np.isnan(normals).any(axis=1).sum())
        if 0 < without < len(points):
            self.notes.append(phrase("{} of {} points have no normal: normals are not used", without, len(points)))
        known = {"mm": 1.0, "inch": MM_PER_INCH}
        said = next((unit for unit, factor in known.items() if factor == self.factor), None)
        unit = source.unit(said or "mm")
        if said is None:
            self.notes.append(phrase("converted from a unit of {}", mm(self.factor, "g")))
        if not any(u.primary for u in document.units):
            source.bases["unit"] = Basis("said", message(option("units")))
        ball = self._ball(radii)
        if not (radii == _UNKNOWN).any():
            basis = Basis("inferred", self.inferred) if self.inferred else Basis("stated")
            source.bases["points"] = basis
            if (radii > 0).any():
                source.bases["radius"] = basis
        return source.measurement(
            "qif", points, lines, ball_radius=ball, normals=None if without else normals,
            nominal=None if np.isnan(nominal).all() else nominal, stated=None if np.isnan(stated).all() else stated,
            elements=names, notes=self.notes, unit=unit, factor=1.0,
        )  # fmt: skip

    def _touches(self) -> _Rows:
        """Points of all sets in mm, with what their sets say of them."""
        sets, table = self.document.sets.values(), self.document.touches
        factors = np.ones(len(table))
        for s in sets if any(s.unit for s in sets) else ():
            factors[s.first : s.first + s.count] = self._factor(s.unit, s.line) / self.factor
        factors *= self.factor
        # The tables' own memory: of a scan another copy would be as large as the file.
        compensated, radii = np.frombuffer(table.compensated), np.frombuffer(table.radius) * factors
        radii = np.where(compensated > 0, _CONTACT, np.where(np.isnan(compensated), _UNKNOWN, radii))
        points = np.frombuffer(table.points).reshape(-1, 3)
        if (factors != 1.0).any():
            with np.errstate(over="ignore"):
                points = points * factors[:, None]
        normals, lines = np.frombuffer(table.normals).reshape(-1, 3), np.frombuffer(table.lines, dtype=np.int64)
        return _Rows(points, normals, radii, lines)

    def _own_sets(self, features: list[Feature]) -> list[tuple[PointSet, Ints]]:
        """Sets of curve and surface features with the rows wanted of them; all where these and points are absent."""
        document = self.document
        wanted: dict[str, Bools] = {}
        for m in document.measured.values():
            for of in m.sets if m.kind in _CURVES else ():
                if of.id in document.sets:
                    rows = wanted.setdefault(of.id, np.zeros(document.sets[of.id].count, dtype=np.bool_))
                    rows[self._span(of)] = True
        chosen = [(s, s.first + np.flatnonzero(wanted[s.id])) for s in document.sets.values() if s.id in wanted]
        if not chosen and not features:
            return [(s, np.arange(s.first, s.first + s.count)) for s in document.sets.values()]
        used = {of.id for m in features for of in m.sets} | wanted.keys()
        kinds: dict[str, int] = {}
        for m in document.measured.values():
            if m.kind not in POINTS | _CURVES:
                for label in document.sets.keys() & ({of.id for of in m.sets} - used):
                    kinds[m.kind.lower()] = kinds.get(m.kind.lower(), 0) + document.sets[label].count
        if kinds:
            left = ", ".join(phrase("{} of {} features", count, kind) for kind, count in sorted(kinds.items()))
            self.notes.append(phrase("points left out: {}", left))
        return chosen

    def _of_features(self, features: list[Feature]) -> tuple[tuple[Floats, ...], Ints, list[str]]:
        document, rows = self.document, self.rows
        names, wanted, normals = [], [], []
        for m in features:
            if m.location is None:
                raise self.source.error(phrase("measured point {} has no Location", m.id), m.line)
            item, ideal = self._ideal(m)
            names.append((item.name if item is not None else "") or m.id)
            normals.append((ideal.normal if ideal is not None else None) or m.normal or NO_VECTOR)
            wanted.append(m if ideal is None or ideal.location is None else ideal)
        points, nominal = self._places(features), self._places(wanted)
        nominal[[m is w for m, w in zip(features, wanted, strict=True)]] = np.nan
        single = np.array([s.first for s in document.sets.values() if s.count == 1], dtype=np.int64)
        at_point = dict(zip(map(tuple, rows.points[single].tolist()), rows.radii[single].tolist(), strict=True))
        radii = np.array([at_point.get(tuple(p), np.nan) for p in points.tolist()])
        for row in np.flatnonzero(np.isnan(radii)).tolist():
            radii[row] = self._radius(points[row], features[row])
        stated = np.array([document.values.get(m.id, np.nan) for m in features]) * self.factor
        directions = np.array(normals)
        self._decide(radii, points, nominal, directions, stated)
        lines = np.array([m.line for m in features], dtype=np.int64)
        return (points, nominal, directions, radii, stated), lines, names

    def _places(self, features: list[Feature]) -> Floats:
        """Locations in mm, (n, 3)."""
        places: Floats = np.array([m.location for m in features], dtype=np.float64)
        factors: Floats = np.array([self._factor(m.unit, m.line) for m in features])
        places *= factors[:, None]
        return places

    def _span(self, of: Reference) -> slice:
        """Which points of its set a reference means."""
        count = self.document.sets[of.id].count
        last = of.last or count
        if not 1 <= of.first <= last <= count and count:
            raise self.source.error(
                phrase("points {} to {} are wanted of point set {}, which has {}", of.first, last, of.id, count),
                of.line,
            )
        return slice(of.first - 1, last)

    def _ideal(self, m: Feature) -> tuple[Feature | None, Feature | None]:
        document = self.document
        if not m.reference:
            return None, None
        item = document.items.get(m.reference)
        if item is None:
            if m.reference in document.nominals:
                return None, document.nominals[m.reference]
            raise self.source.error(
                phrase(
                    "measured point {} refers to feature item {}, which is not in the file", m.id, shown(m.reference)
                ),
                m.line,
            )
        if not item.reference:
            return item, None
        if item.reference not in document.nominals:
            raise self.source.error(
                phrase(
                    "feature item {} refers to nominal {}, which is not in the file", item.id, shown(item.reference)
                ),
                item.line,
            )
        return item, document.nominals[item.reference]

    def _radius(self, point: Floats, m: Feature) -> float:
        """Radius between a feature's location and the surface by what its point set says of it."""
        document, rows = self.document, self.rows
        of = next((of for of in m.sets if of.id in document.sets), None)
        if of is None or not document.sets[of.id].count:
            return _UNKNOWN
        first = document.sets[of.id].first
        span = self._span(of)
        own = slice(first + span.start, first + span.stop)
        radii = rows.radii[own]
        if (radii == _CONTACT).all():
            return _CONTACT
        with np.errstate(over="ignore", invalid="ignore"):
            away = np.linalg.norm(rows.points[own] - point, axis=1)
        nearest = int(away.argmin())
        if away[nearest] <= 1e-9:
            return float(radii[nearest])
        # The location is the centre moved by the radius: it was compensated after the touch.
        return _CONTACT if len(away) == 1 and abs(away[0] - radii[0]) <= 1e-3 else _UNKNOWN

    def _decide(self, radii: Floats, points: Floats, nominal: Floats, normals: Floats, stated: Floats) -> None:
        """What stored profile values show of locations that no set explains, and of the rest of the file. In place."""
        with np.errstate(over="ignore", invalid="ignore"):
            along = ((points - nominal) * normals).sum(axis=1)
        open_before = radii == _UNKNOWN
        balls = set(self.rows.radii[self.rows.radii > 0].tolist())
        for radius in (_CONTACT, *sorted(balls)):
            shows = (radii == _UNKNOWN) & (np.abs(along - radius - stated) <= STATED_TOLERANCE)
            radii[shows] = radius
        if (radii[open_before] != _UNKNOWN).any():
            self.inferred = phrase("the profile values stored in the file")
        unknown = radii == _UNKNOWN
        kinds = set(radii[~unknown].tolist())
        if unknown.any() and len(kinds) == 1:
            radii[unknown] = kinds.pop()
            self.inferred = phrase("the file's other points")
            self.notes.append(phrase("{} locations are taken for what the file's others are", int(unknown.sum())))
        with np.errstate(invalid="ignore"):
            differ = np.abs(along - np.maximum(radii, 0.0) - stated)
        worst = float(np.nanmax(differ, initial=0.0))
        if worst > 1e-4:
            self.notes.append(phrase("stored profile values differ from (P - N) . n - r by up to {}", mm(worst, ".4f")))

    def _of_set(self, s: PointSet, of: Ints) -> tuple[tuple[Floats, ...], Ints, Iterable[str]]:
        rows, n = self.rows, len(of)
        nothing = np.broadcast_to(np.nan, (n, 3))
        # All points of the only set are not copied.
        which = slice(None) if n == len(rows.lines) else of
        columns = (rows.points[which], nothing, rows.normals[which], rows.radii[which], nothing[:, 0])
        name = s.name
        return columns, rows.lines[which], (f"{name}.{k}" for k in range(1, n + 1))

    def _ball(self, radii: Floats) -> float | Floats:
        """Radius in mm, one for all or one a point, with what the caller says about rows the file leaves open."""
        source = self.source
        unknown, nameless, contact = radii == _UNKNOWN, np.isnan(radii), radii == _CONTACT
        stated = radii[~(unknown | nameless | contact)]
        if source.points == "axis" and not unknown.all():
            source.ball_radius(centres=not contact.all())
        if len(stated) and (contact.any() or unknown.any()) and source.points == "contact":
            raise UsageError(
                phrase(
                    "{} contradicts {}: {} points are ball centres",
                    option("points", "contact"),
                    source.name,
                    len(stated),
                )
            )
        if contact.all():
            return source.ball_radius(centres=False)
        if contact.any() and source.points == "centre" and not unknown.any():
            raise UsageError(
                phrase(
                    "{} contradicts {}: {} are contact points",
                    option("points", "centre"),
                    source.name,
                    int(contact.sum()),
                )
            )
        out = radii.copy()
        if unknown.any():
            out[unknown] = source.ball_radius()
        if nameless.any():
            out[nameless] = source.ball_radius(centres=None if contact.any() else True)
        if len(stated) == len(radii) and np.ptp(stated) <= 1e-9:
            return source.ball_radius(centres=True, radius=float(stated[0]))
        return out


def _stacked(arrays: Sequence[Any]) -> Any:
    """One array below another; a single one as it is."""
    return arrays[0] if len(arrays) == 1 else np.concatenate(arrays)
