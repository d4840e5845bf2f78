"""Which Penn tags a word can have: log P(tag | word), from counts, and for new words from their shape.

The ending model is that of T. Brants, "TnT - a statistical part-of-speech tagger" (ANLP 2000): the tags of rare words
with the same ending, successively shorter, starting from the tags of all rare words.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from math import log

from grounding.language.tree import Phrase

RARE = 2
"""A word seen less often than this with a tag counts as an unknown word of that tag."""
FREQUENT = 0.5  # a tag is frequent for a word if it is seen so many times as often as the usual one

_LONGEST_ENDING = 4
_ENDING_WEIGHT = 2.0
_SHAPE_WEIGHT = 4.0
_UNKNOWN_WEIGHT = 0.3
# What English would add to a small treebank: weights of tags for words never seen, and of tags for endings.
_OPEN_CLASSES = {
    "NN": 4.0,
    "NNS": 2.0,
    "JJ": 3.0,
    "VB": 2.0,
    "JJS": 0.5,
    "RB": 0.7,
    "IN": 0.7,
    "VBG": 0.3,
    "VBN": 0.3,
    "VBZ": 0.3,
    "CD": 0.2,
}
_ENDINGS = {
    "s": ("NNS", 3.0),
    "ss": ("NN", 6.0),
    "est": ("JJS", 9.0),
    "most": ("JJS", 9.0),
    "ing": ("VBG", 6.0),
    "ed": ("VBN", 6.0),
    "ly": ("RB", 6.0),
    "ish": ("JJ", 6.0),
    "ness": ("NN", 6.0),
    "ward": ("RB", 6.0),
    "wards": ("RB", 9.0),
}
_SHAPES = ((re.compile(r"\d+(?:st|nd|rd|th)\Z"), "JJ"), (re.compile(r"[\d.,]*\d[\d.,]*\Z"), "CD"))


@dataclass(frozen=True)
class TagModel:
    """Tag counts of a treebank's words, and what follows from them for other words.

    Attributes:
        counts: word -> tag -> how often it was seen.
    """

    counts: Mapping[str, Mapping[str, int]]

    @classmethod
    def learn(cls, trees: Iterable[Phrase]) -> TagModel:
        """Count the words of a treebank."""
        counts: dict[str, dict[str, int]] = {}
        for tree in trees:
            for leaf in tree.leaves:
                row = counts.setdefault(leaf.text, {})
                row[leaf.tag] = row.get(leaf.tag, 0) + 1
        return cls({word: dict(sorted(counts[word].items())) for word in sorted(counts)})

    @cached_property
    def words_seen(self) -> int:
        """How many words the treebank has, repetitions included."""
        return sum(sum(row.values()) for row in self.counts.values())

    @cached_property
    def tags(self) -> tuple[str, ...]:
        """Every tag of the treebank, in alphabetical order."""
        return tuple(sorted({tag for row in self.counts.values() for tag in row}))

    @cached_property
    def rare_mass(self) -> Mapping[str, float]:
        """Tag -> estimated share of all running words that are rare words of this tag."""
        mass = {tag: 0.5 * weight for tag, weight in _OPEN_CLASSES.items() if tag in self.tags}
        for row in self.counts.values():
            for tag, count in row.items():
                if count < RARE:
                    mass[tag] = mass.get(tag, 0.0) + count
        return {tag: mass[tag] / (self.words_seen + sum(mass.values())) for tag in sorted(mass)}

    def is_known(self, word: str) -> bool:
        """Whether the treebank has the word."""
        return word in self.counts

    def usual_tag(self, word: str) -> str:
        """The tag that a word of the treebank has most often; "" for other words."""
        return self._usual_tags.get(word, "")

    def frequent_tags(self, word: str) -> frozenset[str]:
        """The tags of a word of the treebank that are not much rarer than its usual one: "bottom" is NN and JJ."""
        row = self.counts.get(word, {})
        return frozenset(tag for tag, count in row.items() if count >= FREQUENT * max(row.values()))

    @cached_property
    def _usual_tags(self) -> Mapping[str, str]:
        return {word: max(row, key=lambda tag: (row[tag], tag)) for word, row in self.counts.items()}

    def is_rare(self, word: str, tag: str) -> bool:
        """Whether the word, with this tag, is treated as any unknown word of the tag would be."""
        return self.counts.get(word, {}).get(tag, 0) < RARE

    def log_probabilities(self, word: str) -> dict[str, float]:
        """Log P(tag | word) for every tag that the word can have.

        Args:
            word: in lower case; known or not.
        """
        shape = self._by_shape(word)
        row = self.counts.get(word, {})
        total = sum(row.values())
        weight = _UNKNOWN_WEIGHT if row else 1.0
        mixed = {tag: weight * share for tag, share in shape.items()}
        for tag, count in row.items():
            mixed[tag] = mixed.get(tag, 0.0) + count
        return {tag: log(mixed[tag] / (total + weight)) for tag in sorted(mixed)}

    def log_emission(self, word: str, tag: str, log_probability: float) -> float:
        """Log P(word | tag) for a word that is rare with this tag, by Bayes' rule; at most 0.

        Args:
            word: the word.
            tag: one of the tags that have `rare_mass`, or a tag that the word was seen with.
            log_probability: its log P(tag | word).
        """
        frequency = (sum(self.counts.get(word, {}).values()) + 0.5) / (self.words_seen + 1.0)
        return min(0.0, log_probability + log(frequency) - log(self.rare_mass[tag]))

    def _by_shape(self, word: str) -> dict[str, float]:
        """P(tag) of a word never seen, from its shape and its ending."""
        share = dict(self._open_share)
        for length in range(1, _LONGEST_ENDING + 1):
            row = self._endings.get(word[-length:]) if len(word) > length else None
            if row is not None:
                seen = sum(row.values())
                share = {
                    tag: (row.get(tag, 0.0) + _ENDING_WEIGHT * p) / (seen + _ENDING_WEIGHT) for tag, p in share.items()
                }
        for pattern, tag in _SHAPES:
            if tag in share and pattern.match(word):
                share = {other: p / (1.0 + _SHAPE_WEIGHT) for other, p in share.items()}
                share[tag] += _SHAPE_WEIGHT / (1.0 + _SHAPE_WEIGHT)
                break
        return share

    @cached_property
    def _open_share(self) -> Mapping[str, float]:
        """P(tag) of rare words of the open classes; of all rare words where the treebank has no open class."""
        mass = {tag: mass for tag, mass in self.rare_mass.items() if tag in _OPEN_CLASSES} or self.rare_mass
        total = sum(mass.values())
        return {tag: mass[tag] / total for tag in mass}

    @cached_property
    def _endings(self) -> Mapping[str, Mapping[str, float]]:
        """Ending -> tag -> in how many kinds of words, those of tags open to new words only."""
        table: dict[str, dict[str, float]] = {}
        for ending, (tag, weight) in _ENDINGS.items():
            if tag in self._open_share:
                table.setdefault(ending, {})[tag] = weight
        for word, row in self.counts.items():
            best = max(row, key=lambda tag: (row[tag], tag))
            if best not in self._open_share:
                continue
            for length in range(1, min(_LONGEST_ENDING, len(word) - 1) + 1):
                tags = table.setdefault(word[-length:], {})
                tags[best] = tags.get(best, 0.0) + 1.0
        return table
