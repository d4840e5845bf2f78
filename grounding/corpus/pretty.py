"""Examples for the eye: the phrase tree, indented, with the symbols of every phrase."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TextIO

from grounding.corpus.format import Example
from grounding.language.tree import Phrase, Word
from grounding.symbols import Action, Container, ObjectSymbol, Region, Symbol, symbol_key

_STYLES = {"bold": "1", "dim": "2", "concrete": "36", "abstract": "33", "action": "35"}


@dataclass(frozen=True)
class Paint:
    """Colours for a terminal, or none.

    Attributes:
        on: whether to colour at all.
    """

    on: bool = False

    @classmethod
    def for_stream(cls, stream: TextIO) -> Paint:
        """Colour only on a terminal, and not where `NO_COLOR` is set."""
        return cls(stream.isatty() and not os.environ.get("NO_COLOR"))

    def __call__(self, style: str, text: str) -> str:
        """The text in one of `_STYLES`."""
        return f"\033[{_STYLES[style]}m{text}\033[0m" if self.on and text else text


def pretty(example: Example, paint: Paint | None = None) -> str:
    """An example on several lines: its names, the instruction, then the phrases, parents before children."""
    paint = paint or Paint()
    lines = [
        f"{paint('bold', example.id)}  world {example.world!r}  {example.outcome}",
        example.instruction,
    ]
    notes = iter(example.groundings)

    def walk(phrase: Phrase, depth: int) -> None:
        symbols = next(notes)
        indent = "  " * depth
        tagged = " ".join(f"{c.text}/{c.tag}" if isinstance(c, Word) else f"[{c.text}]" for c in phrase.children)
        lines.append(f"{indent}{paint('bold', phrase.tag)} {tagged}")
        lines.extend(f"{indent}    {line}" for line in _by_kind(symbols, paint))
        for child in phrase.phrases:
            walk(child, depth + 1)

    walk(example.tree, 1)
    return "\n".join(lines)


def _by_kind(symbols: frozenset[Symbol], paint: Paint) -> list[str]:
    """One line for each kind of symbol."""
    kinds: dict[str, list[str]] = {}
    for symbol in sorted(symbols, key=symbol_key):
        kinds.setdefault(type(symbol).__name__, []).append(paint(_style(symbol), str(symbol)))
    return ["  ".join(kind) for kind in kinds.values()] or [paint("dim", "nothing")]


def _style(symbol: Symbol) -> str:
    if isinstance(symbol, Action):
        return "action"
    return "concrete" if isinstance(symbol, ObjectSymbol | Container | Region) else "abstract"
