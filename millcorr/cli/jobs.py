# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many commands from one file, in parallel: `millcorr batch`, and the same from a script.

A job is a verb of the command line with its options. Each runs in a process of its own, so that none can harm
another; who waits for them is an executor with the interface of `concurrent.futures`, on this machine or, with
dask.distributed, on a shop's machines.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import io
import json
import os
import shutil
import subprocess
import sys
import time
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor, Future, ThreadPoolExecutor, as_completed
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, TextIO

from millcorr import freecad_process
from millcorr.errors import FormatError, UsageError
from millcorr.messages import AS_DATA, Message, as_data, of_data, phrase

from . import arguments

STATE_SUFFIX = ".state"
"""What is done is recorded beside the batch file, under its name with this at the end."""

LOST = 1
"""Exit status of a job whose process was killed or whose worker was lost."""

ANSWER_TIME = 10.0
"""A scheduler that has not answered after so many seconds is not there."""

BAR = 30
"""Characters of the bar over all jobs."""

_NOT_IN_A_BATCH = ("batch", "history")


@dataclass(frozen=True, slots=True)
class Job:
    """One command of a batch.

    Parameters
    ----------
    name : str
        Unique in its batch.
    argv : tuple of str
        The verb and its options, as on the command line.
    directory : str
        Where it runs: paths in `argv` are relative to it.
    inputs, outputs : tuple of str
        Files that it reads and places that it writes, absolute.
    """

    name: str
    argv: tuple[str, ...]
    directory: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]

    @property
    def digest(self) -> str:
        """SHA-256 of the command and of the content of what it reads."""
        out = hashlib.sha256(json.dumps([self.argv, self.directory]).encode())
        for path in self.inputs:
            file = Path(path)
            out.update(hashlib.sha256(file.read_bytes() if file.is_file() else b"").digest())
        return out.hexdigest()


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a job ended.

    Parameters
    ----------
    name : str
    status : int
        Exit status of its command; 0 done.
    text : str
        What it printed; its one line of error where the status is not 0, as a message where it is one.
    seconds : float
    before : bool
        True where an earlier run of the batch had done it already.
    """

    name: str
    status: int
    text: str
    seconds: float
    before: bool = False


def load(path: str | Path) -> tuple[Job, ...]:
    """The jobs of a batch file.

    Parameters
    ----------
    path : str or Path
        TOML: tables ``[[job]]`` with ``verb`` (default ``correct``), ``name`` and options by their names on the
        command line without the dashes; ``[defaults]`` holds options of every job that knows them.

    Returns
    -------
    tuple of Job

    Raises
    ------
    FormatError
        If the file cannot be read, or a job is not a possible command; names the job and the option.
    UsageError
        If two jobs write the same place, or one reads what another writes.
    """
    path = Path(path)
    try:
        table = tomllib.loads(path.read_bytes().decode("utf-8-sig"))
    except OSError as error:
        raise FormatError(phrase("cannot be read: {}", error.strerror or error), path) from error
    except ValueError as error:
        raise FormatError(phrase("no TOML in UTF-8: {}", error), path) from error
    unknown = sorted(set(table) - {"defaults", "job"})
    if unknown:
        raise FormatError(phrase("{} is not known here: a batch has [defaults] and [[job]]", unknown[0]), path)
    rows, defaults = table.get("job", []), table.get("defaults", {})
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows) or not rows:
        raise FormatError(phrase("a batch needs at least one table [[job]]"), path)
    if not isinstance(defaults, dict):
        raise FormatError(phrase("defaults must be a table"), path)
    verbs = arguments.verbs()
    jobs = tuple(_job(number, row, defaults, verbs, path) for number, row in enumerate(rows, 1))
    _refuse_conflicts(jobs, path)
    return jobs


def _job(
    number: int,
    row: Mapping[str, Any],
    defaults: Mapping[str, Any],
    verbs: Mapping[str, argparse.ArgumentParser],
    path: Path,
) -> Job:
    name, verb = row.get("name", f"job {number}"), row.get("verb", "correct")
    if not isinstance(name, str) or not name.strip() or "\n" in name:
        raise FormatError(phrase("job {}: its name must be one line of text", number), path)
    if verb not in verbs or verb in _NOT_IN_A_BATCH:
        known = ", ".join(v for v in verbs if v not in _NOT_IN_A_BATCH)
        raise FormatError(phrase("{}: verb is one of {}, not {!r}", name, known, verb), path)
    options = {key.replace("_", "-"): value for key, value in row.items() if key not in ("name", "verb")}
    known_actions = _actions(verbs[verb])
    for key, value in defaults.items():
        key = key.replace("_", "-")
        if not any(key in _actions(other) for other in verbs.values()):
            raise FormatError(phrase("defaults: {} is no option", key), path)
        if key in known_actions:
            options.setdefault(key, value)
    argv, given = [verb], []
    for key, value in options.items():
        action = known_actions.get(key)
        if action is None or key in ("help", "debug"):
            raise FormatError(phrase("{}: {} is no option of {}", name, key, verb), path)
        words = _words(action, value)
        if words is None:
            raise FormatError(phrase("{}: {} = {} is not possible", name, key, json.dumps(value, default=str)), path)
        # What is no option stands at the end.
        if action.option_strings:
            argv += words
        else:
            given += words
    # A file name may begin with a dash.
    argv += ["--", *given] if given else []
    parsed = _parsed(argv, name, path)
    directory = path.absolute().parent
    inputs, outputs = [], []
    for action in known_actions.values():
        value = getattr(parsed, action.dest, None)
        places = [] if value is None else value if isinstance(value, list) else [value]
        for place in places:
            if action.dest in arguments.OUTPUTS:
                outputs.append(str((directory / place).resolve()))
            elif isinstance(place, Path) or action.dest == "nominal":
                inputs.append(str((directory / str(place).partition("#")[0]).resolve()))
    return Job(name, tuple(argv), str(directory), tuple(inputs), tuple(outputs))


def _actions(verb: argparse.ArgumentParser) -> dict[str, argparse.Action]:
    """Options and arguments of a verb by the name that a batch file uses."""
    return {
        (action.option_strings[0].lstrip("-") if action.option_strings else action.dest): action
        for action in verb._actions
    }


def _words(action: argparse.Action, value: Any) -> list[str] | None:
    """Words of the command line for an option's value in TOML; None if it has no such value."""
    if value is True and action.nargs in (0, "?"):
        return [action.option_strings[0]]
    values = value if isinstance(value, list) else [value]
    if not all(isinstance(v, str | int | float) and not isinstance(v, bool) for v in values) or not values:
        return None
    texts = [v if isinstance(v, str) else repr(v) for v in values]
    if not action.option_strings:
        return texts
    flag = action.option_strings[0]
    if isinstance(action.nargs, int):
        return [flag, *texts] if len(texts) == action.nargs else None
    if len(texts) > 1 and not isinstance(action, argparse._AppendAction):
        return None
    # Joined, so that a value may begin with a minus sign.
    return [f"{flag}={text}" for text in texts]


