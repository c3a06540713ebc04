# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proof of a corrected program in HEIDENHAIN's ISO code: as of plain language, with codes that hold on.

Motion codes, G90, G91 and the pole may come and go where places change: what they make of the moves is compared.
"""

from __future__ import annotations

import re

import numpy as np

from millcorr.arrays import Bools

from .din_reading import bare, read
from .klartext_proof import Script, feed_of
from .reading import line_starts
from .text_proof import Content, Language, Text

_PLACE_CODES = (0, 1, 2, 3, 5, 6, 10, 11, 12, 13, 15, 16, 24, 25, 29, 90, 91)
_OWN_WORDS = re.compile(
    r"%|D *\d|Q|L|[^;]*(?<![A-Z])G *(?:[2-9]\d\d|1\d\d|98|99|5[1-9]|3\d|4(?!\d)|28|72|73|7[4-9]|8\d)"
)
"""Blocks of programs, parameters, labels, blanks, datums and cycles: their words stay as they are."""
_PIECE = re.compile(r"(?P<letter>[A-Z])[ \t]*(?P<number>[-+]?[ \t]*(?:Q[LR]?\d+|\d+[.,]?\d*|[.,]\d+)|MAX|AUTO)?|[^ \t]")
_NUMBERED = re.compile(rb"(?mi)^((?:\xef\xbb\xbf)?[ \t]*/?[ \t]*)N[ \t]*(\d+)[ \t]*")
_STATES_ONLY = re.compile(rb"G(?:0?[01235]|0?6|1[012356]|9[01])(?!\d)|F[\d.,]+")
_OPENING = re.compile(rb"[ \t]*(?:%[^\r\n]*)?[ \t]*")
_COMMENT = re.compile(rb"[ \t]*;[^\r\n]*")


def _without_numbers(data: bytes) -> tuple[bytes, list[int]]:
    found = [int(m[2]) for m in _NUMBERED.finditer(data)]
    return _NUMBERED.sub(rb"\1", data), found


def _numbers_fit(was: list[int], now: list[int]) -> bool:
    """Whether blocks that count on by one step do so still, the last one apart, and others have what they had."""
    steps = {b - a for a, b in zip(was[:-2], was[1:-1], strict=True)}
    if len(steps) == 1 and (step := steps.pop()) > 0:
        counted = list(range(now[0], now[0] + step * len(now), step))
        on_with = counted[-1] if was[-1] == was[-2] + step else was[-1]
        return now[0] == was[0] and now == [*counted[:-1], on_with]
    rest = iter(was)
    return all(number in rest for number in now)


def _led_lines(data: bytes) -> Bools:
    """Lines of G26 and G27 and of the places that they lead to and from."""
    starts = line_starts(data)
    out = np.zeros(len(starts) - 1, np.bool_)
    for i in range(len(out)):
        found = re.search(r"(?<![A-Z])G *2([67])(?!\d)", bare(data[starts[i] : starts[i + 1]].decode("latin-1")))
        if found is not None:
            out[[i, max(i - 1, 0) if found[1] == "6" else min(i + 1, len(out) - 1)]] = True
    return out


def _content(text: Text, i: int) -> Content:
    line = text.line(i).decode("latin-1").rstrip("\r\n\x1a")
    skip = "/" if re.match(r"[ \t]*/", line) else ""
    content, mark, comment = line.partition(";")
    words = bare(content)
    rest = [mark + comment.strip(" \t*")] if mark else []
    if not words:
        return Content(tuple(rest), None, None, None, skip, False)
    if _OWN_WORDS.match(words):
        return Content((words, *rest), None, None, None, skip, False)
    lead = re.search(r"G *2[67](?!\d)", words) is not None
    kept: list[str] = []
    height = None
    for piece in _PIECE.finditer(words):
        letter, number = piece["letter"], re.sub(r"[ \t]", "", piece["number"] or "")
        if letter == "Z":
            height = letter + number
        elif letter == "G" and number.isdigit() and int(number) in _PLACE_CODES:
            continue
        elif letter is not None and (letter in "XYIJKH" or (letter == "R" and not lead)):
            continue
        elif letter == "F" and number[:1] in "0123456789.,Q" and number:
            continue
        else:
            kept.append((letter or piece.group()) + number)
    return Content((*kept, *rest), feed_of(text, i), height, None, skip, False)


def _restated(old: bytes, new: bytes) -> bool:
    """Whether a line says what another does and states besides what was in force."""
    plain = re.split(rb"[;\"]", new)[0]
    return any(
        (shorter := new[: m.start()] + new[m.end() :]) == old or (len(shorter) > len(old) and _restated(old, shorter))
        for m in _STATES_ONLY.finditer(plain)
    )


SCRIPT = Script(
    Language(read=read, content=_content, restated=_restated, opening=_OPENING, comment=_COMMENT),
    _without_numbers,
    _led_lines,
    re.compile(rb"[^;%]*(?:[IJK][ \t]*[-+\dQ]|G[ \t]*29)", re.IGNORECASE),
    _numbers_fit,
)
