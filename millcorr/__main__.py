# SPDX-License-Identifier: LGPL-2.1-or-later
# PYTHON_ARGCOMPLETE_OK
"""The command line: ``python3 -m millcorr VERB …``."""

from __future__ import annotations

import argparse
import json
import logging
import os
import sys
import traceback
from collections.abc import Callable, Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any

from millcorr.messages import AS_DATA, as_data, message, option

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
    try:
        from .cli.arguments import parser
    except ModuleNotFoundError as error:
        return _failed(argparse.Namespace(debug=False), _lacking(error), EXIT_USAGE)
    known = parser()
    _complete(known)
    arguments = known.parse_args(argv)
    logging.basicConfig(level=logging.DEBUG if arguments.debug else logging.WARNING, format="%(message)s")
    try:
        status = _VERBS[arguments.verb](arguments)
    except MillcorrError as error:
        return _failed(arguments, error, _exit_status(error))
    except OSError as error:
        where = error.filename or ""
        return _failed(arguments, f"{where}: {error.strerror or error}", EXIT_INPUT)
    except ModuleNotFoundError as error:
        return _failed(arguments, _lacking(error), EXIT_USAGE)
    except KeyboardInterrupt as error:
        return _failed(arguments, str(error) or "interrupted; nothing was written", 130)
    except Exception as error:  # noqa: BLE001 - the contract: one line, never a traceback
        return _failed(
            arguments,
            message(f"internal fault ({error!r}); nothing was written, ", option("debug"), " shows where"),
            EXIT_FAULT,
        )
    return status or 0


def _lacking(error: ModuleNotFoundError) -> str:
    return (
        f"this Python lacks the package {error.name}: pip install numpy scipy shapely, or use build/venv/bin/python "
        "after `make demo`"
    )


def _complete(known: argparse.ArgumentParser) -> None:
    """Answer the shell that completes a line, where argcomplete is installed and set up; else nothing."""
    if "_ARGCOMPLETE" in os.environ:
        try:
            import argcomplete
        except ImportError:
            return
        argcomplete.autocomplete(known)


def _exit_status(error: MillcorrError) -> int:
    if isinstance(error, UsageError):
        return EXIT_USAGE
    if isinstance(error, RefusedError):
        return EXIT_REFUSED
    return EXIT_INPUT


def _failed(arguments: argparse.Namespace, error: object, status: int) -> int:
    if arguments.debug:
        traceback.print_exc()
    told = json.dumps(as_data(error)) if AS_DATA in os.environ else "millcorr: " + " ".join(str(error).split())
    print(told, file=sys.stderr)
    return status


def _say(text: str) -> None:
    """Print what was done. Where nobody can read it, a full disk or a closed pipe, it was done all the same."""
    try:
        print(text, flush=True)
    except OSError:
        # Nor must Python try again when it ends.
        sys.stdout = open(os.devnull, "w", encoding="utf-8")


def _correct(arguments: argparse.Namespace) -> None:
    _run(arguments, arguments.output)


def _check(arguments: argparse.Namespace) -> None:
    _run(arguments, None)


def _inspect(arguments: argparse.Namespace) -> None:
    from .cli import verbs

    _say(verbs.inspect(arguments.measured, _reading(arguments)))


def _convert(arguments: argparse.Namespace) -> None:
    from .cli import verbs

    _say(verbs.convert(arguments.measured, arguments.output, _reading(arguments)))


def _split(arguments: argparse.Namespace) -> None:
    from .cli import verbs
    from .correction.settings import Settings

    names = ("side", "cutter_compensation", "tolerance", "output_moves", "depth_along")
    done = verbs.split_program(
        arguments.program,
        tool_diameter=arguments.tool_diameter,
        depth=arguments.depth,
        at=arguments.at,
        nominal=arguments.nominal,
        output=arguments.output,
        settings=Settings(
            method="transfer", depth=arguments.depth, **{name: getattr(arguments, name) for name in names}
        ),
    )
    _say(done)


