# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report as one page of HTML that needs nothing but itself: no script, no font, no network."""

from __future__ import annotations

import datetime
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import PurePath

import numpy as np
from numpy.typing import NDArray

from . import __version__, provenance
from .deviation import statistics
from .pipeline import Result
from .report_plots import COLOURS, MICRO, STYLE, UM, Plot, along_contour, histogram, on_contour

Floats = NDArray[np.float64]

MINUS, ARROW, DASH, SIGMA, DOT, ELLIPSIS = (
    "\N{MINUS SIGN}",
    "\N{RIGHTWARDS ARROW}",
    "\N{EN DASH}",
    "\N{GREEK SMALL LETTER SIGMA}",
    "\N{MIDDLE DOT}",
    "\N{HORIZONTAL ELLIPSIS}",
)

PATH_ERROR_WORTH_SAYING = 1e-3
"""A program that is farther than this, in mm, from the exact path gets a section of its own."""

_MOST_ROWS = 40
_MOST_LINES = 6


def page(
    result: Result,
    *,
    outputs: Mapping[str, str] | None = None,
    notes: Sequence[str] = (),
    date: datetime.date | None = None,
) -> str:
    """The report as HTML.

    Parameters
    ----------
    result : Result
    outputs : mapping of str to str, optional
        What else was written: kind to path.
    notes : sequence of str
        Statements for the top.
    date : datetime.date, optional
        Today by default.
    """
    name = PurePath(result.request.program.name).name
    largest = largest_correction(result)
    day = (date or datetime.date.today()).isoformat()
    body = [
        f"<header><p class=kind>Toolpath correction report</p><h1>{escape(name)}</h1>"
        f"<p class=meta>{day} {DOT} millcorr {escape(__version__)}</p></header>",
        "".join(f"<p class=note>{escape(note)}</p>" for note in notes),
        _verdict(result, largest),
        _tiles(result, largest),
        _warnings(result),
        _deviations(result),
        *_plots(result),
        _separation(result),
        _own_path_error(result),
        _correction(result, largest),
        _settings(result),
        _files(result, outputs or {}),
        "<footer><p>Every measured point is in <b>deviations.csv</b>, every number in <b>report.json</b>, the "
        f"compensated profile as NURBS in <b>profile.json</b> and "
        f"<b>profile.step</b>. Made by millcorr {escape(__version__)}.</p></footer>",
    ]
    return (
        "<!DOCTYPE html>\n<html lang=en><head><meta charset=utf-8>"
        "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'; style-src 'unsafe-inline'\">"
        "<meta name=viewport content='width=device-width,initial-scale=1'>"
        f"<meta name=color-scheme content='light dark'><title>{escape(name)}: toolpath correction</title>"
        f"<style>{_style()}</style></head>\n<body><main>\n"
        + "\n".join(part for part in body if part)
        + "\n</main></body></html>\n"
    )


def _style() -> str:
    def variables(theme: str) -> str:
        return "".join(f"--{name}:{value};" for name, value in COLOURS[theme].items())

    return (
        f":root{{{variables('light')}--note:#fff4d6;--note-edge:#d99a00;--tile:#f5f7fa}}"
        f"@media screen and (prefers-color-scheme:dark){{:root{{{variables('dark')}"
        "--note:#3a2f12;--note-edge:#d9a83a;--tile:#1e262e}}" + _LOOKS + STYLE
    )


