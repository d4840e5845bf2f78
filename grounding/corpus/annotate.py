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

from grounding.corpus.base_phrases import annotate_base
from grounding.corpus.meaning import Meaning, NotAnnotatable, is_empty, passed
from grounding.corpus.noun_phrases import MOST_REFERENCES, NounPhrases
from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.symbols import Action, Ordinal, Region, SpatialReference, Symbol

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
    if root.unclear:
        raise NotAnnotatable(f"{tree.text!r}: too close to call")
    groundings = tuple(annotator.symbols[id(phrase)] for phrase in tree.preorder())
    return groundings, annotator.outcome(root)


class _Annotator:
    def __init__(self, layout: Layout, arrangements: tuple[tuple[str, int], ...]) -> None:
        self.layout = layout
        self.arrangements = arrangements
        self.noun_phrases = NounPhrases(layout, arrangements)
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
            return self.noun_phrases.compose(phrase, children)
        if phrase.tag == "PP":
            return self._prepositional(phrase, children)
        if phrase.tag == "VP":
            return self._verb_phrase(phrase, children)
        if phrase.tag in ("S", "SBAR"):
            told = [child for child in children if child.sort != "empty"]
            said = [child for child in told if child.sort in ("action", "region", "direction")] or told
            if len(said) == 1:
                return replace(said[0], symbols=passed(said[0]))
        raise NotAnnotatable(f"{phrase.tag} {phrase.text!r}: construction not covered")

    def _prepositional(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        words = [word.text for word in phrase.words if word.text not in ("directly", "right", "just", "away", "very")]
        if phrase.words and phrase.words[0].text == "right" and "of" in words:
            words = ["right", *words]
        if len(children) != 1:
            raise NotAnnotatable(f"PP {phrase.text!r}: construction not covered")
        child, preposition = children[0], " ".join(words)
        if child.unclear:
            raise NotAnnotatable(f"PP {phrase.text!r}: too close to call")
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
        if child.sort == "nothing" or (is_empty(child) and preposition not in _COPYING):
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
            return replace(child, symbols=passed(child), preposition=preposition)
        raise NotAnnotatable(f"PP {phrase.text!r}: construction not covered")

    def _existential(self, phrase: Phrase, child: Meaning, relation: str, preposition: str) -> Meaning:
        """Behind a green block: behind one of those that are possible."""
        if child.sort != "one" or not 0 < child.pool.bit_count() <= MOST_REFERENCES or relation == "between":
            raise NotAnnotatable(f"PP {phrase.text!r}: its reference is not determined")
        region = Region(relation, "object", self.layout.names(child.pool))
        return Meaning("region", frozenset({region}), region=region, preposition=preposition)

    def _verb_phrase(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        verbs = [word.text for word in phrase.words if word.tag.startswith("VB")]
        told = [child for child in children if child.sort != "empty"]
        if not verbs or verbs[0] in ("is", "are", "want", "like") or phrase.words[0].tag in ("TO", "MD"):
            if len(told) == 1:
                return replace(told[0], symbols=passed(told[0]))
            raise NotAnnotatable(f"VP {phrase.text!r}: construction not covered")
        kinds = sorted(s.kind for s in meanings(verbs[0]) if isinstance(s, Action))
        if any(child.unclear for child in told):
            raise NotAnnotatable(f"VP {phrase.text!r}: too close to call")
        if any(child.sort == "nothing" or is_empty(child) for child in told):
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
