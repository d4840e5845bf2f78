"""Annotates base noun phrases: those that hold words only ("the second closest red block", "the left", "five")."""

from __future__ import annotations

from dataclasses import dataclass, field

from grounding.corpus.meaning import Meaning, NotAnnotatable
from grounding.geometry.layout import UPRIGHT, Layout
from grounding.geometry.masks import indices_of, single
from grounding.language.lexicon import is_plural, is_universal, meanings, size_order
from grounding.language.tree import Phrase
from grounding.symbols import (
    LAST,
    Cardinal,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    ObjectColor,
    ObjectSymbol,
    ObjectType,
    Ordinal,
    SpatialReference,
    Symbol,
)

_PLACE_NOUNS = ("side", "end", "edge", "half")
UNKNOWN_NOUNS = frozenset(
    "ball balls cup cups bottle bottles pen pens spoon mug hammer apple apples banana sponge toy coin book key shoe "
    "phone plate glass lamp hat sock marble marbles song".split()
)
_LYING = {"horizontal": ("row",), "vertical": ("column", "tower"), "straight": ("row", "column")}
_IGNORED = ("of", "very", "only", "whole", "entire")


@dataclass
class _Words:
    """The words of a base noun phrase, sorted by what they say."""

    types: list[str] = field(default_factory=list)
    colors: list[str] = field(default_factory=list)
    relations: list[str] = field(default_factory=list)
    indices: list[int] = field(default_factory=list)
    numbers: list[int] = field(default_factory=list)
    kinds: tuple[str, ...] = ()
    place: bool = False
    plural: bool = False
    universal: bool = False
    definite: bool = False
    only: bool = False
    robot: bool = False
    unknown: bool = False
    lying: str = ""
    several: bool = False
    size: int = 0


def annotate_base(phrase: Phrase, layout: Layout, arrangements: tuple[tuple[str, int], ...]) -> Meaning:
    """Ground a noun phrase without child phrases.

    Raises:
        NotAnnotatable: a word or combination that is not covered.
    """
    if [word.text for word in phrase.words] == ["i"]:
        return Meaning("empty")
    said = _sort_words(phrase)
    if said.robot:
        return Meaning("robot", frozenset({Container("robot")}))
    if said.unknown:
        return Meaning("nothing", frozenset(_labels(said)))
    if "table" in said.types:
        tables = [item.id for item in layout.world.objects if item.type == "table"]
        if len(tables) != 1 or said.relations or said.colors:
            raise NotAnnotatable(f"NP {phrase.text!r}: which table?")
        of_table: set[Symbol] = {ObjectSymbol(tables[0]), ObjectType("table")}
        return Meaning("table", frozenset(of_table), reference=tuple(tables))
    if len(said.relations) == 2 and "far" in said.relations:
        said.relations.remove("far")  # "the far left" is the left, far out
    if len(said.relations) > 1 or len(said.colors) > 1 or len(said.numbers) > 1 or len(said.indices) > 1:
        raise NotAnnotatable(f"NP {phrase.text!r}: two words for the same thing")
    if said.kinds:
        return _container(phrase, said, layout, arrangements)
    if said.place or not (said.types or said.numbers or said.plural or said.universal):
        if len(said.relations) != 1 or said.colors or said.numbers or said.indices:
            raise NotAnnotatable(f"NP {phrase.text!r}: no direction and no thing")
        relation = said.relations[0]
        return Meaning("direction", frozenset({SpatialReference(relation)}), relation=relation)
    if said.plural or said.numbers or said.universal:
        return _many(phrase, said, layout)
    return _one(phrase, said, layout)


def _sort_words(phrase: Phrase) -> _Words:
    said = _Words()
    words = phrase.words
    for place, word in enumerate(words):
        text, head = word.text, place == len(words) - 1
        symbols = meanings(text)
        if is_universal(text) or word.tag in ("DT", "PDT", "PRP$") or text in ("most", *_IGNORED):
            if text in ("my", "another", "other", "some", "any", "its", "their"):
                raise NotAnnotatable(f"NP {phrase.text!r}: {text!r} is not covered")
            if text in ("a", "an") and any(Cardinal in map(type, meanings(w.text)) for w in words):
                continue
            said.universal |= is_universal(text)
            said.definite |= text in ("the", "that", "this", "these", "those") or is_universal(text)
            said.only |= text == "only"
            if text == "everything":
                said.plural = True
            elif text == "both":
                said.numbers.append(2)
            continue
        if text in _LYING:
            said.lying = text
            continue
        if size_order(text):
            said.size = size_order(text)
            continue
        if text == "one" and head and len(words) > 1:
            said.types.append("block")
            continue
        said.plural |= head and is_plural(word.tag)
        if head and text in _PLACE_NOUNS:
            said.place = True
            continue
        _sort_symbols(phrase, said, text, word.tag, symbols)
    return said


