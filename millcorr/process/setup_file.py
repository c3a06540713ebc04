# SPDX-License-Identifier: LGPL-2.1-or-later
"""The setup of a machining operation: tool, material, machine and stock, written down once as TOML.

Predictors read what they need from it. Every key carries its unit in its name; a key that is not known, missing
or out of range ends in one line that names it.
"""

from __future__ import annotations

import difflib
import math
import tomllib
from dataclasses import MISSING, dataclass, field, fields
from pathlib import Path
from types import UnionType
from typing import Any, TypeVar, get_args, get_type_hints

from millcorr.errors import FormatError, UsageError
from millcorr.messages import message, mm, phrase

EFFECTIVE_DIAMETER = 0.8
"""A fluted shank bends like a solid one of 0.8 times its diameter (dat-2025, eq. 4)."""

STOCK_ENDS = ("with the part", "goes on")
"""What the stock does beyond the ends of an open contour."""

_LARGEST_FILE = 1 << 20

Table = TypeVar("Table")


def _key(
    low: float = 0.0, high: float = math.inf, *, default: Any = MISSING, open_: bool = True, hint: str = ""
) -> Any:
    """A numeric key with its range; `open_` where the lower bound itself is out of range."""
    return field(default=default, metadata={"low": low, "high": high, "open": open_, "hint": hint})


@dataclass(frozen=True, slots=True)
class Tool:
    """End mill and how it runs.

    Parameters
    ----------
    diameter_mm : float
    flutes : int
    spindle_rpm : float
        Spindle speed in 1/min.
    helix_deg : float
        Helix angle; 0 for straight flutes.
    overhang_mm : float, optional
        From the holder to the tip.
    youngs_modulus_gpa : float
        Of the shank: about 600 for carbide, 210 for high-speed steel.
    effective_diameter_factor : float
        The fluted shank bends like a solid one of so many diameters (dat-2025, eq. 4).
    stiffness_n_per_mm : float, optional
        Measured stiffness at the tip, in place of the one that follows from the shank.
    rotation : {"clockwise", "anticlockwise"}
        As M3 or M4 turn it, seen from the spindle towards the part.
    radius_error_mm : float
        By how much the cutter's radius is larger than half of `diameter_mm`, which the program was made for; measured
        standing, at the mean of its teeth.
    runout_mm : float
        Eccentricity of the teeth about the spindle's axis: half of what an indicator shows over a turn.
    runout_deg : float
        From the direction of the eccentricity to a tooth, in the sense in which the teeth follow each other.
    """

    diameter_mm: float = _key(high=1000.0)
    flutes: int = _key(1, 100, open_=False)
    spindle_rpm: float = _key(high=1e6)
    helix_deg: float = _key(0.0, 75.0, default=0.0, open_=False)
    overhang_mm: float | None = _key(high=2000.0, default=None)
    youngs_modulus_gpa: float = _key(
        10.0, 2000.0, default=600.0, hint=phrase("GPa: 600 for carbide, 210 for high-speed steel")
    )
    effective_diameter_factor: float = _key(0.1, 1.0, default=EFFECTIVE_DIAMETER, open_=False)
    stiffness_n_per_mm: float | None = _key(
        1.0, 1e7, default=None, hint=phrase("N/mm: an end mill has 500 to 100000 (1 N/um = 1000 N/mm)")
    )
    rotation: str = field(default="clockwise", metadata={"one_of": ("clockwise", "anticlockwise")})
    radius_error_mm: float = _key(-1.0, 1.0, default=0.0, open_=False, hint=phrase("mm, not um"))
    runout_mm: float = _key(0.0, 0.5, default=0.0, open_=False, hint=phrase("mm, not um"))
    runout_deg: float = _key(-360.0, 360.0, default=0.0, open_=False)

    @property
    def radius(self) -> float:
        """Radius in mm that the program was made for."""
        return self.diameter_mm / 2

    @property
    def tooth_offsets(self) -> tuple[float, ...]:
        """How much farther out than their mean the teeth run, in the order in which they cut, mm."""
        first, pitch = math.radians(self.runout_deg), 2 * math.pi / self.flutes
        return tuple(self.runout_mm * math.cos(first + pitch * j) for j in range(self.flutes))

    @property
    def oversize(self) -> float:
        """How much farther than `radius` the cutter cuts, mm: its radius' error, and its outermost tooth."""
        return self.radius_error_mm + max(self.tooth_offsets)

    @property
    def cutting_radius(self) -> float:
        """Radius of what the turning cutter sweeps, mm."""
        return self.radius + self.oversize

    @property
    def tooth_frequency(self) -> float:
        """Teeth a second."""
        return self.spindle_rpm / 60.0 * self.flutes


