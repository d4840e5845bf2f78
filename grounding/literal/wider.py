"""Whether what is literally missing is there in a wider sense of its words.

What is not there by sharp words may be there by loose ones: three blocks that do not stand apart are still a group for
who looks for three, and "behind" fades to the side. A noun that literally means nothing is weighed once more by
degrees, by itself. Only if that finds nothing either it is missing, however well the rest of a text agrees with the
world: what a text handles in the end may be there though it speaks of something that is not.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from grounding.geometry.masks import indices_of
from grounding.lexicon import arrangement, colour
from grounding.literal.values import FIRM, Missing
from grounding.meaning.nouns import Noun
from grounding.meaning.reader import Reader
from grounding.model.evaluator import Evaluator
from grounding.model.surroundings import context_in
from grounding.world.scene import ROBOT, Scene

HELD = 0.25
"""What is worth less holds of nothing in any sense of the words."""
CLOSE = 1.6  # centres of blocks of which one seems to stand on the next are at most so many edges apart
AHEAD = 0.4  # to the line of sight at most, of what seems stacked [rad]
_HEAPS = frozenset("pile piles heap structure structures building".split())


def is_missing(
    missing: Missing, agreement: float, scene: Scene, views: Iterable[str], history: tuple[int, ...] = ()
) -> bool:
    """Whether what literally is not there is missing in a wider sense of its words as well.

    Where places are all that tells things apart people speak loosely; then it counts how well the whole text agrees.

    Args:
        missing: what is literally not there.
        agreement: of what the text handles with the world, by degrees.
        scene: the world.
        views: whose directions may be meant.
        history: indices of the objects handled before, the latest last.
    """
    noun, firm = missing.noun, missing.limit == FIRM
    if noun is None:
        return agreement < missing.limit
    alike = len(scene.layout.colors) < 2
    flat = missing.shape and "tower" in noun.kinds and not scene.towers
    shaped = noun.head == "container"
    if alike and not firm and not flat and (agreement >= missing.limit or not shaped):
        return agreement < missing.limit
    worth = held(noun, scene, views, history)
    if shaped and firm and missing.shape and not alike:
        worth = min(worth, _plainly(noun, scene))
    if shaped:
        return worth < HELD
    if firm:
        return not alike or worth < HELD
    return min(agreement, worth) < max(missing.limit, HELD)


def held(noun: Noun, scene: Scene, views: Iterable[str] = (ROBOT,), history: tuple[int, ...] = ()) -> float:
    """How well a noun holds of what it holds best of, in [0, 1].

    Args:
        noun: by itself, without the text around it.
        scene: the world.
        views: whose directions may be meant.
        history: indices of the objects handled before, the latest last.
    """
    return max((_by(Evaluator(scene, view, history), noun) for view in views), default=0.0)


def looks_stacked(scene: Scene, noun: Noun) -> bool:
    """Whether something lies as what is called a tower may look from above, where nothing is stacked.

    Blocks in contact one behind the other are a stack in a picture; what is called a pile may be any heap.

    Args:
        scene: the world.
        noun: of an arrangement; its number, if it has one, has to be met.
    """
    heaped = not _HEAPS.isdisjoint(noun.text.split())
    for a in scene.layout.arrangements:
        if noun.number not in (None, a.count) or not a.noticed:
            continue
        if a.kind == "group" and heaped:
            return True
        if a.kind == "column" and a.angle < AHEAD:
            ahead = np.sort(scene.layout.positions[list(indices_of(a.mask)), 0])
            if float(np.diff(ahead).max()) < CLOSE * scene.edge:
                return True
    return False


def _by(evaluator: Evaluator, noun: Noun) -> float:
    reader = Reader(context_in(evaluator.scene, evaluator.history))
    if noun.head == "block" and noun.plural:
        # several are worth what the worst of so many is: as sets they are only weighed against each other
        number = noun.number or (2 if "both" in noun.text.split() else 1)
        each = reader.refer(replace(noun, plural=False, number=None, universal=False, definite=False))
        truths = np.sort(np.max([case.truth for case in evaluator.cases(each)], axis=0))
        return float(truths[-number]) if number <= len(truths) else 0.0
    flat = noun.head == "container" and "tower" in noun.kinds and not evaluator.scene.towers
    if flat and not looks_stacked(evaluator.scene, noun):
        return 0.0
    return evaluator.denote(reader.refer(noun)).truth


def _plainly(noun: Noun, scene: Scene) -> float:
    """How much the best line of so many looks like one: where colours tell things apart nobody counts bands."""
    wanted = colour.truth(scene, noun.colors) > 0.5 if noun.colors else np.ones(scene.n, dtype=bool)
    found = arrangement.candidates(scene, noun.kinds, wanted, noun.number)
    return max((c.looks for c in found if noun.number in (None, int(c.mask.sum())) and c.form != "band"), default=0.0)
