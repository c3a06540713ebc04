# SPDX-License-Identifier: LGPL-2.1-or-later
"""`millcorr history`: what the journal of a series holds."""

from __future__ import annotations

from pathlib import Path

from millcorr.errors import UsageError
from millcorr.production import history as histories
from millcorr.production import journal as journals
from millcorr.report import history as report_history
from millcorr.whole_file import refuse_places, write_whole


def history(journal: Path | None = None, *, csv: Path | None = None, report: Path | None = None) -> str:
    """What a journal of a series holds, as a table; and as files.

    Parameters
    ----------
    journal : Path, optional
        By default the only ``*.journal`` in the current directory.
    csv : Path, optional
        File for every entry.
    report : Path, optional
        Directory for history.html and history.csv.

    Raises
    ------
    MillcorrError
        If the journal cannot be read, or a place cannot be written to.
    """
    if journal is None:
        found = sorted(Path().glob("*.journal"))
        if len(found) != 1:
            there = ", ".join(path.name for path in found) or "none"
            raise UsageError(f"name the journal: in this directory there is {there}")
        journal = found[0]
    refuse_places({"csv": csv}, {"journal": journal}, report, report_history.FILES)
    if csv is not None:
        histories.refuse_other_file(csv)
    chains = journals.read(journal)
    lines = [histories.table(chains)]
    if csv is not None:
        write_whole(csv, "".join(histories.csv_lines(chains)))
        lines.append(f"csv         {csv}")
    if report is not None:
        lines.append(f"report      {report_history.write(chains, journal, report)[0]}")
    return "\n".join(lines)
