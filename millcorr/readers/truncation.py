# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a file ends in the middle of its last number."""

from __future__ import annotations

import re

from millcorr.errors import FormatError
from millcorr.messages import phrase

_TAIL = 20_000
_ROWS = 20
"""So many rows must agree before the last one is judged by them."""
_DIGITS = re.compile(r"[0-9]+")
_IGNORED = str.maketrans("", "", " \t+-")
_GOES_ON = (".", "E", "D")
"""What stands between the digits of one number; a comma only where no point is the decimal mark."""


def check_last_number(data: bytes, name: str) -> None:
    """FormatError where a text without a line end at its end has a last number that is shorter than those above it.

    Parameters
    ----------
    data : bytes
        Content of the file, in any encoding that has ASCII's digits.
    name : str
        File name for the message.

    Raises
    ------
    FormatError
        If more than 20 rows above have as many decimals (or digits of an exponent) as each other where the last
        number of the file stands, and that one has fewer: it was cut off.

    Notes
    -----
    Rows count that are the same as the last line but for their digits, signs and blanks, up to that number. Numbers
    without trailing zeros differ in their decimals and prove nothing.
    """
    tail = data[-_TAIL:].replace(b"\x00", b"").rstrip(b"\x11\x12\x13\x14\x1a").decode("latin-1")
    if tail.endswith(("\n", "\r")):
        return
    lines = [line for line in re.split(r"\r\n|\r|\n", tail) if line.strip()]
    if len(lines) <= _ROWS:
        return
    gaps, runs = _taken_apart(lines[-1])
    # Words and marks behind the last digits show that the number is whole, but for its own decimal mark.
    marks = _GOES_ON if "." in lines[-1] else (*_GOES_ON, ",")
    if not runs or gaps[-1] not in ("", *marks):
        return
    count = len(runs)
    above = [_taken_apart(line) for line in lines[:-1]]
    alike = [(g, r) for g, r in above if len(r) >= count and g[:count] == gaps[:count]]
    if len(alike) <= _ROWS:
        return
    # What follows in the rows above: the mark, and how many digits.
    following = {(g[count], len(r[count])) if len(r) > count else ("", 0) for g, r in alike}
    mark = next(iter(following))[0]
    goes_on = len(following) == 1 and (mark in _GOES_ON or (mark == "," and len(alike[0][1]) == count + 1))
    digits = {len(r[count - 1]) for _, r in alike}
    shorter = gaps[count - 1] in marks and len(digits) == 1 and len(runs[-1]) < min(digits)
    if goes_on or shorter:
        line = len(re.findall(rb"\r\n|\r|\n", data.replace(b"\x00", b"").rstrip(b"\x11\x12\x13\x14\x1a"))) + 1
        raise FormatError(
            phrase(
                "the file ends within a number: it was cut off, or a spreadsheet dropped the last zeros; "
                "export it again, or end the last line"
            ),
            name,
            line,
        )


def _taken_apart(line: str) -> tuple[list[str], list[str]]:
    """What stands before, between and behind the runs of digits, without signs and blanks; and these runs."""
    return [gap.translate(_IGNORED).upper() for gap in _DIGITS.split(line)], _DIGITS.findall(line)
