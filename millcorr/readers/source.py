# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a reader gets: a file's bytes, and what the caller says about them.

Here the caller's words meet the file's: what the file does not say is demanded, and a contradiction is refused.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from millcorr.arrays import Floats, Ints
from millcorr.errors import FormatError, UsageError, unsaid
from millcorr.messages import message, mm, option, phrase, remedy
from millcorr.readers.measurement import LARGEST_LOBING, Basis, Measurement, Probe

from .decoding import decode, pieces, plain
from .names import Names

MM_PER_INCH = 25.4

NORMAL_TOLERANCE = 0.01
"""A normal whose length differs from 1 by more than this is no unit vector."""

NORMAL_ROUNDING = 1e-4
"""A normal is left as printed where no component is farther than this from that of a unit vector."""

RADIUS_TOLERANCE = 1e-4
"""Two radii of a probe ball that differ by no more than this, in mm, are the same."""

LONGEST_LINE = 5000
"""No line of a measurement file has more characters; patterns never meet a longer one."""

LARGEST_BALL = 100.0
"""No probe ball has a larger radius, in mm."""

FARTHEST = 1e6
"""No coordinate lies farther out than this, in mm."""

_ROWS = 1 << 14
"""Rows that are looked at in one go."""

_TOLD = {
    "contact": phrase("contact points"),
    "centre": phrase("centres of the probe ball"),
    "axis": phrase("shifted along an axis"),
}
_FACTORS = {"mm": 1.0, "inch": MM_PER_INCH}


