# SPDX-License-Identifier: LGPL-2.1-or-later
"""The errors a user can meet, split by what the user must do about them.

Each carries what it says as data: a message whose pieces name options and ways out, the place and the figure it is
about where there is one. Fronts word it; nothing reads its text.
"""

from __future__ import annotations

from pathlib import Path

from .messages import Accept, Message, Piece, Place, joined, phrase


class MillcorrError(Exception):
    """Root of every error that millcorr raises on purpose; its text is one line.

    Parameters
    ----------
    *pieces : str or Option
        What it says, see `messages.Message`.
    about : str, optional
        Key of the option whose value is wrong in itself; by default the one that the message begins with.
    place : (float, float), optional
        Where in XY, mm.
    figure : float, optional
        How much, in the unit that the text says.
    """

    def __init__(
        self,
        *pieces: Piece,
        about: str = "",
        place: tuple[float, float] | None = None,
        figure: float | None = None,
    ) -> None:
        self.message = Message(*pieces)
        self.about = about or self.message.subject
        self.place, self.figure = place, figure
        super().__init__(self.message)


class UsageError(MillcorrError, ValueError):
    """The request contradicts itself or lacks something: change the command or the call."""


class UnsaidError(UsageError):
    """A measured file leaves open what only the user knows; see `unsaid`.

    Parameters
    ----------
    *pieces : str or Option
        What to say.
    reason : str
        Why; alone it is what a front shows beside the field.
    """

    def __init__(self, *pieces: Piece, reason: str = "") -> None:
        self.reason = reason
        super().__init__(*pieces, reason)


def unsaid(reason: str, *ways: Piece) -> UnsaidError:
    """The error that a file leaves something open, which one of some options says."""
    return UnsaidError(phrase("say {}: ", joined(ways, phrase(" or "))), reason=reason)


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
        self.said = Message(message)
        where = Place(self.file or "", line)
        super().__init__(*((where, ": ", message) if str(where) else (message,)))


class DistrustError(InputError):
    """The measurement does not look like what it is said to be; an option resolves it, or accepting the finding.

    Parameters
    ----------
    *pieces : str or Option
    finding : str, optional
        Name of the finding, by which it is accepted.
    place, figure
        As of the finding.
    """

    def __init__(
        self,
        *pieces: Piece,
        finding: str = "",
        place: tuple[float, float] | None = None,
        figure: float | None = None,
    ) -> None:
        self.finding = finding
        super().__init__(*pieces, *((Accept(finding),) if finding else ()), place=place, figure=figure)


class RefusedError(MillcorrError):
    """The correction would be wrong or unsafe and is refused; nothing is written."""


class FitError(RefusedError):
    """A curve or a filter could not be fitted to the data within its tolerance."""


class LimitError(RefusedError):
    """A correction is larger than the limit, gouges, or leaves the profile."""