_LOOKS = """
*{box-sizing:border-box}
html{background:var(--paper);color:var(--ink)}
body{margin:0;font:15px/1.5 "Segoe UI","Helvetica Neue",Arial,"Liberation Sans","DejaVu Sans",sans-serif}
main{max-width:900px;margin:0 auto;padding:28px 24px 40px}
header{border-bottom:2px solid var(--ink);margin-bottom:18px;
display:grid;grid-template-columns:1fr auto;align-items:end}
.kind{grid-column:1/3;margin:0;font-size:12px;letter-spacing:.09em;text-transform:uppercase;color:var(--soft)}
h1{margin:0 0 6px;font-size:27px;line-height:1.2;overflow-wrap:anywhere}
.meta{margin:0 0 8px 16px;color:var(--soft);white-space:nowrap}
h2{font-size:17px;margin:30px 0 8px;break-after:avoid}
p{margin:0 0 8px}
.verdict{font-size:16px;margin:0 0 14px}
.note,.warnings{border-left:4px solid var(--note-edge);background:var(--note);padding:8px 14px;margin:0 0 14px}
.note{font-weight:600}
.warnings ul{margin:2px 0 0;padding-left:20px}
.tiles{display:grid;grid-template-columns:repeat(4,1fr);gap:10px;margin:0 0 16px}
.tile{background:var(--tile);padding:10px 12px;border-radius:4px;break-inside:avoid}
.tile b{display:block;font-size:19px;font-weight:600;font-variant-numeric:tabular-nums;white-space:nowrap}
.tile span{font-size:12px;color:var(--soft);display:block;line-height:1.35}
table{border-collapse:collapse;width:100%;margin:4px 0 10px;font-variant-numeric:tabular-nums}
th,td{text-align:left;padding:4px 10px 4px 0;border-bottom:1px solid var(--faint);vertical-align:top}
thead th{border-bottom:1px solid var(--soft);font-weight:600;color:var(--soft);font-size:13px}
tbody th{font-weight:400}
.numbers td,.numbers thead th+th{text-align:right;padding:4px 0 4px 10px}
.numbers td.words,.numbers thead th.words{text-align:left;padding-left:24px}
.facts th{width:15em;color:var(--soft)}
td{overflow-wrap:anywhere}
tr{break-inside:avoid}
.hash{font:12px/1.4 "DejaVu Sans Mono",Consolas,Menlo,monospace;color:var(--soft)}
.small,figcaption,footer{font-size:13px;color:var(--soft)}
figure{margin:6px 0 14px;break-inside:avoid}
.plot svg{display:block;width:100%;height:auto}
footer{border-top:1px solid var(--faint);margin-top:28px;padding-top:8px}
@media (max-width:640px){.tiles{grid-template-columns:repeat(2,1fr)}main{padding:16px 12px}}
@media print{@page{size:A4;margin:15mm}body{font-size:10.5pt}main{max-width:none;padding:0}
*{-webkit-print-color-adjust:exact;print-color-adjust:exact}h1{font-size:19pt}h2{margin-top:16pt}.verdict{font-size:11pt}
.hash{font-size:7.5pt}.facts{break-inside:avoid}}
"""


def _um(value: float, signed: bool = False) -> str:
    """Micrometres with two decimals."""
    if not math.isfinite(value):
        return DASH
    text = f"{value * UM:+.2f}" if signed else f"{value * UM:.2f}"
    if float(text) == 0:
        text = "0.00"
    return text.replace("-", MINUS)


def _mm(value: float, digits: int = 3) -> str:
    return f"{value:.{digits}f}".replace("-", MINUS) if math.isfinite(value) else DASH


def _place(x: float, y: float) -> str:
    return f"X{_mm(x)} Y{_mm(y)}"


def _count(count: int) -> str:
    return f"{count:,}".replace(",", "\N{NARROW NO-BREAK SPACE}")


def _plural(count: int, thing: str) -> str:
    return f"{_count(count)} {thing}{'' if count == 1 else 's'}"


def _table(head: Sequence[str], rows: Iterable[Sequence[str]], css: str = "numbers") -> str:
    """Table of escaped cells, the first of each row its name."""
    top = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    body = "".join(
        f"<tr><th>{escape(row[0])}</th>" + "".join(f"<td>{escape(cell)}</td>" for cell in row[1:]) + "</tr>"
        for row in rows
    )
    header = f"<thead><tr>{top}</tr></thead>" if head else ""
    return f"<table class={css}>{header}<tbody>{body}</tbody></table>"


def _facts(rows: Iterable[tuple[str, str]]) -> str:
    return _table((), rows, "facts")


@dataclass(frozen=True, slots=True)
class LargestCorrection:
    """Where the profile is moved farthest.

    Parameters
    ----------
    value : float
        Signed correction in mm, positive out of the material.
    contour : int
    s : float
        mm from the contour's start.
    point : tuple of float
        x, y of the nominal in mm.
    """

    value: float
    contour: int
    s: float
    point: tuple[float, float]


