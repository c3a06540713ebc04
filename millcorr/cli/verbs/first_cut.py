# SPDX-License-Identifier: LGPL-2.1-or-later
"""`millcorr split`: the program of a first cut."""

from __future__ import annotations

from pathlib import Path

from millcorr import nc
from millcorr.correction.settings import Settings
from millcorr.messages import message, option, remedy
from millcorr.production.split import split
from millcorr.whole_file import refuse_places, replaced_whole

from .inputs import nominal_file, read_nominal
from .words import um


def split_program(
    program: Path,
    *,
    tool_diameter: float,
    depth: float,
    output: Path,
    at: float = 0.5,
    nominal: str | None = None,
    settings: Settings | None = None,
) -> str:
    """Write the program of a first cut, which leaves a part of the allowance on the finished contour.

    Parameters
    ----------
    program : Path
        Program that finishes the part.
    tool_diameter, depth : float
        Cutter, and whole allowance over the finished contour, mm.
    at : float
        Share of the allowance that the first cut takes.
    nominal : str, optional
        Profile, where the program cannot show it.
    output : Path
    settings : Settings, optional

    Returns
    -------
    str
        What was done, and how to go on.

    Raises
    ------
    MillcorrError
        See `millcorr.production.split.split`; nothing is written then.
    """
    refuse_places({"output": output}, {"program": program, "nominal": nominal_file(nominal)})
    chosen, radius = settings or Settings(), tool_diameter / 2
    profile = None if nominal is None else read_nominal(nominal, radius, chosen, None)
    done = split(nc.read(program), radius, depth, at, settings=chosen, nominal=profile)
    proof = done.result.verification
    side = "" if chosen.side == "auto" else message(" ", option("side", chosen.side))
    with replaced_whole(output, done.result.text):
        pass
    return "\n".join(
        [
            f"first cut   takes {done.depth:g} mm and leaves {done.left:g} mm of {depth:g} mm",
            f"proof       emitted path within {um(proof.path_error_max)} um of its exact parallel",
            message(
                "then        measure, and correct ",
                option("program", program),
                " ",
                option("tool_diameter", tool_diameter),
                side,
                " ",
                option("measured", of="FILE"),
                " ",
                option("points", of="KIND"),
                " ",
                remedy("method", "transfer"),
                " ",
                option("depth", done.depth),
                " ",
                option("allowance", done.left),
                " ",
                option("output", of="SECOND.nc"),
            ),
            f"program     {output}",
        ]
    )
