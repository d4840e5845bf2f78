"""Questions about the world: is something there, how many are there, which is it, where, on what, of what colour."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from grounding.distinguishing import Describer
from grounding.language.parser import Parser
from grounding.language.tree import Phrase
from grounding.lexicon import arrangement
from grounding.lexicon import words as w
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reader import Reader
from grounding.meaning.referents import SETS, Referent
from grounding.model.cases import Weights
from grounding.model.evaluator import Evaluator
from grounding.model.surroundings import context_in
from grounding.numbers import listed, spelled
from grounding.result import Grounding
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene

TRUE = 0.5
"""What is less true than this is not so."""
ALIKE = 0.9
LIKELY = 0.5
"""Of what is asked about, all that are so likely as the best are told; of what is ranked those that are alike."""
_OPENING = r"^(?:(?:please|hey|hi|so|ok|okay|robot|baxter),? )*(?:(?:can|could) you )?(?:(?:please )?tell me,? )?"
_BE = r"(?:is|are|'s|was|were)"
_SEEING = r"(?:(?:do|can|could) you (?:see|have|find)|does (?:the )?(?:table|world|robot|scene) have|have you got)"
_ON = r"(?:(?:standing|sitting|lying|resting|stacked|placed)\s+)?(?:on|upon|on top of)"
_THERE = r"(?:\s+(?:are there|is there|do you see|can you see|do you have))?"
_HERE = r"(?:\s+(?:here|there|on the table|in total))*"
_GOING_ON = re.compile(r"[?.!;]\s*(?=[^\W\d_]{2})(?!(?:please|thanks|thank you|robot|baxter)\b)", re.IGNORECASE)
_FORMS: tuple[tuple[str, str], ...] = (
    ("count", rf"how many (?P<what>(?:(?!{_BE} there)\S+ )+?)(?P<be>{_BE}) (?!there)(?P<how>.+)"),
    ("count", rf"how many (?P<what>.+?){_THERE}{_HERE}"),
    ("colour", rf"(?:what|which) colou?r {_BE} (?P<what>.+)"),
    ("below", rf"(?:what|which \w+) {_BE} (?P<what>.+?) {_ON}(?: top)?(?: of)?"),
    ("below", r"(?:on )?what (?:does|do) (?P<what>.+?) (?:stand|sit|lie|rest)(?: on)?"),
    ("above", rf"what {_BE} {_ON}(?: top of)? (?P<what>.+)"),
    ("where", rf"where {_BE} (?P<what>.+)"),
    ("which", rf"(?:which|what)(?: of (?:the|these|those))? (?P<what>.+?) (?P<be>{_BE}) (?P<how>.+)"),
    ("which", rf"(?:which|what) {_BE} (?P<what>the .+)"),
    ("exists", rf"(?:{_BE} there|{_SEEING}) (?:a |an |any |some )?(?P<what>.+?)(?: here| there)?"),
    ("holds", rf"(?P<be>{_BE}) (?P<what>(?:the|that|this) .+)"),
)


@dataclass(frozen=True)
class Inquiry:
    """A question about the world.

    Attributes:
        kind: exists, count, which, where, below (what it stands on), above (what stands on it), colour or holds.
        what: the words for what it is about.
        how: what is asked whether it holds of that; "" for other questions.
    """

    kind: str
    what: str
    how: str = ""


def inquiry_of(text: str) -> Inquiry | None:
    """The question that a text asks about the world, None for texts that ask for something to be done.

    Args:
        text: of a person.
    """
    if _GOING_ON.search(text):
        return None  # "do you see the tower? take its top": a question that only introduces what is spoken of
    plain = re.sub(r"\s+", " ", text.strip().lower().replace("\u2019", "'")).rstrip(" ?.!")
    plain = re.sub(r"\b(what|where|which|who)'s\b", r"\1 is", re.sub(_OPENING, "", plain))
    for kind, form in _FORMS:
        match = re.fullmatch(form, plain)
        if match:
            return _told(kind, match.groupdict())
    return None


def _told(kind: str, said: Mapping[str, str]) -> Inquiry | None:
    what, how = said["what"].strip().removeprefix("the "), said.get("how", "")
    if kind == "holds":
        subject, how = _parted(said["what"].split())
        return Inquiry(kind, subject, how) if how else None
    if not how:
        return Inquiry(kind, said["what"])
    if said["be"] in ("is", "'s") and what.endswith("s"):
        what = what[:-1]  # "which of the blocks is"
    return Inquiry(kind, f"the {what} that {said['be']} {how}")


def _parted(words: Sequence[str]) -> tuple[str, str]:
    """A subject, which ends with a word for a thing, and what is asked of it."""
    ends = (i for i, word in enumerate(words) if w.is_block(word) or w.containers(word))
    end = next(ends, len(words) - 1) + 1
    return " ".join(words[:end]), " ".join(words[end:])


def answered(text: str, inquiry: Inquiry, parser: Parser, scene: Scene, weights: Weights) -> Grounding:
    """Answer a question from what the words mean in the world.

    Args:
        text: as it was asked.
        inquiry: that it is.
        parser: of the words for what it is about.
        scene: the world.
        weights: of the features of what is referred to.
    """
    parse = parser.parse(inquiry.what, 1)[0]
    phrase = next((p for p in parse.tree.preorder() if p.tag == "NP"), parse.tree)
    asked = _Asked(scene, phrase, weights)
    if inquiry.how:
        said = parser.parse(f"things that are {inquiry.how}", 1)[0]
        asked.predicate = next((p for p in said.tree.preorder() if p.tag == "NP"), said.tree)
    if not asked.names_something:
        return Grounding(text, "not_understood", explanation=f"I do not know what {inquiry.what!r} is",
                         unknown_words=parse.unknown_words)  # fmt: skip
    told = _ANSWERS[inquiry.kind](asked)
    return Grounding(text, "answered", answer=told, unknown_words=parse.unknown_words)


class _Asked:
    """What a question is about, in a scene."""

    def __init__(self, scene: Scene, phrase: Phrase, weights: Weights) -> None:
        self.scene = scene
        self.noun = read_noun(phrase)
        self.text = phrase.text
        self.evaluator = Evaluator(scene, ROBOT, weights=weights)
        self.context = context_in(scene)
        self.referent: Referent = Reader(self.context).refer(self.noun)
        self.names_something = self.noun.head in ("block", "container") or self.context.knows(self.noun)
        self.predicate: Phrase | None = None
        self.describer = Describer(scene, weights)

    def truths(self) -> Array:
        """How well every object is one of those that are spoken of, shape (n,), alone and without ranks."""
        single = Reader(self.context).refer(_singular(self.noun))
        found = [case.truth for case in self.evaluator.cases(single) if case.masks is None]
        return np.max(found, axis=0) if found else np.zeros(self.scene.n)

    def arranged(self) -> list[arrangement.Candidate]:
        """The arrangements that are spoken of, those that share members once."""
        denoted = self.evaluator.denote(self.referent)
        fits = [arrangement.Candidate(mask, chance, "") for mask, chance in denoted.sets if chance >= LIKELY]
        return _apart(fits) if denoted.truth >= TRUE else []

    def meant(self) -> list[int]:
        """The objects that are likely meant."""
        denoted = self.evaluator.denote(self.referent)
        if denoted.truth < TRUE:
            return []
        if self.referent.sort == SETS and denoted.sets:
            return [int(i) for i in np.flatnonzero(denoted.sets[0][0])]
        ranked = any(condition.ranks for condition in self.referent.conditions)
        least = ALIKE if ranked else LIKELY
        return [int(i) for i in np.flatnonzero(denoted.weights >= least * denoted.weights.max(initial=0.0))]

    def name(self, index: int) -> str:
        """What an object is called for people."""
        return self.describer.describe(self.scene.layout.ids[index]).text

    def names(self, members: Sequence[int]) -> str:
        """What objects are called for people."""
        return listed([self.name(i) for i in members])

    def stands_on(self, index: int) -> str:
        """What an object stands on."""
        for tower in self.scene.towers:
            place = tower.index(index) if index in tower else 0
            if place:
                return self.name(tower[place - 1])
        return "the table"


def _singular(noun: Noun) -> Noun:
    return replace(noun, plural=False, number=None, universal=False, definite=False)


def _apart(found: Sequence[arrangement.Candidate]) -> list[arrangement.Candidate]:
    kept: list[arrangement.Candidate] = []
    for candidate in found:
        if not any((candidate.mask & other.mask).any() for other in kept):
            kept.append(candidate)
    return kept


def _number(asked: _Asked) -> int:
    if asked.noun.head == "container":
        return len(asked.scene.towers) if asked.noun.kinds == ("tower",) and not asked.noun.colors else len(
            asked.arranged())  # fmt: skip
    return int((asked.truths() >= TRUE).sum())


def _exists(asked: _Asked) -> str:
    sets = asked.noun.head == "container"
    count, wanted = _number(asked), 1 if sets and not asked.noun.plural else asked.noun.number or 1
    if count >= wanted:
        told = f", {_are(count)}" if count > 1 or asked.noun.plural else ""
        which = [] if sets else [int(i) for i in np.flatnonzero(asked.truths() >= TRUE)]
        return f"yes{told}" if len(which) != 1 else f"yes, {asked.name(which[0])}"
    return f"no, {_are(count)}" if count else f"no, there {'are' if asked.noun.plural else 'is'} no {_bare(asked)}"


def _count(asked: _Asked) -> str:
    return _are(_number(asked))


def _which(asked: _Asked) -> str:
    found = asked.meant()
    return asked.names(found) if found else f"none: {_nothing(asked)}"


def _where(asked: _Asked) -> str:
    found = asked.meant()
    if not found:
        return f"nowhere: {_nothing(asked)}"
    places = []
    for i in found:
        x, y = asked.scene.xy[i]
        places.append(f"{asked.name(i)} is on {asked.stands_on(i)} at x = {x:.2f} m, y = {y:.2f} m")
    return "; ".join(places)


def _below(asked: _Asked) -> str:
    found = asked.meant()
    if not found:
        return _nothing(asked)
    return "; ".join(f"{asked.name(i)} is on {asked.stands_on(i)}" for i in found)


def _above(asked: _Asked) -> str:
    found = asked.meant()
    if not found:
        return _nothing(asked)
    told = []
    for i in found:
        upper = [tower[tower.index(i) + 1 :] for tower in asked.scene.towers if i in tower]
        members = [j for tower in upper for j in tower]
        told.append(f"{asked.names(members)} {'is' if len(members) == 1 else 'are'} on {asked.name(i)}" if members
                    else f"nothing is on {asked.name(i)}")  # fmt: skip
    return "; ".join(told)


def _colour(asked: _Asked) -> str:
    found = asked.meant()
    colours = list(dict.fromkeys(asked.scene.layout.things[i].color for i in found))
    return listed(colours) if colours else _nothing(asked)


def _holds(asked: _Asked) -> str:
    found = asked.meant()
    if not found:
        return _nothing(asked)
    assert asked.predicate is not None
    held = _Asked(asked.scene, asked.predicate, asked.evaluator.weights).truths()
    true = [i for i in found if held[i] >= TRUE]
    if len(true) == len(found):
        return "yes"
    return f"only {asked.names(true)}" if true else "no"


def _nothing(asked: _Asked) -> str:
    return f"nothing here is {asked.text!r}"


def _are(count: int) -> str:
    return f"there {'is' if count == 1 else 'are'} {spelled(count) if count else 'none'}"


def _bare(asked: _Asked) -> str:
    return re.sub(r"^(?:a|an|any|the|some) ", "", asked.text)


_ANSWERS: dict[str, Callable[[_Asked], str]] = {
    "exists": _exists, "count": _count, "which": _which, "where": _where, "below": _below, "above": _above,
    "colour": _colour, "holds": _holds,
}  # fmt: skip
