# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the pages of all reports share: looks, numbers in words, tables, figures."""

from __future__ import annotations

import datetime
import math
from collections.abc import Iterable, Sequence
from html import escape

from millcorr import __version__
from millcorr.arrays import Floats
from millcorr.comparison.deviation import statistics
from millcorr.messages import phrase

from . import reader
from .length_unit import MM
from .plots import COLOURS, STYLE, Plot

MINUS, DASH, DOT = "\N{MINUS SIGN}", "\N{EN DASH}", "\N{MIDDLE DOT}"


def html_page(
    kind: str,
    name: str,
    parts: Iterable[str],
    *,
    about: str,
    files: str,
    date: datetime.date | None = None,
    style: str = "",
    scripts: str = "",
) -> str:
    """A page that needs nothing but itself: no font, no network, and no script but its own.

    Parameters
    ----------
    kind : str
        What kind of report it is, above the name.
    name : str
        Of what is reported.
    parts : iterable of str
        Parts of the page as HTML, in order; empty ones are left out.
    about : str
        Behind the name in the window's title.
    files : str
        What the files beside the page hold, as HTML, for its foot.
    date : datetime.date, optional
        Today by default.
    style : str
        Rules of its own.
    scripts : str
        Elements with scripts and their data; without, the page forbids scripts.
    """
    version = f"millcorr {escape(__version__)}"
    allowed = "default-src 'none'; style-src 'unsafe-inline'" + ("; script-src 'unsafe-inline'" if scripts else "")
    body = [
        f"<header><p class=kind>{escape(reader.worded(kind))}</p><h1>{escape(name)}</h1>"
        f"<p class=meta>{(date or datetime.date.today()).isoformat()} {DOT} {version}</p></header>",
        *parts,
        f"<footer><p>{files} Made by {version}.</p></footer>",
    ]
    return (
        "<!DOCTYPE html>\n<html lang=en><head><meta charset=utf-8>"
        f'<meta http-equiv=Content-Security-Policy content="{allowed}">'
        "<meta name=viewport content='width=device-width,initial-scale=1'>"
        f"<meta name=color-scheme content='light dark'><title>{escape(name)}: {about}</title>"
        f"<style>{_style()}{style}</style></head>\n<body><main>\n"
        + "\n".join(part for part in body if part)
        + f"\n</main>{scripts}</body></html>\n"
    )


def _style() -> str:
    """Style sheet of a page: light, dark and paper."""

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


def um(value: float, signed: bool = False) -> str:
    """A deviation given in mm, in the reader's small unit: micrometres with two decimals."""
    if not math.isfinite(value):
        return DASH
    digits = 1 + reader.unit().fine_digits
    text = f"{value * reader.fine_per_mm():{'+' if signed else ''}.{digits}f}"
    if float(text) == 0:
        text = f"{0.0:.{digits}f}"
    return text.replace("-", MINUS)


STATISTICS = (phrase("mean"), phrase("min"), phrase("max"), phrase("height"), phrase("std"))
"""Heads of what `statistics_of` gives."""


def statistics_of(value: Floats) -> tuple[str, ...]:
    """Statistics of deviations given in mm, (n,), as cells of a table in the reader's small unit."""
    s = statistics(value)
    return *(um(s[key], True) for key in ("mean", "min", "max")), um(s["height"]), um(s["std"])


def with_unit(value: float, signed: bool = False) -> str:
    """The same with the unit's name."""
    return f"{um(value, signed)} {reader.fine()}"


def mm(value: float, digits: int = 3) -> str:
    """A length given in mm, in the reader's unit, to the last digit of one in mm; or a dash."""
    digits += reader.unit().digits - MM.digits
    return f"{value / reader.unit().mm:.{digits}f}".replace("-", MINUS) if math.isfinite(value) else DASH


def coordinates(x: float, y: float) -> str:
    """A place as a machinist writes it."""
    return f"X{mm(x)} Y{mm(y)}"


def grouped(count: int) -> str:
    """A whole number in groups of three digits."""
    return f"{count:,}".replace(",", "\N{NARROW NO-BREAK SPACE}")


def capital(said: str) -> str:
    """A message in the reader's words, as a sentence begins."""
    text = reader.worded(said)
    return text[:1].upper() + text[1:]


def plural(count: int, thing: str) -> str:
    """So many things."""
    return f"{grouped(count)} {thing}{'' if count == 1 else 's'}"


def heading(title: str) -> str:
    """Heading of a section, in the reader's words."""
    return f"<h2>{escape(reader.worded(title))}</h2>"


def html_table(head: Sequence[str], rows: Iterable[Sequence[str]], css: str = "numbers") -> str:
    """Table of escaped cells in the reader's words, the first of each row its name."""
    top = "".join(f"<th>{escape(reader.worded(cell))}</th>" for cell in head)
    body = "".join(
        f"<tr><th>{escape(reader.worded(row[0]))}</th>"
        + "".join(f"<td>{escape(reader.worded(cell))}</td>" for cell in row[1:])
        + "</tr>"
        for row in rows
    )
    header = f"<thead><tr>{top}</tr></thead>" if head else ""
    return f"<table class={css}>{header}<tbody>{body}</tbody></table>"


def html_notes(notes: Iterable[str]) -> str:
    """Statements for the top of a page."""
    return "".join(f"<p class=note>{escape(reader.worded(note))}</p>" for note in notes)


def html_tiles(tiles: Iterable[tuple[str, str]]) -> str:
    """Figures to see at once, each with what it is."""
    inner = "".join(
        f"<div class=tile><b>{escape(reader.worded(v))}</b><span>{escape(reader.worded(what))}</span></div>"
        for v, what in tiles
    )
    return f"<div class=tiles>{inner}</div>"


def html_facts(rows: Iterable[tuple[str, str]]) -> str:
    """Table of names and what they are."""
    return html_table((), rows, "facts")


def figure(plot: Plot) -> str:
    """A drawing with its caption."""
    return f"<figure class=plot>{plot.svg}<figcaption>{escape(plot.caption)}</figcaption></figure>"
