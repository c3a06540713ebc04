# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in a thread beside the window: how far it is, its outcome, and how to stop it."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

from millcorr import progress
from millcorr.app.text import QT_TRANSLATE_NOOP
from millcorr.progress import Stopped

_text = QT_TRANSLATE_NOOP

STAGES = {
    "read": _text("Millcorr", "Reading points"),
    "prepare": _text("Millcorr", "Reading the program"),
    "fit": _text("Millcorr", "Best fit"),
    "compare": _text("Millcorr", "Deviations"),
    "examine": _text("Millcorr", "Looking for doubts"),
    "separate": _text("Millcorr", "Separating form from scatter"),
    "simulate": _text("Millcorr", "Cutting in the model"),
    "write": _text("Millcorr", "Laying and proving the path"),
    "draw": _text("Millcorr", "Drawing"),
}
"""What the user reads of the core's stages."""


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
        self._heard = "", 0.0
        self._unwanted = False
        self.error: BaseException | None = None
        self.cancelled = False

    def start(self) -> Work:
        """Begin; gives itself."""
        self._thread.start()
        return self

    def _run(self) -> None:
        try:
            with progress.heard(self._hear):
                self._value = self._function()
        except Stopped:
            self.cancelled = True
        # Whatever it is, it belongs to the one who asked for the work.
        except BaseException as error:  # noqa: BLE001
            self.error = error

    def _hear(self, stage: str, share: float) -> None:
        self._heard = STAGES.get(stage, ""), share
        if self._unwanted:
            raise Stopped

    def wait(self) -> None:
        """Wait until it has ended."""
        self._thread.join()

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
        """Ask it to stop, which it does when it next tells how far it is; what it has begun to put in place it ends."""
        self._unwanted = True

    def progress(self) -> tuple[str, float]:
        """What it is at, to be translated, and the share of the whole that is done; the share never falls."""
        return self._heard
