# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report as one page of HTML that needs nothing but itself: no script, no font, no network."""

from __future__ import annotations

import datetime
import math
from collections.abc import Mapping, Sequence
from html import escape
from pathlib import PurePath

import numpy as np

from millcorr.arrays import Floats
from millcorr.comparison.deviation import statistics
from millcorr.correction import provenance
from millcorr.correction.settings import Settings
from millcorr.geometry.correction import LargestCorrection, largest_correction
from millcorr.messages import Message, joined, phrase
from millcorr.options import options_of
from millcorr.pipeline import Result

from . import reader
from .html import (
    STATISTICS,
    capital,
    coordinates,
    figure,
    grouped,
    heading,
    html_facts,
    html_notes,
    html_page,
    html_table,
    html_tiles,
    mm,
    plural,
    statistics_of,
    um,
    with_unit,
)
from .plots import COVERAGE, Plot, along_contour, histogram
from .posterior import posteriors
from .prediction import nothing_measured, prediction_section, setup_name
from .transfer import transfer_section
from .verdict import what_to_do
from .view import on_contour, path_and_contour

ARROW, SIGMA, ELLIPSIS = "\N{RIGHTWARDS ARROW}", "\N{GREEK SMALL LETTER SIGMA}", "\N{HORIZONTAL ELLIPSIS}"

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
    largest = largest_correction(result.correction, result.nominal)
    parts = [
        html_notes(notes),
        _verdict(result, largest),
        _tiles(result, largest),
        _warnings(result),
        _deviations(result),
        *_plots(result),
        _separation(result),
        prediction_section(result),
        transfer_section(result),
        _own_path_error(result),
        _correction(result, largest),
        _settings(result),
        _files(result, outputs or {}),
    ]
    return html_page(
        phrase("Toolpath correction report"),
        PurePath(result.request.program.name).name,
        parts,
        about="toolpath correction",
        files=f"Every {'simulated' if nothing_measured(result) else 'measured'} point is in <b>deviations.csv</b>, "
        "the contour check in <b>contour.csv</b>, every number in <b>report.json</b>, "
        "the nominal in <b>nominal.json</b>, "
        "the compensated profile as NURBS in <b>profile.json</b> and <b>profile.step</b>.",
        date=date,
    )


def profile_value(deviation: Floats) -> float:
    """Profile deviation 2 max abs(d) in mm, to compare with a tolerance zone (ISO 1101); NaN without points."""
    return 2.0 * float(np.abs(deviation).max()) if len(deviation) else math.nan


def expected_std(result: Result) -> float:
    """Standard deviation in mm to expect when the next part is measured the same way; NaN where unknown.

    What the correction leaves of the systematic part, the random part anew, and how badly the systematic part is
    known: ``s_rest^2 + s^2 + g^2 u^2``.
    """
    if not len(result.deviation) or not math.isfinite(result.random_std):
        return math.nan
    known = result.uncertainty[np.isfinite(result.uncertainty)]
    unsure = float((known**2).mean()) if len(known) else 0.0
    rest = result.filtered + result.predicted - result.deviation.value
    gain = result.request.settings.gain
    variance = float(rest.var()) + result.random_std**2 + gain**2 * unsure
    return math.sqrt(variance)


def _corrected_before(result: Result) -> bool:
    return bool(provenance.marks(result.request.program.comments()))


