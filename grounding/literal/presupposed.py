"""What a text speaks of beside what it handles, where it is not read as a whole.

A text may be beyond what is read literally though a phrase within it is not: "the one opposite the row of seven" says
that there is a row of seven. What definite phrases presuppose is looked for one by one.
"""

from __future__ import annotations

from collections.abc import Iterator

from grounding.language.tree import Phrase
from grounding.literal.arrangements import size_of
from grounding.literal.reading import ReadsLiterally
from grounding.literal.values import FIRM, Missing, Unread
from grounding.meaning.nouns import Noun, read_noun
from grounding.numbers import ranked, spelled

_FORMING = frozenset(
    "form forms make makes making create creates creating become becomes forming build builds building".split()
)


def forms(tree: Phrase) -> bool:
    """Whether a text asks to make something out of blocks, which need not be there before."""
    return bool(_FORMING & {leaf.text for leaf in tree.leaves})


def absences(tree: Phrase, reader: ReadsLiterally) -> Iterator[Missing]:
    """What the definite phrases of a text presuppose and what is literally not there, innermost first.

    Args:
        tree: the parse.
        reader: of its phrases.
    """
    if forms(tree):
        return
    alike = len(reader.layout.colors) < 2  # where places are all that tells things apart people speak loosely
    for phrase in tree.postorder():
        if phrase.tag != "NP" or not _presupposes(noun := read_noun(phrase)):
            continue
        beyond = _beyond(noun)
        if beyond is not None:
            yield beyond
        if alike and ("tower" not in noun.kinds or reader.scene.towers):
            continue
        try:
            reader.mean(phrase)
        except Unread:
            continue
        except Missing as missing:
            yield missing


def _presupposes(noun: Noun) -> bool:
    """Whether a noun says that there is something."""
    if not noun.definite or noun.conjoined:
        return False
    pointed = not {"the", "those", "these"}.isdisjoint(noun.text.split()[:2])  # "all the", "those three"
    return (noun.head == "container" and not noun.plural) or (noun.head == "block" and pointed)


def _beyond(noun: Noun) -> Missing | None:
    """A rank beyond the number of the set in which it is counted: "the fourth one in the row of three"."""
    if noun.head != "block" or noun.plural or len(noun.ordinals) != 1:
        return None
    for modifier in noun.modifiers:
        texts = [word.text for word in modifier.words]
        if modifier.tag != "PP" or texts not in (["of"], ["in"], ["within"]) or len(modifier.phrases) != 1:
            continue
        number = size_of(read_noun(modifier.phrases[0]))
        if number is not None and noun.ordinals[0] > number:
            return Missing(f"there is no {ranked(noun.ordinals[0])} one of {spelled(number)}", FIRM)
    return None
