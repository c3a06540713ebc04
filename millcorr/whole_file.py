# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are never there in part, and the places that may be written to."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from millcorr.messages import phrase

from . import progress
from .errors import UsageError
from .messages import Message, message, option


def refuse_places(
    outputs: Mapping[str, Path | None],
    inputs: Mapping[str, Path | None],
    report: Path | None = None,
    files: Collection[str] = (),
) -> None:
    """Refuse outputs that would take the place of an input, of a directory or of another output.

    Parameters
    ----------
    outputs : mapping of str to Path
        Files to write, by the key of the option that names them, or a message about it; None where it was not given.
    inputs : mapping of str to Path
        Files to read, by what they are.
    report : Path, optional
        Directory of the report; it need not exist.
    files : collection of str
        Names of the files that the report consists of.

    Raises
    ------
    UsageError
        Also where an output would lie in a directory that does not exist; a report makes its own.
    """
    taken = {place.resolve(): what for what, place in inputs.items() if place is not None}
    for name, place in outputs.items():
        if place is None:
            continue
        said = message(name, f" {place}") if isinstance(name, Message) else option(name, place)
        what = taken.get(place.resolve())
        if what is not None:
            raise UsageError(phrase("{} is the {} itself; the original must stay untouched", said, what))
        if place.is_dir():
            raise UsageError(phrase("{} is a directory; name the file to write", said))
        if not place.absolute().parent.is_dir():
            raise UsageError(phrase("{}: there is no directory {}: make it first", said, place.parent))
        taken[place.resolve()] = message("file of ", name if isinstance(name, Message) else option(name))
    if report is None:
        return
    if report.resolve() in taken or (report.exists() and not report.is_dir()):
        raise UsageError(phrase("{} is a file; name a directory", option("report", report)))
    for place, what in taken.items():
        if place.parent == report.resolve() and place.name in files:
            raise UsageError(
                phrase(
                    "{} would replace the {}, {}: name another directory", option("report", report), what, place.name
                )
            )


def write_whole(path: Path, text: str) -> Path:
    """Write a text file in UTF-8, or replace the old one, as a whole; errors as `replaced_whole`."""
    with replaced_whole(path, text.encode("utf-8")):
        pass
    return path


@contextmanager
def replaced_whole(path: Path | None, data: bytes) -> Iterator[None]:
    """Have a file appear, or replace the old one, when it is complete and all that is done meanwhile succeeded.

    Parameters
    ----------
    path : Path or None
        A link stays a link: the file it names is replaced. None writes nothing.
    data : bytes

    Raises
    ------
    UsageError
        If there is no such directory, or nothing may be written to it.
    OSError
        If the disk is full or fails.
    """
    if path is None:
        yield
        return
    path = path.resolve()
    if not path.parent.is_dir():
        raise UsageError(phrase("{}: there is no directory {}: make it first", path, path.parent))
    try:
        handle, temporary = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
    except OSError as error:
        raise UsageError(phrase("{}: cannot be written: {}", path, error.strerror)) from error
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, path.stat().st_mode & 0o777 if path.exists() else 0o666 & ~_umask())
        yield
        progress.settle()
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def write_together(directory: Path, files: Mapping[str, Iterable[str] | Iterable[bytes]]) -> list[Path]:
    """Write text files in UTF-8 that appear in a directory when all of them are complete; others there stay.

    Parameters
    ----------
    directory : Path
        Made where it does not exist.
    files : mapping of str to iterable of str or bytes
        Pieces of the text of each file, by its name; lines end as in the text, whatever the system.

    Returns
    -------
    list of Path

    Raises
    ------
    UsageError
        If `directory` is a file.
    OSError
        If it cannot be written to.
    """
    if directory.exists() and not directory.is_dir():
        raise UsageError(phrase("{}: the report needs a directory, this is a file", directory))
    new = not directory.exists()
    home = directory.parent if new else directory
    home.mkdir(parents=True, exist_ok=True)
    stage = Path(tempfile.mkdtemp(prefix=".millcorr-report-", dir=home))
    try:
        for name, text in files.items():
            progress.step()
            with open(stage / name, "wb") as file:
                file.writelines(piece.encode() if isinstance(piece, str) else piece for piece in text)
        progress.settle()
        if new:
            # mkdtemp makes a private directory; this one is as readable as any other.
            stage.chmod(0o777 & ~_umask())
            stage.rename(directory)
        else:
            for name in files:
                os.replace(stage / name, directory / name)
    finally:
        shutil.rmtree(stage, ignore_errors=True)
    return [directory / name for name in files]


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
