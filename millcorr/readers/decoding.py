# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the bytes of a measurement file to its text and its lines, or a refusal that says what the file is instead."""

from __future__ import annotations

import codecs
import re
from collections.abc import Iterator

import numpy as np

from millcorr.errors import FormatError
from millcorr.messages import phrase

_NOT_TEXT = (
    (b"%PDF", phrase("a PDF document"), phrase("export the points as CSV")),
    (b"PK\x03\x04", phrase("a ZIP container (a workbook, a FreeCAD document?)"), phrase("save the points as CSV")),
    (b"\xd0\xcf\x11\xe0", phrase("an Excel workbook"), phrase("save the points as CSV")),
    (b"\x1f\x8b", phrase("compressed (gzip)"), phrase("unpack it first")),
    (b"\x89PNG", phrase("a PNG picture"), phrase("give the measured points")),
    (b"\xff\xd8\xff", phrase("a JPEG picture"), phrase("give the measured points")),
    (b"{\\rtf", phrase("a rich text document"), phrase("save the points as plain text")),
    (b"ISO-10303-21", phrase("a STEP model"), phrase("give the measured points, not the model")),
)

_BOMS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)

_NOTHING = b"\x00 \t\r\n\x1a"
_BLOCK = 1 << 18
_CONTROL_CODES = bytes([*range(0x00, 0x09), *range(0x0E, 0x1C), 0x7F])
_CONTROL = re.compile("[" + re.escape(_CONTROL_CODES.decode("ascii")) + "]")
_ALIKE = {"\u00a0": " ", "\u202f": " ", "\u2009": " ", "\u2212": "-", "\ufeff": ""}


def beginning(data: bytes, size: int) -> bytes:
    """First bytes of a file as ASCII ones, whatever the encoding: no byte order mark, no zeros."""
    return data[:size].lstrip(b"\xef\xbb\xbf\xff\xfe").replace(b"\x00", b"")


def decode(data: bytes, name: str, drop: bytes = b"") -> str:
    r"""Text of a file, every line ending turned into ``\n``.

    Parameters
    ----------
    data : bytes
    name : str
        File name for messages.
    drop : bytes
        ASCII control characters that this format's senders put between the lines; they are left out.

    Returns
    -------
    str
        Decoded by its byte order mark, else as UTF-16 without one, UTF-8 or Windows-1252. No-break spaces are
        blanks and the typographic minus is ``-``.

    Raises
    ------
    FormatError
        If the file is empty, is known to be something else, or is no text.
    """
    # A copy of all of it is needed only where it begins with very many blanks.
    if not data[:512].strip(_NOTHING) and not data.strip(_NOTHING):
        raise FormatError(
            phrase("the file is empty") if not data else phrase("the file holds nothing but blanks"), name
        )
    head = data[:512].lstrip(codecs.BOM_UTF8).lstrip()
    for magic, kind, remedy in _NOT_TEXT:
        if head.startswith(magic):
            raise FormatError(phrase("the file is {}: {}", kind, remedy), name)
    text = _decoded(data, name)
    # Not from the bytes: they are halves of characters in UTF-16.
    for control in drop.decode("ascii"):
        text = text.replace(control, "")
    start = text[:512].lstrip().lower()
    if start.startswith(("<?xml", "<!doctype", "<html")) or re.match(r"<[a-z][\w:.-]*[\s/>]", start):
        raise FormatError(phrase("the file is XML or HTML: export the points as text with a header x,y,z"), name)
    if text.endswith(("\x1a", "\x00")):
        text = text.rstrip("\x1a\x00")
    if "\r" in text:
        text = text.replace("\r\n", "\n").replace("\r", "\n")
    # The bytes of UTF-16 hold zeros: only the text shows whether there is a control character.
    found = _CONTROL.search(text) if _has_controls(data) else None
    if found:
        line = text.count("\n", 0, found.start()) + 1
        raise FormatError(phrase("binary data (control character {}): not a text file", ord(found[0])), name, line)
    if not text.isascii():
        for character, plain in _ALIKE.items():
            text = text.replace(character, plain)
    return text


def lines_of(text: str, begin: int = 0) -> Iterator[str]:
    """Lines of a text from a place on, without cutting it up as a whole."""
    while begin <= len(text):
        end = text.find("\n", begin)
        if end < 0:
            end = len(text)
        yield text[begin:end]
        begin = end + 1


def blocks_of(text: str, size: int) -> Iterator[str]:
    """Whole lines of a text, about `size` characters at a time, each ending in a line end but for the last."""
    begin = 0
    while begin < len(text):
        end = text.rfind("\n", begin, begin + size) + 1 or text.find("\n", begin) + 1 or len(text)
        yield text[begin:end]
        begin = end


def _has_controls(data: bytes) -> bool:
    """Whether any of `_CONTROL_CODES` is among the bytes; block by block, faster than a search in the text."""
    codes = np.frombuffer(data, dtype=np.uint8)
    for begin in range(0, len(codes), _BLOCK):
        block = codes[begin : begin + _BLOCK]
        # Below blank: tab to carriage return are left, and what str.split takes for blanks.
        if ((block < 0x09) | (block - 0x0E < 0x0E) | (block == 0x7F)).any():
            return True
    return False


def _decoded(data: bytes, name: str) -> str:
    if data.isascii() and b"\x00" not in data[:4096]:
        return data.decode("ascii")
    for mark, encoding in _BOMS:
        if data.startswith(mark):
            return _strict(data[len(mark) :], encoding, name)
    # Latin text as UTF-16 without a mark has a zero in nearly every other byte.
    sample = data[:4096]
    half = max(1, len(sample) // 2)
    if sample[1::2].count(0) > 0.7 * half and sample[0::2].count(0) < 0.1 * half:
        return _strict(data, "utf-16-le", name)
    if sample[0::2].count(0) > 0.7 * half and sample[1::2].count(0) < 0.1 * half:
        return _strict(data, "utf-16-be", name)
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return _strict(data, "cp1252", name)


def _strict(data: bytes, encoding: str, name: str) -> str:
    try:
        return data.decode(encoding)
    except UnicodeDecodeError as error:
        newlines = (b"\n", b"\r\n", b"\r")
        line = max(data.count(n, 0, error.start) for n in newlines) + 1
        kind = phrase("binary or truncated") if encoding.startswith("utf") else "binary"
        raise FormatError(phrase("the file is {}: no text in {}", kind, encoding.upper()), name, line) from error
