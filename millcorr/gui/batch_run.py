# SPDX-License-Identifier: LGPL-2.1-or-later
"""A batch in a process of its own: what its jobs do, one by one, and how to stop it. Knows no window."""

from __future__ import annotations

import json
import os
import queue
import signal
import subprocess
import sys
import threading
from pathlib import Path

from millcorr import freecad_process
from millcorr.cli import jobs
from millcorr.messages import AS_DATA, Message, of_data


def ended(line: str) -> jobs.Outcome | None:
    """The job that a line of `millcorr batch` tells of, its error as a message; None where it tells of none."""
    try:
        row = json.loads(line)
        return jobs.Outcome(**row | {"text": of_data(row["text"])})
    except (ValueError, TypeError, KeyError):
        return None


class BatchRun:
    """A batch file that is being run.

    Parameters
    ----------
    path : str or Path
    again : bool
        Also what an earlier run has done.

    Raises
    ------
    MillcorrError
        If the file cannot be used; nothing is started then.
    """

    def __init__(self, path: str | Path, again: bool = False) -> None:
        self.names = tuple(job.name for job in jobs.load(path))
        package = str(Path(__file__).resolve().parents[2])
        environment = dict(os.environ)
        environment["PYTHONPATH"] = os.pathsep.join([package, *freecad_process.packages()])
        environment.pop("PYTHONHOME", None)
        environment[AS_DATA] = "1"
        command = [jobs.plain_python(), "-m", "millcorr", "batch", str(path), *(["--again"] if again else [])]
        # A group of its own: stopping it stops the jobs, which are processes of their own, too.
        self._process = subprocess.Popen(
            command,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            encoding="utf-8",
            errors="replace",
            start_new_session=sys.platform != "win32",
        )
        self._lines: queue.Queue[str | None] = queue.Queue()
        self._reader = threading.Thread(target=self._read, name="millcorr batch", daemon=True)
        self._reader.start()
        self._rest: list[str] = []
        self.running = True
        self.cancelled = False

    def _read(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            self._lines.put(line.rstrip("\n"))
        self._process.wait()
        self._lines.put(None)

    def news(self) -> list[jobs.Outcome]:
        """Jobs that ended since the last call; afterwards `running` says whether more will."""
        out = []
        while True:
            try:
                line = self._lines.get_nowait()
            except queue.Empty:
                return out
            if line is None:
                self.running = False
                return out
            event = ended(line)
            if event is None:
                self._rest.append(line)
            else:
                out.append(event)

    @property
    def said(self) -> Message:
        """What it said beside its jobs: why it could not run, where it could not."""
        return jobs.error_of("\n".join(self._rest))

    @property
    def status(self) -> int | None:
        """Exit status; None while it runs."""
        return self._process.poll()

    def cancel(self) -> None:
        """Stop it and all its jobs; what is done stays done, and the next run goes on from there."""
        if self._process.poll() is not None:
            return
        self.cancelled = True
        if sys.platform == "win32":
            subprocess.run(["taskkill", "/T", "/F", "/PID", str(self._process.pid)], check=False, capture_output=True)
        else:
            os.killpg(self._process.pid, signal.SIGTERM)
