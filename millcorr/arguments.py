# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of the command line: verbs and their options. What they do is said in `millcorr.__main__`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any, NoReturn

from . import __version__

OUTPUTS = ("output", "gcode", "report", "slowed", "shifted", "tilted")
"""Options that name what a verb writes."""

MACHINE_KEYS = (
    "acceleration_time_x_ms",
    "acceleration_time_y_ms",
    "position_gain_per_s",
    "contour_speed_change_mm_min",
)
"""Keys of a setup that a log can tell."""


class _Parser(argparse.ArgumentParser):
    """Says what is wrong in one line, as every other error."""

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"millcorr: {' '.join(message.split())}; --help says the options\n")


class _Verb(_Parser):
    """Parser that asks for what one option's value makes necessary."""

    def parse_known_args(self, *args: Any, **kwargs: Any) -> Any:
        """As usual, but measured points may be left out only where they are predicted."""
        found, rest = super().parse_known_args(*args, **kwargs)
        if found is not None and getattr(found, "method", "predicted") != "predicted" and not found.measured:
            self.error("the following arguments are required: --measured")
        return found, rest


def verbs() -> dict[str, argparse.ArgumentParser]:
    """Parser of each verb by its name."""
    return next(dict(a.choices) for a in parser()._actions if isinstance(a, argparse._SubParsersAction))


def parser() -> argparse.ArgumentParser:
    """Parser of the whole command line; the attribute `verb` of what it gives names the verb."""
    out = _Parser(prog="millcorr", description="Correct milling toolpaths from measured parts.", allow_abbrev=False)
    out.add_argument("--version", action="version", version=f"millcorr {__version__}")
    verbs = out.add_subparsers(required=True, metavar="VERB", dest="verb", parser_class=_Verb)

    def add(name: str, text: str) -> argparse.ArgumentParser:
        return verbs.add_parser(name, help=text, description=text.capitalize() + ".", allow_abbrev=False)

    for name, text in (("correct", "write a corrected program or document"), ("check", "deviations and report only")):
        verb = add(name, text)
        _add_inputs(verb)
        if name == "correct":
            _add_outputs(verb)
            _add_series(verb)
        else:
            listed = "list every point: as measured, contact point, slope, error"
            verb.add_argument("--table", action="store_true", help=listed)
        verb.add_argument("--report", metavar="DIR", type=Path, help="write report.html, .json, .csv there")
    _add_split(add("split", "program of a first cut, which leaves a part of the allowance"))
    model = "cut a program in the model: forces, deflections and the error to expect, as plots and an animation"
    _add_simulate(add("simulate", model))
    _add_probe(add("probe", "program that measures the contour on the machine"))
    inspect = add("inspect", "what a measured file holds")
    convert = add("convert", "measured file to text x,y,z[,i,j,k]")
    convert.add_argument("--output", "-o", metavar="POINTS.csv", type=Path, required=True, help="file to write")
    for verb in (inspect, convert):
        verb.add_argument("measured", metavar="FILE", type=Path, help="measured file")
        _add_measurement(verb)
    _add_batch(add("batch", "many commands from one file, in parallel"))
    _add_history(add("history", "what a journal of a series holds"))
    for verb in verbs.choices.values():
        verb.add_argument("--debug", action="store_true", help="show the traceback of an error")
    return out


def _add_source(verb: argparse.ArgumentParser, what: str, *, required: bool = True) -> None:
    """What is cut: a program, which is called `what`, or an operation of a document."""
    source = verb.add_mutually_exclusive_group(required=required)
    source.add_argument("--program", metavar="PART.nc", type=Path, help=what)
    source.add_argument("--document", metavar="JOB.FCStd", type=Path, help="FreeCAD document with a job")
    verb.add_argument("--operation", metavar="LABEL", help="operation of the document (the only one by default)")


