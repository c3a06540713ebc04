# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in a thread beside the window: how far it is, its outcome, and how to stop it.

The mathematics knows nothing of windows. How far it is shows from which of its modules is at work.
"""

from __future__ import annotations

import ctypes
import sys
import threading
from collections.abc import Callable, Sequence
from typing import Any

from .text import QT_TRANSLATE_NOOP

_text = QT_TRANSLATE_NOOP

STAGES: tuple[tuple[tuple[str, ...], str, float], ...] = (
    (("readers",), _text("Millcorr", "Reading points"), 0.05),
    (("alignment",), _text("Millcorr", "Best fit"), 0.20),
    (("distrust", "probe"), _text("Millcorr", "Looking for doubts"), 0.25),
    (("deviation", "commanded"), _text("Millcorr", "Deviations"), 0.15),
    (("targets", "compensation", "separation"), _text("Millcorr", "Separating form from scatter"), 0.45),
    (("path.emission",), _text("Millcorr", "Laying and proving the path"), 0.75),
    (("scene",), _text("Millcorr", "Drawing"), 0.92),
)
"""Modules of the core, what the user reads while one is at work, and the share of the whole that is then done."""

_STAGE = {f"millcorr.{module}": (text, share) for modules, text, share in STAGES for module in modules}


class Cancelled(BaseException):
    """Raised inside work that nobody wants any more."""


def stage_of(modules: Sequence[str]) -> tuple[str, float] | None:
    """Stage of work from the names of the modules at work, outermost first; None where none is known."""
    for name in modules:
        parts = name.split(".")
        found = _STAGE.get(".".join(parts[:3])) or _STAGE.get(".".join(parts[:2]))
        if found is not None:
            return found
    return None


class Work:
    """A function that runs in a thread of its own.

    Parameters
    ----------
    function : callable
        Needs nothing of FreeCAD.
    """

    def __init__(self, function: Callable[[], Any]) -> None:
        self._function = function
        self._thread = threading.Thread(target=self._run, name="millcorr", daemon=True)
        self._value: Any = None
        self._share = 0.0
        self._stage = ""
        self.error: BaseException | None = None
        self.cancelled = False

    def start(self) -> Work:
        """Begin; gives itself."""
        self._thread.start()
        return self

    def _run(self) -> None:
        try:
            self._value = self._function()
        except Cancelled:
            self.cancelled = True
        # Whatever it is, it belongs to the one who asked for the work.
        except BaseException as error:  # noqa: BLE001
            self.error = error

    @property
    def done(self) -> bool:
        """Whether it has ended, in whatever way."""
        return not self._thread.is_alive() and self._thread.ident is not None

    @property
    def value(self) -> Any:
        """What the function gave; raises what it raised."""
        if self.error is not None:
            raise self.error
        return self._value

    def cancel(self) -> None:
        """Stop it as soon as it is back in Python; its outcome counts no more from now on."""
        self.cancelled = True
        if self._thread.is_alive() and self._thread.ident is not None:
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread.ident), ctypes.py_object(Cancelled))

    def progress(self) -> tuple[str, float]:
        """What it is at, to be translated, and the share of the whole that is done; the share never falls."""
        frame = sys._current_frames().get(self._thread.ident or 0)
        modules = []
        while frame is not None:
            modules.append(str(frame.f_globals.get("__name__", "")))
            frame = frame.f_back
        found = stage_of(modules[::-1])
        if found is not None and found[1] >= self._share:
            self._stage, self._share = found
        return self._stage, self._share
