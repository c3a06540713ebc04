# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of the command line: verbs and their options. What they do is said in `millcorr.__main__`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any, NoReturn

from millcorr import __version__
from millcorr.correction import settings
from millcorr.correction.settings import Exports, Settings
from millcorr.messages import flag
from millcorr.options import Declared, options_of
from millcorr.readers.reading import Reading

OUTPUTS = ("output", "gcode", "report", "slowed", "shifted", "tilted")
"""Options that name what a verb writes."""

MACHINE_KEYS = (
    "acceleration_time_x_ms",
    "acceleration_time_y_ms",
    "position_gain_per_s",
    "contour_speed_change_mm_min",
)
"""Keys of a setup that a log can tell."""


EXAMPLES = {
    "correct": "--program part.nc --tool-diameter 10 --measured part.csv --points contact --output corrected.nc",
    "check": "--program part.nc --tool-diameter 10 --measured part.csv --points contact --report report",
    "split": "--program finish.nc --tool-diameter 10 --depth 0.8 --output first.nc",
    "simulate": "--program part.nc --setup setup.toml --report report",
    "probe": "--program part.nc --tool-diameter 10 --probe-radius 3 --dialect linuxcnc --output probe.nc",
    "inspect": "part.csv",
    "convert": "part.msr --output part.csv",
    "batch": "jobs.toml --jobs 4",
    "history": "part.nc.journal --report history",
}
"""One command of each verb, which its help shows."""


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
        example = f"example: python3 -m millcorr {name} {EXAMPLES[name]}"
        described = text[0].upper() + text[1:] + "."
        return verbs.add_parser(name, help=text, description=described, epilog=example, allow_abbrev=False)

    for name, text in (("correct", "write a corrected program or document"), ("check", "deviations and report only")):
        verb = add(name, text)
        _add_inputs(verb)
        if name == "correct":
            _add_outputs(verb)
            _add_series(verb)
        else:
            listed = "list every point: as measured, contact point, slope, error"
            verb.add_argument("--table", action="store_true", help=listed)
        written = _heading(verb, settings.WRITTEN)
        written.add_argument("--report", metavar="DIR", type=Path, help="write report.html, .json, .csv there")
        _add(verb, Exports)
    _add_split(add("split", "program of a first cut, which leaves a part of the allowance"))
    model = "cut a program in the model: forces, deflections and the error to expect, as plots and an animation"
    _add_simulate(add("simulate", model))
    _add_probe(add("probe", "program that measures the contour on the machine"))
    inspect = add("inspect", "what a measured file holds")
    convert = add("convert", "measured file to text x,y,z[,i,j,k]")
    convert.add_argument("--output", "-o", metavar="POINTS.csv", type=Path, required=True, help="file to write")
    for verb in (inspect, convert):
        verb.add_argument("measured", metavar="FILE", type=Path, help="measured file")
        _add(verb, Reading)
    _add_batch(add("batch", "many commands from one file, in parallel"))
    _add_history(add("history", "what a journal of a series holds"))
    for verb in verbs.choices.values():
        verb.add_argument("--debug", action="store_true", help="show the traceback of an error")
    return out


def _add_source(verb: argparse.ArgumentParser, what: str, *, required: bool = True) -> None:
    """What is cut: a program, which is called `what`, or an operation of a document."""
    program = _heading(verb, settings.PROGRAM)
    source = program.add_mutually_exclusive_group(required=required)
    source.add_argument("--program", metavar="PART.nc", type=Path, help=what)
    source.add_argument("--document", metavar="JOB.FCStd", type=Path, help="FreeCAD document with a job")
    program.add_argument("--operation", metavar="LABEL", help="operation of the document (the only one by default)")


def _add(verb: argparse.ArgumentParser, noun: type, *keys: str, **words: Any) -> None:
    """Options that a noun declares, each under its heading: all of them, or those with these keys.

    `words` takes the place of what argparse would be told by the declaration.
    """
    known = options_of(noun)
    for key in keys or known:
        one = known[key]
        said: dict[str, Any] = {"help": _help(one), "dest": key}
        if one.type is bool:
            said["action"] = "store_true"
        else:
            said |= {"type": one.type, "default": list(one.default) if one.several else one.default}
            said |= {"choices": one.choices} if one.choices else {"metavar": one.unit}
            if one.several:
                said["action"] = "append"
            if one.count > 1:
                said |= {"nargs": one.count, "metavar": tuple(one.unit.split())}
        _heading(verb, one.group).add_argument(flag(key), **(said | words))


