"""What a text speaks of that is not there: things of no known name, colours, arrangements, ranks beyond the last."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from grounding.geometry.layout import Layout
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.lexicon import arrangement, colour, kind
from grounding.lexicon import words as w
from grounding.lexicon.size import vary
from grounding.literal.colors import without
from grounding.meaning.nouns import Noun, read_noun
from grounding.numbers import counted, listed, ranked, spelled
from grounding.symbols import ObjectColor
from grounding.world.scene import Scene

_LOOKS = 0.35  # an arrangement that looks less like one than this is not spoken of
_MOSTS = {"row": "longest", "column": "longest", "diagonal": "longest", "tower": "highest"}
_NO_THINGS = frozenset(
    "arm arms hand hands finger fingers gripper outside inside beginning rest bit face faces we us i".split()
)
_HEAPS = frozenset(("pile", "piles"))  # of blocks side by side, where nothing is stacked
_THINGS = ("block", "container")


def whats_missing(tree: Phrase, scene: Scene) -> str | None:
    """What is spoken of and not there, as a sentence for people; None where nothing is seen to be missing.

    Args:
        tree: the parse.
        scene: the world.
    """
    if not scene.n:
        return "there is nothing on the table"
    asked = targets(tree)
    strange = unknown_things(tree, scene.layout)
    if asked and strange and _strange(asked[0], scene.layout) == strange[0]:
        return _unknown(strange[:1], scene.layout)
    missing = _unseen(tree, scene)
    if missing is not None:
        return missing
    for phrase in (p for target in asked[:1] for p in target.postorder() if p.tag == "NP"):
        noun = read_noun(phrase)
        missing = _arrangement(noun, scene) or _rank(noun, scene) or _denied(noun, scene)
        if missing is not None:
            return missing
    return _unknown(strange, scene.layout) if strange else None


def unknown_named(tree: Phrase, scene: Scene) -> str | None:
    """A colour or a thing that is spoken of and that nothing here has, as a sentence for people, or None."""
    strange = unknown_things(tree, scene.layout)
    return _unseen(tree, scene) or (_unknown(strange, scene.layout) if strange else None)


def unknown_things(tree: Phrase, layout: Layout) -> tuple[str, ...]:
    """The nouns that call a thing by a name that nothing here has: what is asked for first, then what it is near to."""
    phrases = [target for target in targets(tree) if target.leaves[0].tag in ("DT", "CD") or len(target.leaves) > 1]
    for phrase in tree.preorder():
        if phrase.tag == "PP" and any(_relates(word.text) for word in phrase.words):
            phrases += [child for child in phrase.phrases if child.leaves[0].text == "the" and not child.phrases]
    names = (_strange(phrase, layout) for phrase in phrases)
    return tuple(dict.fromkeys(name for name in names if name is not None))


def _relates(text: str) -> bool:
    """Whether a preposition sets things in relation to things."""
    return bool(w.is_beside(text) or w.is_between(text) or w.is_touching(text) or w.is_surrounded(text)
                or text in ("on", "behind", "left", "right", "above", "below", "onto", "atop", "under"))  # fmt: skip


def _strange(phrase: Phrase, layout: Layout) -> str | None:
    """The noun of a noun phrase, where nothing here is called that."""
    if phrase.tag != "NP":
        return None
    base = phrase
    while base.phrases and base.phrases[0] is base.children[0] and base.phrases[0].tag == "NP":
        base = base.phrases[0]
    words = base.words
    if not words or words[-1].tag not in ("NN", "NNS", "NNP", "NNPS"):
        return None
    noun, name = read_noun(base), words[-1].text
    known = (
        name in _NO_THINGS
        or not noun.strange
        or meanings(name)
        or any(kind.is_type(name, known) for known in layout.types)
        or name not in noun.unknown
        or len(name) < 2
    )
    return None if known else name


def targets(tree: Phrase) -> tuple[Phrase, ...]:
    """What is asked for: the first object of every verb, or the text itself; else the first thing that is named."""
    found = _objects(tree)
    if any(read_noun(phrase).head in _THINGS or read_noun(phrase).strange for phrase in found):
        return found
    return (*found, *[p for p in tree.preorder() if p.tag == "NP" and read_noun(p).head in _THINGS][:1])


def _objects(tree: Phrase) -> tuple[Phrase, ...]:
    if tree.tag == "NP":
        return (tree,)
    if tree.tag not in ("VP", "S", "FRAG"):
        return ()
    objects = [child for child in tree.phrases if child.tag in ("NP", "VP", "S")]
    if tree.tag != "FRAG" and objects and objects[0].tag == "NP":
        further = [target for child in objects[1:] if child.tag != "NP" for target in _objects(child)]
        subject = tree.tag == "S" and read_noun(objects[0]).head in ("agent", "other", "pronoun") and further
        return tuple(further) if subject else (objects[0], *further)
    return tuple(target for child in objects for target in _objects(child))


def _unknown(names: tuple[str, ...], layout: Layout) -> str:
    known = sorted({item.type for item in layout.things}) or ["nothing"]
    quoted = listed([f"'{name}'" for name in names], "or")
    return f"I know of nothing called {quoted} here; the world has: {', '.join(known)}"


def _unseen(tree: Phrase, scene: Scene) -> str | None:
    found = (_lacking(read_noun(phrase), scene) for phrase in tree.postorder() if phrase.tag == "NP")
    return next((missing for missing in found if missing is not None), None)


def _lacking(noun: Noun, scene: Scene) -> str | None:
    if noun.head not in _THINGS or not (noun.colors or noun.types):
        return None
    if kind.fitting(scene, noun.types, noun.colors).any():
        return None
    said = tuple(word for word in noun.text.split() if w.kind(word) in noun.types)
    return without(scene, noun.types, noun.colors, said)


def _arrangement(noun: Noun, scene: Scene) -> str | None:
    if noun.head != "container" or noun.plural or (noun.sized and vary(scene)):
        return None
    if noun.ordinals and {"row", "column"} & set(noun.kinds):
        return None  # people count rows where nothing else looks like one
    number = noun.number or next((n.number for m in noun.modifiers if (n := _content(m)) is not None), None)
    stuff = np.ones(scene.n, dtype=bool)
    colors = noun.colors or next((n.colors for m in noun.modifiers if (n := _content(m)) is not None), ())
    if colors:
        stuff = colour.truth(scene, colors) > 0.5
    found = [c.mask for c in arrangement.candidates(scene, noun.kinds, stuff) if c.looks >= _LOOKS]
    kind = noun.kinds[0]
    heap = not _HEAPS.isdisjoint(noun.text.split())
    if kind == "tower" and not scene.towers and number is None and not heap:
        return "there is no tower here"
    if kind == "tower":  # seen from above blocks side by side are called stacks as well
        found += [c.mask for c in arrangement.clusters(scene, stuff) if c.looks >= _LOOKS]
    told = f"{' '.join(colors[:1])} {kind}".strip()
    counts = sorted(int(mask.sum()) for mask in found)
    if not counts:
        return f"there is no {told} here" if number is None else f"there is no {told} of {spelled(number)} blocks here"
    if number is not None and number > 2 and number not in counts:  # any two make a row
        best = max(counts) if number > max(counts) else min(counts, key=lambda count: (abs(count - number), -count))
        which = f"the {_MOSTS.get(kind, 'largest')} has" if best == max(counts) else "the nearest to that has"
        return f"there is no {told} of {spelled(number)} blocks; {which} {spelled(best)}"
    return None


def _content(modifier: Phrase) -> Noun | None:
    """The members that an arrangement is said to have: "of five", "of red blocks"."""
    if modifier.tag == "PP" and [word.text for word in modifier.words] in (["of"], ["with"]) and modifier.phrases:
        noun = read_noun(modifier.phrases[0])
        return noun if noun.head == "block" else None
    return None


def _rank(noun: Noun, scene: Scene) -> str | None:
    if noun.head != "block" or not noun.ordinals or noun.modifiers and any(_narrows(m) for m in noun.modifiers):
        return None
    rank = max(noun.ordinals)
    there = int((kind.fitting(scene, noun.types, noun.colors) > 0.5).sum())
    if 0 < there < rank:
        told = " ".join((*noun.colors[:1], *(noun.types[:1] or ("one",))))
        count = counted(there)
        return f"there is no {ranked(rank)} {told}; {count}"
    return None


def _denied(noun: Noun, scene: Scene) -> str | None:
    """Where all that is there has a colour that is ruled out: "the block that is not red"."""
    leaves = [leaf.text for modifier in noun.modifiers for leaf in modifier.leaves]
    denied = {
        symbol.name
        for before, text in pairwise(leaves)
        for symbol in meanings(text)
        if before in ("not", "n't", "nor", "neither") and isinstance(symbol, ObjectColor)
    }
    there = {item.color for item in scene.layout.things if not noun.colors or item.color in noun.colors}
    if noun.head != "block" or not denied or not there or not there <= denied:
        return None
    return f"all blocks here are {listed(sorted(there), 'or')}"


def _narrows(modifier: Phrase) -> bool:
    """Whether a modifier names the set in which is counted."""
    return any(w.containers(leaf.text) for leaf in modifier.leaves)
