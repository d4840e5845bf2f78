"""Concepts, each with the definitions of it that the program has: what every one of its parts takes the concept for.

A concept is asked for every reference in a world: the thing that something is next to, the two that it is between, the
corner that it is in. A definition answers with what the concept holds of, indices of things or masks of sets; it raises
`Unread` or `NotAnnotatable` where it leaves that open. Another part of the program that comes to define a concept, or
one that goes, changes `CONCEPTS` and nothing else.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import combinations
from typing import Any

import numpy as np

from grounding.corpus.base_phrases import BasePhrases
from grounding.corpus.meaning import Meaning, NotAnnotatable
from grounding.corpus.narrowing import Narrowing
from grounding.corpus.prepositions import Prepositions
from grounding.corpus.selector import Selector
from grounding.corpus.treebank import LaidWorld
from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of, mask_of
from grounding.language.tree import from_brackets
from grounding.lexicon import alone, arrangement, between, direction, nearness, place, rank
from grounding.lexicon.person import distance_from
from grounding.lexicon.where import Where
from grounding.literal import choosing
from grounding.literal.reader import LiteralReader
from grounding.literal.relations import region_of
from grounding.literal.values import Meant, Missing, Unread
from grounding.meaning.nouns import Noun
from grounding.symbols import Region
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene

HOLDS = 0.5  # a concept of the lexicon holds of what is truer, if no other threshold is asked for
OPEN = (Unread, NotAnnotatable)  # raised by a definition that leaves open what it holds of
PARTS = ("gamma", "lexicon", "literal", "annotator")
"""The parts of the program that define concepts: the regions and shapes of Γ, which the factors' features use; the
lexicon, by which is answered; the literal readings; the annotation of generated texts."""

_PHRASE = from_brackets("(NP (NN block))")[0]  # for messages only
_SIDES = ("left", "right", "front", "back")
_CORNERS = (("front", "left"), ("front", "right"), ("back", "left"), ("back", "right"))

Held = frozenset[int]
Definition = Callable[["Seen", Any], Held]


class Seen:
    """One world, as every part of the program looks at it.

    Args:
        laid: the world.
        threshold: the lexicon's concepts hold of what is truer.
    """

    def __init__(self, laid: LaidWorld, threshold: float = HOLDS) -> None:
        self.laid = laid
        self.threshold = threshold
        self.layout: Layout = laid.layout
        self.scene = Scene(laid.layout)
        self.everything = laid.layout.everything
        self.all: Array = np.ones(laid.layout.size)

    @cached_property
    def where(self) -> Where:
        """The things as places of which concepts hold."""
        return Where.objects(self.scene)

    @cached_property
    def literal(self) -> LiteralReader:
        """The literal reader."""
        return LiteralReader(self.scene)

    @cached_property
    def selector(self) -> Selector:
        """The annotator's selections."""
        return Selector(self.layout)

    def only(self, index: int) -> Array:
        """Weights of one thing, shape (n,)."""
        return np.eye(self.layout.size)[index]


@dataclass(frozen=True)
class Concept:
    """A concept and its definitions.

    Attributes:
        references: what it is asked for, in a world.
        definitions: by the names of the parts of the program, see `PARTS`.
    """

    references: Callable[[Seen], Iterable[Hashable]]
    definitions: Mapping[str, Definition]

    def held(self, part: str, seen: Seen, reference: Hashable) -> Held | None:
        """What the concept holds of by one definition; None where that is left open."""
        try:
            return self.definitions[part](seen, reference)
        except OPEN:
            return None


def _bits(mask: int) -> Held:
    return frozenset(indices_of(mask))


def _above(seen: Seen, weights: Array) -> Held:
    return frozenset(np.flatnonzero(weights > seen.threshold).tolist())


def _once(seen: Seen) -> Iterable[Hashable]:
    return (None,)


def _things(seen: Seen) -> Iterable[Hashable]:
    return range(seen.layout.size)


