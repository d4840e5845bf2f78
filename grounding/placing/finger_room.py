"""Room for fingers around a place: a little aside where that leaves what was meant as it is."""

from __future__ import annotations

import numpy as np

from grounding.destinations import free_places
from grounding.lexicon.table import tables, under
from grounding.world import FURNITURE, Array
from grounding.world.scene import Scene

ASIDE = 0.6  # how far a place may be moved for that [edges]
_STEP = 0.1  # of the search [edges]


def _around() -> Array:
    lines = np.arange(-ASIDE, ASIDE + 1e-9, _STEP)
    points = np.stack(np.meshgrid(lines, lines, indexing="ij"), axis=-1).reshape(-1, 2)
    away = np.linalg.norm(points, axis=1)
    order = np.argsort(away, kind="stable")
    return np.asarray(points[order][away[order] <= ASIDE + 1e-9])


_AROUND = _around()


def leave_room(point: Array, source: int, scene: Scene) -> Array:
    """The place nearest to one on the table where fingers can let go.

    Args:
        point: x, y [m].
        source: index of what is put there.
        scene: the world.

    Returns:
        x, y [m]; the place itself where nothing near it has more room.
    """
    world, item = scene.layout.world, scene.layout.things[source]
    index = int(under(scene, point[None])[0])
    table = tables(scene)[index] if index >= 0 else None
    if table is None:
        return point
    others = [o for o in world.objects if o.id != item.id and o.type not in FURNITURE]
    near = [o for o in others if np.abs(o.position[:2] - point).max() < 4 * scene.edge]
    if free_places(point[None], item, near, table)[0]:
        return point
    places = point + _AROUND * scene.edge
    free = np.flatnonzero(free_places(places, item, near, table))
    return np.asarray(places[free[0]]) if len(free) else point
