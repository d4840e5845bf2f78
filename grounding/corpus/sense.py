"""Whether people would say a sentence: drawn sentences may be true and yet say the same twice, or nothing.

What a noun phrase is ranked by is said once: "the nearest two blocks that are nearer to you" ranks twice by distance,
and which rank comes first is left to whoever hears it. What is said of another thing within it counts there.
"""

from __future__ import annotations

from collections.abc import Iterator

from grounding.language.tree import Phrase, Word

_BY_DISTANCE = frozenset("nearest closest farthest furthest nearer closer farther further".split())
_ALONE = frozenset("by to all".split())
_BRINGING = frozenset("bring pick take get grab".split())


def is_sensible(tree: Phrase) -> bool:
    """Whether no noun phrase of a tree is ranked twice by distance, and nothing lies on itself or is chosen alone."""
    if _on_itself(tree) or _brought_back(tree) or _alone_before(tree):
        return False
    return all(_distances(phrase) < 2 for phrase in tree.preorder() if phrase.tag == "NP")


def _distances(noun: Phrase) -> int:
    """How often a noun phrase is ranked by distance."""
    return sum(word.text in _BY_DISTANCE for word in _own(noun, head=True))


def _own(phrase: Phrase, *, head: bool = False) -> Iterator[Word]:
    """The words that a noun phrase says of its own thing: not those of the noun phrases to which it relates it."""
    for place, child in enumerate(phrase.children):
        if isinstance(child, Word):
            yield child
        elif child.tag != "NP" or (head and place == 0) or _is_predicate(phrase, child):
            yield from _own(child, head=child.tag == "NP")


def _is_predicate(phrase: Phrase, child: Phrase) -> bool:
    """Whether a noun phrase says what something is: "that is the nearest to you"."""
    return phrase.tag == "VP" and child.tag == "NP" and child is phrase.phrases[-1] and phrase.leaves[0].tag == "VBZ"


def _on_itself(tree: Phrase) -> bool:
    texts = [leaf.text for leaf in tree.leaves]
    return any(text == "itself" and (not place or texts[place - 1] not in _ALONE) for place, text in enumerate(texts))


def _brought_back(tree: Phrase) -> bool:
    """Whether something is to be picked up back: only what was put down elsewhere goes back."""
    commands = (p for p in tree.preorder() if p.tag == "VP" and any(word.text in _BRINGING for word in p.words))
    return any(child.tag == "PRT" and child.text == "back" for command in commands for child in command.phrases)


def _alone_before(tree: Phrase) -> bool:
    """Whether loneness is told before what it is of: "by itself pick up the red block"."""
    for phrase in tree.preorder():
        verb = next((i for i, c in enumerate(phrase.children) if isinstance(c, Word) and c.tag.startswith("VB")), 0)
        before = (child for child in phrase.children[:verb] if isinstance(child, Phrase))
        if phrase.tag == "VP" and any(child.leaves[-1].text in ("itself", "own", "alone") for child in before):
            return True
    return False
