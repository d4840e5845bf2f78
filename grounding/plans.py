"""What takes several moves: to swap two things, to stack several, to take a tower apart."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from grounding.distinguishing import Describer
from grounding.language.parser import Parse
from grounding.language.tree import Phrase
from grounding.lexicon.support import bare, flat
from grounding.lexicon.vocabulary import vocabulary
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.referents import SETS
from grounding.model.cases import Weights
from grounding.model.evaluator import Evaluator
from grounding.model.phrases import PhraseReader
from grounding.numbers import spelled
from grounding.placing.by_belief import free_place
from grounding.result import Destination, GroundedAction, Grounding
from grounding.world.scene import ROBOT, Scene

ALIKE = 0.8
RIVAL = 0.5
"""Towers that are at least so likely meant as the best are a reason to ask, sets of things that are alike as well."""
_CONTENT = frozenset("of with from using out".split())


def planned(
    text: str, parses: Sequence[Parse], scene: Scene, history: tuple[int, ...], weights: Weights
) -> Grounding | None:
    """The moves that a text asks for as a whole, or why they cannot be made; None for all other texts.

    Args:
        text: the instruction.
        parses: of it, the likeliest first.
        scene: the world.
        history: indices of the objects handled before.
        weights: of the features of what is referred to.
    """
    command = _command(parses[0].tree)
    if command is None:
        return None
    verb = command.leaves[0].text
    deed = "unstack" if "apart" in {leaf.text for leaf in command.leaves} else vocabulary().value("plan", verb)
    objects = [child for child in command.phrases if child.tag == "NP"]
    if deed is None or not objects:
        return None
    reader = PhraseReader(Evaluator(scene, ROBOT, history, weights))
    return _DEEDS[deed](text, command, objects[0], reader)


def _command(tree: Phrase) -> Phrase | None:
    """The verb phrase of a text that is one command."""
    while tree.tag in ("S", "FRAG") and len(tree.phrases) == 1 and len(tree.children) == 1:
        tree = tree.phrases[0]
    return tree if tree.tag == "VP" and tree.children[0] is tree.leaves[0] else None


def _swapped(text: str, command: Phrase, thing: Phrase, reader: PhraseReader) -> Grounding | None:
    """Three moves: the first aside, the second to its place, the first to the second one's."""
    noun = read_noun(thing)
    if noun.head not in ("block", "container", "pronoun") and not noun.conjoined:  # "the places of the two blocks"
        of = (*noun.modifiers, *(child for child in command.phrases if child.tag == "PP"))
        inner = [p for m in of if [word.text for word in m.words] == ["of"] for p in m.phrases if p.tag == "NP"]
        noun = read_noun(inner[0]) if inner else noun
    else:
        noun = _with_rest(noun, [child for child in command.phrases if child.tag == "PP"])
    if noun.head == "pronoun":
        return None
    found = _set(text, noun, reader, 2)
    if isinstance(found, Grounding):
        return found
    first, second = found
    scene = reader.scene
    if not (scene.clear[first] and scene.clear[second]):
        return _refused(text, "one of them carries something; say what to put where")
    aside = free_place(first, reader)
    if aside is None:
        return _refused(text, "there is no free place to put one of them aside")
    return _moves(text, scene, [(first, aside), (second, _place_of(scene, first, second)),
                                (first, _place_of(scene, second, first))])  # fmt: skip


def _with_rest(noun: Noun, rest: Sequence[Phrase]) -> Noun:
    """A noun with what stands behind it, which tells of the last thing that it names: "A and B" "on the left"."""
    if not rest:
        return noun
    if noun.conjoined:
        return replace(noun, conjoined=(*noun.conjoined[:-1], Phrase("NP", (noun.conjoined[-1], *rest))))
    return replace(noun, modifiers=(*noun.modifiers, *rest))


def _stacked(text: str, command: Phrase, thing: Phrase, reader: PhraseReader) -> Grounding | None:
    """One on the other, what is pointed last; on something else they are put by the words for that."""
    noun = read_noun(thing)
    several = noun.plural or noun.conjoined
    if not several or any(child.tag == "PP" and child is not thing for child in command.phrases):
        return None
    found = _set(text, noun, reader, noun.number)
    return found if isinstance(found, Grounding) else _tower(text, found, reader)


