"""Answers of people to a question: one of the alternatives, a few of them, none, a place, or something else."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from grounding.language.lexicon import meanings
from grounding.language.parser import Parse
from grounding.language.tree import Phrase
from grounding.meaning.discourse.verbs import HANDLING
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reader import Reader
from grounding.meaning.referents import OBJECTS, Condition, Referent
from grounding.missing import targets
from grounding.model.cases import Denotation, Weights
from grounding.model.evaluator import EVEN, Evaluator
from grounding.symbols import LAST, Cardinal, ObjectColor, ObjectType, Ordinal
from grounding.world import Array
from grounding.world.scene import ROBOT, SPEAKER, Scene

TOLD = 0.6  # an alternative is taken when it has such a share of what an answer says
MARGIN = 1.4
TRUE = 0.04  # what describes all alternatives worse than this describes something else
_LEFT = 0.4  # alternatives this much less likely than the best are left
YES = frozenset("yes yeah yep yup sure right correct exactly ok okay indeed affirmative true".split())
NO = frozenset("no nope nah neither none wrong incorrect negative not".split())
FILLING = frozenset(
    "please thanks thank you i mean meant think want it it's its is that that's the this one ones of them these those "
    "either um uh hm well oh so number option block box cube a two three".split()
)
_FORGETTING = ("never mind", "nevermind", "forget it", "cancel", "stop", "abort", "quit that", "leave it")
_WORD = re.compile(r"[\w'-]+")


@dataclass(frozen=True)
class Answer:
    """The choice that an answer makes among the alternatives.

    Attributes:
        kind: "chosen" (one of them, or with "both" several), "narrowed", "first" (the likeliest is to be asked for
            alone), "none", "forgotten", or "other" where it is about something else.
        places: of the alternatives that are left, in their order.
        probability: of the chosen one.
        rest: the words after "no", that may say what is meant instead.
    """

    kind: str
    places: tuple[int, ...] = ()
    probability: float = 0.0
    rest: str = ""


def words_of(text: str) -> list[str]:
    """The words of an answer in lower case."""
    return _WORD.findall(text.lower().replace("\u2019", "'"))


def by_words(text: str, count: int, named: int) -> Answer | None:
    """Read what yes, no and places in the list say; None where an answer has more to it.

    Args:
        text: the answer.
        count: how many alternatives there are.
        named: how many of them, the first ones, the question named.
    """
    words = words_of(text)
    told = [word for word in words if word not in FILLING]
    if any(words == words_of(said) for said in _FORGETTING):
        return Answer("forgotten")
    if words and words[0] in NO:
        further = words[1:]
        while further and further[0] in FILLING - {"the", "a", "block"} | NO:
            further = further[1:]
        rest = " ".join(further)
        return Answer("none", tuple(range(named, count)), rest="" if set(further) <= FILLING | NO else rest)
    agreed = YES - {"right"} if named > 1 or {"the", "one"} & set(words) else YES  # "the right one" is a side
    if told and set(told) <= agreed:
        return Answer("chosen", (0,), 0.99) if named == 1 else Answer("first", tuple(range(count)))
    if told in (["both"], ["all"]):
        return Answer("chosen", tuple(range(count if told == ["all"] else 2)), 0.99) if count > 1 else None
    place = _listed(told, words, named)
    return None if place is None else Answer("chosen", (place,), 0.99)


def by_offer(text: str, offers: Sequence[str]) -> Answer | None:
    """The alternative that an answer names in the very words of the question; None where it uses others.

    Args:
        text: the answer.
        offers: the words of the alternatives; sets of things are told by a part of them: "the nearest one".
    """
    said = _telling(text)
    same = [place for place, offer in enumerate(offers) if said and said == _telling(offer)]
    if not same and said and all(" of " in offer for offer in offers):
        same = [place for place, offer in enumerate(offers) if set(said) <= set(_telling(offer))]
    return Answer("chosen", (same[0],), 0.99) if len(same) == 1 else None


def _telling(text: str) -> list[str]:
    """The words that tell one of several alike from the others."""
    things = (ObjectColor, ObjectType)
    return [
        word for word in words_of(text)
        if word not in FILLING - {"two", "three"} and not any(isinstance(s, things) for s in meanings(word))
    ]  # fmt: skip


def _listed(told: Sequence[str], words: Sequence[str], named: int) -> int | None:
    """The alternative that "the second one", "2" or "the latter" points at, or None."""
    if told in (["former"], ["latter"]):
        return 0 if told == ["former"] else named - 1
    if not told and words in (["one"], ["two"], ["three"], ["number", "two"], ["number", "three"], ["option", "two"]):
        told = words[-1:]
    if len(told) != 1 or named < 2:
        return None
    values = [s.value for s in meanings(told[0]) if isinstance(s, Ordinal | Cardinal)]
    if told[0] in ("last", "final"):
        values = [LAST]
    if not values:
        return None
    place = named - 1 if values[0] == LAST else values[0] - 1
    return place if 0 <= place < named else None


def by_description(
    parses: Sequence[Parse], scene: Scene, options: Sequence[Sequence[str]], weights: Weights = EVEN
) -> Answer:
    """Find the alternatives that a description holds of, as it is said to tell them apart.

    Args:
        parses: of the answer, the likeliest first.
        scene: the world.
        options: the ids of each alternative.
        weights: of features.
    """
    inside = np.zeros(scene.n)
    for names in options:
        inside[[scene.layout.index[name] for name in names if name in scene.layout.index]] = 1.0
    views = (ROBOT,) if scene.layout.world.speaker is None else (ROBOT, SPEAKER)
    best = Answer("other")
    for view in views:
        for parse in parses[:2]:
            found = _told(parse, _Among(scene, view, weights, inside), options)
            if (found.kind != "other", found.probability) > (best.kind != "other", best.probability):
                best = found
    return best


class _Among(Evaluator):
    """Evaluates what is said of some objects: "the left one" of two.

    Args:
        scene: the world.
        view: whose left is meant where nobody is named.
        weights: of features.
        inside: 1 for the objects and 0 for others, shape (n,).
    """

    def __init__(self, scene: Scene, view: str, weights: Weights, inside: Array) -> None:
        super().__init__(scene, view, weights=weights)
        self.inside = inside
        self.those = Referent(OBJECTS, plural=True)

    def denote(self, referent: Referent, base: Array | None = None, *, carrying: bool = False) -> Denotation:
        """Find what a referent means."""
        if referent is self.those:
            return Denotation(self.inside)
        return super().denote(referent, base, carrying=carrying)

    def held(self, noun: Noun) -> Array:
        """Measure how well every one of the objects is what a noun means, shape (n,), in [0, 1]."""
        referent = Reader().refer(noun).having(Condition("those", (self.those,), said="told"))
        found = self.denote(referent)
        inside = found.weights * self.inside
        truth = max((float((case.truth * self.inside).max(initial=0.0)) for case in found.cases if case.masks is None),
                    default=found.truth)  # fmt: skip
        return np.asarray(inside / max(float(inside.max(initial=0.0)), 1e-9) * truth)


def _told(parse: Parse, among: _Among, options: Sequence[Sequence[str]]) -> Answer:
    noun = _described(parse.tree)
    if noun is None or not among.inside.any():
        return Answer("other")
    weights = among.held(noun)
    index = among.scene.layout.index
    held = np.array([min((weights[index[name]] for name in names if name in index), default=0.0) for names in options])
    best, total = float(held.max(initial=0.0)), float(held.sum())
    if best < TRUE:
        return Answer("other")
    order = np.argsort(-held, kind="stable")
    second = float(held[order[1]]) if len(order) > 1 else 0.0
    if best >= TOLD * total and best >= MARGIN * second:
        return Answer("chosen", (int(order[0]),), best / total)
    left = tuple(int(i) for i in np.flatnonzero(held >= _LEFT * best))
    return Answer("narrowed", left, best / total) if len(left) < len(options) else Answer("other")


def _described(tree: Phrase) -> Noun | None:
    """The noun that an answer describes: its own, that of what a clause asks for, or a block with bare modifiers."""
    if tree.tag == "NP":
        return _singular(read_noun(tree))
    for target in targets(tree):
        noun = read_noun(target)
        if noun.head in ("block", "container", "place") and not noun.strange:
            further = tuple(p for p in tree.phrases if p.tag in ("PP", "SBAR", "ADVP", "ADJP"))
            return _singular(replace(noun, modifiers=(*noun.modifiers, *further)))
    if tree.tag in ("PP", "SBAR", "ADVP", "ADJP"):
        return Noun(head="block", modifiers=(tree,))
    modifiers = tuple(p for p in tree.phrases if p.tag in ("PP", "SBAR", "ADVP", "ADJP", "NP"))
    return Noun(head="block", modifiers=modifiers) if tree.tag == "FRAG" and modifiers else None


def _singular(noun: Noun) -> Noun | None:
    """A noun as one of the alternatives: "the left", "the red"."""
    if noun.strange:
        return None
    if noun.head == "place" and not noun.place:
        return replace(noun, head="block")
    return noun if noun.head == "block" else None


def commands(parse: Parse) -> bool:
    """Tells whether a text says what to do, not only which one."""
    verbs = {word for kinds in HANDLING.values() for word in kinds} - {"want", "need", "moved", "put down"}
    return any(leaf.text in verbs and leaf.tag[:2] == "VB" for leaf in parse.tree.leaves)