def largest_correction(result: Result) -> LargestCorrection:
    """The largest correction and its place."""
    correction, nominal = result.correction, result.nominal
    extremes = [course.extreme for course in correction.courses]
    k = int(np.argmax([abs(value) for _, value in extremes]))
    stretch, (along_stretch, value) = correction.stretches[k], extremes[k]
    s = stretch.begin + along_stretch
    if nominal.contours[stretch.contour].closed:
        s %= float(nominal.total[stretch.contour])
    point, _ = nominal.at(stretch.contour, np.array([s]))
    return LargestCorrection(value, stretch.contour, s, (float(point[0, 0]), float(point[0, 1])))


def profile_value(deviation: Floats) -> float:
    """Profile deviation 2 max abs(d) in mm, to compare with a tolerance zone (ISO 1101); NaN without points."""
    return 2.0 * float(np.abs(deviation).max()) if len(deviation) else math.nan


def expected_std(result: Result) -> float:
    """Standard deviation in mm to expect when the next part is measured the same way; NaN where unknown.

    What the correction leaves of the determined part, the random part anew, and what of this part's random
    part went through the filter into the correction: ``s_rest^2 + s^2 (1 + g^2 q)``.
    """
    if not len(result.deviation) or not math.isfinite(result.random_std):
        return math.nan
    points = [len(part.determined) for part in result.separations]
    factor = float(np.average([part.variance_factor for part in result.separations], weights=points))
    rest = result.filtered + result.predicted - result.deviation.value
    gain = result.request.settings.gain
    variance = float(rest.var()) + result.random_std**2 * (1 + gain**2 * factor)
    return math.sqrt(variance)


def _corrected_before(result: Result) -> bool:
    return bool(provenance.marks(result.request.program.comments()))


def _verdict(result: Result, largest: LargestCorrection) -> str:
    d, settings, proof = result.deviation, result.request.settings, result.verification
    words = []
    if len(d):
        s = statistics(d.value)
        measurement = result.request.measurement
        name = PurePath(measurement.source).name if measurement is not None else ""
        words.append(
            f"{_plural(len(d) + len(d.rejected), 'measured point')} ({escape(name)}) show deviations of "
            f"{_um(s['min'], True)} to {_um(s['max'], True)} {MICRO}, {_um(s['mean'], True)} {MICRO} in the mean."
        )
    else:
        words.append("No measurement: the path is laid on the exact parallel of the nominal contour.")
    moves = result.regeneration
    if not moves.changed:
        words.append("Nothing is to be corrected: <b>the program stays as it is</b>.")
    elif abs(largest.value) < 5e-9:
        words.append(f"<b>{_plural(moves.changed, 'move')} of the program change</b> by the path's own error only.")
    else:
        words.append(
            f"<b>The correction moves the contour by up to {_um(largest.value, True)} {MICRO}</b> (at "
            f"{_place(*largest.point)}) and changes {_plural(moves.changed, 'move')}."
        )
    kept = "within" if proof.path_error_max <= settings.tolerance else "<b>outside</b>"
    words.append(
        f"Read back, the program keeps the exact path to {_um(proof.path_error_max)} {MICRO}, {kept} its tolerance of "
        f"{_um(settings.tolerance)} {MICRO}."
    )
    return f"<p class=verdict>{' '.join(words)}</p>"


def _tiles(result: Result, largest: LargestCorrection) -> str:
    tiles = []
    if len(result.deviation):
        before, after = statistics(result.deviation.value), statistics(result.predicted)
        mean = f"{_um(before['mean'], True)} {ARROW} {_um(after['mean'], True)}"
        height = f"{_um(before['height'])} {ARROW} {_um(after['height'])}"
        tiles.append((mean, f"mean deviation, {MICRO}, before and predicted"))
        tiles.append((height, f"height (max {MINUS} min), {MICRO}, before and predicted"))
    tiles.append((f"{_um(largest.value, True)} {MICRO}", "largest correction of the contour"))
    if len(result.deviation) == 0:
        tiles.append((_plural(result.regeneration.changed, "move"), "changed in the program"))
    tiles.append((f"{_um(result.verification.path_error_max)} {MICRO}", "largest path error of the program, read back"))
    inner = "".join(f"<div class=tile><b>{escape(v)}</b><span>{escape(what)}</span></div>" for v, what in tiles)
    return f"<div class=tiles>{inner}</div>"