@dataclass(frozen=True, slots=True)
class Material:
    """Cutting coefficients of one tool and work material, linear-edge model (Altintas).

    Give the four coefficients, or `ks_n_per_mm2` and `mu`: then Ktc = Ks, Krc = mu Ks and there is no edge force,
    so that the resultant is ``sqrt(1 + mu^2) Ks S`` (dat-2025, eqs. 5, 6).

    Parameters
    ----------
    name : str
    ktc_n_per_mm2, krc_n_per_mm2 : float
        Tangential and radial force per undeformed chip area, N/mm^2.
    kte_n_per_mm, kre_n_per_mm : float
        Edge force per length of cutting edge, N/mm.
    origin : str
        Where the numbers come from. Without a calibration on the machine they are good to a factor of two.
    calibrated : bool
        True where they were measured with this tool and material.
    """

    name: str = ""
    ktc_n_per_mm2: float = _key(10.0, 1e5, default=math.nan, hint=phrase("N/mm2: 500 to 5000 for metals"))
    krc_n_per_mm2: float = _key(-1e5, 1e5, default=math.nan)
    kte_n_per_mm: float = _key(0.0, 1000.0, default=0.0, open_=False)
    kre_n_per_mm: float = _key(0.0, 1000.0, default=0.0, open_=False)
    origin: str = ""
    calibrated: bool = False

    def caution(self) -> str:
        """What to say about numbers that were not calibrated; empty where they were."""
        if self.calibrated:
            return ""
        return phrase(
            "cutting coefficients of {} are not calibrated on this machine ({}): forces are good to a factor of two",
            self.name or phrase("the material"),
            self.origin or phrase("origin not stated"),
        )