def _simulate(arguments: argparse.Namespace) -> None:
    from .cli import verbs
    from .correction.settings import Settings
    from .production.simulation import Asked

    names = ("side", "cutter_compensation", "tolerance", "output_moves", "limit", "iterate")
    chosen = Settings(method="predicted", **{name: getattr(arguments, name) for name in names})
    _say(
        verbs.simulate_program(
            arguments.program,
            document=arguments.document,
            operation=arguments.operation,
            setup=arguments.setup,
            report=arguments.report,
            nominal=arguments.nominal,
            settings=chosen,
            asked=Asked(
                heights=tuple(arguments.heights),
                slowed=arguments.slowed,
                corner_error=arguments.corner_error,
                shifted=arguments.shifted,
                tilted=arguments.tilted,
                trace=arguments.trace,
                identify=tuple(arguments.identify),
            ),
        )
    )


def _probe(arguments: argparse.Namespace) -> None:
    from .cli import measuring_task

    names = (
        "program document operation nominal model tool_diameter side cutter_compensation dialect output z safe_z "
        "feed tool log"
    )
    room = {name: getattr(arguments, name) for name in ("clearance", "overtravel", "stock", "free_width", "touch")}
    done = measuring_task.measuring_program(
        **{name: getattr(arguments, name) for name in names.split()},
        positioning=arguments.positioning_feed,
        probe={"ball_radius": arguments.probe_radius}
        | {name: value for name, value in room.items() if value is not None},
        placement={
            "count": arguments.points_count,
            "spacing": arguments.spacing,
            "by_curvature": arguments.curvature,
            "contour": arguments.contour,
            "stretch": arguments.stretch,
        },
    )
    _say(done)


def _batch(arguments: argparse.Namespace) -> int:
    from .cli import jobs

    outcomes = jobs.run(
        arguments.batch, workers=arguments.jobs, dask=arguments.dask, again=arguments.again, out=sys.stdout
    )
    _say(jobs.in_words(outcomes))
    return jobs.exit_status(outcomes)


def _reading(arguments: argparse.Namespace) -> Any:
    from .readers.reading import FIELDS, Reading

    return Reading.from_dict({name: getattr(arguments, name) for name in FIELDS if hasattr(arguments, name)})


def _run(arguments: argparse.Namespace, output: Path | None) -> None:
    from . import pipeline
    from .cli import verbs
    from .report import Exports

    known = [field.name for field in fields(pipeline.Settings) if hasattr(arguments, field.name)]
    given: dict[str, Any] = {name: getattr(arguments, name) for name in known}
    settings: dict[str, Any] = {
        name: tuple(value) if isinstance(value, list) else value for name, value in given.items()
    }
    asked = verbs.CorrectionAsked(
        arguments.measured,
        _reading(arguments),
        arguments.nominal,
        arguments.tool_diameter,
        output,
        arguments.report,
        Exports(tuple(arguments.export), arguments.zone),
        pipeline.Settings(**settings),
        arguments.setup,
        once=getattr(arguments, "once", False),
        **_series(arguments),
    )
    if arguments.program is not None:
        if arguments.operation is not None or getattr(arguments, "gcode", None) is not None:
            raise UsageError(
                option("operation"),
                " and ",
                option("gcode"),
                " belong to ",
                option("document"),
                "; with ",
                option("program"),
                " use ",
                option("output"),
            )
        done = verbs.correct_program(arguments.program, asked, table=getattr(arguments, "table", False))
    else:
        if getattr(arguments, "table", False):
            raise UsageError(
                option("table"),
                " belongs to ",
                option("program"),
                "; with ",
                option("document"),
                " use ",
                option("report"),
                ", which writes deviations.csv",
            )
        gcode = getattr(arguments, "gcode", None)
        done = verbs.correct_document(arguments.document, asked, operation=arguments.operation, gcode=gcode)
    _say(done)


def _series(arguments: argparse.Namespace) -> dict[str, Any]:
    """What was said about the series: journal and rules."""
    from .production.process_control import LIMITS

    limits = {name: getattr(arguments, name, None) for name in LIMITS}
    return {
        "journal": getattr(arguments, "journal", None),
        "control": getattr(arguments, "control", None),
        "limits": {name: value for name, value in limits.items() if value is not None},
    }


def _history(arguments: argparse.Namespace) -> None:
    from .cli import verbs

    _say(verbs.history(arguments.journal, csv=arguments.csv, report=arguments.report))


_VERBS: dict[str, Callable[[argparse.Namespace], int | None]] = {
    "correct": _correct,
    "check": _check,
    "inspect": _inspect,
    "convert": _convert,
    "split": _split,
    "simulate": _simulate,
    "probe": _probe,
    "batch": _batch,
    "history": _history,
}


if __name__ == "__main__":
    sys.exit(main())
