"""What every phrase of a tree means among the objects."""

from __future__ import annotations

import numpy as np

from grounding.explanations.meanings import Meanings
from grounding.explanations.values import Objects, PhraseExplained, Weighed
from grounding.language.tree import Phrase
from grounding.lexicon import place
from grounding.meaning.nouns import Noun, is_measuring, read_noun
from grounding.meaning.reader import Reader
from grounding.meaning.referents import NOTHING, OBJECTS, PERSON, PLACE, TABLE, Referent
from grounding.model.belief import Belief
from grounding.model.cases import Denotation
from grounding.model.phrases import PhraseReader
from grounding.phrases import walk
from grounding.result import Grounding
from grounding.world import Array
from grounding.world.scene import ROBOT, SPEAKER

_CLAUSES = ("VP", "S", "SBAR", "FRAG")


def explained_phrases(
    tree: Phrase, meanings: Meanings | None, belief: Belief, result: Grounding
) -> tuple[PhraseExplained, ...]:
    """What every phrase means, outer ones first.

    Args:
        tree: that was taken.
        meanings: of the reading; None where the text speaks of nothing.
        belief: of the text, for the phrase that is all of it.
        result: the answer, with the symbols of its phrases.
    """
    symbols = {(p.tag, p.words, p.depth): p.groundings for p in result.phrases}
    found = []
    for phrase, depth in walk(tree):
        weighed = None
        if meanings is not None:
            weighed = _whole(meanings, belief) if depth == 0 and phrase.tag in _CLAUSES else _weighed(phrase, meanings)
        key = (phrase.tag, span_of(phrase), depth)
        found.append(PhraseExplained(phrase.text, phrase.tag, key[1], depth, symbols.get(key, ()), weighed))
    return tuple(found)


def span_of(phrase: Phrase) -> tuple[int, int]:
    """The places of a phrase's first and last word."""
    return phrase.leaves[0].index, phrase.leaves[-1].index


def _whole(meanings: Meanings, belief: Belief) -> Weighed:
    """What the text is believed to mean."""
    ids = meanings.evaluator.scene.layout.ids
    options: list[tuple[Objects, float]] = [(names, share) for names, share in belief.options if names]
    weights = dict.fromkeys(ids, 0.0)
    for names, share in options:
        for name in names:
            weights[name] = min(1.0, weights[name] + share)
    several = any(len(names) > 1 for names, _ in options[:1])
    return Weighed("sets" if several else "objects", tuple(options[:4]), weights)


def _weighed(phrase: Phrase, meanings: Meanings) -> Weighed | None:
    if phrase.tag == "NP":
        noun = read_noun(phrase)
        if is_measuring(noun):
            return None
        referent = _known(phrase.text, meanings) or _read(noun, meanings)
        return _of(referent, meanings.denotation(referent), meanings)
    if phrase.tag in _CLAUSES or not phrase.phrases and phrase.tag != "ADJP":
        return None
    reader = Reader(PhraseReader(meanings.evaluator, meanings.reading.told.mentioned).context)
    conditions = tuple(reader.conditions(phrase, Noun(head="block")))
    if not conditions:
        return None
    if len(conditions) == 1 and conditions[0].chooses:
        inner = conditions[0].of[0]
        return _of(inner, meanings.denotation(inner), meanings)
    referent = Referent(OBJECTS, conditions, text=phrase.text)
    cases = meanings.evaluator.cases(referent)
    held = np.max([case.truth for case in cases], axis=0) if cases else np.zeros(meanings.evaluator.scene.n)
    return _weights("degree", held, meanings)


def _known(text: str, meanings: Meanings) -> Referent | None:
    """The referent of the meaning that has the words of a phrase."""
    found = [line.referent for line in meanings.lines if line.condition is None and line.referent.text == text]
    things = [referent for referent in found if referent.sort != PERSON or len(found) == 1]
    return next(iter(things), None)


def _read(noun: Noun, meanings: Meanings) -> Referent:
    told = meanings.reading.told
    return PhraseReader(meanings.evaluator, told.mentioned, several=told.plural).noun(noun).referent


def _of(referent: Referent, denotation: Denotation, meanings: Meanings) -> Weighed | None:
    match referent.sort:
        case s if s == PERSON:
            return Weighed("person", note="the speaker" if referent.person == SPEAKER else "the robot")
        case s if s == TABLE:
            return Weighed("table", note="the table")
        case s if s == NOTHING:
            return Weighed("nothing")
        case s if s == PLACE:
            return _place(referent, meanings)
    scene = meanings.evaluator.scene
    weights = dict(zip(scene.layout.ids, map(float, denotation.weights), strict=True))
    return Weighed("sets" if denotation.sets else "objects", meanings.likely(denotation), weights)


def _place(referent: Referent, meanings: Meanings) -> Weighed | None:
    if referent.region is None or not meanings.evaluator.scene.n:
        return Weighed("place")
    evaluator, owner = meanings.evaluator, referent.region.owner
    held = place.truth(evaluator.scene, evaluator.spot(referent.region))
    sided = f"as the {owner or ROBOT} sees it" if owner is not None else ""
    return _weights("place", held, meanings, sided)


def _weights(kind: str, held: Array, meanings: Meanings, note: str = "") -> Weighed:
    ids = meanings.evaluator.scene.layout.ids
    weights = dict(zip(ids, (float(min(max(degree, 0.0), 1.0)) for degree in held), strict=True))
    likely = sorted(((name,) for name in ids if weights[name] > 0.005), key=lambda n: (-weights[n[0]], n))
    return Weighed(kind, tuple((names, weights[names[0]]) for names in likely[:4]), weights, note)
