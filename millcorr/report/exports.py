# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviations and what was decided about them, for quality departments: Q-DAS, QIF 3.0, and tables with decimal comma.

Coordinates are contact points and lie on the nominal's normal; what was rejected has no deviation and is not exported.
"""

from __future__ import annotations

import datetime
import re
import uuid
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import escape

import numpy as np

from millcorr import __version__
from millcorr.arrays import Bools, Floats
from millcorr.correction.settings import Exports
from millcorr.errors import UsageError
from millcorr.messages import option, phrase
from millcorr.pipeline import Result

FILES = {"dfq": "deviations.dfq", "qif": "deviations.qif", "csv": "deviations-comma.csv"}
"""File of each kind of export."""

_VALID, _NOT_TO_EVALUATE = "0", "255"
"""Attributes of a value in Q-DAS files (K0002)."""

_XML_HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<QIFDocument xmlns="http://qifstandards.org/xsd/qif3" versionQIF="3.0.0" idMax="{last}">
<QPId>{document}</QPId>
<Version><TimeCreated>{time}</TimeCreated></Version>
<Header><Application><Name>millcorr {version}</Name></Application></Header>
<FileUnits><PrimaryUnits>
<AngularUnit><SIUnitName>radian</SIUnitName><UnitName>degree</UnitName>
<UnitConversion><Factor>0.0174532925199433</Factor></UnitConversion></AngularUnit>
<LinearUnit><SIUnitName>meter</SIUnitName><UnitName>mm</UnitName><UnitConversion><Factor>0.001</Factor></UnitConversion>
</LinearUnit></PrimaryUnits></FileUnits>
"""
_NAMESPACE = uuid.UUID("6f0c2b1e-8f35-5f0d-9a43-6b1c2f7e5d10")
"""Of the identifiers of exported documents: the same result has the same."""

_DEFINITION = 1
_PER_POINT = 7
"""Identifiers that one point needs."""


def files_of(exports: Exports) -> tuple[str, ...]:
    """Names of the files of what is exported."""
    return tuple(FILES[kind] for kind in dict.fromkeys(exports.export))


def texts_of(
    exports: Exports, result: Result, table: Iterable[bytes], day: datetime.date
) -> dict[str, Iterable[bytes]]:
    """Pieces of each exported file by its name; `table` is that of deviations.csv.

    Raises
    ------
    UsageError
        If nothing was measured.
    """
    if exports.export and result.request.measurement is None:
        raise UsageError(
            phrase("{} needs measured points: what is predicted is no result of an inspection", option("export"))
        )
    makers = {
        "dfq": lambda: dfq(result, exports.zone, day),
        "qif": lambda: qif(result, exports.zone or 0.0, day),
        "csv": lambda: with_decimal_comma(table),
    }
    return {FILES[kind]: makers[kind]() for kind in dict.fromkeys(exports.export)}


def with_decimal_comma(pieces: Iterable[bytes]) -> Iterator[bytes]:
    """Lines of a table with semicolons between the columns and commas in the numbers; quoted text stays."""
    marks = bytes.maketrans(b",.", b";,")
    for piece in pieces:
        # Text between quotation marks is every second part.
        parts = piece.split(b'"')
        yield b'"'.join(part if k % 2 else part.translate(marks) for k, part in enumerate(parts))


@dataclass(frozen=True, slots=True)
class _Points:
    """Used points: names, contact and nominal points (n, 3), normals (n, 2), deviations, outliers, corrections (n,)."""

    names: Sequence[str]
    contact: Floats
    nominal: Floats
    normal: Floats
    value: Floats
    outlier: Bools
    moved: Floats

    @classmethod
    def of(cls, result: Result) -> _Points:
        d, measurement = result.deviation, result.request.measurement
        assert measurement is not None
        elements = measurement.elements
        names = [f"P{row + 1}" if elements is None else _line(elements[row]) for row in d.index.tolist()]
        if len(set(names)) < len(names) or not all(names):
            names = [f"P{row + 1}" for row in d.index.tolist()]
        contact = d.foot + d.value[:, None] * d.normal
        moved = result.correction.at(d.stretch, d.s, result.nominal)
        return cls(
            names, np.column_stack([contact, d.z]), np.column_stack([d.foot, d.z]), d.normal, d.value, result.outlier,
            moved,
        )  # fmt: skip


