# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writers of measurement files, one a format, from made-up points; and mutations that damage them."""

from __future__ import annotations

import base64
import random
import re
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest


@dataclass(frozen=True)
class Part:
    """Made-up measured part: ball centres, nominal points and normals (n, 3), ball radius, names of the points."""

    centres: np.ndarray
    nominal: np.ndarray
    normals: np.ndarray
    radius: float
    names: tuple[str, ...]

    @property
    def contact(self) -> np.ndarray:
        """What the ball touches: its centre less radius times normal."""
        return self.centres - self.radius * self.normals

    @property
    def deviations(self) -> np.ndarray:
        return ((self.contact - self.nominal) * self.normals).sum(axis=1)


def ellipse(n: int = 12, *, radius: float = 1.5, seed: int = 0, decimals: int | None = 5) -> Part:
    """Points on a slightly wrong ellipse of half axes 30 and 20 at z = -4, touched along its normals."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 2 * np.pi, n, endpoint=False) + 0.1
    nominal = np.column_stack([30 * np.cos(t), 20 * np.sin(t), np.full(n, -4.0)])
    normals = np.column_stack([np.cos(t) / 30, np.sin(t) / 20, np.zeros(n)])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    centres = nominal + (radius + rng.normal(0.03, 0.01, n))[:, None] * normals
    if decimals is not None:
        nominal, centres = np.round(nominal, decimals), np.round(centres, decimals)
    return Part(centres, nominal, normals, radius, tuple(f"P{k}" for k in range(1, n + 1)))


# --- MSR --------------------------------------------------------------------------------------------------


def msr(
    part: Part,
    *,
    rotations: tuple[np.ndarray, ...] = (),
    angles: tuple[tuple[float, float, float], ...] = (),
    shifts: tuple[tuple[float, float, float], ...] = (),
    dense: bool = False,
    digits: int = 9,
    ending: str = "\n",
) -> str:
    """MSR file; with `rotations` R and `shifts` t the points are written as R^T (p - t) after their G330 line."""
    lines = ["START"]
    groups = np.array_split(np.arange(len(part.centres)), max(1, len(rotations)))
    for k, rows in enumerate(groups):
        turn, shift = np.eye(3), np.zeros(3)
        if rotations:
            turn, shift = rotations[k], np.array(shifts[k])
            words = zip("ABCXYZ", (*angles[k], *shifts[k]), strict=True)
            lines.append(f"G330 N{rows[0] if len(rows) else 0} " + " ".join(f"{c}{v:.{digits}f}" for c, v in words))
            lines[-1] += " I0 R0"
        for row in rows:
            p, n, c = (part.nominal[row] - shift) @ turn, part.normals[row] @ turn, (part.centres[row] - shift) @ turn
            for code, letters, numbers, tail in (
                ("G800", "XYZIJK", (*p, *n), ("O0", "U0.01", "L-0.01")),
                ("G801", "XYZR", (*c, part.radius), ()),
            ):
                words = [f"{a}{v:.{digits}f}" for a, v in zip(letters, numbers, strict=True)]
                blank = "" if dense else " "
                lines.append(f"{code}{blank}N{row + 1}{blank}" + blank.join((*words, *tail)))
    return ending.join([*lines, "END", ""])


# --- QIF --------------------------------------------------------------------------------------------------


SET_NINE = '<PointList n="1"><WholePointSetId>9</WholePointSetId></PointList>'


def qif(
    part: Part,
    *,
    version: int = 3,
    scan: bool = False,
    compensated: bool = False,
    sets: bool = True,
    stated: bool = True,
    binary: str = "",
    inch: bool = False,
    prefix: str = "",
    comments: bool = False,
    listed: bool = False,
) -> str:
    """QIF results: point features joined to nominals, or with `scan` one point set of a curve feature.

    With `listed` the touches stand in the features as CheckMate writes them in documents of 2.1, and not in sets.
    """
    scale = 25.4 if inch else 1.0
    where = (part.contact if compensated else part.centres) / scale
    nominal = part.nominal / scale
    n = len(where)
    role = "Measurement" if version == 3 else "Actual"
    remark = "<!-- 1 2 3 -->" if comments else ""

    def vector(v: np.ndarray) -> str:
        return " ".join(f"{x!r}" for x in v.tolist())

    def rows(name: str, values: np.ndarray) -> str:
        if binary:
            coded = base64.b64encode(values.astype(binary).tobytes()).decode()
            size = values.itemsize if binary == "<f8" else 4
            return f'<Binary{name} count="{values.size}" sizeElement="{size}">{coded}</Binary{name}>'
        inner = f"\n{remark}".join(vector(v) for v in values)
        return f"<{name}>{remark}\n{inner}\n</{name}>"

    def point_set(id: int, values: np.ndarray, normals: np.ndarray | None) -> str:
        radius = "" if compensated else f"<ProbeRadius>{part.radius / scale!r}</ProbeRadius>"
        return (
            f'<MeasuredPointSet id="{id}" count="{len(values)}">{rows("Points", values)}'
            + ("" if normals is None else rows("Normals", normals))
            + f"<Compensated>{str(compensated).lower()}</Compensated>{radius}</MeasuredPointSet>\n"
        )

    def touches(id: int, values: np.ndarray, normals: np.ndarray | None) -> str:
        radius = "" if compensated else f"<ProbeRadius>{part.radius / scale!r}</ProbeRadius>"
        told = f"<Compensated>{str(compensated).lower()}</Compensated>{radius}"
        directions = [""] * len(values) if normals is None else [f"<Normal>{vector(v)}</Normal>" for v in normals]
        inner = "".join(
            f'<MeasurePoint id="{id + k}">{remark}<Point>{vector(v)}</Point>{direction}\n{told}</MeasurePoint>\n'
            for k, (v, direction) in enumerate(zip(values, directions, strict=True))
        )
        return f'<PointList n="{len(values)}">{inner}</PointList>'

    ideals = items = measured = clouds = profiles = ""
    if scan:
        measured = (
            f'<PointDefinedCurveFeature{role} id="8"><FeatureItemId>7</FeatureItemId>'
            + (touches(10, where, part.normals) if listed else SET_NINE)
            + f"</PointDefinedCurveFeature{role}>\n"
        )
        clouds = "" if listed else point_set(9, where, part.normals)
    for k in range(0 if scan else n):
        a = 100 + 10 * k
        ideals += (
            f'<PointFeatureNominal id="{a}"><Location>{vector(nominal[k])}</Location>'
            f"<Normal>{vector(part.normals[k])}</Normal></PointFeatureNominal>\n"
        )
        items += (
            f'<PointFeatureItem id="{a + 1}"><FeatureNominalId>{a}</FeatureNominalId>'
            f"<FeatureName>{part.names[k]}</FeatureName></PointFeatureItem>\n"
        )
        points = f'<PointList n="1"><WholePointSetId>{a + 3}</WholePointSetId></PointList>' if sets else ""
        if listed:
            points = touches(a + 3, where[k : k + 1], None)
        measured += (
            f'<PointFeature{role} id="{a + 2}"><FeatureItemId>{a + 1}</FeatureItemId>{points}'
            f"<Location>{vector(where[k])}</Location></PointFeature{role}>\n"
        )
        if sets and not listed:
            clouds += point_set(a + 3, where[k : k + 1], None)
        if stated:
            value = float(((where[k] - nominal[k]) * part.normals[k]).sum())
            value -= 0.0 if compensated else part.radius / scale
            for v in (value, 0.0):
                profiles += (
                    f'<PointProfileCharacteristic{role} id="{a + 4 + (v == 0)}"><CharacteristicItemId>5'
                    f'</CharacteristicItemId><Feature{role}Ids n="1"><Id>{a + 2}</Id></Feature{role}Ids>'
                    f"<Value>{v!r}</Value></PointProfileCharacteristic{role}>\n"
                )
    name, factor = ("inch", 0.0254) if inch else ("mm", 0.001)
    body = f"""<QIFDocument xmlns="http://qifstandards.org/xsd/qif{version}" versionQIF="{version}.0.0" idMax="9999">
