# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far long work is, told through one callback, which may raise to stop it.

Who starts work says who hears of it (`heard`); the work says what it is at (`stage`) and comes by often (`step`). What
hears may raise `Stopped` there. Once a file is being put in its place nobody is asked any more (`settle`): what was
written is always reported as written. Where nobody listens all of this does nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

Callback = Callable[[str, float], None]
"""Gets the name of a stage and the share of the whole that is done, 0 to 1."""

STAGES = {
    "read": 0.0,
    "prepare": 0.1,
    "fit": 0.15,
    "compare": 0.2,
    "examine": 0.3,
    "separate": 0.4,
    "simulate": 0.45,
    "write": 0.7,
    "draw": 0.9,
}
"""Stages of work in their order, and the share of the whole that is done when one begins."""

_ENDS = dict(zip(STAGES, (*list(STAGES.values())[1:], 1.0), strict=True))


class Stopped(BaseException):
    """Nobody wants the work any more. Like an interrupt from the keyboard it is no error that work could meet."""


class _Listener:
    """Who hears of one piece of work, and how far that is."""

    __slots__ = ("callback", "settled", "share", "stage")

    def __init__(self, callback: Callback) -> None:
        self.callback, self.stage, self.share, self.settled = callback, "", 0.0, False

    def tell(self, share: float) -> None:
        """Tell the share; it never falls, though a stage may come twice."""
        self.share = max(self.share, share)
        if not self.settled:
            self.callback(self.stage, self.share)


_listener: ContextVar[_Listener | None] = ContextVar("millcorr.progress", default=None)


@contextmanager
def heard(callback: Callback | None) -> Iterator[None]:
    """Have a callback hear of the work inside; None leaves it to whoever hears already.

    Parameters
    ----------
    callback : callable
        Called in the thread that works. What it raises ends the work: `Stopped`, where nobody wants it any more.
    """
    if callback is None:
        yield
        return
    token = _listener.set(_Listener(callback))
    try:
        yield
    finally:
        _listener.reset(token)


def stage(name: str) -> None:
    """A stage begins: one of `STAGES`."""
    listener = _listener.get()
    if listener is not None:
        listener.stage = name
        listener.tell(STAGES[name])


def step(done: float = 0.0) -> None:
    """The work goes on and may be stopped here; a loop says which share of its stage is done."""
    listener = _listener.get()
    if listener is not None:
        begun = STAGES.get(listener.stage, 0.0)
        listener.tell(begun + done * (_ENDS.get(listener.stage, begun) - begun))


def settle() -> None:
    """What was made is put in its place now: a last chance to stop, and none from here to the end of the work."""
    step()
    listener = _listener.get()
    if listener is not None:
        listener.settled = True
