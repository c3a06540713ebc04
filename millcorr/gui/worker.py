# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in the background, watched by the window's own event loop."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .background import Work
from .qt import QtCore

POLL = 40
"""The work is looked at every so many milliseconds."""


class Worker:
    """Runs one piece of work at a time; a new one takes the place of the old.

    Parameters
    ----------
    parent : QObject
        Dies with it.
    on_done : callable
        Gets what the work gave.
    on_failed : callable
        Gets the exception.
    on_progress : callable
        Gets the stage, to be translated, and the share that is done.
    on_stopped : callable
        Called where work that was to `stop` has, without an outcome.
    """

    def __init__(
        self,
        parent: Any,
        on_done: Callable[[Any], None],
        on_failed: Callable[[BaseException], None],
        on_progress: Callable[[str, float], None] = lambda stage, share: None,
        on_stopped: Callable[[], None] = lambda: None,
    ) -> None:
        self._on_done, self._on_failed, self._on_progress = on_done, on_failed, on_progress
        self._on_stopped = on_stopped
        self._work: Work | None = None
        self._timer = QtCore.QTimer(parent)
        self._timer.setInterval(POLL)
        self._timer.timeout.connect(self._look)

    @property
    def busy(self) -> bool:
        """Whether work is going on."""
        return self._work is not None

    def start(self, function: Callable[[], Any]) -> None:
        """Begin work; what was going on is cancelled."""
        self.cancel()
        self._work = Work(function).start()
        self._timer.start()

    def cancel(self) -> None:
        """Stop; nobody is called back."""
        self._timer.stop()
        if self._work is not None:
            self._work.cancel()
            self._work = None

    def stop(self) -> None:
        """Ask work that writes to stop; what comes of it is still told, for it may have written already."""
        if self._work is not None:
            self._work.cancel()

    def finish(self) -> None:
        """Stop, wait for the end, and tell what came of it at once."""
        if self._work is not None:
            self._work.cancel()
            self._work.wait()
            self._look()

    def _look(self) -> None:
        work = self._work
        if work is None:
            return
        if not work.done:
            self._on_progress(*work.progress())
            return
        self._timer.stop()
        self._work = None
        if work.cancelled:
            self._on_stopped()
        elif work.error is not None:
            self._on_failed(work.error)
        else:
            self._on_done(work.value)
