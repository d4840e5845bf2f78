"""The parts of a clause: its words, subjects, objects and adjuncts."""

from __future__ import annotations

from dataclasses import dataclass

from grounding.graded.discourse.verbs import BEING
from grounding.language.tree import Phrase, Word
from grounding.meaning.nouns import read_noun


@dataclass(frozen=True)
class Parts:
    """A clause through its nested verb phrases.

    Attributes:
        words: of the clause itself, its verbs among them.
        subjects: noun phrases before its verb, "there" among them.
        objects: noun phrases after its verb.
        before: adjuncts before any noun phrase, where there is one.
        rest: all other adjuncts.
    """

    words: tuple[Word, ...]
    subjects: tuple[Phrase, ...]
    objects: tuple[Phrase, ...]
    before: tuple[Phrase, ...]
    rest: tuple[Phrase, ...]

    @property
    def named(self) -> tuple[Phrase, ...]:
        """The subjects that name something: not "there"."""
        return tuple(phrase for phrase in self.subjects if not is_existential(phrase))

    @property
    def said(self) -> Phrase:
        """The words of a clause by themselves: "stack ... on X" leads elsewhere than "move ... to X"."""
        return Phrase("VP", self.words)

    @property
    def owned(self) -> tuple[Phrase, ...]:
        """Subjects that are a side of what is moved: "its left side touches X"."""
        return tuple(phrase for phrase in self.subjects if phrase.leaves[0].text in ("its", "it's"))


def parts_of(clause: Phrase) -> Parts:
    """Take a clause apart."""
    words: list[Word] = []
    subjects: list[Phrase] = []
    objects: list[Phrase] = []
    before: list[Phrase] = []
    rest: list[Phrase] = []

    def visit(phrase: Phrase) -> None:
        verb = phrase.tag == "VP"
        started = bool(words) and verb
        for child in (unfolded for part in phrase.children for unfolded in _unfolded(part)):
            if not isinstance(child, Phrase):
                words.append(child)
                started = True
            elif child.tag == "NP":
                (objects if verb and started else subjects).append(child)
            elif child.tag in ("VP", "S"):
                visit(child)
            elif child.tag in ("PRT", "INTJ", "WHNP"):
                continue
            else:
                (rest if objects or subjects else before).append(child)

    visit(_upright(clause))
    if not objects and not subjects:
        before, rest = [], before + rest
    return Parts(tuple(words), tuple(subjects), tuple(objects), tuple(before), tuple(rest))


def _upright(clause: Phrase) -> Phrase:
    """What is told in inverse order, as if there were "there": "on the left are two red blocks"."""
    places = [child for child in clause.phrases if child.tag in ("PP", "ADVP")]
    verb = clause.phrases[-1] if clause.phrases else clause
    inverse = clause.tag == "S" and verb.tag == "VP" and places and len(places) + 1 == len(clause.children)
    if not inverse or not isinstance(verb.children[0], Word) or verb.children[0].text not in BEING:
        return clause
    if len(verb.children) < 2 or not isinstance(verb.children[1], Phrase) or verb.children[1].tag != "NP":
        return clause
    there = Phrase("NP", (Word("there", "EX", clause.leaves[0].index),))
    return Phrase("S", (there, Phrase("VP", (*verb.children[:2], *places, *verb.children[2:]))))


def is_existential(phrase: Phrase) -> bool:
    """Whether a noun phrase is the "there" of "there is"."""
    return [word.text for word in phrase.leaves] in (["there"], ["here"])


def _unfolded(part: Phrase | Word) -> tuple[Phrase | Word, ...]:
    """A thing that was read as the measure of a phrase stands before it: "the block" "behind the tower"."""
    if isinstance(part, Phrase) and part.tag == "PP" and len(part.children) > 1:
        first = part.children[0]
        if isinstance(first, Phrase) and first.tag == "NP":
            noun = read_noun(first)
            pointed = noun.definite and first.leaves[0].text in ("the", "that", "this")
            if noun.head in ("block", "container") and pointed:
                return (Phrase("NP", (first, Phrase("PP", part.children[1:]))),)
    return (part,)
