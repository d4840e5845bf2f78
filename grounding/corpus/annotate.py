"""Annotates a gold tree phrase by phrase in a world whose arrangements are known.

This is how the treebank and generated corpora get their groundings: by the meaning that the sentence was written with,
in a world of which we know how it was laid out. It refuses what is not clear there: a row that is not the only one, a
nearest block by less than `MARGIN`. Inference never uses it: models learn from what it wrote.

The conventions follow the annotators of the paper's corpus where those are consistent: "the row" is a kind until
something makes it one row; "third block" is an attribute until a direction and a set make it one block; "in NP", "of
NP" pass on what their noun phrase means.

What Γ has no symbol of its own for is expressed by several: a corner is two spatial references, "northeast of it" two
regions, of which an action's destination is the one and the other stands beside the action; the speaker across the
table is the far end, and "my left" the robot's right.
"""

from __future__ import annotations

from collections.abc import Sequence

from grounding.corpus.base_phrases import BasePhrases
from grounding.corpus.clauses import Clauses
from grounding.corpus.meaning import Meaning, NotAnnotatable
from grounding.corpus.noun_phrases import NounPhrases
from grounding.corpus.selector import Selector
from grounding.geometry.layout import Layout
from grounding.language.tree import Phrase
from grounding.symbols import Action, Symbol


def annotate(
    tree: Phrase, layout: Layout, arrangements: Sequence[tuple[str, int]], history: Sequence[str] = ()
) -> tuple[tuple[frozenset[Symbol], ...], str]:
    """Ground every phrase of a gold tree.

    Args:
        tree: the gold parse.
        layout: the world, measured.
        arrangements: the rows, columns, groups, circles and towers that are there, as (kind, mask).
        history: ids of what was moved before, the latest last.

    Returns:
        the symbols of every phrase, in preorder, and the outcome: "grounded", "ambiguous" or "no_referent".

    Raises:
        NotAnnotatable: the sentence is not true, not clear or not covered here.
    """
    annotator = _Annotator(layout, tuple(arrangements), tuple(history))
    root = annotator.phrase(tree)
    if root.unclear:
        raise NotAnnotatable(f"{tree.text!r}: too close to call")
    groundings = tuple(annotator.symbols[id(phrase)] for phrase in tree.preorder())
    return groundings, annotator.outcome(tree, root)


class _Annotator:
    def __init__(self, layout: Layout, arrangements: tuple[tuple[str, int], ...], history: tuple[str, ...]) -> None:
        select = Selector(layout)
        self.base_phrases = BasePhrases(select, arrangements, history)
        self.noun_phrases = NounPhrases(select, arrangements)
        self.clauses = Clauses(self.noun_phrases, history)
        self.symbols: dict[int, frozenset[Symbol]] = {}

    def phrase(self, phrase: Phrase) -> Meaning:
        children = [self.phrase(child) for child in phrase.phrases]
        meaning = self._compose(phrase, children)
        self.symbols[id(phrase)] = meaning.symbols
        return meaning

    def outcome(self, tree: Phrase, root: Meaning) -> str:
        """What an instruction that means this leads to.

        Raises:
            NotAnnotatable: no instruction at all, or one that speaks of something unsaid.
        """
        if root.sort == "action":
            actions = sum(isinstance(symbol, Action) and bool(symbol.objects) for symbol in root.symbols)
            if not actions and root.verb and (root.target is None or root.target.sort == "pronoun"):
                raise NotAnnotatable(f"{tree.text!r}: nothing was spoken of before")
            if root.indefinite and actions:
                return "grounded"  # "next to a red block": any will do
            return "grounded" if actions == 1 else "ambiguous" if actions else "no_referent"
        if root.sort in ("one", "many", "container"):
            if root.chosen:
                return "grounded"
            return "ambiguous" if root.pool or root.arrangements else "no_referent"
        if root.sort != "nothing":
            raise NotAnnotatable(f"{tree.text!r}: no instruction")
        return "no_referent"

    def _compose(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        if phrase.tag in ("PRT", "WHNP", "ADVP", "INTJ"):
            return Meaning("empty")
        if phrase.tag == "NP":
            return self._noun_phrase(phrase, children)
        if phrase.tag == "PP":
            return self.clauses.destinations.prepositions.compose(phrase, children)
        if phrase.tag == "VP":
            return self.clauses.verb_phrase(phrase, children)
        if phrase.tag == "ADJP":
            return self.clauses.adjectives(phrase, children)
        if phrase.tag in ("S", "SBAR"):
            return self.clauses.sentence(phrase, children)
        if phrase.tag == "FRAG":
            return self.clauses.discourse(phrase, children)
        raise NotAnnotatable(f"{phrase.tag} {phrase.text!r}: construction not covered")

    def _noun_phrase(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        if children:
            return self.noun_phrases.compose(phrase, children)
        texts = [word.text for word in phrase.words]
        if texts[-1] in ("perspective", "viewpoint", "view", "point") or texts == ["where", "you", "are"]:
            if "my" in texts and self.noun_phrases.select.sight.speaker is not None:
                raise NotAnnotatable(f"NP {phrase.text!r}: the speaker's view is not covered")
            return Meaning("view")
        if texts == ["the", "way"]:
            return Meaning("view")
        if texts[-2:] == ["its", "own"] or texts == ["itself"]:
            return Meaning("lone")
        return self.base_phrases.annotate(phrase)
