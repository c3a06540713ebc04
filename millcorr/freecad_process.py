# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run FreeCAD's command line for what only FreeCAD can do, from a Python that knows nothing of it.

The request goes there and the answer comes back as JSON files: FreeCAD prints progress on its standard output
and gives no useful exit status.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from . import errors, progress
from .errors import MillcorrError, UsageError

REMEDY = "install FreeCAD (Debian: apt install freecad), or set FREECADCMD to its command line program"

_POLL = 0.1
"""Seconds between two looks whether a process is still wanted."""

_SCRIPT = """\
import json, os, sys
def _run():
    request_file = {request!r}
    answer_file = {answer!r}
    if os.path.exists(answer_file):
        return
    with open(request_file, encoding="utf-8") as stream:
        request = json.load(stream)
    sys.path.insert(0, request["addon"])
    if request["tag"] == sys.implementation.cache_tag:
        sys.path[1:1] = request["packages"]
    try:
        from millcorr.app import process
    except ModuleNotFoundError as error:
        missing = error.name or str(error)
        answer = {{"error": "UsageError", "message":
            "FreeCAD's Python " + sys.version.split()[0] + " lacks the package " + missing
            + "; install it for that Python (Debian: apt install python3-" + missing.split(".")[0] + ")"}}
        with open(answer_file, "w", encoding="utf-8") as stream:
            json.dump(answer, stream)
    else:
        process.answer(request, answer_file)
_run()
"""


def command() -> str:
    """FreeCAD's command line program.

    Returns
    -------
    str
        From the environment variable FREECADCMD, else ``freecadcmd`` or ``FreeCADCmd`` on the PATH.

    Raises
    ------
    UsageError
        If there is none.
    """
    named = os.environ.get("FREECADCMD")
    if named:
        found = shutil.which(named)
        if found is None:
            raise UsageError(f"FREECADCMD names {named}, which is no program; {REMEDY}")
        return found
    for name in ("freecadcmd", "FreeCADCmd"):
        found = shutil.which(name)
        if found is not None:
            return found
    raise UsageError(f"a FreeCAD document needs FreeCAD, which was not found; {REMEDY}")


def packages() -> list[str]:
    """Directories from which this Python takes the packages that millcorr needs."""
    out: list[str] = []
    for name in ("numpy", "scipy", "shapely", "matplotlib"):
        module = sys.modules.get(name)
        if module is None:
            from importlib.util import find_spec

            spec = find_spec(name)
            file = None if spec is None else spec.origin
        else:
            file = module.__file__
        if file is not None:
            directory = str(Path(file).resolve().parents[1])
            if directory not in out:
                out.append(directory)
    return out


def call(function: str, arguments: dict[str, Any], timeout: float | None = None) -> dict[str, Any]:
    """Call a function of `millcorr.app.process` in FreeCAD.

    Parameters
    ----------
    function : str
        Its name, such as ``"correct"`` or ``"demonstration"``.
    arguments : dict
        Its arguments, in what JSON can hold.
    timeout : float, optional
        Seconds to wait at most.

    Returns
    -------
    dict
        What it returns.

    Raises
    ------
    MillcorrError
        Of the class and with the text that it raised there.
    UsageError
        If FreeCAD is missing, does not start, or lacks a package.
    """
    program = command()
    with tempfile.TemporaryDirectory(prefix="millcorr-") as directory:
        here = Path(directory)
        request, answer, script = here / "request.json", here / "answer.json", here / "millcorr_request.py"
        request.write_text(
            json.dumps(
                {
                    "function": function,
                    "arguments": arguments,
                    "addon": str(Path(__file__).resolve().parents[1]),
                    "packages": packages(),
                    "tag": sys.implementation.cache_tag,
                }
            ),
            encoding="utf-8",
        )
        script.write_text(_SCRIPT.format(request=str(request), answer=str(answer)), encoding="utf-8")
        environment = dict(os.environ)
        # The user's own settings hold: they say where post processors lie. Without a home there are none.
        environment.setdefault("HOME", directory)
        # Without a screen FreeCAD's Qt must not look for one.
        environment.setdefault("QT_QPA_PLATFORM", "offscreen")
        # A virtual environment of this Python must not decide where FreeCAD's looks for its own library.
        for name in ("PYTHONHOME", "PYTHONPATH", "VIRTUAL_ENV"):
            environment.pop(name, None)
        try:
            process = subprocess.Popen(
                [program, str(script)],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                env=environment,
            )
        except OSError as error:
            raise UsageError(f"{program} does not start: {error.strerror or error}; {REMEDY}") from error
        said = _waited_for(process, program, timeout)
        if not answer.exists():
            lines = said.decode("utf-8", "replace").strip().splitlines()
            last = lines[-1].strip() if lines else f"exit status {process.returncode}"
            raise UsageError(f"{program} ended without an answer: {last}")
        answered: dict[str, Any] = json.loads(answer.read_text(encoding="utf-8"))
    if "error" in answered:
        raise _error(answered)
    returned: dict[str, Any] = answered["value"]
    return returned


def _waited_for(process: subprocess.Popen[bytes], program: str, timeout: float | None) -> bytes:
    """What a process says until it ends; it is ended where nobody wants it any more, or after `timeout` seconds."""
    begun = time.monotonic()
    with process:
        try:
            while True:
                try:
                    return process.communicate(timeout=_POLL)[0]
                except subprocess.TimeoutExpired:
                    progress.step()
                if timeout is not None and time.monotonic() - begun > timeout:
                    raise UsageError(f"{program} did not finish within {timeout:g} s")
        except BaseException:
            process.kill()
            raise


def _error(answered: dict[str, Any]) -> MillcorrError:
    """The error that was raised in FreeCAD, as far as it can be made again; its traceback as a note."""
    kind = getattr(errors, answered["error"], MillcorrError)
    if not (isinstance(kind, type) and issubclass(kind, MillcorrError)):
        kind = MillcorrError
    error = kind(answered["message"])
    if "traceback" in answered:
        error.add_note(answered["traceback"])
    if isinstance(error, errors.FormatError):
        error.file, error.line = answered.get("file"), answered.get("line")
    return error