def _pairs(seen: Seen) -> Iterable[Hashable]:
    return combinations(range(seen.layout.size), 2)


# -- relations to a thing, or to two ----------------------------------------------------------------------------------


def _members(reference: int | tuple[int, int]) -> tuple[int, ...]:
    return reference if isinstance(reference, tuple) else (reference,)


def _region(relation: str, seen: Seen, reference: int | tuple[int, int]) -> Held:
    names = tuple(seen.layout.ids[i] for i in _members(reference))
    return _bits(seen.layout.within(Region(relation, "object", names)))


def _read(relation: str, seen: Seen, reference: int | tuple[int, int]) -> Held:
    members = _members(reference)
    mask = sum(1 << i for i in members)
    meant = Meant("things", mask, mask) if len(members) == 1 else Meant("things", mask, mask, "group", True, 2)
    return _bits(region_of(seen.literal, meant, relation, None).mask & ~mask)


def _annotated(relation: str, seen: Seen, reference: int | tuple[int, int]) -> Held:
    members = _members(reference)
    mask = sum(1 << i for i in members)
    names = seen.layout.names(mask)
    if len(members) == 1:
        child = Meaning("one", pool=mask, chosen=mask, reference=names)
    else:
        child = Meaning("many", number=2, definite=True, pool=mask, chosen=mask, reference=names,
                        reference_kind="group")  # fmt: skip
    found = Prepositions(seen.selector).region(_PHRASE, child, relation, relation)
    return _bits(Narrowing(seen.selector, seen.laid.arrangements).within(found) & ~mask)


def _near(reach: str, seen: Seen, reference: int) -> Held:
    return _above(seen, nearness.truth(seen.where.gaps, seen.scene.edge, reach)[:, reference]) - {reference}


def _toward(name: str, seen: Seen, reference: int) -> Held:
    vector = direction.unit(seen.scene, (name,), ROBOT)
    assert vector is not None
    held = direction.truth(seen.where, seen.scene.xy, seen.scene.edge, vector, strict=False)[:, reference]
    return _above(seen, held) - {reference}


def _between(seen: Seen, reference: tuple[int, int]) -> Held:
    parts = [between.Part(seen.only(i), 1) for i in reference]
    return _above(seen, between.amid(seen.where, seen.scene, parts, surrounding=False)) - set(reference)


def _relation(name: str, lexicon: Definition, gamma: str | None = None) -> Concept:
    return Concept(_pairs if name == "between" else _things, {
        "gamma": partial(_region, gamma or name), "lexicon": lexicon,
        "literal": partial(_read, name), "annotator": partial(_annotated, name),
    })  # fmt: skip


# -- things that are singled out --------------------------------------------------------------------------------------


def _noun(noun: Noun, seen: Seen, reference: object) -> Held:
    return _bits(seen.literal.meant(noun).chosen)


def _first(sign: float, seen: Seen, reference: object) -> Held:
    key = -sign * distance_from(seen.scene, ROBOT)
    return _above(seen, rank.truth(seen.all, key, 1, rank.blur(seen.scene)))


def _extreme(name: str) -> Concept:
    noun = Noun(head="block", distance=name, text=f"the {name}est block")
    return Concept(_once, {
        "gamma": lambda seen, _: _bits(seen.layout.nth(seen.everything, name, 1)),
        "lexicon": partial(_first, 1.0 if name == "near" else -1.0), "literal": partial(_noun, noun),
        "annotator": lambda seen, _: _bits(seen.selector.rank(_PHRASE, seen.everything, name, 1, "")),
    })  # fmt: skip


_MIDDLE = Noun(head="block", middle=True, text="the middle block")


def _corner_noun(seen: Seen, names: tuple[str, str]) -> Held:
    return _noun(Noun(head="block", directions=names, text=f"the {names[0]} {names[1]} block"), seen, names)