def _warnings(result: Result) -> str:
    if not result.warnings:
        return ""
    items = "".join(f"<li>{escape(text)}</li>" for text in result.warnings)
    title = "Warning" if len(result.warnings) == 1 else f"{len(result.warnings)} warnings"
    return f"<section class=warnings><b>{title}</b><ul>{items}</ul></section>"


_SIGN = (
    "Deviations are signed along the nominal's normal: <b>positive is excess material, negative is undercut</b>. "
    f"Deviations in {MICRO}, coordinates and lengths in mm."
)


def _deviations(result: Result) -> str:
    d = result.deviation
    if not len(d):
        return f"<h2>Deviations</h2><p>No points were measured.</p><p class=small>{_SIGN}</p>"
    columns = (("before", d.value), ("determined part", result.filtered), ("predicted after", result.predicted))
    rows = []
    for name, value in columns:
        s = statistics(value)
        signed = [_um(s[key], True) for key in ("mean", "min", "max")]
        rows.append((name, *signed, _um(s["height"]), _um(s["std"]), _um(profile_value(value))))
    head = (MICRO, "mean", "min", "max", "height", "std", "profile value")
    words = [
        "Predicted: the same points after the correction, this part's random part unchanged. The profile value is "
        f"2{DOT}max|d|, to be held against the width of a profile tolerance zone (ISO 1101)."
    ]
    again = expected_std(result)
    if math.isfinite(again):
        words.append(
            "The next part brings its own random part: measured the same way, a standard deviation of about "
            f"<b>{_um(again)} {MICRO}</b> is to be expected."
        )
    else:
        words.append(
            "The random part is not known here, so the prediction is too favourable: the next part brings its own, "
            "and what was random on this part comes on top."
        )
    return (
        f"<h2>Deviations</h2>{_table(head, rows)}<p class=small>{_SIGN}</p><p class=small>{' '.join(words)}</p>"
        + _points(result)
        + _by_level(result)
    )


def _points(result: Result) -> str:
    d, measurement = result.deviation, result.request.measurement
    assert measurement is not None
    kind = "contact points"
    if measurement.ball_radius > 0:
        kind = f"ball centres, ball radius {measurement.ball_radius:g} mm"
    counts = f"{_plural(len(measurement), 'point')} read ({kind}), {_count(len(d))} used, "
    counts += f"{_count(len(d.rejected))} rejected"
    groups: dict[str, list[int]] = {}
    for r in d.rejected:
        groups.setdefault(r.reason, []).append(int(measurement.lines[r.index]))
    items = []
    for reason, lines in sorted(groups.items(), key=lambda group: -len(group[1])):
        listed = ", ".join([*map(str, lines[:_MOST_LINES]), *([ELLIPSIS] if len(lines) > _MOST_LINES else [])])
        word = "line" if len(lines) == 1 else "lines"
        items.append(f"<li>{_count(len(lines))} \N{MULTIPLICATION SIGN} {escape(reason)} ({word} {listed})</li>")
    return f"<p>{counts}.</p>" + (f"<ul>{''.join(items)}</ul>" if items else "")


def _by_level(result: Result) -> str:
    """Before and predicted for every contour and level, where there are several."""
    d = result.deviation
    levels = int(d.level.max()) + 1
    keys = [divmod(int(key), levels) for key in np.unique(d.contour * levels + d.level)]
    if len(keys) < 2:
        return ""
    rows = []
    for contour, level in keys[:_MOST_ROWS]:
        at = (d.contour == contour) & (d.level == level)
        before, after = statistics(d.value[at]), statistics(result.predicted[at])
        rows.append(
            (
                f"contour {contour + 1}, Z {_mm(float(d.z[at].mean()))}",
                _count(int(at.sum())),
                _um(before["mean"], True),
                _um(before["height"]),
                _um(before["std"]),
                _um(after["mean"], True),
                _um(after["height"]),
                _um(after["std"]),
            )
        )
    head = (MICRO, "points", "mean", "height", "std", "predicted mean", "height", "std")
    more = f"<p class=small>{len(keys) - _MOST_ROWS} more are not listed.</p>" if len(keys) > _MOST_ROWS else ""
    return _table(head, rows) + more


