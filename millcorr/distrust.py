# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distrust before correction: signs that the measured points do not mean what they seem to mean.

Each finding has a name, a figure, and the option that resolves it. A dangerous one stops the correction; a user
who knows better accepts it by name, and the report records it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .deviation import REACH, Deviation
from .errors import DistrustError, UsageError
from .footpoint import FootPointSearch
from .measurement import Measurement
from .profile import Profile

Floats = NDArray[np.float64]

INCH = 25.4
CONSTANT_OFFSET = 0.2
"""A median deviation beyond this, in mm, with little scatter is no machining error."""

SMALL_SCATTER = 0.15
"""Scatter of an offset, as a share of it, up to which it counts as constant."""

MANY_REJECTED = 0.4
"""A larger share of points that cannot be used means the wrong program, part or frame."""

MISALIGNED = 0.05
"""A shift or turn of the whole part that moves points by more than this, in mm, is dangerous to correct."""

OTHER_NOMINAL = 0.05
"""The file's own nominal points lie at most this far, in mm, from the profile if both mean the same part."""

STATED = 6e-4
"""Deviations that the file states agree with its own points within this, in mm: half a unit of 0.001 and a bit."""

SAMPLE = 2000
"""So many points, evenly chosen, are enough to recognise a wrong unit or frame."""

NAMES = (
    "unit",
    "mirrored",
    "ball-not-compensated",
    "compensated-twice",
    "diameter-for-radius",
    "radius-for-diameter",
    "wrong-side",
    "constant-offset",
    "misalignment",
    "identical-to-nominal",
    "below-the-cut",
    "outliers",
    "other-nominal",
    "stated-deviations",
    "many-rejected",
)


@dataclass(frozen=True, slots=True)
class Finding:
    """Something about a measurement that a user should know before correcting from it.

    Parameters
    ----------
    name : str
        One of `NAMES`; what ``--accept`` takes.
    text : str
        What was seen, with its figure, and what to do.
    dangerous : bool
        True where correcting would probably scrap the part.
    """

    name: str
    text: str
    dangerous: bool


def refuse_dangerous(findings: Iterable[Finding], accepted: Collection[str], source: str) -> tuple[str, ...]:
    """Stop at the first dangerous finding that was not accepted.

    Parameters
    ----------
    findings : iterable of Finding
    accepted : collection of str
        Names the user accepts.
    source : str
        Name of the measured file.

    Returns
    -------
    tuple of str
        Notes for the report: harmless findings, and accepted ones, marked as such.

    Raises
    ------
    UsageError
        If a name to accept does not exist.
    DistrustError
        If a dangerous finding was not accepted.
    """
    unknown = sorted(set(accepted) - set(NAMES))
    if unknown:
        raise UsageError(f"--accept {unknown[0]}: there is no such finding; known are {', '.join(NAMES)}")
    notes = []
    for finding in findings:
        if finding.dangerous and finding.name not in accepted:
            raise DistrustError(f"{source}: {finding.text} (if it is right as it is: --accept {finding.name})")
        notes.append(f"accepted {finding.name}: {finding.text}" if finding.dangerous else finding.text)
    return tuple(notes)


