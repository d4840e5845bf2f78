"""What is said when no reading names anything: is it the words, the world, or something left open?"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from grounding.describing import whats_missing
from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of
from grounding.inference import Hypothesis, aligned
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.readings import Reading
from grounding.symbols import (
    Action,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    ObjectColor,
    ObjectSymbol,
    ObjectType,
    Symbol,
    symbol_key,
)

_NOUN_TAGS = ("NN", "NNS", "NNP", "NNPS")
_PLACE_NOUNS = ("side", "end", "edge", "half", "corner", "hand")  # parts of things, no things
_WORD_TAGS = ("NN", "VB", "JJ")
_INSTRUCTED = ("PP", "SBAR", "ADVP", "VP", "S")
_MOST = 5  # alternatives that are listed


@dataclass(frozen=True)
class Unanswered:
    """Why there is no answer.

    Attributes:
        outcome: "ambiguous", "no_referent" or "not_understood".
        explanation: one sentence, for people.
        question: where the outcome is "ambiguous".
        words: that were not understood.
        alternatives: (action, objects, share of belief), where the outcome is "ambiguous".
    """

    outcome: str
    explanation: str
    question: str | None = None
    words: tuple[str, ...] = ()
    alternatives: tuple[tuple[str, tuple[str, ...], float], ...] = ()


def unanswered(reading: Reading, layout: Layout, unknown: Sequence[str]) -> Unanswered:
    """Find out why the likeliest reading names nothing.

    Args:
        reading: the likeliest one.
        layout: the world.
        unknown: words that the grammar does not know.
    """
    tree = reading.inference.tree
    walked = list(aligned(tree, reading.hypothesis))
    said = frozenset(symbol for _, h in walked for symbol in h.symbols)
    asks = any(isinstance(symbol, Action) for symbol in said) or tree.tag == "NP"
    names = any(isinstance(s, ObjectType | ObjectColor | Container) and s != Container("robot") for s in said)
    strange = [word for word in _strange_nouns(tree, layout) if asks]
    if not asks or not (names or strange):
        heard = tuple(dict.fromkeys((*unknown, *_strange_words(tree))))
        reason = "say what to handle: which block, row or tower" if asks else "this asks for no pick, place or clear"
        if heard:
            reason = f"I do not understand {_quoted(heard)}"
        return Unanswered("not_understood", reason, words=heard)
    heard = tuple(dict.fromkeys((*unknown, *strange)))
    if strange:
        known = sorted({item.type for item in layout.things}) or ["nothing"]
        why = f"I know of nothing called {_quoted(strange)} here; the world has: {', '.join(known)}"
        return Unanswered("no_referent", why, words=heard)
    for phrase, hypothesis in reversed(walked):
        if layout.size and _lacks_place(phrase, hypothesis):
            return _open_place(hypothesis, layout, heard)
    for phrase, hypothesis in reversed(walked):
        below = frozenset().union(*(child.symbols for child in hypothesis.children), frozenset())
        missing = whats_missing(layout, hypothesis.symbols, below)
        if missing is not None:
            return Unanswered("no_referent", f"{phrase.text!r}: {missing}", words=heard)
    if not any(isinstance(s, Container) and s != Container("robot") for s in said):
        counted = _open_count(said, layout, heard)
        if counted is not None:
            return counted
    hollow = [p.text for p, h in reversed(walked) if p.tag in ("NP", "PP") and not h.symbols]
    why = f"nothing here is {hollow[0]!r}" if hollow else "nothing in this world is what these words describe"
    return Unanswered("no_referent", why, words=heard)


def _lacks_place(phrase: Phrase, hypothesis: Hypothesis) -> bool:
    """Whether a phrase asks to place something without saying where."""
    told = any(child.tag in _INSTRUCTED for child in phrase.phrases)
    return phrase.tag == "VP" and not told and Action("place") in hypothesis.symbols


def _open_place(hypothesis: Hypothesis, layout: Layout, heard: tuple[str, ...]) -> Unanswered:
    why = "where to is open: say where to put it, such as on, beside or behind something"
    below = frozenset().union(*(child.symbols for child in hypothesis.children), frozenset())
    objects = tuple(sorted(s.id for s in below if isinstance(s, ObjectSymbol)))
    pool = layout.everything
    for symbol in below:
        if isinstance(symbol, ObjectAttribute):
            pool &= layout.matching(symbol.object_type, symbol.color)
    meant = [objects] if objects else [(layout.ids[i],) for i in indices_of(pool)]
    options = tuple(("place", names, 1 / len(meant)) for names in meant[:_MOST])
    return Unanswered("ambiguous", why, "Where shall I put it?", heard, options)


def _open_count(said: frozenset[Symbol], layout: Layout, heard: tuple[str, ...]) -> Unanswered | None:
    """Asks which ones, where fewer are wanted than there are; None where no number leaves that open."""
    kinds = [symbol.kind for symbol in sorted(said, key=symbol_key) if isinstance(symbol, Action)] or ["pick"]
    for symbol in sorted(said, key=symbol_key):
        if isinstance(symbol, ContainerAttribute) and symbol.number and symbol.relation is None:
            there = layout.names(layout.matching(symbol.object_type, symbol.color))
            if symbol.number < len(there):
                noun = " ".join(filter(None, (symbol.color, symbol.object_type or "object")))
                question = f"There are {len(there)} {noun}s; which {symbol.number} of them do you mean?"
                sets = list(itertools.islice(itertools.combinations(there, symbol.number), _MOST))
                share = 1 / _choose(len(there), symbol.number)
                options = tuple((kinds[0], names, share) for names in sets)
                return Unanswered("ambiguous", "it is open which ones are meant", question, heard, options)
    return None


def _choose(total: int, taken: int) -> int:
    ways = 1
    for i in range(taken):
        ways = ways * (total - i) // (i + 1)
    return ways


def _strange_nouns(tree: Phrase, layout: Layout) -> Iterator[str]:
    types = layout.types
    for phrase in tree.preorder():
        nouns = [word for word in phrase.words if word.tag in _NOUN_TAGS]
        if phrase.tag == "NP" and nouns:
            noun = nouns[-1].text
            if not meanings(noun) and noun not in types and noun not in _PLACE_NOUNS:
                yield noun


def _strange_words(tree: Phrase) -> Iterator[str]:
    for leaf in tree.leaves:
        if leaf.tag[:2] in _WORD_TAGS and not meanings(leaf.text):
            yield leaf.text


def _quoted(words: Sequence[str]) -> str:
    return ", ".join(f"'{word}'" for word in words)
