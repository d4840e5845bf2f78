"""Possessives and neighbours are told with "of" and relations, corrections by what they come to.

Of "the row's end", "its left neighbor" and "not the red one but the blue one" readers of trees then meet "the end of
the row", "the block left of it" and "the blue one" only. Words keep their places in the sentence, so that they do not
stand in its order below a possessive.
"""

from __future__ import annotations

import operator
from collections.abc import Sequence

from grounding.language.tree import Phrase, Word

_NEIGHBORS = {"neighbor": "block", "neighbors": "blocks"}
_OWNERS = {"its": "it", "their": "them"}
_SIDES = frozenset(
    "left right front back top bottom upper lower north south east west northern southern eastern western".split()
)
_FAR = frozenset(
    "far northeast northwest southeast southwest northeastern northwestern southeastern southwestern "
    "topmost bottommost leftmost rightmost".split()
)
_PLACES = {"corner": "in", "edge": "at", "end": "at"}
_BLOCKS = frozenset("block cube box brick piece one".split())
_RANKS = frozenset("closest nearest closer nearer farthest furthest".split())
_TOWARD = frozenset(("on", "to"))


def unfold(tree: Phrase) -> Phrase:
    """A tree without possessives and without what is only denied.

    Args:
        tree: a parse; "the tower's top" is `(NP (POSP (NP (DT the) (NN tower)) (POS 's)) (NN top))` in it, "not the
            red one but the blue one" `(NP (CONJP (RB not) (NP ...) (CC but) (NP ...)))`.
    """
    parts = _placed(tree.children) if tree.tag == "NP" else tree.children
    children = [unfold(child) if isinstance(child, Phrase) else child for child in parts]
    if tree.tag == "NP":
        children = _neighboring(_owned(_corrected(children)))
    same = len(children) == len(tree.children) and all(map(operator.is_, children, tree.children))
    return tree if same else Phrase(tree.tag, tuple(children))


def _placed(children: tuple[Phrase | Word, ...]) -> tuple[Phrase | Word, ...]:
    """The children of a noun phrase, a place before its noun after it: "the corner block of the square"."""
    thing, modifier = children[0], children[-1]
    if len(children) == 2 and isinstance(thing, Phrase) and thing.tag == "NP":
        inner = _at_place(thing.children)
        if inner is not None and isinstance(modifier, Phrase) and [word.text for word in modifier.words] == ["of"]:
            block, at = inner
            return block, Phrase("PP", (*at.words, Phrase("NP", (*at.phrases, modifier))))
    return _at_place(children) or children


def _at_place(children: Sequence[Phrase | Word]) -> tuple[Phrase, Phrase] | None:
    """A block and where it is, of words like "the far left corner block"; None of others."""
    words = [child for child in children if isinstance(child, Word)]
    if len(words) < len(children) or len(words) < 2 or words[-1].text not in _BLOCKS or words[-2].text not in _PLACES:
        return None
    *before, place, noun = words
    sides = [word for word in before if word.text in _SIDES | _FAR]
    block = Phrase("NP", (*(word for word in before if word not in sides), noun))
    the = Word("the", "DT", place.index)
    at = Word(_PLACES[place.text], "IN", place.index)
    return block, Phrase("PP", (at, Phrase("NP", (the, *sides, place))))


def _corrected(children: list[Phrase | Word]) -> list[Phrase | Word]:
    """The children of a noun phrase, without what it is said not to be: "not the red block but the one behind it"."""
    last = children[-1]
    if not isinstance(last, Phrase) or last.tag != "CONJP" or len(last.phrases) != 2:
        return children
    denied, meant = last.phrases
    meant = _replaced(meant, denied)
    return [*children[:-1], meant] if len(children) > 1 else list(meant.children)


def _replaced(phrase: Phrase, thing: Phrase) -> Phrase:
    """A phrase with a thing in the place of "it"."""
    if phrase.tag == "NP" and phrase.text == "it":
        return thing
    return Phrase(phrase.tag, tuple(_replaced(c, thing) if isinstance(c, Phrase) else c for c in phrase.children))


def _owned(children: list[Phrase | Word]) -> list[Phrase | Word]:
    """The children of a noun phrase, its possessor after what belongs to it."""
    owner = children[0]
    if not isinstance(owner, Phrase) or owner.tag != "POSP" or len(children) < 2 or not owner.words:
        return children
    mark = owner.words[-1].index
    thing = Phrase("NP", (Word("the", "DT", mark), *children[1:]))
    return [thing, Phrase("PP", (Word("of", "IN", mark), *owner.phrases))]


def _neighboring(children: list[Phrase | Word]) -> list[Phrase | Word]:
    """The children of a noun phrase, a neighbor of something as a block beside it."""
    whose = next((word for word in children if isinstance(word, Word) and word.text in _OWNERS), None)
    if whose is not None and _is_neighbor(children):
        rest = [child for child in children if child is not whose]
        owner = Phrase("NP", (Word(_OWNERS[whose.text], "PRP", whose.index),))
        thing = Phrase("NP", (Word("the", "DT", whose.index), *rest))
        return _beside(thing, Phrase("PP", (Word("of", "IN", whose.index), owner)))
    if len(children) != 2:
        return children
    head, modifier = children
    if not isinstance(head, Phrase) or not isinstance(modifier, Phrase):
        return children
    if _is_neighbor(head.children) and [word.text for word in modifier.words] == ["of"] and modifier.phrases:
        return _beside(head, modifier)
    where = [leaf.text for leaf in modifier.leaves]
    sided = modifier.tag == "PP" and len(where) < 4 and where[0] in _TOWARD and where[-1] in _SIDES
    beside = head.phrases[-1] if sided and len(head.phrases) == 2 else None
    if beside is not None and beside.words and beside.words[0].text == "beside" and _is_block(head.phrases[0]):
        of = Phrase("PP", (Word("of", "IN", beside.words[0].index), *beside.phrases))
        return [head.phrases[0], Phrase("PP", (*modifier.words, Phrase("NP", (*modifier.phrases, of))))]
    return children


def _is_neighbor(children: Sequence[Phrase | Word]) -> bool:
    last = children[-1]
    return isinstance(last, Word) and last.text in _NEIGHBORS


def _is_block(thing: Phrase) -> bool:
    return bool(thing.words) and thing.words[-1].text in _NEIGHBORS.values()


def _beside(thing: Phrase, of: Phrase) -> list[Phrase | Word]:
    """A neighbor of something: on the side that it names, or nearest to it."""
    *before, last = thing.children
    assert isinstance(last, Word)
    sides = [word for word in before if isinstance(word, Word) and word.text in _SIDES]
    ranks = [word for word in before if isinstance(word, Word) and word.text in _RANKS]
    index = of.words[0].index
    block = Phrase("NP", (*(c for c in before if c not in sides and c not in ranks),
                          Word(_NEIGHBORS[last.text], last.tag, last.index)))  # fmt: skip
    if sides:
        relation: tuple[Word, ...] = (*ranks, *sides, Word("of", "IN", index))
    elif ranks:
        relation = (*ranks, Word("to", "IN", index))
    else:
        relation = (Word("beside", "IN", index),)
    return [block, Phrase("PP", (*relation, *of.phrases))]
