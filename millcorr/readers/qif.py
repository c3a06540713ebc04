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
from .qif_document import POINTS, Document, Features, set_name
from .source import MM_PER_INCH, Source, shown
from .xml_events import parse

STATED_TOLERANCE = 1e-6
"""A stored profile value this near, in mm, shows what a location is."""

_SAME = 1e-9
"""A location this near, in mm, to a touch is the touch."""
_MOVED = 1e-3
"""In mm; distance by which a location misses its touch's radius and still is the touch compensated."""

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
        return _Joined(source, document, _wanted(source, document)).measurement()
    finally:
        document.forget()


def _wanted(source: Source, document: Document) -> frozenset[int]:
    """Results of the part that the caller wants, and -1: what stands in no result belongs to every part.

    Results follow each other on one part as long as none of their features is one that the part has. Features
    without an item or nominal, and points without a feature, do not show what they are: one result a part has them.
    """
    of_result: list[set[str]] = [set() for _ in document.results]
    features, sets = document.measured, document.sets
    for result, reference in zip(features.results, features.references, strict=True):
        if result >= 0:
            of_result[result].add(reference)
    with_features = {result for result in features.results if result >= 0}
    in_features = set(document.references.ids)
    for label, row in sets.rows.items():
        result = sets.results[row]
        if result >= 0 and result not in with_features and label not in in_features:
            of_result[result].add("")
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
    return frozenset((-1, *parts[chosen_part(source, titles)]))


class _Rows(NamedTuple):
    """Points of all sets in mm and their normals, (n, 3), radii as above and lines."""

    points: Floats
    normals: Floats
    radii: Floats
    lines: Ints