@dataclass(frozen=True, slots=True)
class Machine:
    """Machine: stiffness between tool and part, and how its axes move.

    Parameters
    ----------
    kx_n_per_mm, ky_n_per_mm : float, optional
        Stiffness of the whole loop, tool included, along X and Y (petrakov-2023, fig. 1).
    acceleration_time_x_ms, acceleration_time_y_ms : float
        Time constant of acceleration and deceleration of each axis; 0 for none.
    acceleration_shape : {"linear", "bell", "exponential"}
        What the time constant is one of: a change of speed of that length at one acceleration, or at one that rises
        and falls along lines; or a lag.
    contour_control : bool
        True where the control keeps the path by slowing down (dat-2025).
    contour_time_slope_ms_per_mm_min, contour_time_offset_ms : float
        Accuracy-maintenance time ``T = slope v_f + offset`` with v_f in mm/min (dat-2025, eq. 1).
    contour_speed_change_mm_min : float, optional
        Largest sudden change of speed of one axis where two blocks meet, which sets the feed at a corner. A parameter
        of the control (Fanuc: No. 1783); needed with contour control.
    position_gain_per_s : float, optional
        Kv of the position loop.
    stiffness_along : tuple of (s, kx, ky)
        Stiffness at arc lengths of the nominal's one contour, in mm and N/mm, where it is not the same everywhere (a
        thin wall): s ascending. In between the compliance is linear, round a closed contour, too; beyond the first and
        the last of an open one it stays. `kx_n_per_mm` and `ky_n_per_mm` are then those that are printed.
    wall_over_height : tuple of (height, kx, ky)
        Stiffness of the part's wall alone, in N/mm, at heights above the deepest tip, in mm and ascending: a wall that
        stands free at its top. Besides the tool and the machine, and only for the wall over its height; in between
        the compliance is linear, beyond the ends it stays.
    origin : str
        Where the stiffness comes from; said wherever figures rest on it.
    """

    kx_n_per_mm: float | None = _key(1.0, 1e7, default=None, hint=phrase("N/mm (1 N/um = 1000 N/mm)"))
    ky_n_per_mm: float | None = _key(1.0, 1e7, default=None, hint=phrase("N/mm (1 N/um = 1000 N/mm)"))
    acceleration_time_x_ms: float = _key(0.0, 10_000.0, default=0.0, open_=False)
    acceleration_time_y_ms: float = _key(0.0, 10_000.0, default=0.0, open_=False)
    acceleration_shape: str = field(default="linear", metadata={"one_of": ("linear", "bell", "exponential")})
    contour_control: bool = False
    contour_time_slope_ms_per_mm_min: float = _key(0.0, 10.0, default=0.0062, open_=False)
    contour_time_offset_ms: float = _key(0.0, 10_000.0, default=39.226, open_=False)
    contour_speed_change_mm_min: float | None = _key(
        0.0, 100_000.0, default=None, hint=phrase("mm/min: the feed difference that the control allows at a corner")
    )
    position_gain_per_s: float | None = _key(
        0.1, 10_000.0, default=None, hint=phrase("1/s, not (m/min)/mm: Kv 1 is 16.67/s")
    )
    stiffness_along: tuple[tuple[float, float, float], ...] = ()
    wall_over_height: tuple[tuple[float, float, float], ...] = ()
    origin: str = ""

    def caution(self) -> str:
        """Where the stiffness comes from, in words; empty where that is not stated or there is none."""
        if not self.origin or self.kx_n_per_mm is None or self.ky_n_per_mm is None:
            return ""
        return phrase("stiffness of {:g} and {:g} N/mm: {}", self.kx_n_per_mm, self.ky_n_per_mm, self.origin)

    def stiffness(self, source: str = "") -> tuple[float, float]:
        """Stiffnesses (kx, ky) in N/mm; UsageError, naming the source, where the setup has none."""
        if self.kx_n_per_mm is None or self.ky_n_per_mm is None:
            missing = "kx_n_per_mm" if self.kx_n_per_mm is None else "ky_n_per_mm"
            raise UsageError(
                phrase(
                    "{}: [machine] {} is missing: deflection needs the stiffness of both axes",
                    source or "setup",
                    missing,
                )
            )
        return self.kx_n_per_mm, self.ky_n_per_mm


@dataclass(frozen=True, slots=True)
class Stock:
    """What is there before the program cuts: one of allowance, contour, program or solid.

    Parameters
    ----------
    allowance_mm : float, optional
        Equidistant stock left on the nominal profile.
    contour : Path, optional
        Stock as a contour: `profile.json`, material on the left.
    program : Path, optional
        NC program that cut before, with a tool of `program_tool_diameter_mm`.
    program_tool_diameter_mm : float, optional
        By default the same tool.
    solid : bool
        True where nothing was cut before: material everywhere.
    top_z_mm : float, optional
        Height of the stock's face.
    axial_depth_mm : float, optional
        Height of the stock above the deepest pass, in place of `top_z_mm`.
    end : {"with the part", "goes on"}
        What is beyond the ends of an open contour: the allowance ends there with a round of its own size; or it goes on
        straight, as where the contour is a piece of a longer wall.
    """

    allowance_mm: float | None = _key(0.0, 1000.0, default=None, open_=False)
    contour: Path | None = None
    program: Path | None = None
    program_tool_diameter_mm: float | None = _key(high=1000.0, default=None)
    solid: bool = False
    top_z_mm: float | None = _key(-1e5, 1e5, default=None)
    axial_depth_mm: float | None = _key(high=1000.0, default=None)
    end: str = field(default=STOCK_ENDS[0], metadata={"one_of": STOCK_ENDS})


