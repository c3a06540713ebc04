# SPDX-License-Identifier: LGPL-2.1-or-later
"""Close the loop once, on a simulated machine: ``python3 -m millcorr.virtual.demonstration DIRECTORY``.

FreeCAD makes a document after the experiment in werner-2018 and posts its program; the simulated machine cuts
and measures a part; ``millcorr correct`` corrects the document from raw and from filtered deviations; the
machine cuts and measures again. The true surface of the second part is judged against the published result.
"""

from __future__ import annotations

import argparse
import json
import os
import shlex
import subprocess
import sys
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from millcorr import freecad_process, nc, pipeline
from millcorr.arrays import Floats
from millcorr.comparison.deviation import deviations, statistics
from millcorr.errors import MillcorrError
from millcorr.geometry.profile import Profile
from millcorr.readers import text
from millcorr.readers.measurement import Measurement

from .simulated_machine import SimulatedMachine, SimulatedPart, reference_contour

Statistics = Mapping[str, float]

TOOL_DIAMETER = 10.0
"""mm, as in `millcorr.app.demonstration`."""

POINTS = 200
"""Measured points, as in werner-2018."""

SEED = 2018
"""Of all randomness, so that every run shows the same numbers."""

PARTS = 20
"""Parts over which the mean result is stated, so that one seed proves nothing."""

FILTERS = {"none": "after, raw data", "mean:5": "after, mean of 5", "auto": "after, auto"}
"""The corrections of the demonstration: ``--filter`` and its row in the table."""

PUBLISHED: dict[str, Statistics] = {
    "before": {"mean": 0.0104, "min": 0.003, "max": 0.017, "height": 0.0140, "std": 0.0027},
    "none": {"mean": 0.0028, "min": -0.003, "max": 0.007, "height": 0.0104, "std": 0.0018},
    "mean:5": {"mean": 0.0028, "min": 0.0, "max": 0.0057, "height": 0.0060, "std": 0.0009},
}
"""The table of werner-2018, mm."""

JUDGED = ("mean", "height", "std")
"""What the filtered correction must bring down to the published values, on the true surface."""

_COLUMNS = {"mean": "5.1f", "min": "6.1f", "max": "6.1f", "height": "7.1f", "std": "6.2f"}


@dataclass(frozen=True, eq=False, slots=True)
class Row:
    """A line of the table: statistics in mm, of the paper, the true surface and the measured points."""

    title: str
    published: Statistics | None
    true: Statistics | None
    measured: Statistics | None


def main(argv: Sequence[str] | None = None) -> int:
    """Run the demonstration.

    Parameters
    ----------
    argv : sequence of str, optional
        Arguments; by default those of the process.

    Returns
    -------
    int
        0 if the published result was reached, else 1.
    """
    parser = argparse.ArgumentParser(
        prog="millcorr.virtual.demonstration", description="Close the loop on a simulated machine."
    )
    parser.add_argument("directory", type=Path, help="where the files go")
    parser.add_argument("--seed", type=int, default=SEED, help="of the simulated randomness (default %(default)s)")
    arguments = parser.parse_args(argv)
    try:
        missed = run(arguments.directory, arguments.seed)
    except MillcorrError as error:
        print(f"demonstration: {error}", file=sys.stderr)
        return 1
    if missed:
        print(f"demonstration: published result NOT reached: {'; '.join(missed)}", file=sys.stderr)
    return 1 if missed else 0


