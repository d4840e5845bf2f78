"""Annotates prepositional phrases: directions, regions, distances to something, and what is passed on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from grounding.corpus.meaning import Meaning, NotAnnotatable, is_empty, passed
from grounding.corpus.selector import Selector
from grounding.corpus.words import OPPOSITE, SUPERLATIVE_FAR, SUPERLATIVE_NEAR, directions
from grounding.geometry.masks import indices_of, mask_of
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.symbols import Cardinal, Ordinal, Region, SpatialReference, Symbol

MOST_REFERENCES = 8  # so many objects a reference may leave possible

_COPYING = ("in", "of", "from", "on", "at", "to", "off", "with", "over", "toward", "towards", "off of", "within",
            "inside", "among", "out of", "into", "for", "along", "onto", "on to", "over to")  # fmt: skip
_RELATIONS = {
    "behind": "back", "beyond": "back", "past": "back", "above": "above", "over": "above", "below": "below",
    "under": "below", "beneath": "below", "underneath": "below", "near": "near", "beside": "near", "by": "near",
    "next to": "near", "close to": "near", "adjacent to": "near", "alongside": "near", "against": "touching",
    "touching": "touching", "between": "between", "in between": "between", "on": "top", "onto": "top", "upon": "top",
    "atop": "top", "in front of": "front", "surrounded by": "surrounded",
}  # fmt: skip
_STRICT = ("directly", "immediately", "right", "just", "exactly")
_ADVERBS = (*_STRICT, "away", "very", "slightly", "almost", "diagonally", "straight", "located", "situated", "placed",
            "positioned", "sitting", "standing", "lying", "also", "all", "the", "way", "far", "up", "down", "more",
            "most", "so", "that", "back", "out", "then", "about")  # fmt: skip
_REFUSED = ("aligned", "level", "flush", "line", "parallel", "facing", "opposite", "diagonal", "separated", "than",
            "forming", "making", "across", "around", "until")  # fmt: skip


class Prepositions:
    """Prepositional phrases in one world."""

    def __init__(self, select: Selector) -> None:
        self.select = select
        self.layout = select.layout

    def compose(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        """The meaning of a prepositional phrase from its children's.

        Raises:
            NotAnnotatable: not clear or not covered.
        """
        texts = [word.text for word in phrase.words if word.tag != "UH"]
        if any(text in _REFUSED for text in texts):
            raise self._refusal(phrase)
        measured = any(child.sort == "measure" for child in children)
        numbers = frozenset(s for c in children if c.sort == "measure" for s in c.symbols if isinstance(s, Cardinal))
        told = [child for child in children if child.sort not in ("measure", "empty")]
        if _counts_blocks(phrase, children):
            measured, told = True, told[1:]
            numbers = frozenset(s for s in children[0].symbols if isinstance(s, Cardinal))
        if any(child.unclear for child in told):
            raise NotAnnotatable(f"PP {phrase.text!r}: too close to call")
        if len(told) == 2:
            found = self._joined(phrase, texts, told)
        elif not told:
            found = self._bare(phrase, texts, measured)
        elif len(told) == 1:
            found = self._one(phrase, texts, told[0])
        else:
            raise self._refusal(phrase)
        if any(text in _STRICT for text in texts) and not (texts[0] == "right" and "of" in texts):
            found = replace(found, strict=True)
        return replace(found, symbols=found.symbols | numbers, measured=True) if measured else found

    def _refusal(self, phrase: Phrase) -> NotAnnotatable:
        return NotAnnotatable(f"PP {phrase.text!r}: construction not covered")

    def _joined(self, phrase: Phrase, texts: list[str], told: list[Meaning]) -> Meaning:
        """What is joined: "above and to the left of it", "on the left and next to it"."""
        first, second = told
        if not {"and", "then", "but"} & set(texts) and any(p.words for p in phrase.phrases if p.tag != "PP"):
            raise self._refusal(phrase)
        symbols = first.symbols | second.symbols
        if (
            first.relation
            and first.place == "path"
            and not first.measured
            and second.sort == "region"
            and second.region
        ):
            relation = str(first.relation)
            region = Region(relation, second.region.kind, second.region.objects)
            return replace(second, symbols=second.symbols | {region}, regions=(region, *second.regions))
        if "nothing" in (first.sort, second.sort):
            return Meaning("nothing")
        return Meaning("several", symbols, parts=(first, second))

    def _bare(self, phrase: Phrase, texts: list[str], measured: bool) -> Meaning:
        """No noun phrase, or only a distance: "up two spaces", "furthest away"."""
        superlative = [text for text in texts if text in SUPERLATIVE_FAR]
        if superlative and set(texts) <= {*SUPERLATIVE_FAR, "away"}:
            return self._direction("far", "closest")
        named = list(dict.fromkeys(name for text in texts for name in directions(text)))
        named = [name for name in named if name not in ("near", "far") or not measured]
        if not 0 < len(named) <= 2:
            raise self._refusal(phrase)
        flat = [{"top": "back", "bottom": "front"}.get(name, name) for name in named]
        symbols: frozenset[Symbol] = frozenset(SpatialReference(name) for name in flat)
        corner = tuple(flat) if len(flat) == 2 else ()
        return Meaning("direction", symbols, relation=None if corner else flat[0], corner=corner, place="path",
                       preposition="toward")  # fmt: skip

    def _direction(self, name: str, preposition: str, index: int | None = None) -> Meaning:
        symbols: set[Symbol] = {SpatialReference(name)}
        symbols |= {Ordinal(index)} if index else set()
        return Meaning("direction", frozenset(symbols), relation=name, index=index, preposition=preposition)

    def _one(self, phrase: Phrase, texts: list[str], child: Meaning) -> Meaning:
        ordinals = [s.value for text in texts for s in meanings(text) if isinstance(s, Ordinal)]
        if child.sort == "direction" and "and" in texts and not child.corner and len(directions(texts[0])) == 1:
            first, second = (
                {"top": "back", "bottom": "front"}.get(directions(texts[0])[0], directions(texts[0])[0]),
                child.relation,
            )
            return Meaning("direction", child.symbols | {SpatialReference(first)}, corner=(first, str(second)),
                           place="path", preposition="toward")  # fmt: skip
        if child.sort in ("robot", "speaker") and texts[-1] in ("toward", "towards"):
            name = "near" if child.sort == "robot" else "far"
            return replace(self._direction(name, "toward"), place="path")
        near = any(text in SUPERLATIVE_NEAR for text in texts)
        far = any(text in SUPERLATIVE_FAR for text in texts)
        if child.sort in ("lone", "view"):
            return child
        if child.sort == "pronoun" and texts[-1:] in (["by"], ["on"], ["off"]) and phrase.text.endswith("itself"):
            return Meaning("lone")
        if child.sort == "pronoun":
            raise self._refusal(phrase)
        if child.sort == "direction" and child.place == "path":
            return child
        if near or far:
            return self._superlative(phrase, texts, child, far, ordinals[0] if ordinals else None)
        if ordinals:
            if texts[-1] in ("from", "in") and child.sort == "direction" and child.relation:
                return replace(child, symbols=child.symbols | {Ordinal(ordinals[0])}, index=ordinals[0],
                               preposition="from")  # fmt: skip
            raise self._refusal(phrase)
        if len(texts) >= 2 and texts[-1] == "of" and directions(texts[-2]) and texts[-2] not in ("out",):
            named = directions(texts[-2])
            relation = {"top": "back", "bottom": "front"}.get(named[0], named[0])
            if len(texts) > 2 and texts[-3:-1] == ["in", "front"]:
                relation = "front"
            if relation in ("left", "right", "front", "back"):
                found = self.region(phrase, child, relation, "of")
                return found if len(named) == 1 else self._also(phrase, found, child, named[1])
        words = [text for text in texts if text not in _ADVERBS]
        preposition = " ".join(words) or texts[-1]
        if not words and texts[-1] in ("over", "down", "up", "off", "back") and child.sort == "direction":
            preposition = "to"
        if child.sort == "region" or (child.sort == "several" and not words):
            return replace(child, preposition=preposition if words else child.preposition)
        stands_on = preposition in ("on", "onto", "upon") and child.sort in ("one", "table", "container", "many")
        if child.sort == "nothing" or (is_empty(child) and preposition not in _COPYING):
            return replace(child, preposition=preposition) if preposition in _COPYING else Meaning("nothing")
        if child.sort == "direction" and _RELATIONS.get(preposition) in ("near", "touching"):
            return replace(child, symbols=passed(child), preposition="at")
        if preposition in _RELATIONS and (stands_on or preposition not in _COPYING or preposition == "over"):
            if child.sort in ("robot", "speaker"):
                return self._near_person(phrase, child, preposition)
            if child.sort in ("one", "many", "container", "table"):
                return self.region(phrase, child, _RELATIONS[preposition], preposition)
            raise self._refusal(phrase)
        if preposition in _COPYING and child.sort not in ("empty", "action"):
            if child.sort == "speaker" and preposition not in ("to", "from", "of"):
                raise self._refusal(phrase)
            said = "on" if preposition in ("toward", "towards", "along", "over") else preposition
            said = {"off": "from", "off of": "from", "within": "in", "inside": "in", "among": "in", "out of": "of",
                    "over to": "to", "into": "in", "onto": "on"}.get(said, said)  # fmt: skip
            return replace(child, symbols=passed(child), preposition=said)
        raise self._refusal(phrase)

    def _near_person(self, phrase: Phrase, child: Meaning, preposition: str) -> Meaning:
        if preposition not in ("near", "close to", "next to", "by"):
            raise self._refusal(phrase)
        name = "far" if child.sort == "speaker" else "near"
        return replace(self._direction(name, "on"), by_speaker=child.sort == "speaker")

    def _superlative(self, phrase: Phrase, texts: list[str], child: Meaning, far: bool, index: int | None) -> Meaning:
        """Distances: "third farthest from it", "furthest to the left", "furthest from the left"."""
        said = "farthest" if far else "closest"
        if child.sort in ("robot", "speaker"):
            name = "far" if far != (child.sort == "speaker") else "near"
            return replace(self._direction(name, said, index), by_speaker=child.sort == "speaker")
        if child.sort == "region" and child.region is not None and self._is_table(child.region.objects):
            relation = child.region.relation
            child = Meaning("direction", frozenset({SpatialReference(relation)}), relation=relation)
        if child.sort == "direction":
            away = far and "from" in texts
            symbols: set[Symbol] = {s for s in child.symbols if isinstance(s, SpatialReference)}
            symbols |= {Ordinal(index)} if index else set()
            if child.corner and not away:
                return replace(child, symbols=frozenset(symbols), index=index, preposition=said)
            if child.relation and away:
                return self._direction(OPPOSITE.get(child.relation, child.relation), said, index)
            if child.relation:
                return replace(child, symbols=frozenset(symbols), index=index or child.index, preposition=said)
            raise self._refusal(phrase)
        if child.sort == "nothing" or is_empty(child):
            return Meaning("nothing")
        if child.sort in ("one", "many", "container") and child.reference:
            region = Region("far" if far else "near", child.reference_kind, child.reference)
            carried: set[Symbol] = {region}
            carried |= {Ordinal(index)} if index else set()
            return Meaning("region", frozenset(carried), region=region, preposition=said, index=index,
                           nearest_to=child.reference, away=far)  # fmt: skip
        raise self._refusal(phrase)

    def _is_table(self, names: Sequence[str]) -> bool:
        return bool(names) and all(self.layout.world[name].type == "table" for name in names)

    def _also(self, phrase: Phrase, found: Meaning, child: Meaning, relation: str) -> Meaning:
        """A second direction from the same thing: "northeast of it"."""
        if found.sort != "region" or found.region is None:
            raise self._refusal(phrase)
        other = Region(relation, found.region.kind, found.region.objects)
        return replace(found, symbols=found.symbols | {other}, regions=(*found.regions, other))

    def region(self, phrase: Phrase, child: Meaning, relation: str, preposition: str) -> Meaning:
        """The region in a relation to what a noun phrase means.

        Args:
            phrase: for messages.
            child: the meaning of the noun phrase.
            relation: a spatial reference, or "above", "below", "touching", "surrounded".
            preposition: remembered with the region.
        """
        if child.sort in ("nothing",) or is_empty(child):
            return Meaning("nothing")
        if child.sort not in ("one", "many", "container", "table"):
            raise self._refusal(phrase)
        if relation in ("above", "below"):
            relation = self._upright(child, relation)
        contact = relation == "touching"
        if relation == "surrounded" or (relation == "between" and child.sort != "many"):
            return self._amid(phrase, child, preposition, relation)
        relation = "near" if contact else relation
        if child.parts and not child.chosen:
            return self._each_of_two(phrase, child, relation, preposition, contact)
        if not child.reference:
            return self._existential(phrase, child, relation, preposition, contact)
        if relation == "between":
            if child.number not in (2, None) or child.chosen.bit_count() < 2:
                raise NotAnnotatable(f"PP {phrase.text!r}: between what?")
            if child.number is None and child.chosen.bit_count() != 2:
                return self._amid(phrase, child, preposition, relation)
        pair = relation == "between" and child.reference_kind == "group"
        region = Region(relation, "object" if pair else child.reference_kind, child.reference)
        restricts = self._touching_all(phrase, child) if contact else None
        return Meaning("region", frozenset({region}), region=region, preposition=preposition, contact=contact,
                       restricts=restricts)  # fmt: skip

    def _upright(self, child: Meaning, relation: str) -> str:
        """Whether above is on top of it or behind it, as one looks at a table: what stands on it decides."""
        upright = "top" if relation == "above" else "bottom"
        if child.chosen and child.reference:
            region = Region(upright, child.reference_kind, child.reference)
            if self.layout.within(region):
                return upright
        return "back" if relation == "above" else "front"

    def _touching_all(self, phrase: Phrase, child: Meaning) -> int:
        together = child.sort == "container"
        found = self.layout.everything & ~child.chosen
        for mask in [child.chosen] if together else [1 << i for i in indices_of(child.chosen)]:
            touching, clear = self.select.sight.touching(mask, found)
            if not clear:
                raise NotAnnotatable(f"PP {phrase.text!r}: touching or not is too close to call")
            found = touching
        return found

    def _existential(self, phrase: Phrase, child: Meaning, relation: str, preposition: str, contact: bool) -> Meaning:
        """Behind a green block: behind one of those that are possible; touching two: touching so many of them."""
        if child.sort == "many" and child.definite:
            raise NotAnnotatable(f"PP {phrase.text!r}: there are not so many")
        if child.ranks or child.index is not None:
            raise NotAnnotatable(f"PP {phrase.text!r}: which one is open")
        if child.sort not in ("one", "many") or not 0 < child.pool.bit_count() <= MOST_REFERENCES:
            raise NotAnnotatable(f"PP {phrase.text!r}: its reference is not determined")
        number = 1 if child.sort == "one" else child.number or 2
        region = Region(relation, "object", self.layout.names(child.pool))
        restricts = None
        if relation == "between":
            restricts = self._between_some(child.pool) if number == 2 else 0
        elif contact or number > 1:
            restricts = self._at_least(phrase, child.pool, number, relation, contact)
        return Meaning("region", frozenset({region}), region=region, preposition=preposition, contact=contact,
                       restricts=restricts, indefinite=child.indefinite)  # fmt: skip

    def _each_of_two(self, phrase: Phrase, child: Meaning, relation: str, preposition: str, contact: bool) -> Meaning:
        """Between a red and a blue block; touching one of each."""
        pools = [part.chosen or part.pool for part in child.parts]
        if len(pools) != 2 or not all(pools) or not child.pool.bit_count() <= 2 * MOST_REFERENCES:
            raise NotAnnotatable(f"PP {phrase.text!r}: its reference is not determined")
        first, second = (list(indices_of(pool)) for pool in pools)
        region = Region(relation, "object", self.layout.names(child.pool))
        found = 0
        if relation == "between":
            for i, j in ((i, j) for i in first for j in second if i != j):
                names = self.layout.names(1 << i | 1 << j)
                found |= self.layout.within(Region("between", "object", names))
        else:
            found = self.layout.everything
            for pool in pools:
                found &= self._at_least(phrase, pool, 1, relation, contact)
        return Meaning("region", frozenset({region}), region=region, preposition=preposition, contact=contact,
                       restricts=found)  # fmt: skip

    def _at_least(self, phrase: Phrase, pool: int, number: int, relation: str, contact: bool) -> int:
        """What is in a relation to so many members of a set."""
        counts = np.zeros(self.layout.size, dtype=int)
        for i in indices_of(pool):
            if contact:
                found, clear = self.select.sight.touching(1 << i, self.layout.everything & ~(1 << i))
                if not clear:
                    raise NotAnnotatable(f"PP {phrase.text!r}: touching or not is too close to call")
            else:
                found = self.layout.within(Region(relation, "object", (self.layout.ids[i],)))
            for j in indices_of(found):
                counts[j] += 1
        return mask_of(np.flatnonzero(counts >= number))

    def _between_some(self, pool: int) -> int:
        found = 0
        for pair in combinations(indices_of(pool), 2):
            mask = sum(1 << i for i in pair)
            found |= self.layout.within(Region("between", "object", self.layout.names(mask)))
        return found

    def _amid(self, phrase: Phrase, child: Meaning, preposition: str, relation: str) -> Meaning:
        """Surrounded by blocks: several of them beside it, on different sides."""
        pool = child.chosen or child.pool
        if child.sort == "many" and child.definite and not child.chosen:
            raise NotAnnotatable(f"PP {phrase.text!r}: there are not so many")
        if child.sort not in ("many", "container") or not 1 < pool.bit_count() <= MOST_REFERENCES:
            raise NotAnnotatable(f"PP {phrase.text!r}: its reference is not determined")
        if relation == "between":
            raise NotAnnotatable(f"PP {phrase.text!r}: between what?")
        least = max(2, child.number or 3)
        found = 0
        for i in range(self.layout.size):
            beside = self.layout.within(Region("near", "object", (self.layout.ids[i],))) & pool & ~(1 << i)
            if beside.bit_count() >= least and self._around(i, beside):
                found |= 1 << i
        region = Region("between", "object", self.layout.names(pool))
        return Meaning("region", frozenset({region}), region=region, preposition=preposition, restricts=found)

    def _around(self, index: int, beside: int) -> bool:
        """Whether blocks lie on more than one side of another."""
        offset = self.layout.positions[list(indices_of(beside)), :2] - self.layout.positions[index, :2]
        angles = np.sort(np.arctan2(offset[:, 1], offset[:, 0]))
        widest = float(np.diff(np.append(angles, angles[0] + 2 * np.pi)).max())
        return widest < (1.25 if len(angles) > 2 else 1.35) * np.pi


def _counts_blocks(phrase: Phrase, children: Sequence[Meaning]) -> bool:
    """Whether a distance is said in blocks: "two blocks to the left", "up one cube"."""
    if not children or children[0].sort not in ("one", "many") or phrase.phrases[0].phrases:
        return False
    words = phrase.phrases[0].words
    counted = any(isinstance(s, Cardinal) for s in meanings(words[0].text)) or words[0].text in ("a", "half")
    if not counted or phrase.phrases[0].tag != "NP":
        return False
    first = phrase.children[0] is phrase.phrases[0]
    bare = len(children) == 1 and all(directions(word.text) and word.text not in _RELATIONS for word in phrase.words)
    return bare or (first and len(phrase.children) > 1)


def lies_directly(
    layout_positions: np.ndarray, edges: np.ndarray, index: int, references: Sequence[int], relation: str
) -> bool:
    """Whether a block lies straight in a direction of a reference, not aside by more than most of an edge."""
    axis = 1 if relation in ("front", "back") else 0
    if relation not in ("front", "back", "left", "right"):
        return True
    aside = np.abs(layout_positions[list(references), axis] - layout_positions[index, axis]).min()
    return bool(aside <= 0.8 * edges[index])
