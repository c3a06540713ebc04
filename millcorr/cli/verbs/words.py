# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found and done, in a few lines."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from millcorr.report.verdict import what_to_do


def in_words(summary: Mapping[str, Any], outputs: Mapping[str, str], *, checked_only: bool) -> str:
    """What to do, what was found and what was done, in a few lines; micrometres."""
    points, proof = summary["points"], summary["verification"]
    prediction = summary["foreseen"]
    lines = [": ".join(what_to_do(summary))]
    if prediction is not None and prediction["combined"] is None:
        lines += [f"points      {points['used']} of the simulated surface; nothing was measured"]
    else:
        said = f", {points['left_out']} left out" if points["left_out"] else ""
        lines += [f"points      {points['used']} used of {points['read']}{said}"]
    lines.append("um                  mean      min      max   height      std")
    for title, key in (("deviation", "deviation"), ("determined part", "filtered"), ("predicted after", "predicted")):
        row = summary[key]
        values = "".join(f"{um(row[name]):>9}" for name in ("mean", "min", "max", "height", "std"))
        lines.append(f"{title:<15}{values}")
    random, largest = um(summary["random_std"]), summary["correction"]
    random = "not known" if random == "-" else f"{random} um"
    if points["parts"] > 1:
        random += f" from part to part, {points['parts']} parts"
    at = "X{:.3f} Y{:.3f}".format(*largest["place"]) if largest["largest"] else ""
    moved = f"{largest['largest'] * 1000:+.2f} um" + (f" at {at}" if at else "")
    lines.append(f"random part std {random}; largest correction {moved}")
    lines += _elastic(summary["transfer"])
    lines.append(
        f"proof       emitted path within {um(proof['path_error_max'])} um of the compensated profile's exact parallel"
    )
    lines += [f"warning     {w}" for w in summary["warnings"]]
    lines += [f"note        {a}" for a in summary["advice"]]
    lines += [f"{name:<11} {path}" for name, path in outputs.items()]
    if checked_only:
        lines.append("check only: no program was written")
    return "\n".join(lines)


def _elastic(transfer: Mapping[str, Any] | None) -> list[str]:
    """Transfer function, and the offset that several depths tell apart from it."""
    if transfer is None:
        return []
    depth = ", ".join(f"{value:g}" for value in transfer["depth"])
    known = transfer["ms_uncertainty"]
    spread = "" if known is None or known != known else f" +- {known:.4f}"
    lines = [
        f"transfer    MS {transfer['ms_mean']:.4f} ({transfer['ms_min']:.4f} to {transfer['ms_max']:.4f}){spread}, "
        f"depth {depth} mm, next {transfer['next_depth']:.4g} mm, {transfer['taken']} along {transfer['depth_along']}"
    ]
    offset = transfer["offset"]
    if offset:
        lines.append(
            f"offset      {um(offset['mean'])} um ({um(offset['min'])} to {um(offset['max'])}) "
            f"+- {um(offset['uncertainty'])}, kept apart"
        )
    return lines


def um(value: float | None) -> str:
    """Micrometres with two decimals; a dash where there is no number."""
    return "-" if value is None or value != value else f"{value * 1000:.2f}"
