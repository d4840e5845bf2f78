"""How true what is said of a place is of candidate places, by the same concepts as of the objects that stand there."""

from __future__ import annotations

import numpy as np

from grounding.lexicon import between, direction, nearness
from grounding.lexicon.relations import relation as module
from grounding.lexicon.where import Where
from grounding.meaning.goal.clues import RELATION
from grounding.model.phrases import PhraseReader
from grounding.placing.anchors import Anchors
from grounding.placing.floor_plan import FloorPlan, Places
from grounding.placing.maps import Shift
from grounding.world import Array


def truths(
    relation: str, anchors: Anchors, shift: Shift, places: Places, plan: FloorPlan, reader: PhraseReader, *,
    strict: bool = False,
) -> Array | None:  # fmt: skip
    """How true a relation to what is referred to is of places.

    Args:
        relation: of a clue, see `grounding.meaning.goal.clues.Clue`.
        anchors: hypotheses about what it relates to.
        shift: the directions that are said.
        places: the candidates.
        plan: of the floor.
        reader: of the scene.
        strict: whether "directly" is said.

    Returns:
        shape (p, h); None for what the lexicon has no concept of here: ways with a length, what comes about, what is
        amid many.
    """
    scene, flat = reader.scene, places.support < 0
    where = Where.points(scene, plan.world(places.points))
    found = np.zeros((len(places.points), len(anchors.share)))
    for h, members in enumerate(anchors.members):
        chosen = list(members)
        if relation == "between" and max(map(len, anchors.members)) <= 2:
            found[:, h] = _between(where, scene.xy[chosen], scene.edge)
        elif relation == "offset" and not shift.said.any() and shift.open.any():
            vector = shift.open @ plan.axes
            vector = vector / np.linalg.norm(vector)
            found[:, h] = direction.truth_of_set(where, scene.xy[chosen], scene.edge, vector, strict=strict)
        elif relation in ("near", "touch"):
            reach = nearness.TOUCHING if relation == "touch" else nearness.BESIDE
            found[:, h] = nearness.truth(where.gaps[:, chosen], scene.edge, reach).max(axis=1) * flat
        elif relation == "apart":
            near = nearness.truth(where.gaps[:, chosen], scene.edge, nearness.APART)
            found[:, h] = 1.0 - near.max(axis=1) * flat
        elif relation.startswith(RELATION):
            found[:, h] = module(relation.removeprefix(RELATION)).truth(where, scene)[:, chosen].max(axis=1) * flat
        else:
            return None
    return found


def _between(where: Where, points: Array, edge: float) -> Array:
    """How true it is to lie between two points; nothing lies between one."""
    return between.truth(where.xy, points[0], points[1], edge) if len(points) == 2 else np.zeros(len(where))


def preferences(name: str, anchors: Anchors, places: Places, plan: FloorPlan, reader: PhraseReader) -> Array:
    """Which places in a relation of the lexicon would be meant, shape (p, h)."""
    where = Where.points(reader.scene, plan.world(places.points))
    held = module(name).preference(where, reader.scene)
    return np.stack([held[:, list(members)].max(axis=1) for members in anchors.members], axis=1)