<FileUnits><PrimaryUnits><LinearUnit><SIUnitName>meter</SIUnitName><UnitName>{name}</UnitName>
<UnitConversion><Factor>{factor}</Factor></UnitConversion></LinearUnit></PrimaryUnits></FileUnits>
<Features><FeatureNominals>
{ideals}</FeatureNominals><FeatureItems>
{items}</FeatureItems></Features>
<Results><MeasurementResults id="2"><MeasuredFeatures>
{measured}</MeasuredFeatures><MeasuredPointSets>
{clouds}</MeasuredPointSets><MeasuredCharacteristics><Characteristic{role}s>
{profiles}</Characteristic{role}s></MeasuredCharacteristics></MeasurementResults></Results>
</QIFDocument>
"""
    if prefix:
        body = re.sub(r"<(/?)(?=[A-Z])", rf"<\1{prefix}:", body).replace("xmlns=", f"xmlns:{prefix}=")
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + body


# --- PC-DMIS ----------------------------------------------------------------------------------------------


def xyzijk(part: Part, *, inch: bool = False, normals: bool = True, separator: str = ",", names: bool = False) -> str:
    """PC-DMIS XYZ file of the contact points."""
    rows = part.contact / (25.4 if inch else 1.0)
    if normals:
        rows = np.hstack([rows, part.normals])
    lines = ["XYZIJK" if inch else "XYZIJK    METRIC"]
    for name, row in zip(part.names, rows, strict=True):
        lines.append(separator.join([*([name] if names else []), *(f"{v:.9f}" for v in row)]))
    return "\n".join([*lines, ""])


def pcdmis(
    part: Part,
    *,
    inch: bool = False,
    vectors: bool = True,
    bonus: bool = False,
    pages: bool = False,
    comma: bool = False,
    decimals: int = 6,
    blanks: bool = False,
    between: bool = False,
    ends: bool = True,
) -> str:
    """PC-DMIS text report of the contact points, each with X, Y, Z, T and V rows.

    Parameters
    ----------
    blanks : bool
        Names of dimensions hold blanks, as operators number them after the drawing.
    between : bool
        After every point a hole's feature control frame, which has no DIM, and a distance, whose rows are no point's.
    ends : bool
        Dimensions end with a line of their own.
    """
    scale = 25.4 if inch else 1.0
    heads = ["NOMINAL", "+TOL", "-TOL", *(["BONUS"] if bonus else []), "MEAS", "DEV", "OUTTOL"]
    heading = "AX  " + "".join(f"{h:>14}" for h in heads)

    def row(axis: str, nominal: float, measured: float) -> str:
        deviation = round(measured, decimals) - round(nominal, decimals)
        cells = {"NOMINAL": nominal, "+TOL": 0.05, "-TOL": 0.05, "MEAS": measured, "DEV": deviation, "OUTTOL": 0.0}
        shown = "".join(f"{cells[h]:14.{decimals}f}" if h in cells else " " * 14 for h in heads)
        return f"{axis:<4}{shown} ---#---"

    lines = ["PART NAME  : PLATE 12", "REV NUMBER :", "STATS COUNT : 1", ""]
    unit = "IN" if inch else "MM"
    nominals, contacts, deviations = part.nominal / scale, part.contact / scale, part.deviations / scale
    for k, name in enumerate(part.names):
        dimension = f"#{k + 1}A LOC{k + 1}" if blanks else f"LOC{k + 1}"
        lines += [f"DIM {dimension}= LOCATION OF POINT {name}  UNITS={unit}", heading]
        for axis, a, b in zip("XYZ", nominals[k], contacts[k], strict=True):
            lines.append(row(axis, a, b))
            if pages and axis == "Y":
                lines += ["\x0c", f"PART NAME  : PLATE 12        DATE : 29.02.2024    PAGE {k + 2}", "", heading]
        if vectors:
            lines.append(row("T", 0.0, deviations[k]))
            lines.append("V   " + "".join(f"{v:14.9f}" for v in part.normals[k]) + "             -" * 4)
        if ends:
            lines.append(f"END OF DIMENSION {dimension}")
        if between:
            frame = f"#{k + 1}.1 FCFLOC{k + 1}" if k % 2 else f"FCFLOC{k + 1}"
            numbers = f"{9.5:14.{decimals}f}{' ' * 38}{9.6:14.{decimals}f}{0.1:14.{decimals}f}"
            lines += [
                f"{frame} = POSITION OF CIR{k + 1}      FIT TO DATUMS=ON  DEV PERPEN CENTERLINE=ON  UNITS={unit}",
                "AX    NOMINAL       +TOL       -TOL      BONUS       MEAS         DEV     OUTTOL",
                *(f"{axis:<4}{numbers}" for axis in "XYZ"),
                "D1     12.000      0.250      0.250                12.065 CIRCLE CIR8 AT RFS           ",
                "TP        RFS      0.400                 0.000      0.083       0.083      0.000 -#-------",
                f"DIM {dimension}B DIST1= 2D DISTANCE FROM CIRCLE CIR7 TO CIRCLE CIR6 PAR TO   XAXIS  UNITS={unit}",
                heading,
                row("M", 273.0, 273.027),
            ]
    lines += ["DIM D1= LOCATION OF CIRCLE CIR1  UNITS=MM", heading, row("D", 10.0, 10.01), "END OF DIMENSION D1"]
    lines += ["DIM A1= 2D ANGLE FROM LINE L1 TO LINE L2  UNITS=DEG", "Winkel 90°"]
    text = "\n".join([*lines, ""])
    return text.replace(".", ",") if comma else text


# --- STL --------------------------------------------------------------------------------------------------


def cylinder_mesh(n: int, *, radius: float = 20.0, height: float = 8.0) -> np.ndarray:
    """Facets (2n, 3, 3) of a cylinder's wall, corners anticlockwise seen from outside, exact in 32 bits."""
    turns = np.arange(n + 1) % n * 2 * np.pi / n
    low = np.column_stack([radius * np.cos(turns), radius * np.sin(turns), np.zeros(n + 1)]).astype(np.float32)
    high = low + np.array([0.0, 0.0, height], dtype=np.float32)
    return np.concatenate(
        [[[low[k], low[k + 1], high[k + 1]], [low[k], high[k + 1], high[k]]] for k in range(n)]
    ).astype(np.float64)


