# SPDX-License-Identifier: LGPL-2.1-or-later
"""A profile as STEP (ISO 10303-21, AP214): its curves as exact B-splines, for any CAD system."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from datetime import datetime

from millcorr import __version__

from .nurbs import NurbsCurve
from .profile import Profile


def text(profile: Profile, name: str, *, date: datetime | None = None) -> str:
    """STEP file of a profile.

    Parameters
    ----------
    profile : Profile
        In the plane Z0; mm.
    name : str
        Name of the product.
    date : datetime, optional
        For the header; now by default.

    Returns
    -------
    str
        One curve set with every curve, periodic ones cut open at their seam without changing their shape.
    """
    lines: list[str] = []

    def add(entity: str) -> str:
        lines.append(f"#{len(lines) + 1}={entity};")
        return f"#{len(lines)}"

    label = _string(name)
    context = add("APPLICATION_CONTEXT('automotive design')")
    add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{context})")
    product_context = add(f"PRODUCT_CONTEXT('',{context},'mechanical')")
    product = add(f"PRODUCT({label},{label},'',({product_context}))")
    formation = add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
    definition_context = add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{context},'design')")
    definition = add(f"PRODUCT_DEFINITION('design','',{formation},{definition_context})")
    shape = add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    millimetre = add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
    radian = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
    steradian = add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
    accuracy = add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),{millimetre},'distance_accuracy_value','')")
    space = add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" + accuracy + "))"
        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({millimetre},{radian},{steradian}))REPRESENTATION_CONTEXT('',''))"
    )
    curves = []
    for contour in profile.contours:
        for curve in contour.curves:
            poles = [add(f"CARTESIAN_POINT('',({_real(x)},{_real(y)},0.))") for x, y in curve.clamped().poles]
            curves.append(add(_curve(curve.clamped(), poles, curve.periodic)))
    curve_set = add(f"GEOMETRIC_CURVE_SET('',({','.join(curves)}))")
    origin = add("CARTESIAN_POINT('',(0.,0.,0.))")
    up, along = add("DIRECTION('',(0.,0.,1.))"), add("DIRECTION('',(1.,0.,0.))")
    frame = add(f"AXIS2_PLACEMENT_3D('',{origin},{up},{along})")
    representation = add(f"GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION({label},({frame},{curve_set}),{space})")
    add(f"SHAPE_DEFINITION_REPRESENTATION({shape},{representation})")
    stamp = (date or datetime.now()).replace(microsecond=0).isoformat()
    header = [
        "ISO-10303-21;",
        "HEADER;",
        "FILE_DESCRIPTION(('millcorr compensated profile'),'2;1');",
        f"FILE_NAME({label},'{stamp}',(''),(''),'millcorr {__version__}','millcorr','');",
        "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));",
        "ENDSEC;",
        "DATA;",
    ]
    return "\n".join([*header, *lines, "ENDSEC;", "END-ISO-10303-21;", ""])


def _curve(curve: NurbsCurve, poles: Sequence[str], closed: bool) -> str:
    points, flag = ",".join(poles), ".T." if closed else ".F."
    knots = f"({_row(str(m) for m in curve.multiplicities)}),({_row(_real(k) for k in curve.knots)}),.UNSPECIFIED."
    if (curve.weights == curve.weights[0]).all():
        return f"B_SPLINE_CURVE_WITH_KNOTS('',{curve.degree},({points}),.UNSPECIFIED.,{flag},.F.,{knots})"
    return (
        f"(BOUNDED_CURVE()B_SPLINE_CURVE({curve.degree},({points}),.UNSPECIFIED.,{flag},.F.)"
        f"B_SPLINE_CURVE_WITH_KNOTS({knots})CURVE()GEOMETRIC_REPRESENTATION_ITEM()"
        f"RATIONAL_B_SPLINE_CURVE(({_row(_real(w) for w in curve.weights)}))REPRESENTATION_ITEM(''))"
    )


def _row(values: Iterable[str]) -> str:
    return ",".join(values)


def _real(value: float) -> str:
    """A real number as Part 21 wants it: always with a point, exponent with a capital E."""
    number = repr(float(value)).upper()
    if "E" in number:
        mantissa, exponent = number.split("E")
        return f"{mantissa if '.' in mantissa else mantissa + '.'}E{exponent}"
    return number if "." in number else number + "."


def _string(value: str) -> str:
    """A string in Part 21's quotes; what is not plain ASCII in its hexadecimal form."""
    out = "".join(c if " " <= c <= "~" else f"\\X4\\{ord(c):08X}\\X0\\" for c in value.replace("\\", "\\\\"))
    return "'" + out.replace("'", "''") + "'"
