# SPDX-License-Identifier: LGPL-2.1-or-later
"""The errors a user can meet, split by what the user must do about them."""

from __future__ import annotations

from pathlib import Path


class MillcorrError(Exception):
    """Root of every error that millcorr raises on purpose; its text is one line."""


class UsageError(MillcorrError, ValueError):
    """The request contradicts itself or lacks something: change the command or the call."""


class InputError(MillcorrError, ValueError):
    """The input is readable but cannot be trusted or used as it is."""


class FormatError(InputError):
    """A file cannot be read: names the file, the line where known, and the remedy.

    Parameters
    ----------
    message : str
        What is wrong and what to do about it.
    file : str or Path, optional
        The file.
    line : int, optional
        Line number in the file, counted from 1.
    """

    def __init__(self, message: str, file: str | Path | None = None, line: int | None = None) -> None:
        self.file = None if file is None else str(file)
        self.line = line
        where = self.file or ""
        if line is not None:
            where = f"{where}:{line}" if where else f"line {line}"
        super().__init__(f"{where}: {message}" if where else message)


class DistrustError(InputError):
    """The measurement does not look like what it is said to be; an option or --accept resolves it.

    Parameters
    ----------
    message : str
    finding : str, optional
        Name of the finding, as `--accept` takes it.
    """

    def __init__(self, message: str, finding: str = "") -> None:
        self.finding = finding
        super().__init__(message)


class RefusedError(MillcorrError):
    """The correction would be wrong or unsafe and is refused; nothing is written."""


class FitError(RefusedError):
    """A curve or a filter could not be fitted to the data within its tolerance."""


class LimitError(RefusedError):
    """A correction is larger than the limit, gouges, or leaves the profile."""
