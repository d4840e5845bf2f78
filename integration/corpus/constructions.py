"""Constructions of an annotated instruction, for counts: superlatives, ordinals, arrangements, clauses, viewpoints."""

from __future__ import annotations

from grounding.corpus.format import Example
from grounding.language.tree import Phrase
from grounding.symbols import Cardinal, Container, ObjectAttribute, ObjectColor, Ordinal, Region, SpatialReference

_OWN = frozenset({"me", "my", "mine", "i"})
_YOURS = frozenset({"you", "your", "yours"})
_EXCLUDING = frozenset({"other", "except", "but", "not", "without", "only", "alone", "single", "lone", "itself"})
_COMPASS = frozenset("north south east west northeast northwest southeast southwest".split())
_PRONOUNS = frozenset({"it", "them", "they", "that", "this", "these", "those"})


def constructions(example: Example) -> list[str]:
    """Names of the constructions of an instruction, sorted."""
    symbols = {symbol for grounding in example.groundings for symbol in grounding}
    words = {leaf.text for leaf in example.tree.leaves}
    tags = {phrase.tag for phrase in example.tree.preorder()}
    parts = {leaf.tag for leaf in example.tree.leaves}
    told = {
        "colour": any(isinstance(symbol, ObjectColor) for symbol in symbols),
        "count": any(isinstance(symbol, Cardinal) for symbol in symbols),
        "ordinal": any(isinstance(symbol, Ordinal) for symbol in symbols),
        "direction": any(isinstance(symbol, SpatialReference) for symbol in symbols),
        "rank in a set": any(isinstance(s, ObjectAttribute) and s.index not in (None, 1) for s in symbols),
        "relation": any(isinstance(symbol, Region) for symbol in symbols),
        "superlative": bool(parts & {"JJS", "RBS"}),
        "relative clause": "SBAR" in tags,
        "statement": example.tree.tag in ("S", "SINV"),
        "several sentences": example.tree.tag == "FRAG",
        "pronoun": bool(words & _PRONOUNS) and bool(parts & {"PRP"}),
        "exclusion": bool(words & _EXCLUDING),
        "compass": bool(words & _COMPASS),
        "speaker's viewpoint": bool(words & _OWN),
        "addressee's viewpoint": bool(words & _YOURS),
    }
    kinds = {symbol.kind for symbol in symbols if isinstance(symbol, Container) and symbol.objects}
    depth = _depth(example.tree)
    nesting = f"nested {depth} deep" if depth < 4 else "nested 4 and deeper"
    return sorted({name for name, there in told.items() if there} | kinds | {nesting})


def _depth(phrase: Phrase) -> int:
    """The number of noun phrases with postmodifiers that lie in one another."""
    inner = max((_depth(child) for child in phrase.phrases), default=0)
    return inner + (phrase.tag == "NP" and any(child.tag in ("PP", "SBAR") for child in phrase.phrases))