def near_zero(result: Result) -> tuple[float, str]:
    """Deviation in mm up to which a point counts as near zero on the contour's plot, and why."""
    settings = result.request.settings
    if settings.dead_band > 0:
        return settings.dead_band, "the dead band"
    if math.isfinite(result.random_std) and result.random_std > 0:
        return 2 * result.random_std, f"twice the random part's {SIGMA}"
    return settings.tolerance, "the path's tolerance"


def _plots(result: Result) -> list[str]:
    d = result.deviation
    parts = []
    if len(d):
        plot = along_contour(result.nominal, d, result.filtered, result.predicted)
        parts.append("<h2>Deviation along the contour</h2>" + _figure(plot))
    within, why = near_zero(result)
    rejected = None
    if result.request.measurement is not None and d.rejected:
        rejected = result.request.measurement.points[[r.index for r in d.rejected]]
    plot = on_contour(result.nominal, d, result.filtered, within=within, rejected=rejected)
    title = "Deviations on the contour" if len(d) else "Contour"
    more = f" Near zero: up to {_um(within)} {MICRO}, {why}." if len(d) else ""
    parts.append(f"<h2>{title}</h2>" + _figure(Plot(plot.svg, plot.caption + more)))
    if len(d):
        parts.append("<h2>Distribution</h2>" + _figure(histogram(d.value, result.predicted, result.random_std)))
    return parts


def _figure(plot: Plot) -> str:
    return f"<figure class=plot>{plot.svg}<figcaption>{escape(plot.caption)}</figcaption></figure>"


def _separation(result: Result) -> str:
    if not result.separations:
        return ""
    random = (
        f"<p>Random part: standard deviation <b>{_um(result.random_std)} {MICRO}</b>, process and measurement "
        "together. It does not repeat and is not corrected.</p>"
        if math.isfinite(result.random_std)
        else "<p>The random part is not known: without a filter all of the deviation is taken as determined, and what "
        "was random on this part is milled into the next.</p>"
    )
    random += "".join(f"<p>{escape(text[:1].upper() + text[1:])}.</p>" for text in result.advice)
    title = "<h2>What repeats and what does not</h2>"
    if len(result.separations) == 1:
        part = result.separations[0]
        words = part.description[:1].upper() + part.description[1:]
        return (
            f"{title}{random}<p>{escape(words)}. Of the random part's variance {part.variance_factor * 100:.1f} % "
            "goes through the filter into the correction.</p>"
        )
    rows = [
        (str(i), _count(len(part.determined)), _um(part.random_std), f"{part.variance_factor:.3f}", part.description)
        for i, part in enumerate(result.separations[:_MOST_ROWS], 1)
    ]
    head = ("smooth stretch and level", "points", f"random {SIGMA} / {MICRO}", "variance factor", "filter")
    left = len(result.separations) - _MOST_ROWS
    more = f"<p class=small>{left} more are not listed.</p>" if left > 0 else ""
    table = _table(head, rows).replace("<th>filter</th>", "<th class=words>filter</th>")
    return f"{title}{random}{_last_column_in_words(table)}{more}"


def _last_column_in_words(table: str) -> str:
    rows = table.split("</td></tr>")
    return "</td></tr>".join(
        row[: row.rfind("<td>")] + "<td class=words>" + row[row.rfind("<td>") + 4 :] if "<td>" in row else row
        for row in rows
    )


def _own_path_error(result: Result) -> str:
    error = result.regeneration.original_error
    if error <= PATH_ERROR_WORTH_SAYING:
        return ""
    title = "<h2>The program's own path error</h2>"
    if _corrected_before(result):
        title = "<h2>The correction in force</h2>"
        words = (
            f"This program was corrected before: it commands a contour up to <b>{_um(error)} {MICRO}</b> off the "
            "nominal. This offset is known exactly and was taken out of the deviations before filtering; the new "
            "correction takes its place."
        )
    else:
        words = (
            f"The path of the program is up to <b>{_um(error)} {MICRO}</b> off the exact parallel of the nominal. This "
            "share comes from the CAM system's path, not from the machine: it is known exactly, was taken out of the "
            "deviations before filtering, and the corrected program does not have it."
        )
    if not len(result.commanded):
        return f"{title}<p>{words}</p>"
    s = statistics(result.commanded)
    rms = math.sqrt(float((result.commanded**2).mean()))
    signed = [_um(s[key], True) for key in ("mean", "min", "max")]
    row = ("at the points", *signed, _um(s["height"]), _um(s["std"]), _um(rms))
    return f"{title}<p>{words}</p>" + _table((MICRO, "mean", "min", "max", "height", "std", "rms"), [row])