def _placed(corner: bool, seen: Seen, names: str | tuple[str, ...]) -> Held:
    spot = place.make_spot(seen.scene, (names,) if isinstance(names, str) else names, ROBOT, corner=corner)
    return _above(seen, place.truth(seen.scene, spot))


# -- arrangements -----------------------------------------------------------------------------------------------------


def _arranged(kind: str, seen: Seen, reference: object) -> Held:
    found = arrangement.candidates(seen.scene, (kind,), seen.all > 0)
    if not found:
        return frozenset()
    held = np.array([c.looks for c in found]) * np.exp(arrangement.overshadowed(found))
    kept = (c for c, how in zip(found, held, strict=True) if how > seen.threshold)
    return frozenset(mask_of(np.flatnonzero(c.mask)) for c in kept)


def _read_arrangement(kind: str, seen: Seen, reference: object) -> Held:
    try:
        meant = seen.literal.meant(Noun(head="container", kinds=(kind,), text=f"the {kind}"))
    except Missing:
        return frozenset()
    return frozenset(mask for _, mask in meant.sets)


def _arrangement(kind: str) -> Concept:
    return Concept(_once, {
        "gamma": lambda seen, _: frozenset(a.mask for a in seen.layout.evident_of((kind,), seen.everything)),
        "lexicon": partial(_arranged, kind), "literal": partial(_read_arrangement, kind),
        "annotator": lambda seen, _: frozenset(
            mask for _, mask in BasePhrases(seen.selector, seen.laid.arrangements).of_kinds((kind,), seen.everything)
        ),
    })  # fmt: skip


CONCEPTS: Mapping[str, Concept] = {
    "next to": _relation("near", partial(_near, nearness.BESIDE)),
    "touching": _relation("touching", partial(_near, nearness.TOUCHING), gamma="near"),  # Γ has no contact, but near
    "left of": _relation("left", partial(_toward, "left")),
    "right of": _relation("right", partial(_toward, "right")),
    "in front of": _relation("front", partial(_toward, "front")),
    "behind": _relation("back", partial(_toward, "back")),
    "between": _relation("between", _between),
    "nearest": _extreme("near"),
    "farthest": _extreme("far"),
    "row": _arrangement("row"),
    "column": _arrangement("column"),
    "group": _arrangement("group"),
    "circle": _arrangement("circle"),
    "tower": _arrangement("tower"),
    "alone": Concept(_once, {
        "lexicon": lambda seen, _: _above(seen, alone.truth(seen.scene, seen.all, counted=False)),
        "literal": lambda seen, _: _bits(choosing.alone(seen.scene, seen.everything)),
        "annotator": lambda seen, _: _bits(seen.selector.alone(_PHRASE, seen.everything)),
    }),
    "middle": Concept(_once, {
        "gamma": lambda seen, _: _bits(seen.layout.central(seen.everything)),
        "lexicon": lambda seen, _: _above(seen, rank.middle(seen.scene, seen.all, chosen=False)),
        "literal": partial(_noun, _MIDDLE),
        "annotator": lambda seen, _: _bits(seen.selector.rank(_PHRASE, seen.everything, "center", 1, "")),
    }),
    "corner": Concept(lambda seen: _CORNERS, {  # two spatial references in Γ
        "gamma": lambda seen, names: _bits((seen.layout.side(names[0]) or 0) & (seen.layout.side(names[1]) or 0)),
        "lexicon": partial(_placed, True), "literal": _corner_noun,
        "annotator": lambda seen, names: _bits(
            seen.selector.choose(_PHRASE, seen.everything, Meaning("one", corner=names))
        ),
    }),
    "side": Concept(lambda seen: _SIDES, {
        "gamma": lambda seen, name: _bits(seen.layout.side(name) or 0),
        "lexicon": partial(_placed, False),
        "literal": lambda seen, name: _bits(choosing.half(seen.scene, seen.everything, name)),
        "annotator": lambda seen, name: _bits(seen.selector.half(_PHRASE, seen.everything, name, clear=True)),
    }),
}  # fmt: skip