def _add_measurement(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("--format", metavar="NAME", help="format of the measured file (by content by default)")
    kinds = "points on the part, centres of the probe's ball, or centres shifted by its radius along an axis"
    verb.add_argument("--points", choices=("contact", "centre", "axis"), help=kinds)
    verb.add_argument("--probe-radius", metavar="MM", type=float, help="ball radius, for --points centre and axis")
    calibration = "calibration of the probe: effective radius by direction, offset of the stylus"
    verb.add_argument("--probe", metavar="FILE.toml", type=Path, help=calibration)
    verb.add_argument("--units", choices=("mm", "inch"), help="unit of the measured file")
    verb.add_argument("--part", metavar="N", type=int, help="which of several measured parts in one file, from 1")
    offset = "origin of the work frame in the frame of the file, mm"
    verb.add_argument("--work-offset", metavar=("X", "Y", "Z"), nargs=3, type=float, help=offset)
    turn = "turn of the work frame in the frame of the file, degrees, anticlockwise"
    verb.add_argument("--work-rotation", metavar="DEG", type=float, help=turn)
    columns = "what the columns of a text file are, for layouts that no format covers"
    verb.add_argument("--mapping", metavar="FILE.toml", type=Path, help=columns)


def _add_inputs(verb: argparse.ArgumentParser) -> None:
    _add_source(verb, "NC program to correct")
    several = "measured points; given several times, the deviations of the parts are averaged"
    verb.add_argument("--measured", metavar="FILE", type=Path, action="append", default=[], help=several)
    _add_measurement(verb)
    verb.add_argument("--nominal", metavar="FILE", help="profile: document#label, step, iges, brep, dxf, json, nc")
    verb.add_argument("--tool-diameter", metavar="MM", type=float, help="cutter diameter of the measured surface")
    others = (
        "number or name, and diameter, of another tool of the program, where its comments do not say it; give several"
    )
    verb.add_argument("--tool", metavar="T=MM", action="append", default=[], dest="tools", help=others)
    along = "move what roughs along the contour with it, so that its allowance stays"
    verb.add_argument("--keep-allowance", action="store_true", help=along)
    _add_path(verb)
    fits = "best fit before comparing: none, shift, rigid, or some of x, y, turn joined by +; then :zone or :all"
    verb.add_argument("--align", default="none", metavar="FIT", help=fits)
    verb.add_argument(
        "--accept", action="append", default=[], metavar="NAME", help="accept a finding that would stop the correction"
    )
    filters = "none, mean:5, mean:1,2,3,2,1, gauss:MM, robust:MM, auto"
    verb.add_argument("--filter", default="auto", metavar="F", help=filters)
    methods = ("mirror", "transfer", "combined", "predicted")
    verb.add_argument("--method", choices=methods, default="mirror", help="how to correct")
    _add_transfer(verb)
    setup = "tool, material, machine and stock, for --method combined and predicted"
    verb.add_argument("--setup", metavar="SETUP.toml", type=Path, help=setup)
    bound = "with --setup: simulate and correct again until the predicted error is at most this"
    verb.add_argument("--iterate", metavar="MM", type=float, help=bound)
    verb.add_argument("--gain", type=float, default=1.0, help="share of the deviation to correct")
    verb.add_argument("--limit", type=float, default=0.5, metavar="MM", help="largest correction")
    verb.add_argument("--dead-band", type=float, default=0.0, metavar="MM", help="leave smaller deviations")
    share = "largest share of a contour without points near that is corrected all the same (default 0.6)"
    verb.add_argument("--unmeasured", type=float, default=0.6, metavar="SHARE", dest="unmeasured_share", help=share)


def _add_transfer(verb: argparse.ArgumentParser) -> None:
    depth = "depth along the normal at which the measured part was cut; once, or once for each --measured"
    verb.add_argument("--depth", metavar="MM", type=float, action="append", default=[], help=depth)
    following = "depth that the corrected program will cut (default: that of the measured part)"
    verb.add_argument("--next-depth", metavar="MM", type=float, help=following)
    along = "how deviations are taken for the transfer function: along the normal, or along x or y"
    verb.add_argument("--depth-along", choices=("normal", "x", "y"), default="normal", help=along)
    form = "transfer function smooth along the contour, as one value, or one a point"
    verb.add_argument("--transfer-function", choices=("smooth", "one", "points"), default="smooth", help=form)
    left = "stock that the program of the measured part left over the nominal; once, or once for each --measured"
    verb.add_argument("--allowance", metavar="MM", type=float, action="append", default=[], help=left)


def _add_split(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("--program", metavar="FINISH.nc", type=Path, required=True, help="program that finishes the part")
    verb.add_argument("--tool-diameter", metavar="MM", type=float, required=True, help="cutter diameter")
    whole = "whole allowance over the finished contour, along the normal"
    verb.add_argument("--depth", metavar="MM", type=float, required=True, help=whole)
    share = "share of the allowance that the first cut takes (default: half)"
    verb.add_argument("--at", metavar="SHARE", type=float, default=0.5, help=share)
    verb.add_argument("--output", metavar="FIRST.nc", type=Path, required=True, help="program of the first cut")
    verb.add_argument("--nominal", metavar="FILE", help="profile, where the program cannot show it (splines)")
    axis = "keep the other coordinate of an open contour's ends, as the program has it"
    verb.add_argument("--depth-along", choices=("normal", "x", "y"), default="normal", help=axis)
    _add_path(verb)


def _add_simulate(verb: argparse.ArgumentParser) -> None:
    _add_source(verb, "NC program")
    what = "tool, material, machine and stock"
    verb.add_argument("--setup", metavar="SETUP.toml", type=Path, required=True, help=what)
    verb.add_argument("--report", metavar="DIR", type=Path, required=True, help="directory for plots, table, animation")
    verb.add_argument("--nominal", metavar="FILE", help="profile, where the program does not show it")
    verb.add_argument("--limit", type=float, default=0.5, metavar="MM", help="largest correction to show")
    bound = "correct until the predicted error is at most this"
    verb.add_argument("--iterate", metavar="MM", type=float, help=bound)
    wall = "height above the tool's tip at which the wall is wanted, with its shift and tilt; give several"
    verb.add_argument("--heights", metavar="MM", type=float, action="append", default=[], help=wall)
    moved = "write the program with its contour moved by the wall's mean error over the --heights"
    verb.add_argument("--shifted", metavar="OUT.nc", type=Path, help=moved)
    lean = "write the program with the tool tilted before each wall, for machines with a [tilt] table; needs --heights"
    verb.add_argument("--tilted", metavar="OUT.nc", type=Path, help=lean)
    slow = "write the program with lower feeds at corners that the machine rounds off by more than --corner-error"
    verb.add_argument("--slowed", metavar="OUT.nc", type=Path, help=slow)
    bound = "largest distance between a corner and the path of the tool"
    verb.add_argument("--corner-error", metavar="MM", type=float, help=bound)
    log = "log of the program (t,x,y or t,feed) from which keys of [machine] are identified"
    verb.add_argument("--trace", metavar="TRACE.csv", type=Path, help=log)
    key = "key of [machine] to identify; give several (default: times and gain that the setup does not state)"
    verb.add_argument("--identify", metavar="KEY", choices=MACHINE_KEYS, action="append", default=[], help=key)
    _add_path(verb)


def _add_probe(verb: argparse.ArgumentParser) -> None:
    _add_source(verb, "program that cuts the contour", required=False)
    verb.add_argument("--nominal", metavar="FILE", help="profile to measure, with a program or without")
    verb.add_argument("--tool-diameter", metavar="MM", type=float, help="cutter diameter, with --program")
    _add_side(verb)
    verb.add_argument("--probe-radius", metavar="MM", type=float, required=True, help="effective radius of the ball")
    verb.add_argument("--dialect", metavar="NAME", required=True, help="control: linuxcnc, grbl, fanuc, haas, …")
    verb.add_argument("--output", metavar="PROBE.nc", type=Path, required=True, help="measuring program")
    number = verb.add_mutually_exclusive_group()
    number.add_argument("--points-count", metavar="N", type=int, help="so many points (default 40)")
    number.add_argument("--spacing", metavar="MM", type=float, help="a point every so many millimetres")
    verb.add_argument("--curvature", action="store_true", help="denser where the contour bends")
    verb.add_argument("--contour", metavar="N", type=int, help="only this contour, from 1")
    verb.add_argument("--stretch", metavar="N", type=int, help="only this smooth stretch, from 1")
    how = "along an axis where the slope allows it (auto), always along an axis, or along the normal"
    verb.add_argument("--touch", choices=("auto", "axis", "normal"), default="auto", help=how)
    for name, default, text in (
        ("z", None, "height to measure at (default: the middle of the deepest cut)"),
        ("safe-z", None, "height at which the probe passes over everything (default: the program's)"),
        ("clearance", 2.0, "distance from which a touch begins (default 2)"),
        ("overtravel", 1.0, "how far behind the surface a touch gives up (default 1)"),
        ("stock", 0.0, "stock that is still on the contour (default 0)"),
        ("free-width", None, "how far beside the contour it is free"),
        ("feed", 100.0, "feed of the touch, mm/min (default 100)"),
        ("positioning-feed", 1000.0, "feed of moves at measuring height, mm/min (default 1000)"),
    ):
        unit = "MM/MIN" if "feed" in name else "MM"
        verb.add_argument(f"--{name}", metavar=unit, type=float, default=default, help=text)
    verb.add_argument("--tool", metavar="N", type=int, help="number of the probe in the magazine")
    verb.add_argument("--log", metavar="NAME", help="name of the file that the control writes")


def _add_side(verb: argparse.ArgumentParser) -> None:
    """How a program's path is understood."""
    verb.add_argument("--side", choices=("left", "right", "auto"), default="auto", help="cutter's side of the contour")
    verb.add_argument(
        "--cutter-compensation",
        choices=("contour", "wear"),
        default="contour",
        help="what a program with G41/G42 gives: the contour, or the centre path",
    )


def _add_path(verb: argparse.ArgumentParser) -> None:
    """How a program's path is understood and written."""
    _add_side(verb)
    verb.add_argument("--tolerance", type=float, default=0.001, metavar="MM", help="largest path error")
    verb.add_argument(
        "--output-moves", choices=("keep", "lines", "arcs", "nurbs"), default="keep", help="kinds of move to write"
    )


def _add_series(verb: argparse.ArgumentParser) -> None:
    journal = "record the part in a journal (default: beside the nominal, else the program, with .journal added)"
    verb.add_argument("--journal", metavar="FILE", nargs="?", const="", help=journal)
    same = "with --journal: a run that it has already, with its output in place, is done and no error"
    verb.add_argument("--once", action="store_true", help=same)
    verb.add_argument("--control", metavar="ewma:K", help="correct again only when the smoothed deviation demands it")
    for name, what in (
        ("control-limit", "smoothed deviation within which the program stays as it is"),
        ("control-tolerance", "a part beyond it is corrected at once by its own deviation"),
        ("control-alarm", "a part beyond it is refused until --accept difference"),
        ("control-abort", "a part beyond it is refused"),
        ("step-limit", "largest change by one correction"),
        ("sum-limit", "largest sum of all corrections"),
    ):
        verb.add_argument(f"--{name}", metavar="MM", type=float, help=what)


def _add_outputs(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("--output", metavar="OUT", type=Path, required=True, help="corrected program or document")
    verb.add_argument("--gcode", metavar="OUT.nc", type=Path, help="posted program of a corrected document")


def _add_batch(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("batch", metavar="BATCH.toml", type=Path, help="jobs to run")
    verb.add_argument("--jobs", metavar="N", type=int, help="so many at a time (default: one a processor)")
    verb.add_argument("--dask", metavar="ADDRESS", help="scheduler of dask.distributed whose workers run the jobs")
    verb.add_argument("--again", action="store_true", help="also run what an earlier run has done")


def _add_history(verb: argparse.ArgumentParser) -> None:
    only = "journal of a series (default: the only one in this directory)"
    verb.add_argument("journal", metavar="JOURNAL", type=Path, nargs="?", help=only)
    verb.add_argument("--csv", metavar="FILE", type=Path, help="write every entry there")
    verb.add_argument("--report", metavar="DIR", type=Path, help="write history.html and history.csv there")