def stl(facets: np.ndarray, *, binary: bool = True) -> bytes:
    """STL file by hand; the normals in it are left blank, as many programs do."""
    if binary:
        body = b"".join(struct.pack("<12fH", 0, 0, 0, *facet.ravel(), 0) for facet in facets)
        return b"solid of a scanner, binary".ljust(80) + struct.pack("<I", len(facets)) + body
    lines = ["solid wall 1"]
    for facet in facets:
        lines += ["  facet normal 0.0 0.0 0.0", "    outer loop"]
        lines += [f"      vertex {x!r} {y!r} {z!r}" for x, y, z in facet.tolist()]
        lines += ["    endloop", "  endfacet"]
    return "\n".join([*lines, "endsolid wall 1", ""]).encode()


# --- PTS and PTX ------------------------------------------------------------------------------------------


def pts(part: Part, *, colour: bool = True) -> str:
    """PTS file of the contact points with intensities and colours."""
    tail = " -1023 128 0 255" if colour else ""
    rows = [" ".join(f"{v:.6f}" for v in p) + tail for p in part.contact]
    return "\r\n".join([str(len(rows)), *rows, ""])


def ptx(part: Part, *, turn: float = 0.5, shift: tuple[float, float, float] = (3.0, -2.0, 1.0), missed: int = 1) -> str:
    """PTX scan of the contact points from a scanner that was turned about Z and shifted; a ray a point met nothing."""
    c, s = np.cos(turn), np.sin(turn)
    # The scanner's axes as rows: registered = (x, y, z) R + shift.
    rotation = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    seen = (part.contact - shift) @ rotation.T
    place = " ".join(f"{v:.9f}" for v in shift)
    axes = [" ".join(f"{v:.12f}" for v in row) for row in rotation]
    head = [str(1 + missed), str(len(seen)), place, *axes, *(f"{row} 0" for row in axes), f"{place} 1"]
    rows = [" ".join(f"{v:.9f}" for v in p) + " 0.25" + "\n0 0 0 0.5" * missed for p in seen]
    return "\n".join([*head, *rows, ""])