def _parsed(argv: Sequence[str], name: str, path: Path) -> argparse.Namespace:
    said = io.StringIO()
    try:
        with contextlib.redirect_stderr(said):
            return arguments.parser().parse_args(argv)
    except SystemExit as error:
        last = (said.getvalue().strip().splitlines() or ["not a possible command"])[-1]
        raise FormatError(f"{name}: {last.removeprefix('millcorr: ').partition('; --help')[0]}", path) from error


def _refuse_conflicts(jobs: Sequence[Job], path: Path) -> None:
    names: dict[str, int] = {}
    written: dict[str, str] = {}
    for number, job in enumerate(jobs, 1):
        if job.name in names:
            raise FormatError(phrase("{}: two jobs have this name", job.name), path)
        names[job.name] = number
        for place in job.outputs:
            if place in written:
                raise UsageError(phrase("{}: {} and {} both write {}", path, written[place], job.name, place))
            written[place] = job.name
    for job in jobs:
        for place in job.inputs:
            if written.get(place, job.name) != job.name:
                raise UsageError(
                    phrase(
                        "{}: {} reads {}, which {} writes: jobs run at the same time; make two batches of them",
                        path,
                        job.name,
                        place,
                        written[place],
                    )
                )


def run_job(job: Job) -> Outcome:
    """Run one job in a process of its own and wait for it. Can be sent to another machine that has millcorr."""
    begun = time.monotonic()
    environment = dict(os.environ)
    package = str(Path(__file__).resolve().parents[2])
    environment["PYTHONPATH"] = os.pathsep.join([package, *freecad_process.packages()])
    # Where FreeCAD brings its own library, a plain Python must not look there.
    environment.pop("PYTHONHOME", None)
    environment[AS_DATA] = "1"
    # What a batch that was killed has left running may be in the journal before the batch could record it.
    once = ["--once"] if any(word.partition("=")[0] == "--journal" for word in job.argv) else []
    try:
        done = subprocess.run(
            [plain_python(), "-m", "millcorr", *job.argv, *once],
            cwd=job.directory,
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            encoding="utf-8",
            errors="replace",
            check=False,
        )
    except OSError as error:
        return Outcome(job.name, LOST, f"cannot be started: {error.strerror or error}", time.monotonic() - begun)
    seconds = time.monotonic() - begun
    if done.returncode < 0:
        return Outcome(job.name, LOST, f"its process was killed by signal {-done.returncode}", seconds)
    text = done.stdout.strip() if done.returncode == 0 else error_of(done.stderr.strip() or done.stdout.strip())
    return Outcome(job.name, done.returncode, text, seconds)