def _built(text: str, command: Phrase, thing: Phrase, reader: PhraseReader) -> Grounding | None:
    """A tower of what is named: "build a tower with the red and the blue block"."""
    noun = read_noun(thing)
    if noun.head != "container" or noun.kinds[:1] != ("tower",) or any(leaf.text == "by" for leaf in command.leaves):
        return None
    rest = (*noun.modifiers, *(child for child in command.phrases if child is not thing))
    inner = [p for m in rest if _CONTENT & {word.text for word in m.words} for p in m.phrases if p.tag == "NP"]
    content = read_noun(inner[0]) if inner else None
    named = content is not None and (content.conjoined or content.colors or content.modifiers or content.universal)
    if content is None or not named:
        return _refused(text, "to build one, say of which blocks, or which block goes where")
    found = _set(text, content, reader, content.number or noun.number)
    return found if isinstance(found, Grounding) else _tower(text, found, reader)


def _parted(text: str, command: Phrase, thing: Phrase, reader: PhraseReader) -> Grounding | None:
    """Everything off a tower but its lowest block, from the top."""
    referent, denoted = reader.noun(read_noun(thing))
    scene = reader.scene
    best = set(np.flatnonzero(denoted.sets[0][0])) if referent.sort == SETS and denoted.sets else set()
    tower = next((tower for tower in scene.towers if best <= set(tower)), ()) if best else ()
    if not tower or denoted.truth < RIVAL:
        return _refused(text, f"nothing that is stacked is {thing.text!r}")
    rivals = [mask for mask, chance in denoted.sets[1:] if chance >= RIVAL and not (mask & denoted.sets[0][0]).any()]
    if rivals:
        return _refused(text, f"several towers are {thing.text!r}; say which")
    names = tuple(scene.layout.ids[i] for i in tower[:0:-1])
    return Grounding(text, "grounded", (GroundedAction("clear", names, denoted.truth),))


_DEEDS: dict[str, Callable[[str, Phrase, Phrase, PhraseReader], Grounding | None]] = {
    "swap": _swapped, "stack": _stacked, "build": _built, "unstack": _parted,
}  # fmt: skip


def _set(text: str, noun: Noun, reader: PhraseReader, number: int | None) -> tuple[int, ...] | Grounding:
    """The things that a noun speaks of, in their order from the left; what is to be said where that is open."""
    scene = reader.scene
    referent, denoted = reader.noun(noun)
    sets = [(mask, chance) for mask, chance in denoted.sets if number is None or int(mask.sum()) == number]
    if referent.sort != SETS or denoted.truth < RIVAL or not sets:
        what = f"{spelled(number)} of " if number else ""
        return _refused(text, f"nothing here is {what}{noun.text!r}" if noun.text else "say which blocks")
    mask, chance = sets[0]
    others = [other for other, likely in sets[1:] if likely >= ALIKE * chance]
    if int(mask.sum()) < 2:
        return _refused(text, f"{noun.text!r} is a single thing; say which ones")
    if others and number is not None:
        named = Describer(scene)
        first = [named.describe(scene.layout.ids[int(i)]).text for i in np.flatnonzero(mask)]
        return Grounding(text, "ambiguous", question=f"Do you mean {' and '.join(first)}, or others?",
                         explanation="several could be meant")  # fmt: skip
    members = np.flatnonzero(mask)
    order = np.argsort(-(scene.xy[members] @ scene.direction("left")), kind="stable")
    return tuple(int(i) for i in members[order])


def _tower(text: str, members: Sequence[int], reader: PhraseReader) -> Grounding:
    scene = reader.scene
    level, free = flat(scene), bare(scene)
    if not all(scene.clear[i] for i in members):
        return _refused(text, "one of them carries something; clear it first")
    ordered = sorted(members, key=lambda i: (not level[i], -float(np.prod(scene.layout.things[i].size)), i))
    if not all(free[i] for i in ordered[:-1]):
        return _refused(text, "nothing stands on what is pointed; leave some of it out")
    top = float(scene.z[ordered[0]] + scene.layout.things[ordered[0]].half_extents[2])
    x, y = (float(v) for v in scene.xy[ordered[0]])
    moves = []
    for below, above in pairwise(ordered):
        height = float(scene.layout.things[above].half_extents[2])
        moves.append((above, Destination((x, y, top + height), "top", (scene.layout.ids[below],))))
        top += 2 * height
    return _moves(text, scene, moves)


def _place_of(scene: Scene, there: int, moved: int) -> Destination:
    """Where something stands, for something else that may be of another height."""
    item = scene.layout.things[there]
    bottom = float(item.position[2] - item.half_extents[2])
    x, y = (float(value) for value in item.position[:2])
    return Destination((x, y, bottom + float(scene.layout.things[moved].half_extents[2])))


def _moves(text: str, scene: Scene, moves: Sequence[tuple[int, Destination]]) -> Grounding:
    ids = scene.layout.ids
    return Grounding(text, "grounded", tuple(GroundedAction("place", (ids[i],), 1.0, where) for i, where in moves))


def _refused(text: str, why: str) -> Grounding:
    return Grounding(text, "not_understood", explanation=why)