# --- Calypso ----------------------------------------------------------------------------------------------

CALYPSO = (
    "planid partnb id type idsymbol actual nominal uppertol lowertol deviation exceed warningLimitCF featureid "
    "featuresigma comment link linkmode mmc useruppertol userlowertol fftphi fftphiunit zoneroundnessangle groupname "
    "groupname2 datumAid datumBid datumCid natuppertolid natlowertolid decimalplaces featurePosX featurePosY "
    "featurePosZ unit group1 group2 group3"
).split()


def calypso(part: Part, *, inch: bool = False, has_z: bool = True, number: int = 815, others: bool = True) -> str:
    """Calypso's table of characteristics of the contact points, and a bore behind every third; rows end early."""
    scale = 25.4 if inch else 1.0
    rows = ["\t".join(CALYPSO) + "\t"]

    def row(name: str, kind: str, nominal: float, actual: float) -> str:
        a, b = round(actual / scale, 7), round(nominal / scale, 7)
        cells = {
            "planid": "00469-Gate", "partnb": str(number), "id": f"{name}_{kind[0]}", "type": f"{kind[0].upper()}1",
            "idsymbol": kind, "actual": f"{a:.7f}", "nominal": f"{b:.7f}", "uppertol": "0.0050000",
            "lowertol": "-0.0050000", "deviation": f"{a - b:.7f}", "warningLimitCF": "100.0000000", "featureid": name,
            "featuresigma": "0.0000000", "unit": "inch" if inch else "mm", "group1": "Gate",
        }  # fmt: skip
        return "\t".join(cells.get(column, "") for column in CALYPSO).rstrip("\t")

    for k, (name, n, p) in enumerate(zip(part.names, part.nominal, part.contact, strict=True)):
        kinds = ["xValue", "yValue", *(["zValue"] if has_z else [])]
        rows += [row(name, kind, n[c], p[c]) for c, kind in enumerate(kinds)]
        if others and k % 3 == 0:
            bore = (("xValue", 40.0), ("yValue", 20.0), ("diameter", 16.0))
            rows += [row(f"Bore_{k}", kind, v, v + 0.01) for kind, v in bore]
    return "\r\n".join([*rows, "END", ""])


def calypso_features(part: Part, *, number: int = 815, normals: bool = True, others: bool = True) -> str:
    """Calypso's table of features of the contact points in mm, and a circle behind every third."""
    head = "planid partnb id type idsymbol group comment link x y z nx ny nz diameter".split()
    head += ["alignment", "x_nom", "y_nom", "z_nom"]
    rows = ["\t".join(head) + "\t"]
    for k, name in enumerate(part.names):
        vectors = (part.contact[k], part.normals[k] if normals else np.zeros(3), part.nominal[k])
        p, n, q = ([f"{v:.7f}" for v in vector] for vector in vectors)
        kind = "SpacePoint" if k % 2 else "Point"
        rows.append("\t".join(["00469-Gate", str(number), name, "Punkt", kind, "", "", "", *p, *n, "", "Base", *q]))
        if others and k % 3 == 0:
            rows.append(
                "\t".join(["00469-Gate", str(number), f"Bore_{k}", "Kreis", "Circle", "", "", "", *p, *n, "16.0"])
            )
    return "\r\n".join([*rows, "END", ""])


# --- DMIS -------------------------------------------------------------------------------------------------