def error_of(told: str) -> Message:
    """What a command that failed says, as data on its last line, or else as it stands."""
    with contextlib.suppress(ValueError, IndexError):
        return of_data(json.loads(told.splitlines()[-1]))
    return Message(told)


def plain_python() -> str:
    """A plain Python with the version of this one; inside FreeCAD the running program is none."""
    if Path(sys.executable or "").name.lower().startswith("python"):
        return sys.executable
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    for name in (f"python{version}", "python3", "python"):
        for place in (Path(sys.prefix) / "bin" / name, Path(sys.prefix) / f"{name}.exe"):
            if place.is_file():
                return str(place)
        found = shutil.which(name)
        if found:
            return found
    raise UsageError(phrase("a batch needs a plain Python beside FreeCAD's: none was found on the PATH"))


class _State:
    """What earlier runs have done: one line a job in a file beside the batch, written when the job is done."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.done: dict[str, Outcome] = {}
        if not path.exists():
            return
        for line in path.read_text(encoding="utf-8").splitlines():
            # The last line may be torn where the machine went down.
            with contextlib.suppress(ValueError, KeyError, TypeError):
                row = json.loads(line)
                self.done[row["digest"]] = Outcome(row["name"], row["status"], row["text"], row["seconds"], True)

    def finished(self, job: Job, digest: str) -> Outcome | None:
        """Outcome of a job that succeeded before with the same command and inputs, if what it wrote is there."""
        outcome = self.done.get(digest)
        if outcome is None or outcome.status or not all(Path(place).exists() for place in job.outputs):
            return None
        return outcome

    def record(self, digest: str, outcome: Outcome) -> None:
        row = asdict(outcome) | {"digest": digest}
        with open(self.path, "a", encoding="utf-8") as file:
            file.write(("" if self._ends_whole() else "\n") + json.dumps(row) + "\n")
            file.flush()
            os.fsync(file.fileno())

    def _ends_whole(self) -> bool:
        with contextlib.suppress(OSError), open(self.path, "rb") as file:
            file.seek(-1, os.SEEK_END)
            return file.read(1) == b"\n"
        return True


def run(
    path: str | Path,
    *,
    workers: int | None = None,
    dask: str | None = None,
    again: bool = False,
    out: TextIO | None = None,
) -> tuple[Outcome, ...]:
    """Run the jobs of a batch file; one that fails does not stop the others.

    Parameters
    ----------
    path : str or Path
        See `load`.
    workers : int, optional
        So many jobs at a time; by default as many as there are processors.
    dask : str, optional
        Address of a scheduler of dask.distributed, such as ``tcp://host:8786``, whose workers run the jobs.
    again : bool
        Also run what an earlier run has done with the same inputs.
    out : text file, optional
        Where a line for every job and the bar go; by default standard output.

    Returns
    -------
    tuple of Outcome
        In the order of the file.

    Raises
    ------
    MillcorrError
        If the batch file cannot be used; no job was started then.
    KeyboardInterrupt
        If it was interrupted, after the jobs that were running; the second time at once.
    """
    path = Path(path)
    jobs = load(path)
    if workers is not None and workers < 1:
        raise UsageError(f"--jobs {workers}: at least one job must run at a time")
    state = _State(path.with_name(path.name + STATE_SUFFIX))
    show = _Progress(len(jobs), out or sys.stdout)
    digests = {job.name: job.digest for job in jobs}
    outcomes: dict[str, Outcome] = {}
    for job in jobs:
        before = None if again else state.finished(job, digests[job.name])
        if before is not None:
            outcomes[job.name] = before
            show.line(before)
    with _executor(workers, dask) as executor:
        waiting: dict[Future[Outcome], Job] = {
            executor.submit(run_job, job): job for job in jobs if job.name not in outcomes
        }
        interrupted = False
        while waiting:
            try:
                for future in as_completed(waiting):
                    job = waiting.pop(future)
                    outcome = _outcome(future, job)
                    state.record(digests[job.name], outcome)
                    outcomes[job.name] = outcome
                    show.line(outcome)
            except KeyboardInterrupt:
                if interrupted:
                    raise
                interrupted = True
                # What runs comes to its end, and is recorded; what only waits is not begun.
                waiting = {future: job for future, job in waiting.items() if not future.cancel()}
    show.close()
    if interrupted:
        done = sum(outcome.status == 0 for outcome in outcomes.values())
        raise KeyboardInterrupt(f"interrupted: {done} of {len(jobs)} jobs are done; run it again for the others")
    return tuple(outcomes[job.name] for job in jobs)


def _outcome(future: Future[Outcome], job: Job) -> Outcome:
    try:
        return future.result()
    # A worker's end reaches us as one of many classes; the other jobs go on.
    except Exception as error:  # noqa: BLE001
        return Outcome(job.name, LOST, f"its worker was lost: {error!r}", 0.0)


@contextlib.contextmanager
def _executor(workers: int | None, dask: str | None) -> Iterator[Executor]:
    if dask is None:
        with ThreadPoolExecutor(workers or os.cpu_count() or 1) as pool:
            yield pool
        return
    try:
        from distributed import Client
    except ModuleNotFoundError as error:
        raise UsageError("--dask needs the package distributed: pip install distributed") from error
    try:
        client = Client(dask, timeout=ANSWER_TIME)
    except (OSError, ValueError, TimeoutError) as error:
        raise UsageError(f"--dask {dask}: no scheduler answers there: {error}") from error
    with client:
        # A job has no side effect before its end, so it may be run anew where its worker is lost.
        yield client.get_executor(pure=False, retries=2)


class _Progress:
    """One line for every job that ended, and on a terminal a bar over all below them."""

    def __init__(self, count: int, out: TextIO) -> None:
        self.count, self.out, self.ended = count, out, 0
        self.bar = out.isatty()
        self._draw()

    def line(self, outcome: Outcome) -> None:
        self.ended += 1
        if AS_DATA in os.environ:
            # Another program reads it, and words it.
            print(json.dumps(asdict(outcome) | {"text": as_data(outcome.text)}), file=self.out, flush=True)
            return
        width = len(str(self.count))
        how = "before" if outcome.before else "ok" if outcome.status == 0 else f"exit {outcome.status}"
        self._clear()
        text = "" if outcome.status == 0 else "  " + " ".join(outcome.text.split())
        print(
            f"[{self.ended:{width}}/{self.count}] {how:<7} {outcome.seconds:7.1f} s  {outcome.name}{text}",
            file=self.out,
            flush=True,
        )
        self._draw()

    def close(self) -> None:
        self._clear()

    def _draw(self) -> None:
        if self.bar and self.ended < self.count:
            full = BAR * self.ended // self.count
            print(f"[{'#' * full}{'.' * (BAR - full)}] {self.ended}/{self.count}", end="", file=self.out, flush=True)

    def _clear(self) -> None:
        if self.bar:
            print("\r" + " " * (BAR + 20) + "\r", end="", file=self.out)


def in_words(outcomes: Sequence[Outcome]) -> str:
    """Summary of a batch in one line, and one more for each job that failed."""
    failed = [o for o in outcomes if o.status]
    before = sum(o.before for o in outcomes)
    done = len(outcomes) - len(failed)
    lines = [f"{done} of {len(outcomes)} jobs done" + (f", {before} of them in an earlier run" if before else "")]
    lines += [f"failed      {o.name}: {' '.join(o.text.split())}" for o in failed]
    return "\n".join(lines)


def exit_status(outcomes: Sequence[Outcome]) -> int:
    """The highest exit status of the jobs; 0 where all are done."""
    return max((o.status for o in outcomes), default=0)
