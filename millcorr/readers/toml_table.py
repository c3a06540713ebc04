# SPDX-License-Identifier: LGPL-2.1-or-later
"""TOML files that a user writes: read whole, every key known, errors that name the file."""

from __future__ import annotations

import difflib
import re
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from millcorr.errors import FormatError
from millcorr.messages import phrase

from .source import shown

_LARGEST_FILE = 1 << 20


def toml_table(path: str | Path, what: str, keys: Sequence[str]) -> dict[str, Any]:
    """Content of a TOML file.

    Parameters
    ----------
    path : str or Path
    what : str
        What the file describes, for messages: "mapping".
    keys : sequence of str
        All keys that it may have.

    Raises
    ------
    FormatError
        If the file cannot be read, is no TOML, or has another key; names the file, and the line or the key.
    """
    path = Path(path)
    try:
        if path.stat().st_size > _LARGEST_FILE:
            raise FormatError(phrase("too large for a {}", what), path)
        table = tomllib.loads(path.read_bytes().decode("utf-8-sig"))
    except OSError as error:
        raise FormatError(phrase("the {} cannot be read: {}", what, error.strerror or error), path) from error
    except UnicodeDecodeError as error:
        raise FormatError(phrase("the {} is no text in UTF-8", what), path) from error
    except tomllib.TOMLDecodeError as error:
        found = re.search(r"at line (\d+)", str(error))
        reason = re.sub(r"\s*\(at .*", "", str(error))
        raise FormatError(phrase("no TOML: {}", shown(reason)), path, int(found[1]) if found else None) from error
    except (ValueError, RecursionError) as error:
        raise FormatError(phrase("no TOML that describes a {}", what), path) from error
    for key in table:
        if key not in keys:
            near = difflib.get_close_matches(key, keys, 1)
            hint = phrase("did you mean {}?", near[0]) if near else phrase("a {} has {}", what, ", ".join(keys))
            raise FormatError(phrase("{} is no key of a {}: {}", shown(key), what, hint), path)
    return table