@dataclass(frozen=True, slots=True)
class Tilt:
    """Rotary axes that tilt the tool.

    Parameters
    ----------
    order : {"A", "B", "AB", "BA"}
        A turns about X, B about Y; "AB": A carries B.
    a_sign, b_sign : int
        1 where a positive word turns the tool against the part as a right-hand screw about the axis does; -1 where
        it turns the table so, or counts the other way.
    limit_deg : float
        Largest angle of either axis.
    decimals : int
        Digits behind the point of the words, in degrees.
    tool_centre_point : bool
        The control keeps the tip at the programmed X, Y, Z while the axes turn (G43.4, TRAORI and the like are in force
        as the program is run). Without it the tip would swing away.
    """

    order: str = field(metadata={"one_of": ("A", "B", "AB", "BA")})
    a_sign: int = field(default=1, metadata={"one_of": (1, -1)})
    b_sign: int = field(default=1, metadata={"one_of": (1, -1)})
    limit_deg: float = _key(0.0, 30.0, default=2.0)
    decimals: int = _key(1, 6, default=4, open_=False)
    tool_centre_point: bool = False


@dataclass(frozen=True, slots=True)
class Setup:
    """A validated setup.

    Parameters
    ----------
    tool : Tool
    material : Material
    machine : Machine
    stock : Stock
    source : str
        File it came from, for messages.
    tilt : Tilt, optional
        None where the machine has not said that it can tilt the tool.
    """

    tool: Tool
    material: Material
    machine: Machine
    stock: Stock
    source: str = ""
    tilt: Tilt | None = None

    def __post_init__(self) -> None:
        for name in _TABLES:
            if (part := getattr(self, name)) is not None:
                _check(part, name, self.source)
        tool, material, stock = self.tool, self.material, self.stock
        for key in ("ktc_n_per_mm2", "krc_n_per_mm2"):
            if math.isnan(getattr(material, key)):
                self._refuse(
                    phrase(
                        "[material] {} is missing: give ktc_n_per_mm2 and krc_n_per_mm2, or ks_n_per_mm2 and mu", key
                    )
                )
        given = [k for k in ("allowance_mm", "contour", "program") if getattr(stock, k) is not None]
        given += ["solid"] if stock.solid else []
        if not given:
            self._refuse(phrase("[stock] is missing: give allowance_mm, contour, program or solid = true"))
        if len(given) > 1:
            self._refuse(phrase("[stock] {} and {} say the same twice: give one of them", given[1], given[0]))
        if stock.program_tool_diameter_mm is not None and stock.program is None:
            self._refuse(phrase("[stock] program_tool_diameter_mm goes with program, which is missing"))
        if stock.end != STOCK_ENDS[0] and stock.allowance_mm is None and stock.contour is None:
            self._refuse(phrase('[stock] end = "{}" goes with allowance_mm or contour, one is missing', stock.end))
        if (stock.top_z_mm is None) == (stock.axial_depth_mm is None):
            self._refuse(
                phrase("[stock] top_z_mm or axial_depth_mm is needed, one of them: it says how deep the tool cuts")
            )
        if self.machine.contour_control and self.machine.contour_speed_change_mm_min is None:
            self._refuse(
                phrase(
                    "[machine] contour_speed_change_mm_min is missing: contour_control needs the speed change "
                    "allowed at a corner"
                )
            )
        for key, name, rows in (
            ("stiffness_along", "s", self.machine.stiffness_along),
            ("wall_over_height", "height", self.machine.wall_over_height),
        ):
            behind = -1e-12
            for place, *_ in rows:
                if not place > behind:
                    self._refuse(phrase("[machine] {}: {} is 0 or more and ascends, {:g} does not", key, name, place))
                behind = place
        if stock.axial_depth_mm is not None:
            self.require_overhang(stock.axial_depth_mm)
        if tool.overhang_mm is not None and tool.overhang_mm > 40 * tool.diameter_mm:
            self._refuse(phrase("[tool] overhang_mm {:g} is more than 40 diameters: is its unit mm?", tool.overhang_mm))

    @property
    def cautions(self) -> tuple[str, ...]:
        """How far the numbers can be trusted, and which were fitted to what, in words."""
        return tuple(text for text in (self.material.caution(), self.machine.caution()) if text)

    def require_overhang(self, depth: float) -> None:
        """FormatError where the tool's overhang is shorter than a cut of `depth` mm."""
        overhang = self.tool.overhang_mm
        if overhang is not None and overhang < depth:
            self._refuse(phrase("[tool] overhang_mm {:g} is shorter than the cut of {}", overhang, mm(depth, "g")))

    def _refuse(self, message: str) -> None:
        raise FormatError(message, self.source or None)