def dmis(
    part: Part,
    *,
    inch: bool = False,
    polar: str = "",
    curve: bool = False,
    continued: bool = False,
    prcomp: str = "ON",
    vectors: bool = True,
) -> str:
    """DMIS output of contact points, or of centres with `prcomp` OFF; `polar` names the unit of angles."""
    scale = 25.4 if inch else 1.0
    lines = ["DMISMN/'PART 12',05.2", "$$ made by hand", f"UNITS/{'INCH' if inch else 'MM'},{polar or 'ANGDEC'}"]
    if prcomp:
        lines.append(f"PRCOMP/{prcomp}")
    where = part.centres if prcomp == "OFF" else part.contact

    def angle(a: float) -> str:
        degrees = np.degrees(a)
        if polar == "ANGRAD":
            return f"{a:.15f}"
        if polar == "ANGDMS":
            minutes = abs(degrees) * 60
            sign = "-" if degrees < 0 else ""
            return f"{sign}{int(minutes // 60)}:{int(minutes % 60)}:{minutes % 1 * 60:.12f}"
        return f"{degrees:.13f}"

    def place(p: np.ndarray, n: np.ndarray) -> str:
        x, y, z = p / scale
        first = f"POL,{np.hypot(x, y):.12f},{angle(np.arctan2(y, x))}" if polar else f"CART,{x:.12f},{y:.12f}"
        behind = "".join(f",{v:.12f}" for v in n) if vectors else ""
        text = f"{first},{z:.12f}{behind}"
        return text.replace(",", ",$\n    ", 2) if continued else text

    for role, points in (("F", part.nominal), ("FA", where)):
        if curve:
            lines.append(f"{role}(CURVE)=FEAT/GCURVE,CART")
            lines += [f"PTDATA/{place(p, n)}" for p, n in zip(points, part.normals, strict=True)]
            continue
        for name, p, n in zip(part.names, points, part.normals, strict=True):
            lines.append(f"{role}({name})=FEAT/POINT,{place(p, n)}  $$ {name}")
    lines += ["FA(C1)=FEAT/CIRCLE,INNER,CART,0,0,0,0,0,1,10.003", "TA(T1)=TOL/PROFP,0.1", "ENDFIL", ""]
    return "\n".join(lines)


# --- probe logs of controls -------------------------------------------------------------------------------


def linuxcnc(part: Part, *, inch: bool = False, others: tuple[float, ...] = (0.0,) * 6) -> str:
    """LinuxCNC probe log of the ball centres."""
    rows = part.centres / (25.4 if inch else 1.0)
    return "".join(" ".join(f"{v:.6f}" for v in (*row, *others)) + "\n" for row in rows)


def grbl(
    part: Part, *, offset: tuple[float, float, float] = (0.0, 0.0, 0.0), wco: bool = False, stored: bool = False,
    inch: bool = False, axes: int = 3,
) -> str:  # fmt: skip
    """GRBL log of the ball centres, in the machine frame."""
    scale = 25.4 if inch else 1.0
    lines = ["Grbl 1.1h ['$' for help]", ">>> $X", "[MSG:Caution: Unlocked]", "ok", "[GC:G0 G55 G17 G21 G90 M5 F0]"]
    if inch:
        lines.append("$13=1")
    o = np.array(offset) / scale
    if wco:
        lines.append(f"<Idle|MPos:0.000,0.000,0.000|FS:0,0|WCO:{o[0]:.4f},{o[1]:.4f},{o[2]:.4f}>")
    if stored:
        # 2 mm of G92 and 3 mm of tool length belong to the offset.
        lines += ["[G54:9.000,9.000,9.000]", f"[G55:{o[0]:.4f},{o[1] - 2:.4f},{o[2] - 3:.4f}]"]
        lines += ["[G92:0.000,2.000,0.000]", "[TLO:3.000]", "[PRB:0.000,0.000,0.000:0]"]
    for k, centre in enumerate(part.centres / scale + o):
        values = [*centre, *([0.0] * (axes - 3))]
        lines += [f"{k:02d}:15:33 [PRB:" + ",".join(f"{v:.6f}" for v in values) + ":1]", "ok"]
    return "\r\n".join([*lines, ""])


def bcnc(heights: np.ndarray, corners: tuple[float, ...] = (0.0, -5.0, 30.0, 20.0)) -> str:
    """Height map, (rows in Y, columns in X), as bCNC saves it: %g, an empty line after every row of the grid."""
    left, low, right, high = corners
    rows, columns = heights.shape
    lines = [f"{left:g} {right:g} {columns}", f"{low:g} {high:g} {rows}", "-10 3 10", "", ""]
    for y, row in zip(np.linspace(low, high, rows), heights, strict=True):
        lines += [f"{x:g} {y:g} {z:g}" for x, z in zip(np.linspace(left, right, columns), row, strict=True)] + [""]
    return "\n".join(lines)


