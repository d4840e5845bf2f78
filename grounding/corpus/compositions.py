"""Worlds to speak of: composed ones of several kinds, and any others with the arrangements in them recognised."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from grounding.corpus.clutter import compose_clutter
from grounding.corpus.composer import compose
from grounding.corpus.sparse import colourless, compose_loosely, with_hands
from grounding.corpus.treebank import LaidWorld, lay
from grounding.errors import CorpusError
from grounding.symbols import Container
from grounding.world import Viewpoint, World, make_object

KINDS = {"composed": 0.55, "loose": 0.15, "clutter": 0.3}
"""Kinds of composed worlds and their shares: arrangements among others, a loose row or column by hand, heaps."""

APART = 1.6  # the nearest other block is so many times farther from a group than its members are from each other
SPEAKER_SHARE = 0.5
HANDS_SHARE = 0.1
COLOURLESS_SHARE = 0.05


def compose_world(rng: np.random.Generator, name: str, kind: str | None = None, blocks: int | None = None) -> LaidWorld:
    """Lay a random world without physics.

    Args:
        rng: the only source of chance.
        name: in the corpus.
        kind: one of `KINDS`; drawn if None.
        blocks: how many, 3 to 30, for kind "composed"; drawn if None.

    Raises:
        CorpusError: an unknown kind, or a number of blocks that cannot be laid.
    """
    if kind is None:
        kind = "composed" if blocks is not None else list(KINDS)[int(rng.choice(len(KINDS), p=list(KINDS.values())))]
    if kind not in KINDS or (blocks is not None and kind != "composed"):
        raise CorpusError(f"no worlds of kind {kind!r} with {blocks} blocks; kinds are {', '.join(KINDS)}, and only "
                          "of 'composed' ones the number can be chosen")  # fmt: skip
    if kind == "clutter":
        composition = compose_clutter(rng)
    else:
        composition = compose_loosely(rng) if kind == "loose" else compose(rng, blocks)
    return recognise(name, dressed(composition.world, rng), composition.containers)


def dressed(world: World, rng: np.random.Generator) -> World:
    """The world with what does not lie on the table drawn: a speaker across it, the robot's hands, unknown colours."""
    if rng.random() < SPEAKER_SHARE:
        table = next((item for item in world.objects if item.type == "table"), make_object("table"))
        x = float(table.position[0] + table.size[0] / 2 + rng.uniform(0.2, 0.6))
        place = np.array([round(x, 3), round(float(rng.uniform(-0.1, 0.1)), 3), 0.0])
        place.setflags(write=False)
        world = World(world.objects, Viewpoint(place, 3.14159))
    if rng.random() < HANDS_SHARE:
        world = with_hands(world)
    return colourless(world) if rng.random() < COLOURLESS_SHARE else world


def recognise(name: str, world: World, containers: Iterable[Container] = ()) -> LaidWorld:
    """Digest a world: the arrangements that were laid, if known, and those that catch the eye.

    What was laid counts if it is seen, a group if it catches the eye as a whole and stands apart from what lies around.
    """
    laid = lay(name, world, containers)
    by_members = laid.layout.by_members
    evident = laid.layout.evident
    kept = tuple(
        a
        for a in laid.arrangements
        if a in by_members and (a[0] != "group" or (a in evident and by_members[a].separation >= APART))
    )
    return LaidWorld(name, laid.layout, kept)