def _help(one: Declared) -> str:
    """What an option is for, and what it is where it is not given."""
    if one.default is None or one.default is False or one.several:
        return one.help
    usual = f"{one.default:g}" if isinstance(one.default, float) else one.default
    return f"{one.help} (default {usual})"


def _heading(verb: argparse.ArgumentParser, title: str) -> argparse._ArgumentGroup:
    """Group of a verb's options with a title, made where it is not there yet."""
    found = (group for group in verb._action_groups if group.title == title)
    return next(found, None) or verb.add_argument_group(title)


def _add_inputs(verb: argparse.ArgumentParser) -> None:
    _add_source(verb, "NC program to correct")
    program, measured = _heading(verb, settings.PROGRAM), _heading(verb, settings.MEASURED)
    program.add_argument("--nominal", metavar="FILE", help="profile: document#label, step, iges, brep, dxf, json, nc")
    program.add_argument("--tool-diameter", metavar="MM", type=float, help="cutter diameter of the measured surface")
    _add(verb, Settings, "tools", "keep_allowance")
    _add_side(verb)
    several = "measured points; given several times, the deviations of the parts are averaged"
    measured.add_argument("--measured", metavar="FILE", type=Path, action="append", default=[], help=several)
    _add(verb, Reading)
    _add(verb, Settings, "align", "accept")
    _add(verb, Settings, "filter", "method", "gain", "limit", "dead_band", "unmeasured_share")
    _add(verb, Settings, "depth", "next_depth", "depth_along", "transfer_function", "allowance")
    setup = "tool, material, machine and stock, for --method combined and predicted"
    _heading(verb, settings.MODEL).add_argument("--setup", metavar="SETUP.toml", type=Path, help=setup)
    _add(verb, Settings, "iterate")
    _add(verb, Settings, "tolerance", "output_moves")


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
    _add(verb, Settings, "depth_along", help=axis)
    _add_path(verb)


def _add_simulate(verb: argparse.ArgumentParser) -> None:
    _add_source(verb, "NC program")
    what = "tool, material, machine and stock"
    verb.add_argument("--setup", metavar="SETUP.toml", type=Path, required=True, help=what)
    verb.add_argument("--report", metavar="DIR", type=Path, required=True, help="directory for plots, table, animation")
    verb.add_argument("--nominal", metavar="FILE", help="profile, where the program does not show it")
    _add(verb, Settings, "limit", "iterate")
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
    part = "finished part in the program's frame and in mm: where a wall stands, and what stands in the way"
    verb.add_argument("--model", metavar="PART.stl", type=Path, help=part)
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
        ("z", None, "height to measure at (default: the middle of the wall)"),
        (
            "safe-z",
            None,
            "height at which the probe passes over everything (default: the highest rapid, and above the model)",
        ),
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
    _add(verb, Settings, "side", "cutter_compensation")


def _add_path(verb: argparse.ArgumentParser) -> None:
    """How a program's path is understood and written."""
    _add_side(verb)
    _add(verb, Settings, "tolerance", "output_moves")


def _add_series(verb: argparse.ArgumentParser) -> None:
    series = verb.add_argument_group("the series of parts")
    journal = "record the part in a journal (default: beside the nominal, else the program, with .journal added)"
    series.add_argument("--journal", metavar="FILE", nargs="?", const="", help=journal)
    same = "with --journal: a run that it has already, with its output in place, is done and no error"
    series.add_argument("--once", action="store_true", help=same)
    series.add_argument("--control", metavar="ewma:K", help="correct again only when the smoothed deviation demands it")
    for name, what in (
        ("control-limit", "smoothed deviation within which the program stays as it is"),
        ("control-tolerance", "a part beyond it is corrected at once by its own deviation"),
        ("control-alarm", "a part beyond it is refused until --accept difference"),
        ("control-abort", "a part beyond it is refused"),
        ("step-limit", "largest change by one correction"),
        ("sum-limit", "largest sum of all corrections"),
    ):
        series.add_argument(f"--{name}", metavar="MM", type=float, help=what)


def _add_outputs(verb: argparse.ArgumentParser) -> None:
    written = _heading(verb, settings.WRITTEN)
    written.add_argument("--output", metavar="OUT", type=Path, required=True, help="corrected program or document")
    written.add_argument("--gcode", metavar="OUT.nc", type=Path, help="posted program of a corrected document")


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
