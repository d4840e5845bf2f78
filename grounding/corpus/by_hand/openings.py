"""Where one more block may go in a scene: free, supported places that people have words for."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from grounding.corpus.by_hand.hand import Opening
from grounding.corpus.by_hand.kinds import Scene
from grounding.corpus.by_hand.room import EDGE, FINGER, gap, uncovered
from grounding.corpus.tabletop import TABLE_TOP, WHOLE_X, WHOLE_Y
from grounding.world import WorldObject

OPENINGS = ("gap", "end", "middle", "between", "beside", "top", "corner")
_LOW = TABLE_TOP + EDGE / 2  # z of a block's centre on the table in [m]
_HIGHEST = 4  # blocks of a stack
_BESIDE = 0.032  # gap to the block that something is put beside, in [m]
_CLEAN = 0.055  # gap to all others there, in [m]
_APART = (0.13, 0.24)  # centres of two blocks between which one goes, in [m]
_FROM_EDGE = 0.03  # a corner's block is so far from where it would stick out, in [m]


def openings(scene: Scene) -> tuple[Opening, ...]:
    """All places in a scene for one more block, those that nothing has to leave first."""
    things = scene.world.things
    found = [*scene.openings, *_corners(), *_tops(things), *_beside(things), *_between(scene)]
    return tuple(opening for opening in found if free(opening, things))


def free(opening: Opening, things: tuple[WorldObject, ...]) -> bool:
    """Whether fingers can leave a block there, and it does not stick out over the table's edge."""
    x, y, z = opening.place
    inside = WHOLE_X[0] <= x <= WHOLE_X[1] and WHOLE_Y[0] <= y <= WHOLE_Y[1]
    place = np.array((x, y))
    beside = [item for item in things if float(item.position[2]) > z - EDGE / 2]
    return inside and all(gap(place, 0.0, item) >= FINGER for item in beside)


def _corners() -> Iterator[Opening]:
    for x in (WHOLE_X[0] + _FROM_EDGE, WHOLE_X[1] - _FROM_EDGE):
        for y in (WHOLE_Y[0] + _FROM_EDGE, WHOLE_Y[1] - _FROM_EDGE):
            yield Opening("corner", (round(x, 4), round(y, 4), _LOW))


def _tops(things: tuple[WorldObject, ...]) -> Iterator[Opening]:
    for item in things:
        z = round(float(item.position[2]) + EDGE, 5)
        if uncovered(item, things) and z < TABLE_TOP + _HIGHEST * EDGE:
            yield Opening("top", (float(item.position[0]), float(item.position[1]), z), (item.id,))


def _beside(things: tuple[WorldObject, ...]) -> Iterator[Opening]:
    for item in (thing for thing in things if _on_table(thing)):
        for step in ((0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0)):
            away = float(item.half_extents[0]) + EDGE / 2 + _BESIDE
            place = item.position[:2] + away * np.array(step)
            if all(gap(place, 0.0, other) >= _CLEAN for other in things if other is not item):
                yield Opening("beside", (round(float(place[0]), 4), round(float(place[1]), 4), _LOW), (item.id,))


def _between(scene: Scene) -> Iterator[Opening]:
    things = [item for item in scene.world.things if _on_table(item)]
    known = np.array([opening.place[:2] for opening in scene.openings]).reshape(-1, 2)
    for one, other in combinations(things, 2):
        away = float(np.linalg.norm(one.position[:2] - other.position[:2]))
        middle = (one.position[:2] + other.position[:2]) / 2
        if _APART[0] <= away <= _APART[1] and (np.linalg.norm(known - middle, axis=1) > EDGE).all():
            yield Opening("between", (round(float(middle[0]), 4), round(float(middle[1]), 4), _LOW), (one.id, other.id))


def _on_table(item: WorldObject) -> bool:
    return abs(float(item.position[2]) - _LOW) < EDGE / 2