_TABLES: dict[str, type] = {"tool": Tool, "material": Material, "machine": Machine, "stock": Stock, "tilt": Tilt}
_OPTIONAL = ("tilt",)
_ROWS = {"stiffness_along", "wall_over_height"}


def load(path: str | Path) -> Setup:
    """Setup from a TOML file; paths in it are relative to the file.

    Raises
    ------
    FormatError
        If the file is no setup, with the key that is wrong.
    """
    path = Path(path)
    try:
        if path.stat().st_size > _LARGEST_FILE:
            raise FormatError(phrase("too large for a setup"), path)
        data = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise FormatError(error.strerror or str(error), path) from error
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise FormatError(phrase("not TOML: {}", error), path) from error
    return from_dict(data, str(path))


def from_dict(data: dict[str, Any], source: str = "") -> Setup:
    """Setup from the tables of a TOML file; FormatError as `load`."""
    for name in data:
        if name not in _TABLES:
            raise FormatError(phrase("[{}] is unknown{}", name, _near(name, _TABLES)), source or None)
    parts: dict[str, Any] = {}
    for name, kind in _TABLES.items():
        if name in _OPTIONAL and name not in data:
            continue
        table = data.get(name, {})
        if not isinstance(table, dict):
            raise FormatError(phrase("[{}] is a table of keys", name), source or None)
        table = dict(table)
        if name == "material":
            table = _specific_force(table, source)
        if name == "stock":
            for key in ("contour", "program"):
                if isinstance(table.get(key), str):
                    table[key] = Path(source).parent / table[key]
        parts[name] = _made(kind, name, table, source)
    return Setup(**parts, source=source)


def _specific_force(table: dict[str, Any], source: str) -> dict[str, Any]:
    """Ktc and Krc of Ks and mu."""
    if not {"ks_n_per_mm2", "mu"} & table.keys():
        return table
    for key, low, high in (("ks_n_per_mm2", 10.0, 1e5), ("mu", 0.0, 5.0)):
        value = table.get(key)
        if value is None:
            raise FormatError(phrase("[material] {} is missing: ks_n_per_mm2 and mu go together", key), source or None)
        if isinstance(value, bool) or not isinstance(value, int | float) or not low <= value <= high:
            raise FormatError(
                phrase("[material] {} {!r} is not a number from {:g} to {:g}", key, value, low, high), source or None
            )
    for key in ("ktc_n_per_mm2", "krc_n_per_mm2", "kte_n_per_mm", "kre_n_per_mm"):
        if key in table:
            raise FormatError(
                phrase("[material] {} and ks_n_per_mm2 say the same twice: give one of them", key), source or None
            )
    ks, mu = float(table.pop("ks_n_per_mm2")), float(table.pop("mu"))
    return {**table, "ktc_n_per_mm2": ks, "krc_n_per_mm2": mu * ks}


def _made(kind: type[Table], name: str, table: dict[str, Any], source: str) -> Table:
    known = {f.name: f for f in fields(kind)}  # type: ignore[arg-type]
    for key in table:
        if key not in known:
            extra = ("ks_n_per_mm2", "mu") if kind is Material else ()
            raise FormatError(phrase("[{}] {} is unknown{}", name, key, _near(key, [*known, *extra])), source or None)
    for key, item in known.items():
        if key not in table and item.default is MISSING:
            raise FormatError(phrase("[{}] {} is missing", name, key), source or None)
    for key in _ROWS & table.keys():
        if isinstance(table[key], list):
            table[key] = tuple(tuple(r) if isinstance(r, list) else r for r in table[key])
    values = {k: float(v) if _wants(kind, k, float) and type(v) is int else v for k, v in table.items()}
    return kind(**values)


