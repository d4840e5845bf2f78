"""XML elements that remember the line they stand on, so that a refusal can name it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat

from grounding.errors import CorpusError


@dataclass(frozen=True, eq=False)
class Element:
    """An XML element without its text.

    Attributes:
        tag: its name.
        attributes: by name.
        line: where it starts, from 1.
        children: the elements directly inside it; filled while reading, not to be changed afterwards.
    """

    tag: str
    attributes: Mapping[str, str]
    line: int
    children: list[Element] = field(default_factory=list)

    def __str__(self) -> str:
        return f"line {self.line}: <{self.tag}>"

    def get(self, *names: str) -> str:
        """The first of these attributes that it has.

        Raises:
            CorpusError: it has none of them.
        """
        for name in names:
            if name in self.attributes:
                return self.attributes[name]
        raise CorpusError(f"{self}: attribute {' or '.join(map(repr, names))} is missing")

    def all(self, *tags: str) -> Iterator[Element]:
        """The children with one of these tags."""
        return (child for child in self.children if child.tag in tags)


def read_elements(path: Path | str) -> Element:
    """Read an XML file.

    Raises:
        CorpusError: the file cannot be read or is not well-formed; names the line, the caller names the file.
    """
    top = Element("", {}, 0)
    stack = [top]

    def start(tag: str, attributes: dict[str, str]) -> None:
        element = Element(tag, attributes, parser.CurrentLineNumber)
        stack[-1].children.append(element)
        stack.append(element)

    parser = expat.ParserCreate()
    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: stack.pop()
    try:
        parser.Parse(Path(path).read_bytes(), True)
    except OSError as error:
        raise CorpusError(f"cannot be read: {error.strerror}") from error
    except expat.ExpatError as error:
        reason = expat.errors.messages[error.code]
        raise CorpusError(f"line {error.lineno}: not well-formed XML: {reason}") from error
    return top.children[0]