def examine_points(measurement: Measurement, profile: Profile, cutter_radius: float) -> tuple[Finding, ...]:
    """Signs of a wrong unit, frame, side or probe radius, from where the points lie.

    Parameters
    ----------
    measurement : Measurement
    profile : Profile
        Nominal.
    cutter_radius : float
        mm; tells a wrong side.

    Returns
    -------
    tuple of Finding
    """
    search = FootPointSearch(profile)
    step = max(1, len(measurement) // SAMPLE)
    points = measurement.points[::step, :2]
    if not len(points):
        return ()
    own = _against_itself(measurement, search, step)
    ball = measurement.ball_radius
    value = search.find(points).distance - ball
    offset, scatter = _middle(value)
    near = float((np.abs(value) <= REACH).mean())
    if near < 0.9:
        wrong_frame = _wrong_frame(points, search, ball, near)
        if wrong_frame is not None:
            return (wrong_frame, *own)
    if abs(offset) < CONSTANT_OFFSET or scatter > SMALL_SCATTER * abs(offset):
        return own
    return (_constant_offset(offset, scatter, ball, cutter_radius), *own)


def _against_itself(measurement: Measurement, search: FootPointSearch, step: int) -> tuple[Finding, ...]:
    """What the file says twice, compared: its nominal with the profile, its deviations with its points."""
    found = []
    if measurement.nominal is not None:
        nominal = measurement.nominal[::step, :2]
        nominal = nominal[np.isfinite(nominal).all(axis=1)]
        away = float(np.median(np.abs(search.find(nominal).distance))) if len(nominal) else 0.0
        if away > OTHER_NOMINAL:
            text = (
                f"the file's own nominal points lie {away:.3f} mm off the profile: check --nominal, the operation and "
                "the work frame"
            )
            found.append(Finding("other-nominal", text, True))
    recomputed = measurement.from_nominal()
    if recomputed is not None and measurement.stated is not None:
        gap = np.nan_to_num(np.abs(recomputed - measurement.stated))
        worst = int(np.argmax(gap))
        if gap[worst] > STATED:
            text = (
                f"{measurement.origin(worst)} states a deviation of {measurement.stated[worst]:+.4f} mm, its points "
                f"give {recomputed[worst]:+.4f} mm: check what the file's columns mean"
            )
            found.append(Finding("stated-deviations", text, True))
    return tuple(found)


def _middle(value: Floats) -> tuple[float, float]:
    """Median, and scatter as the standard deviation of a normal distribution with the same quartiles."""
    low, middle, high = np.percentile(value, [25.0, 50.0, 75.0])
    return float(middle), float((high - low) / 1.349)


def _wrong_frame(points: Floats, search: FootPointSearch, ball: float, near: float) -> Finding | None:
    """A unit or mirroring in which clearly more points lie on the profile than the share `near`.

    A part whose zero is at its corner has half of its points on the profile in either unit.
    """
    attempts = (
        ("unit", f"times {INCH}", points * INCH, "the file is in inches: --units inch"),
        ("unit", f"divided by {INCH}", points / INCH, "the file is in millimetres or was converted twice: --units mm"),
        ("mirrored", "with x reversed", points * [-1, 1], "mirror the work frame of the measurement"),
        ("mirrored", "with y reversed", points * [1, -1], "mirror the work frame of the measurement"),
        ("mirrored", "with x and y exchanged", points[:, ::-1], "exchange the columns x and y"),
    )
    for name, how, changed, remedy in attempts:
        # The probe radius is in millimetres already.
        value = np.abs(search.find(np.ascontiguousarray(changed)).distance - ball)
        share = float((value <= REACH).mean())
        if share > max(0.5, 1.2 * near):
            text = f"{100 * near:.0f} % of the points lie on the profile, but {how} {100 * share:.0f} %: {remedy}"
            return Finding(name, text, True)
    return None


def _constant_offset(offset: float, scatter: float, ball: float, cutter_radius: float) -> Finding:
    seen = f"the points lie {offset:+.3f} mm off the profile all along, with only {scatter:.3f} mm of scatter"
    near = SMALL_SCATTER
    if ball > 0 and abs(offset + ball) < near * ball:
        return Finding("compensated-twice", f"{seen}: they are contact points already: --points contact", True)
    if ball > 0 and abs(offset + ball / 2) < near * ball / 2:
        text = f"{seen}: --probe-radius seems to be the diameter: --probe-radius {ball / 2:g}"
        return Finding("diameter-for-radius", text, True)
    if ball > 0 and abs(offset - ball) < near * ball:
        text = f"{seen}: --probe-radius seems to be half of what it should be: --probe-radius {2 * ball:g}"
        return Finding("radius-for-diameter", text, True)
    if abs(abs(offset) - 2 * cutter_radius) < near * cutter_radius:
        text = f"{seen}, the cutter's diameter: the profile was taken on the wrong side of the path: --side"
        return Finding("wrong-side", text, True)
    if ball == 0 and CONSTANT_OFFSET < offset < 10:
        text = (
            f"{seen}: they look like centres of a ball of about that radius: --points centre with the radius from the "
            "probe's calibration; or the tool differs from --tool-diameter"
        )
        return Finding("ball-not-compensated", text, True)
    return Finding("constant-offset", f"{seen}: check --tool-diameter, --probe-radius and the work frame", True)


def examine_deviations(
    deviation: Deviation, machine: Floats, profile: Profile, lowest_cut: float | None
) -> tuple[Finding, ...]:
    """Signs of misalignment, outliers, nominal in place of measured data and a wrong height.

    Parameters
    ----------
    deviation : Deviation
        Used points.
    machine : (n,) float64
        Deviations less the program's own offset, mm.
    profile : Profile
    lowest_cut : float or None
        Lowest height of the following moves, mm; None where it or the points' height is not known.

    Returns
    -------
    tuple of Finding
    """
    found = []
    if len(deviation) >= 3 and np.abs(deviation.value).max() < 1e-6:
        text = "every deviation is 0: the nominal was probably exported in place of the measured points"
        return (Finding("identical-to-nominal", text, False),)
    if lowest_cut is not None and len(deviation):
        below = deviation.z < lowest_cut - 0.01
        if below.any():
            found.append(
                Finding(
                    "below-the-cut",
                    f"{int(below.sum())} points (from Z{float(deviation.z.min()):.3f}) lie below the deepest pass at "
                    f"Z{lowest_cut:.3f}: check the height of the work frame",
                    False,
                )
            )
    offset, scatter = _middle(machine)
    far = np.abs(machine - offset) > 8 * max(scatter, 1e-4)
    if far.any() and far.mean() <= 0.1:
        worst = int(np.argmax(np.where(far, np.abs(machine - offset), 0.0)))
        x, y = deviation.foot[worst]
        found.append(
            Finding(
                "outliers",
                f"{int(far.sum())} outliers, the largest {machine[worst] * 1000:+.1f} um at X{x:.3f} Y{y:.3f}: "
                "the filters auto and robust leave them out, mean and gauss do not",
                False,
            )
        )
    read = len(deviation) + len(deviation.rejected)
    if len(deviation.rejected) > MANY_REJECTED * read:
        text = (
            f"only {len(deviation)} of {read} points can be used, most others are {_commonest(deviation)}: is the "
            "program whole, and is it the one that cut the part?"
        )
        found.append(Finding("many-rejected", text, True))
    misaligned = _misalignment(deviation, profile)
    return tuple(found) if misaligned is None else (*found, misaligned)


def _commonest(deviation: Deviation) -> str:
    reasons = [r.reason for r in deviation.rejected]
    return max(set(reasons), key=reasons.count)


def _misalignment(deviation: Deviation, profile: Profile) -> Finding | None:
    """A rigid shift or turn that by itself explains most of the deviations."""
    if len(deviation) < 10:
        return None
    n = deviation.normal
    left, bottom, right, top = profile.bounding_box()
    middle = np.array([(left + right) / 2, (bottom + top) / 2])
    size = max(right - left, top - bottom) / 2
    arm = (deviation.foot - middle) / size
    turn = arm[:, 0] * n[:, 1] - arm[:, 1] * n[:, 0]
    design = np.column_stack([np.ones(len(n)), n, turn])
    # Directions that the points hardly determine (one straight edge, a round part) say nothing.
    inside = design - design.mean(axis=0)
    strong = np.sqrt((inside[:, 1:] ** 2).mean(axis=0)) > 0.1
    design = design[:, np.concatenate([[True], strong])]
    if design.shape[1] < 2 or np.linalg.cond(design) > 20:
        return None
    clipped = np.clip(deviation.value, *np.percentile(deviation.value, [2, 98]))
    fitted = np.linalg.lstsq(design, clipped, rcond=None)[0]
    rigid = design[:, 1:] @ fitted[1:]
    total = float((clipped**2).mean())
    # A constant is no motion: what it explains is not the shift's.
    explained = 1.0 - float(((clipped - rigid) ** 2).mean()) / total if total > 0 else 0.0
    moved = float(np.abs(rigid).max())
    if explained < 0.7 or moved < 0.005:
        return None
    parameters = np.zeros(3)
    parameters[strong] = fitted[1:]
    dx, dy, turned = parameters
    return Finding(
        "misalignment",
        f"{100 * explained:.0f} % of the deviations are what a shift of X{dx * 1000:+.0f} Y{dy * 1000:+.0f} um and a "
        f"turn of {np.degrees(turned / size) * 3600:+.0f} arc seconds would give: check the alignment of the "
        "measurement (--align), or correct the work offset",
        moved > MISALIGNED,
    )
