# SPDX-License-Identifier: LGPL-2.1-or-later
"""XML as a stream of elements, without entities: neither bombs nor files from elsewhere.

Any document type declaration is refused before the parser sees an entity. The tree is never built, so that memory
follows what is wanted of the file. What is done with an element is looked up once per name and place, not once per
element: large documents hold millions of elements of a few dozen names.
"""

from __future__ import annotations

from collections.abc import Callable
from xml.parsers import expat

from millcorr.errors import FormatError
from millcorr.messages import phrase

from .source import Source, shown

DEEPEST = 200
"""No element of a measurement file is nested deeper."""

_DECLARATIONS = ("StartDoctypeDeclHandler", "EntityDeclHandler", "ExternalEntityRefHandler")

Opened = Callable[[dict[str, str], int], None]
Content = Callable[[str], object]


class Element(dict[str, "Element"]):
    """What is done with an element in its place; as a mapping, what is done with those inside it, by name.

    Parameters
    ----------
    inside : callable, optional
        What is done with an element inside this one, by its name without prefix; None for nothing, as by default.
    begin : callable, optional
        Called with an element's attributes and line when it begins.
    text : callable, optional
        Called with its text, comments left out, when it ends. Elements inside are refused.
    end : callable, optional
        Called when it ends, where `text` is not.

    Attributes
    ----------
    line : int
        Where the last element in this place began of which anything is wanted.
    """

    __slots__ = ("begin", "end", "idle", "inside", "line", "text")

    def __init__(
        self,
        inside: Callable[[str], Element | None] | None = None,
        *,
        begin: Opened | None = None,
        text: Content | None = None,
        end: Callable[[], None] | None = None,
    ) -> None:
        self.inside = inside
        self.begin = begin
        self.text = text
        self.end = end
        self.idle = begin is None and text is None
        self.line = 0

    def __missing__(self, name: str) -> Element:
        found = self.inside(name.rpartition(":")[2]) if self.inside is not None else None
        self[name] = found = NOTHING if found is None else found
        return found


NOTHING = Element()
"""An element of which nothing is wanted."""


def parse(source: Source, root: str, element: Element) -> None:
    """Go through the elements of an XML file.

    Parameters
    ----------
    source : Source
    root : str
        Name that the root element must have.
    element : Element
        What is done with the root element.

    Raises
    ------
    FormatError
        If the file is not well-formed XML, is of another kind, or declares a document type or an entity.
    """
    parser = expat.ParserCreate()
    parser.buffer_text = True
    parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)
    parser.StartElementHandler, parser.EndElementHandler = _handlers(source, root, element, parser)

    def refuse(*_: object) -> int:
        raise source.error(
            phrase("the XML declares a document type or an entity, which measurement files do not need: remove it"),
            parser.CurrentLineNumber,
        )

    for declaration in _DECLARATIONS:
        setattr(parser, declaration, refuse)
    try:
        # In one piece: the parser goes over a long token once only.
        parser.Parse(source.data, True)
    except FormatError:
        raise
    except expat.ExpatError as error:
        reason = expat.ErrorString(error.code) or phrase("damaged")
        raise source.error(
            phrase("not well-formed XML ({}): the file is damaged or cut off", reason), error.lineno
        ) from error
    except (ValueError, LookupError) as error:
        raise source.error(phrase("XML in an unknown encoding ({}): save it as UTF-8", shown(str(error)))) from error
    finally:
        # They refer to the parser: file and buffers would stay until Python looks for cycles.
        for handler in (*_DECLARATIONS, "StartElementHandler", "EndElementHandler", "CharacterDataHandler"):
            setattr(parser, handler, None)


def _handlers(
    source: Source, root: str, element: Element, parser: expat.XMLParserType
) -> tuple[Callable[[str, dict[str, str]], None], Callable[[str], None]]:
    """What the parser is to call at the begin and at the end of each element."""
    place = Element(lambda name: element if name == root else None)
    outer: list[Element] = []
    chunks: list[str] = []
    enter, leave, collect, take = outer.append, outer.pop, chunks.append, chunks.pop

    def begin(name: str, attributes: dict[str, str]) -> None:
        nonlocal place
        enter(place)
        place = place[name]
        if place.idle:
            if place is NOTHING or len(outer) > DEEPEST:
                check(name)
            return
        place.line = parser.CurrentLineNumber
        if place.begin is not None:
            place.begin(attributes, place.line)
        if place.text is not None:
            # Text that nobody wants is not even passed on.
            parser.CharacterDataHandler = collect

    def check(name: str) -> None:
        line = parser.CurrentLineNumber
        if len(outer) == 1 and place is NOTHING:
            raise source.error(phrase("the XML is {}, not {}", shown(name.rpartition(":")[2]), root), line)
        if outer[-1].text is not None:
            raise source.error(phrase("{} stands where the text of an element was expected", shown(name)), line)
        if len(outer) > DEEPEST:
            raise source.error(phrase("elements nested deeper than {}: not a measurement file", DEEPEST), line)

    def end(_: str) -> None:
        nonlocal place
        if place.text is not None:
            parser.CharacterDataHandler = None
            if len(chunks) == 1:
                place.text(take())
            else:
                content = "".join(chunks)
                chunks.clear()
                place.text(content)
        elif place.end is not None:
            place.end()
        place = leave()

    return begin, end