class _Joined:
    """Rows of the measurement, joined from a document's records."""

    def __init__(self, source: Source, document: Document, wanted: frozenset[int]) -> None:
        self.source = source
        self.document = document
        kinds, results = document.measured.kinds, document.measured.results
        self.measured = [row for row, result in enumerate(results) if result in wanted]
        """Rows of the features measured on the part."""
        self.features = [row for row in self.measured if kinds[row] in POINTS]
        """Those whose location is the point measured."""
        self.sets = {label: row for label, row in document.sets.rows.items() if document.sets.results[row] in wanted}
        """Rows of the part's point sets, by id."""
        of = document.references
        self.references: dict[int, list[int]] = {}
        """Rows of the references to these sets, by the row of the feature that refers."""
        for row, (feature, label) in enumerate(zip(of.features, of.ids, strict=True)):
            if label in self.sets and results[feature] in wanted:
                self.references.setdefault(feature, []).append(row)
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
        sets = self._own_sets()
        if not self.features and not sets:
            raise source.error(phrase("no measured points; {} measured features without any", len(self.measured)))
        self.factors, self.factor = self._units()
        self.rows = self._touches()
        parts: list[tuple[tuple[Floats, ...], Ints, Iterable[str]]] = []
        if self.features:
            parts.append(self._of_features())
        parts += [self._of_set(label, rows) for label, rows in sets]
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
        sets, table = self.document.sets, self.document.touches
        firsts = np.array(sets.first)
        factors = np.ones(len(table))
        for row in range(len(sets)) if any(sets.units) else ():
            own = slice(sets.first[row], sets.first[row] + sets.counts[row])
            factors[own] = self._factor(sets.units[row], sets.lines[row]) / self.factor
        factors *= self.factor
        # The tables' own memory: of a scan another copy would be as large as the file.
        compensated, radii = np.frombuffer(table.compensated), np.frombuffer(table.radius) * factors
        wrong = np.flatnonzero((radii <= 0) & ~(compensated > 0))
        if len(wrong):
            row = int(np.searchsorted(firsts, wrong[0], side="right")) - 1
            label = next(label for label, place in sets.rows.items() if place == row)
            raise self.source.error(
                phrase("point set {}: its ProbeRadius is not positive", set_name(label)), sets.lines[row]
            )
        radii = np.where(compensated > 0, _CONTACT, np.where(np.isnan(compensated), _UNKNOWN, radii))
        points = np.frombuffer(table.points).reshape(-1, 3)
        if (factors != 1.0).any():
            with np.errstate(over="ignore"):
                points = points * factors[:, None]
        normals, lines = np.frombuffer(table.normals).reshape(-1, 3), np.frombuffer(table.lines, dtype=np.int64)
        return _Rows(points, normals, radii, lines)

    def _own_sets(self) -> list[tuple[str, Ints]]:
        """Sets of curve and surface features with the rows wanted of them; all where these and points are absent."""
        sets, of, kinds = self.document.sets, self.document.references, self.document.measured.kinds
        wanted: dict[str, Bools] = {}
        for feature in self.measured:
            for row in self.references.get(feature, ()) if kinds[feature] in _CURVES else ():
                label = of.ids[row]
                rows = wanted.setdefault(label, np.zeros(sets.counts[self.sets[label]], dtype=np.bool_))
                rows[self._span(row)] = True
        chosen = [(label, sets.first[row] + np.flatnonzero(wanted[label])) for label, row in self.sets.items()
                  if label in wanted]  # fmt: skip
        if not chosen and not self.features:
            return [
                (label, np.arange(sets.first[row], sets.first[row] + sets.counts[row]))
                for label, row in self.sets.items()
            ]
        used = {of.ids[row] for feature in self.features for row in self.references.get(feature, ())} | wanted.keys()
        left: dict[str, int] = {}
        for feature in self.measured:
            kind = kinds[feature].lower()
            if kinds[feature] not in POINTS | _CURVES:
                for label in {of.ids[row] for row in self.references.get(feature, ())} - used:
                    left[kind] = left.get(kind, 0) + sets.counts[self.sets[label]]
        if left:
            told = ", ".join(phrase("{} of {} features", count, kind) for kind, count in sorted(left.items()))
            self.notes.append(phrase("points left out: {}", told))
        return chosen

    def _of_features(self) -> tuple[tuple[Floats, ...], Ints, list[str]]:
        document, features = self.document, self.features
        measured, nominals = document.measured, document.nominals
        ids = list(measured.rows)
        items, ideals = self._ideals(ids)
        names = [
            (document.items.names[item] if item >= 0 else "") or ids[row]
            for row, item in zip(features, items.tolist(), strict=True)
        ]
        points = self._places(measured, np.array(features))
        missing = np.flatnonzero(np.isnan(points[:, 0]))
        if len(missing):
            row = features[missing[0]]
            raise self.source.error(phrase("measured point {} has no Location", ids[row]), measured.lines[row])
        with_ideal = ideals >= 0
        nominal = np.full(points.shape, np.nan)
        nominal[with_ideal] = self._places(nominals, ideals[with_ideal])
        normals = np.array(measured.normals).reshape(-1, 3)[features]
        if with_ideal.any():
            wanted = np.array(nominals.normals).reshape(-1, 3)[ideals]
            said = with_ideal & ~np.isnan(wanted[:, 0])
            normals[said] = wanted[said]
        radii = self._radii(points)
        stated = np.array([document.values.get(ids[row], np.nan) for row in features]) * self.factor
        self._decide(radii, points, nominal, normals, stated)
        return (points, nominal, normals, radii, stated), np.array(measured.lines)[features], names

    def _places(self, table: Features, rows: Ints) -> Floats:
        """Locations in mm, (n, 3)."""
        places: Floats = np.array(table.locations).reshape(-1, 3)[rows]
        if any(table.units):
            factors = [self._factor(table.units[row], table.lines[row]) for row in rows.tolist()]
            places *= np.array(factors)[:, None]
        else:
            places *= self.factor
        return places

    def _span(self, reference: int) -> slice:
        """Which points of its set a reference means."""
        of = self.document.references
        label, first, line = of.ids[reference], of.first[reference], of.lines[reference]
        count = self.document.sets.counts[self.sets[label]]
        last = of.last[reference] or count
        if not 1 <= first <= last <= count and count:
            raise self.source.error(
                phrase("points {} to {} are wanted of point set {}, which has {}", first, last, label, count), line
            )
        return slice(first - 1, last)

    def _ideals(self, ids: list[str]) -> tuple[Ints, Ints]:
        """Rows of the point features' items and nominals; -1 for none."""
        document = self.document
        measured, items, nominals = document.measured, document.items, document.nominals
        found = []
        labels: list[str] = []
        for row in self.features:
            reference = measured.references[row]
            item, ideal = items.rows.get(reference, -1), -1
            if item >= 0:
                wanted = items.references[item]
                ideal = nominals.rows.get(wanted, -1) if wanted else -1
                if wanted and ideal < 0:
                    labels = labels or list(items.rows)
                    raise self.source.error(
                        phrase(
                            "feature item {} refers to nominal {}, which is not in the file",
                            labels[item],
                            shown(wanted),
                        ),
                        items.lines[item],
                    )
            elif reference:
                ideal = nominals.rows.get(reference, -1)
                if ideal < 0:
                    raise self.source.error(
                        phrase(
                            "measured point {} refers to feature item {}, which is not in the file",
                            ids[row],
                            shown(reference),
                        ),
                        measured.lines[row],
                    )
            found.append((item, ideal))
        both = np.array(found, dtype=np.int64)
        return both[:, 0], both[:, 1]

    def _radii(self, points: Floats) -> Floats:
        """Radius between each feature's location and the surface by what its point set says of it, (n,)."""
        sets, touches = self.document.sets, self.rows
        out = np.full(len(points), _UNKNOWN)
        single = np.full(len(points), -1)
        for place, feature in enumerate(self.features):
            reference = next(iter(self.references.get(feature, ())), -1)
            row = self.sets[self.document.references.ids[reference]] if reference >= 0 else -1
            if row < 0 or not sets.counts[row]:
                continue
            span = self._span(reference)
            if span.stop - span.start == 1:
                single[place] = sets.first[row] + span.start
                continue
            own = slice(sets.first[row] + span.start, sets.first[row] + span.stop)
            if (touches.radii[own] == _CONTACT).all():
                out[place] = _CONTACT
                continue
            with np.errstate(over="ignore", invalid="ignore"):
                away = np.linalg.norm(touches.points[own] - points[place], axis=1)
            if away.min() <= _SAME:
                out[place] = touches.radii[own][away.argmin()]
        alone = np.flatnonzero(single >= 0)
        own_radii = touches.radii[single[alone]]
        with np.errstate(over="ignore", invalid="ignore"):
            away = np.linalg.norm(touches.points[single[alone]] - points[alone], axis=1)
            # The location is the centre moved by the radius: it was compensated after the touch.
            moved = np.abs(away - own_radii) <= _MOVED
        out[alone] = np.where((own_radii == _CONTACT) | (away <= _SAME), own_radii, np.where(moved, _CONTACT, _UNKNOWN))
        return out

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

    def _of_set(self, label: str, of: Ints) -> tuple[tuple[Floats, ...], Ints, Iterable[str]]:
        rows, n = self.rows, len(of)
        nothing = np.broadcast_to(np.nan, (n, 3))
        # All points of the only set are not copied.
        which = slice(None) if n == len(rows.lines) else of
        columns = (rows.points[which], nothing, rows.normals[which], rows.radii[which], nothing[:, 0])
        name = set_name(label)
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
