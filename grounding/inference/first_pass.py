"""The first pass over a tree: from its leaves up, which kinds of symbols every phrase needs."""

from __future__ import annotations

from collections import OrderedDict

from grounding.factors.first_pass import FirstPass, Needs
from grounding.features import FAMILIES
from grounding.features.needs import need_facts, need_key, world_facts
from grounding.geometry.layout import Layout
from grounding.inference.engine import Kept, Tally
from grounding.language.tree import Phrase

KEPT = 20_000  # phrases whose needs are remembered


class Restriction:
    """A first pass, and what it has said before: the same words above the same needs are judged once.

    Args:
        first_pass: the factors.
    """

    def __init__(self, first_pass: FirstPass) -> None:
        self.first_pass = first_pass
        self._known: OrderedDict[object, Needs] = OrderedDict()
        self._unknown = frozenset(family.name for family in FAMILIES).difference(first_pass.kinds)

    def needs(self, tree: Phrase, layout: Layout, tally: Tally | None = None) -> dict[int, Needs]:
        """What every phrase needs, by the identity of the phrase.

        Args:
            tree: the parse.
            layout: the world, measured.
            tally: told how many factors were evaluated: one a kind, but for phrases that are remembered.
        """
        found: dict[int, Needs] = {}
        world = world_facts(layout)
        for phrase in tree.postorder():
            children = [found[id(child)].likely for child in phrase.phrases]
            key = world, need_key(phrase, children)
            needs = self._known.get(key)
            if needs is None:
                needs = self._known[key] = self.first_pass.needs(need_facts(phrase, children, layout))
                if len(self._known) > KEPT:
                    self._known.popitem(last=False)
                if tally is not None:
                    tally.evaluations += len(self.first_pass.kinds)
            found[id(phrase)] = needs
        return found

    def kept(self, tree: Phrase, layout: Layout, tally: Tally) -> Kept:
        """The families that the second pass looks at, by the identity of the phrase.

        A family that the first pass has no factor for is kept: nothing speaks against it.
        """
        return {phrase: found.kept | self._unknown for phrase, found in self.needs(tree, layout, tally).items()}
