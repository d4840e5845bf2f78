"""A clause, taken apart and read: its verbs, and the nouns before and after them."""

from __future__ import annotations

from dataclasses import dataclass, replace

from grounding.language.tree import Phrase
from grounding.meaning.discourse.parts import Parts, is_existential, parts_of
from grounding.meaning.discourse.told import Told, mention, one_of
from grounding.meaning.discourse.verbs import LOOKING, kind_of
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reader import Reader


@dataclass(frozen=True)
class Sentence:
    """A clause, taken apart and read.

    Attributes:
        parts: its parts.
        verbs: its words, the verbs among them.
        kind: of action that they ask for, or None.
        looking: whether it only tells where to look.
        named: its subjects, "there" left out.
        subjects: those of them that can be handled, or stand for it.
        nouns: its objects, those left out that say nothing.
    """

    parts: Parts
    verbs: list[str]
    kind: str | None
    looking: bool
    named: list[Noun]
    subjects: list[Noun]
    nouns: list[Noun]

    def has(self, words: frozenset[str]) -> bool:
        """Whether one of some words is among its own."""
        return any(verb in words for verb in self.verbs)

    @property
    def fresh(self) -> bool:
        """Whether its subject names something rather than pointing back."""
        return bool(self.subjects) and self.subjects[0].head != "pronoun"


def hear(clause: Phrase, reader: Reader, told: Told) -> Sentence:
    """Take a clause apart and read what it names."""
    parts = _chosen_from(parts_of(clause), reader, told)
    verbs = [word.text for word in parts.words]
    looking = any(verb in LOOKING for verb in verbs) or any(is_existential(p) for p in parts.subjects)
    named = [one_of(read_noun(phrase), told) for phrase in parts.named]
    subjects = [noun for noun in named if noun.head in ("block", "pronoun", "container") or _is_part(noun)]
    nouns = [one_of(read_noun(phrase), told) for phrase in parts.objects]
    nouns = [noun for noun in nouns if noun.head != "other" or noun.colors or noun.modifiers
             or reader.context.knows(noun)]  # fmt: skip
    kind = kind_of(verbs, clause)
    if kind == "place" and not subjects and not looking and named and _is_corner(named[0]):
        named[0] = replace(named[0], head="block")
        subjects = named[:1]
    return Sentence(parts, verbs, kind, looking, named, subjects, nouns)


def _is_corner(noun: Noun) -> bool:
    """Whether a bare place stands for what lies there: "the bottom right moves up"."""
    return noun.head == "place" and noun.place is None and bool(noun.directions) and not noun.modifiers


def _chosen_from(parts: Parts, reader: Reader, told: Told) -> Parts:
    """A clause without what it says first that it chooses from: "of the three on the left, the nearest moves"."""
    first = parts.before[0] if parts.before else None
    if first is None or [word.text for word in first.words] != ["of"] or not (parts.subjects or parts.objects):
        return parts
    noun = read_noun(first.phrases[0]) if first.phrases and first.phrases[0].tag == "NP" else None
    if noun is None or not (noun.plural or noun.head == "container"):
        return parts
    mention(noun, reader, told)
    return replace(parts, before=parts.before[1:])


def _is_part(noun: Noun) -> bool:
    """Whether a place is a part of things, which is a thing itself: "the top of the tower"."""
    owners = (p for m in noun.modifiers if [w.text for w in m.words] == ["of"] for p in m.phrases if p.tag == "NP")
    return noun.head == "place" and any(read_noun(p).head in ("block", "container") for p in owners)
