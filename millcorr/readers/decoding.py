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
_PIECE = 1 << 16
"""Characters of a piece: what a reader looks at in one go."""
_START = 512
"""Characters at the beginning that show what a file is."""
_SAMPLE = 4096
"""Bytes at the beginning in which UTF-16 shows itself by its zeros."""
_RETURN = 13
_LINE_END = re.compile(rb"[\r\n]")
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
    _refuse_other_kinds(data, name)
    text = _decoded(data, name)
    # Not from the bytes: they are halves of characters in UTF-16.
    for control in drop.decode("ascii"):
        text = text.replace(control, "")
    _refuse_markup(text[:_START], name)
    if text.endswith(("\x1a", "\x00")):
        text = text.rstrip("\x1a\x00")
    text = _with_newlines(text)
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


def pieces(data: bytes, name: str, drop: bytes = b"", table: bytes | None = None) -> Iterator[str]:
    r"""Text of a file as `decode` gives it, some thousand whole lines at a time.

    Of a file in ASCII, which most are, there is never a second copy. All that `decode` refuses is refused before the
    first piece.

    Parameters
    ----------
    data, name, drop
        As in `decode`.
    table : bytes, optional
        What stands for each byte, as `bytes.translate` takes it; line ends, blanks and letters stand for themselves.

    Returns
    -------
    iterator of str
        Each ends in ``\n``, except perhaps the last; together they are the text.
    """
    end = len(data)
    while end and data[end - 1] in b"\x1a\x00" + drop:
        end -= 1
    # What `decode` would refuse, or take for UTF-16, is left to it.
    controlled = _has_controls(data[: len(data) if drop else end], drop, table)
    if not data.isascii() or b"\x00" in data[:_SAMPLE] or controlled:
        return _cut(decode(data if table is None else data.translate(table), name, drop))
    _refuse_other_kinds(data, name)
    _refuse_markup(data[: 8 * _START].translate(table, drop)[:_START].decode("ascii"), name)
    return _ascii_pieces(data, end, drop, table)


def plain(data: bytes, name: str) -> bytes:
    r"""Text of a file as `decode` gives it, in UTF-8; the file's own bytes where these are it.

    Parameters
    ----------
    data, name
        As in `decode`.

    Returns
    -------
    bytes
        Lines end in ``\n`` or ``\r\n``.
    """
    own = data.isascii() and data.count(b"\r") == data.count(b"\r\n") and not _has_controls(data)
    if not own:
        return decode(data, name).encode("utf-8", "surrogatepass")
    _refuse_other_kinds(data, name)
    _refuse_markup(data[:_START].decode("ascii"), name)
    return data


def _cut(text: str) -> Iterator[str]:
    begin = 0
    while begin < len(text):
        end = text.rfind("\n", begin, begin + _PIECE) + 1 or text.find("\n", begin) + 1 or len(text)
        yield text[begin:end]
        begin = end


def _ascii_pieces(data: bytes, stop: int, drop: bytes, table: bytes | None) -> Iterator[str]:
    """Pieces of the first `stop` bytes; those of `drop` may stand anywhere, also within a line's end."""
    begin = 0
    while begin < stop:
        reach = min(begin + _PIECE, stop)
        end = data.rfind(b"\n", begin, reach) + 1 or data.rfind(b"\r", begin, reach) + 1
        if not end:
            found = _LINE_END.search(data, reach, stop)
            end = found.end() if found else stop
        if data[end - 1] == _RETURN:
            while end < stop and data[end] in drop:
                end += 1
            end += data[end : end + 1] == b"\n"
        yield _with_newlines(data[begin:end].translate(table, drop).decode("ascii"))
        begin = end


def _with_newlines(text: str) -> str:
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def _refuse_other_kinds(data: bytes, name: str) -> None:
    """FormatError if a file holds nothing, or is known to be something else than text."""
    # A copy of all of it is needed only where it begins with very many blanks.
    if not data[:_START].strip(_NOTHING) and not data.strip(_NOTHING):
        raise FormatError(
            phrase("the file is empty") if not data else phrase("the file holds nothing but blanks"), name
        )
    head = data[:_START].lstrip(codecs.BOM_UTF8).lstrip()
    for magic, kind, remedy in _NOT_TEXT:
        if head.startswith(magic):
            raise FormatError(phrase("the file is {}: {}", kind, remedy), name)


def _refuse_markup(beginning: str, name: str) -> None:
    """FormatError if a text begins as XML or HTML does."""
    start = beginning.lstrip().lower()
    if start.startswith(("<?xml", "<!doctype", "<html")) or re.match(r"<[a-z][\w:.-]*[\s/>]", start):
        raise FormatError(phrase("the file is XML or HTML: export the points as text with a header x,y,z"), name)


def _has_controls(data: bytes, drop: bytes = b"", table: bytes | None = None) -> bool:
    """Whether any of `_CONTROL_CODES` is among the translated bytes; by the block, faster than a search in the text."""
    for begin in range(0, len(data), _BLOCK):
        block = np.frombuffer(data[begin : begin + _BLOCK].translate(table, drop), dtype=np.uint8)
        # Below blank: tab to carriage return are left, and what str.split takes for blanks.
        if ((block < 0x09) | (block - 0x0E < 0x0E) | (block == 0x7F)).any():
            return True
    return False


def _decoded(data: bytes, name: str) -> str:
    if data.isascii() and b"\x00" not in data[:_SAMPLE]:
        return data.decode("ascii")
    for mark, encoding in _BOMS:
        if data.startswith(mark):
            return _strict(data[len(mark) :], encoding, name)
    # Latin text as UTF-16 without a mark has a zero in nearly every other byte.
    sample = data[:_SAMPLE]
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