def _wants(kind: type, key: str, wanted: type) -> bool:
    hint = get_type_hints(kind)[key]
    return wanted in (get_args(hint) if isinstance(hint, UnionType) else (hint,))


def _check(part: Any, name: str, source: str) -> None:
    """FormatError where a value has the wrong kind or is out of its range."""
    for item in fields(part):
        value, range_ = getattr(part, item.name), item.metadata
        if value is None and _wants(type(part), item.name, type(None)):
            continue
        where = f"[{name}] {item.name} {value!r}"
        hint = message(" (", range_["hint"], ")") if range_.get("hint") else ""
        if _wants(type(part), item.name, float) or _wants(type(part), item.name, int):
            number = isinstance(value, int | float) and not isinstance(value, bool)
            if not number or (_wants(type(part), item.name, int) and not isinstance(value, int)):
                whole = _wants(type(part), item.name, int)
                said = (
                    phrase("{} is not a whole number{}", where, hint)
                    if whole
                    else phrase("{} is not a number{}", where, hint)
                )
                raise FormatError(said, source or None)
            if value is item.default:
                continue
            if "one_of" in range_:
                _require_one_of(value, range_["one_of"], where, source)
                continue
            low, high = range_["low"], range_["high"]
            if not (low < value <= high or (value == low and not range_["open"])):
                above = phrase("above {:g}", low) if range_["open"] else phrase("at least {:g}", low)
                most = phrase(" and at most {:g}", high) if math.isfinite(high) else ""
                raise FormatError(phrase("{} is not {}{}{}", where, above, most, hint), source or None)
        elif _wants(type(part), item.name, bool):
            if not isinstance(value, bool):
                raise FormatError(phrase("{} is not true or false", where), source or None)
        elif item.name in _ROWS:
            _check_rows(value, f"[{name}] {item.name}", source)
        elif _wants(type(part), item.name, Path):
            if not isinstance(value, Path):
                raise FormatError(phrase("{} is not the name of a file", where), source or None)
        elif not isinstance(value, str):
            raise FormatError(phrase("{} is not a text", where), source or None)
        elif "one_of" in range_:
            _require_one_of(value, range_["one_of"], where, source)


def _check_rows(rows: Any, where: str, source: str) -> None:
    """FormatError where rows are no ``[mm, kx_n_per_mm, ky_n_per_mm]`` in their ranges."""
    for row in rows if isinstance(rows, tuple) else (rows,):
        three = isinstance(row, tuple) and len(row) == 3
        if not three or any(isinstance(v, bool) or not isinstance(v, int | float) for v in row):
            raise FormatError(phrase("{}: {!r} is no row [mm, kx_n_per_mm, ky_n_per_mm]", where, row), source or None)
        if not (math.isfinite(row[0]) and all(1.0 < k <= 1e7 for k in row[1:])):
            raise FormatError(
                phrase("{}: {!r}: stiffness is above 1 and at most 1e+07 N/mm", where, row), source or None
            )


def _require_one_of(value: Any, legal: tuple[Any, ...], where: str, source: str) -> None:
    if value not in legal:
        raise FormatError(phrase("{} is none of {}", where, ", ".join(map(str, legal))), source or None)


def _near(key: str, known: Any) -> str:
    """Advice on a key that is close to a known one, or is one in another unit."""
    names = list(known)
    stem = key.split("_")[0]
    close = difflib.get_close_matches(key, names, n=1, cutoff=0.7) or [n for n in names if n.split("_")[0] == stem][:1]
    return phrase(": is it {}?", close[0]) if close else phrase(", known are {}", ", ".join(names))
