"""Composes the meanings of noun phrases: a head and what modifies it."""

from __future__ import annotations

from dataclasses import replace

from grounding.corpus.meaning import Meaning, NotAnnotatable, is_empty, passed
from grounding.corpus.place_phrases import PlacePhrases
from grounding.corpus.prepositions import lies_directly
from grounding.geometry.masks import indices_of, single
from grounding.language.tree import Phrase
from grounding.symbols import ObjectAttribute, Region, Symbol


class NounPhrases(PlacePhrases):
    """Noun phrases in one world."""

    def compose(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        """The meaning of a noun phrase from its children's.

        Raises:
            NotAnnotatable: not true, not clear or not covered.
        """
        texts = [word.text for word in phrase.words if word.tag != "UH"]
        if "and" in texts and len(children) == 2 and set(texts) <= {"and", "both"}:
            return self._both(phrase, children)
        if "and" in texts and len(children) == 3 and texts == ["and"]:
            inner = self.modified(phrase, children[0], children[1])
            return self.modified(phrase, inner, children[2])
        told = [child for child in children if child.sort != "empty"]
        if [text for text in texts if text != "please"]:
            raise NotAnnotatable(f"NP {phrase.text!r}: construction not covered")
        if len(told) == 1:
            return told[0]
        if len(told) != 2:
            raise NotAnnotatable(f"NP {phrase.text!r}: construction not covered")
        return self.modified(phrase, *told)

    def modified(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        """A head with one modifier.

        Args:
            phrase: for messages.
            head: what is modified.
            modifier: a place, a direction, a set that it is of, a relative clause.

        Raises:
            NotAnnotatable: not true, not clear or not covered.
        """
        predicate = modifier.sort == "one" and not modifier.preposition
        if modifier.unclear and not predicate:
            raise NotAnnotatable(f"{modifier.sort} in {phrase.text!r}: too close to call")
        if modifier.sort in ("several", "predicate") and modifier.parts:
            for part in modifier.parts:
                head = self.modified(phrase, head, part)
            return head
        if "nothing" in (head.sort, modifier.sort) or is_empty(modifier):
            return Meaning("nothing")
        if modifier.measured:
            raise NotAnnotatable(f"NP {phrase.text!r}: a measured distance says nothing of what is there")
        if modifier.sort == "pronoun":
            raise NotAnnotatable(f"NP {phrase.text!r}: what was spoken of is not known here")
        if head.sort == "one":
            return self._one(phrase, head, modifier)
        if head.sort == "many":
            return self._many(phrase, head, modifier)
        if head.sort == "container":
            return self._container(phrase, head, modifier)
        if head.sort == "direction":
            return self._place(phrase, head, modifier)
        if head.sort == "view":
            return head
        if head.sort == "table" and modifier.sort == "region":
            return replace(modifier, symbols=passed(modifier), preposition="")
        raise NotAnnotatable(f"NP {phrase.text!r}: a {head.sort} with a {modifier.sort} is not covered")

    def _both(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        chosen = 0
        if all(c.sort == "one" and not c.unclear and (c.chosen or c.indefinite) and c.pool for c in children) and any(
            not c.chosen for c in children
        ):
            symbols = frozenset().union(*(passed(child) for child in children))
            pool = children[0].pool | children[1].pool
            return Meaning("many", symbols, pool=pool, number=2, parts=tuple(children))
        for child in children:
            if child.sort == "nothing":
                return Meaning("nothing")
            if child.unclear or not child.chosen or child.sort not in ("one", "container", "many"):
                raise NotAnnotatable(f"NP {phrase.text!r}: parts of 'and' are not determined")
            if child.chosen & chosen:
                raise NotAnnotatable(f"NP {phrase.text!r}: parts of 'and' overlap")
            chosen |= child.chosen
        symbols = frozenset().union(*(passed(child) for child in children))
        return Meaning("many", symbols, pool=chosen, chosen=chosen, reference=self.layout.names(chosen),
                       definite=True, number=len(children))  # fmt: skip

    def _one(self, phrase: Phrase, head: Meaning, modifier: Meaning) -> Meaning:
        new, kind, upright = self._narrowed(phrase, head, modifier)
        if new.index is not None and new.index > new.pool.bit_count():
            new = replace(new, pool=0)  # there are not so many
        chosen, unclear = 0, False
        try:
            chosen = self._chosen(phrase, new, modifier, kind, upright)
        except NotAnnotatable as error:
            if "too close to call" not in str(error) or not new.ranks:
                raise
            unclear = True  # fine while something around it decides
        if modifier.sort == "direction" and head.relation is None:
            self._lies_there(phrase, chosen, modifier)
        member = bool(kind) and modifier.sort == "region"
        said = None if new.nearest_to or new.corner else head.relation if member else new.relation
        attribute = ObjectAttribute(head.object_type, head.color, said, new.index or (1 if said else None))
        found = self.select.objects(chosen)
        if modifier.sort in ("direction", "robot", "speaker") and not new.corner:
            symbols: frozenset[Symbol] = found | {attribute} | (frozenset() if chosen else new.carried)
        else:
            symbols = found if chosen else new.carried | {attribute}
        return replace(new, symbols=symbols, chosen=chosen, unclear=unclear, reference=self.layout.names(chosen),
                       reference_kind="object")  # fmt: skip

    def _chosen(self, phrase: Phrase, new: Meaning, modifier: Meaning, kind: str, upright: bool) -> int:
        pool, region = new.pool, modifier.region
        crowded = modifier.sort == "region" and region is not None and not kind and not new.ranks
        if crowded and region is not None and new.index is None and pool:
            if modifier.strict:
                return self._direct(phrase, pool, region)
            if not single(pool) and modifier.restricts is None and not modifier.regions:
                return self.select.first_met(pool, region)
        if new.relation == "center" and modifier.sort == "direction":
            return self.layout.central(pool)
        return self.select.choose(phrase, pool, new, kind if modifier.chosen or kind else "", upright)

    def _direct(self, phrase: Phrase, pool: int, region: Region) -> int:
        """What is directly there: the first that comes, if it lies straight in that direction."""
        if region.kind == "robot" and region.relation in ("front", "back") and not single(pool):
            nearest = "near" if region.relation == "front" else "far"  # of the speaker across the table, the farthest
            return self.select.rank(phrase, pool, nearest, 1, "")
        if region.kind == "robot" or self._table() == region.objects:
            return pool if single(pool) else 0
        chosen = pool if single(pool) else self.select.first_met(pool, region)
        references = list(indices_of(self.layout.mask(region.objects)))
        if not chosen or not references:
            return chosen
        index = next(indices_of(chosen))
        if not lies_directly(self.layout.positions, self.layout.edges, index, references, region.relation):
            raise NotAnnotatable(f"{phrase.text!r}: not directly there")
        return chosen
