# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long the window stands still, whatever else the machine does.

A machine that others use slows the window, too. Another process does the same small piece of work again and again:
how much longer than at its fastest that takes while the window stands still is how much of the pause is not ours.
"""

import subprocess
import time

from PySide import QtCore
from window import check, found, path

FREEZE = 0.2
"""The window may not stand still longer than this, in s, on a machine that does nothing else."""

LOOPS = 40_000

_WORK = """
def work(loops):
    total = 0
    for k in range(loops):
        total += k * k
    return total
"""

_PACER = (
    _WORK
    + """
import os, sys, time
parent = os.getppid()
while os.getppid() == parent:
    begin = time.perf_counter()
    work(int(sys.argv[1]))
    print(begin, time.perf_counter() - begin, flush=True)
    time.sleep(0.02)
"""
)

exec(_WORK)


class Heart:
    """Beats in the window's event loop, and notes its pauses: begin, the wall's time, and what this process used."""

    def __init__(self):
        self.paces = open(path("paces"), "w+", encoding="utf-8")
        subprocess.Popen(["python3", "-c", _PACER, str(LOOPS)], stdout=self.paces)
        self.timer = QtCore.QTimer()
        self.timer.setInterval(5)
        self.timer.timeout.connect(self.beat)
        self.timer.start()
        self.begin()

    def begin(self):
        self.pauses = []
        self.last = time.perf_counter(), time.process_time()

    def beat(self):
        now = time.perf_counter(), time.process_time()
        wall, used = now[0] - self.last[0], now[1] - self.last[1]
        self.pauses.append((self.last[0], wall, min(wall, used)))
        self.last = now

    def paced(self):
        """Begin and duration of every piece of the other process's work, and the duration of a fast one."""
        with open(path("paces"), encoding="utf-8") as stream:
            rows = [tuple(map(float, line.split())) for line in stream if line.endswith("\n")]
        lasted = sorted(duration for _, duration in rows)
        return rows, lasted[len(lasted) // 20]

    def ours(self, pause, rows, fast):
        """What of a pause is left on a machine of our own, s."""
        begin, wall, used = pause
        there = [duration for at, duration in rows if at <= begin + wall and at + duration >= begin]
        return used / max(1.0, sum(there) / len(there) / fast) if there else used

    def longest(self):
        """The longest pause since the beginning on a machine of our own, and the longest that was seen, s."""
        self.beat()
        rows, fast = self.paced()
        return max(self.ours(pause, rows, fast) for pause in self.pauses), max(wall for _, wall, _ in self.pauses)

    def end(self, name):
        """The window has lived all the time."""
        ours, wall = self.longest()
        found["figures"][name] = [round(wall, 3), round(ours, 3)]
        check(ours <= FREEZE, f"{name}: no life for {ours:.3f} s ({wall:.3f} s with others)")

    def prove(self):
        """A window that does stand still is noticed: four times as long as it may."""
        end = time.monotonic() + 1.0
        while time.monotonic() < end:
            time.sleep(0.05)
        _, fast = self.paced()
        self.begin()
        work(round(LOOPS * 4 * FREEZE / fast))  # noqa: F821
        ours, _ = self.longest()
        found["figures"]["standing still"] = round(ours, 3)
        check(ours > FREEZE, f"a window that stands still for {4 * FREEZE} s is taken to stand still for {ours:.3f} s")