def run(directory: Path, seed: int = SEED) -> list[str]:
    """Make, cut, measure, correct and cut again; prints what it does.

    Parameters
    ----------
    directory : Path
        For all files; made if missing.
    seed : int
        Of process and measurement noise.

    Returns
    -------
    list of str
        What missed the published result; empty if it was reached.
    """
    directory.mkdir(parents=True, exist_ok=True)
    document, program = directory / "demo.FCStd", directory / "demo.nc"
    say("1. FreeCAD makes a document with part, job and Profile operation, and posts its program (LinuxCNC)")
    freecad_process.call("demonstrate", {"document": str(document.resolve()), "program": str(program.resolve())})
    say(f"   {document}\n   {program}")

    nominal, machine = reference_contour(), SimulatedMachine.reference()
    at = places(nominal)
    first = cut(machine, nominal, program, worn=0.0, seed=seed)
    say("2. The simulated machine cuts part 1 and measures it: THIS PART IS SIMULATED, no metal was cut")
    for line in machine.describe().split("; "):
        say(textwrap.fill(line, 112, initial_indent="   ", subsequent_indent="     "))
    say(
        f"   So the randomness is split: {_um(machine.process_noise)} um (standard deviation) belong to the process "
        "and are new\n   on every part, "
        f"{_um(machine.measurement_noise)} um belong to the measurement and are not on the part at all."
    )
    measured = directory / "part-1.csv"
    measurement = first.measure(POINTS, seed=seed)
    text.write(measured, measurement, comments=(first.describe(),))
    say(f"   {measured}: {POINTS} contact points")
    commanded, _ = first.commanded(0, at)
    true, seen = first.deviation(0, at), of_points(measurement, nominal)
    rows = [
        Row("part 1 as cut", None, statistics(true), statistics(seen)),
        Row("  FreeCAD's own path error", None, statistics(commanded), None),
        Row(
            "before: what the machine added",
            PUBLISHED["before"],
            statistics(true - commanded),
            statistics(seen - commanded),
        ),
    ]

    say("3. millcorr corrects the document from these points; the machine cuts and measures part 2")
    surfaces: dict[str, Floats] = {}
    paths: list[tuple[str, Path]] = [("measured points", measured)]
    for k, (name, title) in enumerate(FILTERS.items()):
        corrected, posted, report = correct(document, measured, name, directory)
        second = cut(machine, nominal, posted, worn=first.worn, seed=seed + k + 1)
        surfaces[name] = second.deviation(0, at)
        points = of_points(second.measure(POINTS, seed=seed + k + 1), nominal)
        rows.append(Row(title, PUBLISHED.get(name), statistics(surfaces[name]), statistics(points)))
        proof = json.loads((report / "report.json").read_text(encoding="utf-8"))["verification"]["path_error_max"]
        say(f"   posted path within {_um(proof)} um of the exact parallel of the compensated profile")
        paths += [
            (f"{title[7:]}: document", corrected),
            (f"{title[7:]}: program", posted),
            (f"{title[7:]}: report", report / "report.html"),
        ]

    say("\n4. Result, micrometres. Published: Werner 2018, re-measured parts. Simulated: the part's true surface, and")
    say(f"   as re-measured with {_um(machine.measurement_noise)} um of measurement noise\n")
    say(table(rows))
    say("")
    say(in_words(over_many_parts(machine, nominal, nc.read(program), seed), machine))
    paths.append(("picture", draw(directory / "loop.png", nominal, true, surfaces)))
    say("\n5. Files")
    for title, path in paths:
        say(f"   {title:<22}{path}")
    missed = missing(statistics(surfaces["mean:5"]))
    if not missed:
        reached = ", ".join(f"{name} <= {_um(PUBLISHED['mean:5'][name])}" for name in JUDGED)
        say(f"\nReached on the true surface of part 2, after correction through a mean of 5: {reached} um")
    return missed


def places(nominal: Profile) -> Floats:
    """Arc lengths in mm at which the parts are looked at: where the points are measured."""
    out: Floats = (np.arange(POINTS) + 0.5) / POINTS * float(nominal.total[0])
    return out


def cut(machine: SimulatedMachine, nominal: Profile, program: Path, *, worn: float, seed: int) -> SimulatedPart:
    """Cut a part with a posted program."""
    return machine.cut(nc.read(program).toolpath, TOOL_DIAMETER / 2, nominal, worn=worn, seed=seed)


def of_points(measurement: Measurement, nominal: Profile) -> Floats:
    """Deviations of measured points in mm, in the order along the contour in which they were measured."""
    found = deviations(measurement, nominal, cutter_radius=TOOL_DIAMETER / 2)
    if found.rejected:
        raise MillcorrError(
            f"{len(found.rejected)} of the demonstration's points were rejected: {found.rejected[0].reason}"
        )
    out: Floats = found.value[np.argsort(found.index)]
    return out


def correct(document: Path, measured: Path, filter: str, directory: Path) -> tuple[Path, Path, Path]:
    """Run ``millcorr correct`` as a user would; gives corrected document, program and report directory."""
    name = filter.replace(":", "-")
    output, posted = directory / f"corrected-{name}.FCStd", directory / f"corrected-{name}.nc"
    report = directory / f"report-{name}"
    arguments = [
        "correct", "--document", document, "--operation", "Profile", "--measured", measured, "--points", "contact",
        "--filter", filter, "--output", output, "--gcode", posted, "--report", report,
    ]  # fmt: skip
    command = ["-m", "millcorr", *map(str, arguments)]
    say(f"   $ {shlex.join(['python3', *command])}")
    here = str(Path(__file__).resolve().parents[2])
    done = subprocess.run(
        [sys.executable, *command],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        env=dict(os.environ) | {"PYTHONPATH": here},
        check=False,
    )
    if done.returncode != 0:
        raise MillcorrError(f"the correction ended with {done.returncode}: {done.stderr.strip()}")
    return output, posted, report


def missing(true: Statistics) -> list[str]:
    """What of a true surface is worse than the published filtered result, in words."""
    limits = PUBLISHED["mean:5"]
    return [
        f"{name} {_um(abs(true[name]))} um where {_um(limits[name])} um are published"
        for name in JUDGED
        if not abs(true[name]) <= limits[name]
    ]


