"""What was handled before, and how people speak of it: "the block you just moved", "the same block", "another one"."""

from __future__ import annotations

from grounding.language.tree import Phrase
from grounding.lexicon.vocabulary import vocabulary
from grounding.meaning.nouns import Noun, read_noun

_HANDLED = vocabulary().words("handled")
_RECENT = vocabulary().words("recency")
_PAST = _RECENT - {"you"}
_SAME = vocabulary().words("recall")
POINTING = vocabulary().words("pointing")
_THINGS = ("block", "container", "place", "table")
_CLAUSES = ("SBAR", "S", "VP", "PP", "ADJP")


def is_recalled(noun: Noun) -> bool:
    """Whether a noun phrase means what was handled before."""
    if noun.head != "block" or noun.plural or noun.other:
        return False
    if _SAME & set(noun.unknown) or tells_of_handling(noun):
        return True
    told = (noun.colors, noun.modifiers, noun.directions, noun.ordinals, noun.distance, noun.middle, noun.lone)
    return noun.text.split(" ", 1)[0] in POINTING and not any(told)


def tells_of_handling(noun: Noun) -> bool:
    """Whether a noun phrase says that its object was handled: "the block you just moved"."""
    return noun.head == "block" and any(_tells_of_handling(modifier) for modifier in noun.modifiers)


def is_surely_recalled(noun: Noun) -> bool:
    """Whether a noun phrase can mean nothing else than what was handled: "the block you just moved"."""
    texts = {leaf.text for modifier in noun.modifiers for leaf in modifier.leaves}
    return tells_of_handling(noun) and bool(_PAST & texts)


def _tells_of_handling(phrase: Phrase) -> bool:
    """Whether a modifier tells what was done: "you just moved", "that was moved", "from before"; not where it lies."""
    if phrase.tag not in _CLAUSES:
        return False
    texts = {leaf.text for leaf in phrase.leaves}
    if texts <= {"from", "before", "earlier", "previously"}:
        return True
    things = any(p.tag == "NP" and read_noun(p).head in _THINGS for p in phrase.preorder())
    return bool(_HANDLED & texts) and (bool(_RECENT & texts) or (not things and "moved" in texts))
