# SPDX-License-Identifier: LGPL-2.1-or-later
"""How to correct: every choice a user has, checked when it is made."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

from . import alignment
from .errors import UsageError
from .regeneration import OUTPUT_MOVES
from .separation.filters import Filter
from .toolpath import named_tool

LARGEST_TOLERANCE = 0.05
"""Path errors beyond this, in mm, are as large as the deviations worth correcting."""

METHODS = ("mirror", "transfer", "combined", "predicted")
"""How a path answers a deviation; the last two need a setup."""


@dataclass(frozen=True, slots=True)
class Settings:
    """How to correct. Lengths in mm; see the command line for the meaning of each.

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

    side: str = "auto"
    align: str = "none"
    filter: str = "auto"
    method: str = "mirror"
    gain: float = 1.0
    limit: float = 0.5
    dead_band: float = 0.0
    tolerance: float = 0.001
    output_moves: str = "keep"
    cutter_compensation: str = "contour"
    accept: tuple[str, ...] = ()
    depth: float | Sequence[float] | None = ()
    next_depth: float | None = None
    depth_along: str = "normal"
    transfer_function: str = "smooth"
    allowance: float | Sequence[float] | None = ()
    leave_stock: float = 0.0
    iterate: float | None = None
    unmeasured_share: float = 0.6
    tools: tuple[str, ...] = ()
    keep_allowance: bool = False

    def __post_init__(self) -> None:
        choices = {
            "side": ("auto", "left", "right"),
            "method": METHODS,
            "depth_along": ("normal", "x", "y"),
            "transfer_function": ("smooth", "one", "points"),
            "output_moves": OUTPUT_MOVES,
            "cutter_compensation": ("contour", "wear"),
        }
        for name, legal in choices.items():
            if getattr(self, name) not in legal:
                option = "--" + name.replace("_", "-")
                raise UsageError(f"{option} {getattr(self, name)}: choose one of {', '.join(legal)}")
        alignment.Freedom.parse(self.align)
        Filter.parse(self.filter)
        if not 0 < self.gain <= 2:
            raise UsageError(f"--gain {self.gain:g}: must be above 0 and at most 2")
        for name in ("limit", "tolerance"):
            if not getattr(self, name) > 0:
                raise UsageError(f"--{name} {getattr(self, name):g}: must be above 0")
        if self.tolerance > LARGEST_TOLERANCE:
            raise UsageError(
                f"--tolerance {self.tolerance:g}: more than {LARGEST_TOLERANCE:g} mm would hide what is to be corrected"
            )
        if not 0 <= self.unmeasured_share <= 1:
            raise UsageError(f"--unmeasured {self.unmeasured_share:g}: must be a share from 0 to 1")
        if not self.dead_band >= 0:
            raise UsageError(f"--dead-band {self.dead_band:g}: must not be negative")
        for name in ("depth", "allowance"):
            object.__setattr__(self, name, _lengths(getattr(self, name)))
        object.__setattr__(self, "tools", tuple(self.tools))
        _ = self.tool_diameters
        self._check_depths()
        self._check_iteration()

    def _check_depths(self) -> None:
        for value in self.depths:
            if not 0 < value < math.inf:
                raise UsageError(f"--depth {value:g}: must be a length above 0")
        for value in self.allowances:
            if not 0 <= value < math.inf:
                raise UsageError(f"--allowance {value:g}: must be a length, at least 0")
        if not 0 <= self.leave_stock < math.inf:
            raise UsageError(f"stock to leave {self.leave_stock:g}: must be a length, at least 0")
        if self.method == "transfer":
            if not self.depths:
                raise UsageError("--method transfer needs --depth MM, the depth that the measured part was cut at")
            if self.next_depth is not None and not 0 < self.next_depth < math.inf:
                raise UsageError(f"--next-depth {self.next_depth:g}: must be a length above 0")
            return
        for name, given in (
            ("depth", bool(self.depths) and self.method != "combined"),
            ("next-depth", self.next_depth is not None),
            ("depth-along", self.depth_along != "normal"),
            ("transfer-function", self.transfer_function != "smooth"),
        ):
            if given:
                raise UsageError(f"--{name} belongs to --method transfer, not to --method {self.method}")

    @property
    def with_setup(self) -> bool:
        """Whether the method needs a setup."""
        return self.method in ("combined", "predicted")

    def _check_iteration(self) -> None:
        if not self.with_setup:
            if self.iterate is not None:
                raise UsageError(f"--iterate belongs to --method combined or predicted, not to --method {self.method}")
            return
        if self.leave_stock:
            raise UsageError("a first cut that leaves stock is made before anything is measured or predicted")
        if self.method == "predicted" and any(self.allowances):
            raise UsageError("--allowance belongs to a measured part, --method predicted has none")
        if self.iterate is None:
            return
        if not 0 < self.iterate < math.inf:
            raise UsageError(f"--iterate {self.iterate:g}: must be a length above 0")
        if self.gain != 1.0 or self.dead_band:
            raise UsageError("--iterate takes the whole error out: it goes with neither --gain nor --dead-band")

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
                    f"--tool {text}: write the number or name and the diameter of a tool in mm, as --tool 3=16"
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

    def each(self, option: str, parts: int) -> tuple[float, ...]:
        """Depth or allowance of every measured part, mm.

        Parameters
        ----------
        option : {'depth', 'allowance'}
        parts : int
            How many parts were measured.

        Raises
        ------
        UsageError
            If more than one is given, but not one for each part.
        """
        given = self.depths if option == "depth" else self.allowances
        if len(given) > 1 and len(given) != parts:
            raise UsageError(
                f"--{option} is given {len(given)} times for {parts} measured "
                f"{'part' if parts == 1 else 'parts'}: give it once, or once for each --measured"
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


def _lengths(value: float | Sequence[float] | None) -> tuple[float, ...]:
    if value is None:
        return ()
    return tuple(float(v) for v in value) if isinstance(value, Sequence) else (float(value),)


def _listed(values: Sequence[float]) -> str:
    return " ".join(f"{v:g}" for v in values)
