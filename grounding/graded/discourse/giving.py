"""Sentences whose subject gives or gets what is moved: "the tower loses its top", "the row gains a block from X"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from grounding.graded.discourse.parts import Parts
from grounding.graded.discourse.told import is_informative
from grounding.graded.discourse.verbs import (
    BEING,
    COMING,
    GAINING,
    HANDLING,
    HAVING,
    JOINED,
    LOSING,
    MAKING,
    PARTING,
    TAKING,
)
from grounding.language.tree import Phrase, Word
from grounding.lexicon.words import directions
from grounding.meaning.nouns import Noun, read_noun

_FROM = frozenset(("from",))
_BRINGING = frozenset("using claiming moving taking placing stacking putting adding by courtesy".split())
_BEGINNING = frozenset("from using by with coming taking courtesy".split())
_THINGS = ("block", "container", "place")
_WHOLES = frozenset("tower row column group".split())
_POINTING = frozenset("the that this".split())
_MOVING = frozenset(HANDLING["place"])
_OWN = frozenset("its one their".split())


def given(verbs: list[str], parts: Parts, subjects: Sequence[Noun], nouns: Sequence[Noun] = ()) -> Noun | None:
    """What is moved where the subject only gives or gets it; None where it does neither.

    Args:
        verbs: of the clause.
        parts: of the clause.
        subjects: its subjects that name something, read.
        nouns: its objects, read.
    """
    said = set(verbs)
    made = bool(said & MAKING) or bool(subjects and not subjects[0].definite and "forms" in said)
    if made and not any(s.head == "block" for s in subjects):
        return _brought(*parts.objects, *parts.rest)
    if not subjects:
        return None
    subject = subjects[0]
    parted = bool(_WHOLES & set(subject.kinds)) and bool(said & PARTING) and _speaks_of_parts(parts)
    parted = parted and not (nouns and nouns[0].distance)  # "its nearest block" is none of its parts
    if said & LOSING or parted:
        return _part_of(subject, parts, nouns or _owned(parts))
    own = [noun for noun in (*subjects[1:], *nouns) if noun.head == "block" and noun.text.split(" ", 1)[0] in _OWN]
    if said & HAVING and own and said & _MOVING:
        return _part_of(subject, parts, own)  # "the tower has its top block move"
    following = {word.text for phrase in parts.rest[:1] for word in phrase.words}
    joined = bool(said & BEING) and bool(JOINED & (said | following))
    gains = bool(said & GAINING) and (subject.head in ("block", "container") or subject.place is not None)
    comes = bool(said & COMING) and (subject.head == "pronoun" or not is_informative(subject))
    grown = bool(said & BEING) and subject.head != "pronoun" and bool(TAKING & {word.text for word in _leaves(parts)})
    if gains and nouns and nouns[0].head == "block":
        first = nouns[0].text.split(" ", 1)[0]
        if first in _POINTING or (first in _OWN and nouns[0].distance):
            return replace(nouns[0], conjoined=())
        taken = [noun for noun in nouns[1:] if noun.head == "block" and noun.text.split(" ", 1)[0] in _POINTING]
        if taken and said & TAKING:  # "adds a third, taking the block on the left"
            return taken[0]
    return _brought(*parts.objects, *parts.rest) if joined or gains or comes or grown else None


def gained(verbs: list[str], parts: Parts) -> list[Phrase]:
    """Where to, where somebody gives or receives: beside or onto what gains it, or as a further clause tells."""
    clauses = [p for phrase in (*parts.objects, *parts.rest) for p in phrase.preorder() if p.tag == "SBAR"][:1]
    subjects, said = parts.named, set(verbs)
    if not subjects and said & MAKING and parts.objects and read_noun(parts.objects[0]).head == "container":
        where = [p for phrase in parts.rest for p in _without_source(phrase)]
        return [*parts.objects, *where] if where else clauses
    grown = bool(said & BEING) and bool(TAKING & {word.text for word in _leaves(parts)})
    if said & LOSING or not subjects or not (said & GAINING or grown):
        return clauses
    told = [m for p in parts.objects[:1] for m in read_noun(p).modifiers if m.tag == "PP"]
    where = [p for p in (*told, *parts.rest) if p.tag == "PP" and not _BEGINNING & {w.text for w in p.leaves[:2]}]
    sided = any(directions(leaf.text) for p in where for leaf in p.leaves)
    onto = [] if sided else [Phrase("PP", (Word("on", "IN", 0), subjects[0]))]
    return [*onto, *(_of_owner(p, subjects[0]) for p in where), *clauses]


def _without_source(phrase: Phrase) -> list[Phrase]:
    """What a phrase says of a place: all of it, or what follows the thing that it brings there."""
    first = phrase.leaves[0].text
    if first not in _BEGINNING and first not in _BRINGING:
        return [phrase]
    noun = next((p for p in phrase.preorder() if p.tag == "NP" and read_noun(p).head in _THINGS), None)
    if noun is None:
        return []
    return [p for p in phrase.preorder() if p.leaves[0].index == noun.leaves[-1].index + 1][:1]


def _of_owner(phrase: Phrase, owner: Phrase) -> Phrase:
    """A phrase with what "it" and "its" are: "to its left" is to the left of the owner."""
    found: list[Phrase | Word] = []
    for child in phrase.children:
        if not isinstance(child, Phrase):
            found.append(child)
        elif child.tag == "NP" and child.text == "it":
            found.append(owner)
        elif child.tag == "NP" and child.words and child.words[0].text == "its":
            side = Phrase("NP", (replace(child.words[0], text="the", tag="DT"), *child.children[1:]))
            found.append(Phrase("NP", (side, Phrase("PP", (Word("of", "IN", 0), owner)))))
        else:
            found.append(_of_owner(child, owner))
    bare = phrase.tag == "PP" and not any(p.tag == "NP" for p in phrase.preorder())
    return Phrase(phrase.tag, (*found, owner)) if bare else Phrase(phrase.tag, tuple(found))


def _leaves(parts: Parts) -> tuple[Word, ...]:
    return (*parts.words, *(leaf for phrase in (*parts.objects, *parts.rest) for leaf in phrase.leaves))


def _speaks_of_parts(parts: Parts) -> bool:
    """Whether a clause speaks of a part of its subject: "one of its boxes", "one piece"."""
    named = any(leaf.text in _OWN for phrase in parts.objects for leaf in phrase.leaves[:3])
    return named or any(phrase.leaves[0].text in _OWN for phrase in parts.rest[:1])


def _owned(parts: Parts) -> list[Noun]:
    """What is named as a part of the subject within the first adjunct: "its second box" "down a space"."""
    phrases = (p for phrase in parts.rest[:1] for p in phrase.preorder() if p.tag == "NP" and p.leaves[0].text in _OWN)
    return [read_noun(phrase) for phrase in phrases][:1]


def _part_of(subject: Noun, parts: Parts, nouns: Sequence[Noun]) -> Noun:
    """The part of a whole that it gives away: the top, or what is named ("its middle piece")."""
    of_it = Phrase("PP", (Word("of", "IN", 0), parts.named[0]))
    named = nouns[0] if nouns and nouns[0].head == "block" and not nouns[0].plural else None
    if named is not None and (named.directions or named.middle or named.distance or named.ordinals):
        return replace(named, modifiers=(*named.modifiers, of_it), number=None)
    if not _WHOLES & set(subject.kinds):
        return replace(subject, head="block", plural=False)
    return Noun("block", directions=("up",), modifiers=(of_it,), text=subject.text)


def _brought(*phrases: Phrase) -> Noun | None:
    """What "by moving X", "using X", "coming from X" name."""
    found = [part for phrase in phrases for part in phrase.preorder() if part.tag in ("PP", "VP", "S")]
    for words in (COMING, _FROM, _BRINGING):
        for part in found:
            place = next((i for i, c in enumerate(part.children) if isinstance(c, Word) and c.text in words), None)
            after = () if place is None else part.children[place:]
            if after and (noun := _source(Phrase(part.tag, after))) is not None:
                return noun
    return None


def _source(part: Phrase) -> Noun | None:
    """What a phrase says that something comes from: a thing, the top of a tower, what lies in a place."""
    inner = next((p for p in part.preorder() if p.tag == "NP" and read_noun(p).head in _THINGS), None)
    if inner is None:
        way = next((p for p in part.phrases if any(directions(leaf.text) for leaf in p.leaves)), None)
        return None if way is None else Noun("block", modifiers=(way,), text=way.text)
    noun = read_noun(inner)
    if noun.head == "container" and "tower" in noun.kinds and not noun.plural:
        of_it = Phrase("PP", (Word("of", "IN", 0), inner))
        return Noun("block", directions=("up",), modifiers=(of_it,), text=noun.text)
    if noun.head == "place":
        return Noun("block", modifiers=(Phrase("PP", (Word("at", "IN", 0), inner)),), text=noun.text)
    return noun
