"""Annotates a gold tree phrase by phrase in a world whose arrangements are known.

This is how the treebank and generated corpora get their groundings: by the meaning that the sentence was written with,
in a world of which we know how it was laid out. It refuses what is not clear there: a row that is not the only one, a
nearest block by less than `MARGIN`. Inference never uses it: models learn from what it wrote.

The conventions follow the annotators of the paper's corpus where those are consistent: "the row" is a kind until
something makes it one row; "third block" is an attribute until a direction and a set make it one block; "in NP", "of
NP" pass on what their noun phrase means.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from grounding.corpus.base_phrases import UPRIGHT, annotate_base
from grounding.corpus.meaning import Meaning, NotAnnotatable
from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of, single
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.symbols import (
    LAST,
    Action,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    ObjectSymbol,
    Ordinal,
    Region,
    SpatialReference,
    Symbol,
)

MARGIN = 0.01  # an extreme object is so much more extreme than the next one [m]
MOST_REFERENCES = 8  # so many objects a reference may leave possible
_COPYING = ("in", "of", "from", "on", "at", "to", "off", "with")
_RELATIONS = {
    "behind": "back", "above": "top", "over": "top", "below": "bottom", "under": "bottom", "beneath": "bottom",
    "near": "near", "beside": "near", "by": "near", "next to": "near", "close to": "near", "between": "between",
    "left of": "left", "right of": "right", "on": "top", "onto": "top", "upon": "top", "in front of": "front",
}  # fmt: skip


def annotate(
    tree: Phrase, layout: Layout, arrangements: Sequence[tuple[str, int]]
) -> tuple[tuple[frozenset[Symbol], ...], str]:
    """Ground every phrase of a gold tree.

    Args:
        tree: the gold parse.
        layout: the world, measured.
        arrangements: the rows, columns, groups, circles and towers that are there, as (kind, mask).

    Returns:
        the symbols of every phrase, in preorder, and the outcome: "grounded", "ambiguous" or "no_referent".

    Raises:
        NotAnnotatable: the sentence is not true, not clear or not covered here.
    """
    annotator = _Annotator(layout, tuple(arrangements))
    root = annotator.phrase(tree)
    groundings = tuple(annotator.symbols[id(phrase)] for phrase in tree.preorder())
    return groundings, annotator.outcome(root)


class _Annotator:
    def __init__(self, layout: Layout, arrangements: tuple[tuple[str, int], ...]) -> None:
        self.layout = layout
        self.arrangements = arrangements
        self.symbols: dict[int, frozenset[Symbol]] = {}

    def phrase(self, phrase: Phrase) -> Meaning:
        children = [self.phrase(child) for child in phrase.phrases]
        meaning = self._compose(phrase, children)
        self.symbols[id(phrase)] = meaning.symbols
        return meaning

    def outcome(self, root: Meaning) -> str:
        if root.sort == "action":
            actions = sum(isinstance(symbol, Action) and bool(symbol.objects) for symbol in root.symbols)
            return "grounded" if actions == 1 else "ambiguous" if actions else "no_referent"
        if root.sort in ("one", "many", "container"):
            if root.chosen:
                return "grounded"
            return "ambiguous" if root.pool or root.arrangements else "no_referent"
        return "no_referent" if root.sort == "nothing" else "grounded"

    def _compose(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        if phrase.tag in ("PRT", "WHNP", "ADVP", "INTJ"):
            return Meaning("empty")
        if phrase.tag == "NP":
            if not children:
                return annotate_base(phrase, self.layout, self.arrangements)
            return self._noun_phrase(phrase, children)
        if phrase.tag == "PP":
            return self._prepositional(phrase, children)
        if phrase.tag == "VP":
            return self._verb_phrase(phrase, children)
        if phrase.tag in ("S", "SBAR"):
            told = [child for child in children if child.sort != "empty"]
            said = [child for child in told if child.sort in ("action", "region", "direction")] or told
            if len(said) == 1:
                return replace(said[0], symbols=_passed(said[0]))
        raise NotAnnotatable(f"{phrase.tag} {phrase.text!r}: construction not covered")

    # Noun phrases

    def _noun_phrase(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        if phrase.words:
            if [word.text for word in phrase.words] == ["and"] and len(children) == 2:
                return self._both(phrase, children)
            raise NotAnnotatable(f"NP {phrase.text!r}: construction not covered")
        if len(children) != 2:
            raise NotAnnotatable(f"NP {phrase.text!r}: construction not covered")
        head, modifier = children
        if "nothing" in (head.sort, modifier.sort) or _is_empty(modifier):
            return Meaning("nothing")
        if head.sort == "one":
            return self._one(phrase, head, modifier)
        if head.sort == "many":
            return self._many(phrase, head, modifier)
        if head.sort == "container":
            return self._container(phrase, head, modifier)
        if head.sort == "direction":
            return self._place(phrase, head, modifier)
        if head.sort == "table" and modifier.sort == "region":
            return replace(modifier, symbols=_passed(modifier), preposition="")
        raise NotAnnotatable(f"NP {phrase.text!r}: a {head.sort} with a {modifier.sort} is not covered")

    def _both(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        chosen = 0
        for child in children:
            if not child.chosen or child.sort not in ("one", "container"):
                raise NotAnnotatable(f"NP {phrase.text!r}: parts of 'and' are not determined")
            if child.chosen & chosen:
                raise NotAnnotatable(f"NP {phrase.text!r}: parts of 'and' overlap")
            chosen |= child.chosen
        symbols = frozenset().union(*(_passed(child) for child in children))
        return Meaning("many", symbols, pool=chosen, chosen=chosen, reference=self.layout.names(chosen),
                       definite=True, number=len(children))  # fmt: skip

    def _one(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        layout, pool, relation, index = self.layout, head.pool, head.relation, head.index
        kind = modifier.reference_kind
        carried: frozenset[Symbol] = frozenset()
        nearest_to: tuple[str, ...] = ()
        member = False
        if modifier.sort == "direction":
            index = modifier.index or index
            said = modifier.relation
            if said is None:
                raise NotAnnotatable(f"{phrase.text!r}: no direction")
            if relation in (None, said) or (relation in ("near", "far") and modifier.preposition == "to"):
                relation = said
            elif modifier.preposition in ("on", "at", "in"):
                pool = self._half(phrase, pool, said)
            else:
                raise NotAnnotatable(f"{phrase.text!r}: two directions")
        elif modifier.sort == "robot":
            if relation not in ("near", "far"):
                raise NotAnnotatable(f"{phrase.text!r}: what about the robot?")
        elif modifier.sort in ("container", "many", "one"):
            if not modifier.chosen:
                raise NotAnnotatable(f"{phrase.text!r}: {modifier.sort} is not determined")
            if relation in ("near", "far") and modifier.preposition in ("to", "from"):
                if relation == "far":
                    raise NotAnnotatable(f"{phrase.text!r}: far from a thing is not covered")
                nearest_to, relation = modifier.reference, None
            else:
                pool &= modifier.chosen
                carried = frozenset(s for s in modifier.symbols if isinstance(s, Container))
        elif modifier.sort == "region" and modifier.region is not None:
            if modifier.region.relation == "near" and "closest" in modifier.preposition.split():
                nearest_to = modifier.region.objects
            elif relation is None and index is None and _means_member(modifier):
                pool &= layout.mask(modifier.region.objects)
                relation, kind = modifier.region.relation, modifier.region.kind
                member = True
            elif modifier.region.kind != "robot":
                pool &= layout.within(modifier.region)
            carried = frozenset({modifier.region})
        elif modifier.sort == "table":
            pass
        else:
            raise NotAnnotatable(f"{phrase.text!r}: a {modifier.sort} says nothing of a block")
        ranked = relation or ""
        if kind != "tower" and not layout.stacked(pool):
            ranked = UPRIGHT.get(ranked, ranked)
        crowded = modifier.sort == "region" and modifier.region is not None and not member and pool.bit_count() > 1
        if crowded and relation is None and index is None and modifier.region is not None:
            chosen = self._first_met(pool, modifier.region)
        elif nearest_to:
            chosen = self._closest(phrase, pool & ~layout.mask(nearest_to), nearest_to)
        elif relation == "center" and modifier.sort == "direction":
            chosen = layout.central(pool)
        elif relation is not None:
            chosen = self._rank(phrase, pool, ranked, index or 1, kind if modifier.chosen or member else "")
        else:
            chosen = pool if single(pool) and index is None else 0
        said_relation = head.relation if member else relation
        attribute = ObjectAttribute(
            head.object_type, head.color, said_relation, index or (1 if said_relation else None)
        )
        found = self._objects(chosen)
        if modifier.sort in ("direction", "robot"):
            symbols = found | {attribute}
        else:
            symbols = found if chosen else carried | {attribute}
        return replace(head, symbols=symbols, relation=relation, index=index, pool=pool, chosen=chosen,
                       reference=layout.names(chosen), reference_kind="object")  # fmt: skip

    def _many(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        layout, pool, number, relation = self.layout, head.pool, head.number, head.relation
        kind = "group"
        chosen = 0
        if modifier.sort == "direction" and modifier.relation:
            chosen, kind = self._many_at(phrase, head, modifier.relation)
        elif modifier.sort == "robot":
            chosen = head.chosen
        elif modifier.sort in ("container", "many"):
            if not modifier.chosen:
                cands = [a for a in modifier.arrangements if number in (None, a[1].bit_count()) and not a[1] & ~pool]
                if modifier.sort != "container" or len(cands) != 1:
                    raise NotAnnotatable(f"{phrase.text!r}: {modifier.sort} is not determined")
                (kind, chosen), pool = cands[0], cands[0][1]
            else:
                pool &= modifier.chosen
                chosen = self._count(phrase, pool, number, relation)
                if chosen == modifier.chosen and modifier.reference_kind != "object":
                    kind = modifier.reference_kind
        elif modifier.sort == "region" and modifier.region is not None:
            if modifier.region.kind != "robot":
                pool &= layout.within(modifier.region)
            chosen = self._count(phrase, pool, number, relation)
        elif modifier.sort == "table":
            chosen = self._count(phrase, pool, number, relation)
        else:
            raise NotAnnotatable(f"{phrase.text!r}: a {modifier.sort} says nothing of blocks")
        attribute = ContainerAttribute(head.object_type, head.color, relation, number)
        symbols: frozenset[Symbol]
        symbols = self._contained(kind, chosen) if chosen else frozenset({attribute})
        return replace(head, symbols=symbols, pool=pool, chosen=chosen, reference=layout.names(chosen),
                       reference_kind=kind)  # fmt: skip

    def _many_at(self, phrase: Phrase, head: Meaning, direction: str) -> tuple[int, str]:
        if head.relation is not None:
            return self._count(phrase, self._half(phrase, head.pool, direction), head.number, head.relation), "group"
        if head.number is None:
            return self._half(phrase, head.pool, direction, clear=True), "group"
        fitting = [a for a in self.arrangements if a[1].bit_count() == head.number and not a[1] & ~head.pool]
        if fitting:
            best = self._extreme_arrangement(phrase, fitting, direction, 1)
            if self.layout.extent(best[1], direction).mean() > self._middle(direction):
                return best[1], best[0]
        return self._count(phrase, head.pool, head.number, direction), "group"

    def _container(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        cands = list(head.arrangements)
        carried: set[Symbol] = {s for s in head.symbols if isinstance(s, Container) and not s.objects}
        number, relation = head.number, head.relation
        if modifier.sort == "many":
            pool = modifier.pool if not modifier.chosen else modifier.chosen
            number = modifier.number or number
            wanted = self.layout.matching(modifier.object_type, modifier.color)
            if modifier.chosen and any(a[1] == modifier.chosen for a in cands):
                cands = [a for a in cands if a[1] == modifier.chosen]
            else:
                cands = [a for a in cands if not a[1] & ~(wanted if not modifier.chosen else pool | wanted)]
                if number:
                    cands = [a for a in cands if a[1].bit_count() == number]
            carried |= {s for s in modifier.symbols if isinstance(s, ContainerAttribute)}
        elif modifier.sort == "direction" and modifier.relation:
            relation = modifier.relation
        elif modifier.sort == "region" and modifier.region is not None:
            if "closest" in modifier.preposition.split():
                raise NotAnnotatable(f"{phrase.text!r}: not covered")
            if modifier.region.kind != "robot":
                inside = self.layout.within(modifier.region)
                cands = [a for a in cands if not a[1] & ~inside]
            carried |= {modifier.region}
        elif modifier.sort == "robot":
            if head.relation not in ("near", "far"):
                raise NotAnnotatable(f"{phrase.text!r}: not covered")
        elif modifier.sort != "table":
            raise NotAnnotatable(f"{phrase.text!r}: a container with a {modifier.sort} is not covered")
        chosen = None
        if len(cands) == 1:
            chosen = cands[0]
        elif cands and relation:
            chosen = self._extreme_arrangement(phrase, cands, relation, head.index or 1)
        elif cands and head.size:
            chosen = self._largest(phrase, cands, head.size)
        if chosen is None:
            return replace(head, symbols=frozenset(carried), arrangements=tuple(cands), number=number, chosen=0)
        return replace(head, symbols=self._contained(*chosen), arrangements=(chosen,), number=number,
                       chosen=chosen[1], pool=chosen[1], reference=self.layout.names(chosen[1]),
                       reference_kind=chosen[0])  # fmt: skip

    def _place(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        if modifier.sort == "robot":
            region = Region(str(head.relation), "robot", ())
        elif modifier.sort == "one" and not modifier.reference and 0 < modifier.pool.bit_count() <= MOST_REFERENCES:
            region = Region(str(head.relation), "object", self.layout.names(modifier.pool))
        elif modifier.sort in ("table", "one", "container", "many") and modifier.reference:
            region = Region(str(head.relation), modifier.reference_kind, modifier.reference)
        else:
            raise NotAnnotatable(f"{phrase.text!r}: a place needs something that is determined")
        return Meaning("region", frozenset({region}), region=region, relation=head.relation)

    # Prepositional phrases

    def _prepositional(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        words = [word.text for word in phrase.words if word.text not in ("directly", "right", "just", "away", "very")]
        if phrase.words and phrase.words[0].text == "right" and "of" in words:
            words = ["right", *words]
        if len(children) != 1:
            raise NotAnnotatable(f"PP {phrase.text!r}: construction not covered")
        child, preposition = children[0], " ".join(words)
        ordinals = [s for word in words for s in meanings(word) if isinstance(s, Ordinal)]
        if ordinals and words[-1] == "from" and child.sort == "direction":
            return replace(child, symbols=child.symbols | {ordinals[0]}, index=ordinals[0].value, preposition="from")
        if words and words[0] in ("closest", "nearest", "farthest", "furthest"):
            far = words[0].startswith("f")
            if child.sort == "robot":
                name = "far" if far else "near"
                return Meaning("direction", frozenset({SpatialReference(name)}), relation=name, preposition="closest")
            if not far and child.reference:
                region = Region("near", child.reference_kind, child.reference)
                return Meaning("region", frozenset({region}), region=region, preposition="closest to")
            raise NotAnnotatable(f"PP {phrase.text!r}: construction not covered")
        stands_on = preposition in ("on", "onto", "upon") and child.sort in ("one", "table", "container", "many")
        if child.sort == "nothing" or (_is_empty(child) and preposition not in _COPYING):
            return replace(child, preposition=preposition) if preposition in _COPYING else Meaning("nothing")
        if preposition in _RELATIONS and (stands_on or preposition not in _COPYING):
            if child.sort == "robot":
                if preposition not in ("near", "close to"):
                    raise NotAnnotatable(f"PP {phrase.text!r}: construction not covered")
                return Meaning("direction", frozenset({SpatialReference("near")}), relation="near", preposition="on")
            relation = _RELATIONS[preposition]
            if not child.reference:
                return self._existential(phrase, child, relation, preposition)
            if relation == "between" and (child.sort != "many" or child.number != 2):
                raise NotAnnotatable(f"PP {phrase.text!r}: between what?")
            pair = relation == "between" and child.reference_kind == "group"
            kind = "object" if pair else child.reference_kind
            region = Region(relation, kind, child.reference)
            return Meaning("region", frozenset({region}), region=region, preposition=preposition)
        if preposition in _COPYING and child.sort != "empty":
            return replace(child, symbols=_passed(child), preposition=preposition)
        raise NotAnnotatable(f"PP {phrase.text!r}: construction not covered")

    def _existential(self, phrase: Phrase, child: Meaning, relation: str, preposition: str) -> Meaning:
        """Behind a green block: behind one of those that are possible."""
        if child.sort != "one" or not 0 < child.pool.bit_count() <= MOST_REFERENCES or relation == "between":
            raise NotAnnotatable(f"PP {phrase.text!r}: its reference is not determined")
        region = Region(relation, "object", self.layout.names(child.pool))
        return Meaning("region", frozenset({region}), region=region, preposition=preposition)

    # Verb phrases

    def _verb_phrase(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        verbs = [word.text for word in phrase.words if word.tag.startswith("VB")]
        told = [child for child in children if child.sort != "empty"]
        if not verbs or verbs[0] in ("is", "are", "want", "like") or phrase.words[0].tag in ("TO", "MD"):
            if len(told) == 1:
                return replace(told[0], symbols=_passed(told[0]))
            raise NotAnnotatable(f"VP {phrase.text!r}: construction not covered")
        kinds = sorted(s.kind for s in meanings(verbs[0]) if isinstance(s, Action))
        if any(child.sort == "nothing" or _is_empty(child) for child in told):
            return Meaning("action", frozenset(Action(kind) for kind in kinds[:1]))
        if not kinds or not told or told[0].sort not in ("one", "many", "container"):
            raise NotAnnotatable(f"VP {phrase.text!r}: no action on objects")
        kind, target = kinds[0], told[0]
        if verbs[0] == "take" and any(word.text == "away" for child in phrase.phrases for word in child.words):
            kind = "clear"
        regions: list[Region] | list[None] = [None]
        if kind == "place":
            if len(told) != 2:
                raise NotAnnotatable(f"VP {phrase.text!r}: no destination")
            regions = self._destinations(phrase, told[1], target)
        elif len(told) > 1:
            raise NotAnnotatable(f"VP {phrase.text!r}: construction not covered")
        if target.chosen:
            sets = [target.chosen]
        elif target.sort == "one":
            sets = [1 << i for i in indices_of(target.pool)]
        elif target.sort == "container":
            sets = [mask for _, mask in target.arrangements]
        elif target.number is None:
            sets = [target.pool] if target.pool else []
        else:
            sets = []  # which of them is open
        actions: frozenset[Symbol] = frozenset(
            Action(kind, self.layout.names(mask), region)
            for mask in sets
            for region in regions
            if region is None or not self.layout.mask(region.objects) & mask or told[-1].sort == "direction"
        )
        return Meaning("action", actions | {Action(kind)})

    def _destinations(self, phrase: Phrase, place: Meaning, target: Meaning) -> list[Region]:
        region = place.region
        if place.sort == "region" and region is not None and region.kind != "robot":
            if region.kind == "object" and len(region.objects) > 1 and region.relation != "between":
                return [Region(region.relation, "object", (name,)) for name in region.objects]
            return [region]
        if place.sort == "direction" and place.relation and target.chosen and place.preposition == "to":
            return [Region(place.relation, "object", self.layout.names(target.chosen))]
        raise NotAnnotatable(f"VP {phrase.text!r}: the destination is not covered")

    # Sets

    def _objects(self, mask: int) -> frozenset[Symbol]:
        return frozenset(ObjectSymbol(name) for name in self.layout.names(mask))

    def _contained(self, kind: str, mask: int) -> frozenset[Symbol]:
        return self._objects(mask) | {Container(kind, self.layout.names(mask))}

    def _rank(self, phrase: Phrase, pool: int, direction: str, index: int, kind: str) -> int:
        if direction == "center" and kind in ("row", "column", "tower") and index == 1:
            middle = self.layout.median(pool)
            if not middle:
                raise NotAnnotatable(f"{phrase.text!r}: an even number has no middle")
            return middle
        order = self.layout.ranked(pool, direction)
        place = len(order) - 1 if index == LAST else index - 1
        if not 0 <= place < len(order):
            return 0
        self._clear(phrase, pool, direction, place, place + 1)
        return 1 << order[place]

    def _count(self, phrase: Phrase, pool: int, number: int | None, relation: str | None) -> int:
        if number is None:
            if relation is not None:
                raise NotAnnotatable(f"{phrase.text!r}: how many?")
            return pool
        if relation is None:
            return pool if pool.bit_count() == number else 0
        if pool.bit_count() < number:
            return 0
        self._clear(phrase, pool, relation, 0, number)
        return self.layout.extreme(pool, relation, number)

    def _clear(self, phrase: Phrase, pool: int, direction: str, first: int, end: int) -> None:
        """Whether places [first, end) in the ranking are set apart from the others by the margin."""
        extent = np.sort(self.layout.extent(pool, direction))[::-1]
        for edge in (first, end):
            if 0 < edge < len(extent) and extent[edge - 1] - extent[edge] < MARGIN:
                raise NotAnnotatable(f"{phrase.text!r}: too close to call")

    def _closest(self, phrase: Phrase, pool: int, reference: tuple[str, ...]) -> int:
        members = list(indices_of(pool))
        if not members:
            return 0
        distance = self.layout.distance_to(pool, reference)
        order = np.argsort(distance, kind="stable")
        if len(order) > 1 and distance[order[1]] - distance[order[0]] < MARGIN:
            raise NotAnnotatable(f"{phrase.text!r}: too close to call")
        return 1 << members[int(order[0])]

    def _first_met(self, pool: int, region: Region) -> int:
        """Of several objects in a direction of a thing, the one that comes first, if it clearly does."""
        if region.relation not in ("left", "right", "front", "back", "near") or region.objects in ((), ("table",)):
            return 0
        members = list(indices_of(pool))
        away = self.layout.distance_to(pool, region.objects)
        order = np.argsort(away, kind="stable")
        return 1 << members[int(order[0])] if away[order[0]] < 0.75 * away[order[1]] else 0

    def _extreme_arrangement(
        self, phrase: Phrase, cands: list[tuple[str, int]], direction: str, index: int
    ) -> tuple[str, int]:
        if direction == "center":
            centre = self.layout.positions[:, :2].mean(axis=0)
            score = [-float(np.linalg.norm(self.layout.positions[list(indices_of(m)), :2].mean(axis=0) - centre))
                     for _, m in cands]  # fmt: skip
        else:
            score = [float(self.layout.extent(mask, direction).mean()) for _, mask in cands]
        order = sorted(range(len(cands)), key=lambda i: -score[i])
        place = len(order) - 1 if index == LAST else index - 1
        if place >= len(order):
            raise NotAnnotatable(f"{phrase.text!r}: there are not so many")
        for a, b in ((place - 1, place), (place, place + 1)):
            if 0 <= a and b < len(order) and score[order[a]] - score[order[b]] < 5 * MARGIN:
                raise NotAnnotatable(f"{phrase.text!r}: too close to call")
        return cands[order[place]]

    def _largest(self, phrase: Phrase, cands: list[tuple[str, int]], sign: int) -> tuple[str, int]:
        ordered = sorted(cands, key=lambda a: -sign * a[1].bit_count())
        if len(ordered) > 1 and ordered[0][1].bit_count() == ordered[1][1].bit_count():
            raise NotAnnotatable(f"{phrase.text!r}: equally large")
        return ordered[0]

    def _middle(self, direction: str) -> float:
        """Where the table's half in a direction begins."""
        tables = [item for item in self.layout.world.objects if item.type == "table"]
        x, y, _ = tables[0].position if tables else self.layout.positions.mean(axis=0)
        return float({"left": y, "right": -y, "back": x, "front": -x}.get(direction, -np.inf))

    def _half(self, phrase: Phrase, pool: int, direction: str, clear: bool = False) -> int:
        if direction not in ("left", "right", "front", "back"):
            raise NotAnnotatable(f"{phrase.text!r}: no half of the table is meant")
        members = list(indices_of(pool))
        over = self.layout.extent(pool, direction) - self._middle(direction)
        if clear and (np.abs(over) < 2 * MARGIN).any():
            raise NotAnnotatable(f"{phrase.text!r}: some stand in between")
        return sum(1 << i for i, value in zip(members, over, strict=True) if value > 0)


def _is_empty(meaning: Meaning) -> bool:
    """Whether a noun phrase means something that is not there."""
    if meaning.sort == "container":
        return not meaning.chosen and not meaning.arrangements
    return meaning.sort in ("one", "many") and not meaning.chosen and not meaning.pool


def _means_member(modifier: Meaning) -> bool:
    """Whether a place names a member: the top of a tower, the middle of a row, what is at its end."""
    region = modifier.region
    if region is None or region.kind in ("object", "robot"):
        return False
    if region.relation in ("left", "right", "front", "back"):
        return modifier.preposition == "at"
    return region.relation == "center" or (region.relation == "top" and region.kind == "tower")


def _passed(meaning: Meaning) -> frozenset[Symbol]:
    """What a phrase passes on to the one around it: all but the labels and words of the noun phrase itself."""
    if meaning.sort in ("one", "many", "container", "table"):
        kept = (ObjectSymbol, Container, ContainerAttribute, ObjectAttribute)
        return frozenset(s for s in meaning.symbols if isinstance(s, kept))
    return meaning.symbols