def _verdict(result: Result, largest: LargestCorrection) -> str:
    d, settings, proof = result.deviation, result.request.settings, result.verification
    words = []
    do, why = what_to_do(result.summary())
    first = f"<p class=verdict><b>{escape(capital(do))}</b>: {escape(reader.worded(why))}.</p>"
    if len(d):
        s, count = statistics(d.value), len(d) + len(d.rejected)
        span = phrase(
            "{} to {}, {} in the mean", um(s["min"], True), with_unit(s["max"], True), with_unit(s["mean"], True)
        )
        measurement, prediction = result.request.measurement, result.prediction
        if prediction is not None and nothing_measured(result):
            words.append(
                phrase("<b>Nothing was measured</b>: the model of {} leaves {}.", escape(setup_name(prediction)), span)
            )
        else:
            name = escape(PurePath(measurement.source).name) if measurement is not None else ""
            shown = phrase("{} measured points ({}) show deviations of {}.", grouped(count), name, span)
            words.append(phrase("1 measured point ({}) shows deviations of {}.", name, span) if count == 1 else shown)
        if prediction is not None:
            words.append(
                phrase(
                    "The model expects at most {} along the whole contour before the correction and {} after it.",
                    with_unit(prediction.before.largest),
                    with_unit(prediction.after[-1].largest),
                )
            )
    else:
        words.append(phrase("No measurement: the path is laid on the exact parallel of the nominal contour."))
    moves = result.regeneration
    if not moves.changed:
        words.append(phrase("Nothing is to be corrected: <b>the program stays as it is</b>."))
    elif abs(largest.value) < 5e-9:
        words.append(phrase("<b>{} of the program change</b> by the path's own error only.", _moves(moves.changed)))
    else:
        words.append(
            phrase(
                "<b>The correction moves the contour by up to {}</b> (at {}) and changes {}.",
                with_unit(largest.value, True),
                coordinates(*largest.point),
                _moves(moves.changed),
            )
        )
    kept, limit = with_unit(proof.path_error_max), with_unit(settings.tolerance)
    within = phrase("Read back, the program keeps the exact path to {}, within its tolerance of {}.", kept, limit)
    beyond = phrase(
        "Read back, the program keeps the exact path to {}, <b>outside</b> its tolerance of {}.", kept, limit
    )
    words.append(within if proof.path_error_max <= settings.tolerance else beyond)
    return f"{first}<p class=verdict>{' '.join(map(reader.worded, words))}</p>"


def _moves(count: int) -> Message:
    return phrase("1 move") if count == 1 else phrase("{} moves", grouped(count))


def _tiles(result: Result, largest: LargestCorrection) -> str:
    tiles = []
    if len(result.deviation):
        before, after = statistics(result.deviation.value), statistics(result.predicted)
        mean = f"{um(before['mean'], True)} {ARROW} {um(after['mean'], True)}"
        height = f"{um(before['height'])} {ARROW} {um(after['height'])}"
        tiles.append((mean, phrase("mean deviation, {}, before and predicted", reader.fine())))
        tiles.append((height, phrase("height (max \N{MINUS SIGN} min), {}, before and predicted", reader.fine())))
    tiles.append((f"{with_unit(largest.value, True)}", phrase("largest correction of the contour")))
    if len(result.deviation) == 0:
        tiles.append((_moves(result.regeneration.changed), phrase("changed in the program")))
    tiles.append(
        (f"{with_unit(result.verification.path_error_max)}", phrase("largest path error of the program, read back"))
    )
    return html_tiles(tiles)


def _warnings(result: Result) -> str:
    if not result.warnings:
        return ""
    items = "".join(f"<li>{escape(reader.worded(text))}</li>" for text in result.warnings)
    title = phrase("Warning") if len(result.warnings) == 1 else phrase("{} warnings", len(result.warnings))
    return f"<section class=warnings><b>{reader.worded(title)}</b><ul>{items}</ul></section>"


def _sign() -> str:
    return reader.worded(
        phrase(
            "Deviations are signed along the nominal's normal: <b>positive is excess material, negative is "
            "undercut</b>. Deviations in {}, coordinates and lengths in {}.",
            reader.fine(),
            reader.coarse(),
        )
    )


def _deviations(result: Result) -> str:
    d = result.deviation
    if not len(d):
        none = reader.worded(phrase("No points were measured."))
        return heading(phrase("Deviations")) + f"<p>{none}</p><p class=small>{_sign()}</p>"
    columns = (
        (phrase("before"), d.value),
        (phrase("determined part"), result.filtered),
        (phrase("predicted after"), result.predicted),
    )
    rows = []
    for name, value in columns:
        rows.append((name, *statistics_of(value), um(profile_value(value))))
    head = (reader.fine(), *STATISTICS, phrase("profile value"))
    if nothing_measured(result):
        words = phrase("All by the model: the program as it came, and after the correction, each simulated.")
    elif result.prediction is not None:
        words = phrase("Predicted: what the model expects at the same points, their random part unchanged.")
    else:
        words = phrase("Predicted: the same points after the correction, this part's random part unchanged.")
    said = [
        words,
        phrase(
            "The profile value is 2\N{MIDDLE DOT}max|d|, to be held against the width of a profile tolerance zone "
            "(ISO 1101)."
        ),
    ]
    if result.prediction is None:
        said.append(_next_part(result))
    words = joined(said, " ")
    return (
        heading(phrase("Deviations"))
        + html_table(head, rows)
        + f"<p class=small>{_sign()}</p><p class=small>{reader.worded(words)}</p>"
        + _points(result)
        + _by_level(result)
    )