def _sort_symbols(phrase: Phrase, said: _Words, text: str, tag: str, symbols: frozenset[Symbol]) -> None:
    kinds = sorted(s.kind for s in symbols if isinstance(s, Container))
    if kinds == ["robot"]:
        said.robot = True
        return
    if kinds:
        said.several = is_plural(tag)
        said.kinds = tuple(kinds)
        said.numbers += [s.value for s in symbols if isinstance(s, Cardinal)]
        return
    relations = sorted(s.name for s in symbols if isinstance(s, SpatialReference))
    if relations:
        said.relations.append("top" if "top" in relations else "bottom" if "bottom" in relations else relations[0])
        return
    for symbol in symbols:
        match symbol:
            case ObjectType(name):
                said.types.append(name)
                return
            case ObjectColor(name):
                said.colors.append(name)
                return
            case Ordinal(value):
                said.indices.append(value)
                return
            case Cardinal(value):
                said.numbers.append(value)
                return
    if tag in ("NN", "NNS") and not symbols and text in UNKNOWN_NOUNS:
        said.unknown = True
        return
    raise NotAnnotatable(f"NP {phrase.text!r}: {text!r} is not covered")


def _labels(said: _Words) -> set[Symbol]:
    symbols: set[Symbol] = {ObjectType(name) for name in said.types}
    symbols |= {ObjectColor(name) for name in said.colors}
    symbols |= {SpatialReference(name) for name in said.relations}
    symbols |= {Ordinal(value) for value in said.indices}
    symbols |= {Cardinal(value) for value in said.numbers}
    return symbols


def _one(phrase: Phrase, said: _Words, layout: Layout) -> Meaning:
    object_type = said.types[0]
    color = said.colors[0] if said.colors else None
    relation = said.relations[0] if said.relations else None
    index = said.indices[0] if said.indices else None
    if index == LAST and relation is None:
        raise NotAnnotatable(f"NP {phrase.text!r}: 'last' without a direction is not covered")
    pool = layout.matching(object_type, color)
    if said.only and not single(pool):
        raise NotAnnotatable(f"NP {phrase.text!r}: not the only one")
    chosen, unclear = 0, False
    if relation is not None:
        ranked = relation if layout.stacked(pool) else UPRIGHT.get(relation, relation)
        chosen = layout.nth(pool, ranked, index or 1)
        extent = sorted(layout.extent(pool, ranked), reverse=True)
        place = (index or 1) - 1
        pairs = [(a, a + 1) for a in (place - 1, place) if a >= 0 and a + 1 < len(extent)]
        if chosen and any(extent[a] - extent[b] < 0.01 for a, b in pairs):
            unclear = ranked not in UPRIGHT
            chosen = chosen if unclear else 0  # the top of which tower is decided above
    elif index is None and single(pool):
        chosen = pool
    symbols = _labels(said)
    symbols.add(ObjectAttribute(object_type, color, relation, index or (1 if relation else None)))
    symbols |= {ObjectSymbol(name) for name in layout.names(chosen)}
    return Meaning("one", frozenset(symbols), object_type, color, relation, index, pool=pool, chosen=chosen,
                   reference=layout.names(chosen), unclear=unclear)  # fmt: skip


def _many(phrase: Phrase, said: _Words, layout: Layout) -> Meaning:
    object_type = said.types[0] if said.types else None
    color = said.colors[0] if said.colors else None
    relation = said.relations[0] if said.relations else None
    number = said.numbers[0] if said.numbers else None
    if said.indices and said.indices[0] != 1:
        raise NotAnnotatable(f"NP {phrase.text!r}: an ordinal of several blocks is not covered")
    pool = layout.matching(object_type, color)
    if object_type is None and number is None and not said.universal:
        raise NotAnnotatable(f"NP {phrase.text!r}: no noun")
    chosen = 0
    if relation in ("top", "bottom"):
        raise NotAnnotatable(f"NP {phrase.text!r}: top and bottom of several blocks are not covered")
    if relation is not None and number is not None:
        chosen = layout.extreme(pool, relation, number)
        extent = sorted(layout.extent(pool, relation), reverse=True)
        if chosen and number < len(extent) and extent[number - 1] - extent[number] < 0.01:
            raise NotAnnotatable(f"NP {phrase.text!r}: too close to call")
    elif relation is not None:
        raise NotAnnotatable(f"NP {phrase.text!r}: how many?")
    elif number is not None:
        chosen = pool if pool.bit_count() == number and object_type is not None else 0
    elif said.definite:
        chosen = pool
    symbols = _labels(said)
    symbols.add(ContainerAttribute(object_type, color, relation, number))
    if chosen:
        symbols |= set() if single(chosen) else {Container("group", layout.names(chosen))}
        symbols |= {ObjectSymbol(name) for name in layout.names(chosen)}
    return Meaning("many", frozenset(symbols), object_type, color, relation, None, number, said.definite, pool, chosen,
                   reference=layout.names(chosen), reference_kind="group")  # fmt: skip


