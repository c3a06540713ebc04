# SPDX-License-Identifier: LGPL-2.1-or-later
"""Python packages that millcorr needs and FreeCAD's Python may lack: said once, and installed for FreeCAD alone.

Imported when FreeCAD starts: nothing here needs what may be missing.
"""

from __future__ import annotations

import importlib
import re
import shutil
import subprocess
import sys
import tomllib
from functools import cache
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui

from millcorr.app.text import translate

from .qt import QtCore, QtWidgets
from .worker import Worker

_PROJECT = Path(__file__).resolve().parents[2] / "pyproject.toml"
_told: list[Any] = []


@cache
def needed() -> dict[str, str]:
    """Packages that millcorr needs, each with the least version that will do."""
    said = tomllib.loads(_PROJECT.read_text(encoding="utf-8"))["project"]["dependencies"]
    return dict(one.split(">=") for one in said)


def missing() -> list[str]:
    """Packages that are not there, or too old, as pip takes them."""
    return [f"{name}>={least}" for name, least in needed().items() if not _there(name, least)]


def _there(name: str, least: str) -> bool:
    if find_spec(name) is None:
        return False
    try:
        found = metadata.version(name)
    except metadata.PackageNotFoundError:
        # Made by hand, or frozen into FreeCAD: it is there, and will say itself what it lacks.
        return True
    # Built without its history a package states version 0, as Debian's shapely 2.1 does: that tells nothing.
    return _numbers(found) in ((), (0,)) or _numbers(found) >= _numbers(least)


def _numbers(version: str) -> tuple[int, ...]:
    return tuple(map(int, re.findall(r"\d+", version)[:2]))


def lacking() -> str:
    """Why no command can work; empty where all can."""
    if not _lack:
        return ""
    return translate("Millcorr", "Python packages, which a dialog offers to install: {}").format(", ".join(_lack))


_lack = missing()
"""What FreeCAD started without."""


def directory() -> Path:
    """Where FreeCAD looks for packages that its addon manager installs."""
    try:
        utilities = importlib.import_module("addonmanager_utilities")
        return Path(utilities.get_pip_target_directory())
    except (ImportError, AttributeError):
        # FreeCAD 0.20 has the directory, and no function for it.
        return Path(FreeCAD.getUserAppDataDir()) / "AdditionalPythonPackages"


def python() -> str | None:
    """A Python of FreeCAD's own version, to run pip with; None where there is none."""
    try:
        utilities = importlib.import_module("addonmanager_utilities")
        found = utilities.get_python_exe()
        if found:
            return str(found)
    except (ImportError, AttributeError):
        pass
    names = (f"python{sys.version_info.major}.{sys.version_info.minor}", "python3", "python")
    beside = [Path(sys.prefix) / "bin" / name for name in names] + [Path(sys.prefix) / "python.exe"]
    wanted = "{}.{}".format(*sys.version_info)
    for place in (*map(str, beside), *names):
        program = shutil.which(place)
        if program is None:
            continue
        ask = [program, "-c", "import sys; print('{}.{}'.format(*sys.version_info))"]
        if subprocess.run(ask, capture_output=True, text=True, check=False).stdout.strip() == wanted:
            return program
    return None


def command() -> list[str]:
    """What installs the missing packages for FreeCAD."""
    target = ["-m", "pip", "install", "--upgrade", "--target", str(directory())]
    return [python() or "python3", *target, *_lack, *_kept()]


def _kept() -> list[str]:
    """Numpy as it is: pip would put its newest beside it, which a SciPy that was built for this one cannot use."""
    if find_spec("numpy") is None or any(one.startswith("numpy") for one in _lack):
        return []
    return [f"numpy=={importlib.import_module('numpy').__version__}"]


def install() -> str:
    """Install what is missing; what pip complains of, or nothing where all went well. Takes its time."""
    directory().mkdir(parents=True, exist_ok=True)
    try:
        ran = subprocess.run(command(), capture_output=True, text=True, check=False)
    except OSError as error:
        return str(error)
    return "" if ran.returncode == 0 else "\n".join((ran.stderr or ran.stdout).strip().splitlines()[-6:])


class MissingDialog(QtWidgets.QMessageBox):
    """What is missing, a button that installs it, and what came of that."""

    def __init__(self) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.setObjectName("MillcorrMissing")
        self.setModal(False)
        self.setIcon(QtWidgets.QMessageBox.Icon.Warning)
        self.setWindowTitle("Millcorr")
        self.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        said = translate(
            "Millcorr",
            "Millcorr needs Python packages that FreeCAD's Python does not have: {}.\n\nThey can be installed into "
            "{}, for FreeCAD alone, from the network.",
        )
        self.setText(said.format(", ".join(_lack), directory()))
        self.installing = QtWidgets.QPushButton(translate("Millcorr", "Install"))
        self.installing.setObjectName("Install")
        self.addButton(self.installing, QtWidgets.QMessageBox.ButtonRole.ActionRole)
        self.addButton(QtWidgets.QMessageBox.StandardButton.Close)
        # A button of a message closes it: this one works on.
        self.installing.clicked.disconnect()
        self.installing.clicked.connect(lambda *_: self._install())
        self._worker = Worker(self, self._ended, lambda error: self._ended(str(error)))

    def _install(self) -> None:
        self.installing.setEnabled(False)
        self.setInformativeText(translate("Millcorr", "Installing\u2026"))
        self._worker.start(install)

    def _ended(self, trouble: str) -> None:
        self.installing.setEnabled(bool(trouble))
        if not trouble:
            self.setIcon(QtWidgets.QMessageBox.Icon.Information)
            self.setInformativeText(translate("Millcorr", "Installed. Start FreeCAD again to use them."))
            return
        told = translate("Millcorr", "They could not be installed: {}\n\nIn a terminal, this does the same:\n{}")
        if sys.platform.startswith("linux"):
            told += "\n\n" + translate("Millcorr", "On Debian and Ubuntu pip comes with: apt install python3-pip")
        self.setInformativeText(told.format(trouble, " ".join(command())))


def tell_once() -> None:
    """Say what is missing, once while FreeCAD runs."""
    if _lack and not _told:
        _told.append(MissingDialog())
        _told[0].show()
