"""Concrete symbols that words express: labels, spatial references, cardinals, ordinals, kinds of container and action.

The closed ones are all judged for every phrase, so that words outside the lexicon can be learned; of numbers and ranks,
those that the words or a child speak of.
"""

from __future__ import annotations

from collections.abc import Iterable

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

_SPATIAL = tuple(SpatialReference(name) for name in SPATIAL_REFERENCES)
_KINDS = tuple(Container(kind) for kind in CONTAINER_KINDS)
_VERBS = tuple(Action(kind) for kind in ACTION_KINDS)
_COLORS = tuple(ObjectColor(name) for name in known_colors())
_IDENTIFIED = (SpatialReference, Container, Action, ObjectType)  # kinds whose members are worth weights of their own


def judged(scope: Scope, symbols: Iterable[Symbol]) -> Proposals:
    """Concrete symbols with their roles: how words name them, what the children say of them."""
    proposals: Proposals = []
    for symbol in symbols:
        roles = named_how(scope, symbol)
        if isinstance(symbol, _IDENTIFIED):
            mirrored = isinstance(symbol, SpatialReference) and symbol.name in ("left", "right")
            roles.append("is a side" if mirrored else f"is {symbol}")
        if isinstance(symbol, SpatialReference) and scope.named.keys() & _upright(symbol):
            roles.append(f"{symbol.name} where {'things are stacked' if scope.layout.has_stacks else 'all is level'}")
        elif isinstance(symbol, Container) and _named_less(scope, symbol):
            roles.append("another kind is named more")
        for role, source in scope.child_sources.items():
            if symbol in source.symbols:
                roles.append(f"in {role}")
        proposals.append((symbol, roles))
    return proposals


def _upright(symbol: SpatialReference) -> frozenset[SpatialReference]:
    """What a direction may stand for on a table that is seen from above, and upright: top is back, bottom is front."""
    pairs = {SpatialReference(up): SpatialReference(flat) for up, flat in UPRIGHT.items()}
    other = pairs.get(symbol) or {flat: up for up, flat in pairs.items()}.get(symbol)
    return frozenset() if other is None else frozenset([other])


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
    return judged(scope, _COLORS)


def spatial_references(scope: Scope) -> Proposals:
    """All spatial references."""
    return judged(scope, _SPATIAL)


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
    return judged(scope, _KINDS)


def verbs(scope: Scope) -> Proposals:
    """All kinds of action, without their objects."""
    return judged(scope, _VERBS)