def dfq(result: Result, zone: float | None, day: datetime.date) -> Iterator[bytes]:
    """Q-DAS file: four characteristics a point, its X, Y, Z and deviation, each with one value.

    Points that the model takes for outliers have attribute 255 (not to be evaluated) and a text that says so.
    """
    points = _Points.of(result)
    n = len(points.value)
    program, measured = Path(result.request.program.name).name, result.request.measurement
    assert measured is not None
    moved = f"largest correction {result.correction.largest:.4f} mm" if result.correction.largest else "no correction"
    head = [
        f"K0100 {4 * n}", "K1000/1 1", f"K1001/1 {_line(program)}", "K1002/1 Profile",
        f"K1900/1 measured: {_line(Path(measured.source).name)}; {len(result.deviation.rejected)} points rejected; "
        f"{np.count_nonzero(points.outlier)} outliers; {moved}",
    ]  # fmt: skip
    yield _cp1252(head)
    limits = [] if zone is None else [(2110, f"{-zone / 2:.6g}"), (2111, f"{zone / 2:.6g}")]
    for row, name in enumerate(points.names):
        lines: list[str] = []
        for axis in range(4):
            number = 4 * row + axis + 1
            nominal = 0.0 if axis == 3 else points.nominal[row, axis]
            fields = [
                (2000, str(number)), (2001, str(number)), (2002, f"{name}.{('X', 'Y', 'Z', 'deviation')[axis]}"),
                (2004, "0"), (2022, "6"), (2101, f"{nominal:.6f}"), *(limits if axis == 3 else []), (2142, "mm"),
            ]  # fmt: skip
            lines += [f"K{key}/{number} {content}" for key, content in fields]
        yield _cp1252(lines)
    date = day.strftime("%d.%m.%Y/00:00:00")
    for row in range(n):
        lines = []
        for axis, value in enumerate((*points.contact[row].tolist(), float(points.value[row]))):
            number = 4 * row + axis + 1
            attribute = _NOT_TO_EVALUATE if points.outlier[row] else _VALID
            lines += [f"K0001/{number} {value:.6f}", f"K0002/{number} {attribute}", f"K0004/{number} {date}"]
            lines += [f"K0009/{number} outlier"] if points.outlier[row] else []
        yield _cp1252(lines)