def _container(phrase: Phrase, said: _Words, layout: Layout, arrangements: tuple[tuple[str, int], ...]) -> Meaning:
    if said.lying:
        said.kinds = tuple(kind for kind in said.kinds if kind in _LYING[said.lying])
    if said.types or not said.kinds or (said.indices and not said.relations):
        raise NotAnnotatable(f"NP {phrase.text!r}: construction not covered")
    relation = said.relations[0] if said.relations else None
    relation = UPRIGHT.get(relation or "", relation)
    color = said.colors[0] if said.colors else None
    number = said.numbers[0] if said.numbers else None
    wanted = layout.matching(None, color)
    found = [a for a in arrangements if a[0] in said.kinds and not a[1] & ~wanted]
    if number is not None:
        found = [a for a in found if a[1].bit_count() == number]
    symbols = _labels(said)
    symbols |= {Container(kind) for kind in said.kinds}
    chosen = None
    if said.several:
        return _containers(phrase, said, layout, arrangements)
    if len(found) == 1:
        chosen = found[0]
    elif found and relation:
        middle = {kind_mask: _reach(layout, kind_mask[1], relation) for kind_mask in found}
        order = sorted(found, key=lambda a: -middle[a])
        place = (said.indices[0] if said.indices else 1) - 1
        if place >= len(order):
            raise NotAnnotatable(f"NP {phrase.text!r}: there are not so many")
        for a, b in ((place - 1, place), (place, place + 1)):
            if 0 <= a and b < len(order) and middle[order[a]] - middle[order[b]] < 0.05:
                raise NotAnnotatable(f"NP {phrase.text!r}: too close to call")
        chosen = order[place]
    elif found and said.size:
        order = sorted(found, key=lambda a: -said.size * a[1].bit_count())
        if order[0][1].bit_count() == order[1][1].bit_count():
            raise NotAnnotatable(f"NP {phrase.text!r}: equally large")
        chosen = order[0]
    mask = 0
    if chosen is not None:
        mask = chosen[1]
        symbols.add(Container(chosen[0], layout.names(mask)))
        symbols |= {ObjectSymbol(name) for name in layout.names(mask)}
    return Meaning(
        "container", frozenset(symbols), None, color, relation, said.indices[0] if said.indices else None, number,
        said.definite, mask, mask, said.kinds, (chosen,) if chosen else tuple(found), layout.names(mask),
        chosen[0] if chosen else "group", size=said.size,
    )  # fmt: skip


def _containers(phrase: Phrase, said: _Words, layout: Layout, arrangements: tuple[tuple[str, int], ...]) -> Meaning:
    """Several containers, all of their kind: "the two rows"."""
    found = [a for a in arrangements if a[0] in said.kinds]
    number = said.numbers[0] if said.numbers else None
    if said.relations or said.colors or len(said.kinds) > 1 or len(found) < 2 or number not in (None, len(found)):
        raise NotAnnotatable(f"NP {phrase.text!r}: not all containers of a kind")
    mask = 0
    for _, members in found:
        if mask & members:
            raise NotAnnotatable(f"NP {phrase.text!r}: they share members")
        mask |= members
    symbols = _labels(said) | {Container(kind) for kind in said.kinds}
    symbols |= {Container(kind, layout.names(members)) for kind, members in found}
    symbols |= {ObjectSymbol(name) for name in layout.names(mask)}
    return Meaning("many", frozenset(symbols), pool=mask, chosen=mask, number=len(found), definite=True,
                   reference=layout.names(mask), reference_kind=said.kinds[0])  # fmt: skip


def _reach(layout: Layout, mask: int, direction: str) -> float:
    if direction == "center":
        centre = layout.positions[:, :2].mean(axis=0)
        middle = layout.positions[list(indices_of(mask)), :2].mean(axis=0)
        return -float(((middle - centre) ** 2).sum() ** 0.5)
    return float(layout.extent(mask, direction).mean())