def over_many_parts(machine: SimulatedMachine, nominal: Profile, program: nc.Program, seed: int) -> dict[str, Floats]:
    """Correct many parts, so that one seed proves nothing.

    Parameters
    ----------
    machine : SimulatedMachine
    nominal : Profile
    program : Program
        The first program; corrected as a program, without FreeCAD.
    seed : int
        Of the first part; each part has its own.

    Returns
    -------
    dict of str to (PARTS, 3) float64
        For each of `FILTERS` what `JUDGED` names, of the true surface of every second part, mm.
    """
    at, radius = places(nominal), TOOL_DIAMETER / 2
    out = {name: np.empty((PARTS, len(JUDGED))) for name in FILTERS}
    for k in range(PARTS):
        one = seed + 100 * (k + 1)
        first = machine.cut(program.toolpath, radius, nominal, seed=one)
        measurement = first.measure(POINTS, seed=one)
        for n, name in enumerate(FILTERS):
            request = pipeline.Request(program, radius, measurement, nominal, pipeline.Settings(filter=name))
            corrected = nc.parse(pipeline.correct(request).text, program.name)
            second = machine.cut(corrected.toolpath, radius, nominal, worn=first.worn, seed=one + n + 1)
            true = statistics(second.deviation(0, at))
            out[name][k] = [true[j] for j in JUDGED]
    return out


def in_words(many: Mapping[str, Floats], machine: SimulatedMachine) -> str:
    """What `over_many_parts` found."""
    limits = np.array([PUBLISHED["mean:5"][name] for name in JUDGED])
    lines = [f"   Over {PARTS} other parts, standard deviation of the true surface in the mean:"]
    for name, title in FILTERS.items():
        reached = int((np.abs(many[name]) <= limits).all(axis=1).sum())
        lines.append(
            f"   {title:<18}{_um(many[name][:, JUDGED.index('std')].mean())} um; published filtered result reached "
            f"by {reached} of {PARTS}"
        )
    lines.append(f"   No correction can go below the process itself, {_um(machine.process_noise)} um.")
    return "\n".join(lines)


def draw(
    file: Path, nominal: Profile, before: Floats, surfaces: Mapping[str, Floats], magnification: float = 500.0
) -> Path:
    """Draw the deviations before and after as whiskers on the contour and along it.

    Parameters
    ----------
    file : Path
        Image to write.
    nominal : Profile
    before : (n,)
        Deviations of part 1 at `places`, mm.
    surfaces : mapping of str to (n,)
        Those of part 2 for each filter, mm.
    magnification : float
        Of the whiskers.

    Returns
    -------
    Path
        The file.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.collections import LineCollection
    from matplotlib.figure import Figure

    at = places(nominal)
    point, normal = nominal.at(0, at)
    series = (("part 1", before, "#c0392b"), ("part 2, corrected (auto)", surfaces["auto"], "#1f7a4d"))
    figure = Figure(figsize=(9.0, 3.6), layout="constrained")
    FigureCanvasAgg(figure)
    left, right = figure.subplots(1, 2, width_ratios=(1.0, 1.25))
    ring = np.vstack([point, point[:1]])
    left.plot(ring[:, 0], ring[:, 1], color="0.2", linewidth=1.0)
    for title, value, colour in series:
        tips = point + magnification * value[:, None] * normal
        left.add_collection(LineCollection(list(np.stack([point, tips], axis=1)), colors=colour, linewidths=0.8))
        right.plot(at, 1000 * value, color=colour, linewidth=1.0, label=title)
    left.set_aspect("equal")
    left.autoscale_view()
    left.set_title(f"deviations on the contour, {magnification:g}:1", fontsize=9)
    left.set_axis_off()
    right.axhline(0.0, color="0.2", linewidth=0.8)
    right.set_title("deviation along the contour, um (positive: material left)", fontsize=9)
    right.set_xlabel("mm", fontsize=8)
    right.tick_params(labelsize=8)
    right.legend(fontsize=8, frameon=False)
    figure.savefig(file, dpi=100)
    return file


def table(rows: Sequence[Row]) -> str:
    """The rows beside each other, micrometres."""
    width = max(len(row.title) for row in rows) + 1
    groups = ("published", "true surface", "measured")
    sizes = {name: int(form.partition(".")[0]) for name, form in _COLUMNS.items()}
    lines = [
        " " * width + "  ".join(f"{group:^{sum(sizes.values())}}" for group in groups),
        " " * width + "  ".join("".join(f"{name:>{size}}" for name, size in sizes.items()) for _ in groups),
    ]
    for row in rows:
        cells = [
            " " * sum(sizes.values())
            if values is None
            else "".join(f"{1000 * values[name]:{form}}" for name, form in _COLUMNS.items())
            for values in (row.published, row.true, row.measured)
        ]
        lines.append(f"{row.title:<{width}}" + "  ".join(cells))
    return "\n".join(line.rstrip() for line in lines)


def say(line: str) -> None:
    """Print at once, also into a pipe."""
    print(line, flush=True)


def _um(value: float) -> str:
    return f"{value * 1000:.2f}"


if __name__ == "__main__":
    sys.exit(main())