def _next_part(result: Result) -> Message:
    """What the random part makes of the prediction."""
    again = expected_std(result)
    if math.isfinite(again):
        return phrase(
            "The next part brings its own random part: measured the same way, a standard deviation of about "
            "<b>{}</b> is to be expected.",
            with_unit(again),
        )
    return phrase(
        "The random part is not known here, so the prediction is too favourable: the next part brings its own, "
        "and what was random on this part comes on top."
    )


def _points(result: Result) -> str:
    d, measurement = result.deviation, result.request.measurement
    assert measurement is not None
    if nothing_measured(result):
        return f"<p>{plural(len(d), 'point')} of the simulated surface.</p>"
    kind = "contact points"
    if measurement.ball_radius > 0:
        kind = f"ball centres, ball radius {reader.length(measurement.ball_radius)}"
    elif measurement.axis_radii is not None:
        radii = " and ".join(reader.length(radius) for radius in sorted(set(measurement.axis_radii)))
        kind = f"ball centres shifted along an axis, ball radius {radii}"
    if measurement.probe is not None:
        kind += f", probe {escape(measurement.probe.source)}" if measurement.probe.source else ", calibrated probe"
    wrong = result.left_out
    counts = f"{plural(len(measurement), 'point')} read ({kind}), "
    counts += f"{grouped(len(d) + len(d.rejected) - len(wrong))} used, {grouped(len(wrong))} left out"
    groups: dict[str, list[int]] = {}
    for r in wrong:
        groups.setdefault(r.reason, []).append(int(measurement.lines[r.index]))
    items = []
    for reason, lines in sorted(groups.items(), key=lambda group: -len(group[1])):
        listed = ", ".join([*map(str, lines[:_MOST_LINES]), *([ELLIPSIS] if len(lines) > _MOST_LINES else [])])
        word = "line" if len(lines) == 1 else "lines"
        items.append(
            f"<li>{grouped(len(lines))} \N{MULTIPLICATION SIGN} {escape(reader.worded(reason))} ({word} {listed})</li>"
        )
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
                phrase("contour {}, Z {}", contour + 1, mm(float(d.z[at].mean()))),
                grouped(int(at.sum())),
                um(before["mean"], True),
                um(before["height"]),
                um(before["std"]),
                um(after["mean"], True),
                um(after["height"]),
                um(after["std"]),
            )
        )
    head = (
        reader.fine(),
        phrase("points"),
        phrase("mean"),
        phrase("height"),
        phrase("std"),
        phrase("predicted mean"),
        phrase("height"),
        phrase("std"),
    )
    more = f"<p class=small>{len(keys) - _MOST_ROWS} more are not listed.</p>" if len(keys) > _MOST_ROWS else ""
    return html_table(head, rows) + more


def near_zero(result: Result) -> tuple[float, str]:
    """Deviation in mm up to which a point counts as near zero on the contour's plot, and why."""
    settings = result.request.settings
    if settings.dead_band > 0:
        return settings.dead_band, "the dead band"
    if math.isfinite(result.random_std) and result.random_std > 0 and not nothing_measured(result):
        return 2 * result.random_std, f"twice the random part's {SIGMA}"
    return settings.tolerance, "the path's tolerance"


def _plots(result: Result) -> list[str]:
    d = result.deviation
    # What a model leaves without a form is no scatter of parts.
    scatter = math.nan if nothing_measured(result) else result.random_std
    parts = []
    if len(d):
        plot = along_contour(
            result.nominal, d, result.filtered, result.predicted, result.uncertainty, posteriors(result), result.outlier
        )
        parts.append(heading(phrase("Deviation along the contour")) + figure(plot))
    within, why = near_zero(result)
    rejected = None
    left_out = [point.index for point in result.left_out]
    if result.request.measurement is not None and left_out:
        rejected = result.request.measurement.points[left_out]
    plot = on_contour(result.nominal, d, result.filtered, within=within, rejected=rejected)
    title = phrase("Deviations on the contour") if len(d) else phrase("Contour")
    more = f" Near zero: up to {with_unit(within)}, {why}." if len(d) else ""
    parts.append(heading(title) + figure(Plot(plot.svg, plot.caption + more)))
    if len(d):
        parts.append(heading(phrase("Path and contour")) + figure(path_and_contour(result)))
        parts.append(heading(phrase("Distribution")) + figure(histogram(d.value, result.predicted, scatter)))
    return parts


