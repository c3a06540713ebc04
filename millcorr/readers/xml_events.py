# SPDX-License-Identifier: LGPL-2.1-or-later
"""XML as a stream of elements, without entities: neither bombs nor files from elsewhere.

Any document type declaration is refused before the parser sees an entity. The tree is never built, so that memory
follows what is wanted of the file.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol
from xml.parsers import expat

from millcorr.errors import FormatError

from .source import Source, shown

DEEPEST = 200
"""No element of a measurement file is nested deeper."""


class Handler(Protocol):
    """What is done with the elements of a document; `path` holds their names from the root, without namespaces."""

    def begin(self, path: Sequence[str], attributes: dict[str, str], line: int) -> bool:
        """An element begins; True if its text is wanted."""

    def text(self, path: Sequence[str], content: str, line: int) -> None:
        """Text of a wanted element that has just ended, comments left out; `line` is where it began."""

    def end(self, path: Sequence[str]) -> None:
        """An element ends."""


def parse(source: Source, handler: Handler, root: str) -> None:
    """Pass the elements of an XML file to a handler.

    Parameters
    ----------
    source : Source
    handler : Handler
    root : str
        Name that the root element must have.

    Raises
    ------
    FormatError
        If the file is not well-formed XML, is of another kind, or declares a document type or an entity.
    """
    parser = expat.ParserCreate(namespace_separator=" ")
    parser.buffer_text = True
    parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)
    stream = _Stream(source, handler, root, parser)
    parser.StartDoctypeDeclHandler = stream.refuse
    parser.EntityDeclHandler = stream.refuse
    parser.ExternalEntityRefHandler = stream.refuse
    parser.StartElementHandler = stream.begin
    parser.EndElementHandler = stream.end
    try:
        # In one piece: the parser goes over a long token once only.
        parser.Parse(source.data, True)
    except FormatError:
        raise
    except expat.ExpatError as error:
        reason = expat.ErrorString(error.code) or "damaged"
        raise source.error(f"not well-formed XML ({reason}): the file is damaged or cut off", error.lineno) from error
    except (ValueError, LookupError) as error:
        raise source.error(f"XML in an unknown encoding ({shown(str(error))}): save it as UTF-8") from error


class _Stream:
    """The parser's events, with the path of names, and the text of wanted elements put together."""

    def __init__(self, source: Source, handler: Handler, root: str, parser: expat.XMLParserType) -> None:
        self.source = source
        self.handler = handler
        self.root = root
        self.parser = parser
        self.path: list[str] = []
        self.names: dict[str, str] = {}
        """Names without their namespaces, by the names as the parser gives them."""
        self.wanted: list[str] | None = None
        self.wanted_depth = 0
        self.wanted_line = 0

    def refuse(self, *_: object) -> int:
        raise self.source.error(
            "the XML declares a document type or an entity, which measurement files do not need: remove it",
            self.parser.CurrentLineNumber,
        )

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        line = self.parser.CurrentLineNumber
        local = self.names.get(name)
        if local is None:
            local = self.names[name] = name.rpartition(" ")[2]
        if not self.path and local != self.root:
            raise self.source.error(f"the XML is {shown(local)}, not {self.root}", line)
        if len(self.path) >= DEEPEST:
            raise self.source.error(f"elements nested deeper than {DEEPEST}: not a measurement file", line)
        self.path.append(local)
        if self.handler.begin(self.path, attributes, line):
            self.wanted, self.wanted_depth, self.wanted_line = [], len(self.path), line
            # Text that nobody wants is not even passed on.
            self.parser.CharacterDataHandler = self.characters

    def end(self, name: str) -> None:
        if self.wanted is not None and len(self.path) == self.wanted_depth:
            content, self.wanted = "".join(self.wanted), None
            self.parser.CharacterDataHandler = None
            self.handler.text(self.path, content, self.wanted_line)
        self.handler.end(self.path)
        self.path.pop()

    def characters(self, content: str) -> None:
        if self.wanted is not None and len(self.path) == self.wanted_depth:
            self.wanted.append(content)
