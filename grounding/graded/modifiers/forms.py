"""What a modifier does by its form: a clause, a negation, directions that are joined, a predicate, or one relation."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from grounding.graded.modifiers.adjoining import steps_from
from grounding.graded.modifiers.having import having, possessions
from grounding.graded.modifiers.nouns import with_modifiers
from grounding.graded.modifiers.relating import relate
from grounding.graded.place_phrases import read_place, whole_of
from grounding.graded.places import located
from grounding.graded.selectors import adjectives
from grounding.graded.values import SETS, Effect, Membership, Rank, Restriction
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.lexicon import colour, degrees
from grounding.lexicon import words as w
from grounding.meaning.nouns import Noun, read_noun
from grounding.symbols import Ordinal
from grounding.world import Array

if TYPE_CHECKING:
    from grounding.graded.reader import Reader

_CLAUSES = ("SBAR", "S", "VP")
_ADVERBIAL = ("PP", "ADVP", "ADJP", "PRT")
_NEGATING = frozenset("not n't isn't without except".split())
_HAVING = frozenset("has have having".split())
_RELATING = frozenset("not behind facing".split())
_WORDS_OF_A_VIEW = 6  # a longer phrase that has a word like "side" or "point" tells more than a viewpoint


def read_effects(reader: Reader, phrase: Phrase, base: Array) -> list[Effect]:
    """What a modifier does to the objects of the noun that it follows.

    Args:
        reader: that reads the noun phrases within.
        phrase: the modifier.
        base: how well every object agrees with the noun, shape (n,).
    """
    if phrase.tag in ("WHNP", "INTJ") or _takes_view(phrase):
        return []
    if phrase.tag == "NP":
        return _predicate(reader, phrase, base)
    own = [word.text for word in phrase.words]
    if phrase.tag in _CLAUSES and not any(_relates(text) for text in own):
        return _clause(reader, phrase, base, possessive=not _HAVING.isdisjoint(own))
    if not _NEGATING.isdisjoint(own):
        return _negated(reader, phrase, base)
    if len(phrase.phrases) > 1 and all(child.tag in _ADVERBIAL for child in phrase.phrases):
        return _joined(reader, phrase.phrases, base)
    return relate(reader, phrase, base)


def _takes_view(phrase: Phrase) -> bool:
    """Whether a modifier only names a viewpoint: "from your perspective"."""
    texts = [leaf.text for leaf in phrase.leaves]
    viewed = any(w.is_view(text) for text in texts) and not any(w.directions(t) or w.distance(t) for t in texts)
    return phrase.tag == "PP" and viewed and len(texts) <= _WORDS_OF_A_VIEW


def _relates(text: str) -> bool:
    """Whether a word names a relation itself, so that its phrase is not merely a frame around others."""
    return bool(
        w.is_touching(text) or w.is_between(text) or w.is_surrounded(text) or w.directions(text) or w.distance(text)
        or w.is_beside(text) or any(isinstance(s, Ordinal) for s in meanings(text))
        or text in _RELATING
    )  # fmt: skip


def _clause(reader: Reader, phrase: Phrase, base: Array, *, possessive: bool) -> list[Effect]:
    """What the parts of a clause do, its subject left out: "that is next to X", "which has X behind it"."""
    found: list[Effect] = []
    verb = phrase.tag == "VP"
    for child in possessions(phrase.phrases) if verb and possessive else phrase.phrases:
        if child.tag == "NP" and not verb and read_noun(child).head in ("pronoun", "other", "agent"):
            continue
        if child.tag == "NP" and verb and possessive:
            found += having(reader, child)
            continue
        found += reader.effects(child, base)
    return found


def _negated(reader: Reader, phrase: Phrase, base: Array) -> list[Effect]:
    found: list[Effect] = []
    kept = tuple(word for word in phrase.words if word.text not in _NEGATING)
    parts = phrase.phrases or ((Phrase(phrase.tag, kept),) if kept else ())  # "that is not red"
    for child in parts:
        for effect in reader.effects(child, base):
            if isinstance(effect, Restriction):
                found.append(Restriction(1.0 - effect.weights))
            elif isinstance(effect, Membership):
                inside = np.zeros(reader.scene.n)
                for mask, chance in effect.sets[:SETS]:
                    inside = np.maximum(inside, mask * chance)
                found.append(Restriction(1.0 - inside))
    return found


def _joined(reader: Reader, parts: tuple[Phrase, ...], base: Array) -> list[Effect]:
    """Directions that share a reference: "above and to the left of X"."""
    stepped = steps_from(reader, parts, base)
    if stepped is not None:
        return stepped
    bare = [part for part in parts if not any(p.tag == "NP" for p in part.preorder())]
    names = tuple(name for part in bare for leaf in part.leaves for name in w.directions(leaf.text))
    referring = [part for part in parts if part not in bare]
    if names and len(referring) == 1:
        return relate(reader, referring[0], base, names)
    return [effect for part in parts for effect in reader.effects(part, base)]


def _predicate(reader: Reader, phrase: Phrase, base: Array) -> list[Effect]:
    """A noun phrase that says more of the same thing: "that is the closest one to you"."""
    noun = read_noun(phrase)
    if noun.head in ("agent", "pronoun", "table", "measure") and not noun.lone:
        return []
    if noun.head == "place" and noun.place is None and whole_of(reader, noun) is None and not noun.agent:
        noun = replace(noun, head="block")
    if noun.head == "place":
        value = read_place(reader, noun)
        return [Membership(value.sets, value.kinds)] if value.kind == "sets" else located(reader.scene, value, base)
    if noun.head == "block" and noun.plural and noun.modifiers and not noun.colors:
        return [e for m in noun.modifiers for e in reader.effects(m, base)]  # "two blocks behind X"
    if noun.head in ("block", "other") and not noun.conjoined:
        own = replace(noun, head="block", plural=False)
        if not (own.middle or own.lone or own.other):
            return _said_of(reader, own, base)
        value = reader.chosen(own, base * colour.truth(reader.scene, own.colors))
    else:
        value = reader.noun(noun)
    if value.kind == "objects" and value.weights.any():
        return [Restriction(value.weights / degrees.peak(value.weights))]
    return []


def _said_of(reader: Reader, noun: Noun, base: Array) -> list[Effect]:
    """What a predicate adds: its restrictions, and its ranks, which select among what all others leave."""
    own = base * colour.truth(reader.scene, noun.colors)
    bare, effects = with_modifiers(reader, noun, own)
    ranks = [effect for effect in effects if isinstance(effect, Rank)]
    ranks += adjectives(reader.scene, reader.view, bare, own)
    ordinals = list(bare.ordinals)
    if len(ordinals) > sum(rank.ordinal is None for rank in ranks):
        weights = reader.chosen(noun, own).weights
        return [Restriction(weights / degrees.peak(weights))]
    found: list[Effect] = [effect for effect in effects if not isinstance(effect, Rank)]
    if noun.colors:
        found.append(Restriction(colour.truth(reader.scene, noun.colors)))
    for rank in ranks:
        found.append(replace(rank, ordinal=ordinals.pop(0)) if rank.ordinal is None and ordinals else rank)
    return found
