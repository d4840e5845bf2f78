"""Concrete symbols that words express: labels, spatial references, cardinals, ordinals, kinds of container and action.

The closed ones are all judged for every phrase, so that words outside the lexicon can be learned; of numbers and ranks,
those that the words or a child speak of.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from grounding.features.context import named_how
from grounding.features.scope import Scope
from grounding.geometry.layout import UPRIGHT
from grounding.language.lexicon import known_colors
from grounding.symbols import (
    ACTION_KINDS,
    CONTAINER_KINDS,
    SPATIAL_REFERENCES,
    Action,
    Cardinal,
    Container,
    ObjectColor,
    ObjectType,
    Ordinal,
    SpatialReference,
    Symbol,
)

Proposals = list[tuple[Symbol, list[str]]]

_COUNTERPARTS: dict[Symbol | None, Symbol] = {
    SpatialReference(a): SpatialReference(b) for pair in UPRIGHT.items() for a, b in (pair, pair[::-1])
}
"""What a direction may stand for on a table that is seen from above, and upright: top is back, bottom is front."""
_IDENTIFIED = (SpatialReference, Container, Action, ObjectType)  # kinds whose members are worth weights of their own


def judged(scope: Scope, symbols: Iterable[Symbol]) -> Proposals:
    """Concrete symbols with their roles: how words name them, what the children say of them."""
    proposals: Proposals = []
    for symbol in symbols:
        roles = [*named_how(scope, symbol), *_identity(symbol)]
        if isinstance(symbol, SpatialReference) and _COUNTERPARTS.get(symbol) in scope.named:
            roles.append(f"{symbol.name} where {'things are stacked' if scope.layout.has_stacks else 'all is level'}")
        elif isinstance(symbol, Container) and _named_less(scope, symbol):
            roles.append("another kind is named more")
        for role, source in scope.child_sources.items():
            if symbol in source.symbols:
                roles.append(f"in {role}")
        proposals.append((symbol, roles))
    return proposals


class Closed:
    """All symbols of a closed family; what nothing speaks of has the same roles in every phrase, made once."""

    def __init__(self, symbols: Sequence[Symbol]) -> None:
        self._symbols = symbols
        self._places = {symbol: i for i, symbol in enumerate(symbols)}
        self._unspoken: Proposals = [(symbol, ["not named", *_identity(symbol)]) for symbol in symbols]

    def judged(self, scope: Scope) -> Proposals:
        """The same as `judged` of all symbols."""
        proposals = self._unspoken.copy()
        for place in self._spoken(scope):
            proposals[place : place + 1] = judged(scope, self._symbols[place : place + 1])
        return proposals

    def _spoken(self, scope: Scope) -> Iterable[int]:
        """Places of the symbols that the phrase or its children speak of, or that what it says bears upon."""
        touched = [symbol for symbol in scope.named if symbol in self._places]
        if touched and isinstance(touched[0], Container):
            return range(len(self._symbols))  # one that is named makes the others named less
        touched += [_COUNTERPARTS[symbol] for symbol in touched if symbol in _COUNTERPARTS]
        for source in scope.child_sources.values():
            touched += [symbol for symbol in source.symbols if symbol in self._places]
        return {self._places[symbol] for symbol in touched}


def _identity(symbol: Symbol) -> list[str]:
    """The role that tells which symbol it is, of kinds where that is worth weights."""
    if not isinstance(symbol, _IDENTIFIED):
        return []
    mirrored = isinstance(symbol, SpatialReference) and symbol.name in ("left", "right")
    return ["is a side" if mirrored else f"is {symbol}"]


def _named_less(scope: Scope, symbol: Container) -> bool:
    """Whether more words name another kind of container than this one: "vertical line"."""
    counts = {s: len(how) for s, how in scope.named.items() if isinstance(s, Container)}
    return max(counts.values(), default=0) > counts.get(symbol, 0)


def _spoken(scope: Scope, kind: type) -> list[Symbol]:
    """Symbols of a kind that the words or the children speak of, in a fixed order."""
    found = [symbol for symbol in scope.named if isinstance(symbol, kind)]
    for source in scope.child_sources.values():
        found += [symbol for symbol in source.symbols if isinstance(symbol, kind)]
    return sorted(dict.fromkeys(found), key=str)


_SPATIAL = Closed(tuple(SpatialReference(name) for name in SPATIAL_REFERENCES))
_KINDS = Closed(tuple(Container(kind) for kind in CONTAINER_KINDS))
_VERBS = Closed(tuple(Action(kind) for kind in ACTION_KINDS))
_COLORS = Closed(tuple(ObjectColor(name) for name in known_colors()))


def types(scope: Scope) -> Proposals:
    """Types of the world, and those that words name. A word that is a type's own name names it."""
    symbols = dict.fromkeys(_spoken(scope, ObjectType))
    symbols.update(dict.fromkeys(ObjectType(name) for name in sorted(scope.layout.types)))
    proposals = judged(scope, symbols)
    words = {word.text for word in scope.phrase.words}
    for symbol, roles in proposals:
        if isinstance(symbol, ObjectType) and roles[0] == "not named" and symbol.name in words:
            roles[0] = "named by its own name"
            roles.append("named")
    return proposals


def colors(scope: Scope) -> Proposals:
    """All known colours."""
    return _COLORS.judged(scope)


def spatial_references(scope: Scope) -> Proposals:
    """All spatial references."""
    return _SPATIAL.judged(scope)


def cardinals(scope: Scope) -> Proposals:
    """The numbers that are spoken of and, of several things, how many there are."""
    spoken = _spoken(scope, Cardinal)
    counted = Cardinal(scope.layout.size)
    if not scope.plural or counted in spoken or not scope.layout.size:
        return judged(scope, spoken)
    return [*judged(scope, spoken), (counted, ["number of all things"])]


def ordinals(scope: Scope) -> Proposals:
    """The ranks that are spoken of."""
    return judged(scope, _spoken(scope, Ordinal))


def kinds(scope: Scope) -> Proposals:
    """All kinds of container, without their objects."""
    return _KINDS.judged(scope)


def verbs(scope: Scope) -> Proposals:
    """All kinds of action, without their objects."""
    return _VERBS.judged(scope)
