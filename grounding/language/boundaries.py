"""Which words can begin, and which can end, a phrase of several words: most cells of a chart need not be filled.

After B. Roark and K. Hollingshead, "Classifying chart cells for quadratic complexity context-free inference" (COLING
2008), by counts instead of a classifier: no phrase ends with "the", nor with "left" before a noun, and none begins
with "block" after an adjective.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from grounding.language.tags import TagModel
from grounding.language.tree import Phrase

_ENOUGH = 12
"""Words, and words with a neighbour, that were seen less often are not judged."""

Row = Mapping[str, tuple[int, int]]
"""Kind of neighbour -> how often the word was seen with one, and how often a phrase began or ended there."""


@dataclass(frozen=True)
class Boundaries:
    """Counts of a treebank's words; the kind of a neighbour is its most frequent tag.

    Attributes:
        begins: word -> of neighbours to its left.
        ends: word -> of neighbours to its right.
    """

    begins: Mapping[str, Row]
    ends: Mapping[str, Row]

    @classmethod
    def learn(cls, trees: Iterable[Phrase], words: TagModel) -> Boundaries:
        """Count the words of a treebank, whose tags were counted before."""
        begins: dict[str, dict[str, list[int]]] = {}
        ends: dict[str, dict[str, list[int]]] = {}
        for tree in trees:
            first: set[int] = set()
            last: set[int] = set()
            for phrase in tree.preorder():
                leaves = phrase.leaves
                if len(leaves) > 1:
                    first.add(leaves[0].index)
                    last.add(leaves[-1].index)
            kinds = ["", *(words.usual_tag(leaf.text) for leaf in tree.leaves), ""]
            for place, leaf in enumerate(tree.leaves):
                for table, kind, marked in ((begins, kinds[place], first), (ends, kinds[place + 2], last)):
                    row = table.setdefault(leaf.text, {}).setdefault(kind, [0, 0])
                    row[0] += 1
                    row[1] += leaf.index in marked
        return cls(_sorted(begins), _sorted(ends))

    def openings(self, sentence: Sequence[Iterable[str]], words: TagModel) -> tuple[list[bool], list[bool]]:
        """Where phrases of several words may begin and end.

        Args:
            sentence: for every place, the words that may stand there.
            words: the tags of the same treebank.

        Returns:
            for every place, whether one may begin with it, and whether one may end with it.
        """
        kinds: list[set[str | None]] = [
            {kind for word in choices for kind in (words.frequent_tags(word) if words.is_known(word) else (None,))}
            for choices in sentence
        ]
        edge: set[str | None] = {""}
        begins = [
            any(_may(self.begins.get(word), before) for word in choices)
            for choices, before in zip(sentence, [edge, *kinds[:-1]], strict=True)
        ]
        ends = [
            any(_may(self.ends.get(word), after) for word in choices)
            for choices, after in zip(sentence, [*kinds[1:], edge], strict=True)
        ]
        begins[0] = ends[-1] = True
        return begins, ends


def _may(row: Row | None, kinds: Iterable[str | None]) -> bool:
    """Whether the counts of a word, next to a neighbour of one of these kinds, leave room for a phrase."""
    if row is None:
        return True
    seen = sum(count for count, _ in row.values())
    marked = sum(count for _, count in row.values())
    if seen < _ENOUGH:
        return True
    if not marked:
        return False
    for kind in kinds:
        near, there = row.get(kind, (0, 0)) if kind is not None else (0, 0)
        if near < _ENOUGH or there:
            return True
    return False


def _sorted(table: Mapping[str, Mapping[str, Sequence[int]]]) -> dict[str, dict[str, tuple[int, int]]]:
    return {word: {kind: (row[kind][0], row[kind][1]) for kind in sorted(row)} for word, row in sorted(table.items())}
