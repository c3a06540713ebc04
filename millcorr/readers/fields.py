# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of a text line: what is a number, and why something is none."""

from __future__ import annotations

import re

from millcorr.messages import phrase

from .source import shown

NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
COMMA_NUMBER = re.compile(r"[+-]?(?:\d+,\d*|,\d+)(?:[eE][+-]?\d+)?", re.ASCII)
_GROUPED = re.compile(r"[+-]?\d{1,3}(?:,\d{3})+(?:\.\d*)?", re.ASCII)
_DATE = re.compile(
    r"\d{1,4}[./-]\d{1,2}[./-]\d{1,4}.*"
    r"|\d{1,2}[.-]? ?[A-Za-zä]{3,4}\.?(?:[ -]\d{2,4})?"
    r"|[A-Za-zä]{3,4}[ -]\d{1,4}"
)
COMMENT = re.compile(r"(?:^|(?<=[\s,;]))(?:#|//)[^\n]*", re.MULTILINE)


def split(line: str, separator: str | None) -> list[str]:
    """Fields of a line without the blanks around them; a separator of None is any run of blanks."""
    return line.split() if separator is None else [f.strip() for f in line.split(separator)]


def is_number(field: str, separator: str | None) -> bool:
    """Whether a field is a number, with a decimal point or, where commas do not separate, a decimal comma."""
    return bool(NUMBER.fullmatch(field) or (separator != "," and COMMA_NUMBER.fullmatch(field)))


def mixed_marks(field: str) -> str:
    """What to say of a number whose decimal mark is not that of the numbers before."""
    return phrase(
        "{}: decimal points and decimal commas in one file; a spreadsheet may have spoilt it, export "
        "again with decimal points",
        shown(field),
    )


def why_no_number(field: str, separator: str | None) -> str:
    """What to say of a field that should be a number and is none."""
    if field == "":
        return phrase("a coordinate is missing: delete the row or measure the point again")
    if re.fullmatch(r"[+-]?(nan|inf(inity)?|1?\.?#.*|\*+|-+|n/?a|null|none|#.*!?)", field, re.IGNORECASE):
        return phrase("{} is no measured value: delete the row or measure the point again", shown(field))
    if _DATE.fullmatch(field):
        return phrase("{} is a date: a spreadsheet has spoilt the number, export again without it", shown(field))
    if separator != "," and _GROUPED.fullmatch(field):
        return phrase("{}: thousands separator or decimal comma? Export with plain decimal points", shown(field))
    return phrase("{} is no number", shown(field))