def _separation(result: Result) -> str:
    found = result.separated
    if found is None or result.prediction is not None:
        return ""
    lines = [
        f"Random part: standard deviation <b>{with_unit(result.random_std)}</b>, process and measurement together. It "
        "does not repeat and is not corrected."
    ]
    lines += [escape(capital(text)) + "." for text in result.advice]
    sizes = found.sizes
    lines.append(
        f"Form: {with_unit(sizes.form)} ({SIGMA}) over {reader.length(sizes.form_length, '.3g')}; process "
        f"{with_unit(sizes.process)} over {reader.length(sizes.memory, '.2g')}; measurement {with_unit(sizes.white)}. "
        "The band along the whole contour "
        f"(95 %) is {found.band:.2g} standard uncertainties wide to either side. "
        f"Filter: {escape(str(found.filter))}."
    )
    if math.isfinite(found.longest_memory):
        lines.append(
            "Uncertainty and band hold for a process that remembers less than "
            f"{reader.length(found.longest_memory, '.2g')}: one part does not tell noise that is "
            "smooth over longer from form, a second part does."
        )
    out = heading(phrase("What repeats and what does not")) + "".join(f"<p>{line}</p>" for line in lines)
    wrong = result.outliers()
    if not wrong:
        return out
    rows = [
        (str(row["index"] + 1), *(mm(row[k]) for k in "xyz"), um(row["value"], True), um(row["expected"], True))
        for row in wrong[:_MOST_ROWS]
    ]
    head = (
        phrase("point"),
        "X",
        "Y",
        "Z",
        phrase("measured / {}", reader.fine()),
        phrase("expected / {}", reader.fine()),
    )
    left = len(wrong) - _MOST_ROWS
    more = f"<p class=small>{left} more are in report.json.</p>" if left > 0 else ""
    outside = "left out" if found.filter.leaves_out else "not left out by the filter"
    return f"{out}{heading(phrase('Outliers'))}<p>{len(wrong)} points, {outside}.</p>{html_table(head, rows)}{more}"


def _own_path_error(result: Result) -> str:
    error = result.regeneration.original_error
    if error <= PATH_ERROR_WORTH_SAYING:
        return ""
    title = heading(phrase("The program's own path error"))
    if _corrected_before(result):
        title = heading(phrase("The correction in force"))
        words = (
            f"This program was corrected before: it commands a contour up to <b>{with_unit(error)}</b> off the "
            "nominal. What the part still shows is corrected beside it; where nothing was measured it stays."
        )
    else:
        words = (
            f"The path of the program is up to <b>{with_unit(error)}</b> off the exact parallel of the nominal. This "
            "share comes from the CAM system's path, not from the machine: it is known exactly, was taken out of the "
            "deviations before filtering, and the corrected program does not have it."
        )
    if not len(result.commanded):
        return f"{title}<p>{words}</p>"
    rms = math.sqrt(float((result.commanded**2).mean()))
    row = (phrase("at the points"), *statistics_of(result.commanded), um(rms))
    return f"{title}<p>{words}</p>" + html_table((reader.fine(), *STATISTICS, phrase("rms")), [row])


def _uncertainty(result: Result) -> list[tuple[str, str]]:
    """How well the correction is known; nothing where that is not known."""
    known = result.uncertainty[np.isfinite(result.uncertainty)]
    if not len(known):
        return []
    gain, parts = result.request.settings.gain, len(result.request.measurements)
    most, typical = gain * COVERAGE * float(known.max()), gain * COVERAGE * float(np.median(known))
    seen = f"from the spread of {parts} parts" if parts > 1 else "from the scatter of the points of one part"
    return [
        (
            phrase("Uncertainty of the correction"),
            f"expanded (k = {COVERAGE:g}, about 95 %) \N{PLUS-MINUS SIGN}{with_unit(most)} at most, "
            f"\N{PLUS-MINUS SIGN}{with_unit(typical)} typically, "
            f"{seen}. No tolerance is known here, so nothing is said about conformity (ISO 14253-1)",
        )
    ]


