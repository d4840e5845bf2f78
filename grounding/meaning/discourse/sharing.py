"""Which phrases of a command say what is meant, and which say where to: "the block" "behind the tower" "onto X"."""

from __future__ import annotations

from typing import Protocol

from grounding.language.tree import Phrase
from grounding.meaning.discourse.told import is_informative, with_further
from grounding.meaning.nouns import Noun

_LEADING = frozenset("to onto into toward towards over so until up down".split())


class ToldBefore(Protocol):
    """What matters here of what was told before."""

    continued: bool

    @property
    def mentioned(self) -> object | None:
        """What was spoken of last."""


def shared_out(noun: Noun, rest: list[Phrase], told: ToldBefore) -> tuple[Noun, list[Phrase]]:
    """The adjuncts of a command that say which object is meant go to its noun; the others say where to."""
    if len(rest) > 1 and rest[0].tag == "PP" and noun.head == "block" and not is_informative(noun):
        noun = with_further(noun, rest.pop(0))
    fresh = noun.head != "pronoun"
    if len(rest) == 1 and rest[0].tag == "PP" and _is_bare(noun) and told.mentioned is None:
        parted = _parted(rest[0])
        if parted is not None:
            noun, rest = with_further(noun, parted[0]), [parted[1]]
    resulting = len(rest) > 1 and rest[0].tag == "PP" and not _leads(rest[0]) and _results(rest[-1])
    if fresh and resulting and not _is_told_apart(noun, rest[0]):
        noun = with_further(noun, rest.pop(0))
    while told.continued and rest and rest[0].tag in ("PP", "SBAR"):
        if is_informative(noun) and _leads(rest[0]):
            break
        noun = with_further(noun, rest.pop(0))
    return noun, rest


def _is_bare(noun: Noun) -> bool:
    """Whether a noun only says "the block"."""
    return noun.head == "block" and noun.definite and not noun.plural and not is_informative(noun)


def _parted(phrase: Phrase) -> tuple[Phrase, Phrase] | None:
    """A phrase without what it took in at its end, and that: "below the pair" "on top of X"; None for others."""
    last = phrase.children[-1]
    if not isinstance(last, Phrase):
        return None
    deeper = _parted(last)
    if deeper is not None:
        return Phrase(phrase.tag, (*phrase.children[:-1], deeper[0])), deeper[1]
    texts = [leaf.text for leaf in last.leaves[:3]]
    onto = last.tag == "PP" and (texts[0] in ("onto", "atop") or texts[:2] == ["on", "top"])
    if phrase.tag == "NP" and len(phrase.children) > 1 and (onto or _results(last)):
        kept = phrase.children[:-1]
        return (kept[0] if len(kept) == 1 and isinstance(kept[0], Phrase) else Phrase(phrase.tag, kept)), last
    return None


def _is_told_apart(noun: Noun, phrase: Phrase) -> bool:
    """Whether a noun says enough for the phrase after it to tell where to: "the block on the left" "above X"."""
    bare = not any(part.tag == "NP" for part in phrase.preorder())
    return bool(noun.modifiers) or (bare and bool(noun.directions) and not noun.ordinals)


def _results(phrase: Phrase) -> bool:
    """Whether a phrase tells what shall be the case afterwards: "so that it is ..."."""
    return phrase.tag == "SBAR" and any(leaf.text in ("so", "until") for leaf in phrase.leaves[:2])


def _leads(phrase: Phrase) -> bool:
    """Whether a phrase tells where to go: "to the right", "down two"."""
    first = phrase.leaves[0].text
    return first in _LEADING or first.isdigit()