def open_cnc_pilot(heights: np.ndarray, corners: tuple[float, ...] = (0.0, -5.0, 30.0, 20.0)) -> str:
    """Height map, (rows in Y, columns in X), as OpenCNCPilot saves it."""
    (left, low, right, high), (rows, columns) = corners, heights.shape
    points = "".join(
        f'  <point X="{i}" Y="{j}">{heights[j, i]:.4f}</point>\r\n' for i in range(columns) for j in range(rows)
    )
    return (
        '<?xml version="1.0" encoding="utf-8"?>\r\n'
        f'<heightmap MinX="{left:g}" MinY="{low:g}" MaxX="{right:g}" MaxY="{high:g}" SizeX="{columns}" SizeY="{rows}">'
        f"\r\n{points}</heightmap>"
    )


def dprnt(part: Part, *, normals: bool = True, number: bool = True, ending: str = "\r", heads: bool = True) -> str:
    """Contact points as a macro prints them, letters padded."""
    lines = ["%", "POPEN", "PROBE RESULTS PART 12"] if heads else []
    for k, (p, n) in enumerate(zip(part.contact, part.normals, strict=True), 1):
        words = [*([f"N{k}"] if number else []), *(f"{c}{v:10.4f}" for c, v in zip("XYZ", p, strict=True))]
        if normals:
            words += [f"{c}{v:8.5f}" for c, v in zip("IJK", n, strict=True)]
        lines.append("".join(words))
    return "\x12" + ending.join([*lines, *(["%"] if heads else []), ""]) + "\x14"


def mixed_results(part: Part, *, inspected: bool = True, measured: bool = True) -> str:
    """Results as Fusion's generator writes them: points of an inspection, then features of probing cycles."""
    rule = "-" * 67
    lines = ["START", "RESULTSFILE PLATE-RESULTS", "DOCUMENTID 6f1c", "MODELVERSION 3", "TIMESTAMP 251120 101502", ""]
    number = 0
    if inspected:
        lines += ["TOOLPATHID 742.01001", "TOOLPATH INSPECT SURFACE1", "G331 N1 A0. B0. C0. X0. Y0. Z0."]
        lines += ["G330 N1 A0. B0. C0. X0 Y0 Z0 I0 R0"]
        for p, q, n in zip(part.nominal, part.centres, part.normals, strict=True):
            number += 1
            normal = " ".join(f"{c}{v:.6f}" for c, v in zip("IJK", n, strict=True))
            lines.append(f"G800 N{number} X{p[0]:.4f} Y{p[1]:.4f} Z{p[2]:.4f} {normal} O0. U0.1 L0.1")
            lines.append(f"G801 N{number} X{q[0]:.4f} Y{q[1]:.4f} Z{q[2]:.4f} R{part.radius:.4f}")
    if measured:
        lines += ["", "TOOLPATHID 744.02001", "TOOLPATH PROBE BORE"]
        for rows in (
            ["SIZE D12.  ACTUAL 12.0412  DEV 0.0412", "POSN X10.  ACTUAL 10.0123  DEV 0.0123",
             "POSN Y20.  ACTUAL 20.2041  TOL TP 0.1  DEV 0.2041", "",
             "          +++++OUT OF POS+++++ ERROR TP 0.1041 RADIAL"],
            ["POSN X-5.  ACTUAL -5.0051  DEV -0.005132"],
            ["ANG 30.  ACTUAL 30.2  TOL 0.1  DEV 0.2", "", "          +++++ANG OUT OF TOL+++++ ERROR 0.1"],
            ["POSN X1.  ACTUAL 1.0101  DEV 0.010073", "POSN Y2.  ACTUAL 1.9899  DEV -0.010127"],
            ["POSN X1.  ACTUAL 1.0101  DEV 0.0101", "POSN Y2.  ACTUAL NaN  DEV NaN"],
        ):  # fmt: skip
            number += 1
            lines += ["CYCLEDEPTH -4.5", rule, f"   COMPONENT NO 1                   FEATURE NO {number}", rule, *rows]
    return "\n".join([*lines, "END", ""])


def renishaw(part: Part, *, has_z: bool = True, tight: bool = False, others: bool = True) -> str:
    """Print-out of inspection cycles with the contact points, and a bore and an axis touch if `others`."""
    rule, gap = "-" * 49, "" if tight else " "

    def row(word: str, axis: str, nominal: float, actual: float) -> str:
        a, b = round(nominal, 4), round(actual, 4)
        return f"{word} {axis}{gap}{a:.4f} ACTUAL {b:.4f} TOL 0.1000 DEV {b - a:.4f}"

    lines = []
    for k, (n, p) in enumerate(zip(part.nominal, part.contact, strict=True), 1):
        lines += [rule, f"COMPONENT NO 12   FEATURE NO {k}", rule]
        lines += [row("POSN", axis, n[c], p[c]) for c, axis in enumerate("XYZ" if has_z else "XY")]
    if others:
        lines += [rule, "COMPONENT NO 12   FEATURE NO 901", rule, row("POSN", "X", 1.0, 1.01)]
        lines += [rule, "COMPONENT NO 12   FEATURE NO 902", rule, row("POSN", "X", 1, 1), row("POSN", "Y", 2, 2.1)]
        lines += [row("SIZE", "D", 10.0, 10.02), "+++OUT OF TOL+++ ERROR 0.0010"]
    return "\r\n".join([*lines, ""])