def _correction(result: Result, largest: LargestCorrection) -> str:
    moves, proof, settings = result.regeneration, result.verification, result.request.settings
    where = f" at {coordinates(*largest.point)}, s = {mm(largest.s)} {reader.coarse()}" if largest.value else ""
    if largest.value and len(result.nominal.contours) > 1:
        where += f" on contour {largest.contour + 1}"
    side = "out of the material" if largest.value > 0 else "into the material"
    facts = [
        (
            phrase("Largest correction"),
            f"{with_unit(largest.value, True)}{where}" + (f" ({side})" if largest.value else ""),
        ),
        *_uncertainty(result),
        (
            phrase("Moves"),
            phrase(
                "{} of the program's moves changed, {} written", grouped(moves.changed), grouped(len(moves.toolpath))
            ),
        ),
        (phrase("Largest displacement of a vertex"), f"{with_unit(moves.largest_shift)}"),
    ]
    how = phrase(
        "The emitted program was read back and its path compared with the exact parallel of the compensated profile."
    )
    status = "kept" if proof.path_error_max <= settings.tolerance else "exceeded"
    checks = [
        (
            phrase("Largest path error"),
            f"{with_unit(proof.path_error_max)} at {coordinates(*proof.place)}; "
            f"tolerance {with_unit(settings.tolerance)} {status}",
        ),
        (
            phrase("Gouge"),
            phrase("{} nearer to the profile than the cutter's radius at most", with_unit(proof.gouge_max)),
        ),
        (
            phrase("Profile as NURBS"),
            phrase("within {} of the exact compensated contour", with_unit(result.fit_residual)),
        ),
        (phrase("Checked length of path"), f"{mm(proof.length)} {reader.coarse()}"),
    ]
    return (
        f"{heading(phrase('Correction'))}{html_facts(facts)}{heading(phrase('Verification'))}"
        f"<p>{reader.worded(how)}</p>{html_facts(checks)}"
    )


_SETTING_NAMES = {
    "side": phrase("Side of the cutter"),
    "align": phrase("Alignment"),
    "filter": phrase("Filter"),
    "method": phrase("Method"),
    "gain": phrase("Gain"),
    "limit": phrase("Limit of a correction"),
    "dead_band": phrase("Dead band"),
    "tolerance": phrase("Tolerance of the path"),
    "output_moves": phrase("Kinds of move written"),
    "cutter_compensation": phrase("With G41, G42 the program gives"),
    "depth_along": phrase("Depth along"),
    "transfer_function": phrase("Transfer function"),
    "leave_stock": phrase("Stock left on"),
    "keep_allowance": phrase("Allowance kept"),
    "unmeasured_share": phrase("Share that may be unmeasured"),
}
_LENGTHS = {key for key, one in options_of(Settings).items() if one.unit == "MM"}
_ELASTIC_ONLY = ("depth_along", "transfer_function")
"""Settings that say nothing where the deviation is mirrored."""


def _settings(result: Result) -> str:
    summary = result.summary()
    facts: list[tuple[str, str]] = [(phrase("Tool diameter"), reader.length(2 * result.request.radius))]
    centre = phrase("the cutter's centre")
    distance = centre if result.path_radius else phrase("the contour; the control offsets by the radius")
    facts.append((phrase("Program gives"), distance))
    given = phrase("given") if result.request.nominal is not None else phrase("the contour that the program cuts")
    facts.append((phrase("Nominal"), given))
    for name, value in summary["settings"].items():
        if value is None or value == () or (name in _ELASTIC_ONLY and result.request.settings.method == "mirror"):
            continue
        if name == "leave_stock" and not value:
            continue
        values = value if isinstance(value, tuple) else (value,)
        shown = [reader.length(v) if name in _LENGTHS else f"{v:g}" if isinstance(v, float) else str(v) for v in values]
        text = ", ".join(shown)
        facts.append((_SETTING_NAMES.get(name, name.replace("_", " ")), text))
    shift, turn = summary["alignment"]["shift"], summary["alignment"]["rotation_deg"]
    if any(shift) or turn:
        facts.append(
            (
                phrase("Aligned by"),
                f"shift X{mm(shift[0], 4)} Y{mm(shift[1], 4)} {reader.coarse()}, turn {turn:.5f} degrees",
            )
        )
    return heading(phrase("Settings")) + html_facts(facts)


def _files(result: Result, outputs: Mapping[str, str]) -> str:
    rows = "".join(
        f"<tr><th>{escape(_input(kind, result))}</th><td>{escape(str(entry['name']))}<br><span class=hash>SHA-256 "
        f"{escape(str(entry['sha256']))}</span></td></tr>"
        for kind, entry in result.inputs().items()
    )
    out = f"{heading(phrase('Inputs'))}<table class=facts><tbody>{rows}</tbody></table>"
    if outputs:
        out += heading(phrase("Outputs")) + html_facts((kind, str(path)) for kind, path in outputs.items())
    return out


def _input(kind: str, result: Result) -> str:
    return "simulated surface" if kind == "measurement" and nothing_measured(result) else kind
