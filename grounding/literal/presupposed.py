"""What a text speaks of beside what it handles, where it is not read as a whole.

A text may be beyond what is read literally though a phrase within it is not: "the one opposite of the row of seven" says
that there is a row of seven. Shapes and counts that are presupposed are looked for phrase by phrase.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from grounding.graded.nouns import Noun, read_noun
from grounding.language.tree import Phrase
from grounding.literal.values import FIRM, Missing, Unread

if TYPE_CHECKING:
    from grounding.literal.reader import LiteralReader

FORMING = frozenset(
    "form forms make makes making create creates creating become becomes forming build builds building".split()
)


def absences(tree: Phrase, reader: LiteralReader) -> Iterator[Missing]:
    """The shapes and counts that a text presupposes and that are literally not there.

    Args:
        tree: the parse.
        reader: of its phrases.
    """
    if FORMING & {leaf.text for leaf in tree.leaves}:
        return
    for phrase in tree.postorder():
        if phrase.tag != "NP" or not _presupposes(read_noun(phrase)):
            continue
        try:
            reader.mean(phrase)
        except Unread:
            continue
        except Missing as missing:
            if missing.shape or missing.limit == FIRM:
                yield missing


def _presupposes(noun: Noun) -> bool:
    """Whether a noun says that there is a shape, or so many."""
    if not noun.definite or noun.conjoined or noun.other:
        return False
    shape = noun.head == "container" and not noun.plural
    return shape or (noun.head == "block" and noun.plural and "the" in noun.text.split()[:1])
