"""The notation of productions, and how it is read.

A section `[symbol]` lists the productions of a symbol, one a line::

    name weight @mark ... : template

A template is a sequence of leaves, phrases and slots. A leaf is one word or several to choose from, with a tag where
the usual one is not meant, for a word and those before it (`left|right/NN`); a phrase is in brackets as in trees
(`(PP of (NP <set>))`); a slot is the name of a symbol (`<color>`), with a chance where it may stay empty
(`<color>?0.5`).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from grounding.corpus.wording.words import USUAL_TAGS
from grounding.errors import CorpusError

_SECTION = re.compile(r"\[([\w.]+)\]\Z")
_LINE = re.compile(r"([\w.]+) +(\d+(?:\.\d+)?)((?: +@\w+)*) *:(.*)\Z")
_PART = re.compile(r"\s*(?:(\()([A-Z]+)|(\))|<([\w.]+)>(?:\?(0?\.\d+))?|([^\s()<>]+))")


@dataclass(frozen=True)
class Leaf:
    """A word.

    Attributes:
        choices: words to choose from, each with its Penn tag.
    """

    choices: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Slot:
    """A place for what a symbol becomes.

    Attributes:
        symbol: its name.
        chance: of the place being filled.
    """

    symbol: str
    chance: float


@dataclass(frozen=True)
class Branch:
    """A phrase.

    Attributes:
        tag: the phrase type.
        parts: what it is made of.
    """

    tag: str
    parts: tuple[Part, ...]


Part = Leaf | Slot | Branch


@dataclass(frozen=True)
class Production:
    """One way of making a symbol.

    Attributes:
        name: symbol and name of the production, joined by a dot; unique.
        weight: how often it is taken, relative to the symbol's others.
        marks: what it speaks of, for leaving it out: see `grounding.corpus.wording.sampler.MARKS`.
        parts: what it makes.
    """

    name: str
    weight: float
    marks: frozenset[str]
    parts: tuple[Part, ...]

    def slots(self) -> Iterator[Slot]:
        """All slots, in order."""
        return _slots(self.parts)


def read_productions(*texts: str) -> Mapping[str, tuple[Production, ...]]:
    """Read productions.

    Args:
        texts: in the notation above; each symbol has its section in one of them.

    Returns:
        symbol -> its productions, in the order of the text.

    Raises:
        CorpusError: a line that cannot be read, a name used twice, a slot of an unknown symbol, or a word without a
            usual tag; names the line.
    """
    table: dict[str, list[Production]] = {}
    names: set[str] = set()
    for text in texts:
        symbol = ""
        for line in (raw.strip() for raw in text.splitlines()):
            section = _SECTION.match(line)
            if section:
                symbol = section.group(1)
                if symbol in table:
                    raise CorpusError(f"productions: symbol {symbol!r} has two sections")
                table[symbol] = []
            elif line and not line.startswith("#"):
                production = _read_line(symbol, line)
                if production.name in names:
                    raise CorpusError(f"productions: the name {production.name!r} is used twice")
                names.add(production.name)
                table[symbol].append(production)
    for productions in table.values():
        for production in productions:
            for slot in production.slots():
                if slot.symbol not in table:
                    raise CorpusError(f"production {production.name!r}: there is no symbol {slot.symbol!r}")
    return {symbol: tuple(productions) for symbol, productions in table.items()}


def _slots(parts: tuple[Part, ...]) -> Iterator[Slot]:
    for part in parts:
        if isinstance(part, Slot):
            yield part
        elif isinstance(part, Branch):
            yield from _slots(part.parts)


def _read_line(symbol: str, line: str) -> Production:
    match = _LINE.match(line)
    if match is None or not symbol:
        raise CorpusError(f"expected a production 'name weight @mark: template' and found {line!r}")
    name, weight, marks, template = match.groups()
    return Production(
        f"{symbol}.{name}", float(weight), frozenset(marks.replace("@", " ").split()), _read_template(template, line)
    )


def _read_template(template: str, line: str) -> tuple[Part, ...]:
    levels: list[tuple[str, list[Part]]] = [("", [])]
    position = 0
    text = template.strip()
    while position < len(text):
        match = _PART.match(text, position)
        if match is None:
            raise CorpusError(f"production {line!r} is unreadable from {text[position : position + 20]!r}")
        position = match.end()
        opens, tag, closes, slot, chance, words = match.groups()
        if opens:
            levels.append((tag, []))
        elif closes:
            if len(levels) == 1:
                raise CorpusError(f"production {line!r} closes a bracket that is not open")
            tag, parts = levels.pop()
            levels[-1][1].append(Branch(tag, tuple(parts)))
        else:
            levels[-1][1].append(Slot(slot, float(chance or 1)) if slot else _read_leaf(words, line))
    if len(levels) > 1:
        raise CorpusError(f"production {line!r} leaves a bracket open")
    return tuple(levels[0][1])


def _read_leaf(text: str, line: str) -> Leaf:
    choices: list[tuple[str, str]] = []
    waiting: list[str] = []
    for part in text.split("|"):
        word, _, tag = part.partition("/")
        waiting.append(word)
        if tag:
            choices += [(word, tag) for word in waiting]
            waiting = []
    choices += [(word, USUAL_TAGS.get(word, "")) for word in waiting]
    if not all(word and tag for word, tag in choices):
        raise CorpusError(f"production {line!r}: {text!r} has a word without usual tag")
    return Leaf(tuple(choices))
