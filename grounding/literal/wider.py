"""Whether what is literally missing is there in a wider sense of its words.

What is not there by sharp words may be there by loose ones: three blocks that do not stand apart are still a group for
who looks for three, and "behind" fades to the side. A noun that literally means nothing is read once more as graded
readings do, by itself. Only if that finds nothing either it is missing, however well the rest of a text agrees with the
world: what a text handles in the end may be there though it speaks of something that is not.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from grounding.graded.nouns import Noun
from grounding.graded.reader import Reader
from grounding.graded.scene import ROBOT, Scene
from grounding.literal.values import FIRM, Missing

SHAPED = 0.6
"""An arrangement worth less is none in any sense of the word: nothing that looks like one has the number."""
HELD = 0.2
"""What is worth less holds of nothing in any sense of the words."""


def is_missing(missing: Missing, agreement: float, scene: Scene, views: Iterable[str], history: tuple[int, ...]) -> bool:
    """Whether what literally is not there is missing in a wider sense of its words as well.

    Where places are all that tells things apart people speak loosely, so that it counts what the whole text agrees with.

    Args:
        missing: what is literally not there.
        agreement: of what the text handles with the world, by its graded readings.
        scene: the world.
        views: whose directions may be meant.
        history: indices of the objects handled before, the latest last.
    """
    noun, limit = missing.noun, missing.limit
    if noun is None:
        return agreement < limit
    alike = len(scene.layout.colors) < 2
    firm = limit == FIRM
    if alike and not firm:
        return agreement < limit and (noun.head != "container" or held(noun, scene, views, history) < SHAPED)
    worth = held(noun, scene, views, history)
    if noun.head == "container":
        return worth < (SHAPED if missing.shape else HELD)
    if firm:
        return not alike or worth < HELD
    return min(agreement, worth) < max(limit, HELD)


def held(noun: Noun, scene: Scene, views: Iterable[str] = (ROBOT,), history: tuple[int, ...] = ()) -> float:
    """How well a noun holds of what it holds best of, in [0, 1].

    Args:
        noun: by itself, without the text around it.
        scene: the world.
        views: whose directions may be meant.
        history: indices of the objects handled before, the latest last.
    """
    return max((_by(Reader(scene, view, history), noun) for view in views), default=0.0)


def _by(reader: Reader, noun: Noun) -> float:
    if noun.head == "block" and noun.plural:
        # several are worth as much as the worst of so many: sets are weighed against each other only
        number = noun.number or (2 if "both" in noun.text.split() else 1)
        weights = np.sort(reader.noun(replace(noun, plural=False, number=None, universal=False, definite=False)).weights)
        return float(weights[-number]) if number <= len(weights) else 0.0
    value = reader.noun(noun)
    if noun.head == "container":
        return max((weight for _, weight in value.sets), default=0.0)
    return float(value.weights.max(initial=0.0))