@dataclass(frozen=True, slots=True)
class Source:
    """A measurement file's content, and what the caller says about it.

    Parameters
    ----------
    data : bytes
    name : str
        File name for messages and for the measurement's source.
    digest : str
        SHA-256 of the bytes.
    points : {"contact", "centre", "axis"} or None
        What the coordinates are; None: what the file says.
    probe_radius : float or None
        Radius of the probe ball in mm; None: what the file says.
    probe : Probe or None
        Calibration of the probe; its radius counts where neither caller nor file say one.
    units : {"mm", "inch"} or None
        Unit of the coordinates; None: what the file says.
    work_offset : tuple of 3 float, or None
        Origin of the work frame in the machine frame, in mm, for files in the machine frame.
    part : int or None
        Which of several measured parts in the file, from 1.
    bases : dict of str to Basis
        How unit, points and radius came to be known, written down here as each is settled.
    """

    data: bytes
    name: str
    digest: str
    points: str | None = None
    probe_radius: float | None = None
    units: str | None = None
    work_offset: tuple[float, float, float] | None = None
    part: int | None = None
    probe: Probe | None = None
    bases: dict[str, Basis] = field(default_factory=dict)

    def text(self, *, drop: bytes = b"") -> str:
        r"""Text of the file, lines ending in ``\n``.

        Parameters
        ----------
        drop : bytes
            Control characters that this format's senders put between the lines.

        Raises
        ------
        FormatError
            If the file is no text.
        """
        return decode(self.data, self.name, drop)

    def plain(self) -> bytes:
        r"""Text of the file in UTF-8, lines ending in ``\n`` or ``\r\n``: no copy of most files.

        Raises
        ------
        FormatError
            If the file is no text.
        """
        return plain(self.data, self.name)

    def lines(self, *, drop: bytes = b"") -> Iterator[tuple[int, str]]:
        """Lines of the file with their numbers from 1; FormatError for one of absurd length, or if it is no text."""
        for first, piece in self.pieces(drop=drop):
            for number, line in enumerate(piece.split("\n"), first):
                if len(line) > LONGEST_LINE:
                    raise self.too_long(len(line), number)
                yield number, line

    def pieces(self, *, drop: bytes = b"", table: bytes | None = None) -> Iterator[tuple[int, str]]:
        """Some thousand lines at a time, without the end of the last one, and the number of the first, from 1.

        `table` says what stands for each byte. FormatError as in `text`, before the first of them.
        """
        number, ended = 1, False
        for piece in pieces(self.data, self.name, drop, table):
            begun, ended = number, piece.endswith("\n")
            number += piece.count("\n")
            # A line may be as long as the file: nobody keeps it but who takes it.
            piece = piece.removesuffix("\n")
            yield begun, piece
        if ended:
            # The text goes on behind its last line end, with nothing.
            yield number, ""

    def too_long(self, length: int, line: int) -> FormatError:
        """Error for a line, from 1, of absurd length."""
        return self.error(phrase("a line of {} characters: not a measurement file, or damaged", length), line)

    def error(self, message: str, line: int | None = None) -> FormatError:
        """Error that names the file, and the line where known (from 1)."""
        return FormatError(message, self.name, line)

    def unit(self, stated: str | None, default: str = "mm", shows: str = "") -> str:
        """Unit of the coordinates, "mm" or "inch".

        Parameters
        ----------
        stated : {"mm", "inch"} or None
            What the file says.
        default : {"mm", "inch"}
            What it is if neither file nor caller say it.
        shows : str
            What in the file shows `default`, which is inferred then and else assumed.

        Raises
        ------
        UsageError
            If the caller contradicts the file.
        """
        if self.units is not None and stated is not None and self.units != stated:
            raise UsageError(phrase("{} contradicts {}, which says {}", option("units", self.units), self.name, stated))
        if stated is not None:
            self.bases["unit"] = Basis("stated")
        elif self.units is not None:
            self.bases["unit"] = Basis("said", message(option("units")))
        else:
            self.bases["unit"] = (
                Basis("inferred", shows) if shows else Basis("assumed", phrase("the file does not say"))
            )
        return self.units or stated or default

    def kind(self, stated: str | None) -> str:
        """What the points are, of `KINDS`.

        Parameters
        ----------
        stated : str or None
            What the file says.

        Raises
        ------
        UsageError
            If the caller contradicts the file, or neither says what the points are.
        """
        if stated is not None and self.points not in (None, stated):
            raise UsageError(
                phrase(
                    "{} contradicts {}, whose points are {}: leave {} out",
                    option("points", self.points),
                    self.name,
                    _TOLD[stated],
                    option("points"),
                ),
            )
        kind = stated or self.points
        if kind is None:
            raise unsaid(
                phrase("the file does not say whether its coordinates are contact points or centres of the probe ball"),
                remedy("points", "contact"),
                message(remedy("points", "centre"), phrase(" (or axis)")),
            )
        self.bases["points"] = Basis("said", message(option("points"))) if stated is None else Basis("stated")
        return kind

    def ball_radius(self, *, centres: bool | None = None, radius: float | None = None) -> float:
        """Radius in mm that lies between the points and the surface; 0 for contact points.

        It is 0 also for points shifted along an axis: see `axis_radii`.

        Parameters
        ----------
        centres : bool, optional
            Whether the file says that its points are ball centres (True), contact points (False), or does not
            say (None).
        radius : float, optional
            Radius of the ball in mm that the file states.

        Raises
        ------
        UsageError
            If the caller contradicts the file, or neither says what is needed.
        """
        if self.kind(None if centres is None else "centre" if centres else "contact") != "centre":
            return 0.0
        told = self._radius(radius)
        if told is None:
            raise UsageError(
                phrase(
                    "ball centres need {}, the radius of the probe ball: {} does not say it",
                    option("probe_radius", of="MM"),
                    self.name,
                ),
            )
        return told

    def axis_radii(self, radius: float | None = None) -> tuple[float, float]:
        """Radii in mm by which the control shifted points along X and along Y.

        Parameters
        ----------
        radius : float, optional
            Radius in mm that the file states.

        Raises
        ------
        UsageError
            If nobody says it, or two say otherwise.
        """
        control = None if self.probe is None else self.probe.control_radii
        if control is None:
            told = self._radius(radius)
            if told is None:
                raise UsageError(
                    phrase(
                        "points shifted along an axis need {}, the radius by which the control shifted them",
                        option("probe_radius", of="MM"),
                    ),
                )
            return told, told
        said = self.probe_radius if radius is None else radius
        if said is not None and max(abs(said - r) for r in control) > RADIUS_TOLERANCE:
            who = option("probe_radius", said) if radius is None else f"{self.name} {said:g}"
            raise UsageError(phrase("{} contradicts control_radius in the probe's file: leave one of them out", who))
        return control

    def _radius(self, stated: float | None) -> float | None:
        """Radius of the ball in mm by file, caller or calibration; UsageError where they contradict each other."""
        said = self.probe_radius
        if stated is not None and said is not None and abs(said - stated) > RADIUS_TOLERANCE:
            raise UsageError(
                phrase(
                    "{} contradicts {}, which says {}: leave {} out",
                    option("probe_radius", said),
                    self.name,
                    mm(stated, "g"),
                    option("probe_radius"),
                ),
            )
        radius = said if stated is None else stated
        if stated is not None:
            self.bases["radius"] = Basis("stated")
        else:
            self.bases["radius"] = Basis("said", message(option("probe_radius" if said is not None else "probe")))
        if self.probe is None:
            return None if radius is None else float(radius)
        calibrated = self.probe.radius
        if radius is not None and abs(radius - calibrated) > LARGEST_LOBING:
            raise UsageError(
                phrase(
                    "a probe radius of {} contradicts {}, which says {}: they differ by more than a calibration can",
                    mm(radius, "g"),
                    self.probe.source or phrase("the probe"),
                    mm(calibrated, "g"),
                )
            )
        if radius is None and self.points == "axis" and self.probe.directions is not None:
            raise UsageError(
                phrase(
                    "radii by direction do not say by which one the control shifted: add {}",
                    option("probe_radius", of="MM"),
                )
            )
        return calibrated if radius is None else float(radius)

    def measurement(
        self,
        format: str,
        points: Floats,
        lines: Sequence[int] | Ints,
        *,
        ball_radius: float | Floats,
        unit: str = "mm",
        factor: float | None = None,
        normals: Floats | None = None,
        nominal: Floats | None = None,
        stated: Floats | None = None,
        elements: Iterable[str] | None = None,
        has_z: bool = True,
        notes: Sequence[str] = (),
    ) -> Measurement:
        """Measurement from a file's numbers, checked.

        Parameters
        ----------
        format : str
            Name of the format.
        points, normals, nominal : (n, 3) float64
            In the file's unit; normals of length 1 to within `NORMAL_TOLERANCE`.
        lines : (n,) int
            Line number of each point, from 1.
        ball_radius : float or (n,) float64
            In mm. Where points have different radii, all are moved along their normals to the first one's.
        unit : {"mm", "inch"}
        factor : float, optional
            Millimetres in the unit of the numbers given, where that is not the file's `unit`.
        stated : (n,) float64
            Deviations that the file states, in the file's unit.
        elements, has_z, notes
            As in `Measurement`.

        Raises
        ------
        FormatError
            If there are no points, a number is not finite or absurd, a normal has no unit length, or radii differ
            and no normals say which way.
        """
        numbers = np.asarray(lines, dtype=np.int64)
        if not len(points):
            raise self.error(phrase("no measured points in the file"))
        factor = _FACTORS[unit] if factor is None else factor
        if factor != 1.0:
            with np.errstate(over="ignore"):
                points = points * factor
                nominal = None if nominal is None else nominal * factor
                stated = None if stated is None else stated * factor
        self._refuse_absurd(points, numbers, phrase("coordinate"))
        if nominal is not None:
            self._refuse_absurd(nominal, numbers, phrase("nominal coordinate"), missing=True)
        if normals is not None:
            normals = self._unit_normals(normals, numbers)
        radius, remarks = 0.0, list(notes)
        if isinstance(ball_radius, np.ndarray):
            points, radius, remark = self._one_radius(points, normals, ball_radius, numbers)
            remarks += [remark] if remark else []
        else:
            radius = ball_radius
        return Measurement(
            points, normals, radius, numbers, self.name, self.digest, has_z,
            nominal=nominal,
            elements=None if elements is None else elements if isinstance(elements, Names) else Names(elements),
            stated=stated,
            unit=unit,
            format=format,
            notes=tuple(remarks),
        )  # fmt: skip

    def _refuse_absurd(self, values: Floats, lines: Ints, what: str, *, missing: bool = False) -> None:
        """FormatError for the first row of which a value is absurd, or NaN where none may be `missing`."""
        for rows in slices(values):
            good = np.abs(values[rows]) <= FARTHEST
            if missing:
                good |= np.isnan(values[rows])
            if not good.all():
                line = int(lines[rows][np.flatnonzero(~good.all(axis=1))[0]])
                raise self.error(phrase("a {} is no length that a machine can travel", what), line)

    def _unit_normals(self, normals: Floats, lines: Ints) -> Floats:
        """Normals as printed, or of length 1 where they are farther from it than rounding."""
        out = normals
        for rows in slices(normals):
            unit_length = unit_normals(normals[rows], lines[rows], self.name)
            # Rounded as printed they give the figures that other programs take from the same file.
            off = np.abs(unit_length - normals[rows]).max(axis=1) > NORMAL_ROUNDING
            if off.any():
                out = normals.copy() if out is normals else out
                out[rows][off] = unit_length[off]
        return out

    def _one_radius(
        self, points: Floats, normals: Floats | None, radii: Floats, lines: Ints
    ) -> tuple[Floats, float, str]:
        absurd = np.flatnonzero(~((radii >= 0) & (radii <= LARGEST_BALL)))
        if len(absurd):
            row = int(absurd[0])
            raise self.error(phrase("{} is no radius of a probe ball", mm(radii[row], "g")), int(lines[row]))
        radius = float(radii[0])
        other = np.flatnonzero(np.abs(radii - radius) > 1e-9)
        if not len(other):
            return points, radius, ""
        if normals is None:
            raise self.error(
                phrase(
                    "probe balls of {} and {} radius and no normals: give one file a ball",
                    mm(radius, "g"),
                    mm(radii[other[0]], "g"),
                ),
                int(lines[other[0]]),
            )
        moved: Floats = points - (radii - radius)[:, None] * normals
        return (
            moved,
            radius,
            phrase("{} points of another probe ball moved along their normals to {}", len(other), mm(radius, "g")),
        )


