"""The families of factors: for each kind of symbol, which are proposed for a phrase and in which roles they stand.

Three stages: the concrete symbols that words express come first; abstract symbols are proposed from those that are
likely (Equations 11 to 13) and from the children's groundings; objects and actions are judged beside them.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from grounding.features import abstract, acting, attributes, concrete
from grounding.features.scope import Scope
from grounding.symbols import (
    Action,
    Cardinal,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    ObjectColor,
    ObjectSymbol,
    ObjectType,
    Ordinal,
    Region,
    SpatialReference,
    Symbol,
)

Propose = Callable[[Scope], list[tuple[Symbol, list[str]]]]


class Family(NamedTuple):
    """One log-linear factor and the symbols it judges.

    Attributes:
        name: of the factor.
        stage: 0 for concrete symbols that words express, 1 for abstract symbols, 2 for objects and actions.
        propose: gives the proposed symbols of a phrase, each with its roles.
    """

    name: str
    stage: int
    propose: Propose


FAMILIES: tuple[Family, ...] = (
    Family("type", 0, concrete.types),
    Family("color", 0, concrete.colors),
    Family("spatial", 0, concrete.spatial_references),
    Family("cardinal", 0, concrete.cardinals),
    Family("ordinal", 0, concrete.ordinals),
    Family("kind", 0, concrete.kinds),
    Family("verb", 0, concrete.verbs),
    Family("object", 2, abstract.objects),
    Family("attribute", 1, attributes.attributes),
    Family("collection", 1, attributes.collections),
    Family("container", 1, abstract.containers),
    Family("region", 1, acting.regions),
    Family("action", 2, acting.actions),
)
STAGES: tuple[tuple[Family, ...], ...] = tuple(tuple(f for f in FAMILIES if f.stage == stage) for stage in range(3))


def family_of(symbol: Symbol) -> str:
    """The name of the family that judges a symbol."""
    match symbol:
        case Container(_, objects):
            return "container" if objects else "kind"
        case Action(_, objects):
            return "action" if objects else "verb"
    return {
        ObjectType: "type",
        ObjectColor: "color",
        SpatialReference: "spatial",
        Cardinal: "cardinal",
        Ordinal: "ordinal",
        ObjectSymbol: "object",
        ObjectAttribute: "attribute",
        ContainerAttribute: "collection",
        Region: "region",
    }[type(symbol)]
