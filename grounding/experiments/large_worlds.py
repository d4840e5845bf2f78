"""Worlds of more blocks than a table has room for: composed worlds side by side on one large table."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from grounding.corpus.composer import LIMITS, Area, compose
from grounding.corpus.tabletop import TABLE, WHOLE_X, WHOLE_Y
from grounding.errors import CorpusError
from grounding.world import World, WorldObject, make_object

PER_TABLE = 25  # blocks that one composed world is given at most
_DEPTH = WHOLE_X[1] - WHOLE_X[0] + 0.08  # from one composed world to the next, away from the robot, in [m]
_WIDTH = WHOLE_Y[1] - WHOLE_Y[0] + 0.08


def compose_large(rng: np.random.Generator, blocks: int) -> World:
    """Compose a world of any size.

    Args:
        rng: the only source of chance.
        blocks: how many, at least `LIMITS[0]`.

    Returns:
        a world as `compose` makes it, or several of them in a grid that is about as deep as it is wide, with a table
        below all of them.

    Raises:
        CorpusError: too few blocks.
    """
    tables = max(1, -(-blocks // PER_TABLE))
    if blocks // tables < LIMITS[0]:
        raise CorpusError(f"a world of {blocks} blocks; composed are {LIMITS[0]} and more")
    across = max(1, round((tables * _DEPTH / _WIDTH) ** 0.5))
    rows = -(-tables // across)
    items: list[WorldObject] = []
    for place in range(tables):
        count = blocks // tables + (place < blocks % tables)
        column, row = place % across, place // across
        offset = np.array([row * _DEPTH, (column - (across - 1) / 2) * _WIDTH, 0.0])
        part = _composed(rng, count)
        items += [
            replace(item.moved(item.position + offset), id=f"b{len(items) + i}")
            for i, item in enumerate(part.things, start=1)
        ]
    middle = (TABLE.position[0] + (rows - 1) / 2 * _DEPTH, 0.0, TABLE.position[2])
    size = (TABLE.size[0] + (rows - 1) * _DEPTH, TABLE.size[1] + (across - 1) * _WIDTH, TABLE.size[2])
    table = make_object("table", "table", TABLE.color, tuple(map(float, middle)), size=tuple(map(float, size)))
    return World((*items, table))


def _composed(rng: np.random.Generator, blocks: int, tries: int = 8) -> World:
    """One composed world; a style of blocks for which there was no room is drawn anew."""
    for _ in range(tries - 1):
        try:
            return compose(rng, blocks, Area()).world
        except CorpusError:
            continue
    return compose(rng, blocks, Area()).world
