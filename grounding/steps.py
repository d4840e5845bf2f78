"""Several things to do in one text: where one ends and the next begins, each to be grounded in the world that it finds.

"Pick up the red block. Then put it on the tower" is one thing to do; "put A on B and then C next to D" are two.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from grounding.language.parser import Parse
from grounding.language.tree import Phrase, Word
from grounding.lexicon.words import is_between
from grounding.meaning.discourse.clauses import clauses_of
from grounding.meaning.discourse.following import read_text
from grounding.meaning.discourse.verbs import HANDLING
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reader import Reader
from grounding.model.cases import Denotation, Weights
from grounding.model.evaluator import EVEN, Evaluator
from grounding.model.surroundings import context_in
from grounding.world.scene import Scene

Step = tuple[Parse, ...]
"""The parses of one step, the likeliest first."""

SAME = 0.15  # things whose likely objects overlap more than this are one thing that is spoken of again
PLACED = 0.6  # once something has its place, and something is to be picked up, a new name tells another thing
FAINT = 0.05  # things that a description hardly means are none that two descriptions share
HOLDS = 0.1  # what is described worse than this is no thing to handle
_PREPARING = frozenset("touch reach raise want need hold see look find".split())
_ACTING = frozenset(word for words in HANDLING.values() for word in words) - _PREPARING
_JOINTS = frozenset("and then".split())
_POINTING = frozenset("that this those these".split())
_NAMED = ("block", "container")


def split(
    parses: Sequence[Parse], scene: Scene, history: Sequence[str] = (), weights: Weights = EVEN
) -> tuple[Step, ...]:
    """The steps of a text, in order; one where all that is said is about one thing to do.

    Args:
        parses: of the text, the likeliest first.
        scene: the world.
        history: ids of the objects handled before, the latest last.
        weights: of features.
    """
    if not parses or len(_commands(parses[0].tree)) < 2:
        return (tuple(parses),)
    handled = tuple(scene.layout.index[name] for name in history if name in scene.layout.index)
    evaluator = Evaluator(scene, history=handled, weights=weights)
    split_up = [(parse, _groups(parse.tree, evaluator)) for parse in parses]
    count = len(split_up[0][1])
    if count == 1:
        return (tuple(parses),)
    agreeing = [(parse, groups) for parse, groups in split_up if len(groups) == count]
    return tuple(tuple(replace(parse, tree=groups[i]) for parse, groups in agreeing) for i in range(count))


def _commands(tree: Phrase) -> list[Phrase]:
    return [clause for clause in _unfolded(tree) if _named(clause) is not None]


def _groups(tree: Phrase, evaluator: Evaluator) -> list[Phrase]:
    """The clauses of each step, under one root."""
    context = context_in(evaluator.scene, evaluator.history)
    groups: list[list[Phrase]] = [[]]
    for clause in _unfolded(tree):
        noun = _named(clause)
        if noun is not None and any(_named(before) is not None for before in groups[-1]):
            told = read_text(_rooted(groups[-1]), Reader(context))
            most = PLACED if told.destination and _kind(clause) == "pick" else SAME
            further = evaluator.denote(Reader(context).refer(noun))
            if told.target is not None and _apart(evaluator.denote(told.target), further, most):
                groups.append([])
        groups[-1].append(clause)
    return [_rooted(group) for group in groups]


def _kind(clause: Phrase) -> str | None:
    """The kind of action that a command asks for."""
    return next((kind for kind, verbs in HANDLING.items() for leaf in clause.leaves if leaf.text in verbs), None)


def _apart(first: Denotation, second: Denotation, most: float) -> bool:
    """Tells whether two descriptions lead to different things: their likely objects overlap by less than `most`."""
    one, two = (np.where(denotation.weights < FAINT, 0.0, denotation.weights) for denotation in (first, second))
    if not one.any() or not two.any() or second.truth < HOLDS:
        return False
    return float(np.minimum(one / one.sum(), two / two.sum()).sum()) < most


def _named(clause: Phrase) -> Noun | None:
    """The thing that a command says is to be handled; None where it says "it", or commands nothing."""
    if clause.tag != "VP":
        return None
    texts = [word.text for word in clause.words]
    objects = [child for child in clause.phrases if child.tag == "NP"]
    if not objects or not _ACTING & set(texts):
        inner = [child for child in clause.phrases if child.tag == "VP"]
        return _named(inner[0]) if len(inner) == 1 and not objects else None
    noun = read_noun(objects[0])
    if noun.text.split(" ", 1)[0] in _POINTING:
        return None
    told = (
        noun.colors or noun.modifiers or noun.directions or noun.ordinals or noun.distance or noun.middle or noun.lone
    )
    return noun if noun.head in _NAMED and (told or noun.head == "container") else None


def _unfolded(tree: Phrase) -> list[Phrase]:
    """The clauses, with a verb for each thing that shares one: "put A on B, then C on D"."""
    found: list[Phrase] = []
    for clause in clauses_of(tree):
        further = _understood(found[-1], clause) if found else None
        found += _shared(clause if further is None else further)
    return found


def _understood(before: Phrase, clause: Phrase) -> Phrase | None:
    """A clause that leaves out the verb of the one before: "put A on B" ", and C on D"; None for others."""
    verb = next((word for word in before.words if word.text in HANDLING["place"]), None)
    if clause.tag != "NP" or before.tag != "VP" or verb is None or clause.leaves[0].text not in _JOINTS:
        return None
    things = [phrase for phrase in clause.preorder() if phrase.tag == "NP" and phrase.leaves[0].text not in _JOINTS]
    thing = things[0] if things else None
    if thing is None or len(thing.children) < 2 or not _places(thing.phrases[-1] if thing.phrases else thing):
        return None
    index = clause.leaves[0].index
    return Phrase("VP", (replace(verb, index=index), *thing.children))


def _shared(clause: Phrase) -> list[Phrase]:
    """A command whose destination is followed by "and" with another thing and its destination, as two commands."""
    if clause.tag != "VP" or not any(isinstance(c, Phrase) and c.tag == "NP" for c in clause.children):
        return [clause]
    listed = _listed(clause)
    if len(listed) > 1:
        return listed
    last = clause.children[-1]
    if isinstance(last, Phrase) and last.tag in ("VP", "S") and _named(clause) is not None:
        before = last.children[:-1] if last.tag == "S" else ()
        inner = last.children[-1] if last.tag == "S" else last
        if isinstance(inner, Phrase) and _named(inner) is not None:
            return [Phrase("VP", (*clause.children[:-1], *before)), *_shared(inner)]
    joint = next((leaf for leaf in clause.leaves[3:] if leaf.text in _JOINTS), None)
    verb = tuple(word for word in clause.words if word.text in HANDLING["place"])
    if joint is None or not verb or any(is_between(leaf.text) for leaf in clause.leaves):
        return [clause]
    left = _cut(clause, 0, joint.index)
    right = _cut(clause, joint.index + 1, clause.leaves[-1].index + 1)
    if left is None or right is None or not any(_places(phrase) for phrase in left.preorder()):
        return [clause]
    pieces = _pieces(right)
    if len(pieces) < 2 or pieces[0].tag != "NP" or not _places(pieces[1]):
        return [clause]
    second = Phrase("VP", (*(replace(word, index=joint.index) for word in verb), *pieces))  # the verb is understood
    return [_lifted(left), *_shared(second)] if _named(second) is not None else [clause]


def _listed(clause: Phrase) -> list[Phrase]:
    """A command for several things one after the other, as one for each: "take A, then B", "take A, B and C"."""
    verbs = HANDLING["pick"] + HANDLING["clear"]
    if not any(word.text in verbs for word in clause.words):
        return [clause]
    places = (i for i, child in enumerate(clause.children) if isinstance(child, Phrase) and child.tag == "NP")
    place = next(places, None)
    if place is None:
        return [clause]
    verb, things = clause.children[:place], [clause.children[place]]
    for child in clause.children[place + 1 :]:
        if not isinstance(child, Phrase):
            return [clause]
        texts = [word.text for word in child.words]
        then = child.tag == "PP" and texts == ["then"] and len(child.phrases) == 1
        if then:
            things.append(child.phrases[0])
        elif child.tag == "NP" and texts == ["and"] and len(child.phrases) > 1:
            things += child.phrases
        else:
            return [clause]
    commands = [Phrase("VP", (*verb, thing)) for thing in things]
    return commands if all(_named(command) is not None for command in commands) else [clause]


def _lifted(clause: Phrase) -> Phrase:
    """A command whose destination was read as part of its object, with the destination beside it."""
    last = clause.children[-1]
    while isinstance(last, Phrase) and last.tag == "NP" and len(last.children) == 1 and last.phrases:
        last = last.phrases[0]
    if isinstance(last, Phrase) and last.tag == "NP" and len(last.phrases) > 1 and _places(last.phrases[-1]):
        return Phrase(clause.tag, (*clause.children[:-1], *last.children))
    return clause


def _places(phrase: Phrase) -> bool:
    """Tells whether a phrase sets something in relation to a thing."""
    words = [word.text for word in phrase.words]
    return phrase.tag == "PP" and bool(words) and words != ["of"] and any(p.tag == "NP" for p in phrase.phrases)


def _cut(phrase: Phrase, start: int, end: int) -> Phrase | None:
    """The part of a phrase between two positions of words, or None."""
    kept: list[Word | Phrase] = []
    for child in phrase.children:
        if isinstance(child, Word):
            if start <= child.index < end:
                kept.append(child)
        elif (part := _cut(child, start, end)) is not None:
            kept.append(part)
    return Phrase(phrase.tag, tuple(kept)) if kept else None


def _pieces(phrase: Phrase) -> list[Phrase]:
    """A thing and where it is to go, without the phrases around them that belonged to something else."""
    words = [word for word in phrase.words if word.tag != "RB"]
    if phrase.phrases and not words:
        return [piece for child in phrase.phrases for piece in _pieces(child)]
    first = phrase.children[0]
    if phrase.tag == "PP" and isinstance(first, Phrase) and first.tag == "NP" and len(phrase.children) > 2:
        return [first, Phrase("PP", phrase.children[1:])]
    return [phrase]


def _rooted(clauses: Sequence[Phrase]) -> Phrase:
    return clauses[0] if len(clauses) == 1 else Phrase("FRAG", tuple(clauses))