# --- text by a mapping ------------------------------------------------------------------------------------


def mapped(
    part: Part, order: list[str], *, separator: str, comma: bool, named: bool, inch: bool
) -> tuple[str, dict[str, object]]:
    """Text with these columns in this order, "-" being none of them, and the keys of the mapping for it."""
    scale = 25.4 if inch else 1.0
    numbers: dict[str, np.ndarray] = {"deviation": part.deviations / scale}
    for keys, vectors in (("xyz", part.centres / scale), ("ijk", part.normals)):
        numbers |= dict(zip(keys, vectors.T, strict=True))
    numbers |= {f"nominal_{c}": v / scale for c, v in zip("xyz", part.nominal.T, strict=True)}
    marks = {"comma": ",", "semicolon": ";", "tab": "\t", "blank": "  "}
    between = marks.get(separator, separator)
    lines = ["Messprotokoll"]
    if named:
        lines.append(between.join(f"{key}_Größe" for key in order))
    for row, name in enumerate(part.names):
        texts = {"id": name, "-": "note"} | {key: f"{v[row]:.9f}" for key, v in numbers.items()}
        lines.append(between.join(texts[key].replace(".", ",") if comma else texts[key] for key in order))
    columns = {key: f"{key}_größe" if named else place for place, key in enumerate(order, 1) if key != "-"}
    keys = {
        "columns": columns,
        "separator": separator,
        "decimal": "comma" if comma else "point",
        "skip": 1,
        "units": "inch" if inch else "mm",
        "points": "centre",
        "probe_radius": part.radius,
    }
    return "\n".join([*lines, ""]), keys


# --- Q-DAS ------------------------------------------------------------------------------------------------


def qdas(
    parts: list[Part],
    *,
    lines: bool = False,
    names: str = "{}.X",
    key: int = 2001,
    inch: bool = False,
    has_z: bool = True,
    nominal: bool = True,
    ending: str = "\n",
) -> str:
    """Q-DAS file of one part measured several times; `lines` puts the values in lines, else in K0001 fields."""
    scale = 25.4 if inch else 1.0
    axes = "XYZ" if has_z else "XY"
    part = parts[0]
    rows = ["K0100 " + str(len(axes) * len(part.names) + 1), "K1001/1 4711", "K1002/1 Cam"]
    rows += ["K2001/1 Diameter", "K2101/1 12"]
    places = [(name, axis) for name in range(len(part.names)) for axis in range(len(axes))]
    for index, (name, axis) in enumerate(places, 2):
        title = names.replace("X", axes[axis]).format(part.names[name])
        rows += [f"K{key}/{index} {title}", f"K2142/{index} {'inch' if inch else 'mm'}"]
        if nominal:
            rows.append(f"K2101/{index} {part.nominal[name, axis] / scale:.9f}")
    for measured in parts:
        values = ["12.01", *(f"{measured.centres[name, axis] / scale:.9f}" for name, axis in places)]
        if lines:
            rows.append("\x0f".join(f"{v}\x140\x1429.02.2024/10:31:07" for v in values))
        else:
            for index, v in enumerate(values, 1):
                rows += [f"K0001/{index} {v}", f"K0004/{index} 29.02.2024/10:31:07"]
    return ending.join([*rows, ""])


# --- point clouds -----------------------------------------------------------------------------------------


def ply(part: Part, *, kind: str = "binary", number: str = "double", normals: bool = True, mesh: bool = False) -> bytes:
    """PLY file by hand: ASCII, little endian or big endian."""
    order = {"ascii": "", "binary": "<", "big": ">"}[kind]
    name = {"ascii": "ascii", "binary": "binary_little_endian", "big": "binary_big_endian"}[kind]
    table = np.hstack([part.contact, part.normals]) if normals else part.contact
    columns = ["x", "y", "z", "nx", "ny", "nz"][: table.shape[1]]
    head = ["ply", f"format {name} 1.0", "comment made up", f"element vertex {len(table)}"]
    head += [f"property {number} {c}" for c in columns] + ["property uchar quality"]
    if mesh:
        head += ["element face 1", "property list uchar int vertex_indices"]
    data = ("\n".join([*head, "end_header"]) + "\n").encode()
    code = "d" if number == "double" else "f"
    for row in table.tolist():
        data += (
            (" ".join(map(repr, row)) + " 7\n").encode()
            if not order
            else struct.pack(f"{order}{len(row)}{code}B", *row, 7)
        )
    if mesh:
        data += b"3 0 1 2\n" if not order else struct.pack(f"{order}B3i", 3, 0, 1, 2)
    return data


