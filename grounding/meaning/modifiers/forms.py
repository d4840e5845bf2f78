"""What a modifier says by its form: a clause, a denial, directions that are joined, a predicate, or one relation."""

from __future__ import annotations

from dataclasses import replace

from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.lexicon import words as w
from grounding.meaning.modifiers.adjoining import steps_from
from grounding.meaning.modifiers.having import having, possessions
from grounding.meaning.modifiers.relating import relate
from grounding.meaning.nouns import Noun, read_noun, read_words
from grounding.meaning.reading import Reads
from grounding.meaning.referents import SETS, Condition
from grounding.meaning.things import own_conditions
from grounding.meaning.wholes import at, whole_of
from grounding.symbols import Ordinal

_CLAUSES = ("SBAR", "S", "VP")
_ADVERBIAL = ("PP", "ADVP", "ADJP", "PRT")
_WORDS_OF_A_VIEW = 6  # a longer phrase that has a word like "side" or "point" tells more than a viewpoint


def read_conditions(reader: Reads, phrase: Phrase, head: Noun) -> list[Condition]:
    """What a modifier says of what a noun speaks of.

    Args:
        reader: that reads the noun phrases within.
        phrase: the modifier.
        head: the noun that it follows.
    """
    if phrase.tag in ("WHNP", "INTJ") or takes_view(phrase):
        return []
    if phrase.tag == "NP":
        return _predicate(reader, phrase, head)
    own = [word.text for word in phrase.words]
    if phrase.tag in _CLAUSES and not any(_relates(text) for text in own):
        return _clause(reader, phrase, head, possessive=any(w.is_having(text) for text in own))
    if any(w.is_negation(text) for text in own):
        return _negated(reader, phrase, head)
    if len(phrase.phrases) > 1 and all(child.tag in _ADVERBIAL for child in phrase.phrases):
        return _joined(reader, phrase.phrases, head)
    return relate(reader, phrase, head)


def takes_view(phrase: Phrase) -> bool:
    """Whether a modifier only names a viewpoint: "from your perspective"."""
    texts = [leaf.text for leaf in phrase.leaves]
    viewed = any(w.is_view(text) for text in texts) and not any(w.directions(t) or w.distance(t) for t in texts)
    return phrase.tag == "PP" and viewed and len(texts) <= _WORDS_OF_A_VIEW


def _relates(text: str) -> bool:
    """Whether a word names a relation itself, so that its phrase is not merely a frame around others."""
    return bool(
        w.is_touching(text) or w.is_between(text) or w.is_surrounded(text) or w.directions(text) or w.distance(text)
        or w.is_beside(text) or any(isinstance(s, Ordinal) for s in meanings(text))
        or text in ("not", "behind", "facing")
    )  # fmt: skip


def _clause(reader: Reads, phrase: Phrase, head: Noun, *, possessive: bool) -> list[Condition]:
    """What the parts of a clause say, its subject left out: "that is next to X", "which has X behind it"."""
    found: list[Condition] = []
    verb = phrase.tag == "VP"
    for child in possessions(phrase.phrases) if verb and possessive else phrase.phrases:
        if child.tag == "NP" and not verb and read_noun(child).head in ("pronoun", "other", "agent"):
            continue
        if child.tag == "NP" and verb and possessive:
            found += having(reader, child)
            continue
        found += reader.conditions(child, head)
    return found


def _negated(reader: Reads, phrase: Phrase, head: Noun) -> list[Condition]:
    kept = tuple(word for word in phrase.words if not w.is_negation(word.text))
    parts = phrase.phrases or ((Phrase(phrase.tag, kept),) if kept else ())  # "that is not red"
    found: list[Condition] = []
    colours = _colours(phrase)
    if colours:
        return [Condition("colour", words=colours, negated=True)]
    for child in parts:
        said = reader.conditions(child, head)
        if child.tag == "NP" and _names_one(read_noun(child), said):
            said = [Condition("same", (reader.refer(read_noun(child)),))]
        found += said
    return [replace(condition, negated=not condition.negated) for condition in found if not condition.ranks]


def _colours(phrase: Phrase) -> tuple[str, ...]:
    """The colours that a phrase denies, where it says nothing else: "neither red nor blue"."""
    rest = [leaf for leaf in phrase.leaves if not w.is_negation(leaf.text) and leaf.tag not in ("VBZ", "VBP", "CC")]
    words = tuple(leaf for leaf in rest if leaf.text not in ("or", "and"))
    said = read_words(words)
    return said.colors if len(said.colors) == len(words) else ()


def _names_one(noun: Noun, said: list[Condition]) -> bool:
    """Whether a noun that is denied names something by more than what it is: "not the red one closest to you"."""
    told = [condition for condition in said if condition.concept not in ("colour", "kind")]
    return noun.head == "block" and noun.definite and bool(told) and not noun.plural


def _joined(reader: Reads, parts: tuple[Phrase, ...], head: Noun) -> list[Condition]:
    """Directions that share a reference: "above and to the left of X"."""
    stepped = steps_from(reader, parts)
    if stepped is not None:
        return stepped
    bare = [part for part in parts if not any(p.tag == "NP" for p in part.preorder())]
    names = tuple(name for part in bare for leaf in part.leaves for name in w.directions(leaf.text))
    referring = [part for part in parts if part not in bare]
    if names and len(referring) == 1:
        return relate(reader, referring[0], head, names)
    return [condition for part in parts for condition in reader.conditions(part, head)]


def _predicate(reader: Reads, phrase: Phrase, head: Noun) -> list[Condition]:
    """A noun phrase that says more of the same thing: "that is the closest one to you"."""
    noun = read_noun(phrase)
    if noun.head in ("agent", "pronoun", "table", "measure") and not noun.lone:
        return []
    if noun.head == "place" and noun.place is None and whole_of(reader, noun) is None and not noun.agent:
        noun = replace(noun, head="block")
    if noun.head == "place":
        reference = reader.refer(noun)
        if reference.sort == SETS:
            return [Condition("member", (reference,))]
        return [] if reference.region is None else [at(reference.region)]
    if noun.head == "block" and noun.plural and noun.modifiers and not noun.colors:
        return [c for m in noun.modifiers for c in reader.conditions(m, head)]  # "two blocks behind X"
    if noun.head in ("block", "other") and not noun.conjoined:
        own = replace(noun, head="block", plural=False)
        if not (own.middle or own.lone or own.other):
            return _said_of(reader, own)
        return [Condition("same", (replace(reader.refer(own), like=True),))]
    return [Condition("same", (reader.refer(noun),))]


def _said_of(reader: Reads, noun: Noun) -> list[Condition]:
    """What a predicate adds: its conditions, whose ranks select among what all others leave."""
    found = own_conditions(reader, noun)
    ranks = [condition for condition in found if condition.ranks and condition.concept != "ordinal"]
    if len(noun.ordinals) > sum(condition.rank is None for condition in ranks):
        return [Condition("same", (replace(reader.refer(noun), like=True),))]
    ordinals = list(noun.ordinals)
    kept: list[Condition] = []
    for condition in found:
        if condition.concept == "ordinal":
            continue
        if condition.ranks and condition.rank is None and ordinals:
            condition = replace(condition, rank=ordinals.pop(0))
        kept.append(condition)
    return kept
