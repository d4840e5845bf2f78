"""The clauses of a text: commands that run into each other are parted."""

from __future__ import annotations

from grounding.language.tree import Phrase, Word
from grounding.meaning.discourse.mending import as_sentence, mended
from grounding.meaning.discourse.parts import is_existential
from grounding.meaning.discourse.verbs import BEING, HANDLING, MAKING, is_verbal, plain_form

_KEPT = "clauses"


def clauses_of(tree: Phrase) -> tuple[Phrase, ...]:
    """The clauses of a text, in order. They are kept with the tree, which is immutable."""
    kept: dict[str, tuple[Phrase, ...]] = tree.__dict__
    if _KEPT not in kept:
        kept[_KEPT] = tuple(_possessed(as_sentence(clause)) for clause in _clauses(mended(tree)))
    return kept[_KEPT]


def _possessed(clause: Phrase) -> Phrase:
    """The sentence "the corner 's block moves" was read as one on the corner; it is one on the corner's block."""
    if clause.tag != "S" or len(clause.children) < 2:
        return clause
    owner, verb = clause.children[0], clause.children[1]
    if not (isinstance(owner, Phrase) and owner.tag == "NP" and isinstance(verb, Phrase) and verb.tag == "VP"):
        return clause
    if is_existential(owner):
        return clause  # "there 's three of them"
    if len(verb.children) < 2 or not isinstance(verb.children[0], Word) or verb.children[0].text != "'s":
        return clause
    rest = verb.children[1:]
    if isinstance(rest[0], Phrase) and rest[0].tag == "S":
        rest = (*rest[0].children, *rest[1:])
    thing = rest[0]
    if not (isinstance(thing, Phrase) and thing.tag == "NP") or thing.leaves[0].tag == "DT":
        return clause
    of = Phrase("PP", (Word("of", "IN", owner.leaves[-1].index), owner))
    return Phrase("S", (Phrase("NP", (thing, of)), *rest[1:]))


def _clauses(tree: Phrase) -> list[Phrase]:
    if tree.tag == "FRAG":
        return _clauses_below(tree.phrases)
    if tree.tag == "S" and tree.children and isinstance(tree.children[0], Phrase) and is_existential(tree.children[0]):
        command = next((p for p in tree.preorder() if p.tag == "VP" and _commands(p)), None)
        if command is not None:
            following = Phrase("VP", tuple(c for c in command.children if c not in _leading(command)))
            return [_without(tree, command), *_clauses(following)]
    way = _way_of_making(tree)
    if way is not None:
        return _clauses(way)
    if tree.tag == "VP":
        place = next((i for i, child in enumerate(tree.children) if i > 1 and _is_coordinate(tree, i, child)), None)
        if place is not None:
            head = Phrase("VP", tuple(tree.children[:place]))
            further = [child for child in tree.phrases if child in tree.children[place:]]
            return [*_clauses(head), *_clauses_below(further)]
    tags = [child.tag for child in tree.phrases]
    if tree.tag in ("VP", "S") and sum(tag in ("VP", "S") for tag in tags) > 1 and "NP" not in tags:
        return _clauses_below(tree.phrases)
    return [tree]


def _way_of_making(tree: Phrase) -> Phrase | None:
    """What is to be done so that something comes about: "make a tower by putting X on Y" asks to put X on Y."""
    making = tree.tag in ("VP", "S") and any(word.text in MAKING for word in tree.leaves[:1])
    for phrase in tree.preorder() if making else ():
        head = phrase.children[0]
        if phrase.tag == "VP" and isinstance(head, Word) and any(child.tag == "NP" for child in phrase.phrases):
            verb = plain_form(head.text)
            if verb is not None:
                return Phrase("VP", (Word(verb, "VB", head.index), *phrase.children[1:]))
    return None


def _clauses_below(phrases: tuple[Phrase, ...] | list[Phrase]) -> list[Phrase]:
    return [clause for phrase in phrases for clause in _clauses(phrase)]


def _commands(phrase: Phrase) -> bool:
    """Whether a verb phrase has a verb of handling itself, with an object."""
    verbs = any(word.text in words for word in phrase.words for words in HANDLING.values() if word.text not in BEING)
    return verbs and any(child.tag == "NP" for child in phrase.phrases)


def _leading(command: Phrase) -> tuple[Phrase, ...]:
    """What stands before the verb of a command: it belongs to what was said before."""
    found = []
    for child in command.children:
        if not isinstance(child, Phrase):
            break
        found.append(child)
    return tuple(found)


def _without(tree: Phrase, command: Phrase) -> Phrase:
    """A clause without the command that ran into it, which leaves what stands before its verb."""
    children: list[Phrase | Word] = []
    for child in tree.children:
        if child is command:
            children += _leading(command)
        elif isinstance(child, Phrase):
            children.append(_without(child, command))
        else:
            children.append(child)
    return Phrase(tree.tag, tuple(children))


def _is_coordinate(parent: Phrase, place: int, child: Phrase | Word) -> bool:
    """Whether a child is a further command: a verb phrase after "and", behind an object."""
    if not isinstance(child, Phrase) or child.tag != "VP":
        return False
    before = parent.children[place - 1]
    joined = not isinstance(before, Phrase) and before.tag in ("CC", "RB", ",")
    named = any(isinstance(c, Phrase) and c.tag == "NP" for c in parent.children[:place])
    return joined and named and any(is_verbal(word.text) for word in child.words)