def qif(result: Result, zone: float, day: datetime.date) -> Iterator[bytes]:
    """QIF 3.0 results: a point feature and a point profile a point, with status, and what was decided as attributes."""
    points = _Points.of(result)
    n = len(points.names)
    ids = _DEFINITION + 1 + _PER_POINT * np.arange(n)
    results = int(_DEFINITION + 1 + _PER_POINT * n)
    measured = result.request.measurement
    assert measured is not None
    origin = f"{measured.digest} {result.request.program.digest} {zone!r} {result.correction.largest!r} {day}"
    yield _XML_HEAD.format(
        last=results + 1, document=uuid.uuid5(_NAMESPACE, origin), time=f"{day}T00:00:00", version=__version__
    ).encode()
    plain = f'<PointFeatureDefinition id="{_DEFINITION}"/>'
    yield f'<Features><FeatureDefinitions n="1">{plain}</FeatureDefinitions>\n<FeatureNominals n="{n}">\n'.encode()
    for id, nominal, normal in zip(ids.tolist(), points.nominal.tolist(), points.normal.tolist(), strict=True):
        yield (
            f'<PointFeatureNominal id="{id}"><FeatureDefinitionId>{_DEFINITION}</FeatureDefinitionId>'
            f"<Location>{_vector(nominal)}</Location><Normal>{_vector((*normal, 0.0), 9)}</Normal>"
            "</PointFeatureNominal>\n"
        ).encode()
    yield f'</FeatureNominals><FeatureItems n="{n}">\n'.encode()
    checked = "<DeterminationMode><Checked><CheckDetails><Measured/></CheckDetails></Checked></DeterminationMode>"
    for id, name in zip(ids.tolist(), points.names, strict=True):
        yield (
            f'<PointFeatureItem id="{id + 1}"><FeatureNominalId>{id}</FeatureNominalId>'
            f"<FeatureName>{escape(name)}</FeatureName>{checked}</PointFeatureItem>\n"
        ).encode()
    yield f'</FeatureItems></Features>\n<Characteristics><CharacteristicDefinitions n="{n}">\n'.encode()
    # One definition a point: a characteristic's definition, nominal and item go together.
    for id in (ids + 3).tolist():
        yield (
            f'<PointProfileCharacteristicDefinition id="{id}"><ToleranceValue>{zone:.9g}</ToleranceValue>'
            "</PointProfileCharacteristicDefinition>\n"
        ).encode()
    yield f'</CharacteristicDefinitions><CharacteristicNominals n="{n}">\n'.encode()
    for id in (ids + 4).tolist():
        yield (
            f'<PointProfileCharacteristicNominal id="{id}"><CharacteristicDefinitionId>{id - 1}'
            "</CharacteristicDefinitionId></PointProfileCharacteristicNominal>\n"
        ).encode()
    yield f'</CharacteristicNominals><CharacteristicItems n="{n}">\n'.encode()
    for id, name in zip((ids + 5).tolist(), points.names, strict=True):
        yield (
            f'<PointProfileCharacteristicItem id="{id}"><Name>{escape(name)}</Name><FeatureItemIds n="1">'
            f"<Id>{id - 4}</Id></FeatureItemIds><CharacteristicNominalId>{id - 1}</CharacteristicNominalId>"
            "</PointProfileCharacteristicItem>\n"
        ).encode()
    yield (
        f'</CharacteristicItems></Characteristics>\n<Results><MeasurementResultsSet n="1">'
        f'<MeasurementResults id="{results}">'
        f"<ThisResultsInstanceQPId>{uuid.uuid5(_NAMESPACE, 'results ' + origin)}</ThisResultsInstanceQPId>"
        f'<MeasuredFeatures n="{n}">\n'
    ).encode()
    for id, contact in zip(ids.tolist(), points.contact.tolist(), strict=True):
        yield (
            f'<PointFeatureMeasurement id="{id + 2}"><FeatureItemId>{id + 1}</FeatureItemId>'
            f"<Location>{_vector(contact)}</Location></PointFeatureMeasurement>\n"
        ).encode()
    yield f'</MeasuredFeatures><MeasuredCharacteristics><CharacteristicMeasurements n="{n}">\n'.encode()
    columns = (ids.tolist(), points.value.tolist(), points.outlier.tolist(), points.moved.tolist())
    for id, value, outlier, moved in zip(*columns, strict=True):
        status = "INDETERMINATE" if outlier else "PASS" if abs(value) <= zone / 2 else "FAIL"
        decided = (("decision", "outlier" if outlier else "used"), ("correction_mm", f"{moved:.6f}"))
        attributes = "".join(f'<AttributeStr name="{name}" value="{text}"/>' for name, text in decided)
        yield (
            f'<PointProfileCharacteristicMeasurement id="{id + 6}"><Attributes n="2">{attributes}</Attributes>'
            f"<Status><CharacteristicStatusEnum>{status}</CharacteristicStatusEnum></Status>"
            f'<CharacteristicItemId>{id + 5}</CharacteristicItemId><FeatureMeasurementIds n="1"><Id>{id + 2}</Id>'
            f"</FeatureMeasurementIds><Value>{value:.6f}</Value></PointProfileCharacteristicMeasurement>\n"
        ).encode()
    # The whole inspection: an outlier, taken for a touch gone wrong, fails no part and passes none.
    fails = bool((np.abs(points.value[~points.outlier]) > zone / 2).any())
    status = "FAIL" if fails else "UNKNOWN" if points.outlier.any() else "PASS"
    yield (
        "</CharacteristicMeasurements></MeasuredCharacteristics>\n"
        f"<InspectionStatus><InspectionStatusEnum>{status}</InspectionStatusEnum></InspectionStatus>\n"
        "</MeasurementResults></MeasurementResultsSet></Results>\n</QIFDocument>\n"
    ).encode()


def _vector(values: Sequence[float], decimals: int = 6) -> str:
    return " ".join(f"{value:.{decimals}f}" for value in values)


def _line(text: str) -> str:
    """Text of a file in one line without control characters."""
    return " ".join(re.sub(r"[\x00-\x1f\x7f-\x9f\ufffe\uffff\ud800-\udfff]", " ", text).split())[:80]


def _cp1252(lines: Sequence[str]) -> bytes:
    return "".join(f"{line}\r\n" for line in lines).encode("cp1252", "replace")
