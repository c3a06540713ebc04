# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: ``python3 -m millcorr VERB …``."""

from __future__ import annotations

import argparse
import logging
import sys
import traceback
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from . import __version__
from .errors import MillcorrError, RefusedError, UsageError

EXIT_USAGE, EXIT_INPUT, EXIT_REFUSED, EXIT_FAULT = 2, 3, 4, 1


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command.

    Parameters
    ----------
    argv : sequence of str, optional
        Arguments without the program's name; by default those of the process.

    Returns
    -------
    int
        0 done; 2 usage; 3 input that cannot be read or trusted; 4 correction refused; 1 a fault of millcorr.
    """
    arguments = _parser().parse_args(argv)
    logging.basicConfig(level=logging.DEBUG if arguments.debug else logging.WARNING, format="%(message)s")
    try:
        arguments.run(arguments)
    except MillcorrError as error:
        return _failed(arguments, error, _exit_status(error))
    except OSError as error:
        where = error.filename or ""
        return _failed(arguments, f"{where}: {error.strerror or error}", EXIT_INPUT)
    except ModuleNotFoundError as error:
        remedy = "pip install numpy scipy shapely, or use build/venv/bin/python after `make demo`"
        return _failed(arguments, f"this Python lacks the package {error.name}: {remedy}", EXIT_USAGE)
    except KeyboardInterrupt:
        return _failed(arguments, "interrupted; nothing was written", 130)
    except Exception as error:  # noqa: BLE001 - the contract: one line, never a traceback
        return _failed(arguments, f"internal fault ({error!r}); nothing was written, --debug shows where", EXIT_FAULT)
    return 0


def _exit_status(error: MillcorrError) -> int:
    if isinstance(error, UsageError):
        return EXIT_USAGE
    if isinstance(error, RefusedError):
        return EXIT_REFUSED
    return EXIT_INPUT


def _failed(arguments: argparse.Namespace, error: object, status: int) -> int:
    if arguments.debug:
        traceback.print_exc()
    print("millcorr: " + " ".join(str(error).split()), file=sys.stderr)
    return status


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="millcorr", description="Correct milling toolpaths from measured parts.", allow_abbrev=False
    )
    parser.add_argument("--version", action="version", version=f"millcorr {__version__}")
    verbs = parser.add_subparsers(required=True, metavar="VERB")
    for name, run, text in (
        ("correct", _correct, "write a corrected program or document"),
        ("check", _check, "deviations and report only"),
    ):
        verb = verbs.add_parser(name, help=text, description=text.capitalize() + ".", allow_abbrev=False)
        verb.set_defaults(run=run)
        _add_inputs(verb)
        if name == "correct":
            _add_outputs(verb)
        verb.add_argument("--report", metavar="DIR", type=Path, help="write report.html, .json, .csv there")
        verb.add_argument("--debug", action="store_true", help="show the traceback of an error")
    inspect = verbs.add_parser("inspect", help="what a measured file holds", allow_abbrev=False)
    inspect.set_defaults(run=_inspect)
    convert = verbs.add_parser("convert", help="measured file to text x,y,z[,i,j,k]", allow_abbrev=False)
    convert.set_defaults(run=_convert)
    convert.add_argument("--output", "-o", metavar="POINTS.csv", type=Path, required=True, help="file to write")
    for verb in (inspect, convert):
        verb.add_argument("measured", metavar="FILE", type=Path, help="measured file")
        _add_measurement(verb)
        verb.add_argument("--debug", action="store_true", help="show the traceback of an error")
    return parser


def _add_measurement(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("--format", metavar="NAME", help="format of the measured file (by content by default)")
    verb.add_argument("--points", choices=("contact", "centre"), help="what the measured points are")
    verb.add_argument("--probe-radius", metavar="MM", type=float, help="ball radius, for --points centre")
    verb.add_argument("--units", choices=("mm", "inch"), help="unit of the measured file")
    verb.add_argument("--part", metavar="N", type=int, help="which of several measured parts in one file, from 1")
    offset = "origin of the work frame in the machine frame, mm, for files in the machine frame"
    verb.add_argument("--work-offset", metavar=("X", "Y", "Z"), nargs=3, type=float, help=offset)
    columns = "what the columns of a text file are, for layouts that no format covers"
    verb.add_argument("--mapping", metavar="FILE.toml", type=Path, help=columns)


def _add_inputs(verb: argparse.ArgumentParser) -> None:
    source = verb.add_mutually_exclusive_group(required=True)
    source.add_argument("--program", metavar="PART.nc", type=Path, help="NC program to correct")
    source.add_argument("--document", metavar="JOB.FCStd", type=Path, help="FreeCAD document with a job")
    verb.add_argument("--operation", metavar="LABEL", help="operation of the document (the only one by default)")
    several = "measured points; given several times, the deviations of the parts are averaged"
    verb.add_argument("--measured", metavar="FILE", type=Path, required=True, action="append", help=several)
    _add_measurement(verb)
    verb.add_argument("--nominal", metavar="FILE", help="profile: document#label, step, iges, brep, dxf, json, nc")
    verb.add_argument("--tool-diameter", metavar="MM", type=float, help="cutter diameter")
    verb.add_argument("--side", choices=("left", "right", "auto"), default="auto", help="cutter's side of the contour")
    verb.add_argument(
        "--cutter-compensation",
        choices=("contour", "wear"),
        default="contour",
        help="what a program with G41/G42 gives: the contour, or the centre path",
    )
    fits = "best fit before comparing: none, shift, rigid, or some of x, y, turn joined by +; then :zone or :all"
    verb.add_argument("--align", default="none", metavar="FIT", help=fits)
    verb.add_argument(
        "--accept", action="append", default=[], metavar="NAME", help="accept a finding that would stop the correction"
    )
    filters = "none, mean:5, mean:1,2,3,2,1, gauss:MM, robust:MM, auto"
    verb.add_argument("--filter", default="auto", metavar="F", help=filters)
    verb.add_argument("--method", choices=("mirror",), default="mirror", help="how to correct")
    verb.add_argument("--gain", type=float, default=1.0, help="share of the deviation to correct")
    verb.add_argument("--limit", type=float, default=0.5, metavar="MM", help="largest correction")
    verb.add_argument("--dead-band", type=float, default=0.0, metavar="MM", help="leave smaller deviations")
    verb.add_argument("--tolerance", type=float, default=0.001, metavar="MM", help="largest path error")
    verb.add_argument(
        "--output-moves", choices=("keep", "lines", "arcs", "nurbs"), default="keep", help="kinds of move to write"
    )


def _add_outputs(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("--output", metavar="OUT", type=Path, required=True, help="corrected program or document")
    verb.add_argument("--gcode", metavar="OUT.nc", type=Path, help="posted program of a corrected document")


def _correct(arguments: argparse.Namespace) -> None:
    _run(arguments, arguments.output)


def _check(arguments: argparse.Namespace) -> None:
    _run(arguments, None)


def _inspect(arguments: argparse.Namespace) -> None:
    from . import session

    print(session.inspect(arguments.measured, **_measurement_options(arguments)))


def _convert(arguments: argparse.Namespace) -> None:
    from . import session

    print(session.convert(arguments.measured, arguments.output, **_measurement_options(arguments)))


def _measurement_options(arguments: argparse.Namespace) -> dict[str, Any]:
    names = ("format", "points", "probe_radius", "units", "part", "work_offset", "mapping")
    given = {name: getattr(arguments, name) for name in names}
    return {name: value for name, value in given.items() if value is not None}


def _run(arguments: argparse.Namespace, output: Path | None) -> None:
    from . import session

    options = {
        name: getattr(arguments, name)
        for name in (
            "side",
            "align",
            "filter",
            "method",
            "gain",
            "limit",
            "dead_band",
            "tolerance",
            "output_moves",
            "cutter_compensation",
        )
    }
    options["accept"] = tuple(arguments.accept)
    common: dict[str, Any] = {
        "measured": arguments.measured,
        **_measurement_options(arguments),
        "nominal": arguments.nominal,
        "tool_diameter": arguments.tool_diameter,
        "output": output,
        "report": arguments.report,
        "settings": options,
    }
    if arguments.program is not None:
        if arguments.operation is not None or getattr(arguments, "gcode", None) is not None:
            raise UsageError("--operation and --gcode belong to --document; with --program use --output")
        done = session.correct_program(arguments.program, **common)
    else:
        done = session.correct_document(
            arguments.document, operation=arguments.operation, gcode=getattr(arguments, "gcode", None), **common
        )
    print(done)


if __name__ == "__main__":
    sys.exit(main())
