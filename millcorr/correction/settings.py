# SPDX-License-Identifier: LGPL-2.1-or-later
"""How to correct: every choice a user has, checked when it is made."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

from millcorr.comparison import alignment
from millcorr.errors import UsageError
from millcorr.messages import Message, message, mm, option, phrase
from millcorr.nc.toolpath import named_tool
from millcorr.options import declared, options_of
from millcorr.separation.filters import Filter

LARGEST_TOLERANCE = 0.05
"""Path errors beyond this, in mm, are as large as the deviations worth correcting."""

METHODS = ("mirror", "transfer", "combined", "predicted")
"""How a path answers a deviation."""

WITH_SETUP = ("combined", "predicted")
"""Those that simulate, and need a setup."""

PROGRAM, MEASURED, CORRECTION = "the program", "the measurement", "the correction"
TRANSFER, MODEL, WRITTEN = "transfer function", "model of the cut", "what is written"
"""Headings under which options stand."""


@dataclass(frozen=True, slots=True)
class Settings:
    """How to correct. Lengths in mm; what each means is declared on it.

    Depths and allowances may be given as a number or as a sequence, one for each measured part; they are kept as
    tuples.

    Parameters
    ----------
    side, align, filter, method, output_moves, cutter_compensation : str
    gain, limit, dead_band, tolerance : float
    accept : tuple of str
        Findings that are right as they are.
    depth : tuple of float
        Depth H along the normal that the measured parts were cut at: from the stock to the surface that their
        program should make. One for all parts or one each; empty without a transfer function.
    next_depth : float, optional
        Stock over the nominal that the corrected program will find. By default the same depth; with an allowance
        what the measured part still has on it.
    depth_along : {'normal', 'x', 'y'}
        How deviations are taken for the transfer function, see `transfer_function.along_axis`.
    transfer_function : {'smooth', 'one', 'points'}
        Transfer function from the filtered deviations along the contour, their mean, or point by point.
    allowance : tuple of float
        Stock that the program of the measured parts left over the nominal, one for all or one each; empty for 0.
    leave_stock : float
        Stock that the written program leaves over the nominal: a first cut, before anything is measured.
    tools : tuple of str
        Diameters of other tools of the program, each ``T=MM`` with the tool's number or name.
    keep_allowance : bool
        Passes that rough along the contour, leaving up to `limit` on it, are moved with it, each by its own radius.
    unmeasured_share : float
        Largest share of a contour that may lie farther from any point than the form hangs together; more is refused.
    iterate : float, optional
        Go on simulating and correcting until the predicted error is at most this, in mm; by default one correction,
        simulated once. For the methods with a setup.
    """

    side: str = declared(
        "auto", "side of the contour on which the cutter runs", choices=("auto", "left", "right"), group=PROGRAM
    )
    align: str = declared(
        "none",
        "best fit before comparing: none, shift, rigid, or some of x, y, turn joined by +; then :zone or :all",
        type=str,
        unit="FIT",
        group=MEASURED,
    )
    filter: str = declared(
        "auto",
        "what separates form from scatter: none, mean:5, mean:1,2,3,2,1, gauss:MM, robust:MM, auto",
        type=str,
        unit="F",
        group=CORRECTION,
    )
    method: str = declared("mirror", "how to correct", choices=METHODS, group=CORRECTION)
    gain: float = declared(
        1.0, "share of the deviation to correct", unit="SHARE", above=0.0, most=2.0, group=CORRECTION
    )
    limit: float = declared(0.5, "largest correction", unit="MM", above=0.0, group=CORRECTION)
    dead_band: float = declared(0.0, "leave smaller deviations", unit="MM", least=0.0, group=CORRECTION)
    tolerance: float = declared(0.001, "largest path error", unit="MM", above=0.0, group=WRITTEN)
    output_moves: str = declared(
        "keep", "kinds of move to write", choices=("keep", "lines", "arcs", "nurbs"), group=WRITTEN
    )
    cutter_compensation: str = declared(
        "contour",
        "what a program with G41/G42 gives: the contour, or the centre path",
        choices=("contour", "wear"),
        group=PROGRAM,
    )
    accept: tuple[str, ...] = declared(
        (), "accept a finding that would stop the correction", type=str, unit="NAME", group=MEASURED
    )
    depth: float | Sequence[float] | None = declared(
        (),
        "depth along the normal at which the measured part was cut; once, or once for each part",
        unit="MM",
        above=0.0,
        group=TRANSFER,
        methods=("transfer", "combined"),
    )
    next_depth: float | None = declared(
        None,
        "depth that the corrected program will cut (default: that of the measured part)",
        unit="MM",
        above=0.0,
        group=TRANSFER,
        methods=("transfer",),
    )
    depth_along: str = declared(
        "normal",
        "how deviations are taken for the transfer function: along the normal, or along x or y",
        choices=("normal", "x", "y"),
        group=TRANSFER,
        methods=("transfer",),
    )
    transfer_function: str = declared(
        "smooth",
        "transfer function smooth along the contour, as one value, or one a point",
        choices=("smooth", "one", "points"),
        group=TRANSFER,
        methods=("transfer",),
    )
    allowance: float | Sequence[float] | None = declared(
        (),
        "stock that the program of the measured parts left over the nominal; once, or once for each part",
        unit="MM",
        least=0.0,
        group=TRANSFER,
        methods=("mirror", "transfer", "combined"),
    )
    leave_stock: float = declared(
        0.0, "stock that the written program leaves over the nominal: a first cut", unit="MM", least=0.0, group=WRITTEN
    )
    iterate: float | None = declared(
        None,
        "simulate and correct again until the predicted error is at most this",
        unit="MM",
        above=0.0,
        group=MODEL,
        methods=WITH_SETUP,
    )
    unmeasured_share: float = declared(
        0.6,
        "largest share of a contour without points near that is corrected all the same",
        unit="SHARE",
        least=0.0,
        most=1.0,
        group=CORRECTION,
    )
    tools: tuple[str, ...] = declared(
        (),
        "number or name, and diameter, of another tool of the program, where its comments do not say it",
        type=str,
        unit="T=MM",
        group=PROGRAM,
    )
    keep_allowance: bool = declared(
        False, "move what roughs along the contour with it, so that its allowance stays", type=bool, group=PROGRAM
    )

    def __post_init__(self) -> None:
        for name in ("depth", "allowance"):
            object.__setattr__(self, name, _lengths(getattr(self, name)))
        object.__setattr__(self, "tools", tuple(self.tools))
        for one in options_of(Settings).values():
            value = getattr(self, one.key)
            one.refuse(value)
            if value != one.default and not one.counts_with(self.method):
                raise UsageError(
                    phrase(
                        "{} belongs to {}, not to {}",
                        option(one.key),
                        _either(one.methods),
                        option("method", self.method),
                    )
                )
        alignment.Freedom.parse(self.align)
        Filter.parse(self.filter)
        if self.tolerance > LARGEST_TOLERANCE:
            raise UsageError(
                phrase(
                    "{}: more than {} would hide what is to be corrected",
                    option("tolerance", self.tolerance),
                    mm(LARGEST_TOLERANCE, "g"),
                ),
            )
        _ = self.tool_diameters
        if self.method == "transfer" and not self.depths:
            raise UsageError(
                phrase(
                    "{} needs {}, the depth that the measured part was cut at",
                    option("method", "transfer"),
                    option("depth", of="MM"),
                ),
            )
        if self.with_setup and self.leave_stock:
            raise UsageError(phrase("a first cut that leaves stock is made before anything is measured or predicted"))
        if self.iterate is not None and (self.gain != 1.0 or self.dead_band):
            raise UsageError(
                phrase(
                    "{} takes the whole error out: it goes with neither {} nor {}",
                    option("iterate"),
                    option("gain"),
                    option("dead_band"),
                ),
            )

    @property
    def with_setup(self) -> bool:
        """Whether the method needs a setup."""
        return self.method in WITH_SETUP

    @property
    def tool_diameters(self) -> tuple[tuple[int, float], ...]:
        """Numbers (`named_tool`) and diameters of the tools that are stated apart, mm.

        Raises
        ------
        UsageError
            If one is no number or name, and diameter.
        """
        out = []
        for text in self.tools:
            tool, _, diameter = text.rpartition("=")
            # As a program may call it, too: T3, T="ROUGH".
            tool = re.sub(r'^T(?=\d+$|\s*=?\s*")[\s=]*', "", tool.strip(), flags=re.IGNORECASE).strip('"')
            try:
                value = float(diameter)
            except ValueError:
                value = 0.0
            if not tool or not 0 < value < math.inf:
                raise UsageError(
                    phrase(
                        "{}: write the number or name and the diameter of a tool in mm, as {}",
                        option("tools", text),
                        option("tools", of="3=16"),
                    ),
                )
            out.append((named_tool(tool.encode()), value))
        return tuple(out)

    @property
    def depths(self) -> tuple[float, ...]:
        """Depths that the measured parts were cut at, mm."""
        return _lengths(self.depth)

    @property
    def allowances(self) -> tuple[float, ...]:
        """Stock that their program left over the nominal, mm."""
        return _lengths(self.allowance)

    def each(self, key: str, parts: int) -> tuple[float, ...]:
        """Depth or allowance of every measured part, mm.

        Parameters
        ----------
        key : {'depth', 'allowance'}
        parts : int
            How many parts were measured.

        Raises
        ------
        UsageError
            If more than one is given, but not one for each part.
        """
        given = self.depths if key == "depth" else self.allowances
        if len(given) > 1 and len(given) != parts:
            raise UsageError(
                phrase(
                    "{} is given {} times and measured parts {}: give it once, or once for each {}",
                    option(key),
                    len(given),
                    parts,
                    option("measured"),
                ),
            )
        return given if len(given) > 1 else (given or (0.0,)) * parts

    def in_words(self) -> str:
        """The settings that shape a correction, in one line."""
        words = f"method {self.method}"
        if self.method == "transfer":
            words += f" depth {_listed(self.depths)}"
            words += "" if self.next_depth is None else f" next depth {self.next_depth:g}"
            words += f" along {self.depth_along} taken {self.transfer_function}"
        if self.method == "combined" and self.depths:
            words += f" depth {_listed(self.depths)}"
        words += "" if self.iterate is None else f" iterated to {self.iterate:g}"
        words += f" allowance {_listed(self.allowances)}" if any(self.allowances) else ""
        return (
            f"{words} filter {self.filter} gain {self.gain:g} dead band {self.dead_band:g} "
            f"limit {self.limit:g} tolerance {self.tolerance:g} moves {self.output_moves} align {self.align}"
            + (f" accepted {' '.join(self.accept)}" if self.accept else "")
        )


@dataclass(frozen=True, slots=True)
class Exports:
    """What is exported beside a report.

    Parameters
    ----------
    export : tuple of str
    zone : float, optional
        Tolerance zone of the profile (ISO 1101), half of it to either side of the nominal.

    Raises
    ------
    UsageError
        If a kind is unknown, the zone is no width, or QIF is wanted without one: its schema has no profile without.
    """

    export: tuple[str, ...] = declared(
        (),
        "beside the report: deviations and decisions as Q-DAS, QIF 3.0 or table with decimal comma; give several",
        choices=("dfq", "qif", "csv"),
        group=WRITTEN,
    )
    zone: float | None = declared(
        None,
        "width of the profile's tolerance zone, by which exported points pass or fail",
        unit="MM",
        above=0.0,
        group=WRITTEN,
    )

    def __post_init__(self) -> None:
        for one in options_of(Exports).values():
            one.refuse(getattr(self, one.key))
        if "qif" in self.export and self.zone is None:
            raise UsageError(
                phrase(
                    "{} qif needs {}, the width of the profile's tolerance zone on the drawing",
                    option("export"),
                    option("zone", of="MM"),
                ),
            )


def _lengths(value: float | Sequence[float] | None) -> tuple[float, ...]:
    if value is None:
        return ()
    return tuple(float(v) for v in value) if isinstance(value, Sequence) else (float(value),)


def _either(methods: Sequence[str]) -> Message:
    """Method combined or predicted, as an option names it."""
    first, *others = methods
    return message(option("method", first), *(phrase(" or {}", other) for other in others))


def _listed(values: Sequence[float]) -> str:
    return " ".join(f"{v:g}" for v in values)