def pcd(part: Part, *, kind: str = "ascii", number: str = "double") -> bytes:
    """PCD file by hand, ASCII or binary."""
    size, code, text = (8, "d", "F") if number == "double" else (4, "f", "F")
    table = np.hstack([part.contact, part.normals])
    n = len(table)
    head = f"""# .PCD v0.7 - Point Cloud Data file format
VERSION 0.7
FIELDS x y z normal_x normal_y normal_z
SIZE{f" {size}" * 6}
TYPE{f" {text}" * 6}
COUNT{" 1" * 6}
WIDTH {n}
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS {n}
DATA {kind}
""".encode()
    if kind == "ascii":
        return head + "".join(" ".join(map(repr, row)) + "\n" for row in table.tolist()).encode()
    return head + table.astype("<" + code).tobytes()


def e57(part: Part, folder: Path, scans: int = 1) -> bytes:
    """E57 file by its library, which writes 32-bit numbers."""
    path = folder / "made.e57"
    path.unlink(missing_ok=True)
    image = pytest.importorskip("pye57").E57(str(path), mode="w")
    for piece in np.array_split(part.contact / 1000, scans):
        image.write_scan_raw({f"cartesian{c}": np.ascontiguousarray(v) for c, v in zip("XYZ", piece.T, strict=True)})
    image.close()
    return path.read_bytes()


# --- damage -----------------------------------------------------------------------------------------------

_SPICE = (
    b"\x00", b"\xff", b"\xc6", b"\xef\xbb\xbf", b"\r", b"\n", b"\n\n", b"\x1a", b"'", b'"', b"<", b"&", b">", b"$",
    b"nan", b"inf", b"-inf", b"1e999", b"-1e308", b"1e-320", b"9" * 400, b"0x10", b"1_0", b"--1", b"+", b"-", b".",
    b",", b";", b"(", b")", b"[", b"]", b":", b"=", b"/", b"#", b"****", b"1.#QNAN", b"1,5", b"1.2.3", b" ", b"\t",
    b"\xe2\x88\x92", b"\xd9\xa3", b"\xc2\xa0", b"0", b"-0.0", b"18446744073709551616", b"-5", b"END", b"START",
    b"<!DOCTYPE a [<!ENTITY b 'c'>]>", b"&b;", b"<!-- -->", b"<![CDATA[1]]>", b"</Points>", b"INCH", b"MM", b"CART",
)  # fmt: skip


def damaged(data: bytes, random: random.Random) -> bytes:
    """The same file after one to four accidents: bytes and lines changed, lost, doubled, swapped, cut off."""
    for _ in range(random.choice((1, 1, 1, 2, 3, 4))):
        data = random.choice(_ACCIDENTS)(data, random)
    return data


def _place(data: bytes, random: random.Random) -> int:
    return random.randrange(len(data) + 1)


def _flip(data: bytes, random: random.Random) -> bytes:
    at = _place(data, random)
    return data[:at] + bytes([random.randrange(256)]) + data[at + 1 :]


def _spice(data: bytes, random: random.Random) -> bytes:
    at = _place(data, random)
    return data[:at] + random.choice(_SPICE) + data[at + random.choice((0, 0, 1, 5)) :]


def _cut(data: bytes, random: random.Random) -> bytes:
    return data[: _place(data, random)]


def _lose(data: bytes, random: random.Random) -> bytes:
    at = _place(data, random)
    return data[:at] + data[at + random.choice((1, 2, 8, 60, 500)) :]


def _double(data: bytes, random: random.Random) -> bytes:
    at = _place(data, random)
    piece = data[at : at + random.choice((1, 3, 20, 200))]
    return data[:at] + piece * random.choice((2, 2, 3, 50)) + data[at:]


def _lines(data: bytes, random: random.Random) -> bytes:
    lines = data.split(b"\n")
    a, b = random.randrange(len(lines)), random.randrange(len(lines))
    kind = random.randrange(4)
    if kind == 0:
        lines[a], lines[b] = lines[b], lines[a]
    elif kind == 1:
        del lines[a]
    elif kind == 2:
        lines.insert(a, lines[b])
    else:
        lines[a] = lines[a] + lines[b]
    return b"\n".join(lines)


def _number(data: bytes, random: random.Random) -> bytes:
    """Put something else in the place of a digit: most accidents elsewhere end at the first check."""
    places = [k for k, byte in enumerate(data) if 48 <= byte <= 57]
    if not places:
        return data
    at = random.choice(places)
    return (
        data[:at]
        + random.choice((b"e", b"E9", b"", b"-", b".", b"0", b"99999", b" ", b"nan", b"1e400"))
        + data[at + 1 :]
    )


def _word(data: bytes, random: random.Random) -> bytes:
    """Put one word of the file in the place of another, which leaves more of its form intact."""
    words = list(re.finditer(rb"[\w.+-]+", data))
    if not words:
        return data
    at, other = random.choice(words), random.choice(words)
    return data[: at.start()] + other[0] + data[at.end() :]


_ACCIDENTS: tuple[Callable[[bytes, random.Random], bytes], ...] = (
    _flip,
    _spice,
    _cut,
    _lose,
    _double,
    _lines,
    _number,
    _word,
    _word,
)
