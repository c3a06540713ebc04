# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a journal says: a table for the console, lines of CSV, and the trends and jumps of a series."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from millcorr.arrays import Floats
from millcorr.errors import UsageError
from millcorr.messages import option, phrase

from . import trend
from .form import shared_form
from .journal import Chain, Entry
from .trend import Change

KEPT = phrase("NOT CORRECTED")

DECISIONS = {
    "correct": phrase("corrected"),
    "direct": phrase("corrected by its own deviation"),
    "smoothed": phrase("corrected by the smoothed deviation"),
    "keep": KEPT,
}
"""What a decision is called."""

COLUMNS = (
    "chain",
    "part",
    "time",
    "status",
    "measured",
    "fingerprint",
    "program",
    "program_sha256",
    "next",
    "next_sha256",
    "corrected",
    "decision",
    "reason",
    "points",
    "mean",
    "min",
    "max",
    "height",
    "std",
    "determined",
    "smoothed",
    "correction",
    "machine_mean",
    "machine_x",
    "machine_y",
    "machine_form",
)
"""Columns of the CSV export; lengths in mm, later versions only append."""


def decision_in_words(entry: Entry) -> str:
    """What became of a part; a program that stayed is never called corrected."""
    if entry.pending:
        return phrase("PENDING: the next run that uses the journal settles it")
    return DECISIONS[entry.decision] if entry.corrected else KEPT


def table(chains: Sequence[Chain]) -> str:
    """The journal as text, micrometres; a block for every first program."""
    blocks = []
    for chain in chains:
        lines = [
            f"{chain.name} (first program {chain.first}), {len(chain.entries)} "
            f"{'part' if len(chain.entries) == 1 else 'parts'}; um",
            "part  time                     mean      std   height  largest smoothed  correction  decision",
        ]
        for entry in chain.entries:
            s = entry.statistics
            row = s["deviation"]
            values = f"{_um(row['mean']):>9}{_um(row['std']):>9}{_um(row['height']):>9}{_um(s['determined']):>9}"
            smoothed = _um(s.get("smoothed", math.nan))
            lines.append(
                f"{entry.part:>4}  {entry.time:<20}{values}{smoothed:>9}{_um(s['correction']):>12}  "
                + decision_in_words(entry)
            )
        lines += [f"      {line}" for line, _ in series(chain.entries)]
        blocks.append("\n".join(lines))
    return "\n\n".join(blocks) if blocks else "the journal has no part yet"


def csv_lines(chains: Sequence[Chain]) -> Iterator[str]:
    """Lines of the CSV export, the header first; empty cells for what is not known."""
    yield ",".join(COLUMNS) + "\n"
    for chain in chains:
        forms = machine(chain.entries)[trend.FORM][0]
        for entry, form in zip(chain.entries, forms, strict=True):
            s = entry.statistics
            row = s["deviation"]
            numbers = [row[name] for name in ("mean", "min", "max", "height", "std")]
            numbers += [s["determined"], s.get("smoothed", math.nan), s["correction"]]
            numbers += [*(s["components"][name] for name in trend.COMPONENTS), form]
            cells = [
                chain.first,
                entry.part,
                entry.time,
                "pending" if entry.pending else "done",
                " ".join(name for name, _ in entry.measurements),
                " ".join(fingerprint for _, fingerprint in entry.measurements),
                *entry.before,
                *entry.after,
                int(entry.corrected),
                entry.decision,
                entry.reason,
                s["points"],
                *(f"{v:.12g}" if math.isfinite(v) else "" for v in numbers),
            ]
            out = io.StringIO()
            csv.writer(out, lineterminator="\n").writerow(cells)
            yield out.getvalue()


def refuse_other_file(path: Path) -> None:
    """UsageError where a CSV export would replace anything but an older one: a program, a journal, measured points."""
    if not path.is_file():
        return
    header = ",".join(COLUMNS[:3]).encode("ascii")
    with open(path, "rb") as file:
        begin = file.read(len(header))
    if begin not in (header, b""):
        raise UsageError(
            phrase("{} is no table of a journal and stays untouched: name another file", option("csv", path))
        )


def changes(entries: Sequence[Entry]) -> list[tuple[str, Change]]:
    """Trends and jumps of what the machine does, as (component, change), in the order in which they were seen.

    Parts of the uncorrected program are not compared with later ones: of their correction, the largest of all, an
    elastic machine gives back most.
    """
    first, quantities, out = _uncorrected(entries), machine(entries), []
    for begin, end in ((0, first), (first, len(entries))):
        for component, (value, commanded) in quantities.items():
            found = trend.changes(
                value[begin:end], commanded[begin:end], false_alarms=trend.FALSE_ALARMS / len(quantities)
            )
            out += [(component, replace(c, part=c.part + begin, last=c.last + begin)) for c in found]
    return sorted(out, key=lambda pair: pair[1].last)


def machine(entries: Sequence[Entry]) -> dict[str, tuple[Floats, Floats]]:
    """What the machine does, and what its program commanded, by component: (n,) mm each; NaN where not known.

    The form is that which the parts of the uncorrected program share, and that which all later ones do.
    """
    out = {}
    for component in trend.COMPONENTS:
        value, commanded = (
            np.array([float(e.statistics[of][component]) for e in entries]) for of in ("components", "commanded")
        )
        out[component] = value, commanded
    first = _uncorrected(entries)
    groups = [shared_form([e.points for e in group]) for group in (entries[:first], entries[first:])]
    value, commanded = (np.concatenate(column) for column in zip(*groups, strict=True))
    out[trend.FORM] = value, commanded
    return out


def _uncorrected(entries: Sequence[Entry]) -> int:
    """Number of parts that were cut with the uncorrected program."""
    return next((k for k, entry in enumerate(entries, 1) if entry.corrected), len(entries))


def series(entries: Sequence[Entry]) -> list[tuple[str, bool]]:
    """Trends and jumps, one line each, and whether the last part shows it.

    Parameters
    ----------
    entries : sequence of Entry
        In order; the last one need not be numbered yet.
    """
    numbers = [entry.part or len(entries) for entry in entries]
    return [
        (trend.in_words(change, component, numbers), change.last == len(entries) - 1)
        for component, change in changes(entries)
    ]


def _um(value: float) -> str:
    return f"{value * 1000:.2f}" if math.isfinite(value) else "-"