def slices(table: Floats) -> Iterator[slice]:
    """Rows of a table, some thousand at a time: a million rows are large."""
    return (slice(begin, begin + _ROWS) for begin in range(0, len(table), _ROWS))


def unit_normals(normals: Floats, lines: Ints, name: str) -> Floats:
    """Normals (n, 3) brought to length 1; FormatError names the line of one that is no direction."""
    return unit_vectors(normals, lines, name, phrase("normal i,j,k"))


def unit_vectors(vectors: Floats, lines: Ints, name: str, what: str) -> Floats:
    """Vectors (n, 3) brought to length 1; FormatError says `what` and the line of one that is no direction."""
    with np.errstate(over="ignore", invalid="ignore"):
        length = np.sqrt(np.einsum("ij,ij->i", vectors, vectors))
    wrong = np.flatnonzero(~(np.abs(length - 1.0) <= NORMAL_TOLERANCE))
    if len(wrong):
        row = int(wrong[0])
        size = "zero" if length[row] == 0 else f"{length[row]:.4g}"
        raise FormatError(
            phrase("the {} has length {}, not 1: export unit vectors or leave the columns out", what, size),
            name,
            int(lines[row]),
        )
    out: Floats = vectors / length[:, None]
    return out


def shown(text: str) -> str:
    """A piece of a file for a message: quoted, one line, not long."""
    text = text.strip()
    return repr(text if len(text) <= 40 else text[:37] + "...")