def _correction(result: Result, largest: LargestCorrection) -> str:
    moves, proof, settings = result.regeneration, result.verification, result.request.settings
    where = f" at {_place(*largest.point)}, s = {_mm(largest.s)} mm" if largest.value else ""
    if largest.value and len(result.nominal.contours) > 1:
        where += f" on contour {largest.contour + 1}"
    side = "out of the material" if largest.value > 0 else "into the material"
    facts = [
        ("Largest correction", f"{_um(largest.value, True)} {MICRO}{where}" + (f" ({side})" if largest.value else "")),
        ("Moves", f"{_count(moves.changed)} of the program's moves changed, {_count(len(moves.toolpath))} written"),
        ("Largest displacement of a vertex", f"{_um(moves.largest_shift)} {MICRO}"),
    ]
    status = "kept" if proof.path_error_max <= settings.tolerance else "exceeded"
    checks = [
        (
            "Largest path error",
            f"{_um(proof.path_error_max)} {MICRO} at {_place(*proof.place)}; "
            f"tolerance {_um(settings.tolerance)} {MICRO} {status}",
        ),
        ("Gouge", f"{_um(proof.gouge_max)} {MICRO} nearer to the profile than the cutter's radius at most"),
        ("Profile as NURBS", f"within {_um(result.fit_residual)} {MICRO} of the exact compensated contour"),
        ("Checked length of path", f"{_mm(proof.length)} mm"),
    ]
    return (
        f"<h2>Correction</h2>{_facts(facts)}<h2>Verification</h2><p>The emitted program was read back and its path "
        f"compared with the exact parallel of the compensated profile.</p>{_facts(checks)}"
    )


_SETTING_NAMES = {
    "side": "Side of the cutter",
    "align": "Alignment",
    "filter": "Filter",
    "method": "Method",
    "gain": "Gain",
    "limit": "Limit of a correction",
    "dead_band": "Dead band",
    "tolerance": "Tolerance of the path",
    "output_moves": "Kinds of move written",
    "cutter_compensation": "With G41, G42 the program gives",
}
_LENGTHS = ("limit", "dead_band", "tolerance")


def _settings(result: Result) -> str:
    summary = result.summary()
    facts = [("Tool diameter", f"{2 * result.request.radius:g} mm")]
    distance = "the cutter's centre" if result.path_radius else "the contour; the control offsets by the radius"
    facts.append(("Program gives", distance))
    facts.append(("Nominal", "given" if result.request.nominal is not None else "the contour that the program cuts"))
    for name, value in summary["settings"].items():
        text = f"{value:g}" if isinstance(value, float) else str(value)
        facts.append((_SETTING_NAMES.get(name, name.replace("_", " ")), text + (" mm" if name in _LENGTHS else "")))
    shift, turn = summary["alignment"]["shift"], summary["alignment"]["rotation_deg"]
    if any(shift) or turn:
        facts.append(("Aligned by", f"shift X{_mm(shift[0], 4)} Y{_mm(shift[1], 4)} mm, turn {turn:.5f} degrees"))
    return f"<h2>Settings</h2>{_facts(facts)}"


def _files(result: Result, outputs: Mapping[str, str]) -> str:
    rows = "".join(
        f"<tr><th>{escape(kind)}</th><td>{escape(str(entry['name']))}<br><span class=hash>SHA-256 "
        f"{escape(str(entry['sha256']))}</span></td></tr>"
        for kind, entry in result.inputs().items()
    )
    out = f"<h2>Inputs</h2><table class=facts><tbody>{rows}</tbody></table>"
    if outputs:
        out += f"<h2>Outputs</h2>{_facts((kind, str(path)) for kind, path in outputs.items())}"
    return out
